"""Unequal branches with the tables of the paper's joint, against the joint itself and against routes without tables."""

import dataclasses
import math

import numpy as np
import pytest
from asperity.drive.unequal_branches import force_on_sun
from asperity.joint.branches import BranchedJoint
from asperity.joint.working_loads import working_loads

from asperity.errors import InputError
from asperity.joint.branch_sizes import BranchSizes

INTERFERENCE = 13e-6
NONE = np.zeros(3)


def test_the_sun_unwinds_a_branch_as_far_as_it_follows_its_force(springs):
    """The carrier turns by the ninth part of what the sun rolls off: a milliradian for 36 um."""
    for sense in (1.0, -1.0):
        drive = springs()
        drive.laws = dataclasses.replace(drive.laws, direction=sense)
        force = force_on_sun(normal=np.zeros(3), tangential=sense * np.array([1.0, 0.0, 0.0]))
        turned = drive.sun_turns(36e-6 * force)
        np.testing.assert_allclose(turned, 1e-3 * np.array([-1.0, 0.5, 0.5]), rtol=1e-12)


def test_wrong_input_is_told(springs, paper_joint, sizes):
    drive = springs()
    with pytest.raises(InputError, match="3 planets, got the sizes of 2"):
        drive.branches(BranchSizes(np.zeros(2), np.zeros(2), np.zeros(2), 0.0))
    with pytest.raises(
        InputError, match=r"of branch 1, 51\.8. um, is more than 3 times that of equal .* 13 um"
    ):
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
def test_equal_branches_are_the_joint(real, sizes):
    from asperity.joint.capacity import torque_capacity
    from asperity.joint.planar.solve import solve_planar

    found = real.branches(sizes(NONE, 5e7))
    solution = solve_planar(real.joint)
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
def test_five_micrometres_by_the_published_numbers(real, sizes):
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
def test_branches_turn_by_the_same_angle_and_creep_alike_without_the_tables(real, sizes):
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
def test_nothing_acts_from_outside_on_sun_carrier_and_ring_together(real, support, sizes):
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
def test_exact_forces_balance_on_the_sun(real, sizes):
    found = real.branches(sizes([2e-6, 0.0, -2e-6], 5e7))
    exact = real.laws.states(found.standing.preload, 3.0 * found.standing.torque)
    force = force_on_sun(normal=exact["normal"][0], tangential=exact["tangential"][0])
    assert force == pytest.approx(5e7 * found.standing.sun_displacement, abs=0.05)
