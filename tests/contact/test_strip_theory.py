"""Crowned rollers in slices: Lambert's function, Kalker's line limit and CONTACT."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import lambertw

from asperity.contact.carter import gross_slip_creepage, slip_ratio_at_creepage
from asperity.contact.hertz_line import effective_radius, half_width
from asperity.contact.strip_theory import (
    strip_creepage,
    strip_logarithm,
)

E, NU, B, N = 206e9, 0.3, 10e-3, 2000.0
MODULUS = E / (2 * (1 - NU**2))
RADIUS = float(effective_radius(radius_1=10e-3, radius_2=20e-3, sign=1.0))
BODY = {"youngs_modulus": E, "poisson_ratio": NU}
SLICES = 41
PLACE = (np.arange(SLICES) - SLICES // 2) * B / SLICES


WIDTH = float(half_width(normal_force=N, contact_length=B, effective_radius=RADIUS, contact_modulus=MODULUS))


def test_logarithm_is_lamberts_function_to_rounding():
    """v - ln v = t is v = -W_{-1}(-e^-t)."""
    target = np.concatenate([1.0 + np.geomspace(1e-6, 1.0, 30), np.linspace(2.0, 700.0, 30)])
    v = np.asarray(strip_logarithm(np.asarray(target)))
    np.testing.assert_allclose(v, -lambertw(-np.exp(-target), -1).real, rtol=2e-9)
    np.testing.assert_allclose(v - np.log(v), target, rtol=5e-16)


def test_creep_coefficient_of_a_long_ellipse_is_kalkers():
    """Strips over an ellipse: C11 = pi^2/(4(1-nu)); CONTACT (tractcurv, a/b = 0.5, nu 0.28) gives 3.789, 11 % more."""
    a, b, poisson, shear = 6.304e-3, 12.61e-3, 0.28, 82e9
    place = b * np.cos((np.arange(2000) + 0.5) * np.pi / 2000)
    lengths = b * np.sin((np.arange(2000) + 0.5) * np.pi / 2000) * np.pi / 2000
    half_widths = a * np.sqrt(1 - (place / b) ** 2)
    slope = np.sum(0.5 * math.pi * half_widths * shear / (1 - poisson) * lengths)  # Carter's, of every strip
    coefficient = slope / (shear * a * b)
    assert coefficient == pytest.approx(math.pi**2 / (4 * (1 - poisson)), rel=1e-5)
    contact = 247.0 / 1e-5 / (shear * a * b)  # first case of the deck: 247.0 N at a creepage of 1e-5
    assert contact == pytest.approx(3.789, rel=2e-3)
    assert 0.08 < contact / coefficient - 1 < 0.25


@pytest.mark.slow
@pytest.mark.parametrize("crown", [0.0, 0.5, 3.0])
def test_creepage_and_force_are_inverse_and_odd(crown):
    """Line loads of a parabola, of which a large crown leaves the ends without contact."""
    load = np.maximum(1.0 - crown * (2.0 * PLACE / B) ** 2, 0.0)
    capacity = np.asarray(0.1 * N / SLICES * load)
    limits = gross_slip_creepage(
        friction_coefficient=0.1, half_width=np.asarray(WIDTH * np.sqrt(load)), effective_radius=RADIUS
    )

    def creep(share):
        return strip_creepage(slip_ratio=share, capacity=capacity, gross_slip_creepage=limits)

    share = np.linspace(-1.0, 1.0, 41)
    xi = jax.vmap(creep)(share)
    shared = jax.vmap(lambda v: slip_ratio_at_creepage(creepage=v, gross_slip_creepage=limits))(xi)
    back = jnp.sum(capacity * shared, axis=1) / jnp.sum(capacity)
    np.testing.assert_allclose(back, share, atol=1e-13)
    np.testing.assert_allclose(xi, -xi[::-1], atol=1e-18)
    assert float(xi[-1]) == pytest.approx(float(jnp.max(limits)), rel=1e-6)
    assert float(creep(1.01)) == np.inf
    # a crowned roller creeps less than a cylinder at small force: its middle slices are wider
    for at in (0.0, 0.3, -0.9, 0.99):
        step = 1e-6
        numeric = float(creep(at + step) - creep(at - step)) / (2 * step)
        assert float(jax.grad(creep)(at)) == pytest.approx(numeric, rel=1e-5)
