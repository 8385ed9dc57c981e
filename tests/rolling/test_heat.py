"""Steady temperatures: known losses, and the paper's joint in oil by an independent computation."""

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq
from traction_contacts import OILS

from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once
from asperity.joint.heat import heat_made
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.rolling.conditions import Lubricant
from asperity.rolling.heat import HeatFlow, heat_balance

EXAMPLES = Path(__file__).parents[2] / "examples"
FLOW = HeatFlow(ambient=25.0, resistance=3.0, roller_resistance=0.0, oil_limit=120.0)
#: The paper's joint in oil at 6000 rpm: oil, torque [N·m], K/W, °C, loss [W] and gain, by a computation of its own.
#: The joint carries the drag of its oil here, which that computation leaves out of its forces.
KNOWN = [
    ("S50", 5.0, 1.0, 48.2, 23.2, -0.68),
    ("S50", 5.0, 3.0, 67.6, 14.2, -0.91),
    ("S50", 5.0, 6.0, 86.4, 10.2, -1.68),
    ("M100", 2.5, 1.0, 57.7, None, None),
    ("M100", 2.5, 3.0, 81.3, None, None),
]


def balance(losses, flow=FLOW):
    """The balance of losses over the temperature of the rollers alone."""
    return at_once(lambda: heat_balance(flow, lambda _, housing, rollers: losses(rollers), ()))


def test_falling_losses_have_one_temperature():
    found = balance(lambda t: 10.0 * xp.exp(-0.01 * (t - 25.0)))
    root = brentq(lambda t: 25.0 + 30.0 * math.exp(-0.01 * (t - 25.0)) - t, 25.0, 120.0, xtol=1e-12)
    assert float(found.roller_temperature) == pytest.approx(root, abs=1e-7)
    assert float(found.gain) == pytest.approx(-0.01 * (root - 25.0), rel=1e-5)
    assert float(found.loss) == pytest.approx((root - 25.0) / 3.0, rel=1e-8)
    assert found.other_states() == []


def test_of_two_steady_temperatures_the_lower_one_is_stable():
    found = balance(lambda t: 5.0 + 0.004 * (t - 25.0) ** 2)
    low, high = np.roots([0.012, -1.0, 15.0])[::-1] + 25.0
    assert float(found.roller_temperature) == pytest.approx(low, abs=1e-9)
    assert float(found.gain) == pytest.approx(0.024 * (low - 25.0), rel=1e-7)
    ((other, stable),) = found.other_states()
    assert other == pytest.approx(high, abs=0.5)
    assert not stable
    # the vertex of the excess, 15 - 1/(4 * 0.012)
    assert float(found.ambient_reserve) == pytest.approx(0.25 / 0.012 - 15.0, rel=1e-6)


def test_reserve_is_what_warmer_surroundings_take():
    """Losses that touch what leaves: a steady temperature up to the reserve, none beyond it."""

    def lost(t):
        return 5.0 + 0.004 * (t - 25.0) ** 2

    reserve = float(balance(lost).ambient_reserve)
    for beyond in (1e-4, 0.3, 30.0):
        assert not bool(balance(lost, dataclasses.replace(FLOW, ambient=25.0 + reserve + beyond)).is_steady)
    for short in (0.01, 0.3, 5.0):
        assert bool(balance(lost, dataclasses.replace(FLOW, ambient=25.0 + reserve - short)).is_steady)


def test_no_steady_temperature_is_an_answer():
    found = balance(lambda t: 8.0 + 0.02 * (t - 25.0) ** 2)
    assert not bool(found.is_steady)
    assert float(found.roller_temperature) == float(found.housing_temperature) == 25.0
    assert math.isnan(float(found.loss))
    assert float(found.ambient_reserve) == pytest.approx(0.25 / 0.06 - 24.0, rel=1e-6)


def test_why_no_temperature_is_steady():
    """Losses that do not rise as fast as what leaves only need a hotter oil; others, or a slip, have no end."""
    assert balance(lambda t: 5.0 + 0.0 * t).unsteady_because == ""
    hot = balance(lambda t: 40.0 + 0.0 * t)
    assert hot.unsteady_because == "too hot: it would settle above 120 degC"
    assert balance(lambda t: 8.0 + 0.02 * (t - 25.0) ** 2).unsteady_because == "thermal runaway"
    slips = balance(lambda t: xp.where(t > 60.0, xp.nan, 40.0 + 0.0 * t))
    assert slips.unsteady_because == "thermal runaway"


def test_where_the_joint_does_not_roll_nothing_is_steady():
    """No state between 40 and 60 degC: a temperature beyond it is no start for one below."""
    found = balance(lambda t: xp.where((t > 30.0) & (t < 60.0), xp.nan, 5.0 + 0.0 * t))
    assert not bool(found.is_steady)
    found = balance(lambda t: xp.where(t > 60.0, xp.nan, 5.0 + 0.0 * t))
    assert float(found.roller_temperature) == pytest.approx(40.0, abs=1e-9)


def test_nothing_is_lost_where_the_input_stands():
    found = balance(lambda t: 0.0 * t)
    assert float(found.roller_temperature) == 25.0
    assert float(found.loss) == 0.0


def test_rollers_are_warmer_than_the_housing_by_their_resistance():
    found = balance(lambda t: 5.0 + 0.0 * t, dataclasses.replace(FLOW, roller_resistance=0.5))
    assert float(found.housing_temperature) == pytest.approx(40.0, abs=1e-9)
    assert float(found.roller_temperature) == pytest.approx(42.5, abs=1e-9)


def test_slopes_of_the_temperature():
    """By the implicit function, against a difference of two roots."""
    import jax

    def warm(ambient, power):
        flow = dataclasses.replace(FLOW, ambient=ambient, roller_resistance=0.5)
        found = heat_balance(flow, lambda numbers, _, t: numbers[0] * xp.exp(-0.01 * (t - 25.0)), (power,))
        return found.roller_temperature

    slopes = jax.jit(jax.grad(warm, argnums=(0, 1)))(25.0, 10.0)
    both = jax.jit(warm)
    for place, slope in enumerate(slopes):
        ends = [both(25.0 + (place == 0) * step, 10.0 + (place == 1) * step) for step in (-1e-2, 1e-2)]
        assert float(slope) == pytest.approx(float(ends[1] - ends[0]) / 2e-2, rel=1e-5)


@pytest.fixture(scope="module")
def wedge():
    """The paper's joint with surfaces of 0.2 µm at 6000 rpm."""
    text = (EXAMPLES / "zou2025.toml").read_text(encoding="utf-8")
    for line in ("fractal_dimension = 1.4", 'fractal_roughness = "1e-8 mm"', "frequency_ratio = 1.5"):
        assert line in text
        text = text.replace(line, 'rms_height = "0.2 um"' if "dimension" in line else "")
    return joint_from_case(parse_case(text, source="joint.toml"))


def warming(wedge, oil, torque):
    """Losses of the paper's joint in oil over the temperature of all of it."""
    fluid = OILS[oil]
    rolling = dataclasses.replace(
        wedge.rolling,
        lubricant=Lubricant(fluid, 300.0),
        viscosity=1.0,
        roughness=(0.2e-6,) * len(wedge.drive.contacts),
    )
    joint = as_numbers(
        dataclasses.replace(wedge, rolling=rolling, input_speed=200.0 * math.pi, output_torque=torque)
    )

    def losses(_numbers, _housing, rollers):
        return heat_made(dataclasses.replace(joint, rolling=rolling.with_oil_at(rollers + 273.15)))

    return losses


@pytest.mark.parametrize(("oil", "torque", "resistance", "temperature", "loss", "gain"), KNOWN)
def test_paper_joint_by_another_computation(wedge, oil, torque, resistance, temperature, loss, gain):
    flow = dataclasses.replace(FLOW, resistance=resistance)
    found = at_once(lambda: heat_balance(flow, warming(wedge, oil, torque), ()))
    assert float(found.roller_temperature) - 25.0 == pytest.approx(temperature - 25.0, rel=0.01)
    if loss is not None:
        assert float(found.loss) == pytest.approx(loss, rel=0.01)
        assert float(found.gain) == pytest.approx(gain, rel=0.03)


@pytest.mark.parametrize("resistance", [0.3, 1.0])
def test_paper_joint_runs_away_in_mineral_oil(wedge, resistance):
    flow = dataclasses.replace(FLOW, resistance=resistance)
    found = at_once(lambda: heat_balance(flow, warming(wedge, "M100", 5.0), ()))
    assert not bool(found.is_steady)
