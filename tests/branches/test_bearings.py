"""Bearings between unlike branches: by hand, and equal ones as in the joint without branches."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.branches.bearings import branch_bearing_lives, with_duty
from asperity.drive.structure.bearing_life import RatedBearing
from asperity.errors import InputError
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solved_case
from asperity.rolling.conditions import DutyPoint

PIN = RatedBearing(1500.0, 1200.0, 2.0, 0.0, "roller")
HELD = RatedBearing(5000.0, 3000.0, 1.0, 400.0, "ball")
HOUR = 3600.0


@pytest.fixture(scope="module")
def rated(paper_joint):
    return dataclasses.replace(paper_joint(), pin_bearing=PIN, input_bearing=HELD, output_bearing=HELD)


@pytest.fixture
def loaded(unequal_branches):
    """100 and 60 N at most on the pins, 250 N on the sun and 50 N on the carrier, which turn by the minute."""
    pins = np.array([[[0.0, 60.0, 0.0], [0.0, 0.0, 0.0]], [[50.0, 80.0, 0.0], [60.0, 10.0, 0.0]]])
    state = dataclasses.replace(
        unequal_branches().standing,
        pins=pins,
        centre_forces={"carrier": np.array([30.0, -40.0])},
        bearing_speed=np.array([300.0, 300.0, 600.0, 60.0]) * 2.0 * math.pi / 60.0,
    )
    return lambda **changes: unequal_branches(
        **{"rest": state, "standing": state, "rolling": state} | changes
    )


def life(rating, load, exponent, turns_a_minute):
    return 1e6 * (rating / load) ** exponent / (60.0 * turns_a_minute)


def test_lives_by_hand(rated, loaded):
    found = branch_bearing_lives(rated, loaded())
    assert np.asarray(found.load) == pytest.approx([50.0, 30.0, 650.0, 450.0])
    expected = [
        life(1500.0, 50.0, 10.0 / 3.0, 300.0),
        life(1500.0, 30.0, 10.0 / 3.0, 300.0),
        life(5000.0, 650.0, 3.0, 600.0),
        life(5000.0, 450.0, 3.0, 60.0),
    ]
    assert np.asarray(found.life) / HOUR == pytest.approx(expected)
    assert np.asarray(found.static_safety) == pytest.approx([24.0, 40.0, 3000.0 / 650.0, 3000.0 / 450.0])
    assert np.asarray(found.load_ratio) == pytest.approx([1.0 / 30.0, 0.02, 0.13, 0.09])
    assert np.all(np.isnan(np.asarray(found.duty_life)))


def test_a_load_without_a_state_is_unknown(rated, loaded):
    found = branch_bearing_lives(rated, loaded(rolling=None))
    assert np.all(np.isnan(np.asarray(found.load)))
    assert np.all(np.isnan(np.asarray(found.life)))


def test_a_duty_adds_up_by_miners_sum(rated, loaded):
    points = (DutyPoint(5.0, 1.0, 0.25), DutyPoint(2.0, 1.0, 0.75))
    joint = dataclasses.replace(rated, rolling=dataclasses.replace(rated.rolling, duty=points))
    one = loaded()
    half = dataclasses.replace(one.rolling, sun_force=one.rolling.sun_force / 2.0)
    found = branch_bearing_lives(joint, dataclasses.replace(one, duty=(one.rolling, half)))
    lives = [life(5000.0, 650.0, 3.0, 600.0), life(5000.0, 525.0, 3.0, 600.0)]
    expected = 1.0 / (0.25 / lives[0] + 0.75 / lives[1])
    assert float(found.duty_life[2]) / HOUR == pytest.approx(expected)
    unknown = branch_bearing_lives(joint, dataclasses.replace(one, duty=(one.rolling, None)))
    assert np.all(np.isnan(np.asarray(unknown.duty_life)))
    assert float(unknown.life[2]) == pytest.approx(float(found.life[2]))


def test_states_under_a_duty_or_none_where_they_are_refused(rated, loaded):
    points = (DutyPoint(5.0, 1.0, 0.25), DutyPoint(99.0, 2.0, 0.75))
    joint = dataclasses.replace(rated, rolling=dataclasses.replace(rated.rolling, duty=points))
    state = loaded().rolling

    def working(there):
        assert not there.rolling.duty
        if there.output_torque > 50.0:
            raise InputError("beyond")
        assert (there.output_torque, there.sun_speed) == (5.0, 1.0)
        return state

    assert with_duty(loaded(), joint, working).duty == (state, None)


@pytest.fixture(scope="module")
def of_file(joint_text):
    """The paper's joint with bearings, loads of a duty, and sizes of its planets."""

    def found(sizes, loads=()):
        text = joint_text.replace('preload = "1000 N"', 'interference = "12.904 um"')
        for name in ("sun", "carrier"):
            text += f'[{name}_bearing]\ntype = "ball"\ndynamic_rating = "5000 N"\n'
            text += 'static_rating = "3000 N"\noutside_force = "400 N"\n\n'
        text += '[pin_bearing]\ntype = "roller"\ndynamic_rating = "1500 N"\n'
        text += 'static_rating = "1200 N"\ncount = 2\n\n'
        for load in loads:
            text += f'[[duty]]\nshare = 0.5\noutput_torque = "{load} N*m"\nsun_speed = "6000 rpm"\n\n'
        text += "".join(f'[[branch]]\nplanet_deviation = "{size} um"\n\n' for size in sizes)
        return solved_case(parse_case(text, source="x"))

    return found


@pytest.mark.long
def test_equal_branches_are_the_joint_without_them(of_file):
    expected, found = of_file([]).bearings, of_file([0.0] * 3).bearings
    for name in ("load", "life", "static_safety", "load_ratio"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), rtol=2e-6)


@pytest.mark.slow
def test_the_force_of_the_branches_shortens_the_life_of_the_bearings_of_the_sun(of_file):
    """One planet 1 um too large, one too small: hundreds of newtons, as in the table of loads."""
    solved = of_file([1.0, 0.0, -1.0], (5.0, 13.9))
    found, before = solved.bearings, of_file([]).bearings
    load = 400.0 + math.hypot(*solved.branches.rolling.sun_force)
    assert load > 600.0
    assert float(found.load[2]) == pytest.approx(load)
    assert float(before.life[2]) / float(found.life[2]) == pytest.approx((load / 400.0) ** 3)
    # 13.9 N*m is more than these branches pass
    assert solved.branches.duty[0] is not None
    assert solved.branches.duty[1] is None
    assert np.all(np.isnan(np.asarray(found.duty_life)))
