"""Slopes of the equations of a state by their unknowns, from the directions of the contacts, and steps with them.

The forces of the contacts are eliminated one by one; what remains has the displacements, the rotations, the pins and
the interference as unknowns.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.layout.drive import CARRIER, Drive, sectors_of_members
from asperity.drive.state.bores import sides
from asperity.drive.state.creep import creepages
from asperity.drive.state.equations import (
    ASSEMBLED,
    ROLLING,
    STANDING,
    Machine,
    Task,
    Unknowns,
    change_of_normal,
    contact_forces,
    moments_of,
    numbers_of_pairs,
    speeds_and_turns,
    turning_members,
)
from asperity.drive.state.state import contact_approach, slip_at_rest
from asperity.linear import product


class Slopes(NamedTuple):
    """Slopes of the equations in blocks; those of the contacts first, then those of the structure.

    The structure's unknowns are the displacements, turns, pins and interference, its equations the balances of forces
    and moments, the pins and the size.

    Parameters
    ----------
    approach : Array
        Of the approaches by the normal forces, shape (contacts, contacts), or (contacts,) where each contact deforms
        under its own force only.
    held_normal, held_tangential : Array
        Of the slips or creeps by the normal and the tangential forces, shape (contacts, contacts).
    approach_moves, held_moves : Array
        Of both by the structure, shape (contacts, structure).
    normal, tangential : Array
        Of the equations of the structure by the forces of the contacts, shape (structure, contacts).
    structure : Array
        Of them by the structure, shape (structure, structure).
    """

    approach: Array
    held_normal: Array
    held_tangential: Array
    approach_moves: Array
    held_moves: Array
    normal: Array
    tangential: Array
    structure: Array


def state_slopes(machine: Machine, task: Task, by_force: bool, slides: Array, x: Unknowns) -> Slopes:
    """Slopes of :func:`asperity.drive.state.equations.state_misfits`."""
    drive, laws, matrices = machine.drive, machine.laws, machine.matrices
    length, largest, lever = machine.length, machine.largest, machine.lever
    reference, limit = laws.reference_force, machine.friction * laws.reference_force
    normal, tangential = contact_forces(machine, x)
    kind = jnp.asarray(task.kind)
    stands, rolls, assembled = kind == STANDING, kind == ROLLING, kind == ASSEMBLED
    ones, none = jnp.ones_like(normal), jnp.zeros_like(normal)

    def by(law: Callable[[Array, Array], Array], tangents: tuple[Array, Array]) -> tuple[Array, Array]:
        value, slope = jax.jvp(law, (normal, tangential), tangents)
        return value, slope

    # approaches: each by its own force, and by those of the others where bodies bend
    own = laws if laws.coupling is None else dataclasses.replace(laws, coupling=None)
    _, approach = jax.jvp(lambda force: contact_approach(laws=own, normal=force), (normal,), (ones,))
    if laws.coupling is not None:
        approach = _diagonal(approach) + laws.coupling
    approach = approach * reference / length

    # slip at rest, or creep times rolled length
    def slip(force: Array, friction: Array) -> Array:
        return slip_at_rest(laws=laws, normal=force, tangential=friction)

    def creep(force: Array, friction: Array) -> Array:
        return creepages(law=laws.creep, normal=force, tangential=friction)

    slip_normal, slip_tangential = by(slip, (ones, none))[1], by(slip, (none, ones))[1]
    (share, creep_normal), creep_tangential = by(creep, (ones, none)), by(creep, (none, ones))[1]
    speed, _ = speeds_and_turns(machine, x, task.kind)
    one, two = _rolled_by_speeds(drive, speed)
    rolled_by = 0.5 * (one + two)
    backwards = jnp.where(jnp.asarray(task.load.rotation) < 0.0, -1.0, 1.0)
    rolled = backwards * product(rolled_by, speed)
    scale = jnp.where(rolls, 1e3 / lever, 1.0 / length)
    held_normal = _diagonal(jnp.where(rolls, creep_normal * rolled, slip_normal) * reference * scale)
    held_tangential = _diagonal(jnp.where(rolls, creep_tangential * rolled, slip_tangential) * limit * scale)
    members = np.array(turning_members(drive), dtype=int)
    turning = matrices.turning[:, members]
    rolling_turns = (backwards * share[:, None] * rolled_by[:, members] - turning) * scale
    held_displacement = jnp.where(stands, -matrices.sliding, 0.0)
    pins = x.pin.size
    approach_pins = held_pins = jnp.zeros((ones.size, pins))
    if laws.bores is not None:
        wider = ((0, 0), (0, pins - len(drive.pinned)))
        force = x.pin[: len(drive.pinned)] * largest
        approach_pins, held_pins = (
            jnp.pad(each, wider) * largest / length for each in laws.bores.by_pin(sides(force, largest)[0])
        )
        held_pins = jnp.where(stands, held_pins, 0.0)
    held_turns = jnp.where(rolls, rolling_turns, -turning / lever)
    paired = numbers_of_pairs(drive)
    if len(paired):
        first, second = paired.T
        ratio = machine.friction[first] / machine.friction[second]
        at = np.arange(ones.size)
        is_second = np.isin(at, second)[:, None] & stands
        held_normal = jnp.where(is_second, 0.0, held_normal)
        held_normal = held_normal.at[second, first].add(jnp.where(stands, x.tangential[second], 0.0))
        held_normal = held_normal.at[second, second].add(jnp.where(stands, -ratio * x.tangential[first], 0.0))
        held_tangential = jnp.where(is_second, 0.0, held_tangential)
        held_tangential = held_tangential.at[second, second].add(jnp.where(stands, x.normal[first], 0.0))
        held_tangential = held_tangential.at[second, first].add(
            jnp.where(stands, -ratio * x.normal[second], 0.0)
        )
        held_displacement = jnp.where(is_second, 0.0, held_displacement)
        held_turns = jnp.where(is_second, 0.0, held_turns)
        held_pins = jnp.where(is_second, 0.0, held_pins)
    free = (slides != 0.0) | assembled
    held_normal = jnp.where(free[:, None], -_diagonal(slides), held_normal)
    held_tangential = jnp.where(free[:, None], _diagonal(ones), held_tangential)
    held_displacement, held_turns, held_pins = (
        jnp.where(free[:, None], 0.0, each) for each in (held_displacement, held_turns, held_pins)
    )

    moved, turns = matrices.approach.shape[1], members.size
    approach_moves = jnp.concatenate(
        [-matrices.approach, jnp.zeros((ones.size, turns)), approach_pins, -machine.pattern[:, None]], axis=1
    )
    held_moves = jnp.concatenate(
        [held_displacement, held_turns, held_pins, jnp.zeros((ones.size, 1))], axis=1
    )

    # balances, pins and size
    copies = sectors_of_members(drive)[members]
    carrier = (members == drive.members.index(CARRIER))[:, None]
    moments = jnp.where(carrier, 0.0, -turning.T) * copies[:, None] * limit / (lever * largest)
    size = jnp.where(assembled & by_force, reference[0] / largest, 0.0)
    pins_by_normal, pins_by_tangential = _pins_by_contacts(machine, task, x)
    of_normal = jnp.concatenate(
        [
            matrices.approach.T * reference / largest,
            jnp.zeros((turns, ones.size)),
            pins_by_normal,
            (size * np.eye(ones.size)[0])[None],
        ]
    )
    of_tangential = jnp.concatenate(
        [
            matrices.sliding.T * limit / largest,
            jnp.where(assembled, 0.0, moments),
            pins_by_tangential,
            jnp.zeros((1, ones.size)),
        ]
    )
    supports = jnp.zeros((moved, moved))
    if task.load.support_stiffness is not None:
        supports = _diagonal(jnp.repeat(task.load.support_stiffness, 2)) * length / largest
    by_pins = jax.jacfwd(lambda pin: moments_of(machine, task, tangential, pin)[members])(x.pin * largest)
    pin_rows, pin_slopes = _of_pins(machine, task, x)
    corner = jnp.where(assembled & by_force, 0.0, 1.0).reshape(1, 1)
    structure = jnp.block(
        [
            [supports, jnp.zeros((moved, turns)), matrices.pins.T, jnp.zeros((moved, 1))],
            [
                jnp.zeros((turns, moved)),
                jnp.where(assembled, np.eye(turns), 0.0),
                jnp.where(assembled, 0.0, by_pins / lever),
                jnp.zeros((turns, 1)),
            ],
            [pin_rows, jnp.zeros((pins, turns)), _diagonal(pin_slopes), jnp.zeros((pins, 1))],
            [jnp.zeros((1, moved + turns + pins)), corner],
        ]
    )
    return Slopes(
        approach,
        held_normal,
        held_tangential,
        approach_moves,
        held_moves,
        of_normal,
        of_tangential,
        structure,
    )


def newton_step(slopes: Slopes, residual: Unknowns, solver: Callable[[Array, Array], Array]) -> Unknowns:
    r"""Solve :math:`J s = r` for the step of all unknowns, the forces of the contacts eliminated."""
    first = jnp.concatenate([slopes.approach_moves, residual.normal[:, None]], axis=1)
    # normal forces, then tangential ones, as functions of the structure; the last column is without it
    first = first.at[:, :-1].multiply(-1.0)
    coupled = slopes.approach.ndim > 1
    normal = _eliminated(slopes.approach, first) if coupled else first / slopes.approach[:, None]
    held = jnp.concatenate([-slopes.held_moves, residual.tangential[:, None]], axis=1)
    tangential = _triangular(slopes.held_tangential, held - _matrix(slopes.held_normal, normal))
    rest = jnp.concatenate([residual.displacement, residual.turn, residual.pin, residual.interference])
    taken = _matrix(slopes.normal, normal) + _matrix(slopes.tangential, tangential)
    found = solver(slopes.structure + taken[:, :-1], rest - taken[:, -1])
    ends = np.cumsum([residual.displacement.size, residual.turn.size, residual.pin.size])
    displacement, turn, pin, interference = jnp.split(found, ends)
    return Unknowns(
        normal=product(normal[:, :-1], found) + normal[:, -1],
        tangential=product(tangential[:, :-1], found) + tangential[:, -1],
        pin=pin,
        displacement=displacement,
        turn=turn,
        interference=interference,
    )


def _pins_by_contacts(machine: Machine, task: Task, x: Unknowns) -> tuple[Array, Array]:
    """Slopes of the equations of pins and supports by normal and tangential forces, shape (pins, contacts)."""
    drive, laws, none = machine.drive, machine.laws, jnp.zeros((x.pin.size, x.normal.size))
    if laws.bores is None:
        return none, none
    assembled, count = jnp.asarray(task.kind) == ASSEMBLED, len(drive.pinned)
    side, _, _ = sides(x.pin[:count] * machine.largest, machine.largest)
    normal, tangential = laws.bores.by_pin(side)
    normal = jnp.where(assembled, laws.bores.along_normal, normal)
    moves = jnp.where(_kept(machine, task), 0.0, 1.0 / machine.length)[:, None]
    reference = laws.reference_force
    return (
        none.at[:count].set(-moves * normal.T * reference),
        none.at[:count].set(-moves * tangential.T * machine.friction * reference),
    )


def _kept(machine: Machine, task: Task) -> Array:
    """Pins whose forces stay those without torque, shape (pins,)."""
    drive = machine.drive
    kept = np.array(
        [drive.bodies[body].name in drive.closure.constant_pins for body in drive.pinned], dtype=bool
    )
    return jnp.asarray(kept) & (jnp.asarray(task.kind) != ASSEMBLED)


def _of_pins(machine: Machine, task: Task, x: Unknowns) -> tuple[Array, Array]:
    """Slopes of the equations of pins and supports by the displacements, and each by its own force."""
    drive, load = machine.drive, task.load
    count, loaded = len(drive.pinned), jnp.asarray(task.kind) != ASSEMBLED
    constant = _kept(machine, task)
    own: Array = jnp.broadcast_to(load.pin_compliance, (count,))
    if machine.laws.bores is not None:
        bores, (normal, tangential) = machine.laws.bores, contact_forces(machine, x)
        _, _, turns = sides(x.pin[:count] * machine.largest, machine.largest)
        opened = product(bores.around_normal.T, change_of_normal(task, normal))
        own = own - turns * (opened + product(bores.around_tangential.T, tangential))
    soft = own * machine.largest / machine.length
    rows = jnp.where(constant[:, None], 0.0, machine.matrices.pins[:count])
    slopes = jnp.where(constant, 1.0, -soft)
    if load.supports is None:
        return rows, slopes
    beside = -load.supports.compliance * machine.largest / machine.length
    return (
        jnp.concatenate([rows, jnp.where(loaded, load.supports.direction, 0.0)]),
        jnp.concatenate([slopes, jnp.where(loaded, beside, 1.0)]),
    )


def _rolled_by_speeds(drive: Drive, speed: Array) -> tuple[Array, Array]:
    """Slopes of the surface speeds of the contacts by the speeds of the members, shape (contacts, members) [m]."""
    members = drive.members
    relative = np.eye(len(members)) - np.eye(len(members))[members.index(CARRIER)]
    sides = []
    for bodies, radius in (
        ([contact.first for contact in drive.contacts], drive.first_radius),
        ([contact.second for contact in drive.contacts], drive.second_radius),
    ):
        rows = relative[np.array([members.index(body) for body in bodies])]
        sides.append((radius * jnp.sign(product(rows, speed)))[:, None] * rows)
    return sides[0], sides[1]


def _diagonal(values: Array) -> Array:
    """A diagonal matrix, shape (n, n)."""
    matrix: Array = values[:, None] * np.eye(values.size)
    return matrix


def _matrix(one: Array, other: Array) -> Array:
    """Product of two small matrices as a part of the program around it."""
    found: Array = (one[:, :, None] * other[None]).sum(axis=1)
    return found


def _triangular(matrix: Array, columns: Array) -> Array:
    """Solve for contacts each of which depends on itself, and perhaps on one that depends on itself only."""
    own = jnp.diagonal(matrix)
    beside = matrix - _diagonal(own)
    each = columns / own[:, None]
    return each - _matrix(beside, each) / own[:, None]


def _eliminated(matrix: Array, columns: Array) -> Array:
    """Solve for several right sides at once, without exchange of rows: every diagonal element is the largest."""
    rows = np.arange(matrix.shape[0])

    def without_column(k: Array, table: Array) -> Array:
        row = table[k] / table[k, k]
        return jnp.where((rows == k)[:, None], row, table - table[:, k, None] * row)

    table = jax.lax.fori_loop(0, rows.size, without_column, jnp.concatenate([matrix, columns], axis=1))
    return table[:, rows.size :]
