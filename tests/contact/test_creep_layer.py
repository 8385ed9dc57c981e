"""The factor of asperities on the creepage against boundary elements, an independent table, and limits."""

import math

import jax
import numpy as np
import pytest
from soft_asperities import soft_slip_ratio

from asperity.bem.rough_rolling import rough_pressure, rough_rolling
from asperity.contact import creep_layer
from asperity.contact.creep_layer import (
    layer_creepage_factor,
    layer_ratio,
    peak_pressure_factor,
    table_nodes,
    width_factor,
)

STEEL = 2.0 * 0.7 / 1.7  # tangential over normal stiffness of the asperities, 2(1 - nu)/(2 - nu)


def factor(s, q, stiffness_ratio=STEEL):
    return layer_creepage_factor(layer_ratio=s, slip_ratio=q, stiffness_ratio=stiffness_ratio)


def by_boundary_elements(s, slip_ratios, stiffness_ratio, strips):
    contact, state, found = rough_pressure(layer_ratio=s, strips=strips), None, []
    for q in slip_ratios:
        state = rough_rolling(contact, stiffness_ratio=stiffness_ratio, slip_ratio=q, start=state)
        found.append(state.creepage / (1.0 - math.sqrt(1.0 - q)))
    return contact.pressure.max(), np.array(found)


@pytest.mark.parametrize(
    ("s", "stiffness_ratio", "strips", "close"),
    [
        (0.15, STEEL, 160, 2e-3),
        (0.4, 0.7, 120, 2e-3),
        (2.2, 1.17, 120, 6e-3),
        (45.0, STEEL, 200, 6e-3),
        pytest.param(0.013, STEEL, 400, 2e-3, marks=pytest.mark.long),
        pytest.param(0.05, 0.95, 240, 2e-3, marks=pytest.mark.slow),
        pytest.param(400.0, 1.3, 160, 6e-3, marks=pytest.mark.slow),
    ],
)
def test_between_the_entries_of_the_table(s, stiffness_ratio, strips, close):
    q = np.array([0.05, 0.3, 0.62, 0.9, 0.99])
    peak, expected = by_boundary_elements(s, q, stiffness_ratio, strips)
    np.testing.assert_allclose(factor(s, q, stiffness_ratio), expected, rtol=close)
    assert float(peak_pressure_factor(layer_ratio=s)) == pytest.approx(peak, rel=1e-3)


@pytest.mark.parametrize("kappa", [0.5, 0.6, 1.43, 2.0])
def test_beyond_the_stiffness_ratios_of_the_table(kappa):
    """Surfaces with grooves, forces along them on soft bodies, across them and across the rolling direction."""
    q = np.array([0.05, 0.3, 0.62, 0.9])
    for s in (0.1, 2.0):
        _, expected = by_boundary_elements(s, q, kappa, 160)
        np.testing.assert_allclose(factor(s, q, kappa), expected, rtol=1.1e-2)


@pytest.mark.slow
@pytest.mark.parametrize(("i", "j", "k"), [(0, 4, 1), (4, 2, 0), (6, 7, 2), (7, 5, 1)])
def test_entries_of_the_table_recomputed(i, j, k):
    nodes = table_nodes(creep_layer._TABLE.shape)
    s, q, kappa = (float(values[place]) for values, place in zip(nodes, (i, j, k), strict=True))
    _, (expected,) = by_boundary_elements(s, [q], kappa, 240)
    assert 1.0 + s / math.sqrt(1.0 + s) * creep_layer._TABLE[i, j, k] == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("kappa", [0.7, STEEL, 1.3])
@pytest.mark.parametrize("k", [0.1, 0.5, 1.0, 2.0])
def test_asperities_much_softer_than_the_bodies(k, kappa):
    """Beyond the table: creepage k sqrt(s)/kappa of mu a/R, within what the documentation states."""
    q = soft_slip_ratio(k)
    for s in (1e4, 1e8):
        closed = k * math.sqrt(s) / kappa / (1.0 - math.sqrt(1.0 - q))
        assert float(factor(s, q, kappa)) == pytest.approx(closed, rel=0.05)
        peak = math.sqrt(math.pi / 8.0 / s)  # of Gauss's curve
        assert float(peak_pressure_factor(layer_ratio=s)) == pytest.approx(peak, rel=1e-3)


def test_limits_signs_and_derivatives():
    assert float(factor(0.0, 0.4)) == 1.0
    assert float(peak_pressure_factor(layer_ratio=0.0)) == pytest.approx(1.0, abs=1e-3)
    assert float(width_factor(layer_ratio=0.0)) == 1.0
    assert float(factor(0.3, -0.4)) == float(factor(0.3, 0.4))
    s = np.geomspace(1e-4, 1e5, 91)
    for q in (0.1, 0.6, 0.95):
        assert np.all(np.diff(factor(s, q)) > 0.0)
    assert np.all(np.diff(peak_pressure_factor(layer_ratio=s)) < 0.0)
    for q in (0.0, 1e-3, 0.5, 0.999, 1.0, 2.0):
        for ratio in (0.0, 1e-6, 0.2, 5e4):
            slopes = jax.grad(factor, argnums=(0, 1, 2))(ratio, q, STEEL)
            assert np.all(np.isfinite(slopes)), (ratio, q)
    for q in (0.2, 0.7):
        slope = jax.grad(factor, argnums=1)(0.5, q, STEEL)
        ends = [float(factor(0.5, q + d)) for d in (-1e-5, 1e-5)]
        assert float(slope) == pytest.approx((ends[1] - ends[0]) / 2e-5, rel=1e-5)


def test_ratio_of_the_papers_sun_contact():
    """u_0 R/a^2 with u_0 = N/K_n and Hertz's half-width: 0.112 at 1001 N."""
    force, stiffness, modulus, length = 1001.0, 3.958e9, 206e9 / 1.82, 5e-3
    radius = 4e-3 * 13.5e-3 / 17.5e-3
    width = math.sqrt(4.0 * force * radius / (math.pi * length * modulus))
    found = layer_ratio(contact_modulus=modulus, contact_length=length, normal_stiffness=stiffness)
    assert found == pytest.approx(force / stiffness * radius / width**2, rel=1e-12)
    assert found == pytest.approx(0.112, rel=5e-3)
