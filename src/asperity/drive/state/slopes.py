"""Slopes of the equations of a state by their unknowns, from the directions of the contacts, and steps with them.

The forces of the contacts are eliminated one by one; what remains has the displacements, the rotations, the pins and
the interference as unknowns.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive, sectors_of_members
from asperity.drive.state.bores import PressedBores
from asperity.drive.state.equations import (
    ASSEMBLED,
    ROLLING,
    STANDING,
    Machine,
    Responses,
    Task,
    Unknowns,
    change_of_normal,
    contact_forces,
    contact_responses,
    moments_of,
    numbers_of_pairs,
    preload_weights,
    speeds_and_turns,
    turning_members,
)
from asperity.drive.state.loads import drag_pairs, resistance_levers
from asperity.drive.state.state import Resistance
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import fori_loop, put
from asperity.engine.derivatives import jacobian, value_and_slopes
from asperity.linear import product
from asperity.types import Array


class Slopes(NamedTuple):
    """Slopes of the equations in blocks; those of the contacts first, then those of the structure.

    The structure's unknowns are the displacements, turns, pins and interference, its equations the balances of forces
    and moments, the pins and the size. ``approach``: of the approaches by the normal forces, shape (contacts,
    contacts), or (contacts,) where each contact deforms under its own force only; ``held_normal`` and
    ``held_tangential``: of the slips or creeps by the forces, shape (contacts, contacts); ``approach_moves`` and
    ``held_moves``: of both by the structure's unknowns, shape (contacts, structure). ``normal``, ``tangential`` and
    ``structure``: of the structure's equations by the forces of the contacts, shape (structure, contacts), and by its
    unknowns, shape (structure, structure).
    """

    approach: Array
    held_normal: Array
    held_tangential: Array
    approach_moves: Array
    held_moves: Array
    normal: Array
    tangential: Array
    structure: Array


class _HeldRows(NamedTuple):
    """Slopes of slips or creeps by the forces of the contacts and by the structure, shape (contacts, ...)."""

    normal: Array
    tangential: Array
    displacement: Array
    turn: Array
    pin: Array


class ResponsesAndSlopes(NamedTuple):
    """What the contacts do under their forces, and its slopes by the normal and by the tangential forces."""

    value: Responses
    by_normal: Responses
    by_tangential: Responses


def responses_and_slopes(machine: Machine, task: Task, x: Unknowns) -> ResponsesAndSlopes:
    """Of :func:`asperity.drive.state.equations.contact_responses`."""
    forces, none = contact_forces(machine, x), xp.zeros_like(x.normal)
    one = none + 1.0
    value, slopes = value_and_slopes(
        functools.partial(contact_responses, machine, task), forces, [(one, none), (none, one)]
    )
    return ResponsesAndSlopes(value, *slopes)


def state_slopes(
    machine: Machine,
    task: Task,
    pressed_sectors: int,
    slides: Array,
    x: Unknowns,
    responses: ResponsesAndSlopes,
) -> Slopes:
    """Slopes of :func:`asperity.drive.state.equations.state_misfits`."""
    reference, limit = machine.laws.reference_force, machine.friction * machine.laws.reference_force
    largest, matrices, count = machine.largest, machine.matrices, x.normal.size
    turning = matrices.turning[:, turning_members(machine.drive)]
    turns = turning.shape[1]
    assembled = xp.asarray(task.kind) == ASSEMBLED
    pressed = _pressed(machine, x)
    approach_pins, slip_pins = _by_pins(machine, x, pressed)
    held = _held_rows(machine, task, x, slip_pins, responses)
    if len(numbers_of_pairs(machine.drive)):
        held = _with_equal_coefficients(machine, task, x, held)
    sliding = _HeldRows(-_diagonal(slides), xp.eye(count), *(xp.zeros_like(rows) for rows in held[2:]))
    held = _in_rows((slides != 0.0) | assembled, sliding, held)
    pins_by_normal, pins_by_tangential = _pins_by_contacts(machine, task, x, pressed)
    moments = -turning.T * _moment_scale(machine)[:, None] * limit / (machine.lever * largest)
    preload = preload_weights(count, pressed_sectors) * reference
    resisting = [
        _by_resistance(machine, task, slopes.resistance)
        for slopes in (responses.by_normal, responses.by_tangential)
    ]
    (forces, resisted), (forces_along, resisted_along) = resisting
    if machine.hills is not None:
        rows, loaded = turning_members(machine.drive), xp.where(assembled, 0.0, 1.0)
        resisted = resisted + loaded * machine.hills.normal[rows]
        resisted_along = resisted_along + loaded * machine.hills.tangential[rows]
    return Slopes(
        approach=_approaches(machine, responses.by_normal.approach),
        held_normal=held.normal,
        held_tangential=held.tangential,
        approach_moves=xp.concatenate(
            [-matrices.approach, xp.zeros((count, turns)), approach_pins, -machine.pattern[:, None]], axis=1
        ),
        held_moves=xp.concatenate([*held[2:], xp.zeros((count, 1))], axis=1),
        normal=xp.concatenate(
            [
                (matrices.approach.T + forces) * reference / largest,
                resisted * reference / (machine.lever * largest),
                pins_by_normal,
                xp.where(assembled, preload / largest, 0.0)[None],
            ]
        ),
        tangential=xp.concatenate(
            [
                (matrices.sliding.T + forces_along) * limit / largest,
                xp.where(assembled, 0.0, moments + resisted_along * limit / (machine.lever * largest)),
                pins_by_tangential,
                xp.zeros((1, count)),
            ]
        ),
        structure=_of_structure(machine, task, pressed_sectors, x, pressed),
    )


def _by_resistance(machine: Machine, task: Task, slopes: Resistance) -> tuple[Array, Array]:
    """Slopes of the balances of forces and moments by forces of the contacts, through what resists their rolling."""
    drive, matrices = machine.drive, machine.matrices
    members = turning_members(drive)
    if task.load.resistance_of is None:
        return xp.zeros(matrices.sliding.T.shape), xp.zeros((members.size, slopes.drag.size))
    moments = [lever[members] * slope for lever, slope in zip(resistance_levers(drive), slopes, strict=True)]
    return matrices.sliding.T * drag_pairs(drive, slopes.drag), moments[0] + moments[1] + moments[2]


def _approaches(machine: Machine, slope: Array) -> Array:
    """Slopes of the approaches by the own normal force, and by those of the others where bodies bend."""
    laws = machine.laws
    if laws.coupling is not None:
        slope = _diagonal(slope) + laws.coupling
    return slope * laws.reference_force / machine.length


def _pressed(machine: Machine, x: Unknowns) -> PressedBores | None:
    """Pins in their bores; None where none presses in one."""
    if machine.laws.bores is None:
        return None
    force = x.pin[: len(machine.drive.pinned)] * machine.largest
    return machine.laws.bores.under(force, machine.largest)


def _by_pins(machine: Machine, x: Unknowns, pressed: PressedBores | None) -> tuple[Array, Array]:
    """Slopes of approaches and slips by the forces of pins in bores and of supports, shape (contacts, pins)."""
    count, bores = len(machine.drive.pinned), machine.laws.bores
    if bores is None or pressed is None:
        return (xp.zeros((x.normal.size, x.pin.size)),) * 2
    approach, slip = (
        xp.pad(slope, ((0, 0), (0, x.pin.size - count))) * machine.largest / machine.length
        for slope in bores.by_pin(pressed)
    )
    return approach, slip


def _held_rows(
    machine: Machine, task: Task, x: Unknowns, slip_pins: Array, responses: ResponsesAndSlopes
) -> _HeldRows:
    """Slopes of the slip while the drive stands, of creep times rolled length while it rolls."""
    laws, matrices = machine.laws, machine.matrices
    stands, rolls = xp.asarray(task.kind) == STANDING, xp.asarray(task.kind) == ROLLING
    speed, _ = speeds_and_turns(machine, x, task.kind)
    one, two = _rolled_by_speeds(machine.drive, speed)
    rolled_by = 0.5 * (one + two)
    backwards = xp.where(xp.asarray(task.load.rotation) < 0.0, -1.0, 1.0)
    rolled = backwards * product(rolled_by, speed)
    scale = xp.where(rolls, 1e3 / machine.lever, 1.0 / machine.length)
    by_normal, by_tangential = (
        _diagonal(xp.where(rolls, slope.creepage * rolled, slope.slip) * force * scale)
        for slope, force in (
            (responses.by_normal, laws.reference_force),
            (responses.by_tangential, machine.friction * laws.reference_force),
        )
    )
    members = turning_members(machine.drive)
    turning = matrices.turning[:, members]
    rolling_turns = (backwards * responses.value.creepage[:, None] * rolled_by[:, members] - turning) * scale
    return _HeldRows(
        normal=by_normal,
        tangential=by_tangential,
        displacement=xp.where(stands, -matrices.sliding, 0.0),
        turn=xp.where(rolls, rolling_turns, -turning / machine.lever),
        pin=xp.where(stands, slip_pins, 0.0),
    )


def _with_equal_coefficients(machine: Machine, task: Task, x: Unknowns, held: _HeldRows) -> _HeldRows:
    """Rows of a standing drive in which the second contact of each pair has the traction coefficient of the first."""
    first, second = numbers_of_pairs(machine.drive).T
    ratio = machine.friction[first] / machine.friction[second]
    none = trees.map(xp.zeros_like, held)
    by_normal = put(none.normal, (second, first), x.tangential[second])
    by_tangential = put(none.tangential, (second, first), -ratio * x.normal[second])
    equal = none._replace(
        normal=put(by_normal, (second, second), -ratio * x.tangential[first]),
        tangential=put(by_tangential, (second, second), x.normal[first]),
    )
    is_second = xp.asarray(np.isin(np.arange(x.normal.size), second))
    return _in_rows(is_second & (xp.asarray(task.kind) == STANDING), equal, held)


def _in_rows(where: Array, chosen: _HeldRows, held: _HeldRows) -> _HeldRows:
    """Rows of one kind at some contacts, of another at the others."""
    return trees.map(lambda one, other: xp.where(where[:, None], one, other), chosen, held)


def _moment_scale(machine: Machine) -> Array:
    """Copies of each turning member in the drive; none of the carrier, on which contacts have no moment."""
    members = turning_members(machine.drive)
    carrier = members == machine.drive.layout.carrier
    return xp.where(carrier, 0.0, sectors_of_members(machine.drive)[members])


def _of_structure(
    machine: Machine, task: Task, pressed_sectors: int, x: Unknowns, pressed: PressedBores | None
) -> Array:
    """Slopes of the balances, the pins and the size by the structure."""
    load, assembled = task.load, xp.asarray(task.kind) == ASSEMBLED
    members = turning_members(machine.drive)
    moved, turns, pins = x.displacement.size, members.size, x.pin.size
    supports = xp.zeros((moved, moved))
    if load.support_stiffness is not None:
        supports = _diagonal(xp.repeat(load.support_stiffness, 2)) * machine.length / machine.largest
    forces = contact_forces(machine, x)
    by_pins = jacobian(
        lambda pin: moments_of(machine, task, forces, pin, None)[members], x.pin * machine.largest
    )
    pin_rows, pin_slopes = _of_pins(machine, task, x, pressed)
    size = xp.where(assembled & (pressed_sectors > 0), 0.0, 1.0).reshape(1, 1)
    return xp.block(
        [
            [supports, xp.zeros((moved, turns)), machine.matrices.pins.T, xp.zeros((moved, 1))],
            [
                xp.zeros((turns, moved)),
                xp.where(assembled, np.eye(turns), 0.0),
                xp.where(assembled, 0.0, by_pins / machine.lever),
                xp.zeros((turns, 1)),
            ],
            [pin_rows, xp.zeros((pins, turns)), _diagonal(pin_slopes), xp.zeros((pins, 1))],
            [xp.zeros((1, moved + turns + pins)), size],
        ]
    )


def newton_step(slopes: Slopes, residual: Unknowns, solver: Callable[[Array, Array], Array]) -> Unknowns:
    r"""Solve :math:`J s = r` for the step of all unknowns, the forces of the contacts eliminated."""
    # forces as functions of the structure, and without it: apart, so that the step is linear in the residual
    if slopes.approach.ndim > 1:
        inverse = _inverse(slopes.approach)
        normal = -inverse @ slopes.approach_moves
        alone = product(inverse, residual.normal)
    else:
        normal = -slopes.approach_moves / slopes.approach[:, None]
        alone = residual.normal / slopes.approach
    tangential = _triangular(slopes.held_tangential, -slopes.held_moves - slopes.held_normal @ normal)
    held = residual.tangential - product(slopes.held_normal, alone)
    held = _triangular(slopes.held_tangential, held[:, None])[:, 0]
    rest = xp.concatenate([residual.displacement, residual.turn, residual.pin, residual.interference])
    structural_step = solver(
        slopes.structure + slopes.normal @ normal + slopes.tangential @ tangential,
        rest - product(slopes.normal, alone) - product(slopes.tangential, held),
    )
    ends = np.cumsum([residual.displacement.size, residual.turn.size, residual.pin.size])
    displacement, turn, pin, interference = xp.split(structural_step, ends)
    return Unknowns(
        normal=product(normal, structural_step) + alone,
        tangential=product(tangential, structural_step) + held,
        pin=pin,
        displacement=displacement,
        turn=turn,
        interference=interference,
    )


def _pins_by_contacts(
    machine: Machine, task: Task, x: Unknowns, pressed: PressedBores | None
) -> tuple[Array, Array]:
    """Slopes of the equations of pins and supports by normal and tangential forces, shape (pins, contacts)."""
    drive, laws, none = machine.drive, machine.laws, xp.zeros((x.pin.size, x.normal.size))
    if laws.bores is None or pressed is None:
        return none, none
    assembled, count = xp.asarray(task.kind) == ASSEMBLED, len(drive.pinned)
    normal, tangential = laws.bores.by_pin(pressed)
    normal = xp.where(assembled, laws.bores.along_normal, normal)
    moves = xp.where(_kept(machine, task), 0.0, 1.0 / machine.length)[:, None]
    reference = laws.reference_force
    return (
        put(none, np.s_[:count], -moves * normal.T * reference),
        put(none, np.s_[:count], -moves * tangential.T * machine.friction * reference),
    )


def _kept(machine: Machine, task: Task) -> Array:
    """Pins whose forces stay those without torque, shape (pins,)."""
    drive = machine.drive
    kept = np.array(
        [drive.bodies[body].name in drive.closure.constant_pins for body in drive.pinned], dtype=bool
    )
    return xp.asarray(kept) & (xp.asarray(task.kind) != ASSEMBLED)


def _of_pins(machine: Machine, task: Task, x: Unknowns, pressed: PressedBores | None) -> tuple[Array, Array]:
    """Slopes of the equations of pins and supports by the displacements, and each by its own force."""
    drive, load = machine.drive, task.load
    count, loaded = len(drive.pinned), xp.asarray(task.kind) != ASSEMBLED
    constant = _kept(machine, task)
    compliance: Array = xp.broadcast_to(load.pin_compliance, (count,))
    if machine.laws.bores is not None and pressed is not None:
        bores, (normal, tangential) = machine.laws.bores, contact_forces(machine, x)
        compliance = compliance + bores.pin_slope(pressed, change_of_normal(task, normal), tangential)
    soft = compliance * machine.largest / machine.length
    rows = xp.where(constant[:, None], 0.0, machine.matrices.pins[:count])
    slopes = xp.where(constant, 1.0, -soft)
    if load.supports is None:
        return rows, slopes
    beside = -load.supports.compliance * machine.largest / machine.length
    return (
        xp.concatenate([rows, xp.where(loaded, load.supports.direction, 0.0)]),
        xp.concatenate([slopes, xp.where(loaded, beside, 1.0)]),
    )


def _rolled_by_speeds(drive: Drive, speed: Array) -> tuple[Array, Array]:
    """Slopes of the surface speeds of the contacts by the speeds of the members, shape (contacts, members) [m]."""
    layout, sides = drive.layout, []
    for bodies, radius in ((layout.first, drive.first_radius), (layout.second, drive.second_radius)):
        rows = layout.relative[bodies]
        sides.append((radius * xp.sign(product(rows, speed)))[:, None] * rows)
    return sides[0], sides[1]


def _diagonal(values: Array) -> Array:
    """A diagonal matrix, shape (n, n)."""
    return values[:, None] * np.eye(values.size)


def _triangular(matrix: Array, columns: Array) -> Array:
    """Solve for contacts each of which depends on itself, and perhaps on one that depends on itself only."""
    diagonal = xp.diagonal(matrix)
    beside = matrix - _diagonal(diagonal)
    uncoupled = columns / diagonal[:, None]
    return uncoupled - beside @ uncoupled / diagonal[:, None]


def _inverse(matrix: Array) -> Array:
    """Inverse by elimination without exchange of rows: every diagonal element is the largest of its row."""
    rows = np.arange(matrix.shape[0])

    def without_column(k: Array, table: Array) -> Array:
        row = table[k] / table[k, k]
        return xp.where((rows == k)[:, None], row, table - table[:, k, None] * row)

    table = fori_loop(0, rows.size, without_column, xp.concatenate([matrix, np.eye(rows.size)], axis=1))
    return table[:, rows.size :]
