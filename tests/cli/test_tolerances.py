"""``asperity tolerances`` from the command line."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity
from asperity.errors import InputError
from asperity.study.tolerances.allowed_deviations import AllowedDeviations, AllowedSize

PLANETARY = Path(__file__).parents[2] / "examples" / "planetary.toml"


def invoke(*arguments):
    return CliRunner().invoke(asperity, ["tolerances", str(PLANETARY), *map(str, arguments)])


@pytest.fixture
def asked(monkeypatch):
    """What is asked for; no drive is computed."""
    seen = {}

    def allowed(case, limits, **options):
        seen.update(options, limits=[(limit.name, limit.at_most, limit.limit) for limit in limits])
        sizes = (
            AllowedSize("drive.sun_radius", 0.02, 0.9e-6, "IT3", 0.25),
            AllowedSize("load.interference", 0.1, 1e-8, "", 0.1),
        )
        return AllowedDeviations(sizes, ("drive.planet_radius",), 9990, 10_000, 0.999)

    monkeypatch.setattr("asperity.study.tolerances.allowed_deviations.allowed_deviations", allowed)
    return seen


def test_sizes_grades_and_shares_in_a_table(asked):
    result = invoke("--keep", "torque_capacity>=10.5 N*m", "--keep", "hertz_pressure <= 1500 MPa")
    assert result.exit_code == 0, result.output
    assert asked["limits"] == [("torque_capacity", False, 10.5), ("hertz_pressure", True, 1.5e9)]
    assert (asked["share"], asked["sharing"], asked["samples"]) == (0.999, "grade", 10_000)
    assert asked["distribution"].kind == "uniform"
    said = " ".join(result.stdout.split())
    assert "drive.sun_radius 20 mm 0.9 µm 3.6 µm IT3 25 %/µm" in said
    assert "load.interference (bore) 100 mm 0.01 µm 0.04 µm finer than IT01 10 %/µm" in said
    assert "9990 of 10000 drives keep all limits (99.9 % are asked for)" in said
    assert "No influence: drive.planet_radius" in said


def test_one_document(asked):
    result = invoke("--keep", "stiffness>=8e5 N*m/rad", "--share", "95 %", "--sharing", "cost", "--json")
    document = json.loads(result.stdout)
    assert document["sizes"][0]["deviation"] == 0.9e-6
    assert (asked["share"], asked["sharing"]) == (0.95, "cost")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ("--keep", "torque_capacity>=1 N*m", "--share", "100 %"),
            "--share: the share of the drives must be at least 50 % and below",
        ),
        (("--keep", "torque_capacity>=1 N*m", "--share", "9 mm"), "--share: expected a dimensionless number"),
        (("--keep", "torque_capacity>1 N*m"), "expected RESULT>=VALUE"),
        (("--keep", "torque_capacity>=1 N*m", "--distribution", "square"), "can be distributed as"),
    ],
)
def test_bad_input(asked, arguments, message):
    result = invoke(*arguments)
    assert isinstance(result.exception, InputError)
    assert message in str(result.exception)
