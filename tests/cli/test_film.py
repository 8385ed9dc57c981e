"""``asperity film``: tables, picture, document, and one clear message for what is refused."""

import json
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
OIL = EXAMPLES / "oil.toml"


def test_text_and_picture(call, tmp_path):
    image = tmp_path / "film.png"
    told = call("film", OIL, "--temperature", "20, 80 degC", "--points", 4, "--plot", image)
    assert told.code == 0, told.err
    assert "Oil in the contacts at 1500 rpm, 10 N·m and 40 °C" in told.out
    for at in ("20 °C", "80 °C"):
        assert f"Contact pr over speed, oil at {at}" in told.out
    assert "slips" in told.out
    assert "speed of the file" in told.out
    assert image.stat().st_size > 10_000


def test_document(call):
    told = call("film", OIL, "--from", "100 rpm", "--to", "200 rpm", "--points", 2, "--json")
    assert told.code == 0, told.err
    document = json.loads(told.out)
    assert document["oil_temperature_C"] == 40.0
    (curves,) = document["over_speed"]
    assert curves["input_speed_rad_per_s"] == pytest.approx([10.471975512, 20.943951024])


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--points", "1"), "the number of points must be from 2 to 500, got 1 (option --points)"),
        (("--from", "9000 rpm"), "from 9000 rpm to 3000 rpm they do not; choose a start below the end"),
        (("--to", "9 um"), "--to: expected an angular velocity"),
        (("--temperature", "20,40"), "--temperature: expected a temperature with its unit"),
        (("--temperature", "20,,40 degC"), "--temperature: expected temperatures between commas"),
        (("--temperature", "-300 degC"), "is not allowed"),
    ],
)
def test_refusals(call, options, said):
    told = call("film", OIL, *options)
    assert (told.code, told.out) == (2, "")
    assert said in told.err
    assert len(told.err.strip().splitlines()) == 1


def test_a_file_without_oil(call):
    told = call("film", EXAMPLES / "planetary.toml")
    assert (told.code, told.out) == (2, "")
    assert "[lubrication] fluid" in told.err
    assert "asperity materials" in told.err
