"""What a job runs: the study of the command with the options of the page, and its document."""

from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.page.job_process import run_job
from asperity.page.study_jobs import BLOCK
from asperity.surface.measurement import SurfaceMeasurement, measurement_document


def run(kind, file="a.toml", **options):
    return run_job({"kind": kind, "file": str(file), "options": options}, lambda *_: None)


@pytest.fixture
def joint(tmp_path, joint_text):
    path = tmp_path / "a.toml"
    path.write_text(joint_text, encoding="utf-8")
    return path


@pytest.fixture
def shown(monkeypatch):
    """The views of a study, as what they are of."""
    for view in ("elasticities", "intervals", "variance_shares", "designed", "design_warnings"):
        monkeypatch.setattr(f"asperity.page.study_jobs.{view}", lambda *of, name=view: [(name, *of[1:])])
    monkeypatch.setattr("asperity.page.study_jobs.block_documents", list)


def of_results(*names):
    """A dataset of some results."""
    return {"result": SimpleNamespace(values=np.array(names))}


def test_options_of_an_uncertainty_arrive(monkeypatch, joint, shown):
    given = {}

    def uncertainty(case, **options):
        given.update(options, preload=case.load.preload.value)
        return of_results("mass", "drift")

    monkeypatch.setattr("asperity.page.study_jobs.propagate", uncertainty)
    monkeypatch.setattr("asperity.page.study_jobs.uncertainty_document", lambda found: {"is": "spread"})
    found = run("uncertainty", joint, samples=512, seed=3, distribution="normal 2 sigma")
    assert found == {"is": "spread", "views": [("intervals",), ("variance_shares", ["mass"])]}
    assert (given["samples"], given["seed"], given["preload"], given["block"]) == (512, 3, 1000.0, BLOCK)
    assert given["distribution"].kind == "normal"
    run("uncertainty", joint, samples=512, seed=3)
    assert given["distribution"] is None


def test_a_sensitivity_is_that_of_the_file_with_a_view_of_each_result(monkeypatch, joint, shown):
    read = []

    def sensitivity(case):
        read.append(case.drive.planet_radius.value)
        return of_results("mass", "drift")

    monkeypatch.setattr("asperity.page.study_jobs.differentiate", sensitivity)
    monkeypatch.setattr("asperity.page.study_jobs.sensitivity_document", lambda found: {"is": "influence"})
    views = {name: [("elasticities", (name,))] for name in ("mass", "drift")}
    assert run("sensitivity", joint) == {"is": "influence", "views": views}
    assert read == [13.5e-3]


def test_a_design_has_one_objective(monkeypatch):
    problem = SimpleNamespace(objectives=[1, 2])
    monkeypatch.setattr("asperity.page.study_jobs.read_design", lambda file: problem)
    with pytest.raises(InputError, match=r"my\.toml: the page designs for one objective"):
        run("design", "my.toml")


def test_a_design_that_meets_its_limits_has_no_conflict(monkeypatch, shown):
    result = SimpleNamespace(feasible=True, converged=True, joint_text="text")
    problem = SimpleNamespace(objectives=[1], case=SimpleNamespace(measured=None))
    monkeypatch.setattr("asperity.page.study_jobs.read_design", lambda file: problem)
    monkeypatch.setattr("asperity.page.study_jobs.search", lambda problem, progress: result)
    monkeypatch.setattr("asperity.page.study_jobs.design_document", lambda found: {"feasible": True})
    found = run("design")
    assert found.pop("views") == [("designed",), ("design_warnings",)]
    assert found == {"feasible": True, "conflict": None, "joint_text": "text"}


def test_a_measurement_document_is_read_as_it_is(tmp_path):
    import json

    measured = SurfaceMeasurement(
        fractal_dimension=jnp.asarray(1.4),
        fractal_roughness=jnp.asarray(1e-11),
        frequency_ratio=jnp.asarray(1.5),
        covariance=jnp.eye(2) * 1e-6,
        shortest_wavelength=jnp.asarray(1e-6),
        longest_wavelength=jnp.asarray(1e-4),
        estimator="made up",
        profiles=10,
        source="a test",
    )
    document = measurement_document(measurement=measured)
    path = tmp_path / "m.json"
    path.write_text(json.dumps(document), encoding="utf-8")
    found = run("measure", path, document=True)
    assert found["fractal_dimension"] == 1.4
    assert found == json.loads(path.read_text(encoding="utf-8")) | {"measurement_of": "body"}
    of_pair = run("measure", path, document=True, measurement_of="pair")
    assert of_pair == found | {"measurement_of": "pair"}
