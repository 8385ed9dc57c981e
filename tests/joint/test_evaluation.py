"""The whole chain of the paper's joint: the paper's numbers, an independent script, and properties."""

import importlib.util
from pathlib import Path

import jax
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from asperity.joint.evaluation import evaluate

pytestmark = pytest.mark.slow

SIZE = 16


def summary(joint):
    """What these tests look at, so that the rest is not compiled."""
    found = evaluate(joint)
    return {
        "forces": found.forces,
        "tangential_stiffness": found.contacts.tangential_stiffness,
        "largest_area": found.contacts.largest_area,
        "published": found.published,
        "contact_law_holds": found.contact_law_holds,
        "solved": found.solved,
    }


PROGRAM = jax.jit(jax.vmap(summary, out_axes=-1))


@pytest.fixture(scope="module")
def chain(paper_joint):
    """Summary of a batch of the paper's joint with changes; every batch is padded to one size, compiled once."""

    def run(**changes):
        texts = {key: value for key, value in changes.items() if isinstance(value, str)}
        numbers = {key: value for key, value in changes.items() if key not in texts}
        rows = np.broadcast_arrays(*map(np.atleast_1d, numbers.values())) if numbers else [np.zeros(1)]
        padded = {key: np.resize(row, SIZE).astype(float) for key, row in zip(numbers, rows, strict=False)}
        found = PROGRAM(paper_joint(**({"preload": np.full(SIZE, 1000.0)} | padded), **texts))
        return {
            name: jax.tree.map(lambda leaf: np.asarray(leaf)[..., : rows[0].size], each)
            for name, each in found.items()
        }

    return run


@pytest.mark.parametrize("closure", ["elastic", pytest.param("constant_pin_force", marks=pytest.mark.long)])
def test_agreement_with_the_independent_script(chain, closure):
    """Forces by fsolve, contacts by brentq and quad: benchmarks/baseline_scipy.py, which shares no code with us."""
    path = Path(__file__).parents[2] / "benchmarks" / "baseline_scipy.py"
    if not path.exists():
        pytest.skip("benchmarks/ is not shipped with this copy")
    spec = importlib.util.spec_from_file_location("baseline_scipy", path)
    baseline = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(baseline)
    rng = np.random.default_rng(11)
    x = {
        "fractal_dimension": rng.uniform(1.4, 1.9, 5),
        "fractal_roughness": 10.0 ** rng.uniform(-12, -11, 5),
        "preload": rng.uniform(800, 2000, 5),
        "output_torque": rng.uniform(0.5, 5, 5),
        "contact_length": rng.uniform(4e-3, 10e-3, 5),
        "sun_speed": rng.uniform(0, 900, 5),
        "friction_coefficient": rng.uniform(0.12, 0.2, 5),
    }
    found = chain(closure=closure, **x)
    for i in range(5):
        case = {key: value[i] for key, value in x.items()}
        script = {"ring_wall": 10e-3, "normal_law": "nonlinear", "closure": closure}
        other = baseline.evaluate({**case, **script})
        assert found["published"].input[i] == pytest.approx(other["sun"], rel=1e-7)
        assert found["published"].output[i] == pytest.approx(other["output"], rel=1e-7)
        for index, contact in enumerate(other["contacts"].values()):
            assert found["tangential_stiffness"][index, i] == pytest.approx(contact["K_t"], rel=1e-7)
            assert found["largest_area"][index, i] == pytest.approx(contact["a_l"], rel=1e-7)


def test_stiffness_peaks_where_the_paper_says_and_falls_with_torque(chain):
    D = np.array([1.6, 1.7, 1.75, 1.8, 1.85, 1.9, 1.95])
    assert D[np.argmax(chain(fractal_dimension=D)["published"].input)] == 1.85
    assert (np.diff(chain(output_torque=np.linspace(0.0, 5.0, 8))["published"].input) < 0).all()


changes = st.fixed_dictionaries(
    {
        "fractal_dimension": st.floats(1.05, 1.98),
        "fractal_roughness": st.floats(-14.0, -7.0).map(lambda e: 10.0**e),
        "preload": st.floats(300.0, 5000.0),
        "output_torque": st.floats(0.0, 40.0),
        "contact_length": st.floats(4e-3, 30e-3),
        "friction_coefficient": st.floats(0.03, 1.0),
        "sun_speed": st.floats(0.0, 3000.0),
    }
)


@settings(max_examples=20, deadline=None)
@given(changes)
def test_every_joint_that_is_solved_balances_and_means_something(chain, x):
    found = chain(**x)
    if not found["solved"][0]:
        return
    forces = found["forces"]
    assert (forces.normal >= 0).all()
    assert forces.balance_residual.max() < 1e-9
    for leaf in jax.tree.leaves((forces, found["tangential_stiffness"], found["largest_area"])):
        assert np.isfinite(leaf).all()
    assert (np.abs(forces.tangential) <= x["friction_coefficient"] * forces.normal * (1.0 + 1e-9)).all()
    assert (found["tangential_stiffness"][:, 0] >= 0).all()
    if not found["contact_law_holds"][0]:
        assert np.isnan(found["published"].input[0])


@settings(max_examples=15, deadline=None)
@given(changes, st.floats(1.05, 3.0))
def test_more_friction_never_softens_and_rougher_never_stiffens(chain, x, more):
    grip, rough = x["friction_coefficient"], x["fractal_roughness"]
    x |= {
        "friction_coefficient": np.array([grip, grip * more, grip]),
        "output_torque": x["output_torque"] / 4,
    }
    x |= {"fractal_roughness": np.array([rough, rough, rough * more])}
    found = chain(**x)
    (here, sticky, rougher), solved = found["published"].input, found["solved"]
    if solved[:2].all() and not np.isnan(here):
        assert sticky >= here * (1 - 1e-12)  # without torque both are equal, but for rounding
    if solved[[0, 2]].all() and not np.isnan(rougher):
        assert rougher <= here * (1 + 1e-9)
