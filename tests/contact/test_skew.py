"""Skewed contacts: the paper's sun contact, Kalker's limits, and the solver against its own forces."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import brentq

from asperity.bem.elastic_pair import elastic_pair
from asperity.bem.free_half_space import FreeHalfSpace
from asperity.bem.steady_rolling import steady_rolling
from asperity.contact.carter import creepage, gross_slip_creepage
from asperity.contact.hertz_line import half_width
from asperity.contact.skew import (
    axial_force,
    lateral_compliance_ratio,
    longitudinal_capacity_ratio,
    skewed_contact,
    skewed_slip_ratios,
    stick_fraction,
)

STEEL = {"youngs_modulus_1": 206e9, "youngs_modulus_2": 206e9, "poisson_ratio_1": 0.3, "poisson_ratio_2": 0.3}
LIMITS = {"gross_slip_creepage": 3.24e-3, "lateral_gross_slip_creepage": 4.63e-3}


def test_sun_contact_of_the_paper():
    """Sun 4 mm on planet 13.5 mm, 5 mm long, 1000 N, mu 0.12, steel: 1 mrad of skew takes 39 % of mu N."""
    radius = 4e-3 * 13.5e-3 / 17.5e-3
    width = half_width(
        normal_force=1000.0, contact_length=5e-3, effective_radius=radius, contact_modulus=206e9 / 1.82
    )
    along = gross_slip_creepage(friction_coefficient=0.12, half_width=width, effective_radius=radius)
    across = along * lateral_compliance_ratio(**STEEL)
    assert float(along) == pytest.approx(3.24e-3, rel=2e-3)
    assert float(across) == pytest.approx(4.63e-3, rel=2e-3)
    _, ratio = skewed_slip_ratios(
        longitudinal_creepage=0.0,
        lateral_creepage=1e-3,
        gross_slip_creepage=along,
        lateral_gross_slip_creepage=across,
    )
    assert float(ratio) == pytest.approx(0.39, abs=0.006)
    force = axial_force(friction_coefficient=0.12, normal_force=1000.0, lateral_slip_ratio=ratio)
    assert float(force) == pytest.approx(46.0, abs=0.6)


def test_lateral_compliance_is_antiplane_shear():
    """A long contact in anti-plane shear: 1/G_1 + 1/G_2 for the 2/E* of plane strain; Kalker's C22/C11 = 1 - nu."""
    kalker = (np.pi**2 / 4) / (np.pi**2 / (4 * (1 - 0.3)))
    assert float(lateral_compliance_ratio(**STEEL)) == pytest.approx(1 / kalker, rel=1e-12)
    e1, e2, nu1, nu2 = 206e9, 70e9, 0.3, 0.2
    shear = 2 * (1 + nu1) / e1 + 2 * (1 + nu2) / e2
    plane = 2 * ((1 - nu1**2) / e1 + (1 - nu2**2) / e2)
    found = lateral_compliance_ratio(
        youngs_modulus_1=e1, youngs_modulus_2=e2, poisson_ratio_1=nu1, poisson_ratio_2=nu2
    )
    assert float(found) == pytest.approx(shear / plane, rel=1e-12)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_one_direction_alone_is_carter():
    share = jnp.linspace(-1.0, 1.0, 41)
    xi = creepage(slip_ratio=share, gross_slip_creepage=LIMITS["gross_slip_creepage"])
    along, across = skewed_slip_ratios(longitudinal_creepage=xi, lateral_creepage=0.0, **LIMITS)
    np.testing.assert_allclose(along, share, atol=1e-14)
    np.testing.assert_array_equal(across, 0.0)
    solved = skewed_contact(longitudinal_slip_ratio=share, lateral_creepage=0.0, **LIMITS)
    np.testing.assert_allclose(solved.longitudinal_creepage, xi, rtol=1e-12)
    assert bool(jnp.all(solved.solved))


def test_traction_turns_from_the_scaled_creepage_to_the_slip():
    xi = np.array([[1e-3, 2e-3], [-3e-3, 1e-3], [4e-3, -4e-3], [0.0, 9e-3]])
    along, across = skewed_slip_ratios(longitudinal_creepage=xi[:, 0], lateral_creepage=xi[:, 1], **LIMITS)
    scaled = xi / np.array([3.24e-3, 4.63e-3])
    length = np.hypot(*scaled.T)
    total = np.where(length < 1, 1 - (1 - length) ** 2, 1.0)
    np.testing.assert_allclose(np.hypot(along, across), total, rtol=1e-13)
    small, large = (
        skewed_slip_ratios(longitudinal_creepage=0.7 * size, lateral_creepage=size, **LIMITS)
        for size in (1e-9, 1.0)
    )
    assert float(small[0] / small[1]) == pytest.approx(0.7 * 4.63 / 3.24, rel=1e-6)
    assert float(large[0] / large[1]) == pytest.approx(0.7, rel=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("share", "angle"), [(0.4, 30.0), (0.8, 60.0), (0.95, 45.0), (1.1, 40.0), (1.6, 55.0)]
)
def test_forces_against_boundary_elements(share, angle):
    """Steady rolling of a smooth line contact with both creepages, nu = 0.3; lengths in half-widths."""
    points = 160
    pair = elastic_pair(youngs_modulus_1=1.0, youngs_modulus_2=1.0, poisson_ratio_1=0.3, poisson_ratio_2=0.3)
    strip = FreeHalfSpace(pair, shape=(points,), pixel_size=(2.0 / points,), reference_distance=10.0)
    x = (np.arange(points) + 0.5) * 2.0 / points - 1.0
    modulus = 0.5 / (1.0 - 0.3**2)
    pressure = 0.5e-3 * modulus * np.sqrt(1.0 - x**2)  # p_0 = E* a/(2R) with a/R = 1e-3
    limits = 1e-3 * np.array([1.0, 1.0 / 0.7])
    xi = share * np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))]) * limits
    rolled = steady_rolling(
        strip,
        pressure,
        friction_coefficient=1.0,
        layer_compliance=0.0,
        longitudinal_creepage=xi[0],
        lateral_creepage=xi[1],
    )
    expected = np.abs(rolled.tangential_force) / (pressure.sum() * 2.0 / points)
    found = skewed_slip_ratios(
        longitudinal_creepage=xi[0],
        lateral_creepage=xi[1],
        gross_slip_creepage=limits[0],
        lateral_gross_slip_creepage=limits[1],
    )
    assert np.hypot(*(np.array(found) - expected)) < 0.006


def test_stick_zone_is_carters_under_the_length_of_the_traction():
    """Traction 0.3 and 0.4 of friction: half of friction in all, and a stick zone of the root of one half."""
    along, across = np.array([0.3, -0.64, 0.6, 0.0, 3.0]), np.array([-0.4, 0.0, 0.8, 0.0, 4.0])
    found = stick_fraction(longitudinal_slip_ratio=along, lateral_slip_ratio=across)
    np.testing.assert_allclose(found, [np.sqrt(0.5), 0.6, 0.0, 1.0, 0.0], rtol=1e-14)
    nearly = stick_fraction(longitudinal_slip_ratio=1.0 - 4e-12, lateral_slip_ratio=0.0)
    assert float(nearly) == pytest.approx(2e-6, rel=1e-3)


def independent_share(force, lateral):
    def excess(x):
        length = np.hypot(x, lateral)
        return (2 - length if length < 1 else 1 / length) * x - force

    return brentq(excess, 0.0, 1e9, xtol=1e-300, rtol=1e-14)


@pytest.mark.parametrize(
    ("force", "lateral"),
    [(0.5, 0.2), (0.9, 0.4), (0.05, 0.98), (0.999, 1e-6), (0.3, 1.5), (0.95, 0.6), (1e-9, 0.5), (0.99, 0.05)],
)
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_longitudinal_creepage_against_bisection(force, lateral):
    """Partial slip and, from |zeta| = 1 on, sliding: the creepage that carries the force."""
    found = skewed_contact(
        longitudinal_slip_ratio=jnp.array([force, -force]),
        lateral_creepage=lateral,
        gross_slip_creepage=1.0,
        lateral_gross_slip_creepage=1.0,
    )
    expected = independent_share(force, lateral)
    np.testing.assert_allclose(found.longitudinal_creepage, [expected, -expected], rtol=1e-9)
    assert bool(jnp.all(found.solved))


@pytest.mark.slow
def test_forces_come_back_everywhere():
    random = np.random.default_rng(3)
    lateral = np.concatenate([10 ** random.uniform(-12, 0.5, 3000), random.uniform(-2, 2, 3000)])
    force = np.concatenate([1 - 10 ** random.uniform(-9, 0, 3000), random.uniform(-1, 1, 3000)])
    unit = {"gross_slip_creepage": 1.0, "lateral_gross_slip_creepage": 1.0}
    found = skewed_contact(longitudinal_slip_ratio=force, lateral_creepage=lateral, **unit)
    along, across = skewed_slip_ratios(
        longitudinal_creepage=found.longitudinal_creepage, lateral_creepage=lateral, **unit
    )
    assert bool(jnp.all(found.solved))
    np.testing.assert_allclose(along, force, atol=1e-12)
    np.testing.assert_allclose(across, found.lateral_slip_ratio, atol=1e-9)
    assert float(jnp.max(found.slip_ratio)) <= 1.0 + 1e-12


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_no_creepage_carries_all_friction_lengthwise_with_skew():
    found = skewed_contact(
        longitudinal_slip_ratio=jnp.array([1.0, 1.3, -1.3]), lateral_creepage=1e-3, **LIMITS
    )
    assert not bool(jnp.any(found.solved))
    np.testing.assert_array_equal(found.longitudinal_creepage, [np.inf, np.inf, -np.inf])


def test_skew_takes_longitudinal_capacity():
    share = 0.6
    capacity = longitudinal_capacity_ratio(
        lateral_creepage=jnp.array([-share, 0.0, 1.0, 1.01, 2.0]),
        gross_slip_creepage=1.0,
        lateral_gross_slip_creepage=1.0,
    )
    np.testing.assert_allclose(capacity, [0.8, 1.0, 0.0, 0.0, 0.0], rtol=1e-14)
    unit = {"gross_slip_creepage": 1.0, "lateral_gross_slip_creepage": 1.0}
    below, beyond = (
        skewed_contact(longitudinal_slip_ratio=0.8 + d, lateral_creepage=share, **unit) for d in (-1e-9, 1e-9)
    )
    assert float(below.slip_ratio) < 1.0 + 1e-15
    assert float(beyond.slip_ratio) == pytest.approx(1.0, abs=1e-14)


def test_capacity_is_the_force_at_gross_slip():
    lateral = np.array([1e-4, 1e-3, 3e-3, 4.6e-3])
    along = 3.24e-3 * np.sqrt(1 - (lateral / 4.63e-3) ** 2)
    expected, _ = skewed_slip_ratios(longitudinal_creepage=along, lateral_creepage=lateral, **LIMITS)
    found = longitudinal_capacity_ratio(lateral_creepage=lateral, **LIMITS)
    np.testing.assert_allclose(found, expected, rtol=1e-9)


def test_derivatives_against_finite_differences():
    """Without force, without skew, with both of either sign, near gross slip, and sliding across."""
    force = np.array([0.0, 0.0, 0.5, 0.5, -0.5, 0.98, 0.2])
    skew = 1e-3 * np.array([0.0, 1.0, 0.0, 1.0, 1.0, 3.0, 5.0])

    def both(q, g):
        found = skewed_contact(longitudinal_slip_ratio=q, lateral_creepage=g, **LIMITS)
        return jnp.stack([found.longitudinal_creepage, found.lateral_slip_ratio])

    values, slopes = (jax.jit(jax.vmap(f)) for f in (both, jax.jacfwd(both, argnums=(0, 1))))
    by_force, by_skew = slopes(force, skew)
    step = 1e-6
    numeric = (values(force + step, skew) - values(force - step, skew)) / (2 * step)
    size = np.array([1e-3, 1.0])
    np.testing.assert_array_less(np.abs(by_force - numeric), 1e-5 * np.abs(numeric) + 1e-6 * size)
    numeric = (values(force, skew + 1e-3 * step) - values(force, skew - 1e-3 * step)) / (2e-3 * step)
    np.testing.assert_array_less(np.abs(by_skew - numeric), 1e-4 * np.abs(numeric) + 1e-3 * size)
