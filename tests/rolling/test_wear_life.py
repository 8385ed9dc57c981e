"""Life of a joint under wear as one function: against an independent program, and against the course of wear."""

import dataclasses

import numpy as np
import pytest
from tests.support.worn import EXAMPLES, check_case

from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.joint.solve import joint_state
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.reader import read_case
from asperity.rolling.wear import joint_wear
from asperity.rolling.wear_life import wear_life

DUTY = "".join(
    f'\n[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "6000 rpm"\nshare = {share}\n'
    for torque, share in ((8.0, 0.2), (4.0, 0.5), (1.5, 0.3))
)


def joint_of(case):
    """The joint of a case, a preload of it as the interference that makes it."""
    joint = as_numbers(with_own_branches(case))
    if joint.interference is None:
        joint = dataclasses.replace(joint, preload=None, interference=joint_state(joint).interference)
    return joint


def life_of(joint, asked=1e-11):
    return at_once(wear_life, joint, np.ones(len(joint.drive.bodies)), asked)


@pytest.mark.parametrize(
    ("torque", "more", "time"),
    [(2, "", 1.74347e-9), (5, "", 1.95500e-10), (8, "", 4.34089e-11), (5, DUTY, 1.38589e-10)],
)
def test_an_independent_program(torque, more, time):
    case = check_case({'output_torque = "5 N*m"': f'output_torque = "{torque} N*m"'}, more)
    assert life_of(joint_of(case)).time == pytest.approx(time, rel=5e-3)


def test_preload_over_the_time():
    """An independent program has 874.6, 737.9 and 582.8 N after quarters of 2.01376e-10 s/Pa."""
    joint = joint_of(check_case())
    for quarter, preload in ((1, 874.6), (2, 737.9), (3, 582.8)):
        assert life_of(joint, quarter * 0.25 * 2.01376e-10).preload == pytest.approx(preload, rel=2e-3)
    assert np.isnan(life_of(joint, 2.0e-10).preload)


#: Drives that feel one number, several ways to be pressed, oil, unlike branches, and crowns.
BRANCHES = "".join(f'\n[[branch]]\nplanet_deviation = "{size} um"\n' for size in (0.0, 0.5, -0.3))
CROWN = ('contact_length = "5 mm"', 'contact_length = "5 mm"\nplanet_crown_radius = "2000 mm"')


def cases():
    for name in ("multiroller", "planar", "wheel_pair"):
        yield pytest.param(lambda name=name: read_case(EXAMPLES / f"{name}.toml"), id=name)
    for name in ("stepped_planet", "oil"):
        yield pytest.param(
            lambda name=name: read_case(EXAMPLES / f"{name}.toml"), id=name, marks=pytest.mark.slow
        )
    yield pytest.param(lambda: check_case(more=BRANCHES), id="branches", marks=pytest.mark.slow)
    yield pytest.param(lambda: check_case(dict([CROWN])), id="crowns", marks=pytest.mark.slow)


@pytest.mark.parametrize("case", list(cases()))
def test_the_first_stage_of_the_course(case):
    joint = joint_of(case())
    bodies = np.ones(len(joint.drive.bodies))
    course = joint_wear(joint, bodies, keeps_force=False, with_capacity=False)
    end = course.ends[0].coefficient_time
    course = joint_wear(joint, bodies, keeps_force=False, with_capacity=False, also=0.5 * end)
    found = life_of(joint, 0.5 * end)
    assert found.time == pytest.approx(end, rel=2e-5)
    at = np.argmin(abs(course.course.coefficient_time - 0.5 * end))
    assert found.preload == pytest.approx(course.course.preload[at], rel=2e-5)


def test_a_joint_that_stands_or_slips():
    stands = life_of(joint_of(check_case({'sun_speed = "6000 rpm"': 'sun_speed = "0 rpm"'})))
    assert np.isnan(stands.time)
    slips = life_of(joint_of(check_case({'output_torque = "5 N*m"': 'output_torque = "12.5 N*m"'})))
    assert np.isnan(slips.time)
    assert np.isnan(slips.preload)
