"""The preloaded drive at rest, and its springs against the compression formula they stand for."""

import math

import jax
import numpy as np
import pytest

from asperity.drive.mechanism import NormalSprings, compression, rest_state, steepest_compliance
from asperity.drive.wedge.geometry import DriveGeometry, triangle

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


def johnson(force):
    """Two like steel rollers, R = 4 and 13.5 mm, B = 5 mm: Johnson 1985, equation (5.57), both bodies."""
    modulus, nu, length, radii = 206e9, 0.3, 5e-3, (4e-3, 13.5e-3)
    contact = modulus / (2.0 * (1.0 - nu**2))
    effective = radii[0] * radii[1] / (radii[0] + radii[1])
    width = math.sqrt(4.0 * force * effective / (math.pi * length * contact))
    scale = force / length * (1.0 - nu**2) / (math.pi * modulus)
    return scale * sum(2.0 * math.log(4.0 * radius / width) - 1.0 for radius in radii)


def springs_at(force):
    step = 1e-4 * force
    incremental = (johnson(force + step) - johnson(force - step)) / (2.0 * step)
    return NormalSprings(np.array(johnson(force) / force), np.array(incremental))


@pytest.mark.parametrize("force", [1.0, 200.0, 1000.0, 5000.0])
def test_two_compliances_at_rest_give_the_whole_compression_curve(force):
    ours = compression(springs=springs_at(1000.0), normal_force=force, rest_force=1000.0)
    assert float(ours) == pytest.approx(johnson(force) - johnson(1000.0), rel=1e-6, abs=1e-14)


def test_a_pulling_iterate_sees_the_continued_tangent():
    spring = springs_at(1000.0)
    at = [float(compression(springs=spring, normal_force=n, rest_force=1000.0)) for n in (-100.0, -50.0, 0.0)]
    assert at[0] < at[1] < at[2]
    assert at[2] - at[1] == pytest.approx(at[1] - at[0], rel=1e-9)


def test_the_steepest_compliance_is_that_of_a_contact_about_to_lift():
    spring, rest = springs_at(1000.0), 1000.0
    steepest = float(steepest_compliance(spring))
    low, high = (
        float(compression(springs=spring, normal_force=n, rest_force=rest)) for n in (-1.0, 0.9e-6 * rest)
    )
    assert (high - low) / (1.0 + 0.9e-6 * rest) == pytest.approx(steepest, rel=1e-9)
    for force in (1.0, 100.0, 1000.0, 5000.0):
        slope = (johnson(1.001 * force) - johnson(0.999 * force)) / (0.002 * force)
        assert slope < steepest


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_slopes_and_bends_of_the_compression_by_finite_differences():
    spring = springs_at(1000.0)

    def approach(force):
        return compression(springs=spring, normal_force=force, rest_force=1000.0)

    for force in (3.0, 400.0, 2500.0):
        step = 1e-4 * force
        at = [float(approach(force + k * step)) for k in (-1, 0, 1)]
        assert float(jax.grad(approach)(force)) == pytest.approx((at[2] - at[0]) / (2 * step), rel=1e-6)
        bend = (at[2] - 2 * at[1] + at[0]) / step**2
        assert float(jax.grad(jax.grad(approach))(force)) == pytest.approx(bend, rel=1e-4, abs=0.0)
