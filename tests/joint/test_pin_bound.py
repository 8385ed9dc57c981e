"""Whether a stiffness is an upper bound because the pins are rigid, in every type of drive and every table."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import pytest

from asperity.joint.pin_bound import bound_document, bounded, pins_rigid, stiffness_bound
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values

DRIVES = ("zou2025", "planetary", "multiroller", "stepped_planet", "planar")
PINS = '[bearings]\npin_diameter = "4 mm"\n{}\n[model]'


@pytest.mark.parametrize("name", DRIVES)
def test_pins_of_which_nothing_is_stated_are_rigid_in_every_type_of_drive(name, planar_joint):
    joint = planar_joint(name)
    assert pins_rigid(joint)
    assert stiffness_bound(joint) == "upper bound: pins rigid"
    stated = dataclasses.replace(joint, pin_stiffness=5e7)
    assert stiffness_bound(stated) == ""
    assert pins_rigid(dataclasses.replace(joint, pin_stiffness=math.inf))


@pytest.mark.parametrize(
    ("more", "rigid"),
    [("", True), ('pin_length = "20 mm"\n', False), ('pin_radial_clearance = "5 um"\n', True)],
)
def test_pins_of_a_stated_diameter_and_length_bend(planar_joint, more, rigid):
    joint = planar_joint("planetary", {"[model]": PINS.format(more)})
    assert pins_rigid(joint) == rigid
    # of numbers that are traced as well
    asked = []
    jax.eval_shape(lambda traced: asked.append(pins_rigid(traced)) or jnp.zeros(()), joint)
    assert asked == [rigid]


def test_a_drive_without_pins_has_no_such_bound(planar_joint):
    held = {
        'place = "pin"': 'place = "free"',
        'output = "carrier"': 'output = "ring"',
        'grounded = "ring"': 'grounded = "carrier"',
    }
    joint = planar_joint("planar", held)
    assert not joint.drive.pinned
    assert bound_document(joint) == {"pins_rigid": False, "stiffness_bound": None}


def test_words_for_a_number_say_what_bounds_it():
    assert bounded("K1", "upper bound: pins rigid") == "K1 (upper bound: pins rigid)"
    assert bounded("K1", None) == bounded("K1", "") == "K1"


def test_rows_of_the_assembled_stiffness_carry_the_bound(planar_case):
    """Those of held centres do not: there no pin counts."""
    rigid = results_of(si_values(planar_case("planetary")))
    stated = {"# [compliance]": "[compliance]", "# pin_stiffness": "pin_stiffness"}
    soft = results_of(si_values(planar_case("planetary", replaced=stated)))
    bounds = {name: row.bound for name, row in rigid.items() if row.bound}
    assert set(bounds) == {
        *(f"assembly_stiffness_{what}" for what in ("output", "input", "per_mass", "per_volume")),
        "held_cam_output_stiffness",
    }
    assert set(bounds.values()) == {"upper bound: pins rigid"}
    row = rigid["assembly_stiffness_output"]
    assert row.said == f"{row.label} (upper bound: pins rigid)"
    assert not any(row.bound for row in soft.values())
    assert soft["assembly_stiffness_output"].said == row.label
    assert not rigid["published_stiffness_output"].bound


def test_a_case_in_which_branches_differ_carries_it_too(planar_case):
    text = planar_case("planetary").text + 3 * "\n[[branch]]\n"
    rows = results_of(si_values(parse_case(text, source="x")))
    assert rows["assembly_stiffness_output"].bound == "upper bound: pins rigid"
