"""What the page is told of a joint beside its document: the file's values, and why there is no wind-up."""

import math

import numpy as np
import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.page.answer import _windup, plain_numbers, stated_values


def test_numbers_for_json():
    assert plain_numbers(np.array([1.5, np.nan, np.inf, -np.inf, 0.0])) == [1.5, None, None, None, 0.0]


def test_values_are_in_the_unit_of_display_and_in_si(joint_text):
    text = joint_text.replace('"13.5 mm"', '"0.0135 m +- 5 um, uniform"')
    numbers = stated_values(parse_case(text, source="x"))["numbers"]
    assert numbers["drive.planet_radius"] == {
        "value": 13.5,
        "si": pytest.approx(0.0135, rel=1e-15),
        "tolerance": pytest.approx(5e-6, rel=1e-12),
    }
    assert numbers["load.sun_speed"]["value"] == 6000.0
    assert numbers["load.sun_speed"]["si"] == pytest.approx(6000.0 * math.pi / 30.0, rel=1e-15)
    assert numbers["materials.steel.youngs_modulus"]["value"] == 206.0


def test_a_choice_that_the_file_leaves_out_is_empty(case, joint_text):
    choices = stated_values(case)["choices"]
    assert choices["model.contact_factor"] == "printed" or choices["model.contact_factor"] == "unity"
    assert choices["model.bodies"] == "exact"
    lines = [line for line in joint_text.splitlines() if not line.startswith("bodies =")]
    assert stated_values(parse_case("\n".join(lines), source="x"))["choices"]["model.bodies"] == ""


def test_without_a_torque_there_is_no_windup(joint_text):
    joint = joint_from_case(parse_case(joint_text.replace('"5 N*m"', '"0 N*m"'), source="x"))
    assert _windup(joint) == {"unknown_because": "no torque, no wind-up: set an output torque"}
