"""``asperity report``: files and refusals."""

import html
import json
import re

import numpy as np
import pytest

from asperity.surface.height_spectrum import spectrum_of_profiles
from asperity.surface.measured_roughness import MeasuredRoughness, roughness_document


@pytest.mark.slow
def test_html_is_written(call, joint_file, tmp_path):
    outcome = call("report", joint_file(), "--out", tmp_path / "r.html", "--date", "1 <March>")
    assert (outcome.code, outcome.out) == (0, "")
    text = (tmp_path / "r.html").read_text(encoding="utf-8")
    assert text.startswith("<!DOCTYPE html>")
    assert "<td class=w>1 &lt;March&gt;</td>" in text
    assert str(tmp_path) not in text  # a report says nothing about the machine's folders


@pytest.mark.long
def test_pdf_is_written(call, joint_file, tmp_path):
    pytest.importorskip("typst", reason="the extra 'report' is not installed")
    assert call("report", joint_file(), "--out", tmp_path / "r.pdf").code == 0
    assert (tmp_path / "r.pdf").read_bytes().startswith(b"%PDF-")


@pytest.mark.parametrize(
    ("change", "arguments", "said"),
    [
        (("5 N*m", "5 N*m"), ("--out", "r.docx"), "must end in .html or .pdf"),
        (("5 N*m", "5 N*m"), ("--out", "r.html", "--date", "x" * 61), "at most 60 characters"),
        (("5 N*m", "50 N*m"), ("--out", "r.html"), "beyond the standing torque capacity"),
        (("5 N*m", "5 N*m"), ("--out", "r.html", "--tolerances"), "the joint file states no tolerances"),
        (("5 N*m", "5 N*m"), ("--out", "r.html", "--distribution", "uniform"), "belongs to --tolerances"),
    ],
)
def test_refusals_write_nothing(call, joint_file, tmp_path, monkeypatch, change, arguments, said):
    monkeypatch.chdir(tmp_path)
    outcome = call("report", joint_file(change), *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert said in outcome.err
    assert not list(tmp_path.glob("r.*"))


@pytest.fixture
def reported(call, joint_file, tmp_path):
    """Maker of the file of a measured surface, and of the report with it."""

    def made(document):
        file, report = tmp_path / "measured.json", tmp_path / "r.html"
        file.write_text(json.dumps(document))
        outcome = call("report", joint_file(), "--surface", file, "--out", report)
        assert (outcome.code, outcome.err.strip()) == (0, f"wrote {report}")
        return file, report.read_text(encoding="utf-8")

    return made


@pytest.mark.long
def test_a_measured_surface_takes_the_place_of_the_files_and_is_part_of_the_report(
    call, joint_file, tmp_path, reported
):
    document = {
        "schema": "asperity-surface-measurement", "schema_version": 1, "source": "made <up>", "estimator": "none",
        "fractal_dimension": 1.45, "fractal_roughness_m": 1e-11, "frequency_ratio": 1.5,
        "covariance_of_dimension_and_log_roughness": [[1e-6, 0.0], [0.0, 1e-3]],
        "shortest_wavelength_m": 1e-6, "longest_wavelength_m": 1e-4, "profiles": 10,
    }  # fmt: skip
    file, text = reported(document)
    # of both bodies, which are alike: 1e-8 mm times 2^(1/0.9)
    assert "95 % interval from the measured surface, D = 1.450, G = 2.16e-8 mm" in text
    assert "each body as measured: made &lt;up&gt;" in text
    assert html.escape(file.read_text()) in text
    assert "asperity report --surface&#x27; on it" in text
    outcome = call(
        "report", joint_file(), "--surface", file, "--measurement-of", "pair", "--out", tmp_path / "p.html"
    )
    assert outcome.code == 0
    text = (tmp_path / "p.html").read_text(encoding="utf-8")
    assert "95 % interval from the measured surface, D = 1.450, G = 1e-8 mm" in text
    assert "the pair as measured: made &lt;up&gt;" in text
    assert "asperity report --surface --measurement-of pair&#x27; on it" in text


@pytest.mark.long
def test_a_surface_without_a_power_law_is_in_the_report_with_its_interval(reported):
    noise = 1e-7 * np.random.default_rng(0).standard_normal((1, 1000))
    spectrum = spectrum_of_profiles(profiles=noise, spacing=1e-6, lay="rolling", source="ring")
    document = roughness_document(
        MeasuredRoughness(None, "no power law of <white> noise", (spectrum,), "ring")
    )
    _, text = reported(document)
    assert "Interval of the contact law, and of the rms of the heights" in text
    assert "Contact laws side by side" in text
    assert "0.43 to 1.14" in text
    assert "the joint uses the measured spectrum; no power law of &lt;white&gt; noise" in text


DESIGN = """
joint = "{joint}"
[variables]
load.preload = {{ lower = "900 N", upper = "1100 N" }}
[objective]
{objective}
"""


@pytest.mark.parametrize(
    ("joint", "objective", "said"),
    [
        (
            "other.toml",
            'maximise = "stiffness"',
            "it designs .*other.toml, which is not the joint of this report",
        ),
        (
            "joint.toml",
            'maximise = "stiffness"\nminimise = "mass"',
            "a Pareto front has many; state one objective",
        ),
    ],
)
def test_a_design_has_to_be_one_of_this_joint(call, joint_file, tmp_path, joint, objective, said):
    file = joint_file()
    (tmp_path / "other.toml").write_text(file.read_text().replace("1000 N", "1001 N"))
    (tmp_path / "d.toml").write_text(DESIGN.format(joint=joint, objective=objective))
    outcome = call("report", file, "--design", tmp_path / "d.toml", "--out", tmp_path / "r.html")
    assert outcome.code == 2
    assert re.search(said, " ".join(outcome.err.split()))
    assert not (tmp_path / "r.html").exists()
