"""Branches of unlike sizes as ordinary joints, and all that is made of them: curves, dynamics, rolling onset.

Equal branches must give what the joint itself does. Unlike ones are checked by a second route: the common angle and
speed loss at which the tables of :mod:`asperity.joint.branch_law` say that the branches share a torque.
"""

import dataclasses
import math

import jax
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.both_senses import both_senses
from asperity.joint.branch_sizes import BranchSizes
from asperity.joint.branches import BranchedJoint
from asperity.joint.dynamics import Inertias, dynamics
from asperity.joint.standing import WITHOUT_SHAFTS, standing_at
from asperity.joint.unlike_joint import UnlikeJoint, branch_joints
from asperity.joint.unlike_solution import solve_unlike
from asperity.joint.windup import is_symmetric, windup
from asperity.joint.windup_document import examined_windup, windup_document, windup_onsets
from asperity.joint_file.build import branches_from_case, joint_from_case
from asperity.joint_file.reader import parse_case

UNLIKE = np.array([3e-6, 0.0, -2e-6])
SHAFTS = '\n[compliance]\ninput_shaft_stiffness = "500 N*m/rad"\noutput_shaft_stiffness = "50000 N*m/rad"\n'
INERTIAS = Inertias(2e-5, 0.05, 0.0)


@pytest.fixture(scope="module")
def equal(zou_file):
    """The paper's joint, its preload by interference."""
    text = zou_file.read_text(encoding="utf-8").replace('preload = "1000 N"', 'interference = "13 um"')
    case = parse_case(text + SHAFTS, source="mine.toml")
    interference, _ = branches_from_case(case)
    joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint_from_case(case))
    return joint, interference


@pytest.fixture(scope="module")
def unlike(equal):
    def of(planet, support=math.inf, right=0.0):
        sizes = BranchSizes(np.asarray(planet), np.full(3, right), np.zeros(3), support)
        return UnlikeJoint(*equal, sizes)

    return of


def test_a_joint_names_its_contacts_branch_by_branch(unlike):
    joint = unlike(UNLIKE)
    assert joint.contact_names[4:7] == ("wlo_1", "sp_2", "pwr_2")
    assert (joint.ends, len(joint.contact_names)) == (("sun", "carrier"), 15)
    other = joint.under(-3.0, -100.0)
    assert (other.output_torque, other.sun_speed, other.sizes) == (-3.0, -100.0, joint.sizes)
    assert joint.geometry is joint.joint.geometry


def test_torques_in_one_direction_stand_for_the_other_where_all_is_its_own_mirror_image(unlike):
    assert is_symmetric(unlike(UNLIKE))
    assert is_symmetric(unlike(np.full(3, 1e-6), 0.0))
    assert not is_symmetric(unlike(UNLIKE, 2e7))
    assert not is_symmetric(unlike(UNLIKE, right=1e-6))


@pytest.mark.long
def test_torques_of_both_signs_are_shared(unlike):
    """A loose third branch carries nothing; the sum is the torque; beyond the capacity nothing is carried."""
    joint = unlike([3e-6, 0.0, -8e-6])
    torques = np.array([4.0, -4.0, 0.0, 60.0])
    points = branch_joints(joint, torques, np.copysign(100.0, torques), turns=False)
    assert list(points.carried) == [True, True, True, False]
    assert points.bears[:, :2].tolist() == [[True, True]] * 2 + [[False, False]]
    np.testing.assert_allclose(points.share[:, :2].sum(axis=0), 1.0, rtol=1e-14)
    np.testing.assert_allclose(points.share[:, 0], points.share[:, 1], rtol=1e-12)
    own = points.of_each(np.asarray(points.joints.output_torque))
    np.testing.assert_allclose(own.mean(axis=0)[:2], torques[:2], rtol=1e-14)
    assert np.all(np.isnan(points.share[:, 2]))
    ones = np.ones(12)
    np.testing.assert_allclose(points.together(ones)[:2], 2.0 / 3.0, rtol=1e-15)
    np.testing.assert_allclose(points.alike(np.arange(12.0))[:2], [2.0, 3.0], rtol=1e-15)
    assert np.all(points.moving_sun == 1.0)


@pytest.mark.slow
@pytest.mark.parametrize(
    "support", [math.inf, *(pytest.param(each, marks=pytest.mark.long) for each in (2e7, 0.0))]
)
def test_equal_branches_are_the_joint_itself(unlike, equal, support):
    joint, torques = equal[0], np.array([-9.0, -2.0, 0.5, 5.0, 13.0])
    expected, found = standing_at(joint, torques), standing_at(unlike(np.zeros(3), support), torques)
    for name in ("published", "series_with_bulk", "assembly"):
        np.testing.assert_allclose(found.levels[name], expected.levels[name], rtol=1e-9)
        np.testing.assert_allclose(
            found.levels_without_slip[name], expected.levels_without_slip[name], rtol=1e-9
        )
    np.testing.assert_allclose(found.slip_ratio, np.tile(expected.slip_ratio, (3, 1)), rtol=1e-9)
    assert np.all(found.holds)


@pytest.mark.long
def test_equal_branches_drift_and_swing_as_the_joint_itself(unlike, equal):
    joint, own = equal[0], unlike(np.zeros(3))
    torques = np.array([-9.0, 2.0, 13.0])
    expected, found = (both_senses(joint=each, torque=torques) for each in (joint, own))
    for name in ("assembly", "slip_ratio", "driving_drift", "braking_drift"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), rtol=1e-8, err_msg=name)
    at, own_at = (dynamics(each, INERTIAS).at_torque for each in (joint, own))
    for field in dataclasses.fields(at):
        assert getattr(own_at, field.name) == pytest.approx(float(getattr(at, field.name)), rel=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("support", "largest", "differ"),
    [
        (math.inf, 9.0, 1e-4),
        pytest.param(2e7, 9.0, 1e-4, marks=pytest.mark.long),
        pytest.param(math.inf, 13.0, 1e-3, marks=pytest.mark.long),
    ],
)
def test_the_loading_curve_is_the_angle_at_which_the_branches_lie(unlike, equal, support, largest, differ):
    """The integral of the exact compliance against the angle of the tables, and the shafts; the first slips at 9.7."""
    joint = unlike(UNLIKE, support)
    curve = windup(joint, largest_torque=largest, level="assembly")
    there = joint.under(largest, abs(float(joint.sun_speed))).joint
    solver = BranchedJoint(there, equal[1]).solver(joint.sizes, turns=False)
    shafts = 1.0 / 50000.0 + 1.0 / 500.0 / 81.0  # the ratio is 9
    picked = slice(curve.torque.size // 2 + 5, None, 6)
    torques = np.asarray(curve.torque[picked])
    angles, _ = solver._places(torques, solver._most())
    expected = angles + shafts * torques
    np.testing.assert_allclose(curve.angle[picked], expected, rtol=differ)


@pytest.mark.slow
def test_a_branch_that_slips_has_no_stiffness(unlike):
    """Beyond 9.74 N·m the third branch slips, and the stiffness of the two others is left."""
    found = standing_at(unlike(UNLIKE), np.array([9.0, 11.0]))
    slipping, sticking = (each[WITHOUT_SHAFTS] for each in (found.levels, found.levels_without_slip))
    assert slipping[1] / slipping[0] == pytest.approx(2.0 / 3.0, abs=0.03)
    assert sticking[1] / sticking[0] == pytest.approx(1.0, abs=0.01)
    assert found.slip_ratio[10, 1] == pytest.approx(1.0, abs=1e-5)  # contact sp of the third
    assert np.all(np.delete(found.slip_ratio[:, 1], 10) < 0.99)


@pytest.mark.slow
def test_the_stiffness_of_the_branches_is_that_of_their_wind_up(unlike):
    joint = unlike(UNLIKE, 2e7)
    found = joint.branches()
    expected = standing_at(joint, np.array([found.torque])).levels["assembly"][0]
    assert found.stiffness == pytest.approx(expected, rel=1e-7)


@pytest.mark.long
@pytest.mark.parametrize("support", [math.inf, 2e7])
def test_dampers_lie_side_by_side(unlike, support):
    """1/c is the slope of the lost speed over the torque, here of what the branches drift by at two torques."""
    joint = unlike(UNLIKE, support)
    damping = float(dynamics(joint, INERTIAS).at_torque.creep_damping)
    speed, torque, step = float(joint.sun_speed), float(joint.output_torque), 0.05
    lost = []
    for each in (torque - step, torque + step):
        turning = joint.under(each, speed).branches().turning
        lost.append(turning.speed_loss * speed / 9.0)
    assert 1.0 / damping == pytest.approx((lost[1] - lost[0]) / (2.0 * step), rel=2e-3)


@pytest.mark.long
def test_every_contact_of_every_branch_begins_to_roll(unlike, equal):
    """Equal branches: each contact three times, with a third of its share. Unlike ones drift as the branches do."""
    joint = unlike(np.zeros(3))
    both = []
    for each in (equal[0], joint):
        curve, solutions = examined_windup(each, largest_torque=5.0, level="assembly")
        onsets = windup_onsets(each, curve, solutions, creep_share=0.05)
        both.append(windup_document(each, curve, solutions, onsets, level="assembly"))
    expected, found = both
    assert (expected["of_own_branches"], found["of_own_branches"]) == (False, True)
    rolling, own = expected["rolling"], found["rolling"]
    for key in ("static_curve_up_to", "steady_creep_from", "swing_without_drift"):
        assert own[key]["output_rad"] == pytest.approx(rolling[key]["output_rad"], rel=1e-7)
    for name, contact in rolling["contacts"].items():
        third = own["contacts"][f"{name}_3"]
        assert third["share_of_drift"] == pytest.approx(contact["share_of_drift"] / 3.0, rel=1e-9)
        assert third["width_m"] == pytest.approx(contact["width_m"], rel=1e-9)
    capacity = found["torque_capacity"]
    assert capacity["output_torque_Nm"] == pytest.approx(
        expected["torque_capacity"]["output_torque_Nm"], rel=1e-9
    )

    joint = unlike(UNLIKE).under(5.0, float(joint.sun_speed))
    solution = solve_unlike(joint)
    curve = windup(joint, largest_torque=5.0, level="assembly", steps=4)
    onset, _ = windup_onsets(joint, curve, (solution, solution), creep_share=0.05)
    drift = solution.branches.turning.drift_per_output_turn
    assert float(onset.contacts.drift_per_output_turn) == pytest.approx(drift, rel=1e-4)  # of the tables
    assert float(np.sum(onset.contacts.share)) == pytest.approx(1.0, rel=1e-12)
    share = np.asarray(onset.contacts.share).reshape(3, 5).sum(axis=1)
    np.testing.assert_allclose(share, solution.branches.rolling.share, rtol=1e-6)
    assert solution.unknown_because(joint) == []


@pytest.mark.long
def test_a_wind_up_says_nothing_of_a_loose_branch_or_of_the_drift_where_one_slips(unlike):
    """The third planet loose; and at 14.1 N·m slipping in rolling too, from 13.99 on."""

    def rolling(joint, torque):
        curve, solutions = examined_windup(joint, largest_torque=torque, level="assembly")
        onsets = windup_onsets(joint, curve, solutions, creep_share=0.05)
        return windup_document(joint, curve, solutions, onsets, level="assembly")["rolling"]

    contacts = rolling(unlike([3e-6, 0.0, -8e-6]), 4.0)["contacts"]
    assert [name for name in contacts if name.endswith("_3")] == []
    assert sum(each["share_of_drift"] for each in contacts.values()) == pytest.approx(1.0, rel=1e-12)
    found = both_senses(joint=unlike(UNLIKE), torque=np.array([5.0, 14.1, -14.1]))
    for drift in (found.driving_drift, found.braking_drift):
        assert np.isnan(drift).tolist() == [False, True, True]
    turned = float(unlike(UNLIKE).sun_speed)
    at = dynamics(unlike(UNLIKE).under(14.1, turned), INERTIAS).at_torque
    assert at.stiffness > 0.0
    assert np.isnan([at.creep_damping, at.corner_frequency]).all()
    for found in (slips := rolling(unlike(UNLIKE), 14.1), slips["reverse"]):
        assert found["unknown_because"][0].startswith("drift and losses are not known")
        assert "planet 3 slips as a whole" in found["unknown_because"][0]


@pytest.mark.slow
def test_a_torque_that_the_branches_do_not_carry_is_refused_or_has_no_rolling(unlike):
    joint = unlike(UNLIKE)
    speed = float(joint.sun_speed)
    with pytest.raises(InputError, match=r"beyond what the branches carry together, 14\.3 N·m"):
        solve_unlike(joint.under(14.5, speed))
    solution = solve_unlike(joint.under(-14.2, -speed))  # more than equal ones carry
    document = solution.capacity_document
    assert document["output_torque_Nm"] == pytest.approx(14.3, abs=0.01)
    assert document["first_slip"]["contact"] == "sp_3"
    assert document["first_slip"]["output_torque_Nm"] == pytest.approx(9.74, abs=0.01)
