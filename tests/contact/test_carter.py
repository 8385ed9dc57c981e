"""Carter's rolling line contact against CONTACT, against the elastic strain of its own traction, and at its limits."""

from itertools import pairwise

import jax
import numpy as np
import pytest
from scipy.integrate import quad

from asperity.contact.carter import (
    creepage,
    gross_slip_creepage,
    rolling_traction,
    slip_ratio_at_creepage,
    stick_centre,
    stick_half_width,
)
from asperity.contact.hertz_line import half_width, peak_pressure

E, NU, B, R, N = 206e9, 0.3, 10e-3, 20e-3 / 3, 2000.0
MODULUS = E / (2 * (1 - NU**2))
WIDTH = float(half_width(normal_force=N, contact_length=B, effective_radius=R, contact_modulus=MODULUS))
LIMIT = float(gross_slip_creepage(friction_coefficient=0.1, half_width=WIDTH, effective_radius=R))


def test_creepage_is_against_the_force_of_either_sign():
    share = np.array([0.1, 0.25, 0.5, 0.75, 1.0])
    found = creepage(slip_ratio=np.stack([share, -share]), gross_slip_creepage=LIMIT)
    np.testing.assert_array_equal(found[0], -found[1])


def test_slope_of_the_force_at_rest():
    """Kalker's coefficient of a long contact, pi a E* B/2, whatever the friction."""
    found = 0.5 * np.pi * WIDTH * MODULUS * B
    assert float(found) == pytest.approx(2.1774e5, rel=2e-4)
    slope = jax.grad(lambda xi: slip_ratio_at_creepage(creepage=xi, gross_slip_creepage=LIMIT))
    for xi in (0.0, 1e-12, -1e-12):
        assert float(slope(xi)) * 0.1 * N == pytest.approx(float(found), rel=1e-6)


def test_deck_carter2d_of_contact():
    """CONTACT (Vollebregt), example carter2d: G 82 GPa, nu 0.28, R 500 mm, 178.9 N/mm, mu 0.3, creepage 2.4e-4.

    Its 50 cells give 0.6480, its deck names 0.64 and a stick zone of half-width 0.6 mm. Tractions in MPa.
    """
    modulus = 82e9 / (1 - 0.28)
    width = half_width(
        normal_force=178.9e3, contact_length=1.0, effective_radius=0.5, contact_modulus=modulus
    )
    limit = gross_slip_creepage(friction_coefficient=0.3, half_width=width, effective_radius=0.5)
    share = slip_ratio_at_creepage(creepage=2.4e-4, gross_slip_creepage=limit)
    assert float(share) == pytest.approx(0.639995, abs=1e-6)
    assert float(share) == pytest.approx(0.6480, rel=0.015)
    assert float(stick_half_width(slip_ratio=share, half_width=width)) == pytest.approx(0.60001e-3, rel=1e-5)
    contact = {-0.81: 20.1, -0.25: 33.1, 0.03: 18.3, 0.11: 16.3, 0.35: 11.8, 0.55: 8.92}
    ours = rolling_traction(
        position=np.array(list(contact)) * 1e-3,
        slip_ratio=share,
        half_width=width,
        peak_pressure=peak_pressure(normal_force=178.9e3, contact_length=1.0, half_width=width),
        friction_coefficient=0.3,
    )
    np.testing.assert_allclose(ours, np.array(list(contact.values())) * 1e6, rtol=0.03)


def traction(x, share):
    return float(
        rolling_traction(
            position=x,
            slip_ratio=share,
            half_width=WIDTH,
            peak_pressure=2 * N / (np.pi * WIDTH * B),
            friction_coefficient=0.1,
        )
    )


@pytest.mark.parametrize("share", [0.2, 0.7, -0.7, 1.0])
def test_traction_integrates_to_the_force(share):
    kink = WIDTH - 2 * WIDTH * np.sqrt(1 - abs(share))
    parts = [-WIDTH, kink, WIDTH]
    total = sum(quad(traction, a, b, args=(share,), epsrel=1e-8)[0] for a, b in pairwise(parts))
    assert total * B == pytest.approx(share * 0.1 * N, rel=1e-6)


@pytest.mark.slow
@pytest.mark.parametrize("share", [0.3, 0.8])
def test_stick_zone_strains_uniformly_by_the_creepage(share):
    """Steady rolling: in the stick zone 2/(pi E*) PV int q(s)/(s - x) ds is the creepage."""
    xi = float(creepage(slip_ratio=share, gross_slip_creepage=LIMIT))
    stick = WIDTH * np.sqrt(1 - share)
    kink = WIDTH - 2 * stick

    def strain(x):
        inner = (max(kink, -WIDTH) + x) / 2 if x > kink else -WIDTH
        total = quad(traction, inner, WIDTH, args=(share,), weight="cauchy", wvar=x, epsrel=1e-6, limit=400)[
            0
        ]
        for a, b in ((-WIDTH, kink), (kink, inner)):
            if b > a and inner > -WIDTH:
                total += quad(lambda s: traction(s, share) / (s - x), a, b, epsrel=1e-8, limit=200)[0]
        return -2 / (np.pi * MODULUS) * total

    for place in (0.2, 0.5, 0.8):
        assert strain(kink + place * 2 * stick) == pytest.approx(xi, rel=2e-3)


def test_stick_zone_begins_at_the_leading_edge():
    share = np.array([0.0, 0.4, -0.4, 0.99, 1.0, 1.5])
    stick = stick_half_width(slip_ratio=share, half_width=WIDTH)
    np.testing.assert_allclose(stick_centre(slip_ratio=share, half_width=WIDTH) + stick, WIDTH, rtol=1e-14)
    np.testing.assert_allclose(stick[-2:], 0.0)
    np.testing.assert_allclose(stick[1] ** 2, 0.6 * WIDTH**2, rtol=1e-12)


def test_both_directions_are_inverse_and_odd():
    share = np.concatenate([np.linspace(-1.0, 1.0, 201), np.array([1e-14, -1e-14])])
    xi = creepage(slip_ratio=share, gross_slip_creepage=LIMIT)
    np.testing.assert_allclose(
        slip_ratio_at_creepage(creepage=xi, gross_slip_creepage=LIMIT), share, rtol=1e-13
    )
    np.testing.assert_allclose(xi, -creepage(slip_ratio=-share, gross_slip_creepage=LIMIT), rtol=0)


def test_no_creepage_carries_more_than_friction():
    found = creepage(slip_ratio=np.array([1.1, -1.1]), gross_slip_creepage=LIMIT)
    np.testing.assert_array_equal(found, [np.inf, -np.inf])
    back = slip_ratio_at_creepage(creepage=np.array([2 * LIMIT, -2 * LIMIT]), gross_slip_creepage=LIMIT)
    np.testing.assert_array_equal(back, [1.0, -1.0])
    assert float(slip_ratio_at_creepage(creepage=0.0, gross_slip_creepage=0.0)) == 0.0  # no contact


@pytest.mark.parametrize("share", [0.0, 1e-9, 0.3, -0.3, 0.99, 1.2])
def test_derivatives_are_finite_on_both_sides_of_gross_slip(share):
    def curve(q):
        return creepage(slip_ratio=q, gross_slip_creepage=LIMIT)

    derivative = float(jax.grad(curve)(share))
    if share < 1.0:
        step = 1e-7
        numeric = float(curve(share + step) - curve(share - step)) / (2 * step)
        assert derivative == pytest.approx(numeric, rel=1e-5)
    assert np.isfinite(derivative)
    assert np.isfinite(float(jax.grad(lambda q: stick_half_width(slip_ratio=q, half_width=WIDTH))(share)))
