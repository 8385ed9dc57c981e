"""Pressure, arc and compliance of a pin in a large plate: quadrature, sums of modes, elements, Hertz."""

import math

import jax
import numpy as np
import pytest
from pressed_pin import disc, hole, pressed_pin
from scipy.optimize import brentq

from asperity.body.conforming_pin import (
    SHARED,
    clearance_share,
    clearance_slopes,
    conforming_compliance,
    conforming_pressure,
    fitting_load,
    fitting_slopes,
    pressure_shares,
)

E, NU, R = 206e9, 0.3, 13e-3
PLANE = E / (1.0 - NU**2)


def arc_of(half_angle):
    return np.asarray(math.sin(0.5 * half_angle) ** 2)


def quadrature(half_angle, function, points=400):
    """Integral of the pressure times a function over the arc, its ends graded."""
    nodes, weights = np.polynomial.legendre.leggauss(points)
    angle = half_angle * np.sin(0.5 * math.pi * nodes)
    weights = weights * 0.5 * math.pi * half_angle * np.cos(0.5 * math.pi * nodes)
    pressure = np.asarray(conforming_pressure(angle=np.asarray(angle), arc=arc_of(half_angle)))
    return float(np.sum(weights * pressure * function(angle)))


@pytest.mark.parametrize("half_angle", [1e-3, 0.05, 0.3, 1.0, 1.48, 2.2, 3.0])
def test_shares_of_the_modes_by_quadrature(half_angle):
    shares = np.asarray(pressure_shares(arc=arc_of(half_angle)))
    assert quadrature(half_angle, np.cos) == pytest.approx(1.0, rel=1e-12)
    for mode in (0, 2, 3, 10, 80):
        found = shares[list(SHARED).index(mode)]
        assert found == pytest.approx(quadrature(half_angle, lambda a, n=mode: np.cos(n * a)), abs=1e-12)
    spread = quadrature(half_angle, lambda angle: 2.0 * np.sin(0.5 * angle) ** 2)
    assert float(clearance_share(arc=arc_of(half_angle))) == pytest.approx(spread, rel=1e-12)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_beyond_the_arc_nothing_presses():
    angles = np.array([-0.31, -0.29, 0.0, 0.29, 0.31, math.pi])
    pressure = np.asarray(conforming_pressure(angle=angles, arc=arc_of(0.3)))
    assert (pressure > 0.0).tolist() == [False, True, True, True, False, False]
    slope = jax.vmap(jax.grad(lambda a: conforming_pressure(angle=a, arc=arc_of(0.3))))(angles)
    assert np.all(np.isfinite(slope))


@pytest.mark.parametrize("half_angle", [0.2, 0.7, 1.5, 2.5])
def test_compliance_is_the_sum_of_the_modes_of_disc_and_hole(half_angle):
    """By quadrature up to the mode 80, and beyond it, where shares fall as n to the power -3/2, by those of Hertz."""
    arc, kolosov = arc_of(half_angle), 3.0 - 4.0 * NU
    w, modes = np.asarray(pressure_shares(arc=arc)), SHARED[1:]
    each = (hole(modes, kolosov) + disc(modes, kolosov)) * 4.0 / (kolosov + 1.0)
    total = (w[0] ** 2 + np.sum(each * w[1:] ** 2)) / math.pi
    rest = half_angle**-3 / 80.0**3 if half_angle < 2.0 else 1e-6  # bound of what is left out
    assert float(conforming_compliance(arc=arc)) == pytest.approx(total, abs=rest)


@pytest.mark.parametrize("half_angle", [0.01, 0.04, 0.4511, 1.0, 1.48, 2.2, 3.0])
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_the_arc_stores_the_least_energy(half_angle):
    """C' = -2 (cE'L/F) w_0' along all arcs: the closed form of the load is the condition of a minimum."""
    arc = arc_of(half_angle)
    by_arc = jax.grad(lambda a: conforming_compliance(arc=a))(arc)
    share, bend, third = clearance_slopes(arc)
    assert float(-0.5 * by_arc / share * arc) == pytest.approx(float(fitting_load(arc=arc)), rel=1e-9)
    for found, function in (
        (share, lambda a: clearance_share(arc=a)),
        (bend, lambda a: clearance_slopes(a)[0]),
        (third, lambda a: clearance_slopes(a)[1]),
        (fitting_slopes(arc)[0], lambda a: fitting_load(arc=a)),
        (fitting_slopes(arc)[1], lambda a: fitting_slopes(a)[0]),
    ):
        assert float(found) == pytest.approx(float(jax.grad(function)(arc)), rel=1e-8)


@pytest.mark.parametrize("clearance", [0.3e-6, 1e-6, 5e-6])
def test_elements_of_disc_and_plate_press_over_the_same_arc(clearance):
    """111 N on 10 mm of a steel pin of 26 mm: 33.5, 19.6 and 9.0 degrees; no closed form in the elements."""
    line_load, kolosov = 1000.0 / 9.0 / 10e-3, 3.0 - 4.0 * NU
    load = clearance * PLANE / line_load
    arc = brentq(lambda u: float(fitting_load(arc=np.asarray(u))) - load * u, 1e-9, 0.5)
    angle = 2.0 * math.asin(math.sqrt(arc))
    found = pressed_pin(
        walls=[1.0, 0.0],
        kolosov=kolosov,
        modulus=E / (2.0 * (1.0 + NU)),
        radius=R,
        clearance=clearance,
        line_load=line_load,
        span=1.4 * angle,
    )
    assert found.angle == pytest.approx(angle, rel=0.01)
    approach = line_load / PLANE * float(conforming_compliance(arc=np.asarray(arc)))
    approach += (
        line_load * 0.25 * (kolosov - 1.0) * 2.0 * (1.0 + NU) / (2.0 * math.pi * E)
    )  # mode 1 of the disc
    approach += clearance * float(clearance_share(arc=np.asarray(arc)))
    assert found.approach == pytest.approx(approach, rel=2e-3)
    inner = found.centres < 0.8 * angle
    pressure = (
        line_load / R * np.asarray(conforming_pressure(angle=np.asarray(found.centres), arc=np.asarray(arc)))
    )
    np.testing.assert_allclose(found.pressure[inner], pressure[inner], rtol=5e-3)


def test_without_clearance_the_arc_is_that_of_any_load():
    """84.83 degrees, Persson's and Ciavarella's 85."""
    arc = brentq(lambda u: float(fitting_load(arc=np.asarray(u))), 0.3, 0.6, xtol=1e-15)
    assert math.degrees(2.0 * math.asin(math.sqrt(arc))) == pytest.approx(84.828, abs=1e-3)


def test_a_wide_clearance_is_hertz():
    """Half-width b = sqrt(4 P R'/(pi E*)) with R' = R^2/c and E* = E'/2; pressure 2P/(pi b) in the middle."""
    clearance, line_load = 100e-6, 1e3
    half_width = math.sqrt(8.0 * line_load * R**2 / clearance / (math.pi * PLANE))
    arc = np.asarray(math.sin(0.5 * half_width / R) ** 2)
    assert float(fitting_load(arc=arc)) == pytest.approx(clearance * PLANE / line_load * float(arc), rel=1e-3)
    peak = float(conforming_pressure(angle=np.asarray(0.0), arc=arc)) * line_load / R
    assert peak == pytest.approx(2.0 * line_load / (math.pi * half_width), rel=1e-3)
