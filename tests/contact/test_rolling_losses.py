"""Losses of a rolling contact against integrals of their own: pressure, Reynolds' equation."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from asperity.contact.rolling_losses import (
    creep_power,
    hysteresis_moment,
    inlet_rolling_force,
    inlet_rolling_power,
)

MODULUS, RADIUS, LENGTH, FORCE = 206e9 / (2 * (1 - 0.3**2)), 20e-3 / 3, 10e-3, 2000.0
WIDTH = math.sqrt(4 * FORCE / LENGTH * RADIUS / (math.pi * MODULUS))


def test_creep_power_of_two_steel_rollers():
    found = creep_power(tangential_force=100.0, creepage=5.3806e-4, rolling_speed=2.0)
    assert float(found) == pytest.approx(0.107612, rel=1e-12)


def test_hysteresis_is_a_share_of_the_work_on_the_front_half():
    """1 % lost, 1 m/s: 0.0780 W; the front half's pressure turns both rollers, V/R in all, about the middle."""
    found = float(hysteresis_moment(loss_factor=0.01, normal_force=FORCE, half_width=WIDTH))
    assert found * 1.0 / RADIUS == pytest.approx(0.0780, abs=5e-5)
    peak = 2 * FORCE / (math.pi * WIDTH * LENGTH)
    moment = quad(lambda x: peak * math.sqrt(1 - (x / WIDTH) ** 2) * x, 0, WIDTH)[0] * LENGTH
    assert found == pytest.approx(0.01 * moment, rel=1e-9)


def oil(**changes):
    arguments = {
        "viscosity": 0.0305,
        "entrainment_speed": 1.0,
        "line_load": FORCE / LENGTH,
        "effective_radius": RADIUS,
        "contact_modulus": MODULUS,
    }
    return float(inlet_rolling_force(**(arguments | changes)))


def test_inlet_force_of_two_steel_rollers():
    scale = 2 * MODULUS * RADIUS
    assert oil() == pytest.approx(1.47 * (2 * 0.0305 / scale) ** 0.75 * scale, rel=1e-3)
    assert oil(line_load=2 * FORCE / LENGTH) == pytest.approx(oil(), rel=1e-6)


def test_light_load_is_reynolds_equation_between_rigid_rollers():
    """Gap h0 (1 + X^2), eta constant, p = p' = 0 at the outlet: force, load and dissipation by quadrature.

    Dowson's 1.46 and the fit's 1.42 are for the 1.47 found here; the dissipation is twice the force times the speed.
    """

    def gap(x):
        return 1 + x * x

    def slope(x, out):
        return (gap(x) - gap(out)) / gap(x) ** 3

    outlet = brentq(lambda out: quad(slope, -np.inf, out, args=(out,))[0], 0.1, 1.0)
    load = -quad(lambda x: x * slope(x, outlet), -np.inf, outlet)[0]
    force = quad(lambda x: gap(x) / 2 * slope(x, outlet), -np.inf, outlet)[0]
    heat = quad(lambda x: gap(x) ** 3 * slope(x, outlet) ** 2 / 12, -np.inf, outlet)[0]
    # p' = 12 eta u /h0^2 slope, x = sqrt(2 R h0) X: line load 24 eta u R/h0 load, force 12 eta u sqrt(2 R/h0) force
    assert 24 * load == pytest.approx(4.896, rel=1e-3)  # Martin
    viscosity, speed, line_load = 0.0305, 0.7, 20.0
    thickness = 24 * viscosity * speed * RADIUS * load / line_load
    exact = 12 * viscosity * speed * math.sqrt(2 * RADIUS / thickness) * force
    assert oil(line_load=line_load, entrainment_speed=speed) == pytest.approx(exact, rel=0.04)
    # int h^3 p'^2/(12 eta) dx
    dissipated = 12 * 12 * viscosity * speed**2 * math.sqrt(2 * RADIUS / thickness) * heat
    power = inlet_rolling_power(rolling_force=exact, contact_length=1.0, entrainment_speed=speed)
    assert float(power) == pytest.approx(dissipated, rel=1e-6)
