r"""Forces, displacements and speeds of a roller drive: assembled, standing under a torque, in steady rolling.

Every floating body has two displacements and a rotation, and as many equations of balance. The normal force of a
contact follows from the approach of its bodies, the tangential force from their slip while the drive stands and from
their creep while it rolls; no further assumption is needed:

.. math::
    A^\mathsf{T} N + S^\mathsf{T} T + P^\mathsf{T} F = Z, \quad (W^\mathsf{T} T)_j + \dots = 0, \quad
    \delta_k(N) = (A u)_k + \delta_k^0, \quad P u = c_p F

.. math::
    s_k(T_k, N_k) = (S (u - u_0) + W \psi)_k \;\text{(standing)}, \qquad
    \xi_k(T_k, N_k) = \frac{(W\omega)_k}{V_k} \;\text{(rolling)}
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import NamedTuple

from asperity.drive.layout.drive import Drive, incidence
from asperity.drive.state.equations import (
    ASSEMBLED,
    ROLLING,
    STANDING,
    Machine,
    Task,
    Unknowns,
    forces_on,
    machine_of,
    no_displacement,
    no_force,
)
from asperity.drive.state.search import assembled_guess, known_state, solved, started_from, state_of
from asperity.drive.state.state import ContactLaws, CreepOf, DriveLoad, DriveState, contact_approach
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import scan
from asperity.engine.derivatives import without_slopes
from asperity.linear import product, solve
from asperity.types import Array, Real

#: A rolling state by the creep law of the laws themselves, from which that with the law under the forces is sought; and
#: a standing state that is known already, beside rolling ones that are not.
_FIRST_ROLLING, _KNOWN_STANDING = ROLLING + 1, ROLLING + 2


class DriveStates(NamedTuple):
    """The states of one drive.

    Parameters
    ----------
    rest, standing, rolling : DriveState
        Assembled without torque; standing and rolling under the output torque.
    pressed : DriveState or None, optional
        Assembled as a loading cam presses the drive under the torque; None without a cam.
    """

    rest: DriveState
    standing: DriveState
    rolling: DriveState
    pressed: DriveState | None = None


def state_at_rest(
    *,
    drive: Drive,
    laws: ContactLaws,
    pattern: Array,
    preload: Real | None = None,
    interference: Real | None = None,
    load: DriveLoad | None = None,
    added: Array | None = None,
    known: DriveState | None = None,
    sectors: int = 1,
) -> DriveState:
    """The assembled drive without torque: its forces, and the interference that causes them.

    Parameters
    ----------
    drive : Drive
        The drive.
    laws : ContactLaws
        Its contacts.
    pattern : Array
        Interference of each contact over the interference of the drive, shape (contacts,) [-]; 1 at the ring's
        contacts where the ring's radius is too small.
    preload, interference : Real or None
        Mean normal force of the first contacts of all sectors [N], or the interference of the drive [m]; one of them.
    load : DriveLoad or None, optional
        Springs of pins and bearings, of which torque and forces do not count; None for rigid pins.
    added : Array or None, optional
        Interference of each contact besides that of the drive, shape (contacts,) [m]; None for none.
    known : DriveState or None, optional
        The state itself where it is known already: it is returned with its derivatives by the other arguments, without
        being sought.
    sectors : int, optional
        Number of sectors, whose contacts are listed one after the other.

    Returns
    -------
    DriveState
        State without rotation or creep; with a preload, ``interference`` is that which makes it.

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    machine = machine_of(drive, laws, pattern, added, None if load is None else load.supports)
    given = xp.asarray(preload if interference is None else interference, dtype=float)
    springs = DriveLoad(xp.zeros(())) if load is None else load
    unloaded = dataclasses.replace(springs, output_torque=xp.zeros(()), body_force=None)
    task = Task(ASSEMBLED, given, unloaded, no_displacement(drive), no_force(drive))
    pressed = sectors if interference is None else 0
    if known is None:
        found = solved(machine, task, assembled_guess(machine), pressed_sectors=pressed)
        return state_of(machine, task, found)
    pattern_interference = known.interference if added is None else known.interference - added
    unknowns = started_from(machine, known, xp.sum(pattern * pattern_interference) / xp.sum(pattern**2))
    found = known_state(machine, task, unknowns, known.slides, pressed_sectors=pressed)
    return state_of(machine, task, found)


def rolling_state(
    *, drive: Drive, laws: ContactLaws, interference: Array, output_torque: Real, start: DriveState
) -> DriveState:
    """The drive in steady rolling under an output torque that resists the rotation.

    Parameters
    ----------
    drive : Drive
        The drive.
    laws : ContactLaws
        Its contacts.
    interference : Array
        Interference of each contact, shape (contacts,) [m].
    output_torque : Real
        Torque at the output against its rotation [N·m].
    start : DriveState
        Initial state of the solution, :func:`state_at_rest`.

    Returns
    -------
    DriveState
        Forces, displacements, speeds and creepages; check ``residual``, which is large where a contact is in gross
        slip or has lifted off.

    References
    ----------
    Equations (B1), (B3) and (M3) of :doc:`/equations`.
    """
    size = xp.max(interference)
    machine = machine_of(drive, laws, interference / size)
    load = DriveLoad(xp.asarray(output_torque))
    task = Task(ROLLING, size, load, no_displacement(drive), start.pin_force, start.normal)
    found = solved(machine, task, started_from(machine, start, size), pressed_sectors=0)
    return state_of(machine, task, found)


def drive_states(
    *,
    drive: Drive,
    laws: ContactLaws,
    pattern: Array,
    preload: Real | None = None,
    interference: Real | None = None,
    load: DriveLoad,
    creep_of: CreepOf | None = None,
) -> DriveStates:
    """A drive assembled, standing under a torque, and rolling under it.

    Parameters
    ----------
    drive : Drive
        The drive.
    laws : ContactLaws
        Its contacts.
    pattern : Array
        Interference of each contact over the interference of the drive, shape (contacts,) [-].
    preload, interference : Real or None
        Normal force of the first contact without torque [N], or the interference of the drive [m]; one of them.
    load : DriveLoad
        Torque, forces on the bodies, and pins.
    creep_of : callable or None, optional
        Creep law of contacts under normal and tangential forces; None for that of the laws.

    Returns
    -------
    DriveStates
        Check their ``residual``. The assembled state bears no forces on the bodies.

    Notes
    -----
    While the drive stands, the slip of each contact is that of one loading from rest, the asperities with their
    stiffness at the normal force of the assembled state.

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    rest = state_at_rest(
        drive=drive, laws=laws, pattern=pattern, preload=preload, interference=interference, load=load
    )
    return DriveStates(
        rest, *loaded_states(drive=drive, laws=laws, rest=rest, load=load, creep_of=creep_of, separate=True)
    )


def loaded_state(
    *,
    drive: Drive,
    laws: ContactLaws,
    rest: DriveState,
    load: DriveLoad,
    rolls: Array | bool,
    holds: Array | bool = False,
    creep_of: CreepOf | None = None,
    sliding: Array | None = None,
) -> DriveState:
    """A drive under a torque, standing or rolling, from its assembled state.

    Parameters
    ----------
    drive : Drive
        The drive.
    laws : ContactLaws
        Its contacts.
    rest : DriveState
        Its assembled state.
    load : DriveLoad
        Torque, forces on the bodies, and pins.
    rolls : Array or bool
        Whether it rolls.
    holds : Array or bool, optional
        Whether every contact of the standing drive holds, one beyond its friction too.
    creep_of : callable or None, optional
        Creep law of contacts under normal and tangential forces; None for that of the laws.
    sliding : Array or None, optional
        Signs of the contacts that slide as a whole in the rolling drive, each with the force of its friction while
        others carry the rest, shape (contacts,) [-]; None for none.

    Returns
    -------
    DriveState
        Near and beyond gross slip the laws are continued as lines, and ``residual`` is infinite.

    Notes
    -----
    A rolling state is found with the creep law of the laws first, and from there with that under its forces: those of
    the assembled drive are too far away near gross slip, and the standing drive need not carry the torque.

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    rolling, standing = _rolling_kinds(creep_of), (STANDING, _KNOWN_STANDING)
    kinds = tuple(xp.where(rolls, *either) for either in zip(rolling, standing, strict=False))
    given = [(STANDING,) if rolls is False else kinds]
    return _loaded(drive, laws, rest, load, given, creep_of, holds, sliding)[-1]


def standing_state(*, drive: Drive, laws: ContactLaws, rest: DriveState, load: DriveLoad) -> DriveState:
    """A drive that stands under a torque, from its assembled state."""
    return _loaded(drive, laws, rest, load, [(STANDING,)], None)[0]


def loaded_states(
    *,
    drive: Drive,
    laws: ContactLaws,
    rest: DriveState,
    load: DriveLoad,
    creep_of: CreepOf | None,
    separate: bool = False,
) -> tuple[DriveState, DriveState]:
    """A drive under a torque, standing and rolling, from its assembled state.

    Parameters
    ----------
    drive, laws, rest, load, creep_of : Drive, ContactLaws, DriveState, DriveLoad, callable or None
        As for :func:`loaded_state`.
    separate : bool, optional
        Whether each state has a program of its own, so that one that nobody reads costs nothing; otherwise one program
        finds both, which is sooner compiled.

    Returns
    -------
    tuple of DriveState
        Standing and rolling, each as of :func:`loaded_state`.

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    kinds = [(STANDING,), _rolling_kinds(creep_of)]
    states = _loaded(drive, laws, rest, load, kinds if separate else [sum(kinds, ())], creep_of)
    return states[0], states[-1]


def _loaded(
    drive: Drive,
    laws: ContactLaws,
    rest: DriveState,
    load: DriveLoad,
    kinds: _Kinds,
    creep_of: CreepOf | None,
    holds: Array | bool = False,
    sliding: Array | None = None,
) -> list[DriveState]:
    """One state after the other, each from the one before it; those of one tuple by one program."""
    machine, loaded, begin = under_load(drive, laws, rest, load, creep_of)

    def step(before: Start, kind: Array | int) -> tuple[Start, DriveState]:
        first, known = (kind == state_kind for state_kind in (_FIRST_ROLLING, _KNOWN_STANDING))
        kind = xp.where(first, ROLLING, xp.where(known, STANDING, kind))
        task = loaded._replace(kind=kind, by_laws=first)
        unknowns, slides = before
        holding = xp.where(kind == STANDING, slides, 0.0 if sliding is None else sliding)
        found = solved(machine, task, unknowns, slides=holding, pressed_sectors=0, known=known, holds=holds)
        return (found.unknowns, found.slides), state_of(machine, task, found)

    last, solved_states = begin, []
    for alike in kinds:
        if len(alike) == 1:
            last, state = step(last, alike[0])
            solved_states.append(state)
            continue
        last, states = scan(step, last, xp.stack([xp.asarray(kind) for kind in alike]))
        solved_states += [trees.map(lambda leaf, i=i: leaf[i], states) for i in range(len(alike))]
    return solved_states


def under_load(
    drive: Drive, laws: ContactLaws, rest: DriveState, load: DriveLoad, creep_of: CreepOf | None
) -> tuple[Machine, Task, Start]:
    """The equations of a loaded drive, of no kind of state yet, and where a search for its states starts."""
    laws, rest, load = closed_around(drive=drive, laws=laws, rest=rest, load=load)
    size = without_slopes(xp.max(rest.interference))  # a scale, as those of machine_of
    machine = machine_of(drive, laws, rest.interference / size, supports=load.supports, creep_of=creep_of)
    borne = dataclasses.replace(load, body_force=forces_on(drive, load))
    task = Task(STANDING, size, borne, rest.displacement.ravel(), rest.pin_force, rest.normal)
    return machine, task, (started_from(machine, rest, size), rest.slides)


def closed_around(
    *, drive: Drive, laws: ContactLaws, rest: DriveState, load: DriveLoad
) -> tuple[ContactLaws, DriveState, DriveLoad]:
    """What a drive is loaded with: its laws, its assembled state as they see it, and its springs."""
    if laws.closure is None:
        return laws, rest, load
    matrices, moved = incidence(drive), rest.displacement.ravel()
    moved = moved - product(matrices.pins.T, product(matrices.pins, moved))
    approach = contact_approach(laws=laws.closure, normal=rest.normal)
    state = dataclasses.replace(
        rest,
        displacement=moved.reshape(rest.displacement.shape),
        interference=approach - product(matrices.approach, moved),
    )
    return laws.closure, state, dataclasses.replace(load, pin_compliance=0.0, supports=None)


_Kinds = Sequence[tuple[Array | int, ...]]
Start = tuple[Unknowns, Array]  # and the signs of the contacts that slide


def _rolling_kinds(creep_of: CreepOf | None) -> tuple[int, ...]:
    """Kinds of the states by which rolling is found, one after the other."""
    return (ROLLING,) if creep_of is None else (_FIRST_ROLLING, ROLLING)


def rest_forces(*, drive: Drive, pattern: Array) -> Array:
    r"""Normal forces of an assembled drive over that of its first contact.

    .. math:: N = A u + p\,\delta, \qquad A^\mathsf{T} N + P^\mathsf{T} F = 0, \qquad P u = 0, \qquad N_1 = 1

    Parameters
    ----------
    drive : Drive
        The drive.
    pattern : Array
        Interference p of each contact over that of the drive, shape (contacts,) [-].

    Returns
    -------
    Array
        Forces, shape (contacts,) [-].

    References
    ----------
    Equation (M1) of :doc:`/equations`.
    """
    matrices = incidence(drive)
    contacts, moves, pins = matrices.approach.shape[0], matrices.approach.shape[1], matrices.pins.shape[0]
    none = xp.zeros
    system = xp.block(
        [
            [xp.eye(contacts), none((contacts, pins)), -matrices.approach, -pattern[:, None]],
            [none((pins, contacts)), none((pins, pins)), matrices.pins, none((pins, 1))],
            [matrices.approach.T, matrices.pins.T, none((moves, moves)), none((moves, 1))],
            [xp.eye(1, contacts), none((1, pins)), none((1, moves)), none((1, 1))],
        ]
    )
    return solve(system, xp.eye(system.shape[0])[-1])[:contacts]
