"""The preloaded drive at rest, and the steepest slope of its springs."""

import math

import numpy as np
import pytest
from johnson_rollers import johnson, springs_at

from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.drive.normal_springs import compression
from asperity.zou2025.mechanism import rest_state, steepest_compliance

RADII = (4e-3, 13.5e-3, 5e-3, 40e-3)


@pytest.mark.parametrize(("left", "right"), [(0.0, 0.0), (0.2, -0.1)])
def test_rest_state_balances_with_inclined_pins(left, right):
    geometry = DriveGeometry(*RADII, 3.0, left, right)
    rest = rest_state(geometry=geometry, sides=triangle(geometry), preload=1000.0)
    sides = triangle(geometry)
    theta, beta = (
        math.atan2(*map(float, pair))
        for pair in ((sides.sin_direction, sides.cos_direction), (sides.sin_wedge, sides.cos_wedge))
    )
    sp, pwr, pwl, wro, wlo = np.asarray(rest.normal_force)
    assert sp == pytest.approx((pwr + pwl) * math.cos(theta), rel=1e-12)
    for pw, wo, pin, angle in (
        (pwr, wro, float(rest.pin_force_right), right),
        (pwl, wlo, float(rest.pin_force_left), left),
    ):
        assert pin * math.cos(angle) == pytest.approx(pw * math.sin(beta), rel=1e-12)
        assert pin * math.sin(angle) + pw * math.cos(beta) == pytest.approx(wo, rel=1e-12)


def test_the_steepest_compliance_is_that_of_a_contact_about_to_lift():
    """Below the least load it is the slope of the compression; that of Johnson's formula under any load is less."""
    spring, rest = springs_at(1000.0), 1000.0
    steepest = float(steepest_compliance(spring))
    low, high = (
        float(compression(springs=spring, normal_force=n, rest_force=rest)) for n in (-1.0, 0.9e-6 * rest)
    )
    assert (high - low) / (1.0 + 0.9e-6 * rest) == pytest.approx(steepest, rel=1e-9)
    for force in (1.0, 100.0, 1000.0, 5000.0):
        slope = (johnson(1.001 * force) - johnson(0.999 * force)) / (0.002 * force)
        assert 0.0 < slope < steepest
