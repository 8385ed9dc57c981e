"""The equations of a drive in any of its states."""

from __future__ import annotations

import dataclasses
import functools
from typing import Any, NamedTuple

import numpy as np

from asperity.drive.bearings import leading_sense
from asperity.drive.layout.drive import Drive, Incidence, incidence, speeds
from asperity.drive.layout.form import Hills
from asperity.drive.state.bores import PressedBores
from asperity.drive.state.creep import creepages
from asperity.drive.state.loads import (
    drag_pairs,
    friction_moments,
    member_moments,
    resistance_moments,
    signed_resistance,
)
from asperity.drive.state.state import (
    ContactLaws,
    Creeping,
    CreepOf,
    DriveLoad,
    Resistance,
    contact_approach,
    slip_at_rest,
    surface_speeds,
)
from asperity.drive.state.supports import Supports, with_supports
from asperity.engine.arrays import is_of_jax, xp
from asperity.engine.control import cond, put, traced_once
from asperity.engine.derivatives import without_slopes
from asperity.linear import product
from asperity.types import Array

#: Kinds of states: assembled without torque, standing under one, rolling under one.
ASSEMBLED, STANDING, ROLLING = 0, 1, 2


class Unknowns(NamedTuple):
    """Unknowns of a state, each over its scale [-].

    Forces of the contacts over the reference, and over the friction limit at it; forces of the pins, then of the
    supports on the carrier, over the largest reference; displacements of the floating centres over the approach at the
    reference; ``turn``, added to the speeds, or rotation times lever over the approach; interference of the drive over
    the approach at the reference.
    """

    normal: Array
    tangential: Array
    pin: Array
    displacement: Array
    turn: Array
    interference: Array


class Machine(NamedTuple):
    """What is the same in all states of a drive.

    ``matrices`` tell how displacements and rotations move the contacts, the pins, and after these the supports on the
    carrier. ``ideal`` are the speeds without slip, shape (members,) [-]. Of each contact, shape (contacts,):
    ``pattern``, its interference over that of the drive [-], ``added``, what it has besides [m], None for none, and the
    friction coefficient. ``length``, ``largest`` and ``lever`` are scales: approach [m], force [N] and lever [m].
    ``creep_of`` is the creep law of the contacts under their normal and tangential forces; None for that of the laws.
    ``hills`` are the moments that form errors add; None of round tracks.
    """

    drive: Drive
    laws: ContactLaws
    matrices: Incidence
    ideal: Array
    pattern: Array
    friction: Array
    length: Array
    largest: Array
    lever: Array
    added: Array | None = None
    creep_of: CreepOf | None = None
    hills: Hills | None = None


class Task(NamedTuple):
    """One state to be found.

    ``kind`` is :data:`ASSEMBLED`, :data:`STANDING` or :data:`ROLLING`; ``size`` the preload [N] or the interference of
    the drive [m]. Of the assembled drive: ``origin``, the displacements from which slip is counted, shape (2 floating,)
    [m]; ``pin_at_rest``, forces of its pins, shape (pins,) [N]; ``normal_at_rest``, shape (contacts,) [N]. ``by_laws``
    tells whether a rolling drive has the creep of the laws, although the machine knows that under the forces.
    ``velocity`` is by how much the floating centres of a rolling drive move per angle of the input in its ideal sense,
    shape (2 floating,) [m/rad]; None where they stay.
    """

    kind: Any
    size: Array
    load: DriveLoad
    origin: Array
    pin_at_rest: Array
    normal_at_rest: Array | None = None
    by_laws: Any = False
    velocity: Array | None = None


def known_kind(task: Task) -> int | None:
    """Kind of a state, None where a program finds states of several kinds."""
    return None if is_of_jax(task.kind) else int(task.kind)


def of_kind(task: Task, kind: int | None) -> Task:
    """The same state, of a kind that is known."""
    return task if kind is None else task._replace(kind=kind)


def machine_of(
    drive: Drive,
    laws: ContactLaws,
    pattern: Array,
    added: Array | None = None,
    supports: Supports | None = None,
    creep_of: CreepOf | None = None,
) -> Machine:
    """What all states of a drive have in common, with their scales; equation (M3).

    ``pattern`` is the interference of each contact over that of the drive [-], ``added`` what it has besides [m], both
    of shape (contacts,).
    """
    reference = laws.reference_force
    # the derivative of a largest number is 0/0 where XLA rounds it differently a second time, and scales need none
    scales = laws.springs.secant_compliance * reference, reference, drive.second_radius
    length, largest, lever = (without_slopes(xp.max(scale)) for scale in scales)
    return Machine(
        drive=drive,
        laws=laws,
        matrices=with_supports(incidence(drive), supports),
        ideal=speeds(drive),
        pattern=pattern,
        friction=xp.broadcast_to(laws.creep.friction_coefficient, reference.shape),
        length=length,
        largest=largest,
        lever=lever,
        added=added,
        creep_of=creep_of,
    )


def turning_members(drive: Drive) -> np.ndarray:
    """Numbers of the members whose rotation is unknown: all but the input and the grounded member."""
    return drive.layout.turning


def speeds_and_turns(machine: Machine, x: Unknowns, kind: Any) -> tuple[Array, Array]:
    """Speeds over that of the input [-] and rotations [rad] of all members, shape (members,); equation (M3)."""
    layout = machine.drive.layout
    rolls = xp.where(xp.asarray(kind) == ROLLING, 1.0, 0.0)
    turn = product(layout.unit[layout.turning].T, x.turn)
    return machine.ideal + rolls * turn, (1.0 - rolls) * turn * machine.length / machine.lever


def contact_forces(machine: Machine, x: Unknowns) -> tuple[Array, Array]:
    """Normal and tangential forces of the contacts from the unknowns, shape (contacts,) [N]; equation (M3)."""
    reference = machine.laws.reference_force
    return x.normal * reference, x.tangential * machine.friction * reference


def contact_interference(machine: Machine, x: Unknowns) -> Array:
    """Interference of the contacts, shape (contacts,) [m]."""
    pattern_interference = machine.pattern * x.interference * machine.length
    return pattern_interference if machine.added is None else pattern_interference + machine.added


def forces_on(drive: Drive, load: DriveLoad) -> Array:
    """Forces on the floating bodies, shape (floating, 2) [N]; equation (M3)."""
    return xp.zeros((len(drive.floating), 2)) if load.body_force is None else load.body_force


def no_displacement(drive: Drive) -> Array:
    """Displacements of a drive that has not moved: zeros, shape (2 floating,) [m]."""
    return xp.zeros(2 * len(drive.floating))


def no_force(drive: Drive) -> Array:
    """Forces of the pins of a drive that is not pressed, shape (pins,) [N]."""
    return xp.zeros(len(drive.pinned))


class Responses(NamedTuple):
    """What contacts do under forces, shape (contacts,).

    Approach and slip at rest [m], creepage [-], the largest tangential force that they bear [N], and signed resistance
    in rolling.
    """

    approach: Array
    slip: Array
    creepage: Array
    capacity: Array
    resistance: Resistance


def responses_of(approach: Array, *others: Array) -> Responses:
    """Responses of contacts, zeros for those that are not given, shape (contacts,)."""
    nothing = xp.zeros_like(approach)
    slip, creepage, capacity = others or (nothing, nothing, nothing)
    return Responses(approach, slip, creepage, capacity, Resistance(nothing, nothing, nothing))


def contact_responses(machine: Machine, task: Task, normal: Array, tangential: Array) -> Responses:
    """What the contacts do under normal and tangential forces, shape (contacts,) [N]; equations (B1) and (M3).

    Without what bodies that bend add to the approaches of each other's contacts, and without slip and creep where
    only the assembled drive is sought.
    """
    laws = machine.laws
    approach = contact_approach(laws=dataclasses.replace(laws, coupling=None), normal=normal)
    if known_kind(task) == ASSEMBLED:
        return responses_of(approach)
    kind, nothing = known_kind(task), xp.zeros_like(approach)
    bears = machine.friction * normal
    slip = nothing if kind == ROLLING else slip_at_rest(laws=laws, normal=normal, tangential=tangential)
    if kind == STANDING:
        return responses_of(approach, slip, nothing, bears)

    def by_laws() -> Creeping:
        return Creeping(creepages(law=laws.creep, normal=normal, tangential=tangential), bears, nothing)

    law = machine.creep_of
    if law is None:
        creeping = by_laws()
    else:
        under_forces = (xp.asarray(task.kind) == ROLLING) & ~xp.asarray(task.by_laws)
        creeping = cond(under_forces, lambda: law(normal, tangential), by_laws)
    responses = responses_of(approach, slip, creeping.creepage, creeping.capacity)
    return responses._replace(resistance=_resistance(machine.drive, task, normal, creeping.skew_drag))


def _resistance(drive: Drive, task: Task, normal: Array, skew_drag: Array) -> Resistance:
    """What resists rolling, signed, shape (contacts,); 0 where nothing rolls."""
    resistance_of, none = task.load.resistance_of, xp.zeros_like(normal)
    if resistance_of is None:
        return Resistance(none, none, none)
    rolls = xp.asarray(task.kind) == ROLLING
    drag, moment = cond(rolls, resistance_of, lambda normal: (none, none), normal)
    return signed_resistance(drive, Resistance(drag, moment, skew_drag), backwards=_backwards(task))


def _backwards(task: Task) -> Array:
    """-1 of a drive that rolls against its ideal speeds, else 1."""
    return xp.where(xp.asarray(task.load.rotation) < 0.0, -1.0, 1.0)


class Misfits(NamedTuple):
    """Residuals of all equations of a state, each relative to its scale [-].

    ``held`` is by how much the slip or the creep of each contact under its forces exceeds that of its bodies, shape
    (contacts,); an equation where the contact does not slide.
    """

    all: Unknowns
    held: Array


@functools.partial(traced_once, fixed=("pressed_sectors",))  # traced once for all kinds of states
def state_misfits(
    machine: Machine, task: Task, pressed_sectors: int, slides: Array, x: Unknowns, responses: Responses
) -> Misfits:
    """All equations of a state, from what its contacts do under its forces.

    The assembled state has a given mean normal force of the first contacts of ``pressed_sectors`` sectors; with 0 of
    them, and in all other states, the interference is given.
    """
    drive, laws, matrices = machine.drive, machine.laws, machine.matrices
    length, largest, lever = machine.length, machine.largest, machine.lever
    normal, tangential = contact_forces(machine, x)
    pin, moved = x.pin * largest, x.displacement * length
    speed, turned = speeds_and_turns(machine, x, task.kind)
    kind = xp.asarray(task.kind)

    approach, slip, creep, _, resistance = responses
    if laws.coupling is not None:
        approach = approach + product(laws.coupling, normal)
    pressed = None
    if laws.bores is not None:
        force, at_rest = pin[: len(drive.pinned)], task.pin_at_rest
        pressed = laws.bores.under(force, largest)
        widened, slid = laws.bores.moved(force, pressed)
        _, slid_at_rest = laws.bores.moved(at_rest, laws.bores.under(at_rest, largest))
        approach, slip = approach + widened, slip + slid - slid_at_rest
    misfit = approach - product(matrices.approach, moved) - contact_interference(machine, x)
    rolling = _backwards(task) * creep * _rolled(drive, speed) - product(matrices.turning, speed)
    if task.velocity is not None:
        rolling = rolling - product(matrices.sliding, task.velocity)
    standing = slip - product(matrices.sliding, moved - task.origin) - product(matrices.turning, turned)
    force = (
        product(matrices.approach.T, normal)
        + product(matrices.sliding.T, tangential)
        + product(matrices.pins.T, pin)
    )
    if task.load.resistance_of is not None:
        force = force + product(matrices.sliding.T, drag_pairs(drive, resistance.drag))
    if task.load.support_stiffness is not None:
        force = force + xp.repeat(task.load.support_stiffness, 2) * moved
    moments = moments_of(machine, task, (normal, tangential), pin, resistance)
    out = drive.layout.output
    moments = moments - drive.layout.unit[out] * xp.sign(machine.ideal[out]) * task.load.output_torque
    moments = moments[turning_members(drive)] / (lever * largest)
    size = (x.interference * length - task.size) / length
    if pressed_sectors:
        preload = xp.sum(preload_weights(normal.size, pressed_sectors) * normal)
        size = xp.where(kind == ASSEMBLED, (preload - task.size) / largest, size)
    held = xp.where(
        kind == ROLLING,
        rolling / lever * 1e3,
        xp.where(kind == STANDING, _with_equal_coefficients(machine, x, standing / length), x.tangential),
    )
    equations = Unknowns(
        misfit / length,
        xp.where(slides == 0.0, held, x.tangential - slides * x.normal),
        _of_pins(machine, task, (normal, tangential), pin, moved, pressed),
        (force - forces_on(drive, task.load).ravel()) / largest,
        xp.where(kind == ASSEMBLED, x.turn, moments),
        size,
    )
    return Misfits(equations, held)


def preload_weights(contacts: int, sectors: int) -> np.ndarray:
    """Weights of the normal forces in the preload, the mean of the first ones of all sectors, shape (contacts,) [-]."""
    weights = np.zeros(contacts)
    if sectors:
        weights[:: contacts // sectors] = 1.0 / sectors
    return weights


def numbers_of_pairs(drive: Drive) -> np.ndarray:
    """Numbers of the contacts with equal traction coefficients, shape (pairs, 2)."""
    names = [contact.name for contact in drive.contacts]
    pairs = [[names.index(name) for name in pair] for pair in drive.closure.equal_coefficients]
    return np.array(pairs, dtype=int).reshape(-1, 2)


def _with_equal_coefficients(machine: Machine, x: Unknowns, slip: Array) -> Array:
    """Misfits of the slip; of the second contact of each pair by how much T/N differs from that of the first."""
    first, second = numbers_of_pairs(machine.drive).T
    traction = machine.friction * x.tangential
    differs = (traction[second] * x.normal[first] - traction[first] * x.normal[second]) / machine.friction[
        second
    ]
    return put(slip, second, differs)


def change_of_normal(task: Task, normal: Array) -> Array:
    """What the torque has added to the normal forces, shape (contacts,) [N]; nothing in the assembled drive."""
    before = xp.zeros_like(normal) if task.normal_at_rest is None else task.normal_at_rest
    return xp.where(xp.asarray(task.kind) == ASSEMBLED, 0.0, normal - before)


def _of_pins(
    machine: Machine,
    task: Task,
    forces: tuple[Array, Array],
    pin: Array,
    moved: Array,
    pressed: PressedBores | None,
) -> Array:
    """Misfits of the pins: their springs, or their forces without torque where those stay; then of the supports."""
    drive, matrices, supports = machine.drive, machine.matrices, task.load.supports
    count, loaded = len(drive.pinned), xp.asarray(task.kind) != ASSEMBLED
    springs = product(matrices.pins[:count], moved) - task.load.pin_compliance * pin[:count]
    if machine.laws.bores is not None and pressed is not None:
        normal, tangential = forces
        change = change_of_normal(task, normal)
        springs = springs - machine.laws.bores.pin_moved(pressed, normal, change, tangential)
    kept = np.array(
        [drive.bodies[body].name in drive.closure.constant_pins for body in drive.pinned], dtype=bool
    )
    constant = (pin[:count] - task.pin_at_rest) / machine.largest
    pin_misfits = xp.where(loaded & kept, constant, springs / machine.length)
    if supports is None:
        return pin_misfits
    beside = product(supports.direction, moved - task.origin) - supports.compliance * pin[count:]
    return xp.concatenate(
        [pin_misfits, xp.where(loaded, beside / machine.length, pin[count:] / machine.largest)]
    )


def moments_of(
    machine: Machine, task: Task, forces: tuple[Array, Array], pin: Array, resistance: Resistance | None
) -> Array:
    """Moments of contacts, pins and bearings on the members, counter-clockwise, shape (members,) [N·m]; (M1), (R3).

    Of the normal and tangential forces of the contacts, shape (contacts,), of what resists their rolling, None for
    nothing, and of the forces of the pins, shape (pins,) [N].
    """
    normal, tangential = forces
    moments = member_moments(machine.drive, machine.matrices, tangential, pin)
    if machine.hills is not None:
        moments = moments + product(machine.hills.normal, normal)
        moments = moments + product(machine.hills.tangential, tangential)
    if task.load.resistance_of is not None and resistance is not None:
        moments = moments + resistance_moments(machine.drive, resistance)
    load, kind = task.load, xp.asarray(task.kind)
    if load.bearings is None:
        return moments
    sense = leading_sense(
        rotation=xp.where(kind == ROLLING, load.rotation, load.standing_rotation),
        output_torque=load.output_torque,
    )
    return moments + xp.where(kind == ASSEMBLED, 0.0, 1.0) * friction_moments(
        drive=machine.drive,
        bearings=load.bearings,
        pin_force=pin,
        ideal=sense * machine.ideal,
        on_carrier=load.friction_on_carrier,
    )


def _rolled(drive: Drive, speed: Array) -> Array:
    """Rolling speed of each contact relative to the carrier, the mean of its surface speeds [m]."""
    one, two = surface_speeds(drive=drive, speed=speed)
    return 0.5 * (one + two)
