"""Joints over their torque by NumPy, all at once, and within programs of JAX: equal states and slopes."""

import jax
import numpy as np
import pytest
from both_engines import assert_alike, direction
from joint_changes import BEARINGS, CAM, SKEW, SPRINGS

from asperity.engine import trees
from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.engine.derivatives import value_and_slope
from asperity.joint.assembled import assembled as assembled_machine
from asperity.joint.machine import joint_machine
from asperity.standing.over_torque import curve_program, over_torque_of_assembled, standing_of_assembled
from asperity.standing.springs_over_torque import springs_of_assembled

JOINTS = {
    "planetary": ("planetary", {}),
    "cam": ("planetary", {**SPRINGS, "[load]\n": CAM}),
    "skew": ("planetary", {**SPRINGS, "[lubrication]": SKEW}),
    "pins": ("zou2025", {"[model]": f"{BEARINGS}\n[model]"}),
}
NO_SLIP = 1e6
#: Programs of an assembled joint and of torques, and further numbers of theirs.
PROGRAMS = {
    "standing": (standing_of_assembled, (NO_SLIP,)),
    "turning": (over_torque_of_assembled, (NO_SLIP,)),
    "springs": (springs_of_assembled, ()),
}
CASES = [
    pytest.param(program, joint, marks=pytest.mark.slow if joint in ("cam", "pins") else pytest.mark.long)
    for program in PROGRAMS
    for joint in JOINTS
]
#: Over the joint's own: both senses, none, and beyond what its contacts hold.
SHARES = np.array([-60.0, -0.9, -0.3, 0.0, 0.2, 0.95, 1.2, 60.0])


@pytest.fixture(scope="module")
def assembled(planar_joint):
    """Maker of a joint of NumPy's numbers as a machine, and of its state without torque."""

    def make(name):
        example, replaced = JOINTS[name]
        numbers = as_numbers(planar_joint(example, replaced))
        machine = at_once(joint_machine, numbers)
        return machine, at_once(assembled_machine, machine)

    return make


def rows_of(found, places):
    return trees.map(lambda leaf: np.asarray(leaf)[places], found)


def stands(found):
    """At which torques a joint that stands has a state."""
    return np.asarray(found.solved) if hasattr(found, "solved") else np.isfinite(found.stiffness)


@pytest.mark.parametrize(("program", "name"), CASES)
def test_both_engines_follow_a_joint_over_its_torque(assembled, program, name):
    """At torques without a state there is none in either of them; there the other numbers have no meaning."""
    (machine, without_torque), (function, numbers) = assembled(name), PROGRAMS[program]
    torques = machine.joint.output_torque * SHARES
    ours = at_once(function, machine, without_torque, torques, *map(np.asarray, numbers))
    theirs = jax.jit(function)(machine, without_torque, torques, *numbers)
    known = stands(ours)
    np.testing.assert_array_equal(known, stands(theirs))
    assert not known[[0, -1]].any() or name == "cam"
    assert known[1:-2].all()
    assert_alike(*(rows_of(found, known) for found in (ours, theirs)), 1e-9, beside=ours)


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if name == "cam" else pytest.mark.slow) for name in JOINTS]
)
@pytest.mark.parametrize("program", PROGRAMS)
def test_all_torques_at_once_are_one_torque_after_the_other(assembled, program, name):
    (machine, without_torque), (function, numbers) = assembled(name), PROGRAMS[program]
    torques = machine.joint.output_torque * SHARES

    def at(torques):
        return at_once(function, machine, without_torque, torques, *map(np.asarray, numbers))

    together = at(torques)
    known = stands(together)
    for k in np.flatnonzero(known):
        assert_alike(rows_of(together, [k]), at(torques[[k]]), 1e-9, beside=together)


@pytest.mark.slow
@pytest.mark.parametrize("shown", ["assembly", "drift"])
def test_slopes_of_measured_curves_are_those_of_jax(assembled, shown):
    """By all numbers of the joint."""
    joint = assembled("cam")[0].joint
    torques = joint.output_torque * np.array([-0.5, 0.3, 0.9])

    def curve(joint, torques=torques):
        found = curve_program(joint, torques, NO_SLIP, shown)
        return found[shown], found["slip_ratio"]

    along = direction(joint)
    value, slope = value_and_slope(curve, (joint,), (along,))

    def program(joint, along, torques):
        return jax.jvp(lambda joint: curve(joint, torques), (joint,), (along,))

    _, expected = jax.jit(program)(joint, along, torques)
    assert_alike(slope, expected, 1e-9, beside=value)
