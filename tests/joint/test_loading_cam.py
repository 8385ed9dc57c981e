"""A planar joint with a loading cam against joints without one, and the work that turns it."""

import dataclasses

import numpy as np
import pytest

from asperity.drive.stiffness.loading_cam import LoadingCam
from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.joint.torque_limits import LIMIT_KINDS, capacity_document
from asperity.rolling.conditions import DutyPoint
from asperity.standing.over_torque import over_torque
from asperity.standing.springs_over_torque import springs_over_torque
from asperity.standing.windup import windup

CAM = 150.0
AS_SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'ring_support = "free"': 'ring_support = "rigid_housing"',
}
STATES = ("normal", "tangential")


def with_cam(joint, force_per_torque=CAM):
    return dataclasses.replace(joint, cam=LoadingCam(force_per_torque, joint.pattern))


def under_torque(joint, torque):
    return dataclasses.replace(joint, output_torque=torque)


def by_force(joint, preload):
    return dataclasses.replace(joint, preload=preload, interference=None, cam=None)


def like(found, expected, rel):
    """Whether two joints have the same forces, contacts, stiffness with the cam held, and rolling."""
    for name in ("rest", "forces", "rolling"):
        one, other = ((each.pressed if name == "rest" else getattr(each, name)) for each in (found, expected))
        for field in STATES:
            np.testing.assert_allclose(getattr(one, field), getattr(other, field), rtol=rel, atol=1e-9)
    np.testing.assert_allclose(
        found.contacts.tangential_stiffness, expected.contacts.tangential_stiffness, rtol=rel
    )
    assert float(found.interference) == pytest.approx(float(expected.interference), rel=rel)
    for name in ("drift_per_output_turn", "speed_loss"):
        one, other = (float(getattr(each.rolling, name)) for each in (found, expected))
        assert one == pytest.approx(other, rel=rel)
    assert float(found.rolling.life_hours.drive) == pytest.approx(
        float(expected.rolling.life_hours.drive), rel=rel
    )
    held = found.assembly.stiffness.output / (1.0 - found.assembly.loading_cam_share)
    assert float(held) == pytest.approx(float(expected.assembly.stiffness.output), rel=rel)


@pytest.fixture(scope="module")
def plain(planar_joint):
    """The planetary example with springs as bodies, 30 µm of interference and no cam."""
    return planar_joint("planetary", AS_SPRINGS)


@pytest.fixture(scope="module")
def least(plain):
    """Preload of the file's interference, found again from it."""
    preload = float(solve_joint(with_cam(plain)).result.rest.normal[0])
    alike = solve_joint(by_force(plain, preload)).result
    assert float(alike.interference) == pytest.approx(plain.interference, rel=1e-9)
    return preload


@pytest.mark.long
def test_a_cam_without_force_changes_nothing(plain):
    found, expected = solve_joint(with_cam(plain, 0.0)), solve_joint(plain)
    like(found.result, expected.result, 1e-9)
    assert float(found.result.cam_angle) == 0.0
    assert float(found.result.assembly.loading_cam_share) == 0.0
    for name in (
        "standing_capacity",
        "reverse_standing_capacity",
        "rolling_capacity",
        "reverse_rolling_capacity",
    ):
        one, other = (float(getattr(each, name).output_torque) for each in (found, expected))
        assert one == pytest.approx(other, rel=1e-8)


@pytest.mark.long
@pytest.mark.parametrize("torque", [10.0, -40.0])
def test_at_a_torque_it_is_the_drive_with_the_preload_of_that_torque(plain, least, torque):
    found = solve_joint(under_torque(with_cam(plain), torque))
    preload = least + CAM * abs(torque)
    like(found.result, solve_joint(under_torque(by_force(plain, preload), torque)).result, 1e-9)
    assert float(found.result.preload) == pytest.approx(preload, rel=1e-12)
    assert float(found.result.rest.normal[0]) == pytest.approx(least, rel=1e-12)


@pytest.mark.long
def test_the_torque_does_the_work_that_compresses_the_contacts(plain, least):
    """Both works by quadrature, that of the ring force beyond its least one from joints without a cam."""
    largest = 40.0
    nodes, weights = np.polynomial.legendre.leggauss(6)
    torque = 0.5 * largest * (1.0 + nodes)
    cam = with_cam(plain)
    ends = [solve_joint(by_force(plain, least + CAM * each)).result for each in (0.0, largest)]
    turned = [float(solve_joint(under_torque(cam, each)).result.cam_angle) for each in (*torque, largest)]
    by_torque = largest * turned[-1] - 0.5 * largest * np.sum(weights * turned[:-1])
    length = [
        float(solve_joint(by_force(plain, least + CAM * each)).result.interference)
        for each in (*torque, largest)
    ]
    sun, ring = np.asarray(ends[1].rest.normal)
    force = float(plain.drive.sectors) * CAM * ring / sun  # of the ring, for a unit of torque
    by_force_of_ring = force * (largest * length[-1] - 0.5 * largest * np.sum(weights * length[:-1]))
    assert by_torque == pytest.approx(by_force_of_ring, rel=1e-8)
    closed = float(ends[1].interference) - float(ends[0].interference)
    assert turned[-1] == pytest.approx(force * closed, rel=1e-9)


@pytest.mark.long
def test_the_stiffness_is_the_slope_of_the_whole_angle(plain, least):
    """Central differences of the cam's angle, in series with the joint whose cam is held."""
    torque, step = 20.0, 0.05
    cam = with_cam(plain)
    angles = [
        float(solve_joint(under_torque(cam, each)).result.cam_angle)
        for each in (torque - step, torque + step)
    ]
    held = solve_joint(under_torque(by_force(plain, least + CAM * torque), torque)).result
    compliance = (angles[1] - angles[0]) / (2.0 * step) + 1.0 / float(held.assembly.stiffness.output)
    found = solve_joint(under_torque(cam, torque)).result.assembly
    assert float(found.stiffness.output) == pytest.approx(1.0 / compliance, rel=1e-7)
    shares = [np.sum(getattr(found, name)) for name in vars(found) if name.endswith("_share")]
    assert sum(shares) == pytest.approx(1.0, rel=1e-9)


@pytest.mark.long
def test_curves_over_torque_are_those_of_the_joint_at_each_torque(plain, least):
    cam = with_cam(plain)
    torques = np.array([-30.0, 0.0, 5.0, 30.0])
    found = over_torque(cam, torques, no_slip_friction=1e30)
    for k, torque in enumerate(torques):
        alone = solve_joint(under_torque(cam, torque)).result
        assert found.assembly[k, 0] == pytest.approx(float(alone.assembly.stiffness.output), rel=1e-9)
        assert found.life_hours[k] == pytest.approx(float(alone.rolling.life_hours.drive), rel=1e-9)
    step = 0.01
    ends = [
        solve_joint(under_torque(cam, each)).result.rolling.speed_loss for each in (5.0 - step, 5.0 + step)
    ]
    about = springs_over_torque(cam, torques)
    assert about.lost_speed_slope[2] == pytest.approx(float(ends[1] - ends[0]) / (2.0 * step), rel=1e-5)
    np.testing.assert_allclose(about.stiffness, found.assembly[:, 0], rtol=1e-9)
    many = over_torque(cam, np.linspace(-40.0, 40.0, 64), no_slip_friction=1e30)
    assert np.all(np.isfinite(many.efficiency))
    curve = windup(cam, largest_torque=30.0, level="assembly", stage_shares=(1.0 / 3.0, 2.0 / 3.0))
    # integrals of the compliances: with the cam, and with as much force but the cam held
    nodes, weights = np.polynomial.legendre.leggauss(6)
    at = 15.0 * (1.0 + nodes)
    held = [
        float(
            solve_joint(
                under_torque(by_force(plain, least + CAM * each), each)
            ).result.assembly.stiffness.output
        )
        for each in at
    ]
    expected = alone.cam_angle + 15.0 * np.sum(weights / np.array(held))
    assert float(curve.angle[-1]) == pytest.approx(float(expected), rel=1e-7)


@pytest.mark.long
def test_lives_under_a_duty_are_those_at_its_torques(plain, least):
    duty = (DutyPoint(10.0, 100.0, 0.25), DutyPoint(40.0, 50.0, 0.75))
    cam = with_cam(plain)
    loaded = dataclasses.replace(cam, rolling=dataclasses.replace(cam.rolling, duty=duty))
    found = solve_joint(loaded).result.rolling
    for k, point in enumerate(duty):
        there = dataclasses.replace(
            by_force(plain, least + CAM * point.output_torque), input_speed=point.input_speed
        )
        alone = solve_joint(under_torque(there, point.output_torque)).result.rolling
        assert found.duty_load_hours[k] == pytest.approx(float(alone.life_hours.drive), rel=1e-9)


@pytest.mark.slow
def test_capacity_is_that_of_the_preload_which_it_makes(plain, least):
    weak = 20.0
    found = solve_joint(with_cam(plain, weak)).standing_capacity
    assert LIMIT_KINDS[int(found.limit)] == "gross_slip"
    torque = float(found.output_torque)
    alike = solve_joint(by_force(plain, least + weak * torque)).standing_capacity
    assert float(alike.output_torque) == pytest.approx(torque, rel=1e-8)
    assert torque > 1.2 * float(solve_joint(by_force(plain, least)).standing_capacity.output_torque)


@pytest.mark.slow
def test_a_strong_cam_never_slips_and_ends_with_another_limit(plain):
    """Friction holds 0.0144 N·m for each newton of preload, and the cam adds 150 N for each N·m."""
    found = solve_joint(with_cam(plain, CAM))
    for capacity in (found.standing_capacity, found.rolling_capacity):
        assert LIMIT_KINDS[int(capacity.limit)] == "contact_too_wide"
        assert float(capacity.output_torque) > 1e3


@pytest.mark.long
def test_a_wall_ends_what_is_computed_and_is_said_to(planar_joint):
    """Hertz by hand: the half-width of the planet in the ring, b = sqrt(4 N R/(pi L E*)), is 1.6 mm, a fifth of the
    wall, under 66.8 kN, at 415.9 N·m; with a wall of 1 mm under 1044 N, at 4.653 N·m.
    """
    wide = with_cam(planar_joint("planetary"), 160.0)
    by_wall = {}
    for wall in (8e-3, 1e-3):
        shapes = tuple(dataclasses.replace(each, size=wall) if each.size else each for each in wide.shapes)
        joint = by_force(dataclasses.replace(wide, shapes=shapes), 300.0)
        by_wall[wall] = dataclasses.replace(joint, cam=wide.cam, output_torque=3.0)
        contact_modulus = 203e9 / 2.0 / (1.0 - 0.29**2)
        radius = 1.0 / (1.0 / 0.02 - 1.0 / 0.05)
        force = np.pi * 0.01 * contact_modulus * (0.2 * wall) ** 2 / (4.0 * radius)
        found = solve_joint(by_wall[wall]).standing_capacity
        assert LIMIT_KINDS[int(found.limit)] == "wall_too_thin"
        assert float(found.output_torque) == pytest.approx((force - 300.0) / 160.0, rel=1e-3)
        told = capacity_document(found, contacts=("sp", "pr"))
        assert told["limiting_contact"] == "pr"
        assert told["is_lower_bound"]
        assert told["meaning"].endswith("the joint may carry more")
    with pytest.raises(
        InputError, match=r"presses with 1900 N; the joint is computed up to 10.. N, at 4\.6.* N·m"
    ):
        solve_joint(under_torque(by_wall[1e-3], 10.0))
