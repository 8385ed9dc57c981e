"""``asperity design`` from the command line."""

import json
import tomllib
from importlib.resources import files

import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity
from asperity.errors import InputError, NoSolutionError

DESIGN = """
joint = "zou2025.toml"
[variables]
surface.fractal_dimension = { lower = 1.3, upper = 1.9 }
load.preload = { lower = "300 N", upper = "3000 N" }
[objective]
maximise = "stiffness"
[constraints]
pressure_over_first_yield = { at_most = 2.0 }
shakedown_ratio = { at_most = 2.0 }
slip_ratio = { at_most = 0.8 }
[search]
starts = 1
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "zou2025.toml").write_text(files("asperity.joint_file").joinpath("zou2025.toml").read_text())
    (tmp_path / "design.toml").write_text(DESIGN)
    return tmp_path


def invoke(*arguments):
    return CliRunner().invoke(asperity, [str(argument) for argument in arguments], catch_exceptions=True)


@pytest.mark.slow
def test_design_agrees_with_the_joint_command(folder):
    out, plot = folder / "designed.toml", folder / "designed.png"
    result = invoke("design", folder / "design.toml", "--out", out, "--plot", plot, "--json")
    assert result.exit_code == 0, result.output
    found = json.loads(result.stdout)
    assert found["objective"]["after"] > 1.05 * found["objective"]["before"]
    assert plot.stat().st_size > 10_000
    again = json.loads(invoke("joint", out, "--json").stdout)
    stiffness = again["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    assert stiffness == pytest.approx(found["objective"]["after"], rel=1e-9)
    pressure = max(
        each["value"] for each in again["diagnostics"] if each["name"] == "pressure_over_first_yield"
    )
    assert 2.0 * (1.0 - 1e-3) < pressure <= 2.0 * (1.0 + 1e-7)
    assert found["diagnostics"] == again["diagnostics"]
    assert found["feasible"]
    assert {entry["name"] for entry in found["allowed"]} == {"pressure_over_first_yield", "shakedown_ratio"}
    # the file has no digits that its results do not need
    written = tomllib.loads(out.read_text())
    for number in (
        written["load"]["preload"].removesuffix(" N"),
        str(written["surface"]["fractal_dimension"]),
    ):
        assert len(number.replace(".", "")) <= 5


def test_inputs_are_not_written_over(folder):
    for name in ("design.toml", "zou2025.toml"):
        result = invoke("design", folder / "design.toml", "--out", folder / name)
        assert isinstance(result.exception, InputError)
        assert "this is the file that is read; give another name" in str(result.exception)


def test_a_front_is_a_table(folder):
    pytest.importorskip("pymoo")
    front = DESIGN.replace('maximise = "stiffness"', 'maximise = "stiffness"\nminimise = "mass"')
    (folder / "design.toml").write_text(front)
    result = invoke("design", folder / "design.toml", "--out", folder / "front.toml")
    assert isinstance(result.exception, InputError)
    assert "a Pareto front is a table of many joints" in str(result.exception)


@pytest.mark.long
def test_tables_and_conflict(folder):
    text = DESIGN.replace("at_most = 2.0", "at_most = 0.9").replace("at_most = 0.8", "at_most = 0.2")
    (folder / "design.toml").write_text(text)
    result = invoke("design", folder / "design.toml")
    assert isinstance(result.exception, NoSolutionError)
    assert "no design meets all limits" in str(result.exception)
    assert "slip ratio" in str(result.exception)
    assert "Free numbers" in result.stdout


def test_bad_files(folder):
    assert isinstance(invoke("design", folder / "none.toml").exception, InputError)
    assert isinstance(invoke("design", folder / "design.toml", "--plot", "x.txt").exception, InputError)
