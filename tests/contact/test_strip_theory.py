"""Crowned rollers in slices: the cylinder, Hertz's ellipse, Kalker's line limit and CONTACT, bisection."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk, lambertw

from asperity.contact.carter import creep_coefficient, creepage, gross_slip_creepage
from asperity.contact.hertz_line import effective_radius, half_width, roller_secant_compliance
from asperity.contact.strip_theory import (
    circular_crown,
    compression_length,
    slice_line_load,
    strip_creepage,
    strip_loads,
    strip_logarithm,
    strip_slip_ratio,
)

E, NU, B, N = 206e9, 0.3, 10e-3, 2000.0
MODULUS = E / (2 * (1 - NU**2))
RADIUS = float(effective_radius(radius_1=10e-3, radius_2=20e-3, sign=1.0))
BODY = {"youngs_modulus": E, "poisson_ratio": NU}
SLICES = 41
PLACE = (np.arange(SLICES) - SLICES // 2) * B / SLICES


WIDTH = float(half_width(normal_force=N, contact_length=B, effective_radius=RADIUS, contact_modulus=MODULUS))
LENGTH = 2 * B * math.exp(-0.5)


def compression(line_load):
    """Compression of a slice written anew."""
    width = math.sqrt(4 * line_load * RADIUS / (math.pi * MODULUS))
    return line_load / (math.pi * MODULUS) * (2 * math.log(LENGTH / width) - 1)


PAIR = {"effective_radius": RADIUS, "contact_modulus": MODULUS, "compression_length": LENGTH}


def loads(force=N, crown=1.0, tilt=0.0, **changes):
    profile = circular_crown(position=PLACE, crown_radius=crown) + tilt * PLACE
    return strip_loads(normal_force=force, profile=profile, slice_length=B / SLICES, **(PAIR | changes))


def test_law_of_a_slice_is_that_of_a_roller_with_another_length():
    """Johnson (5.57) for two like rollers has four times the geometric mean of the radii for D."""
    found = slice_line_load(compression=6e-6, **(PAIR | {"compression_length": 4 * math.sqrt(10e-3 * 20e-3)}))
    width = half_width(
        normal_force=found, contact_length=1.0, effective_radius=RADIUS, contact_modulus=MODULUS
    )
    body = {"half_width": width, "contact_length": 1.0, "youngs_modulus": E, "poisson_ratio": NU}
    secant = sum(roller_secant_compliance(radius=r, **body) for r in (10e-3, 20e-3))
    assert float(found * secant) == pytest.approx(6e-6, rel=1e-12)


@pytest.mark.parametrize("line_load", [1e-3, 1.0, 2e5, 5e6])
def test_slice_load_inverts_the_compression(line_load):
    found = slice_line_load(compression=compression(line_load), **PAIR)
    assert float(found) == pytest.approx(line_load, rel=1e-12)


def test_logarithm_is_lamberts_function_to_rounding():
    """v - ln v = t is v = -W_{-1}(-e^-t)."""
    target = np.concatenate([1.0 + np.geomspace(1e-6, 1.0, 30), np.linspace(2.0, 700.0, 30)])
    v = np.asarray(strip_logarithm(jnp.asarray(target)))
    np.testing.assert_allclose(v, -lambertw(-np.exp(-target), -1).real, rtol=2e-9)
    np.testing.assert_allclose(v - np.log(v), target, rtol=5e-16)


def test_slice_without_compression_carries_nothing():
    found = slice_line_load(compression=jnp.array([-1e-6, 0.0]), **PAIR)
    np.testing.assert_array_equal(found, 0.0)


@pytest.mark.slow
def test_cylinder_is_one_line_contact():
    found = loads(crown=jnp.inf)
    np.testing.assert_allclose(found.line_load, N / B, rtol=1e-11)
    np.testing.assert_allclose(found.half_width, WIDTH, rtol=1e-11)
    assert float(found.approach) == pytest.approx(compression(N / B), rel=1e-11)
    capacity = 0.1 * found.line_load * B / SLICES
    limits = gross_slip_creepage(
        friction_coefficient=0.1, half_width=found.half_width, effective_radius=RADIUS
    )
    for share in (0.25, -0.5, 0.99):
        carter = creepage(slip_ratio=share, gross_slip_creepage=limits[0])
        strips = strip_creepage(slip_ratio=share, capacity=capacity, gross_slip_creepage=limits)
        assert float(strips) == pytest.approx(float(carter), rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(("crown", "tilt"), [(10.0, 0.0), (1.0, 1e-3), (0.1, 0.0), (1e-2, 0.0), (1e-3, 0.0)])
def test_approach_against_bisection(crown, tilt):
    found = loads(crown=crown, tilt=tilt)
    drop = PLACE**2 / (2 * crown) + tilt * PLACE

    def load(delta):
        return brentq(lambda p: compression(p) - delta, 1e-9, 1e8, rtol=1e-13) if delta > 0 else 0.0

    expected = [load(float(found.approach) - z) for z in drop]
    np.testing.assert_allclose(found.line_load, expected, rtol=1e-7)
    assert float(np.sum(found.line_load)) * B / SLICES == pytest.approx(N, rel=1e-10)
    assert bool(found.solved)


@pytest.mark.slow
def test_no_force_and_lifted_contacts_in_a_batch():
    found = jax.vmap(lambda force: loads(force))(jnp.array([N, 0.0, -5.0]))
    assert bool(jnp.all(found.solved))
    np.testing.assert_array_equal(found.line_load[1:], 0.0)
    np.testing.assert_array_equal(found.approach[1:], 0.0)
    slope = jax.grad(lambda force: jnp.sum(loads(force).half_width))
    assert np.isfinite(float(slope(0.0)))


@pytest.mark.parametrize(("axes", "error"), [(1e4, 6e-3), (100.0, 0.011), (10.0, 0.02), (4.0, 0.03)])
def test_ellipse_of_hertz(axes, error):
    """Strips against Hertz's largest pressure, by the ratio of the semi-axes b/a; exact for a long ellipse.

    R_c/R = ((b/a)^2 E - K)/(K - E), complete integrals with e^2 = 1 - (a/b)^2 (Johnson 1985, 4.25–4.29).
    """
    parameter = 1 - axes**-2
    first, second = ellipk(parameter), ellipe(parameter)
    crown = RADIUS * (axes**2 * second - first) / (first - second)
    width = 1e-5
    b = axes * width
    peak = (
        MODULUS * b * axes * parameter / (2 * crown * (first - second))
    )  # 1/(2 R_c) = p0 a (K - E)/(E* e^2 b^2)
    force = 2 / 3 * math.pi * peak * width * b
    place = (np.arange(401) - 200) / 200 * 1.3 * b
    found = strip_loads(
        normal_force=force,
        profile=circular_crown(position=place, crown_radius=crown),
        slice_length=place[1] - place[0],
        **(PAIR | {"compression_length": compression_length(contact_length=2 * b)}),
    )
    pressure = 2 * float(jnp.max(found.line_load)) / (math.pi * float(jnp.max(found.half_width)))
    assert pressure == pytest.approx(peak, rel=error)


def test_creep_coefficient_of_a_long_ellipse_is_kalkers():
    """Strips over an ellipse: C11 = pi^2/(4(1-nu)); CONTACT (tractcurv, a/b = 0.5, nu 0.28) gives 3.789, 11 % more."""
    a, b, poisson, shear = 6.304e-3, 12.61e-3, 0.28, 82e9
    place = b * np.cos((np.arange(2000) + 0.5) * np.pi / 2000)
    lengths = b * np.sin((np.arange(2000) + 0.5) * np.pi / 2000) * np.pi / 2000
    slope = np.sum(
        creep_coefficient(
            contact_modulus=shear / (1 - poisson),
            half_width=a * np.sqrt(1 - (place / b) ** 2),
            contact_length=lengths,
        )
    )
    coefficient = slope / (shear * a * b)
    assert coefficient == pytest.approx(math.pi**2 / (4 * (1 - poisson)), rel=1e-5)
    contact = 247.0 / 1e-5 / (shear * a * b)  # first case of the deck: 247.0 N at a creepage of 1e-5
    assert contact == pytest.approx(3.789, rel=2e-3)
    assert 0.08 < contact / coefficient - 1 < 0.25


@pytest.mark.slow
@pytest.mark.parametrize("crown", [10.0, 1.0, 0.1])
def test_creepage_and_force_are_inverse_and_odd(crown):
    found = loads(crown=crown)
    capacity = 0.1 * found.line_load * B / SLICES
    limits = gross_slip_creepage(
        friction_coefficient=0.1, half_width=found.half_width, effective_radius=RADIUS
    )

    def creep(share):
        return strip_creepage(slip_ratio=share, capacity=capacity, gross_slip_creepage=limits)

    share = jnp.linspace(-1.0, 1.0, 41)
    xi = jax.vmap(creep)(share)
    back = jax.vmap(lambda v: strip_slip_ratio(creepage=v, capacity=capacity, gross_slip_creepage=limits))(xi)
    np.testing.assert_allclose(back, share, atol=1e-13)
    np.testing.assert_allclose(xi, -xi[::-1], atol=1e-18)
    assert float(xi[-1]) == pytest.approx(float(jnp.max(limits)), rel=1e-6)
    assert float(creep(1.01)) == np.inf
    # a crowned roller creeps less than a cylinder at small force: its middle slices are wider
    for at in (0.0, 0.3, -0.9, 0.99):
        step = 1e-6
        numeric = float(creep(at + step) - creep(at - step)) / (2 * step)
        assert float(jax.grad(creep)(at)) == pytest.approx(numeric, rel=1e-5)


@pytest.mark.slow
def test_derivatives_of_the_approach():
    for crown in (10.0, 0.05):
        slopes = jax.grad(lambda f, c: loads(f, c).approach, argnums=(0, 1))(N, crown)
        by_force = (loads(N + 0.1, crown).approach - loads(N - 0.1, crown).approach) / 0.2
        step = 1e-5 * crown
        by_crown = (loads(N, crown + step).approach - loads(N, crown - step).approach) / (2 * step)
        assert float(slopes[0]) == pytest.approx(float(by_force), rel=1e-6)
        assert float(slopes[1]) == pytest.approx(float(by_crown), rel=1e-5)


def test_more_than_the_law_can_carry_is_not_solved():
    """Half-widths beyond D/e have no compression law: such a load is reported, not answered."""
    assert not bool(loads(force=1e12).solved)
