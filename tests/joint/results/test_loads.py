"""Rows of the loads of pins, carrier and housing, by hand."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint.results import RESULTS


def pinned(pin):
    return SimpleNamespace(
        joint=SimpleNamespace(
            pin=pin, loading_roller_length=5e-3, bearings=SimpleNamespace(pin_diameter=np.asarray(4e-3))
        ),
        loads=SimpleNamespace(pin_resultant=np.array([300.0, 120.0])),
    )


def test_bending_of_a_pin_that_one_end_holds():
    """The roller sits in the middle of 8 mm: 4 mm lever; 32 M/(pi d^3)."""
    solved = pinned(SimpleNamespace(free_length=8e-3, support="one_end"))
    moment = np.asarray(RESULTS["pin_bending_moment"].of(solved))
    np.testing.assert_allclose(moment, np.array([300.0, 120.0]) * 4e-3, rtol=1e-12)
    stress = np.asarray(RESULTS["pin_bending_stress"].of(solved))
    np.testing.assert_allclose(stress, 32.0 * moment / (math.pi * 4e-3**3), rtol=1e-12)


def test_without_a_pin_there_is_no_bending():
    assert np.all(np.isnan(np.asarray(RESULTS["pin_bending_moment"].of(pinned(None)))))
    assert np.all(np.isnan(np.asarray(RESULTS["pin_bending_stress"].of(pinned(None)))))


def test_torques_of_the_papers_joint(value):
    """5 N·m at the carrier; the sun's 5/9 N·m turns the other way, so that the ring holds both."""
    assert value("carrier_torque") == pytest.approx(5.0, rel=1e-9)
    assert abs(value("housing_torque")) == pytest.approx(5.0 * (1.0 + 1.0 / 9.0), rel=1e-3)
    assert value("pin_load").shape == (2,)
    # both pins of a branch turn the carrier, at 35 mm from the axis: (F_right - F_left) cos(push angle 0)
    assert 3.0 * 35e-3 * abs(np.diff(value("pin_load"))[0]) == pytest.approx(5.0, rel=0.02)
