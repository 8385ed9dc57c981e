"""Rows of the joint that turns: balances of speed, power and life."""

import math

import numpy as np
import pytest

from asperity.joint.solve import solve_joint
from asperity.results import RESULTS
from asperity.results.solved import SolvedJoint

INPUT = 6000.0 * math.pi / 30.0


def test_creep_from_sun_to_ring(value):
    # both loading rollers of a planet lose the same speed: the logarithms of the ratios of surface speeds add up
    lost = 2.0 * np.arctanh(0.5 * value("creepage"))
    assert lost[1] + lost[3] == pytest.approx(lost[2] + lost[4], rel=1e-9)
    np.testing.assert_allclose(
        value("traction_coefficient"),
        value("rolling_tangential_force") / value("rolling_normal_force"),
        rtol=1e-12,
    )
    np.testing.assert_allclose(
        value("rolling_slip_ratio"), np.abs(value("traction_coefficient")) / 0.12, rtol=1e-9
    )
    # Carter: the strip sticks over sqrt(1 - q) of its width
    np.testing.assert_allclose(value("stick_fraction"), np.sqrt(1.0 - value("rolling_slip_ratio")), rtol=1e-9)


def test_drift_is_the_speed_that_creep_takes(value):
    loss = value("speed_loss")
    speed = INPUT / 9.0 * (1.0 - loss)
    assert value("rolling_output_speed") == pytest.approx(speed, rel=1e-12)
    # in one turn of its own the output would have turned 1/(1 - loss) of it without creep
    assert value("drift") == pytest.approx(2.0 * math.pi * loss / (1.0 - loss), rel=1e-9)
    assert value("drift_rate") == pytest.approx(INPUT / 9.0 * loss, rel=1e-9)


def test_power(value):
    out, into = value("output_power"), value("input_power")
    assert out == pytest.approx(5.0 * value("rolling_output_speed"), rel=1e-12)
    assert value("efficiency") == pytest.approx(out / into, rel=1e-12)
    assert into - out == pytest.approx(value("total_loss"), rel=1e-9)
    assert np.sum(value("contact_loss")) + value("bearing_loss") == pytest.approx(
        value("total_loss"), rel=1e-9
    )
    # creep: force times slip speed; parallel axes, no hysteresis factor, no oil
    np.testing.assert_allclose(value("contact_loss"), value("creep_loss"), rtol=1e-12)
    for name in ("hysteresis_loss", "oil_loss", "flash_temperature", "film_thickness", "film_ratio"):
        assert np.all(np.isnan(value(name))), name
    for name in ("skew_loss", "axial_force", "axial_thrust", "capacity_loss"):
        np.testing.assert_array_equal(value(name), 0.0)


def test_the_papers_joint_is_above_shakedown_and_has_no_life(value):
    assert value("shakedown_ratio").max() > 1.0
    for name in ("drive_life", "life_turns"):
        assert np.isnan(value(name)), name


@pytest.fixture(scope="module")
def hard(paper_joint):
    """The paper's joint of a steel that stays elastic: its yield strength is almost three times as high."""
    joint = paper_joint(yield_strength=1.2e9)
    solved = SolvedJoint(joint, solve_joint(joint).result, None)
    return lambda name: np.asarray(RESULTS[name].of(solved), dtype=float)


def test_lives(hard):
    """Hours and turns by the output's speed; the drive fails by its weakest parts, Weibull's slope 10/9 or 9/8."""
    turns_per_second = hard("rolling_output_speed") / (2.0 * math.pi)
    for time, turns in (("drive_life", "life"), ("contact_life", "contact_life"), ("body_life", "body_life")):
        np.testing.assert_allclose(hard(f"{turns}_turns"), hard(time) * turns_per_second, rtol=1e-9)
    bodies = hard("body_life_turns")
    assert hard("life_turns") < bodies.min()
    assert hard("life_turns") > bodies.min() / bodies.size
    assert math.isnan(hard("duty_life"))
    assert math.isnan(hard("duty_life_turns"))
