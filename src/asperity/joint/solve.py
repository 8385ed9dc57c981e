"""Solve one joint, and refuse one that cannot exist or does not hold its torque."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, NamedTuple

import numpy as np

from asperity.body.stepped import WIDEST_BORE
from asperity.drive.layout.existence import refuse_impossible
from asperity.drive.state.state import STATE_TOLERANCE, ContactLaws, DriveState
from asperity.drive.state.states import DriveStates
from asperity.engine import trees
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once
from asperity.engine.module import Module
from asperity.errors import InputError, NoSolutionError
from asperity.joint.assembled import Pressed, assembled
from asperity.joint.bores import overhang, refuse_pins
from asperity.joint.capacity import searched_torques, torque_capacities
from asperity.joint.description import Joint, pin_names, tracks_of
from asperity.joint.evaluation import JointResult, assembled_joint, joint_result, states_under_torque
from asperity.joint.fit import refuse_loose
from asperity.joint.housing import refuse_housing
from asperity.joint.loading_cam import mean_preload
from asperity.joint.machine import JointMachine, joint_machine
from asperity.joint.torque_limits import LIMIT_KINDS, MODEL_LIMITS, TorqueCapacity, limit_words
from asperity.rolling.inlet_heat import FILM_REMEDY, film_unknown_because
from asperity.types import Array, Document
from asperity.units import format_apart, format_quantity

_TRIES = 12  # of a preload that carries a torque
_UNITS = (
    64.0 * np.finfo(float).eps
)  # of the last place, that rounding moves in a balance of a few dozen forces
_SETTLINGS = 4  # of the forces around which the laws of unlike sectors are taken


class Solution(Module):
    """A joint's result beside the torque that it can pass.

    ``result``: forces, contacts, stiffness, diagnostics and rolling; ``laws`` of its contacts, around their forces
    without torque; ``states`` of the drive: assembled, standing and rolling. ``standing_capacity`` and
    ``reverse_standing_capacity``: largest positive and largest negative output torque, standing [N·m], and what limits
    them; ``rolling_capacity`` and ``reverse_rolling_capacity``, the same in rolling; ``first_slip`` and
    ``reverse_first_slip``: output torques at which the first contact slides while the joint stands, likewise. None of
    them knows the limits of damage, which :mod:`asperity.results.torque_capacity` does.
    """

    result: JointResult
    laws: ContactLaws
    states: DriveStates
    standing_capacity: TorqueCapacity
    reverse_standing_capacity: TorqueCapacity
    rolling_capacity: TorqueCapacity
    reverse_rolling_capacity: TorqueCapacity
    first_slip: TorqueCapacity
    reverse_first_slip: TorqueCapacity


def solution_of(joint: Joint) -> Solution:
    """Everything about one joint, of NumPy's numbers, without a judgement whether it exists."""
    machine, without_torque, states = _states(joint)
    result = at_once(joint_result, machine, without_torque.laws, states)
    capacities = torque_capacities(machine, without_torque)
    both = [trees.map(lambda leaf, i=i: leaf[i], part) for part in capacities for i in range(2)]
    return Solution(result, without_torque.laws, states, *both)


def joint_state(joint: Joint) -> JointResult:
    """What one joint does under its own torque and speed, of NumPy's numbers, without its capacities."""
    machine, without_torque, states = _states(joint)
    result: JointResult = at_once(joint_result, machine, without_torque.laws, states)
    return result


class DirectedLimits(NamedTuple):
    """Torque capacities of a joint in the direction of its torque, as of :class:`Solution`."""

    standing: TorqueCapacity
    rolling: TorqueCapacity
    first_slip: TorqueCapacity


def states_and_limits(joint: Joint) -> tuple[DriveStates, DirectedLimits]:
    """States of one joint, of NumPy's numbers, and its capacities in the direction of its torque; nothing else."""
    machine, without_torque, states = _states(joint)
    place = int(float(joint.output_torque) < 0.0)
    limits = torque_capacities(machine, without_torque)
    return states, DirectedLimits(*(trees.map(lambda leaf: leaf[place], each) for each in limits))


def _states(joint: Joint) -> tuple[JointMachine, Pressed, DriveStates]:
    """The machine that a joint is, assembled, and its states under its torque."""
    machine: JointMachine = at_once(joint_machine, joint)
    without_torque: Pressed = at_once(assembled, machine)
    states: DriveStates = at_once(states_under_torque, machine, without_torque)
    reach = float(np.max(np.abs(machine.contacts.pairs.radius_1)))
    pressed = None if states.pressed is None else without_rounding(states.pressed, reach)
    rest, standing, rolling = (without_rounding(state, reach) for state in states[:3])
    return machine, without_torque, DriveStates(rest, standing, rolling, pressed)


def without_rounding(state: DriveState, reach: float) -> DriveState:
    """A state of one drive in which what only rounding has left of 0 is 0.

    Forces are balanced with the largest normal force, torques with that force at the ``reach`` of the tracks [m]:
    below 64 units in its last place they are the rounding of the balance. Creepages and the loss of speed are
    differences of speeds over these speeds, and rounding below as many units in the last place of 1.
    """
    force = _UNITS * float(np.max(np.abs(state.normal)))
    return dataclasses.replace(
        state,
        **{name: _above(getattr(state, name), force) for name in ("tangential", "pin_force")},
        **{name: _above(getattr(state, name), _UNITS) for name in ("creepage", "speed_loss")},
        input_torque=_above(state.input_torque, force * reach),
    )


def _above(values: Array, rounding: float) -> Array:
    """The values, those of the size of rounding as 0."""
    numbers = np.asarray(values)
    return xp.where(np.abs(numbers) <= rounding, 0.0, numbers)


def solve_joint(joint: Joint) -> Solution:
    """Solve one joint.

    Parameters
    ----------
    joint : Joint
        One joint.

    Returns
    -------
    Solution
        Its result, with leaves as NumPy arrays, and its torque capacity.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the torque capacity; with the numbers.
    NoSolutionError
        If no balance was found.
    """
    numbers = refuse_impossible_joint(joint)
    solution = solution_of(numbers)
    _refuse_unsolved(numbers, solution)
    return solution


def refuse_impossible_joint(joint: Joint) -> Joint:
    """The joint with NumPy's numbers, unless its parts do not fit."""
    joint = as_numbers(joint)
    refuse_impossible(joint.drive)
    refuse_housing(joint)  # first: what temperature does to the fit is not known without it
    refuse_loose(joint.fit)
    refuse_pins(joint)
    refuse_bores(joint)
    refuse_short_pins(joint)
    return joint


def refuse_bores(joint: Joint) -> None:
    """Refuse a hollow roller without a wall, and a stepped one with a wall too thin to be computed."""
    for number, (body, shape) in enumerate(zip(joint.drive.bodies, joint.shapes, strict=True)):
        if shape.bore_diameter is None:
            continue
        bore, widest = float(shape.bore_diameter), 2.0 * min(float(r) for r, _ in tracks_of(joint, number))
        told = f"the bore of {body.name}, {format_apart(bore, widest, 'mm')[0]}, "
        if bore >= widest:
            raise InputError(
                f"{told}leaves no wall in a roller of {format_quantity(widest, 'mm')}; make the bore smaller"
            )
        if len(tracks_of(joint, number)) > 1 and joint.body_model == "exact" and bore > WIDEST_BORE * widest:
            raise InputError(
                f"{told}is wider than {WIDEST_BORE} of the diameter of its smaller track, "
                f"{format_quantity(WIDEST_BORE * widest, 'mm')}: beyond it the compliance of a stepped roller is not "
                "known; make the bore smaller"
            )


def refuse_short_pins(joint: Joint) -> None:
    """Refuse pins that are shorter than their rollers."""
    if joint.pin is None:
        return
    free = float(joint.pin.free_length)
    for name, share in zip(pin_names(joint.drive), np.asarray(overhang(joint)), strict=True):
        if share > 1.0:
            raise InputError(
                f"the pins have a free length of {format_quantity(free, 'mm')}, less than the "
                f"{format_quantity(share * free, 'mm')} of {name}: lengthen the pins (bearings.pin_length)"
            )


def _given(joint: Joint) -> str:
    """What presses the contacts of a joint, as its file states it."""
    if joint.interference is None:
        return f"a preload of {format_quantity(float(np.asarray(joint.preload)), 'N')}"
    given = f"an interference of {format_quantity(float(joint.interference), 'um')}"
    if joint.fit is None:
        return given
    warm = format_quantity(float(joint.fit.working_temperature), "degC")
    return f"{given} at the assembly and a working temperature of {warm}"


def _refuse_unsolved(joint: Joint, solution: Solution) -> None:
    result, torque = solution.result, float(joint.output_torque)
    capacity = solution.reverse_standing_capacity if torque < 0.0 else solution.standing_capacity
    limit, kind = float(capacity.output_torque), LIMIT_KINDS[int(capacity.limit)]
    if (
        _is_pressed(result.rest)
        and joint.cam is not None
        and kind in MODEL_LIMITS
        and abs(torque) >= limit > 0.0
    ):
        raise InputError(_beyond_what_is_computed(joint, solution, capacity))
    refuse_not_pressed(joint, result.rest, result.pressed)
    refuse_short_contacts(result)
    if not bool(result.walls_hold):
        raise InputError(
            "a ring or a hollow roller has a wall thinner than five half-widths of its contacts or about 2 % of its "
            "radius, for which its compliance is not known; make the wall thicker"
        )
    if bool(result.solved) and (abs(torque) < limit or kind == "no_solution"):
        return
    if bool(result.solved) or (math.isfinite(limit) and abs(torque) >= limit):
        words = limit_words(capacity, contacts=result.contact_names)
        remedy = f"raise {_press_words(joint)}, or lower the speed"
        if limit > 0.0:
            pressed = _press_that_carries(joint, torque)
            change = "" if pressed else f"{_press_words(joint)}, "
            remedy = f"lower the torque{pressed}, or change {change}friction coefficient or contact lengths"
        shown, most = format_apart(torque, math.copysign(limit, torque), "N*m")
        raise InputError(
            f"the output torque {shown} is beyond the standing torque capacity {most}, at which {words}; {remedy}"
        )
    residual = float(result.forces.balance_residual)
    left = f" (residual {residual:.3g})" if math.isfinite(residual) else ""
    raise NoSolutionError(
        f"no balance under {format_quantity(torque, 'N*m')} was found{left}; lower the torque or the speed"
    )


def _press_words(joint: Joint) -> str:
    """What presses the contacts of a joint without torque, with its key in the joint file."""
    key = "preload" if joint.interference is None else "interference"
    return f"the {key} (load.{key})"


def _press_that_carries(joint: Joint, torque: float) -> str:
    """The preload or interference that carries a torque, in words; "" where none is known.

    It is scaled by the missing share of the capacity to a thousandth, rounded up to three digits, and tried; from the
    second trial on by the line through the last two, since temperature and sizes add to an interference.
    """
    key, unit = ("preload", "N") if joint.interference is None else ("interference", "um")
    size, tried = float(np.asarray(getattr(joint, key))), list[tuple[float, float]]()
    for _ in range(_TRIES):
        if not 0.0 < size < math.inf:
            return ""
        step = 10.0 ** (math.floor(math.log10(size)) - 2)
        rounded = step * math.ceil(size / step - 1e-9)
        capacity = _standing_capacity(_pressed_with(joint, key, rounded), -1.0 if torque < 0.0 else 1.0)
        limit = float(capacity.output_torque)
        if LIMIT_KINDS[int(capacity.limit)] not in ("gross_slip", "lift_off", "none") or not limit > 0.0:
            return ""
        if abs(torque) < limit < 1.01 * abs(torque) + step / size * limit:
            return f", raise {_press_words(joint)} to {format_quantity(rounded, unit)}"
        tried.append((rounded, limit))
        size = _next_size(tried, abs(torque) * (1.0 + 1e-3))
    return ""


def _next_size(tried: list[tuple[float, float]], torque: float) -> float:
    """The size at which a capacity that grows as it does between the last trials is that torque [N·m]."""
    (size, limit), before = tried[-1], tried[-2:-1]
    for other, smaller in before:
        slope = (limit - smaller) / (size - other) if size != other else 0.0
        if slope > 0.0:
            return size + (torque - limit) / slope
    return size * torque / limit


def _pressed_with(joint: Joint, key: str, size: float) -> Joint:
    """The same joint with another preload [N] or interference [m], of unlike sectors with the forces that it makes."""
    changes: Document = {key: np.asarray(size)}
    if joint.fit is not None:
        scaled: Any = joint.fit.interference * (size / np.asarray(joint.interference))
        changes["fit"] = dataclasses.replace(joint.fit, interference=scaled)
    joint = dataclasses.replace(joint, **changes)
    unlike = joint.unlike
    for _ in range(0 if unlike is None else _SETTLINGS):
        assert unlike is not None
        rest = at_once(assembled_joint, joint).rest
        unlike = dataclasses.replace(unlike, reference_force=rest.normal)
        joint = trees.map(np.asarray, dataclasses.replace(joint, unlike=unlike))
    return joint


def _standing_capacity(joint: Joint, direction: float) -> TorqueCapacity:
    """Capacity of one joint, standing, in one direction, 1 or −1."""
    machine: JointMachine = at_once(joint_machine, joint)
    found = searched_torques(
        machine,
        at_once(assembled, machine),
        direction=np.array([direction]),
        rolls=False,
        holds=np.array([False]),
    )
    capacity: TorqueCapacity = trees.map(lambda leaf: leaf[0], found)
    return capacity


def refuse_not_pressed(joint: Joint, *assembled: DriveState) -> None:
    """Refuse a joint, in its states without torque, of which a contact is not pressed."""
    if not all(map(_is_pressed, assembled)):
        raise NoSolutionError(
            f"with {_given(joint)} no state was found in which every contact of the assembled drive is pressed; "
            f"check this value, the radii and the walls{_thinnest_wall(joint)}"
        )


def _thinnest_wall(joint: Joint) -> str:
    """Which hollow roller has the thinnest wall for its size, and its bore; empty if none is hollow."""
    shares = {}
    for number, (body, shape) in enumerate(zip(joint.drive.bodies, joint.shapes, strict=True)):
        if shape.bore_diameter is not None:
            bore, widest = (
                float(shape.bore_diameter),
                2.0 * min(float(r) for r, _ in tracks_of(joint, number)),
            )
            shown = format_apart(bore, widest, "mm")
            wall = format_quantity(0.5 * (widest - bore), "um")
            shares[bore / widest] = (
                f"{body.name}: its bore_diameter of {shown[0]} leaves {wall} of {shown[1]}"
            )
    return f"; the thinnest wall is that of {shares[max(shares)]}" if shares else ""


def _is_pressed(state: DriveState) -> bool:
    return float(state.worst) < STATE_TOLERANCE and bool(np.all(np.asarray(state.normal) > 0.0))


def _beyond_what_is_computed(joint: Joint, solution: Solution, capacity: TorqueCapacity) -> str:
    """Why a joint is not computed that its cam presses too much, and what to change."""
    assert joint.cam is not None
    torque, limit = float(joint.output_torque), float(capacity.output_torque)
    cam = float(joint.cam.force_per_torque)
    least = float(mean_preload(joint, solution.result.rest.normal))
    shown = format_apart(torque, math.copysign(limit, torque), "N*m")
    forces = [format_quantity(least + cam * abs(moment), "N") for moment in (torque, limit)]
    return (
        f"under the output torque {shown[0]} the loading cam presses with {forces[0]}; the joint is computed up to "
        f"{forces[1]}, at {shown[1]}, where {limit_words(capacity, contacts=solution.result.contact_names)}; lower the "
        "torque or load.cam_force_per_torque, or choose longer contacts or a thicker wall"
    )


def refuse_no_rolling(joint: Joint, solution: Solution) -> None:
    """Refuse a joint that stands but has no steady rolling state."""
    if np.isfinite(np.asarray(solution.result.rolling.residual)):
        return
    if not bool(solution.result.contact_law_holds):
        raise NoSolutionError(
            "no creep: every spot of a contact is plastic, where the contact law gives it no stiffness; raise "
            "fractal_dimension or hardness, or lower fractal_roughness"
        )
    no_film = film_unknown_because(solution.result.contact_names, solution.result.inlet_heat_factor)
    if no_film is not None:
        raise NoSolutionError(f"no steady rolling: {no_film}; {FILM_REMEDY}")
    torque = float(joint.output_torque)
    capacity = solution.reverse_rolling_capacity if torque < 0.0 else solution.rolling_capacity
    shown, most = format_apart(torque, math.copysign(float(capacity.output_torque), torque), "N*m")
    raise NoSolutionError(
        f"no steady rolling under {shown}: the joint rolls up to {most}, at which "
        f"{limit_words(capacity, contacts=solution.result.contact_names)}; lower the torque"
        f"{'' if joint.rolling.skew is None else ' or the skew'}, or raise {_press_words(joint)} or the friction "
        "coefficient"
    )


def refuse_short_contacts(result: JointResult) -> None:
    """Refuse crowned contacts that are too short for their width."""
    holds = result.diagnostics.slices_hold
    if holds is None or np.all(np.asarray(holds)):
        return
    first = int(np.argmin(np.asarray(holds)))
    width = 2.0 * float(np.asarray(result.diagnostics.hertz_half_width)[first])
    ratio = float(np.asarray(result.diagnostics.loaded_length_over_width)[first])
    length, across = (format_quantity(size, "mm", 3) for size in (ratio * width, width))
    raise InputError(
        f"the crowned rollers touch at {result.contact_names[first]} over a length of {length} and a width of "
        f"{across}: the slices need a contact at least twice as long as wide; choose a larger crown radius"
    )
