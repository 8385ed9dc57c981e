"""The contact law against a table computed elsewhere, against quadrature of its definition, and by its properties."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from asperity.contact.asperity import (
    elastic_spot_load,
    normal_spot_stiffness,
    plastic_spot_load,
    tangential_spot_stiffness,
)
from asperity.contact.fractal import Surface, elastic_load_coefficient, fractal_contact, log_area_ratio
from asperity.contact.population import contact_factor, spot_density
from asperity.validation.contact_checks import contact_law

STEEL = {
    "contact_modulus": 206e9 / (2 * 0.91),
    "tangential_contact_modulus": 206e9 / 8.84,
    "hardness": 1260e6,
}
BASES = ("majumdar_bhushan_1991", "circular_spot")


def law(D, G, force, shear=0.0, mu=0.12, factor=1.0, base=BASES[0], **materials):
    return fractal_contact(
        surface=Surface(D, G, 1.5, base),
        normal_force=force,
        tangential_force=shear,
        friction_coefficient=mu,
        contact_factor=factor,
        **(STEEL | materials),
    )


compiled_law = jax.jit(law, static_argnames="base")


# Published and independently computed values


def test_reference_table_to_1e_10_in_every_column():
    checks = list(contact_law())
    assert len(checks) == 9
    for check in checks:
        assert check.values == 40, check.quantity
        assert check.deviation <= 1e-10, check.quantity
        assert not check.absolute  # a zero of the table must be an exact zero here


def test_tangential_stiffness_over_fractal_dimension_as_tabulated():
    # independent quadrature for R 10/20 mm, B = 5 mm, 1000 N, G = 1e-8 mm, lambda as printed, four digits, N/mm
    D = np.array([1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.85, 1.9, 1.95])
    expected = np.array([1.017e5, 3.904e6, 5.584e7, 4.135e8, 1.379e9, 2.537e9, 2.825e9, 2.650e9, 1.786e9])
    factor = contact_factor(
        model="printed",
        radius_1=10e-3,
        radius_2=20e-3,
        sign=1.0,
        contact_length=5e-3,
        contact_modulus=STEEL["contact_modulus"],
        normal_force=1000.0,
    )
    found = 1e-3 * compiled_law(D, 1e-11, 1000.0, factor=factor).tangential_stiffness
    np.testing.assert_allclose(found, expected, rtol=5.5e-4)
    assert D[int(jnp.argmax(found))] == 1.85  # the paper's peak


@pytest.mark.parametrize("base", BASES)
@pytest.mark.parametrize(("D", "G", "force"), [(1.4, 1e-11, 800.0), (1.5, 1e-10, 20.0), (1.75, 1e-12, 5.0)])
def test_outputs_are_integrals_of_one_asperity_over_the_population(base, D, G, force):
    """Equations (20), (24), (A6) by numerical integration of the formulas of a single spot."""
    mu, shear, factor = 0.12, 0.05 * force, 0.4
    found = compiled_law(D, G, force, shear, mu, factor, base=base)
    largest, critical = float(found.largest_area), float(found.critical_area)
    assert critical < largest

    def over_spots(value, lower, upper):
        """Gauss–Legendre in ln a, panel by panel; without a lower bound down to e^-250 a_l, where nothing is left."""
        start = math.log(lower / largest) if lower else -250.0
        edges = np.linspace(start, math.log(upper / largest), 41)
        half = np.diff(edges)[:, None] / 2
        nodes, weights = np.polynomial.legendre.leggauss(16)
        area = largest * np.exp(edges[:-1, None] + half * (nodes + 1.0)).clip(max=1.0)
        density = spot_density(
            spot_area=area, largest_area=largest, contact_factor=factor, fractal_dimension=D
        )
        return float(np.sum(value(area) * density * area * half * weights))

    surface = {"fractal_dimension": D, "fractal_roughness": G, "frequency_ratio": 1.5}
    moduli = {"contact_modulus": STEEL["contact_modulus"]}
    slip = (1.0 - shear / (mu * force)) ** (1.0 / 3.0)
    elastic = over_spots(
        lambda a: elastic_spot_load(spot_area=a, asperity_base=base, **surface, **moduli), critical, largest
    )
    plastic = over_spots(lambda a: plastic_spot_load(hardness=STEEL["hardness"], spot_area=a), 0.0, critical)
    assert elastic + plastic == pytest.approx(force, rel=1e-8)
    assert float(found.elastic_load) == pytest.approx(elastic, rel=1e-8)
    assert float(found.plastic_load) == pytest.approx(plastic, rel=1e-8)
    assert float(found.real_contact_area) == pytest.approx(over_spots(lambda a: a, 0.0, largest), rel=1e-8)
    tangential = over_spots(
        lambda a: tangential_spot_stiffness(
            spot_area=a,
            tangential_contact_modulus=STEEL["tangential_contact_modulus"],
            slip_factor=slip,
        ),
        critical,
        largest,
    )
    normal = over_spots(lambda a: normal_spot_stiffness(spot_area=a, **moduli), critical, largest)
    assert float(found.tangential_stiffness) == pytest.approx(tangential, rel=1e-8)
    assert float(found.normal_stiffness) == pytest.approx(normal, rel=1e-8)


def test_elastic_load_coefficient_is_published_value():
    kappa = elastic_load_coefficient(fractal_dimension=1.4, frequency_ratio=1.5, asperity_base=BASES[0])
    assert float(kappa) == pytest.approx(2 * math.sqrt(math.pi) / 3 * math.sqrt(math.log(1.5)), rel=1e-15)
    circular = elastic_load_coefficient(fractal_dimension=1.4, frequency_ratio=1.5, asperity_base=BASES[1])
    assert float(circular / kappa) == pytest.approx((math.pi / 4) ** 0.7, rel=1e-14)


# The universal load law: root, first and second derivatives


def load_ratio(y, D, kappa):
    """The branch y >= 0 of (A5) in plain Python, the power law integrated by hand."""
    p = 1.5 - D
    rise = y if p == 0 else math.expm1(p * y) / p
    return D * y / 2 + math.log1p(kappa * (1 - D / 2) * rise)


def test_load_law_is_solved_to_rounding_up_to_e_200():
    rng = np.random.default_rng(1)
    D = np.append(rng.uniform(1.02, 1.99, 40), [1.5, 1.5 + 1e-12, 1.5 - 1e-9, 1.5 + 1e-4, 1.02, 1.99])
    u = np.exp(rng.uniform(math.log(1e-6), math.log(200.0), D.size))
    found = log_area_ratio(log_load_ratio=u, fractal_dimension=D, elastic_load_coefficient=0.75)
    for ratio, dimension, y in zip(u, D, np.asarray(found), strict=True):
        root = brentq(
            lambda v, r=ratio, d=dimension: load_ratio(v, d, 0.75) - r, 0.0, 500.0, xtol=1e-30, rtol=1e-15
        )
        assert y == pytest.approx(root, rel=2e-14, abs=1e-15)


def test_load_law_is_a_straight_line_below_the_critical_load():
    u = np.array([-300.0, -1.0, -1e-12, 0.0])
    found = log_area_ratio(log_load_ratio=u, fractal_dimension=1.4, elastic_load_coefficient=0.75)
    np.testing.assert_array_equal(found, u)


def test_first_and_second_derivative_of_the_load_law():
    """dy/du = 1/f' and d2y/du2 = -f''/f'^3 with f' and f'' differentiated by hand."""
    kappa, u = 0.75, 7.0

    def solved(u, D):
        return log_area_ratio(log_load_ratio=u, fractal_dimension=D, elastic_load_coefficient=kappa)

    dimensions = np.array([1.02, 1.2, 1.5 - 1e-7, 1.5, 1.5 + 1e-3, 1.8, 1.99])
    first = jax.grad(solved)
    along = jax.jit(jax.vmap(lambda D: (solved(u, D), first(u, D), jax.grad(first)(u, D))))
    for D, y, slope, bend in zip(dimensions, *map(np.asarray, along(dimensions)), strict=True):
        p, w = 1.5 - D, kappa * (1 - D / 2)
        total = 1 + w * (y if p == 0 else math.expm1(p * y) / p)
        growth = w * math.exp(p * y) / total
        steepness = D / 2 + growth
        assert slope == pytest.approx(1 / steepness, rel=1e-12)
        assert bend == pytest.approx(-growth * (p - growth) / steepness**3, rel=1e-9, abs=1e-15)


# Regimes: everything finite, everywhere


def values_of(D, G, force, shear, mu, factor, modulus, shear_modulus, hardness):
    found = law(
        D,
        G,
        force,
        shear,
        mu,
        factor,
        contact_modulus=modulus,
        tangential_contact_modulus=shear_modulus,
        hardness=hardness,
    )
    return jnp.stack(jnp.broadcast_arrays(*jax.tree.leaves(found)))


INPUTS = ("D", "G", "F", "T", "mu", "lambda", "E", "G*", "H")
STIFFNESS = 5  # row of K_t in values_of
NEAR_SLIP = 1.0 - 1e-12
BORDERS = [  # D, G, F, T/(mu F): elastic, all plastic, D = 1.5, near 1.5, near slip, slipping
    (1.4, 1e-11, 800.0, 0.3),
    (1.3, 1e-11, 1.0, 0.3),
    (1.3, 1e-8, 2.0, 0.0),
    (1.5, 1e-10, 50.0, 0.2),
    (1.5 + 1e-3, 1e-10, 50.0, 0.2),
    (1.9, 1e-12, 3.0, 0.99),
    (1.7, 1e-12, 30.0, 1.2),
]


def domain():
    """The whole domain the product promises, its corners and borders, with stick, slip and no shear."""
    rng = np.random.default_rng(7)
    n = 4000
    D = rng.uniform(1.02, 1.99, n)
    D[:600] = rng.choice([1.02, 1.5, 1.5 + 1e-9, 1.5 - 1e-5, 1.99], 600)
    G = 10.0 ** rng.uniform(-16, -6, n)
    G[300:900] = rng.choice([1e-16, 1e-6], 600)
    force = 10.0 ** rng.uniform(-3, 6, n)
    force[600:1500] = rng.choice([1e-3, 1e6], 900)
    share = rng.choice([0.0, 0.3, NEAR_SLIP, 1.0, 1.0 + 1e-9, 5.0], n)
    point = np.stack([D, G, force, share])
    point[:, : len(BORDERS)] = np.transpose(BORDERS)
    return point


def arguments(point):
    D, G, force, share = point
    rest = (0.12, 0.3, STEEL["contact_modulus"], STEEL["tangential_contact_modulus"], STEEL["hardness"])
    return [np.broadcast_to(x, D.shape).copy() for x in (D, G, force, share * 0.12 * force, *rest)]


@pytest.fixture(scope="module")
def values_and_slopes():
    return jax.jit(jax.vmap(lambda *x: (values_of(*x), jax.jacfwd(values_of, range(9))(*x))))


@pytest.mark.slow
def test_values_and_gradients_are_finite_over_the_whole_domain(values_and_slopes):
    point = domain()
    values, slopes = values_and_slopes(*arguments(point))
    assert bool(jnp.all(jnp.isfinite(values)))
    assert bool(jnp.all(values >= 0.0))
    for name, slope in zip(INPUTS, slopes, strict=True):
        assert bool(jnp.all(jnp.isfinite(slope))), name
    stiffness = jax.grad(lambda *x: values_of(*x)[STIFFNESS], range(9))
    start = arguments(point)
    backward = jax.jit(jax.vmap(stiffness))(*start)
    clear = np.abs(point[3] - 1.0) > 0.1  # where 1 - T/(mu F) keeps its digits
    for name, x, reverse, slope in zip(INPUTS, start, backward, slopes, strict=True):
        assert bool(jnp.all(jnp.isfinite(reverse))), name
        forward = slope[:, STIFFNESS]
        natural = values[:, STIFFNESS] / np.where(x == 0.0, 1.0, x)  # where the terms of a slope cancel
        error = jnp.abs(reverse - forward) - 1e-8 * jnp.abs(forward) - 1e-13 * natural
        assert bool(jnp.all(error[clear] <= 0.0)), name


@pytest.mark.slow
def test_gradients_agree_with_finite_differences_on_both_sides_of_every_border(values_and_slopes):
    start = arguments(domain())
    values, slopes = values_and_slopes(*start)
    n = len(BORDERS)
    plastic = np.asarray(values[:n, 0] < values[:n, 1])
    assert plastic.any()
    assert not plastic.all()
    for index, name in enumerate(INPUTS):
        h = 1e-5 * np.where(start[index] == 0.0, 1.0, start[index])

        def moved(steps, index=index, h=h):
            there = [x + steps * h if i == index else x for i, x in enumerate(start)]
            return np.asarray(values_and_slopes(*there)[0])

        size = h[:, None]
        difference = (8.0 * (moved(1) - moved(-1)) - (moved(2) - moved(-2))) / (12.0 * size)
        error = np.abs(np.asarray(slopes[index]) - difference)
        allowed = 3e-8 * np.abs(slopes[index]) + 1e-13 * np.abs(values) / size
        assert (error <= allowed)[:n].all(), (name, np.argwhere(error[:n] > allowed[:n]))


def test_no_stiffness_without_elastic_spots_without_stick_and_without_contact():
    plastic = compiled_law(1.3, 1e-8, 1.0)
    assert float(plastic.tangential_stiffness) == float(plastic.normal_stiffness) == 0.0
    assert float(plastic.plastic_load) == 1.0
    for shear in (120.0, 121.0, 1e9):
        slipping = compiled_law(1.4, 1e-11, 1000.0, shear)
        assert float(slipping.tangential_stiffness) == 0.0
        assert float(slipping.normal_stiffness) > 0.0
    for force in (0.0, -5.0):
        lifted = compiled_law(1.4, 1e-11, force)
        for name in ("largest_area", "real_contact_area", "elastic_load", "plastic_load", "normal_stiffness"):
            assert float(getattr(lifted, name)) == 0.0, name


# Properties

dimensions = st.one_of(st.just(1.5), st.floats(1.02, 1.99))
roughnesses = st.floats(-16.0, -6.0).map(lambda e: 10.0**e)
loads = st.floats(-3.0, 6.0).map(lambda e: 10.0**e)
property_test = settings(max_examples=60, deadline=None)


@property_test
@given(dimensions, roughnesses, loads, st.floats(0.0, 1.2), st.floats(-3.0, 3.0).map(lambda e: 10.0**e))
def test_lengths_scaled_and_forces_by_the_square(D, G, force, share, s):
    """Continuum mechanics has no length of its own: with lambda fixed, areas go with s^2, stiffnesses with s."""
    small = compiled_law(D, G, force, share * 0.12 * force)
    large = compiled_law(D, G * s, force * s * s, share * 0.12 * force * s * s)
    for name, power in (
        ("largest_area", 2),
        ("critical_area", 2),
        ("real_contact_area", 2),
        ("plastic_load", 2),
        ("normal_stiffness", 1),
    ):
        a, b = float(getattr(small, name)), float(getattr(large, name))
        assert b == pytest.approx(a * s**power, rel=1e-9, abs=1e-9 * force * s * s * (name == "plastic_load"))


@property_test
@given(dimensions, roughnesses, loads, st.floats(1e-3, 1.0), st.floats(-9.0, 9.0).map(lambda e: 10.0**e))
def test_forces_and_moduli_in_another_unit(D, G, force, factor, unit):
    """Newton or kilonewton: areas stay, forces and stiffnesses follow."""
    here = compiled_law(D, G, force, factor=factor)
    there = compiled_law(D, G, force * unit, factor=factor, **{k: v * unit for k, v in STEEL.items()})
    assert float(there.largest_area) == pytest.approx(float(here.largest_area), rel=1e-9, abs=0.0)
    assert float(there.normal_stiffness) == pytest.approx(
        unit * float(here.normal_stiffness), rel=1e-9, abs=0
    )


@property_test
@given(dimensions, roughnesses, loads, st.floats(1.001, 100.0), st.sampled_from(BASES))
def test_more_load_more_area_and_stiffness(D, G, force, growth, base):
    less, more = compiled_law(D, G, force, base=base), compiled_law(D, G, force * growth, base=base)
    assert float(more.largest_area) > float(less.largest_area)
    assert float(more.real_contact_area) > float(less.real_contact_area)
    assert float(more.tangential_stiffness) >= float(less.tangential_stiffness)
    assert float(less.elastic_load + less.plastic_load) == pytest.approx(force, rel=1e-14)


@property_test
@given(dimensions, roughnesses, loads, st.floats(0.0, 0.99), st.floats(1.001, 3.0))
def test_more_shear_less_stiffness_and_more_roughness_more_plastic(D, G, force, share, growth):
    free = compiled_law(D, G, force, share * 0.12 * force)
    sheared = compiled_law(D, G, force, share * growth * 0.12 * force)
    rough = compiled_law(D, G * growth, force)
    assert float(sheared.tangential_stiffness) <= float(free.tangential_stiffness)
    assert float(sheared.normal_stiffness) == float(free.normal_stiffness)
    assert float(rough.plastic_load) >= float(free.plastic_load) * (1 - 1e-12)
