"""The creepage factor of a layer against boundary elements, a brush, and an independent table."""

import importlib.util
from pathlib import Path

import jax
import numpy as np
import pytest

from asperity.contact.creep_layer import (
    layer_ratio,
    pressure_layer_creepage_factor,
    small_slip_creepage_factor,
    table_nodes,
    uniform_layer_creepage_factor,
)

LAWS = {False: uniform_layer_creepage_factor, True: pressure_layer_creepage_factor}
EXAMPLE = Path(__file__).parents[2] / "examples" / "rolling_layer.py"


@pytest.fixture(scope="module")
def boundary_elements():
    spec = importlib.util.spec_from_file_location("rolling_layer", EXAMPLE)
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    return lambda **given: example.creepage_factor(**given, cells=(100, 200))


#: By an independent two-dimensional solver, 400 cells: chi, then the factor at q = 0.1, 0.25, 0.5, 0.8. Its own
# error of the creepage is 0.1 to 0.3 %.
UNIFORM = {
    0.01: (1.019, 1.017, 1.018, 1.022),
    0.1: (1.162, 1.155, 1.159, 1.187),
    0.2: (1.314, 1.302, 1.307, 1.360),
    1.0: (2.52, 2.48, 2.50, 2.72),
    10.0: (16.3, 16.0, 16.0, 18.0),
}
BY_PRESSURE = {0.2: (1.361, 1.308, 1.286, 1.349)}


@pytest.mark.parametrize(
    ("factor", "ratio", "expected"),
    [(uniform_layer_creepage_factor, *row) for row in UNIFORM.items()]
    + [(pressure_layer_creepage_factor, *row) for row in BY_PRESSURE.items()],
)
def test_factors_of_an_independent_solver(factor, ratio, expected):
    found = factor(layer_ratio=ratio, slip_ratio=np.array([0.1, 0.25, 0.5, 0.8]))
    np.testing.assert_allclose(found, expected, rtol=8e-3)


@pytest.mark.slow
@pytest.mark.parametrize("with_pressure", LAWS)
@pytest.mark.parametrize(("i", "j"), [(0, 0), (2, 3), (4, 5), (6, 8), (8, 10)])
def test_entries_of_the_table_recomputed(boundary_elements, with_pressure, i, j):
    ratios, slips = table_nodes((9, 15 if with_pressure else 11))
    given = {"layer_ratio": ratios[i], "slip_ratio": slips[j]}
    expected = boundary_elements(**given, with_pressure=with_pressure)
    assert float(LAWS[with_pressure](**given)) == pytest.approx(expected, rel=6e-3)


@pytest.mark.slow
@pytest.mark.parametrize("with_pressure", LAWS)
def test_between_the_entries_of_the_table(boundary_elements, with_pressure):
    rng = np.random.default_rng(5)
    for ratio, slip in zip(np.exp(rng.uniform(-5.0, 2.9, 8)), rng.uniform(0.03, 0.97, 8), strict=True):
        expected = boundary_elements(layer_ratio=ratio, slip_ratio=slip, with_pressure=with_pressure)
        found = float(LAWS[with_pressure](layer_ratio=ratio, slip_ratio=slip))
        assert found == pytest.approx(expected, rel=4e-3)


def brush_slip_ratio(k):
    """Force of traction k (1 - x) up to sqrt(1 - x^2), which it meets at x = (k^2 - 1)/(k^2 + 1), over mu N."""
    x = np.linspace(-1.0, 1.0, 400001)
    return np.trapezoid(np.minimum(k * (1.0 - x), np.sqrt(1.0 - x**2)), x) / (0.5 * np.pi)


@pytest.mark.parametrize("k", [0.05, 0.3, 1.0, 2.0])
def test_a_soft_layer_is_a_brush(k):
    """Creepage of gross slip 1, contact modulus 2, half-width 1: the brush creeps k chi."""
    q = brush_slip_ratio(k)
    closed = k / (1.0 - np.sqrt(1.0 - q))
    chi = 1e5
    assert float(uniform_layer_creepage_factor(layer_ratio=chi, slip_ratio=q)) / chi == pytest.approx(
        closed, rel=2e-3
    )


@pytest.mark.slow
@pytest.mark.parametrize("factor", LAWS.values())
def test_limits_signs_and_derivatives(factor):
    assert float(factor(layer_ratio=0.0, slip_ratio=0.4)) == 1.0
    assert float(factor(layer_ratio=0.3, slip_ratio=-0.4)) == float(factor(layer_ratio=0.3, slip_ratio=0.4))
    chi = np.geomspace(1e-4, 1e3, 57)
    assert np.all(np.diff(factor(layer_ratio=chi, slip_ratio=0.6)) > 0.0)
    for q in (0.0, 1e-3, 0.5, 0.99, 1.0, 2.0):
        for ratio in (0.0, 1e-6, 0.2, 500.0):
            slopes = jax.grad(lambda c, s: factor(layer_ratio=c, slip_ratio=s), argnums=(0, 1))(ratio, q)
            assert np.all(np.isfinite(slopes)), (ratio, q)
    assert float(jax.grad(lambda c: factor(layer_ratio=c, slip_ratio=0.3))(0.0)) > 0.5 * np.pi
    for q in (0.2, 0.7):
        slope = jax.grad(lambda s: factor(layer_ratio=0.5, slip_ratio=s))(q)
        ends = [float(factor(layer_ratio=0.5, slip_ratio=q + d)) for d in (-1e-5, 1e-5)]
        assert float(slope) == pytest.approx((ends[1] - ends[0]) / 2e-5, rel=1e-5)


def test_bodies_and_layer_in_series():
    """Errors of 1 + pi chi/2 that its documentation states."""
    chi, q = np.meshgrid(np.geomspace(0.005, 20.0, 41), np.linspace(0.02, 0.8, 40))
    simple = small_slip_creepage_factor(layer_ratio=chi)
    for factor, low, high in (
        (uniform_layer_creepage_factor, -0.08, 0.05),
        (pressure_layer_creepage_factor, -0.06, 0.195),
    ):
        error = simple / factor(layer_ratio=chi, slip_ratio=q) - 1.0
        assert low - 0.002 < error.min() < low + 0.01
        assert high - 0.01 < error.max() < high
    modest = q <= 0.5
    error = (simple / uniform_layer_creepage_factor(layer_ratio=chi, slip_ratio=q) - 1.0)[modest]
    assert error.min() > -0.0155
    assert error.max() < 0.05
    assert small_slip_creepage_factor(layer_ratio=0.2) == pytest.approx(1.3142, abs=1e-4)


def test_the_ratio_of_the_papers_sun_contact():
    """E* 1.1319e11 Pa, 5 mm, 2777 N/um: 0.20; the same as E* c/(2a) with c = 2aB/K_t."""
    found = layer_ratio(contact_modulus=1.1319e11, contact_length=5e-3, tangential_stiffness=2777e6)
    assert found == pytest.approx(0.2038, abs=1e-4)
    a = 1e-4
    assert found == pytest.approx(1.1319e11 * (2.0 * a * 5e-3 / 2777e6) / (2.0 * a), rel=1e-12)
