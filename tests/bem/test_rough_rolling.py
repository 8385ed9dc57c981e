"""Rolling of rough cylinders against an independent solver, closed forms at both ends, and Carter."""

import math

import numpy as np
import pytest
from soft_asperities import soft_slip_ratio

from asperity.bem.rough_rolling import RoughPressure, _Bundle, rough_pressure, rough_rolling

STEEL = 2.0 * 0.7 / 1.7  # tangential over normal stiffness, 2(1 - nu)/(2 - nu)
SLIP_RATIOS = (0.1, 0.25, 0.5, 0.8)

#: By an independent solver of 600 cells: layer ratio, peak pressure and root mean square half-width over Hertz's, and
# creepage over Carter's at the slip ratios above. Its own error is 0.2 %.
INDEPENDENT = [
    pytest.param(0.01, 0.990, 1.020, (1.014, 1.014, 1.015, 1.020), marks=pytest.mark.slow),
    (0.02, 0.980, 1.039, (1.027, 1.026, 1.028, 1.037)),
    (0.05, 0.952, 1.095, (1.059, 1.060, 1.065, 1.085)),
    (0.1, 0.907, 1.183, (1.110, 1.113, 1.125, 1.163)),
    (0.2, 0.830, 1.342, (1.205, 1.214, 1.237, 1.306)),
]


def carter(q):
    """Creepage over mu a/R; Johnson 1985, section 8.3."""
    return 1.0 - math.sqrt(1.0 - q)


def rolled(contact, slip_ratios, stiffness_ratio=STEEL):
    state, states = None, []
    for q in slip_ratios:
        state = rough_rolling(contact, stiffness_ratio=stiffness_ratio, slip_ratio=q, start=state)
        states.append(state)
    return states


def root_mean_square(contact):
    return math.sqrt(np.sum(contact.pressure * contact.position**2) / np.sum(contact.pressure))


@pytest.mark.parametrize(("layer_ratio", "peak", "width", "factors"), INDEPENDENT)
def test_an_independent_solver(layer_ratio, peak, width, factors):
    contact = rough_pressure(layer_ratio=layer_ratio, strips=160)
    assert contact.pressure.max() == pytest.approx(peak, abs=6e-4)
    assert 2.0 * root_mean_square(contact) == pytest.approx(width, abs=6e-4)
    found = [s.creepage / carter(q) for s, q in zip(rolled(contact, SLIP_RATIOS), SLIP_RATIOS, strict=True)]
    np.testing.assert_allclose(found, factors, rtol=4e-3)


@pytest.mark.parametrize("layer_ratio", [0.05, 0.5, 30.0])
def test_how_far_the_load_spreads(layer_ratio):
    """Balance, differentiated and times x p: the mean square of x is a^2/4 of Hertz's ellipse, and u_0 R."""
    contact = rough_pressure(layer_ratio=layer_ratio, strips=200)
    assert root_mean_square(contact) == pytest.approx(math.sqrt(0.25 + layer_ratio), rel=2e-4)
    width = contact.position[0] - contact.position[1]
    assert width * contact.pressure.sum() == pytest.approx(0.5 * math.pi, rel=1e-12)


@pytest.mark.parametrize("k", [0.2, 0.7, 1.5])
def test_soft_asperities_between_rigid_bodies(k):
    """Far from Hertz the bodies do not yield, and the pressure is a Gauss curve: creepage k sqrt(s)/kappa."""
    s, q = 1e5, soft_slip_ratio(k)
    contact = rough_pressure(layer_ratio=s, strips=160)
    assert contact.pressure.max() == pytest.approx(0.5 * math.pi / math.sqrt(2.0 * math.pi * s), rel=3e-3)
    found = rolled(contact, (0.5 * q, q))[-1]
    assert found.creepage == pytest.approx(k * math.sqrt(s) / STEEL, rel=6e-3)


@pytest.mark.slow
@pytest.mark.parametrize("q", [0.3, 0.7])
def test_little_roughness_is_carters(q):
    """Peaks and edges apart: mu p less a similar ellipse that begins at the leading edge; Johnson 1985, (8.29)."""
    contact = rough_pressure(layer_ratio=0.01, strips=200)
    found = rolled(contact, (0.5 * q, q))[-1]
    assert found.creepage == pytest.approx(carter(q), rel=0.03)
    stick = math.sqrt(1.0 - q)
    x = contact.position
    middle = np.maximum(1.0 - ((x - 1.0 + stick) / stick) ** 2, 0.0)
    closed = np.sqrt(np.maximum(1.0 - x**2, 0.0)) - stick * np.sqrt(middle)
    assert np.abs(found.traction - closed).mean() < 0.015


def test_force_and_friction():
    contact = rough_pressure(layer_ratio=0.15, strips=200)
    found = rolled(contact, (0.4, 0.8))[-1]
    width = contact.position[0] - contact.position[1]
    assert width * found.traction.sum() == pytest.approx(0.8 * 0.5 * math.pi, rel=1e-9)
    assert np.all(found.traction <= contact.pressure * (1.0 + 1e-12))
    assert np.all(found.traction >= 0.0)


def test_halving_the_strips_changes_little():
    factors = [
        rolled(rough_pressure(layer_ratio=0.1, strips=strips), (0.3, 0.6))[-1].creepage
        for strips in (80, 160)
    ]
    assert factors[0] == pytest.approx(factors[1], rel=2e-3)


def test_derivatives_of_the_springs():
    """Against finite differences, with groups that stick, slip, touch and part."""
    contact = rough_pressure(layer_ratio=0.2, strips=40)
    bundle = _Bundle(contact, STEEL)
    shift = 0.04 * (1.0 + 0.5 * np.sin(np.arange(40)))
    _, derivative = bundle.tractions(shift)
    step = 1e-7
    for k in range(1, 40, 3):
        change = step * (np.arange(40) == k)
        more, less = (bundle.tractions(shift + sign * change)[0] for sign in (1.0, -1.0))
        np.testing.assert_allclose(derivative[:, k], (more - less) / (2.0 * step), atol=1e-6)


def test_a_bundle_pressed_and_sheared_at_once_is_jaegers():
    """Without memory of leaving springs: constant slope dw/dd of all springs gives kappa dw/dd p up to mu p."""
    s = 0.3
    contact = RoughPressure(
        s, np.arange(8.0), np.exp([-3.0, -2.0, -1.0, 0.0, 0.0, -1.0, -2.0, -3.0]), np.eye(8)
    )
    bundle = _Bundle(contact, 0.8)
    shift = 0.5 * np.append(0.0, np.diff(bundle.depth)[:3])
    traction, _ = bundle.tractions(np.append(shift, np.zeros(4)))
    expected = 0.8 * 0.5 * (contact.pressure[:4] - contact.pressure[0])
    np.testing.assert_allclose(traction[:4], expected, rtol=1e-12, atol=1e-15)
