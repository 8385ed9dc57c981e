"""Stiffness between pins without clearance and the largest clearance of a close fit."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.pin_interval import clearance_interval, largest_clearance, presses_in_bores
from asperity.joint.solve import solve_joint

ARCMIN = math.pi / 10800.0
PINS = {"[model]": '[bearings]\npin_diameter = "26 mm"\n\n[model]'}


def test_the_largest_clearance_is_half_of_both_tolerances():
    """ISO 286-1: IT7 and IT6 of 26 mm are 21 and 13 µm, of 4 mm 12 and 8 µm, on the diameter."""
    assert largest_clearance(26e-3) == pytest.approx(17e-6)
    assert largest_clearance(4e-3) == pytest.approx(10e-6)
    with pytest.raises(InputError, match="up to 500 mm"):
        largest_clearance(0.6)


@pytest.mark.slow
def test_without_a_stated_clearance_both_ends_are_told(planar_joint):
    """The ends are the stiffness without clearance, and with 17 µm: between them it falls all the way."""
    joint = planar_joint("planetary_hollow", PINS)
    solution = solve_joint(joint)
    found = clearance_interval(joint, solution.result)
    most = solve_joint(dataclasses.replace(joint, pin_clearance=np.asarray(17e-6)))
    ends = [float(each.result.assembly.stiffness.output) for each in (most, solution)]
    assert [found["low_Nm_per_rad"], found["high_Nm_per_rad"]] == pytest.approx(ends, rel=1e-9)
    assert found["largest_clearance_m"] == pytest.approx(17e-6)
    assert "between none and 17 um, the most of a fit H7/h6" in found["words"]
    assert found["words"].endswith(
        f"the assembled stiffness is {ends[0] * ARCMIN:.0f} to {ends[1] * ARCMIN:.0f} N·m/arcmin"
    )
    stated = dataclasses.replace(joint, pin_clearance_stated=True)
    assert clearance_interval(stated, solution.result) is None


def test_pins_that_press_nowhere_or_have_no_fit_leave_nothing_open(planar_joint):
    assert not presses_in_bores(planar_joint("planetary"))
    assert clearance_interval(planar_joint("planetary"), None) is None
    friction = {
        "[model]": PINS["[model]"].replace(
            "pin_diameter", "pin_friction_coefficient = 0.01\npin_friction_diameter"
        )
    }
    assert clearance_interval(planar_joint("planetary", friction), None) is None
    joint = planar_joint("planetary_hollow", PINS)
    shapes = tuple(
        shape if shape.pin_diameter is None else dataclasses.replace(shape, pin_diameter=0.6)
        for shape in joint.shapes
    )
    assert clearance_interval(dataclasses.replace(joint, shapes=shapes), None) is None


@pytest.mark.slow
def test_no_ends_where_a_state_is_missing(planar_joint, monkeypatch):
    joint = planar_joint("planetary_hollow", PINS)
    result = solve_joint(joint).result
    lost = dataclasses.replace(result, solved=np.asarray(False))
    monkeypatch.setattr("asperity.joint.pin_interval.joint_state", lambda _: lost)
    found = clearance_interval(joint, result)
    assert (found["low_Nm_per_rad"], found["high_Nm_per_rad"]) == (None, None)
    assert found["words"].endswith("the assembled stiffness is not known over it")
