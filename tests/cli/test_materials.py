"""``asperity materials``: the library listed, one entry, a file of one's own."""

import json

import pytest
from bronze import BRONZE


def test_the_whole_library(call):
    outcome = call("materials")
    assert (outcome.code, outcome.err) == (0, "")
    for text in ("52100", "superfinished", "yield strength", "G from", "Source: "):
        assert text in outcome.out


def test_one_entry(call):
    found = json.loads(call("materials", "440C", "--json").out)
    assert found["materials"]["440C"]["numbers"]["poisson_ratio"] == 0.28  # its data sheet
    assert (list(found["materials"]), found["finishes"]) == (["440C"], {})
    told = call("materials", "ground").out
    assert "Finishes" in told
    assert "Materials" not in told


def test_finishes_are_in_si(call):
    finish = json.loads(call("materials", "ground", "--json").out)["finishes"]["ground"]
    low, high = finish["roughness_average"]
    assert 1e-8 < low < high < 1e-5  # Ra of grinding: a tenth to a few micrometres
    assert finish["fractal_dimension"] == [1.5, 1.5]


def test_a_library_file_of_one_s_own(call, tmp_path):
    (tmp_path / "mine.toml").write_text(BRONZE)
    told = call("materials", "bronze", "--file", tmp_path / "mine.toml")
    assert told.code == 0
    assert "110 GPa" in told.out
    assert "2.8 x yield" in told.out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("441C",), "the library has no entry '441C'; did you mean '440C'?"),
        (("wood",), "it contains 52100"),
        (("--file", "nowhere.toml"), "nowhere.toml: there is no such file"),
    ],
)
def test_refusals(call, arguments, said):
    outcome = call("materials", *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert said in outcome.err


def test_numbers_of_a_library_file_are_checked_as_those_of_a_joint_file(call, tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(BRONZE.replace('"110 GPa"', '"-5 GPa"'))
    outcome = call("materials", "--file", path)
    assert (outcome.code, outcome.out) == (2, "")
    assert "mine.toml: library entry bronze: materials.bronze.youngs_modulus: -5" in outcome.err
    assert "is not allowed; it must be" in outcome.err


def test_oils_with_what_they_are_known_by(call):
    """34.4 mm²/s at 40 °C of 0.887 g/cm³ by Gupta's tables of Santotrac 50; 5P4E by its limiting traction alone."""
    (oil,) = json.loads(call("materials", "santotrac 50", "--json").out)["fluids"].values()
    assert oil["properties"]["viscosity_40_Pa_s"] == pytest.approx(0.0305, rel=2e-3)
    assert oil["properties"]["viscosity_100_Pa_s"] == pytest.approx(4.71e-3, rel=2e-3)
    assert "Gupta" in oil["reference"]
    told = call("materials", "5P4E").out
    assert "0.088" in told
    assert "Materials" not in told
