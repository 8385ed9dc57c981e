"""Branches that are springs with a limit, by hand: how they share torques, and where the sun goes."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint import branch_solver
from asperity.joint.branch_solver import all_together

# the fixture `springs`: 1000 N at 13 um slip at 13 N*m, and turn by one radian at 3e4 N*m
PER_NEWTON, PER_ANGLE = 0.013, 3e4
NONE = np.zeros(3)
UNLIKE = [2e-6, 0.0, -3e-6]


def test_equal_branches_share_alike(springs, sizes):
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


def test_alike_springs_at_rest_by_hand(springs, sizes):
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


def test_beyond_the_first_slip_the_others_take_over(springs, sizes):
    found = springs(output_torque=11.0).branches(sizes([2e-6, 0.0, -2e-6]))
    weakest = PER_NEWTON * found.preload[2] / 3.0
    assert found.standing.torque == pytest.approx(
        [(11.0 - weakest) / 2.0, (11.0 - weakest) / 2.0, weakest], rel=1e-6
    )
    assert found.standing.slip_ratio[2] == 1.0
    holding = found.preload[:2].sum() / 1000.0  # springs as stiff as they are pressed; the third slips
    assert found.stiffness == pytest.approx(PER_ANGLE * holding / 3.0, rel=1e-9)
    assert springs(output_torque=13.5).branches(sizes([2e-6, 0.0, -2e-6])).standing is None


def test_the_first_contact_is_looked_for_below_the_slip(springs, monkeypatch, sizes):
    """Tables between preloads say where a branch slips to some digits only; there its contacts may have no state."""
    fake = type(springs().laws)
    whole = fake.states

    def states(self, preload, torque):
        found = whole(self, preload, torque)
        uneven = found["rolling_slip_ratio"] * np.array([0.9, 0.9, 0.9, 1.0, 0.9])[:, None]
        return found | {"rolling_slip_ratio": np.where(uneven[3] > 1.0 - 5e-6, np.nan, uneven)}

    monkeypatch.setattr(fake, "states", states)
    found = springs(output_torque=5.0).branches(sizes([2e-6, 0.0, -2e-6]))
    assert found.rolling_capacity.contact_name == "wro"


def test_a_sun_that_gives_way_unwinds_branches(springs, sizes):
    """Branches as stiff as they are pressed: wound up by the common angle and by what the sun's way is for each."""
    drive = springs(output_torque=5.0)
    drive.laws = dataclasses.replace(drive.laws, standing=drive.laws.rolling)
    found = drive.branches(sizes([2e-6, 0.0, -3e-6], 1e8))
    turns = drive.sun_turns(found.standing.sun_displacement - found.rest.sun_displacement)
    stiffness = PER_ANGLE * found.standing.preload / 1000.0
    wound = 3.0 * found.standing.torque / stiffness
    assert np.ptp(turns) > 1e-3 * wound[0]
    assert wound - turns == pytest.approx(np.full(3, wound[0] - turns[0]), rel=0.0, abs=1e-6 * np.ptp(turns))


def test_a_floating_sun_presses_three_planets_alike(springs, sizes):
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


def test_the_bearings_of_the_sun_balance_its_planets(springs, sizes):
    found = springs(output_torque=5.0).branches(sizes([3e-6, 0.0, -1e-6], 5e7))
    for state in (found.rest, found.standing, found.rolling):
        assert state.sun_force == pytest.approx(5e7 * state.sun_displacement, abs=1e-4)
        assert np.hypot(*state.sun_displacement) > 1e-7
    # away from the largest planet
    assert found.rest.sun_displacement[0] < 0.0


def test_a_loose_branch_carries_nothing(springs, sizes):
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


@pytest.mark.parametrize("support", [2e7, 2e8])
def test_friction_of_the_bearings_moves_the_sun_a_little(springs, support, sizes):
    """In proportion to the friction, also where a branch is wound back; symmetric sizes, which tempt the search far."""
    unequal = sizes([1e-6, -1e-6, -1e-6], support)
    none, little, more = (
        springs(friction=friction, output_torque=5.0).branches(unequal, slip=False).standing
        for friction in (0.0, 1e-5, 1e-3)
    )
    moves = [found.sun_displacement - none.sun_displacement for found in (little, more)]
    assert np.abs(moves[1]).max() > 1e-10
    np.testing.assert_allclose(100.0 * moves[0], moves[1], rtol=0.05, atol=1e-11)


@pytest.fixture
def as_stiff_as_pressed(springs):
    """A drive whose standing branches have a stiffness in proportion to their preload."""
    drive = springs()
    drive.laws = dataclasses.replace(drive.laws, standing=drive.laws.rolling)
    return drive


@pytest.mark.parametrize("support", [math.inf, 5e7, 0.0])
@pytest.mark.parametrize("turns", [False, True])
def test_a_point_is_the_state_of_the_whole(springs, sizes, support, turns):
    """All torques at once, against the search for each by itself."""
    drive = springs()
    torques = np.array([9.0, 1e-3, 0.0, 5.0, 12.0])
    points = drive.solver(sizes(UNLIKE, support), turns=turns).points(torques)
    assert points.carried.all()
    for index, torque in enumerate(torques):
        state = drive.solver(sizes(UNLIKE, support), turns=turns).under(torque)
        assert points.preload[index] == pytest.approx(state.preload, rel=1e-8)
        assert points.torque[index] / 3.0 == pytest.approx(state.torque, rel=1e-7, abs=1e-12)
        assert points.slips[index].tolist() == (state.slip_ratio >= 1.0).tolist()
    assert np.sum(points.torque, axis=1) / 3.0 == pytest.approx(torques, rel=1e-13, abs=1e-12)


@pytest.mark.parametrize("support", [5e7, 0.0])
@pytest.mark.parametrize("turns", [False, True])
def test_where_newton_goes_astray_each_torque_is_searched_for(springs, sizes, monkeypatch, support, turns):
    drive, torques = springs(), np.array([1.0, 9.0])
    found = drive.solver(sizes(UNLIKE, support), turns=turns).points(torques)
    monkeypatch.setattr(branch_solver, "_NEWTON_STEPS", 0)
    again = drive.solver(sizes(UNLIKE, support), turns=turns).points(torques)
    assert again.torque == pytest.approx(found.torque, rel=1e-7)
    assert again.preload == pytest.approx(found.preload, rel=1e-8)


def test_branches_that_slip_are_named(springs, sizes):
    """A micrometre of planet is 149.3 N: the third slips at 13 (1 - 0.4480) N*m, when all have that torque."""
    solver = springs().solver(sizes(UNLIKE), turns=False)
    first = 13.0 * (1.0 - 3.0 * 0.14933)
    found = solver.points(first * np.array([0.999, 1.001]))
    assert found.slips.tolist() == [[False] * 3, [False, False, True]]


def test_beyond_what_all_hold_there_is_no_point(springs, sizes):
    solver = springs().solver(sizes(UNLIKE), turns=False)
    most = solver.capacity().all_slip
    assert most == pytest.approx(13.0 * (1.0 - 0.14933 / 3.0), rel=1e-4)  # the sum of what each holds
    assert solver.points(most * np.array([1.0001, 0.9999])).carried.tolist() == [False, True]
    assert solver.under(1.0001 * most) is None


@pytest.mark.parametrize("support", [2e7, 2e8])
@pytest.mark.parametrize("turns", [False, True])
def test_a_sun_that_gives_way_takes_from_the_stiffness(as_stiff_as_pressed, sizes, support, turns):
    """The slope of the torque over the common angle, with the sun free to follow, over that with the sun nailed."""
    solver = as_stiff_as_pressed.solver(sizes(UNLIKE, support), turns=turns)
    torques = np.array([4.0])
    (moving_sun,) = solver.points(torques).moving_sun
    (angle,), (place,) = solver._places(torques, solver._most())
    step = 1e-4 * angle
    free = solver.total(angle + step) - solver.total(angle - step)

    def nailed(common):
        preload, share, _ = solver._loads(solver._demands(common, place), place)
        return float(np.mean(solver.law.torque(preload, share)))

    held = nailed(angle + step) - nailed(angle - step)
    assert moving_sun == pytest.approx(free / held, rel=1e-5)
    # three alike in rolling: what the sun takes from one preload it gives to the others
    assert moving_sun == pytest.approx(1.0, rel=1e-9) if turns else abs(moving_sun - 1.0) > 1e-4


def test_a_sun_among_equal_branches_or_held_stays_where_it_is(as_stiff_as_pressed, sizes):
    def factors(of):
        return as_stiff_as_pressed.solver(of, turns=False).points(np.array([1.0, 4.0])).moving_sun

    assert factors(sizes(NONE, 5e7)) == pytest.approx(np.ones(2), rel=1e-9)
    assert factors(sizes(UNLIKE)).tolist() == [1.0, 1.0]


def test_together_each_counts_once_and_what_no_branch_does_once():
    """Bearings take 1 of each value; the loose branch does nothing: 1 + (3 + 1)/3, and 1 + (9 + 19)/3."""
    each = np.array([[4.0, 2.0, 50.0], [10.0, 20.0, np.nan]])
    found = all_together(each, np.array([True, True, False]), 1.0)
    assert found == pytest.approx([7.0 / 3.0, 31.0 / 3.0], rel=1e-15)
