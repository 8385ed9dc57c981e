"""Sectors of their own sizes: equal ones are the joint, and the paper's drive as computed independently."""

import dataclasses
import math
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np
import pytest

from asperity.branches import branches as module
from asperity.branches.branches import BranchedJoint
from asperity.branches.sizes import SectorDeviations
from asperity.drive.state.loads import pin_components
from asperity.errors import InputError, NoSolutionError
from asperity.joint.loading_cam import Pressed
from asperity.joint.solve import solve_joint
from asperity.joint.torque_limits import LIMIT_KINDS, TorqueCapacity
from asperity.joint.unfolding import SectorSizes, SettledSectors
from asperity.joint.working_loads import member_speeds, working_loads
from asperity.joint_file.build import deviations_of
from asperity.joint_file.si_tables import si_values
from asperity.results.branch_document import branch_document
from asperity.rolling.document import losses
from asperity.rolling.power import RollingLosses

SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'ring_support = "free" ': 'ring_support = "rigid_housing" ',
}


def sized(name, per_size, errors, support=math.inf):
    errors = np.asarray(errors, dtype=float)
    return SectorDeviations({name: errors}, np.outer(errors, per_size), np.asarray(per_size), support)


def planets(errors, support=math.inf):
    return sized("planet", [1.0, 1.0], errors, support)


class Limits(NamedTuple):
    output_torque: np.ndarray
    limit: np.ndarray
    limiting_contact: np.ndarray


@pytest.fixture
def made_up(planar_joint, monkeypatch):
    """A planetary whose sectors are pressed with 1000 N at 30 um, and whose planets carry as they are pressed.

    No program: states by hand. Sectors slip at 9 N·m, and all of them at 12 N·m.
    """

    def states(added):
        own = 30e-6 + added.sum(axis=1)
        normal = np.repeat(1000.0 * own / 30e-6, 2)
        state = SimpleNamespace(
            normal=normal,
            tangential=0.05 * normal,
            residual=1e-13,
            displacement=np.array([[1e-6, 2e-6]]),
            pin_force=np.array([10.0, 20.0, 30.0]),
            input_torque=np.asarray(2.0),
            speed_loss=np.asarray(1e-3),
            speed=np.array([1.0, 0.0, -0.5, -0.6, -0.4, 0.2]),  # sun, ring, planets and carrier
        )
        return own, state

    def settled(self, floating, sizes):
        assert floating == (("sun",) if math.isfinite(sizes.sun_support_stiffness) else ())
        _, state = states(sizes.added)
        given = SectorSizes(sizes.added, np.ones_like(sizes.added), np.asarray(sizes.sun_support_stiffness))
        return SettledSectors(given, Pressed(None, state), np.asarray(0.0))

    def sector_states(sectors, floating, joint, settled):
        added = settled.sizes.added
        own, state = states(added)
        each = np.array([[0.5, 0.7], [0.6, 0.4], [0.2, 0.3]])
        return SimpleNamespace(
            rest=state,
            standing=state,
            rolling=state,
            centre_force=np.arange(18.0).reshape(3, 3, 2),
            interference=added + np.array([0.0, 30e-6]),
            output_moment=np.array([own, own[::-1]]),
            centre_moment=np.array([[0.0, 0.0, 0.0], [-2.0, -10.0, 12.0], [-2.1, -9.9, 12.0]]),
            losses=RollingLosses(*np.full((4, 2), [0.2, 0.3]), np.asarray(0.5), np.array([0.8, 1.2])),
            drift_per_output_turn=np.asarray(0.01),
            pressure_over_first_yield=each,
            slip_ratio=each,
            shakedown_ratio=0.5 * each,
            rolling_slip_ratio=0.9 * each,
            life_hours=np.array([1.0, 2.0, 3.0]),
            assembly=SimpleNamespace(stiffness=SimpleNamespace(output=2e4)),
            limits=Limits(
                np.array([9.0, 8.0]), np.full(2, LIMIT_KINDS.index("gross_slip")), np.array([5, 2])
            ),
            most_torque=np.array(12.0),
        )

    def of(torque=6.0):
        monkeypatch.setattr(BranchedJoint, "_settled", settled)
        monkeypatch.setattr(module, "sector_states", sector_states)
        joint = dataclasses.replace(planar_joint("planetary"), output_torque=torque)
        result = SimpleNamespace(interference=30e-6, rest=SimpleNamespace(normal=np.full(2, 1000.0)))
        capacity = [SimpleNamespace(output_torque=value) for value in (10.0, 10.5, 9.0, 9.5)]
        names = ("capacity", "reverse_capacity", "rolling_capacity", "reverse_rolling_capacity")
        solution = SimpleNamespace(result=result, **dict(zip(names, capacity, strict=True)))
        return BranchedJoint(joint, solution)

    return of


def test_sectors_by_hand(made_up):
    """3 um more and less; the first planet is above the sun, so that the axes are turned by 90 degrees."""
    drive = made_up()
    found = drive.branches(planets([1.5e-6, 0.0, -1.5e-6], support=1e7))
    own = np.array([33e-6, 30e-6, 27e-6])
    np.testing.assert_allclose(found.interference, own, rtol=1e-12)
    np.testing.assert_allclose(found.preload, 1000.0 * own / 30e-6, rtol=1e-12)
    np.testing.assert_allclose(np.hypot(*found.standing.largest_pins), [30.0])
    np.testing.assert_allclose(found.standing.contact_forces[0], np.tile(found.preload, (2, 1)))
    turns = 2.0 * math.pi * 25.0  # 1500 rpm of the sun; the second planet is the fastest on its pin
    np.testing.assert_allclose(found.rolling.bearing_speed, [0.8 * turns, turns, 0.2 * turns], rtol=1e-12)
    np.testing.assert_array_equal(found.standing.bearing_speed, 0.0)
    for state, shares in ((found.standing, own), (found.rolling, own[::-1])):
        np.testing.assert_allclose(state.torque, 6.0 * shares / shares.sum(), rtol=1e-12)
    np.testing.assert_array_equal(found.rest.torque, 0.0)
    np.testing.assert_allclose(found.standing.slip_ratio, [0.7, 0.6, 0.3])
    np.testing.assert_allclose(found.rolling.slip_ratio, [0.63, 0.54, 0.27])
    assert found.rolling.limits["shakedown_ratio"].shape == (2, 3)
    # x to the right and y up become -y and x
    np.testing.assert_allclose(found.standing.sun_displacement, [2e-6, -1e-6], atol=1e-18)
    np.testing.assert_allclose(found.standing.sun_force, [7.0, -6.0], atol=1e-12)
    np.testing.assert_allclose(found.standing.centre_forces["ring"], [9.0, -8.0], atol=1e-12)
    assert (found.capacity.first_slip, found.capacity.branch, found.capacity.contact) == (9.0, 2, 1)
    assert (found.rolling_capacity.first_slip, found.rolling_capacity.branch) == (8.0, 1)
    assert (found.capacity.all_slip, found.capacity.equal, found.rolling_capacity.equal) == (12.0, 10.0, 9.0)
    assert found.stiffness == 2e4
    assert found.standing.torques == {"sun": -2.0, "ring": -10.0, "carrier": 12.0}
    assert found.rolling.speeds == pytest.approx({"sun": turns, "ring": 0.0, "carrier": 0.2 * turns})
    assert found.standing.input_torque == 2.0
    # 6 N·m at a fifth of 157 rad/s, beside 2 W of contacts and 0.5 W of bearings
    power = found.turning.power
    assert (float(power.loss), float(power.output)) == pytest.approx((2.5, 6.0 * 0.2 * turns), rel=1e-12)
    assert float(power.efficiency) == pytest.approx(
        37.6991 / (37.6991 + 0.5), rel=1e-5
    )  # 188.496 W and 2.5 W
    assert (found.turning.speed_loss, found.turning.drift_per_output_turn) == (1e-3, 0.01)
    assert found.turning.drift_rate == pytest.approx(0.01 * 0.2 * 25.0, rel=1e-12)  # 5 turns a second
    # the planets are pushed along the tangent; the fastest of them turns 0.8 times as fast as the sun on its pin
    np.testing.assert_allclose(np.abs(found.standing.pins[1]).max(axis=0), [10.0, 20.0, 30.0])
    speed = float(drive.joint.input_speed)
    np.testing.assert_allclose(found.rolling.bearing_speed, np.array([0.8, 1.0, 0.2]) * speed)


def test_sectors_under_more_than_they_carry_and_backwards(made_up):
    backwards = made_up(-6.0).branches(planets([0.0, 0.0, 0.0]))
    assert (backwards.torque, backwards.capacity.equal, backwards.rolling_capacity.equal) == (6.0, 10.5, 9.5)
    np.testing.assert_array_equal(backwards.standing.sun_displacement, 0.0)
    beyond = made_up(12.5).branches(planets([0.0, 0.0, 0.0]))
    assert beyond.standing is None
    assert beyond.stiffness is None
    assert made_up(11.5).branches(planets([0.0, 0.0, 0.0])).stiffness == 2e4


def test_loose_and_floating_sectors_are_refused_before_any_state(made_up):
    drive = made_up()
    with pytest.raises(InputError, match=r"planet 2 is loose: its sizes leave an interference of -2 um"):
        drive.branches(planets([0.0, -16e-6, 0.0]))
    with pytest.raises(InputError, match="leave no branch with an interference"):
        drive.branches(planets([-16e-6, -16e-6, -20e-6]))
    drive.count = 2
    with pytest.raises(InputError, match="nothing holds a floating sun between two sectors"):
        drive.branches(sized("planet", [1.0, 1.0], [0.0, 0.0], 0.0))


@pytest.mark.parametrize(
    ("limit", "contact", "said"),
    [
        ("no_solution", 6, "the force balance has no solution"),
    ],
)
def test_what_ends_the_branches_before_any_contact_does_is_said(limit, contact, said):
    """Limits of branches count the contacts of all sectors: their names were looked up among those of one."""
    drive = SimpleNamespace(joint=SimpleNamespace(contact_names=("sp", "pr")), count=3)
    first = TorqueCapacity(np.array(0.5), np.array(LIMIT_KINDS.index(limit)), np.array(contact))
    with pytest.raises(NoSolutionError, match=rf"cannot be compared: {said}.*beyond 0.5 N"):
        BranchedJoint._capacity(drive, first, math.nan, first)


@pytest.fixture(scope="module")
def branched(planar_joint):
    joint = planar_joint("planetary", SPRINGS)
    return BranchedJoint(joint, solve_joint(joint))


@pytest.mark.slow
def test_equal_sectors_are_the_joint(branched):
    found = branched.branches(planets(np.zeros(3)))
    solution = branched.solution
    result = solution.result
    np.testing.assert_allclose(found.preload, float(result.preload), rtol=1e-12)
    assert found.stiffness == pytest.approx(float(result.assembly.stiffness.output), rel=1e-12)
    for state, slip in (
        (found.standing, result.diagnostics.slip_ratio),
        (found.rolling, result.rolling.slip_ratio),
    ):
        np.testing.assert_allclose(state.share, 1.0 / 3.0, rtol=1e-12)
        np.testing.assert_allclose(state.slip_ratio, np.max(slip), rtol=1e-12)
        for force in (state.sun_force, *state.centre_forces.values()):
            np.testing.assert_allclose(force, 0.0, atol=1e-9)
    np.testing.assert_allclose(
        found.rolling.limits["life_hours"], float(result.rolling.life_hours.drive), rtol=1e-12
    )
    loads = working_loads(branched.joint, result)
    radial, tangential = pin_components(drive=branched.joint.drive, force=loads.pin)
    np.testing.assert_allclose(found.rolling.largest_pins, [radial, tangential], rtol=1e-9, atol=1e-9)
    members = np.asarray(member_speeds(branched.joint, result))  # sun, planet, ring and carrier
    speeds = [abs(members[1] - members[3]), members[0], abs(members[3])]
    np.testing.assert_allclose(found.rolling.bearing_speed, speeds, rtol=1e-12)
    loads = dict(
        zip(branched.joint.drive.members, branched.joint.drive.sense * np.asarray(loads.moments), strict=True)
    )
    del loads["planet"]
    assert found.rolling.torques == pytest.approx(loads, rel=1e-9, abs=1e-9)
    ends = {"sun": abs(members[0]), "ring": 0.0, "carrier": abs(members[3])}
    assert found.rolling.speeds == pytest.approx(ends, rel=1e-12, abs=1e-12)
    assert found.standing.input_torque == pytest.approx(10.0 / 6.0, rel=1e-9)
    told = branch_document(found)["turning"]
    for name in ("speed_loss", "drift_per_output_turn", "drift_rate", "output_speed"):
        assert getattr(found.turning, name) == pytest.approx(float(getattr(result.rolling, name)), rel=1e-9)
    for name, loss in losses(result.rolling).items():
        assert told["losses_W"][name] == (
            None if np.isnan(loss) else pytest.approx(float(loss), rel=1e-9, abs=1e-12)
        )
    assert told["efficiency"] == pytest.approx(float(result.rolling.power.efficiency), rel=1e-12)
    pressure = np.asarray(result.diagnostics.pressure_over_first_yield)
    np.testing.assert_allclose(
        found.standing.limits["pressure_over_first_yield"], np.tile(pressure, (3, 1)).T, rtol=1e-12
    )
    # torques to the width of the last step of their searches
    assert found.capacity.first_slip == pytest.approx(float(solution.first_slip.output_torque), rel=1e-9)
    assert found.capacity.all_slip == pytest.approx(float(solution.capacity.output_torque), rel=1e-9)
    assert found.rolling_capacity.first_slip == pytest.approx(
        float(solution.rolling_capacity.output_torque), rel=1e-9
    )


@pytest.mark.slow
def test_what_unequal_planets_do(branched):
    found = branched.branches(planets([2e-6, 0.0, -2e-6]))
    # a planet grows into the sun and into the ring
    np.testing.assert_allclose(found.interference, 30e-6 + 2.0 * np.array([2e-6, 0.0, -2e-6]), rtol=1e-9)
    assert found.preload[0] > found.preload[1] > found.preload[2]
    assert (found.capacity.branch, found.capacity.contact_name) == (2, "sp")
    assert found.capacity.first_slip < found.capacity.all_slip
    assert math.isnan(found.rolling_capacity.all_slip)
    for state in (found.rest, found.standing, found.rolling):
        # nothing acts from outside: what the bearings of sun, ring and carrier bear adds up to nothing
        total = state.sun_force + sum(state.centre_forces.values())
        np.testing.assert_allclose(total, 0.0, atol=1e-8)
        assert np.hypot(*state.sun_force) > 10.0
    assert found.standing.torque.sum() == pytest.approx(10.0, rel=1e-12)
    # the carrier is the output: the pins carry the torque of each planet, 30 mm from the axis
    np.testing.assert_allclose(30e-3 * found.standing.pins[1, 0], found.standing.torque, rtol=1e-9)
    for member, force in {"sun": found.standing.sun_force, **found.standing.centre_forces}.items():
        assert found.standing.force_on(member) == pytest.approx(np.hypot(*force), rel=1e-12)
    # the torques on sun, ring and carrier add up to nothing
    for state in (found.standing, found.rolling):
        assert sum(state.torques.values()) == pytest.approx(0.0, abs=1e-8)
        assert abs(state.torques["sun"]) == pytest.approx(10.0 / 6.0, rel=2e-3)
    # the sun is pushed away from the largest planet
    assert found.rest.sun_force[0] < 0.0
    backwards = branched.branches(planets([2e-6, 0.0, -2e-6]).with_first(-2e-6))
    np.testing.assert_allclose(backwards.interference, 30e-6 + 2.0 * np.array([0.0, 0.0, -2e-6]), rtol=1e-9)


@pytest.mark.slow
def test_sizes_that_cannot_be_compared_are_refused(branched, planar_joint):
    with pytest.raises(InputError, match="3 planets, got the sizes of 2"):
        branched.branches(planets([0.0, 0.0]))
    with pytest.raises(InputError, match=r"planet 3 is loose: its sizes leave an interference of -2 .m"):
        branched.branches(planets([0.0, 0.0, -16e-6]))
    with pytest.raises(InputError, match="the drive is loose"):
        branched.branches(planets([-16e-6, -16e-6, -16e-6]))
    by_force = planar_joint("planetary", {'interference = "30 um"  ': 'preload = "1000 N"  '})
    with pytest.raises(InputError, match=r"give load\.interference"):
        BranchedJoint(by_force, branched.solution)


@pytest.mark.long
def test_unlike_planets_of_the_papers_drive(paper_joint):
    """One planet 5 um too large and one too small: 1854, 1000 and 218 N with the sun held, computed independently."""
    joint = paper_joint(ring_wall_thickness=60e-3, body_model="springs", interference=12.904e-6)
    found = BranchedJoint(joint, solve_joint(joint)).branches(
        sized("planet", [1.0, 1.0, 1.0, 0.0, 0.0], np.array([5e-6, 0.0, -5e-6]))
    )
    np.testing.assert_allclose(found.preload, [1854.0, 1000.0, 218.0], atol=1.0)
    # a planet counts 1.9413 times, computed independently
    np.testing.assert_allclose(
        found.interference - 12.904e-6, [9.7065e-6, 0.0, -9.7065e-6], rtol=5e-5, atol=1e-15
    )


@pytest.mark.long
@pytest.mark.parametrize("name", ["multiroller", "stepped_planet"])
def test_equal_sectors_of_other_drives(planar_joint, planar_case, name):
    joint = planar_joint(name)
    solution = solve_joint(joint)
    found = BranchedJoint(joint, solution).branches(deviations_of(si_values(planar_case(name))))
    result = solution.result
    np.testing.assert_allclose(found.preload, float(result.preload), rtol=1e-12)
    assert found.stiffness == pytest.approx(float(result.assembly.stiffness.output), rel=1e-11)
    np.testing.assert_allclose(found.rolling.slip_ratio, np.max(result.rolling.slip_ratio), rtol=1e-11)
    np.testing.assert_allclose(
        found.rolling.limits["life_hours"], float(result.rolling.life_hours.drive), rtol=1e-11
    )
    assert found.capacity.all_slip == pytest.approx(float(solution.capacity.output_torque), rel=1e-9)
