"""The eleven equations: satisfied by a drive balanced by hand, and each one sensitive to its own forces."""

import math

import numpy as np
import pytest

from asperity.drive.mechanism import Bearings
from asperity.drive.wedge.equilibrium import balance_equations
from asperity.drive.wedge.geometry import DriveGeometry, triangle

GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
NAMES = ("1", "2x", "2y", "2M", "3t", "3r", "3M", "4t", "4r", "4M", "5")


def balanced():
    """A loss-free state with T_sp = 40 N and S = 1100 N, worked out line by line from (1)–(5)."""
    sides = triangle(GEOMETRY)
    theta, beta = (
        math.atan2(*map(float, pair))
        for pair in ((sides.sin_direction, sides.cos_direction), (sides.sin_wedge, sides.cos_wedge))
    )
    t_sp, load = 40.0, 1100.0
    difference = t_sp / math.tan(theta / 2.0)
    n_pwr, n_pwl = (load + difference) / 2.0, (load - difference) / 2.0
    t_pwr, t_pwl = t_sp * n_pwr / load, t_sp * n_pwl / load
    left = n_pwl * math.sin(beta) + t_pwl * math.cos(beta) + t_pwl
    right = n_pwr * math.sin(beta) - t_pwr * math.cos(beta) - t_pwr
    return {
        "normal": [
            (t_pwr - t_pwl) * math.sin(theta) + load * math.cos(theta),
            n_pwr,
            n_pwl,
            n_pwr * math.cos(beta) + t_pwr * math.sin(beta),
            n_pwl * math.cos(beta) - t_pwl * math.sin(beta),
        ],
        "tangential": [t_sp, t_pwr, t_pwl, t_pwr, t_pwl],
        "pin_left": left,
        "pin_right": right,
        "left_bearing_torque": 0.0,
        "right_bearing_torque": 0.0,
        "input_torque": 3.0 * t_sp * 4e-3,
        "output_torque": 3.0 * (left - right) * 35e-3,
        "planet_centrifugal": 0.0,
        "roller_centrifugal": 0.0,
    }


def residuals(state):
    values = balance_equations(
        geometry=GEOMETRY, sides=triangle(GEOMETRY), bearings=Bearings(0.0, 0.0, 0.0, 0.0, 0.0), **state
    )
    return dict(zip(NAMES, np.asarray(values, dtype=float), strict=True))


def test_a_state_balanced_by_hand_has_no_residual():
    assert max(abs(value) for value in residuals(balanced()).values()) < 1e-9
    # loss-free: T_out = 9 T_in for R_o = 10 R_s
    state = balanced()
    assert state["output_torque"] == pytest.approx(9.0 * state["input_torque"], rel=1e-9)


@pytest.mark.parametrize(
    ("key", "index", "touched"),
    [
        ("normal", 0, {"2y"}),
        ("normal", 1, {"2x", "2y", "4t", "4r"}),
        ("normal", 2, {"2x", "2y", "3t", "3r"}),
        ("normal", 3, {"4r"}),
        ("normal", 4, {"3r"}),
        ("tangential", 0, {"1", "2x", "2M"}),
        ("tangential", 1, {"2x", "2y", "2M", "4t", "4r", "4M"}),
        ("tangential", 3, {"4t", "4M"}),
        ("pin_left", None, {"3t", "5"}),
        ("pin_right", None, {"4t", "5"}),
        ("output_torque", None, {"5"}),
        ("input_torque", None, {"1"}),
    ],
)
def test_each_force_appears_where_the_paper_has_it(key, index, touched):
    state = balanced()
    if index is None:
        state[key] += 1.0
    else:
        state[key][index] += 1.0
    assert {name for name, value in residuals(state).items() if abs(value) > 1e-6} == touched
