"""A joint as a component of OpenMDAO: its derivatives, and the preload that an optimiser finds."""

import numpy as np
import pytest

import asperity

pytest.importorskip("openmdao", reason="OpenMDAO is not installed (extra 'test')")

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore::DeprecationWarning")]


@pytest.fixture
def example(load_example, monkeypatch, tmp_path):
    monkeypatch.setenv("OPENMDAO_WORKDIR", str(tmp_path))  # OpenMDAO writes folders of its own
    monkeypatch.chdir(tmp_path)
    return load_example("openmdao_joint")


@pytest.mark.long
def test_partials_and_preload(example, zou_file):
    problem = example.problem(zou_file)
    problem.run_model()
    checked = problem.check_partials(method="fd", form="central", step=1e-4, step_calc="rel", out_stream=None)
    pairs = checked["joint"]
    assert len(pairs) == 6
    for pair, found in pairs.items():
        ours, differences = (float(np.ravel(found[key])[0]) for key in ("J_fwd", "J_fd"))
        assert ours == pytest.approx(differences, rel=1e-5), pair
    preload = example.main(zou_file)
    solved = asperity.load(zou_file).with_values({"load.preload": f"{preload!r} N"}).solve()
    assert solved["drift"].to("arcmin") == pytest.approx(40.0, rel=1e-6)
