"""Flash temperature: a published case, Blok's constant and Carter's slip zone by quadrature of the moving source."""

import math

import jax
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import minimize_scalar

from asperity.contact.carter import creepage
from asperity.contact.flash_temperature import (
    FLASH_CONSTANT,
    flash_temperature,
    partial_slip_flash_factor,
)

STEEL = {"conductivity": 46.0, "density": 7800.0, "heat_capacity": 460.0}


def rise(power, u1, u2, half_width, effusivity_1, effusivity_2):
    found = flash_temperature(
        friction_power=power,
        surface_speed_1=u1,
        surface_speed_2=u2,
        half_width=half_width,
        effusivity_1=effusivity_1,
        effusivity_2=effusivity_2,
    )
    return float(found)


def highest(heat, start):
    """Largest of int_start^x heat(s)/sqrt(x-s) ds for x up to 1: the surface under a fast moving source."""

    def integral(x):
        return quad(heat, start, x, weight="alg", wvar=(0, -0.5), limit=200)[0]

    found = minimize_scalar(
        lambda x: -integral(x), bounds=(0.5 * (start + 1.0), 1.0), method="bounded", options={"xatol": 1e-9}
    )
    return -found.fun


def ellipse(s):
    return math.sqrt(max(1.0 - s * s, 0.0))


def test_bloks_constant_is_a_moving_elliptic_source():
    """T = q0/(b sqrt(pi u)) int sqrt(a) f/sqrt(x-s) ds with q0 = 2 P'/(pi a): C = (2 sqrt 2/pi^1.5) max integral."""
    constant = 2.0 * math.sqrt(2.0) / math.pi**1.5 * highest(ellipse, -1.0)
    assert constant == pytest.approx(FLASH_CONSTANT, rel=2e-3)


def test_both_surfaces_of_unlike_bodies_rise_alike():
    """Each takes the share of the heat that gives both the same temperature."""
    u1, u2, b1, b2 = 1.3, 0.9, 14000.0, 9000.0
    share = b1 * math.sqrt(u1) / (b1 * math.sqrt(u1) + b2 * math.sqrt(u2))
    alone = FLASH_CONSTANT / math.sqrt(2 * 1e-4)
    first, second = (
        alone * 50.0 * share / (b1 * math.sqrt(u1)),
        alone * 50.0 * (1 - share) / (b2 * math.sqrt(u2)),
    )
    assert first == pytest.approx(second, rel=1e-12)
    assert rise(50.0, u1, u2, 1e-4, b1, b2) == pytest.approx(first, rel=1e-12)


@pytest.mark.parametrize("q", [0.02, 0.2, 0.39, 0.7, 0.95, 1.0])
def test_heat_of_carters_slip_zone(q):
    """Traction mu p times slip (mu/R) sqrt(x'^2 - c^2): its sum is Q xi V, and it is hotter than an even share."""
    c = math.sqrt(1.0 - q)

    def heat(s):
        return ellipse(s) * math.sqrt(max((s + 1.0 - c) ** 2 - c * c, 0.0))

    start = -1.0 + 2.0 * c
    total = quad(heat, start, 1.0, limit=200)[0]
    # in units of mu p0 a and mu a/R: Q = q pi/2
    creep = float(creepage(slip_ratio=q, gross_slip_creepage=1.0))
    assert total == pytest.approx(q * math.pi / 2 * creep, rel=1e-5)
    expected = highest(heat, start) / total / (highest(ellipse, -1.0) / (math.pi / 2))
    assert float(partial_slip_flash_factor(stick_fraction=c)) == pytest.approx(expected, rel=2e-4)


def test_without_slip_there_is_no_heat_and_slopes_are_finite():
    assert float(partial_slip_flash_factor(stick_fraction=1.0)) == math.inf
    slope = jax.grad(lambda c: partial_slip_flash_factor(stick_fraction=c))
    step = partial_slip_flash_factor(stick_fraction=0.4001) - partial_slip_flash_factor(stick_fraction=0.3999)
    assert float(slope(0.4)) == pytest.approx(float(step) / 2e-4, rel=1e-6)
    assert np.isfinite(float(slope(0.0)))
