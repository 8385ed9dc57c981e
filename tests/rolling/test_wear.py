"""Wear of a joint over its life: drift of worn radii, points in time, a cam, unlike lengths, and what is refused."""

import dataclasses

import numpy as np
import pytest
from tests.support.worn import EXAMPLES, check_case

from asperity.drive.layout.drive import speeds
from asperity.errors import InputError
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case
from asperity.rolling.wear import joint_wear, size_drift, track_names, wear_loads
from asperity.rolling.wear_rates import side_tracks


def wear_of(case, **options):
    joint = joint_from_case(case)
    return joint_wear(
        joint, np.ones(len(joint.drive.bodies)), **{"keeps_force": False, "with_capacity": False, **options}
    )


@pytest.fixture(scope="module")
def check():
    return wear_of(check_case(), also=0.5e-10, with_capacity=True)


def test_worn_radii_of_the_wedge_by_its_ratio():
    r""":math:`\Delta\omega_c/\omega_c = -(h_s/R_s + h_o/R_o) R_o/(R_o - R_s)`; planets and rollers drop out."""
    drive = joint_from_case(check_case()).drive
    sun, ring, other = 3.2e-9, 1.3e-9, 5e-9
    depth = np.array([[sun, other, other, other, other], [other, other, other, ring, ring]])
    ratio = -(sun / 4e-3 + ring / 40e-3) * 40.0 / 36.0
    assert size_drift(drive, depth) == pytest.approx(-2.0 * np.pi * ratio / (1.0 + ratio), rel=1e-5)
    # 3.2 µm of the sun: 19 arcmin a turn
    worn = size_drift(drive, np.array([[3.2e-6, 0.0, 0.0, 0.0, 0.0], 5 * [0.0]]))
    assert worn * 10800.0 / np.pi == pytest.approx(19.2, rel=0.01)
    assert np.isfinite(speeds(drive)).all()


def test_the_course(check):
    course = check.course
    assert np.all(np.diff(course.coefficient_time) > 0.0)
    for falling in (course.interference, course.preload):
        assert np.all(np.diff(falling) < 0.0)
    for rising in (course.drift, course.size_drift, *course.depth):
        assert np.all(np.diff(rising) > 0.0)
    for time in (0.5e-10, check.first_slide.coefficient_time, check.nothing_left.coefficient_time):
        assert np.any(np.isclose(course.coefficient_time, time, rtol=1e-12, atol=0.0))
    known = course.capacity[np.isfinite(course.capacity)]
    assert np.all(np.diff(known) < 0.0)
    assert course.depth.shape == (5, course.coefficient_time.size)


def test_the_end_is_where_the_capacity_is_the_torque(check):
    at = np.flatnonzero(
        np.isclose(check.course.coefficient_time, check.first_slide.coefficient_time, rtol=1e-12, atol=0.0)
    )
    known = np.isfinite(check.course.capacity)
    times, capacity = check.course.coefficient_time[known], check.course.capacity[known]
    assert np.interp(check.first_slide.coefficient_time, times, capacity) == pytest.approx(5.0, rel=0.02)
    assert check.course.interference[at[0]] == pytest.approx(check.first_slide.interference, rel=1e-6)


def test_depths_are_the_rates_over_time(check):
    """The first part of the course by the trapezoidal rule between its points, whose rates rise slowly."""
    course = check.course
    first = course.depth[:, 1] / course.coefficient_time[1]
    assert first == pytest.approx(check.now.depth_rate, rel=0.02)
    assert np.all(first > check.now.depth_rate)


def test_a_cam_keeps_its_force():
    """At 10 000 h and 1e-17 1/Pa an independent program has 10.18 µm of stroke."""
    joint = joint_from_case(check_case())
    still = joint_wear(joint, np.ones(5), keeps_force=True)
    assert (still.course, still.first_slide, still.nothing_left) == (None, None, None)
    assert still.now.interference_rate * 1e-17 * 3.6e7 * 1e6 == pytest.approx(10.18, rel=2e-3)


def test_tracks_of_every_body():
    drive = joint_from_case(read_case(EXAMPLES / "stepped_planet.toml")).drive
    names = track_names(drive)
    assert len(names) == len(set(names)) == 1 + max(max(side) for side in side_tracks(drive))
    assert {"planet_1", "planet_2"} <= set(names)


def test_contacts_of_unlike_lengths_make_a_step():
    lengths = '{ sp = "5 mm", pwr = "5 mm", pwl = "4 mm", wro = "5 mm", wlo = "5 mm" }'
    found = wear_of(check_case({'contact_length = "5 mm"': f"contact_length = {lengths}"}))
    assert found.unlike_lengths == ("planet", "left_loading_roller")


def test_a_load_that_stands_takes_its_share_and_nothing_wears():
    text = "".join(
        f'\n[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "{speed} rpm"\nshare = 0.5\n'
        for torque, speed in ((5.0, 6000), (9.0, 0))
    )
    case = check_case(more=text)
    assert wear_loads(joint_from_case(case)).share.tolist() == [0.5]
    half, whole = wear_of(case), wear_of(check_case())
    assert half.now.depth_rate == pytest.approx(0.5 * whole.now.depth_rate)
    assert half.first_slide.coefficient_time == pytest.approx(2.0 * whole.first_slide.coefficient_time)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            {'output_torque = "5 N*m"': 'output_torque = "12.5 N*m"'},
            "12.5 N·m the joint does not roll at the start",
        ),
        ({'output_torque = "5 N*m"': 'output_torque = "0 N*m"'}, "no contact slips, and nothing wears"),
        ({'sun_speed = "6000 rpm"': 'sun_speed = "0 rpm"'}, "the input stands"),
    ],
)
def test_what_is_refused(change, said):
    with pytest.raises(InputError, match=said):
        wear_of(check_case(change))


def test_coefficients_of_parts():
    """A sun that wears alone: nothing else gets deeper, and the time is that of its share in the interference."""
    joint = joint_from_case(check_case())
    alone = joint_wear(joint, np.array([1.0, 0.0, 0.0, 0.0, 0.0]), keeps_force=False, with_capacity=False)
    assert alone.course.depth[0, -1] > 0.0
    assert np.all(alone.course.depth[1:] == 0.0)
    assert np.all(np.isnan(alone.course.capacity))
    assert dataclasses.asdict(joint)["wear_coefficients"] is None
