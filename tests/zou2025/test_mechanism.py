"""The preloaded drive at rest, and the steepest slope of its springs."""

import math

import numpy as np
import pytest

from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.drive.normal_springs import NormalSprings, compression
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
    """The slope of the compression by differences: that of any load is less, and below the least load it is this."""
    spring, rest = NormalSprings(np.array(1.4e-8), np.array(1.2e-8)), 1000.0
    steepest = float(steepest_compliance(spring))

    def slope(low, high):
        at = (float(compression(springs=spring, normal_force=n, rest_force=rest)) for n in (low, high))
        return -np.subtract(*at) / (high - low)

    assert slope(-1.0, 0.9e-6 * rest) == pytest.approx(steepest, rel=1e-9)
    for force in (1.0, 100.0, 1000.0, 5000.0):
        assert 0.0 < slope(0.999 * force, 1.001 * force) < steepest
