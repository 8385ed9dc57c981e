"""A joint over its output torque: stiffness, standing, with and without slip, drift in rolling."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from asperity.drive.layout.drive import creeping_speeds, driving_sense
from asperity.drive.state.creep import drift_per_turn
from asperity.drive.state.first_limit import slip_ratio
from asperity.drive.state.state import STATE_TOLERANCE, DriveLoad, DriveState
from asperity.drive.state.states import loaded_state, loaded_states, standing_state
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once, map_over, vectorised
from asperity.engine.derivatives import value_and_slope
from asperity.joint.assembled import Pressed, assembled
from asperity.joint.bores import pin_loads
from asperity.joint.contacts import JointContacts
from asperity.joint.description import Joint
from asperity.joint.laws import creep_under, drive_load, rolling_load
from asperity.joint.loading_cam import CamOfJoint, pressed_at, turned_cam, with_its_cam
from asperity.joint.machine import JointMachine, joint_machine
from asperity.joint.stiffness import loaded_stiffness
from asperity.rolling.rolling import turning
from asperity.types import Array, Document, Real


class StandingOverTorque(NamedTuple):
    """A joint that stands, at torques of either sign along the first axis, as of :class:`OverTorque`."""

    balanced: Array
    solved: Array
    slip_ratio: Array
    published: Array
    series_with_bulk: Array
    assembly: Array


class OverTorque(NamedTuple):
    """A joint at torques of either sign. SI units, torques along the first axis.

    ``balanced`` tells whether the forces of the joint that stands balance, ``solved`` whether they also stay within
    friction. ``slip_ratio`` is its T/(mu N), 1 where a contact slides while others hold, shape (torques, contacts).
    Incremental stiffnesses at the output, shape (torques, 2) [N·m/rad]: as it is, and under the same normal forces with
    so much friction that no contact slips. ``drift``, shape (torques, 2) [rad], is the angle by which the output gives
    way to the torque in one turn of its own, with the sign of the torque, in rolling with the torque and against it;
    nan where there is no steady rolling. ``efficiency`` counts power as the input turns, ``total_loss`` in W; lives in
    hours and turns of the output.
    """

    balanced: Array
    solved: Array
    slip_ratio: Array
    published: Array
    series_with_bulk: Array
    assembly: Array
    drift: Array
    efficiency: Array
    total_loss: Array
    life_hours: Array
    life_turns: Array


def over_torque(joint: Joint, torques: np.ndarray, *, no_slip_friction: float) -> OverTorque:
    """What a joint does at output torques of either sign, shape (torques,) [N·m], as NumPy arrays.

    ``no_slip_friction``: under which no contact slips [-]. Results of states that do not balance have no meaning.
    """
    return at_torques(over_torque_of_assembled, joint, torques, no_slip_friction)


def standing_over_torque(joint: Joint, torques: np.ndarray, *, no_slip_friction: float) -> StandingOverTorque:
    """What a joint that stands does at torques, as NumPy arrays."""
    return at_torques(standing_of_assembled, joint, torques, no_slip_friction)


def at_torques(function: Callable[..., Any], joint: Joint, torques: np.ndarray, *numbers: float) -> Any:
    """What a function of a machine, its assembled state, torques and further numbers gives, as NumPy arrays."""
    machine = at_once(joint_machine, as_numbers(joint))
    return at_once(function, machine, at_once(assembled, machine), np.asarray(torques, float), *numbers)


def standing_of_assembled(
    machine: JointMachine, without_torque: Pressed, torques: Array, no_slip_friction: Real
) -> StandingOverTorque:
    """The same of a joint that is assembled."""
    return map_over(_stands(machine, without_torque, no_slip_friction), torques)


def _stands(
    machine: JointMachine, without_torque: Pressed, no_slip_friction: Real
) -> Callable[[Array], StandingOverTorque]:
    """The joint that stands under an output torque [N·m]."""
    unloaded = with_its_torque(machine)
    pressed = pressed_at(machine, without_torque)

    def at(torque: Array) -> StandingOverTorque:
        load = dataclasses.replace(unloaded, output_torque=torque)
        laws, rest = pressed(torque)
        state = standing_state(drive=machine.drive, laws=laws, rest=rest, load=load)
        cam = turned_cam(machine, without_torque.rest, rest)
        return _standing(machine, no_slip_friction, state, rest, cam)

    return at


def over_torque_of_assembled(
    machine: JointMachine, without_torque: Pressed, torques: Array, no_slip_friction: Real
) -> OverTorque:
    """As :func:`over_torque`, of a joint that is assembled."""
    states = _states(machine, without_torque)

    def at(torque: Array) -> OverTorque:
        under = states(torque)
        rolls = under.rolling
        turned = turning(machine.under(torque), rolls)
        works = rolls.residual < STATE_TOLERANCE
        return OverTorque(
            **_standing(machine, no_slip_friction, under.standing, under.rest, under.cam)._asdict(),
            drift=_drift(machine, torque, under),
            efficiency=xp.where(works, turned.power.efficiency, xp.nan),
            total_loss=xp.where(works, turned.power.loss, xp.nan),
            life_hours=xp.where(works, turned.life_hours.drive, xp.nan),
            life_turns=xp.where(works, turned.life_turns.drive, xp.nan),
        )

    return map_over(at, torques)


def slope_of_lost_speed(
    machine: JointMachine,
    pressed: Callable[[Array], Pressed],
    unloaded: DriveLoad,
    torque: Array,
) -> tuple[Array, DriveState]:
    """Slope of the lost share of the output speed over the output torque [1/(N·m)], and the state of rolling there.

    nan where there is no steady rolling. ``pressed`` is the assembled joint under a torque; ``unloaded``, that of
    :func:`rolling_with_its_torque`.
    """

    def rolling_at_torque(torque: Array) -> DriveState:
        laws, rest = pressed(torque)
        return loaded_state(
            drive=machine.drive,
            laws=laws,
            rest=rest,
            load=dataclasses.replace(unloaded, output_torque=torque),
            rolls=True,
            creep_of=creep_under(machine),
        )

    rolling, slope = value_and_slope(rolling_at_torque, (torque,), (xp.ones_like(torque),))
    return xp.where(rolling.residual < STATE_TOLERANCE, slope.speed_loss, xp.nan), rolling


def curve_program(joint: Joint, torques: Array, no_slip_friction: Real, shown: str) -> dict[str, Array]:
    """What a measured curve shows of a joint, assembled within the same program; for derivatives by its numbers.

    ``shown``: the name of a stiffness, or ``drift``; with the slip ratio, and whether the joint that stands is solved.
    """
    machine = joint_machine(joint)
    without_torque = assembled(machine)
    states = _states(machine, without_torque) if shown == "drift" else None
    stands = _stands(machine, without_torque, no_slip_friction)

    def at(torque: Array) -> dict[str, Array]:
        if states is None:
            curves = stands(torque)._asdict()
            return {name: curves[name] for name in (shown, "slip_ratio", "solved")}
        under = states(torque)
        solved = under.standing.residual < STATE_TOLERANCE
        drift = _drift(machine, torque, under)
        return {"drift": drift, "slip_ratio": _slip_ratio(machine.contacts, under.standing), "solved": solved}

    return map_over(at, torques)


class _Under(NamedTuple):
    """A joint under a torque: assembled for it, standing, rolling, rolling the other way, and what its cam does."""

    rest: DriveState
    standing: DriveState
    rolling: DriveState
    backwards: DriveState
    cam: CamOfJoint | None


def _states(machine: JointMachine, without_torque: Pressed) -> Callable[[Array], _Under]:
    """The joint under an output torque [N·m]."""
    unloaded = rolling_with_its_torque(machine)
    pressed = pressed_at(machine, without_torque)

    def under(torque: Array) -> _Under:
        laws, rest = pressed(torque)
        load = dataclasses.replace(unloaded, output_torque=torque)
        given: Document = {"drive": machine.drive, "laws": laws, "rest": rest}
        given["creep_of"] = creep_under(machine)
        standing, rolling = loaded_states(load=load, **given)
        backwards = rolling
        # what opposes the rotation changes the forces
        if load.resistance_of is not None or load.bearings is not None:
            other = dataclasses.replace(load, rotation=-_sense(load.rotation))
            backwards = loaded_state(load=other, rolls=True, **given)
        cam = turned_cam(machine, without_torque.rest, rest)
        return _Under(rest, standing, rolling, backwards, cam)

    return under


def _sense(rotation: Real) -> Array:
    """-1 of a drive that rolls backwards, else 1."""
    return xp.where(xp.asarray(rotation) < 0.0, -1.0, 1.0)


def with_its_torque(machine: JointMachine) -> DriveLoad:
    """Loads of a joint that stands and begins to move with its torque, as in a wind-up; the torque is to be put in."""
    return dataclasses.replace(drive_load(machine), standing_rotation=xp.zeros(()))


def rolling_with_its_torque(machine: JointMachine) -> DriveLoad:
    """The same, with what resists the rolling of the joint that turns."""
    return dataclasses.replace(with_its_torque(machine), resistance_of=rolling_load(machine).resistance_of)


def _standing(
    machine: JointMachine,
    no_slip_friction: Real,
    state: DriveState,
    rest: DriveState,
    cam: CamOfJoint | None,
) -> StandingOverTorque:
    """Stiffness of the joint that stands, assembled so at ``rest``, with and without slip."""
    contacts, sense = machine.contacts, driving_sense(machine.drive)
    friction_coefficient = xp.broadcast_to(contacts.pairs.friction_coefficient, sense.shape)
    frictions = xp.stack([friction_coefficient, xp.full_like(friction_coefficient, no_slip_friction)])

    def levels(friction: Array) -> tuple[Array, Array, Array]:
        pairs = dataclasses.replace(contacts.pairs, friction_coefficient=friction)
        stiffness = loaded_stiffness(
            dataclasses.replace(machine, contacts=dataclasses.replace(contacts, pairs=pairs)),
            state.normal,
            sense * state.tangential,
            xp.where(friction == friction_coefficient, state.slides, 0.0),
            pin_loads(state, rest),
        )
        return (
            xp.asarray(stiffness.published.output),
            xp.asarray(stiffness.series_with_bulk.output),
            xp.asarray(with_its_cam(stiffness.assembly, cam).stiffness.output),
        )

    published, series, assembly = vectorised(levels)(frictions)
    return StandingOverTorque(
        balanced=state.worst < STATE_TOLERANCE,
        solved=state.residual < STATE_TOLERANCE,
        slip_ratio=_slip_ratio(contacts, state),
        published=published,
        series_with_bulk=series,
        assembly=assembly,
    )


def _slip_ratio(contacts: JointContacts, state: DriveState) -> Array:
    slip = slip_ratio(
        normal_force=state.normal,
        tangential_force=state.tangential,
        friction_coefficient=contacts.pairs.friction_coefficient,
    )
    return xp.where(state.slides == 0.0, slip, 1.0)


def _drift(machine: JointMachine, torque: Array, under: _Under) -> Array:
    """Drift of the joint that rolls with the torque and against it [rad]."""
    drive, own = machine.drive, _sense(machine.joint.input_speed)
    out = drive.members.index(drive.output)

    def turned(creepage: Array) -> Array:
        return xp.abs(creeping_speeds(drive=drive, creepage=creepage)[0][out])

    senses = own * xp.array([1.0, -1.0])
    creepages = xp.stack([under.rolling.creepage, under.backwards.creepage])
    speed = map_over(turned, xp.concatenate([senses[:, None] * creepages, 0.0 * creepages[:1]]))
    # angle lost in one turn of the output, (B3); negative where the creep runs ahead
    drift = drift_per_turn(1.0 - speed[:2] / speed[2])
    works = xp.stack([under.rolling.residual, under.backwards.residual]) < STATE_TOLERANCE
    with_torque = xp.where(torque < 0.0, -1.0, 1.0)
    one, other = xp.where(works, senses * drift, xp.nan)
    first = senses[0] == with_torque
    return xp.stack([xp.where(first, one, other), xp.where(first, other, one)])
