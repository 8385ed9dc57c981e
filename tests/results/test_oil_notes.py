"""Oils that are colder than their data, and films that pass before they flow, are said to be so in every drive."""

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from shown_blocks import sentences

import asperity
from asperity.contact.fluid import LimitingTraction, RheologicalTraction
from asperity.joint.solve import joint_state
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.film import joint_film
from asperity.joint_file.reader import read_case
from asperity.results.film_document import film_document
from asperity.results.oil_notes import oil_notes
from asperity.views.blocks import Warnings
from asperity.views.film import film

EXAMPLES = Path(__file__).parents[2] / "examples"
OIL = """
[temperature]
assembly = "20 degC"
working = "{warm}"

[lubrication]
fluid = "{fluid}"
"""


def joint(*, law="eyring", temperature=313.15, lowest=None, speed=100.0):
    """Two contacts with an oil of which only what the notes read is stated."""
    fluid = SimpleNamespace(
        traction=RheologicalTraction(LimitingTraction(0.05), 0.5e9, law) if law is not None else object()
    )
    lubricant = SimpleNamespace(fluid=fluid, temperature=temperature, lowest_temperature=lowest)
    return SimpleNamespace(
        rolling=SimpleNamespace(lubricant=lubricant), contact_names=("sp", "pr"), input_speed=speed
    )


def rolling(*numbers):
    return SimpleNamespace(film=SimpleNamespace(deborah_number=np.array(numbers)))


def test_a_film_after_eyring_must_have_the_time_to_flow():
    kept, crossed = oil_notes(joint(), rolling(0.99, 1.01))
    assert (kept.contact, kept.ok, kept.state, kept.remedy) == ("sp", True, "", None)
    assert (crossed.contact, crossed.ok, crossed.value, crossed.limit) == ("pr", False, 1.01, 1.0)
    assert (crossed.severity, crossed.state) == ("state", "elastic film")
    assert "elastic up to its limiting stress" in crossed.meaning
    assert 'shear_law = "limit"' in crossed.remedy


@pytest.mark.parametrize("law", ["limit", None])
def test_films_that_flow_at_their_limit_are_not_judged(law):
    assert oil_notes(joint(law=law), rolling(1e4, 1e4)) == ()


def test_what_does_not_roll_has_no_note():
    assert oil_notes(joint(), rolling(np.nan, np.nan)) == ()
    assert oil_notes(joint(law="limit", lowest=353.15, speed=0.0), rolling(np.nan, np.nan)) == ()
    assert oil_notes(joint(), SimpleNamespace(film=None)) == ()


@pytest.mark.parametrize(("temperature", "ok"), [(353.2, True), (353.1, False), (290.0, False)])
def test_an_oil_must_be_as_warm_as_its_data(temperature, ok):
    (note,) = oil_notes(joint(law="limit", temperature=temperature, lowest=353.15), rolling(1.0, 1.0))
    assert (note.ok, note.contact, note.display_unit) == (ok, None, "degC")
    assert (note.value, note.limit) == pytest.approx((temperature - 273.15, 80.0))
    assert (note.state == "extrapolated") is not ok
    assert ("begin at 80 degC" in note.meaning) is not ok


def with_oil(name, fluid, tmp_path):
    """An example with an oil at 20 degC, under a small torque that it carries."""
    text = re.sub(
        r"(?m)^\[(lubrication|temperature)\]\n(?:(?!\[).*\n)*", "", (EXAMPLES / f"{name}.toml").read_text()
    )
    text = re.sub(r'(?m)^output_torque = "[^"]*"', 'output_torque = "0.2 N*m"', text)
    path = tmp_path / f"{name}_{fluid}.toml"
    path.write_text(text + OIL.format(warm="20 degC", fluid=fluid))
    return path


@pytest.mark.parametrize(
    "name", ["zou2025", "planetary", "multiroller", "stepped_planet", "wheel_pair", "planar"]
)
@pytest.mark.parametrize(
    ("fluid", "note", "state"),
    [("Santotrac 50", "oil_temperature", "extrapolated"), ("N100", "deborah_number", "elastic film")],
)
def test_every_drive_says_it(name, fluid, note, state, tmp_path):
    joint = joint_from_case(read_case(with_oil(name, fluid, tmp_path)))
    found = [entry for entry in oil_notes(joint, joint_state(joint).rolling) if entry.name == note]
    assert len(found) == (1 if note == "oil_temperature" else len(joint.contact_names))
    assert all(entry.state == ("" if entry.ok else state) for entry in found)
    assert not found[0].ok  # the first contact is pressed hardest


def test_documents_and_warnings_have_them(tmp_path):
    solved = asperity.load(with_oil("wheel_pair", "Santotrac 50", tmp_path)).solve()
    (entry,) = (entry for entry in solved.document["diagnostics"] if entry["name"] == "oil_temperature")
    assert (entry["value"], entry["shown"], entry["limit_shown"]) == (
        pytest.approx(20.0),
        "20 degC",
        "80 degC",
    )
    (block,) = (block for block in solved.blocks() if isinstance(block, Warnings))
    said = " ".join(one.text for one in block.items)
    assert "temperature of the oil 20 degC (extrapolated)" in said


def test_the_film_over_speed_says_it(tmp_path):
    path = tmp_path / "oil.toml"
    path.write_text(
        (EXAMPLES / "oil.toml").read_text().replace("Santotrac 50", "N100").replace("10 N*m", "2 N*m")
    )
    said = " ".join(sentences(film(film_document(joint_film(asperity.load(path).case, points=3)))))
    assert "The Deborah number is above 1 at sp (up to" in said
