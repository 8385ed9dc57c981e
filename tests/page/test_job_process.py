"""What a job runs: the study of the command with the options of the page, and its document."""

from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.page.job_process import BLOCK, run_job
from asperity.surface.measurement import SurfaceMeasurement, measurement_document
from asperity.views.blocks import Paragraph


def run(kind, file="a.toml", **options):
    return run_job({"kind": kind, "file": str(file), "options": options}, lambda *_: None)


@pytest.fixture
def joint(tmp_path, joint_text):
    path = tmp_path / "a.toml"
    path.write_text(joint_text, encoding="utf-8")
    return path


def test_options_of_an_uncertainty_arrive(monkeypatch, joint):
    given = {}

    def uncertainty(case, **options):
        given.update(options, preload=case.load.preload.value)
        return {"result": SimpleNamespace(values=np.array(["drift", "efficiency"]))}

    monkeypatch.setattr("asperity.study.tolerances.uncertainty.uncertainty", uncertainty)
    monkeypatch.setattr(
        "asperity.study.tolerances.documents.uncertainty_document", lambda found: {"is": "spread"}
    )
    monkeypatch.setattr("asperity.views.tolerances.intervals", lambda found: [Paragraph("intervals")])
    monkeypatch.setattr(
        "asperity.views.tolerances.variance_shares", lambda found, names: [Paragraph(f"shares of {names}")]
    )
    found = run("uncertainty", joint, samples=512, seed=3, distribution="normal 2 sigma")
    assert [block["text"] for block in found.pop("views")] == ["intervals", "shares of ['drift']"]
    assert found == {"is": "spread"}
    assert (given["samples"], given["seed"], given["preload"], given["block"]) == (512, 3, 1000.0, BLOCK)
    assert given["distribution"].kind == "normal"
    run("uncertainty", joint, samples=512, seed=3)
    assert given["distribution"] is None


def test_a_sensitivity_is_that_of_the_file(monkeypatch, joint):
    monkeypatch.setattr(
        "asperity.study.tolerances.sensitivity.sensitivity",
        lambda case: {
            "result": SimpleNamespace(values=np.array(["drift"])),
            "radius": case.drive.planet_radius.value,
        },
    )
    monkeypatch.setattr(
        "asperity.study.tolerances.documents.sensitivity_document", lambda found: {"is": found["radius"]}
    )
    monkeypatch.setattr(
        "asperity.views.tolerances.elasticities", lambda found, names: [Paragraph(f"of {names}")]
    )
    found = run("sensitivity", joint)
    assert found.pop("views")["drift"][0]["text"] == "of ('drift',)"
    assert found == {"is": 13.5e-3}


def test_a_design_has_one_objective(monkeypatch):
    problem = SimpleNamespace(objectives=[1, 2])
    monkeypatch.setattr("asperity.study.design.design_file.read_design", lambda file: problem)
    with pytest.raises(InputError, match=r"my\.toml: the page designs for one objective"):
        run("design", "my.toml")


def test_a_design_that_meets_its_limits_has_no_conflict(monkeypatch):
    result = SimpleNamespace(feasible=True, converged=True, joint_text="text")
    case = SimpleNamespace(measured=None)
    monkeypatch.setattr(
        "asperity.study.design.design_file.read_design",
        lambda file: SimpleNamespace(objectives=[1], case=case),
    )
    monkeypatch.setattr("asperity.study.design.design.design", lambda problem, progress: result)
    monkeypatch.setattr(
        "asperity.study.design.design_result.design_document", lambda found: {"feasible": True}
    )
    monkeypatch.setattr("asperity.views.design.design", lambda found: [Paragraph("designed")])
    monkeypatch.setattr("asperity.views.design.design_warnings", lambda found: [Paragraph("no warnings")])
    found = run("design")
    assert [block["text"] for block in found.pop("views")] == ["designed", "no warnings"]
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
