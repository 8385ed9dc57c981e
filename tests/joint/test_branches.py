"""Unequal branches: by hand where a branch is a spring that slips, and with the tables of the paper's joint."""

import dataclasses
import math

import numpy as np
import pytest
from scipy.interpolate import PchipInterpolator, RectBivariateSpline

from asperity.drive.unequal_branches import force_on_sun
from asperity.errors import InputError
from asperity.joint import branches
from asperity.joint.branch_law import BranchLaw, BranchLaws
from asperity.joint.branch_sizes import BranchSizes
from asperity.joint.branches import BranchedJoint
from asperity.joint.working_loads import working_loads

PER_NEWTON, PER_ANGLE = 0.013, 3e4  # capacity over preload [m], stiffness of a branch [N·m/rad]
INTERFERENCE = 13e-6
NONE = np.zeros(3)


MOMENTS = {"sun": 0.15, "carrier": 1.0, "ring": 0.85}  # over the torque


class FakeLaws(BranchLaws):
    """Branches that need no program."""

    def states(self, preload, torque):
        slip = np.where(preload > 0.0, torque / (PER_NEWTON * np.maximum(preload, 1e-9)), np.nan)
        pressure = np.where(preload > 0.0, np.sqrt(preload / 1000.0), np.nan)
        return {
            **{name: np.tile(slip, (5, 1)) for name in ("slip_ratio", "rolling_slip_ratio")},
            **{name: np.tile(pressure, (5, 1)) for name in ("pressure_over_first_yield", "shakedown_ratio")},
            "life_hours": np.where(preload > 0.0, 1.0 / np.maximum(preload, 1e-9), np.nan),
            **{
                f"{rolls}{kind}": np.zeros((5, 3))
                for rolls in ("", "rolling_")
                for kind in ("normal", "tangential")
            },
            **{f"{rolls}pins": np.zeros((2, 2, 3)) for rolls in ("", "rolling_")},
            "bearing_speed": np.zeros((4, 3)),
            **{
                f"{rolls}{name}_torque": share * torque
                for rolls in ("", "rolling_")
                for name, share in MOMENTS.items()
            },
            **{name: np.zeros((5, 3)) for name in ("creep", "skew", "hysteresis", "oil")},
            "contact": np.tile(0.01 * torque, (5, 1)),
            "compliance": 1.0 / (PER_ANGLE * np.where(preload > 0.0, preload, np.nan) / 1000.0),
            "bearings": np.zeros(3),
            **{name: np.full(3, 0.5) for name in ("speed_loss", "drift_per_output_turn", "output_speed")},
        }


def spring_law(rigid_in_preload, friction=0.0):
    """A linear spring that slips at a torque in proportion to its preload; stiffness alike, or as the preload.

    Its bearings take a force of the sun in proportion to the preload.
    """
    nodes = np.geomspace(10.0, 5000.0, 6)
    ends = np.append(0.0, nodes)
    even = np.linspace(0.0, 1.0, 6)
    over, size = np.meshgrid(even, np.log(nodes), indexing="ij")

    def table(values):
        return RectBivariateSpline(even, np.log(nodes), values)

    at_slip = (
        PER_NEWTON * ends / PER_ANGLE if rigid_in_preload else np.full(7, PER_NEWTON * 1000.0 / PER_ANGLE)
    )
    return BranchLaw(
        preloads=nodes,
        capacity=PchipInterpolator(ends, PER_NEWTON * ends),
        demand_at_slip=PchipInterpolator(ends, at_slip),
        used=table(over),
        normal=table(np.ones_like(size)),
        tangential=table(friction + 0.1 * over),
    )


@pytest.fixture
def springs(paper_joint, monkeypatch):
    """A drive of three such branches, whose preload is in proportion to the interference: 1000 N at 13 um."""

    def of(friction=0.0, **changes):
        both = spring_law(True, friction), spring_law(False, friction)
        laws = lambda joint, *, largest_preload: FakeLaws(*both, joint, 1.0)  # noqa: E731
        monkeypatch.setattr(branches, "branch_laws", laws)
        monkeypatch.setattr(branches, "joint_preload", lambda joint, length: 1000.0 * length / INTERFERENCE)
        return BranchedJoint(paper_joint(**changes), INTERFERENCE)

    return of


def sizes(planet, support=math.inf, right=NONE):
    return BranchSizes(np.asarray(planet), np.asarray(right), NONE, support)


def test_equal_branches_share_alike(springs):
    drive = springs(output_torque=5.0)
    for support in (math.inf, 5e7, 0.0):
        found = drive.branches(sizes(NONE, support))
        assert found.preload == pytest.approx(np.full(3, 1000.0), rel=1e-12)
        for state in (found.standing, found.rolling):
            assert state.share == pytest.approx(np.full(3, 1.0 / 3.0), rel=1e-12)
            assert state.torque.sum() == pytest.approx(5.0, rel=1e-12)
            assert state.sun_displacement == pytest.approx(np.zeros(2), abs=1e-18)
        for capacity in (found.capacity, found.rolling_capacity):
            assert capacity.first_slip == pytest.approx(13.0, rel=1e-9)
            assert capacity.all_slip == pytest.approx(capacity.equal, rel=1e-12)


def test_alike_springs_at_rest_by_hand(springs):
    """A held sun: a micrometre of planet is 1.9413 um of interference; springs alike carry alike until one slips."""
    found = springs(output_torque=5.0).branches(sizes([2e-6, 0.0, -2e-6]))
    one = 1000.0 * 1.9413 * 2.0 / 13.0
    preload = 1000.0 + one * np.array([1.0, 0.0, -1.0])
    assert found.preload == pytest.approx(preload, rel=1e-4)
    assert found.standing.share == pytest.approx(np.full(3, 1.0 / 3.0), rel=1e-9)
    assert found.standing.slip_ratio == pytest.approx(5.0 / (PER_NEWTON * preload), rel=1e-4)
    assert found.capacity.first_slip == pytest.approx(PER_NEWTON * preload[2], rel=1e-4)
    assert found.capacity.branch == 2
    assert found.capacity.all_slip == pytest.approx(13.0, rel=1e-4)
    # where all slip at the same creep, each carries as it is pressed
    assert found.rolling.share == pytest.approx(preload / 3000.0, rel=1e-4)
    assert found.rolling_capacity.first_slip == pytest.approx(13.0, rel=1e-4)
    force = found.rest.sun_force
    assert force == pytest.approx(
        [-preload[0] + 0.5 * preload[1] + 0.5 * preload[2], -math.sqrt(0.75) * one], rel=1e-3
    )


def test_beyond_the_first_slip_the_others_take_over(springs):
    found = springs(output_torque=11.0).branches(sizes([2e-6, 0.0, -2e-6]))
    weakest = PER_NEWTON * found.preload[2] / 3.0
    assert found.standing.torque == pytest.approx(
        [(11.0 - weakest) / 2.0, (11.0 - weakest) / 2.0, weakest], rel=1e-6
    )
    assert found.standing.slip_ratio[2] == 1.0
    holding = found.preload[:2].sum() / 1000.0  # springs as stiff as they are pressed; the third slips
    assert found.stiffness == pytest.approx(PER_ANGLE * holding / 3.0, rel=1e-9)
    assert springs(output_torque=13.5).branches(sizes([2e-6, 0.0, -2e-6])).standing is None


def test_the_first_contact_is_looked_for_below_the_slip(springs, monkeypatch):
    """Tables between preloads say where a branch slips to some digits only; there its contacts may have no state."""
    whole = FakeLaws.states

    def states(self, preload, torque):
        found = whole(self, preload, torque)
        uneven = found["rolling_slip_ratio"] * np.array([0.9, 0.9, 0.9, 1.0, 0.9])[:, None]
        return found | {"rolling_slip_ratio": np.where(uneven[3] > 1.0 - 5e-6, np.nan, uneven)}

    monkeypatch.setattr(FakeLaws, "states", states)
    found = springs(output_torque=5.0).branches(sizes([2e-6, 0.0, -2e-6]))
    assert found.rolling_capacity.contact_name == "wro"


def test_a_sun_that_gives_way_unwinds_branches(springs):
    """Branches as stiff as they are pressed: wound up by the common angle and by what the sun's way is for each."""
    drive = springs(output_torque=5.0)
    drive.laws = dataclasses.replace(drive.laws, standing=drive.laws.rolling)
    found = drive.branches(sizes([2e-6, 0.0, -3e-6], 1e8))
    turns = drive.sun_turns(found.standing.sun_displacement - found.rest.sun_displacement)
    stiffness = PER_ANGLE * found.standing.preload / 1000.0
    wound = 3.0 * found.standing.torque / stiffness
    assert np.ptp(turns) > 1e-3 * wound[0]
    assert wound - turns == pytest.approx(np.full(3, wound[0] - turns[0]), rel=0.0, abs=1e-6 * np.ptp(turns))


def test_a_floating_sun_presses_three_planets_alike(springs):
    """Its three forces balance only if they are equal: all have the preload of the mean interference."""
    drive = springs(output_torque=5.0)
    found = drive.branches(sizes([3e-6, 0.0, -1e-6], 0.0, [0.0, 2e-6, 0.0]))
    held = drive.branches(sizes([3e-6, 0.0, -1e-6], math.inf, [0.0, 2e-6, 0.0]))
    # interference is what the ring forces N cos(wedge)/cos(theta) do the same work on as N on the sun's approach
    work = (17.5**2 + 18.5**2 - 35.0**2) / (-2.0 * 17.5 * 18.5)  # cos(theta)
    work /= (18.5**2 + 35.0**2 - 17.5**2) / (2.0 * 18.5 * 35.0)  # cos(wedge)
    angle = 2.0 * np.pi / 3.0 * np.arange(3)
    towards = np.stack([np.cos(angle), np.sin(angle)], axis=1) @ found.rest.sun_displacement
    np.testing.assert_allclose(found.interference - held.interference, work * towards, rtol=1e-9, atol=1e-18)
    assert np.abs(towards).max() > 1e-6
    mean = np.mean(found.interference)
    assert found.preload == pytest.approx(np.full(3, 1000.0 * mean / 13e-6), rel=1e-6)
    assert found.rest.sun_force == pytest.approx(np.zeros(2), abs=1e-3)
    assert found.standing.share == pytest.approx(np.full(3, 1.0 / 3.0), rel=1e-6)


def test_the_sun_unwinds_a_branch_as_far_as_it_follows_its_force(springs):
    """The carrier turns by the ninth part of what the sun rolls off: a milliradian for 36 um."""
    for sense in (1.0, -1.0):
        drive = springs()
        drive.laws = dataclasses.replace(drive.laws, direction=sense)
        force = force_on_sun(normal=np.zeros(3), tangential=sense * np.array([1.0, 0.0, 0.0]))
        turned = drive.sun_turns(36e-6 * force)
        np.testing.assert_allclose(turned, 1e-3 * np.array([-1.0, 0.5, 0.5]), rtol=1e-12)


def test_the_bearings_of_the_sun_balance_its_planets(springs):
    found = springs(output_torque=5.0).branches(sizes([3e-6, 0.0, -1e-6], 5e7))
    for state in (found.rest, found.standing, found.rolling):
        assert state.sun_force == pytest.approx(5e7 * state.sun_displacement, abs=1e-4)
        assert np.hypot(*state.sun_displacement) > 1e-7
    # away from the largest planet
    assert found.rest.sun_displacement[0] < 0.0


def test_a_loose_branch_carries_nothing(springs):
    found = springs(output_torque=5.0).branches(sizes([0.0, 0.0, -8e-6]))
    assert found.preload[2] == 0.0
    assert found.standing.share == pytest.approx([0.5, 0.5, 0.0])
    assert np.isnan(found.standing.slip_ratio[2])
    assert found.capacity.first_slip == pytest.approx(26.0 / 3.0, rel=1e-6)
    assert found.standing.torques == pytest.approx({"sun": 0.75, "carrier": 5.0, "ring": 4.25})
    assert float(found.turning.power.loss) == pytest.approx(
        0.01 * 5.0 * 5.0
    )  # five contacts of each, by its torque
    with pytest.raises(InputError, match="leave no branch"):
        springs().branches(sizes([-8e-6, -8e-6, -8e-6]))


def test_wrong_input_is_told(springs, paper_joint):
    drive = springs()
    with pytest.raises(InputError, match="3 planets, got the sizes of 2"):
        drive.branches(BranchSizes(np.zeros(2), np.zeros(2), np.zeros(2), 0.0))
    with pytest.raises(InputError, match="more than 3 times the nominal one"):
        drive.branches(sizes([20e-6, 0.0, 0.0]))
    with pytest.raises(InputError, match="loading cam"):
        BranchedJoint(dataclasses.replace(paper_joint(), cam_force_per_torque=50.0), INTERFERENCE)


@pytest.fixture(scope="module")
def real(paper_joint):
    joint = dataclasses.replace(
        paper_joint(ring_wall_thickness=60e-3), body_model="springs", ring_support=None
    )
    return BranchedJoint(joint, 12.904e-6)


@pytest.mark.slow
def test_equal_branches_are_the_joint(real):
    from asperity.joint.capacity import torque_capacity
    from asperity.joint.solve import solve

    found = real.branches(sizes(NONE, 5e7))
    solution = solve(real.joint)
    ratio = float(np.max(solution.result.diagnostics.slip_ratio))
    assert found.standing.slip_ratio == pytest.approx(np.full(3, ratio), rel=1e-8)
    assert found.preload == pytest.approx(np.full(3, 1000.0), rel=1e-12)
    assert found.standing.share == pytest.approx(np.full(3, 1.0 / 3.0), rel=1e-12)
    capacity = float(torque_capacity(real.joint, direction=1.0).output_torque)
    assert found.capacity.first_slip == pytest.approx(capacity, rel=1e-9)
    assert found.capacity.equal == pytest.approx(capacity, rel=1e-12)
    # what all of them do together: below the torque by what its search leaves, and by the share that contacts are seen
    rolling, loads = solution.result.rolling, working_loads(real.joint, solution.result)
    assert found.standing.input_torque == pytest.approx(float(solution.result.forces.input_torque), rel=1e-8)
    expected = {"sun": loads.sun_torque, "carrier": loads.carrier_torque, "ring": loads.housing_torque}
    assert found.rolling.torques == pytest.approx(
        {name: float(each) for name, each in expected.items()}, rel=1e-7
    )
    for name in ("speed_loss", "drift_per_output_turn", "drift_rate", "output_speed"):
        assert getattr(found.turning, name) == pytest.approx(float(getattr(rolling, name)), rel=1e-7)
    for name in ("loss", "bearings", "output", "efficiency"):
        own = float(getattr(found.turning.power, name))
        assert own == pytest.approx(float(getattr(rolling.power, name)), rel=1e-7), name


@pytest.mark.slow
def test_five_micrometres_by_the_published_numbers(real):
    """±5 um on a planet make 218 and 1854 N, computed independently; the pressure of a line grows as the root."""
    found = real.branches(sizes([5e-6, 0.0, -5e-6]))
    assert found.preload == pytest.approx([1854.0, 1000.0, 218.0], abs=1.0)
    pressure = found.rest.limits["pressure_over_first_yield"]
    force = real.laws.states(found.rest.preload, np.zeros(3))["normal"]
    assert pressure / pressure[:, 1:2] == pytest.approx(np.sqrt(force / force[:, 1:2]), rel=1e-6)
    lives = found.rolling.limits["life_hours"]
    # Lundberg and Palmgren: the life of a line falls with the fourth power of its force
    assert lives[0] / lives[1] == pytest.approx((1000.0 / 1854.0) ** 4, rel=0.05)
    shakedown = found.rolling.limits["shakedown_ratio"][0]
    assert shakedown[0] / shakedown[1] == pytest.approx(math.sqrt(1.854), rel=0.02)


@pytest.mark.slow
def test_branches_turn_by_the_same_angle_and_creep_alike_without_the_tables(real):
    """The angle of each branch by quadrature of its compliance; the speed loss from its rolling state."""
    found = real.branches(sizes([2e-6, 0.0, -2e-6], 5e7))
    nodes, weights = np.polynomial.legendre.leggauss(8)
    angle = []
    for preload, torque in zip(found.standing.preload, 3.0 * found.standing.torque, strict=True):
        states = real.laws.states(np.full(8, preload), 0.5 * torque * (1.0 + nodes))
        angle.append(0.5 * torque * np.sum(weights * states["compliance"]))
    moved = found.standing.sun_displacement - found.rest.sun_displacement
    own = np.array(angle) - real.sun_turns(moved)
    assert own == pytest.approx(np.full(3, own.mean()), rel=2e-4)
    assert np.ptp(angle) > 0.0
    loss = real.laws.states(found.rolling.preload, 3.0 * found.rolling.torque)["speed_loss"]
    assert loss == pytest.approx(np.full(3, loss.mean()), rel=2e-4)


@pytest.mark.slow
@pytest.mark.parametrize("support", [math.inf, 5e7])
def test_nothing_acts_from_outside_on_sun_carrier_and_ring_together(real, support):
    """Three balances by themselves: contacts of the sun from the tables, those of the ring and the pins without."""
    found = real.branches(sizes([2e-6, 0.0, -2e-6], support))
    for state in (found.rest, found.standing, found.rolling):
        total = state.sun_force + sum(state.centre_forces.values())
        assert total == pytest.approx(np.zeros(2), abs=0.05)
        assert state.force_on("ring") > 10.0
    # the torque of each branch at its pins, on the circle of the loading rollers
    orbit = 35e-3
    turned = found.standing.pins[1].sum(axis=0) * orbit
    assert turned == pytest.approx(found.standing.torque, rel=1e-6)


@pytest.mark.slow
def test_exact_forces_balance_on_the_sun(real):
    found = real.branches(sizes([2e-6, 0.0, -2e-6], 5e7))
    exact = real.laws.states(found.standing.preload, 3.0 * found.standing.torque)
    force = force_on_sun(normal=exact["normal"][0], tangential=exact["tangential"][0])
    assert force == pytest.approx(5e7 * found.standing.sun_displacement, abs=0.05)


@pytest.mark.parametrize("support", [2e7, 2e8])
def test_friction_of_the_bearings_moves_the_sun_a_little(springs, support):
    """In proportion to the friction, also where a branch is wound back; symmetric sizes, which tempt the search far."""
    unequal = sizes([1e-6, -1e-6, -1e-6], support)
    none, little, more = (
        springs(friction=friction, output_torque=5.0).branches(unequal, slip=False).standing
        for friction in (0.0, 1e-5, 1e-3)
    )
    moves = [found.sun_displacement - none.sun_displacement for found in (little, more)]
    assert np.abs(moves[1]).max() > 1e-10
    np.testing.assert_allclose(100.0 * moves[0], moves[1], rtol=0.05, atol=1e-11)
