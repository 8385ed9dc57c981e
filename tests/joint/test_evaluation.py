"""The whole chain: the paper's numbers, an independent script, properties, gradients and refusals."""

import importlib.util
import math
from pathlib import Path

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from asperity.drive.force_balance import DriveForces
from asperity.drive.torsional_stiffness import TorsionalStiffness
from asperity.errors import PrecisionError
from asperity.joint.planar.evaluation import evaluate_planar
from asperity.joint.planar.solve import solve_planar

SIZE = 16


class Summary(eqx.Module):
    """What these tests look at, so that the rest is not compiled."""

    forces: DriveForces
    tangential_stiffness: jax.Array
    largest_area: jax.Array
    published: TorsionalStiffness
    contact_law_holds: jax.Array
    solved: jax.Array


def summary(joint):
    found = evaluate_planar(joint)
    return Summary(
        found.forces,
        found.contacts.tangential_stiffness,
        found.contacts.largest_area,
        found.published,
        found.contact_law_holds,
        found.solved,
    )


compiled = eqx.filter_jit(summary)


@pytest.fixture(scope="module")
def chain(paper_joint):
    """Summary of a batch of the paper's joint with changes; every batch is padded to one size, compiled once."""

    def run(**changes):
        texts = {key: value for key, value in changes.items() if isinstance(value, str)}
        numbers = {key: value for key, value in changes.items() if key not in texts}
        rows = np.broadcast_arrays(*map(np.atleast_1d, numbers.values())) if numbers else [np.zeros(1)]
        padded = {key: np.resize(row, SIZE).astype(float) for key, row in zip(numbers, rows, strict=False)}
        found = compiled(paper_joint(**({"preload": np.full(SIZE, 1000.0)} | padded), **texts))
        return jax.tree.map(lambda leaf: np.asarray(leaf)[..., : rows[0].size], found)

    return run


def test_the_papers_joint(chain):
    """T_sp = 46.30 N from statics; 5.0e6 N·m/rad at the output for a small torque, about 4.3e6 at 5 N·m."""
    found = chain(output_torque=np.array([1e-6, 5.0]), sun_speed=0.0)
    assert found.solved.all()
    assert found.forces.tangential[0, 1] == pytest.approx(46.30, abs=0.005)
    assert found.published.output[0] == pytest.approx(5.0e6, rel=0.01)
    assert found.published.output[1] == pytest.approx(4.3e6, rel=0.02)
    np.testing.assert_allclose(found.published.output, 81 * found.published.sun, rtol=1e-13)


@pytest.mark.parametrize("closure", ["elastic", "constant_pin_force"])
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
        other = baseline.evaluate_planar({**case, **script})
        assert found.published.sun[i] == pytest.approx(other["sun"], rel=1e-7)
        assert found.published.output[i] == pytest.approx(other["output"], rel=1e-7)
        for index, contact in enumerate(other["contacts"].values()):
            assert found.tangential_stiffness[index, i] == pytest.approx(contact["K_t"], rel=1e-7)
            assert found.largest_area[index, i] == pytest.approx(contact["a_l"], rel=1e-7)


def test_stiffness_peaks_where_the_paper_says_and_falls_with_torque(chain):
    D = np.array([1.6, 1.7, 1.75, 1.8, 1.85, 1.9, 1.95])
    assert D[np.argmax(chain(fractal_dimension=D).published.sun)] == 1.85
    assert (np.diff(chain(output_torque=np.linspace(0.0, 5.0, 8)).published.sun) < 0).all()


changes = st.fixed_dictionaries(
    {
        "fractal_dimension": st.floats(1.05, 1.98),
        "fractal_roughness": st.floats(-14.0, -7.0).map(lambda e: 10.0**e),
        "preload": st.floats(300.0, 5000.0),
        "output_torque": st.floats(0.0, 40.0),
        "contact_length": st.floats(2e-3, 30e-3),
        "friction_coefficient": st.floats(0.03, 1.0),
        "sun_speed": st.floats(0.0, 5000.0),
        "planet_count": st.integers(2, 4).map(float),
        "pin_friction_coefficient": st.floats(0.0, 0.01),
        "pin_diameter": st.floats(0.0, 6e-3),
        "loading_roller_torque": st.floats(0.0, 0.02),
        "carrier_torque": st.floats(0.0, 0.2),
    }
)


@settings(max_examples=60, deadline=None)
@given(changes)
def test_every_joint_balances_and_means_something(chain, x):
    found = chain(**x)
    forces = found.forces
    assert found.solved.all()
    assert (forces.normal >= 0).all()
    assert forces.balance_residual.max() < 1e-9
    for leaf in jax.tree.leaves((forces, found.tangential_stiffness, found.largest_area)):
        assert np.isfinite(leaf).all()
    slips = (np.abs(forces.tangential) >= x["friction_coefficient"] * forces.normal)[:, 0]
    assert (found.tangential_stiffness[slips, 0] == 0).all()
    assert (found.tangential_stiffness[:, 0] >= 0).all()
    if not found.contact_law_holds[0]:
        assert np.isnan(found.published.sun[0])
        return
    assert (found.published.sun[0] == 0) == any(
        found.tangential_stiffness[list(stage), 0].sum() == 0 for stage in ((0,), (1, 2), (3, 4))
    )


@settings(max_examples=25, deadline=None)
@given(changes, st.floats(1.05, 3.0))
def test_more_friction_never_softens_and_rougher_never_stiffens(chain, x, more):
    grip, rough = x["friction_coefficient"], x["fractal_roughness"]
    x |= {
        "friction_coefficient": np.array([grip, grip * more, grip]),
        "output_torque": x["output_torque"] / 4,
    }
    x |= {"fractal_roughness": np.array([rough, rough, rough * more])}
    here, sticky, rougher = chain(**x).published.sun
    if not np.isnan(here):
        assert sticky >= here
    if not np.isnan(rougher):
        assert rougher <= here * (1 + 1e-9)


@pytest.mark.slow
def test_gradients_with_respect_to_everything_are_finite_and_right(paper_joint):
    """Reverse mode at ordinary, slipping, lifted, plastic and unloaded joints; finite differences at the first."""
    joint = paper_joint(
        output_torque=np.array([4.0, 30.0, 80.0, 4.0, 0.0, 3.0, 2.0, 1.0]),
        fractal_dimension=np.array([1.4, 1.5, 1.7, 1.1, 1.5, 1.02, 1.99, 1.8]),
        pin_friction_coefficient=2e-3,
        pin_diameter=4e-3,
        sun_torque=1e-3,
        loading_roller_torque=1e-3,
        carrier_torque=1e-2,
        left_push_angle=0.05,
    )
    rigid = joint.structure
    joint = eqx.tree_at(lambda j: j.structure, joint, None)

    def stiffness(joint):
        return evaluate_planar(
            eqx.tree_at(lambda j: j.structure, joint, rigid, is_leaf=lambda x: x is None)
        ).published.sun

    @jax.jit
    def pulled(joint):
        value, pull = jax.vjp(stiffness, joint)
        return value, pull(jnp.ones_like(value))[0]

    value, slopes = pulled(joint)
    assert float(value[1]) == float(value[2]) == 0.0  # slip, lift-off and slip
    assert np.isnan(np.asarray(value)[[3, 5]]).all()  # all plastic
    assert (np.asarray(value)[[0, 4, 6, 7]] > 0).all()
    for path, leaf in jax.tree_util.tree_leaves_with_path(slopes):
        assert bool(jnp.all(jnp.isfinite(leaf))), path
    leaves, tree = jax.tree.flatten(joint)
    smooth = [0, 4, 6, 7]
    for index, (leaf, slope) in enumerate(zip(leaves, jax.tree.leaves(slopes), strict=True)):
        h = 1e-5 * np.where(leaf == 0.0, 1.0, leaf)

        def moved(steps, index=index, h=h):
            return pulled(
                jax.tree.unflatten(tree, [x + steps * h * (i == index) for i, x in enumerate(leaves)])
            )[0]

        difference = (moved(1) - moved(-1)) / (2 * h)
        scale = np.abs(value / h) * 1e-10
        error = np.abs(np.asarray(slope) - np.asarray(difference))
        one_sided = np.broadcast_to(np.asarray(leaf) == 0.0, error.shape)  # numbers of no batch are scalars
        allowed = 1e-6 * np.abs(slope) + scale
        assert (error <= allowed)[smooth][~one_sided[smooth]].all(), index


@pytest.mark.slow
def test_batches_broadcast_and_one_joint_is_a_scalar(paper_joint, chain):
    torque = np.linspace(0.0, 5.0, 6).reshape(2, 3)
    batch = eqx.tree_at(lambda j: j.output_torque, paper_joint(), torque)
    shapes = eqx.filter_eval_shape(evaluate, batch)
    assert shapes.published.sun.shape == (2, 3)
    assert shapes.contacts.tangential_stiffness.shape == (5, 2, 3)
    alone = solve_planar(paper_joint()).result
    assert alone.published.sun.shape == ()
    row = chain(output_torque=np.array([1.0, 5.0]))
    assert float(alone.published.sun) == pytest.approx(row.published.sun[1], rel=1e-12)
    assert alone.contact("pwl")["normal_force"] == alone.forces.normal[2]


def test_single_precision_is_refused(paper_joint):
    joint = paper_joint()
    with jax.enable_x64(False), pytest.raises(PrecisionError, match="use_double_precision"):
        solve_planar(joint)


def test_carrier_turns_the_other_way_with_the_published_ratio(paper_joint):
    found = solve_planar(paper_joint()).result
    assert float(found.output_speed) == pytest.approx(-69.81317007977317)
    assert float(found.speed_ratio) == pytest.approx(-9.0)
    assert math.degrees(float(found.angles.direction)) == pytest.approx(27.0831, abs=6e-5)


@pytest.mark.slow
@pytest.mark.parametrize(
    "place",
    [
        lambda j: j.friction_coefficients[0],
        lambda j: j.contact_lengths[0],
        lambda j: j.surfaces[0].fractal_dimension,
        lambda j: j.bodies.ring.youngs_modulus,
        lambda j: j.bearings.pin_diameter,
        lambda j: j.structure.output_shaft_stiffness,
    ],
)
def test_a_single_number_may_be_the_batch(paper_joint, place):
    """Shapes only, nothing is compiled."""
    joint = eqx.tree_at(place, jax.tree.map(float, paper_joint()), np.full(3, 0.5))
    shapes = jax.eval_shape(evaluate, joint)
    assert shapes.forces.normal.shape in {(5, 1), (5, 3)}
    assert shapes.assembly.stiffness.output.shape == (3,)
