"""The accuracy over a turn as it is shown: the largest orders first, sectors together, what may slip."""

from pathlib import Path

import pytest
from form_errors import check_joint
from shown_blocks import sentences, tables

import asperity
from asperity.joint_file.accuracy import joint_accuracy
from asperity.joint_file.reader import parse_case
from asperity.results.accuracy_document import accuracy_document
from asperity.views.accuracy import accuracy

FILE = Path(__file__).parents[2] / "examples" / "accuracy.toml"


@pytest.fixture(scope="module")
def document():
    return accuracy_document(joint_accuracy(asperity.load(FILE).case, reverse=True))


def test_parts_of_all_sectors_stand_in_one_row(document):
    rows = tables(accuracy(document))["Form errors by order, amplitudes of each"].rows
    assert "planet (each of 3)" in {row[0] for row in rows}
    assert len([row for row in rows if row[0].startswith("planet")]) == 2
    errors = [float(row[4]) * (3 if "each of 3" in row[0] else 1) for row in rows]
    assert errors == sorted(errors, reverse=True)


def test_what_symmetry_leaves_out_is_nought(document):
    rows = tables(accuracy(document))["Form errors by order, amplitudes of each"].rows
    (ring,) = [row for row in rows if row[:2] == ("ring", "2")]
    assert ring[4] == "0"


def test_both_directions(document):
    found = tables(accuracy(document))
    assert "Contacts over a turn in the other direction" in found
    assert len(found["Transmission error in both directions"].rows) == 5
    assert "lost motion" in " ".join(sentences(accuracy(document)))


def test_contacts_that_may_slip():
    text = check_joint() + '\n[[form]]\npart = "sun"\nrunout = "20 um"\n'
    document = accuracy_document(joint_accuracy(parse_case(text, source="joint")))
    shown = list(accuracy(document))
    assert "may slip" in {row[-1] for row in tables(shown)["Contacts over a turn"].rows}
    assert "not cut off" in " ".join(sentences(shown))


def test_without_torque_there_is_no_drift_but_torque_swings():
    text = FILE.read_text(encoding="utf-8").replace('output_torque = "5 N*m"', 'output_torque = "0 N*m"')
    found = joint_accuracy(parse_case(text, source="joint"))
    document = accuracy_document(found, allowed=1e-3)
    figures = {figure.name: figure for figure in next(iter(accuracy(document))).items}
    assert figures["drift"].shown == "0"
    without = figures["turns without a reference"]
    assert (without.shown, without.detail) == ("any number", "the output does not drift")
    assert "swings about 0 N·m" in figures["input torque"].detail
    assert 1.0 < float(figures["input torque"].shown) < 100.0  # mN·m
    contacts = tables(accuracy(document))["Contacts over a turn"].rows
    assert {(row[4], row[6]) for row in contacts} == {("0", "0")}


def test_no_rounding_errors_where_symmetry_leaves_nothing():
    """Two and three waves of a ring that four equal sectors share: no transmission error at all."""
    text = (FILE.parent / "multiroller.toml").read_text(encoding="utf-8")
    text += '\n[[form]]\npart = "ring"\nharmonics = { 2 = "0.5 um", 3 = "0.3 um" }\n'
    blocks = list(accuracy(accuracy_document(joint_accuracy(parse_case(text, source="joint"), reverse=True))))
    figures = {figure.name: figure.shown for figure in blocks[0].items}
    assert figures["transmission error"] == figures["transmission error, rms"] == "0"
    assert figures["input torque"] == "0"
    directions = tables(blocks)["Transmission error in both directions"].rows
    assert {row[1:] for row in directions if "wind-up" not in row[0] and "repeat" not in row[0]} == {
        ("0", "0")
    }


def test_of_contacts_alike_the_first_is_named(document):
    """The runout of the ring loads the contacts of all sectors alike, but for rounding errors."""
    rows = tables(accuracy(document))["Form errors by order, amplitudes of each"].rows
    assert {row[-1] for row in rows if row[0] == "ring"} == {"sp 1"}
