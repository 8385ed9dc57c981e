"""Temperatures under a duty, against exponentials."""

import dataclasses
import math

import numpy as np
import pytest
from scipy.linalg import expm

from asperity.rolling.duty_heat import duty_heat
from asperity.rolling.heat import HeatFlow

FLOW = HeatFlow(20.0, 2.0, 0.0, 120.0, heat_capacity=300.0, duty_time=600.0)
ROLLERS = np.linspace(20.0, 120.0, 24)
SHARES = np.array([0.25, 0.75])


def constant(*powers):
    """Losses that do not depend on temperature, shape (loads, temperatures)."""
    return np.array(powers)[:, None] + 0.0 * ROLLERS


def test_temperatures_of_constant_losses():
    found = duty_heat(FLOW, ROLLERS, constant(30.0, 5.0), SHARES, 100.0)
    assert found.mean == pytest.approx(20.0 + 2.0 * (0.25 * 30.0 + 0.75 * 5.0), abs=1e-9)
    assert found.alone == pytest.approx((80.0, 30.0), abs=1e-9)


def test_peak_is_that_of_exponentials():
    """From the state that repeats towards the steady one of the first load, for a quarter of the time."""
    found = duty_heat(FLOW, ROLLERS, constant(30.0, 5.0), SHARES, 100.0)
    fall = np.exp(-SHARES * 600.0 / (2.0 * 400.0))
    hot, cold = 80.0, 30.0
    # start = cold + (peak - cold) fall[1], peak = hot + (start - hot) fall[0]
    peak = (hot * (1.0 - fall[0]) + cold * (1.0 - fall[1]) * fall[0]) / (1.0 - fall[0] * fall[1])
    assert found.peak == pytest.approx(peak, abs=1e-4)


def test_a_long_load_reaches_its_own_temperature():
    slow = dataclasses.replace(FLOW, duty_time=1e5)
    assert duty_heat(slow, ROLLERS, constant(30.0, 5.0), SHARES, 100.0).peak == pytest.approx(80.0, abs=1e-3)


def test_a_short_pass_has_the_mean():
    fast = dataclasses.replace(FLOW, duty_time=1.0)
    found = duty_heat(fast, ROLLERS, constant(30.0, 5.0), SHARES, 100.0)
    assert found.peak == pytest.approx(found.mean, abs=0.05)


def test_rollers_of_their_own():
    """Light rollers jump by the losses times their resistance, over a housing as of one node."""
    apart = dataclasses.replace(FLOW, roller_resistance=0.5, duty_time=1e5)
    found = duty_heat(apart, ROLLERS, constant(30.0, 5.0), SHARES, 1.0)
    assert found.alone == pytest.approx((20.0 + 2.5 * 30.0, 20.0 + 2.5 * 5.0), abs=1e-9)
    assert found.peak == pytest.approx(95.0, abs=1e-3)


def test_peak_of_rollers_over_their_housing():
    """Both balances of heat by exponentials of their matrix; the duty repeats from the state after it."""
    apart = dataclasses.replace(FLOW, roller_resistance=0.5)
    capacities, slope = np.array([100.0, 300.0]), -0.05
    rates = (
        np.array([[slope - 1.0 / 0.5, 1.0 / 0.5], [1.0 / 0.5, -1.0 / 0.5 - 1.0 / 2.0]]) / capacities[:, None]
    )
    powers = (30.0, 5.0)
    steady = [np.linalg.solve(rates, -np.array([power, 0.0]) / capacities) for power in powers]
    times = SHARES * 600.0
    one, two = (expm(rates * time) for time in times)
    # above the ambient: x1 = s1 + one (x0 - s1), x0 = s2 + two (x1 - s2)
    start = np.linalg.solve(
        np.eye(2) - two @ one, steady[1] - two @ steady[1] + two @ (steady[0] - one @ steady[0])
    )
    course = [
        steady[0] + expm(rates * time) @ (start - steady[0]) for time in np.linspace(0.0, times[0], 400)
    ]
    found = duty_heat(apart, ROLLERS, constant(*powers) + slope * (ROLLERS - 20.0), SHARES, 100.0)
    assert found.peak == pytest.approx(20.0 + max(state[0] for state in course), abs=1e-4)


def test_losses_that_rise_too_fast_have_no_temperature():
    losses = np.stack([5.0 + 0.6 * (ROLLERS - 20.0), 5.0 + 0.0 * ROLLERS])
    found = duty_heat(FLOW, ROLLERS, losses, SHARES, 100.0)
    assert math.isnan(found.alone[0])
    # mean: 5 + .15 (T - 20) = (T - 20)/2
    assert found.mean == pytest.approx(20.0 + 5.0 / 0.35, abs=1e-6)
    assert math.isfinite(found.peak)


def test_beyond_the_limit_of_the_oil():
    found = duty_heat(dataclasses.replace(FLOW, duty_time=1e5), ROLLERS, constant(60.0, 5.0), SHARES, 100.0)
    assert math.isnan(found.alone[0])
    assert math.isinf(found.peak)


@pytest.mark.parametrize("unknown", [{"duty_time": None}, {"heat_capacity": None}])
def test_no_peak_without_its_numbers(unknown):
    found = duty_heat(dataclasses.replace(FLOW, **unknown), ROLLERS, constant(30.0, 5.0), SHARES, 100.0)
    assert math.isnan(found.peak)
    assert math.isfinite(found.mean)
