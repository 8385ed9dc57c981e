"""A film whose inlet is too hot for its fit: the contact is named, and what rolls has no value."""

import math
from pathlib import Path

import numpy as np
import pytest
from shown_blocks import sentences, tables

import asperity
from asperity.errors import NoSolutionError
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.film import joint_film
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import si_values
from asperity.results.film_document import film_document
from asperity.rolling.inlet_heat import film_unknown_because
from asperity.study.batch import evaluate_points
from asperity.views.film import film

OIL = Path(__file__).parents[2] / "examples" / "oil.toml"
NAMES = ("sp", "pr")


@pytest.fixture(scope="module")
def hot(tmp_path_factory):
    """The example with a thick oil, fast and pressed hard: 43.6 m/s and more than 2 GPa at the sun."""
    text = OIL.read_text()
    for old, new in (
        ("1500 rpm", "50000 rpm"),
        ("Santotrac 50", "N100"),
        ('"90 um"', '"350 um"'),
        ('working = "40 degC"', 'working = "20 degC"'),
        ('"10 N*m"', '"5 N*m"'),
    ):
        assert old in text
        text = text.replace(old, new)
    path = tmp_path_factory.mktemp("hot") / "hot.toml"
    path.write_text(text)
    return path


def factor_of(line_load, radius, speed):
    """Gupta's factor of N100 at 20 degC between rollers of 52100, from the library's numbers, by hand."""
    modulus, kelvin = 203e9 / (2.0 * (1.0 - 0.29**2)), 293.15
    half_width = math.sqrt(4.0 * line_load * radius / (math.pi * modulus))
    pressure = 2.0 * line_load / (math.pi * half_width)
    viscosity = 161.60e-6 * math.exp(650.0 / (kelvin - 206.0))
    loading = viscosity * 650.0 / (kelvin - 206.0) ** 2 * speed**2 / 0.14
    cooled = 1.0 - 13.2 * pressure / (2.0 * modulus) * loading**0.42
    return cooled / (1.0 + 0.213 * loading**0.64)


def test_the_contact_is_named_with_its_factor(hot):
    result = asperity.load(hot).solve().document
    said = result["rolling"]["unknown_because"][0]
    assert said.startswith("no oil film at sp: heat at its inlet is beyond the range")
    notes = [note for note in result["diagnostics"] if note["name"] == "rolling_torque_ratio"]
    assert "no oil film at sp" in notes[0]["meaning"]
    assert "lower the speed" in notes[0]["remedy"]
    # standing forces and stiffness do not know the oil
    assert result["standing_torque_capacity"]["output_torque_Nm"] > 5.0
    with pytest.raises(NoSolutionError, match=r"no oil film at sp.*must be above 0; lower the speed"):
        asperity.roll(asperity.load(hot))


def test_a_point_of_a_study_says_it_by_its_status(hot):
    names = ("inlet_heat_factor", "assembly_stiffness_output", "creepage", "preload")
    speeds = np.array([50000.0, 5000.0]) * math.pi / 30.0
    status, found = evaluate_points(si_values(read_case(hot)), {"load.sun_speed": speeds}, names)
    assert [STATUS_NAMES[code] for code in status] == ["no_oil_film", "solved"]
    assert np.isfinite(found["assembly_stiffness_output"]).all()
    assert np.isnan(found["creepage"][:, 0]).all()
    assert np.isfinite(found["creepage"][:, 1]).all()
    # without torque: the preload on lines of 5 mm, radius 20/3 mm, and half the sun's speed relative to the carrier
    speed = 50000.0 * math.pi / 30.0 * 10e-3 * (1.0 - 1.0 / 6.0)
    expected = factor_of(float(np.ravel(found["preload"])[0]) / 5e-3, 20e-3 / 3.0, speed)
    assert expected < 0.0
    assert found["inlet_heat_factor"][0, 0] == pytest.approx(expected, rel=1e-6)


def test_over_speed_films_end_where_the_inlet_is_too_hot(hot):
    case = asperity.load(hot).case
    document = film_document(joint_film(case, points=8))
    shown = tables(film(document))
    rows = [[row[4] for row in shown[f"Contact {name} over speed, oil at 20 °C"].rows] for name in NAMES]
    assert (rows[0][0], rows[0][-1]) == ("boundary", "no film")
    # at 50000 rpm the ring's contact has a film, but the joint does not roll
    assert ("no film", "–") in zip(*rows, strict=True)
    assert shown["The joint over speed, oil at 20 °C"].rows[-1][-1] == "no oil film"
    said = " ".join(sentences(film(document)))
    assert "'no film': heat at the inlet" in said
    assert "'slips'" not in said
    with pytest.raises(NoSolutionError, match="no oil film at sp"):
        joint_film(case, start=50000.0 * math.pi / 30.0, points=3)


@pytest.mark.parametrize("factors", [None, np.array([0.3, 0.9]), np.array([np.nan, np.nan])])
def test_nothing_is_said_of_films_that_are_known(factors):
    assert film_unknown_because(NAMES, factors) is None


def test_the_worst_contact_is_named():
    assert "pr" in film_unknown_because(NAMES, np.array([-0.1, -0.2])).split(":")[0]
