"""Pins as thick as their rollers, and pins that hold them fast."""

import math

import pytest

from asperity.errors import InputError
from asperity.joint.bores import pin_room, refuse_pins


def test_a_pin_as_thick_as_its_roller_and_a_pin_that_grips(paper_joint):
    """Rollers of 5 mm radius; a grip of 1 x 4/10 is harmless up to a push angle of acos 0.4 = 66.4 degrees."""
    refuse_pins(paper_joint())
    refuse_pins(paper_joint(pin_diameter=9.9e-3))
    with pytest.raises(
        InputError, match=r"10\.1 mm must be below the diameter of right_loading_roller, 10 mm"
    ):
        refuse_pins(paper_joint(pin_diameter=10.1e-3))
    pin = {"pin_diameter": 4e-3, "pin_friction_coefficient": 1.0}
    refuse_pins(paper_joint(left_push_angle=math.radians(66.0), **pin))
    with pytest.raises(InputError, match="the pins lock: the friction of left_loading_roller"):
        refuse_pins(paper_joint(left_push_angle=math.radians(67.0), **pin))


def test_of_each_roller_on_a_pin(paper_joint):
    thick, held = pin_room(paper_joint(pin_diameter=4e-3, pin_friction_coefficient=0.5, right_push_angle=1.0))
    assert thick == pytest.approx([0.4, 0.4])
    assert held == pytest.approx([0.2 / math.cos(1.0), 0.2])
