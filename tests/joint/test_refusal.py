"""Numbers on both sides of every range that physics sets, and messages with numbers by hand."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.refusal import (
    refuse_bad_numbers,
    refuse_locked_pins,
    refuse_pulled_rollers,
    refuse_short_contacts,
    refuse_wide_contacts,
)

RIGHT = 0.5 * math.pi


def test_short_crowned_contacts_are_named_as_their_drive_names_them():
    """0.3 mm of half-width: 0.6 mm wide, and 1.5 times as long."""
    diagnostics = SimpleNamespace(
        slices_hold=np.array([True, False]),
        hertz_half_width=np.array([0.1e-3, 0.3e-3]),
        loaded_length_over_width=np.array([20.0, 1.5]),
    )
    result = SimpleNamespace(contact_names=("sp", "pr"), diagnostics=diagnostics)
    with pytest.raises(InputError, match=r"touch at pr over a length of 0\.9 mm and a width of 0\.6 mm"):
        refuse_short_contacts(result)
    diagnostics.slices_hold = None  # cylinders
    refuse_short_contacts(result)


@pytest.mark.parametrize(
    ("name", "inside", "outside"),
    [
        ("left_push_angle", (-0.99 * RIGHT, 0.99 * RIGHT), (-1.01 * RIGHT, 1.01 * RIGHT)),
        ("right_push_angle", (-0.99 * RIGHT, 0.99 * RIGHT), (-1.01 * RIGHT, 1.01 * RIGHT)),
        ("poisson_ratio", (-0.99, 0.5), (-1.01, 0.5001)),
        ("fractal_dimension", (1.01, 1.99), (0.99, 1.0, 2.0, 2.01)),
        ("planet_count", (1.0, 4.0), (0.0, 2.5)),
        ("preload", (1e-6,), (0.0, -1.0, math.inf)),
        ("sun_torque", (0.0,), (-1e-9, math.inf)),
        ("pin_diameter", (0.0,), (-1e-9,)),
        ("sun_speed", (-10.0, 0.0), (math.inf, math.nan)),
    ],
)
def test_ranges_from_both_sides(paper_joint, name, inside, outside):
    for value in inside:
        refuse_bad_numbers(paper_joint(**{name: value}))
    for value in outside:
        with pytest.raises(InputError, match=name):
            refuse_bad_numbers(paper_joint(**{name: value}))


def test_frequencies_must_grow_and_springs_must_not_push(paper_joint):
    joint = paper_joint()
    for ratio, allowed in ((1.01, True), (0.99, False)):
        surface = dataclasses.replace(joint.surfaces[0], frequency_ratio=np.asarray(ratio))
        changed = dataclasses.replace(joint, surfaces=(surface,))
        if allowed:
            refuse_bad_numbers(changed)
        else:
            with pytest.raises(InputError, match="must be above 1"):
                refuse_bad_numbers(changed)
    for stiffness in (0.0, math.inf):
        structure = dataclasses.replace(joint.structure, pin_stiffness=stiffness)
        refuse_bad_numbers(dataclasses.replace(joint, structure=structure))
    structure = dataclasses.replace(joint.structure, pin_stiffness=-1.0)
    with pytest.raises(InputError, match="pin_stiffness = -1 is not allowed"):
        refuse_bad_numbers(dataclasses.replace(joint, structure=structure))


def test_a_pin_as_thick_as_its_roller_and_a_pin_that_grips(paper_joint):
    """Rollers of 5 mm radius; a grip of 1 x 4/10 is harmless up to a push angle of acos 0.4 = 66.4 degrees."""
    refuse_locked_pins(paper_joint(pin_diameter=9.9e-3))
    with pytest.raises(InputError, match=r"10\.1 mm must be below the diameter of the loading roller, 10 mm"):
        refuse_locked_pins(paper_joint(pin_diameter=10.1e-3))
    pin = {"pin_diameter": 4e-3, "pin_friction_coefficient": 1.0}
    refuse_locked_pins(paper_joint(left_push_angle=math.radians(66.0), **pin))
    with pytest.raises(
        InputError, match=r"diameter of the loading roller is 0\.4, it must be below .* 0\.391"
    ):
        refuse_locked_pins(paper_joint(left_push_angle=math.radians(67.0), **pin))


def test_a_pin_that_pulls_its_roller_off_the_ring(paper_joint):
    """N_pw (cos beta + sin beta tan gamma) with beta = 13.1582 degrees and N_pw = 1000 N/(2 cos 27.0831)."""
    wedge = math.radians(13.1582)
    result = SimpleNamespace(angles=SimpleNamespace(wedge=wedge))
    refuse_pulled_rollers(paper_joint(left_push_angle=math.radians(-76.0)), result)
    force = 500.0 / math.cos(math.radians(27.0831))
    force *= math.cos(wedge) + math.sin(wedge) * math.tan(math.radians(-80.0))
    with pytest.raises(InputError) as refused:
        refuse_pulled_rollers(paper_joint(left_push_angle=math.radians(-80.0)), result)
    assert f"the contact wlo would have to carry {force:.3g} N" in str(refused.value)
    assert "-76.84" in str(refused.value)


def test_a_strip_as_wide_as_its_body_is_named_with_its_whole_width(paper_joint):
    def result(widest):
        widths = np.array([1e-3, widest, 1e-3, 1e-3, 1e-3])
        return SimpleNamespace(
            diagnostics=SimpleNamespace(hertz_half_width=widths),
            interfaces=SimpleNamespace(bulk_normal=np.ones(5)),
        )

    refuse_wide_contacts(paper_joint(), result(4.9e-3))
    with pytest.raises(
        InputError, match=r"contact pwr is 10\.2 mm wide, too wide for a radius or wall of 5 mm"
    ):
        refuse_wide_contacts(paper_joint(), result(5.1e-3))
