"""``asperity accuracy``: tables, picture, document, and one clear message for what is refused."""

import json
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
FILE = EXAMPLES / "accuracy.toml"


def test_text_and_picture(call, tmp_path):
    image = tmp_path / "accuracy.png"
    told = call("accuracy", FILE, "--reverse", "--allowed", "10 arcmin", "--plot", image)
    assert told.code == 0, told.err
    for said in ("transmission error", "Form errors by order", "Contacts over a turn in the other direction"):
        assert said in told.out
    assert "until its drift may have passed 10 arcmin" in told.out
    assert image.stat().st_size > 10_000


def test_document(call):
    told = call("accuracy", FILE, "--json")
    assert told.code == 0, told.err
    accuracy = json.loads(told.out)["accuracy"]
    ring = next(one for one in accuracy["components"] if (one["part"], one["harmonic"]) == ("ring", 3))
    assert ring["sector"] is None
    assert ring["order"] == pytest.approx(3.0)
    assert ring["transmission_error_rad"] > 0.0
    assert set(ring["normal_N"]) == set(ring["tangential_N"]) == set(accuracy["contacts"])
    assert "reverse" not in accuracy
    assert {one["sector"] for one in accuracy["components"] if one["part"] == "planet"} == {1, 2, 3}


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--allowed", "5"), "--allowed: expected an angle with its unit"),
        (("--allowed", "-1 arcmin"), "-1 arcmin is not allowed; it must be above 0 (option --allowed)"),
        (("--uncertainty", "20 %"), "give the error too, such as '5 arcmin' (option --allowed)"),
    ],
)
def test_refusals(call, options, said):
    told = call("accuracy", FILE, *options)
    assert (told.code, told.out) == (2, "")
    assert said in told.err
    assert len(told.err.strip().splitlines()) == 1


def test_a_file_without_form_errors(call):
    told = call("accuracy", EXAMPLES / "planetary.toml")
    assert (told.code, told.out) == (2, "")
    assert "[[form]]" in told.err


def test_runout_and_roundness_that_a_limit_allows(call):
    told = call("tolerances", FILE, "--keep", "transmission_error<=20 arcsec")
    assert told.code == 0, told.err
    assert "Allowed form errors" in told.out
    assert "No influence, by the symmetry of the drive: sun 1, ring 1, ring 2." in told.out
    told = call("tolerances", FILE, "--keep", "transmission_error<=20 arcsec", "--sharing", "cost", "--json")
    document = json.loads(told.out)
    assert document["transmission_error"] == pytest.approx(20.0 / 3600.0 * 3.141592653589793 / 180.0)
    assert all(form["reading"] == pytest.approx(2.0 * form["amplitude"]) for form in document["forms"])


def test_proportions_of_the_file_are_for_form_errors(call):
    told = call("tolerances", FILE, "--keep", "torque_capacity>=1 N*m", "--sharing", "stated")
    assert (told.code, told.out) == (2, "")
    assert "choose equal, grade or cost" in told.err
