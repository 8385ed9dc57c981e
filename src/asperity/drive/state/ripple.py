r"""What form errors of the tracks do to a rolling drive, to first order: one complex system of equations a harmonic.

In the frame of the carrier every harmonic of the form of a body that turns past its contacts is a wave of the angle
:math:`\tau` of the input. With the equations r of steady rolling, their form terms, and the movement of the centres in
the creep,

.. math::
    \xi V = S\,\frac{du}{d\tau} + W \omega, \qquad
    \Bigl(J + i \nu \frac{\partial r}{\partial u'}\Bigr) X = -G, \qquad
    \nu = -n\,\frac{\omega_b - \omega_c}{\omega_{in}}

where J are the slopes of the equations by their unknowns in the rolling state, and G those by the form.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.form import Form, Lobes, waves_at_contacts
from asperity.drive.state.equations import (
    Machine,
    Unknowns,
    contact_forces,
    moments_of,
    state_misfits,
    turning_members,
)
from asperity.drive.state.form_terms import with_form
from asperity.drive.state.loads import Resistance
from asperity.drive.state.rolling_balance import RollingBalance
from asperity.drive.state.slopes import ResponsesAndSlopes, Slopes, responses_and_slopes, state_slopes
from asperity.engine.arrays import as_complex, complex_number, xp
from asperity.engine.control import map_over
from asperity.engine.derivatives import jacobian, value_and_slopes
from asperity.engine.trees import map as of_leaves
from asperity.errors import NoSolutionError
from asperity.linear import solve_rows
from asperity.types import Array, Number


class Ripples(NamedTuple):
    r"""Complex amplitudes of what harmonics do to a rolling drive, over the amplitudes of the harmonics, one a row.

    A quantity is its steady value plus the real part of amplitude times :math:`A e^{i(\nu\tau + \varphi)}`, tau the
    angle of the input in its ideal sense. ``frequency`` nu, shape (waves,) [-]; ``normal``, ``tangential``, shape
    (waves, contacts) [N/m]; ``slip``, of the tangential force over what the contact bears, shape (waves, contacts)
    [1/m]; ``pin``, shape (waves, pins) [N/m]; ``displacement``, of the floating centres, shape (waves, 2 floating) [-];
    ``speed``, of the members over that of the input, shape (waves, members) [1/m]; ``input_torque``, in the sense in
    which the input turns, shape (waves,) [N].
    """

    frequency: np.ndarray
    normal: np.ndarray
    tangential: np.ndarray
    slip: np.ndarray
    pin: np.ndarray
    displacement: np.ndarray
    speed: np.ndarray
    input_torque: np.ndarray

    def error(self, member: int) -> np.ndarray:
        """That of :func:`swing` of a member."""
        return np.asarray(swing(self.speed[:, member], self.frequency))


def swing(speed: Number, frequency: Number) -> Array:
    r"""Angle by which a member deviates from its steady rotation, over the amplitudes, shape (waves,) [rad/m].

    .. math:: \int (\omega - \bar\omega)\,d\tau = \frac{\Omega}{i \nu}

    ``speed`` over that of the input, complex, over the amplitudes [1/m]; ``frequency`` nu [-].
    """
    angle: Array = speed / complex_number(xp.zeros_like(frequency), frequency)
    return angle


def ripples(rolling: RollingBalance, waves: Sequence[Lobes]) -> Ripples:
    r"""What harmonics of the form of a drive's tracks do to it in steady rolling, to first order.

    Parameters
    ----------
    rolling : RollingBalance
        The unfolded drive: a wave of one body reaches the others differently in every sector.
    waves : sequence of Lobes
        The harmonics, each for itself.

    Returns
    -------
    Ripples
        Complex amplitudes over the amplitudes of the waves.

    Raises
    ------
    NoSolutionError
        If the equations of a wave have no solution.

    References
    ----------
    Equations (R1) to (R3) of :doc:`/equations`, linear in form and movement.
    """
    with np.errstate(all="ignore"):
        solved = solved_waves(rolling, waves)
    if not np.all(np.isfinite(solved.unknowns)):
        raise NoSolutionError(
            "the equations of a form error have no solution: nothing holds a part of the drive"
        )
    return _ripples_of(rolling, solved)


class SolvedWaves(NamedTuple):
    """Solutions of the equations for harmonics of a rolling drive.

    ``responses`` of its contacts; ``forms`` of the waves at the contacts as complex numbers: of both surfaces and their
    slopes, shape (waves, 4 contacts) [-]; ``frequency`` nu, shape (waves,) [-]; ``unknowns`` in the order of
    :func:`full_slopes`, complex, shape (waves, n) [1/m].
    """

    responses: ResponsesAndSlopes
    forms: Array
    frequency: Array
    unknowns: Array

    def speed(self, machine: Machine) -> Array:
        """Speeds of the members over that of the input, complex, shape (waves, members) [1/m]."""
        layout, contacts = machine.drive.layout, len(machine.drive.contacts)
        first = 2 * contacts + machine.matrices.approach.shape[1]
        turns = self.unknowns[:, first : first + layout.turning.size]
        return turns @ as_complex(layout.unit[layout.turning])

    def forces(self, machine: Machine) -> tuple[Array, Array]:
        """Normal and tangential forces of the contacts, complex, shape (waves, contacts) [N/m]."""
        contacts, reference = len(machine.drive.contacts), machine.laws.reference_force
        normal = self.unknowns[:, :contacts] * as_complex(reference)
        return normal, self.unknowns[:, contacts : 2 * contacts] * as_complex(machine.friction * reference)


def solved_waves(
    rolling: RollingBalance, waves: Sequence[Lobes], groups: Sequence[int] | None = None
) -> SolvedWaves:
    """What :func:`ripples` solves, pure: for one drive, and for many by JAX, with derivatives.

    ``groups``: a number for each wave, alike for those of one frequency, which share their matrix.
    """
    machine, task, (x, _, slides) = rolling
    found = responses_and_slopes(machine, task, x)
    slopes = state_slopes(machine, task, 0, slides, x, found)
    speed = rolling.state.speed
    forms = xp.stack([_at_contacts(machine, lobes) for lobes in waves])
    frequency = xp.stack([-lobes.harmonic * _relative(machine, lobes, speed) for lobes in waves])
    solution = _solved(
        full_slopes(slopes),
        velocity_slopes(machine),
        frequency,
        forms @ as_complex(_by_form(rolling)).T,
        range(len(waves)) if groups is None else groups,
    )
    return SolvedWaves(found, forms, frequency, -solution)


def _solved(
    matrix: Array, damping: Array, frequency: Array, right_sides: Array, groups: Sequence[int]
) -> Array:
    r"""The x of :math:`(J + i \nu D) x = b` for waves of some frequencies, shape (waves, n); one matrix for a group."""
    places = [[k for k, of in enumerate(groups) if of == group] for group in dict.fromkeys(groups)]
    most = max(map(len, places))
    filled = np.array([(place + place[-1:] * most)[:most] for place in places])

    def of_group(given: tuple[Array, Array]) -> Array:
        nu, sides = given
        return solve_rows(complex_number(matrix, nu * damping), sides)

    solutions = map_over(of_group, (frequency[filled[:, 0]], right_sides[filled]))
    where = {k: (group, row) for group, place in enumerate(places) for row, k in enumerate(place)}
    first, second = np.array([where[k] for k in range(len(groups))]).T
    found: Array = solutions[first, second]
    return found


def full_slopes(slopes: Slopes) -> Array:
    """Slopes of all equations by all unknowns, those of the contacts first: normal, tangential, then the structure."""
    approach = slopes.approach
    normal = approach if approach.ndim > 1 else approach[:, None] * xp.eye(approach.size)
    return xp.concatenate(
        [
            xp.concatenate([normal, xp.zeros_like(normal), slopes.approach_moves], axis=1),
            xp.concatenate([slopes.held_normal, slopes.held_tangential, slopes.held_moves], axis=1),
            xp.concatenate([slopes.normal, slopes.tangential, slopes.structure], axis=1),
        ]
    )


def velocity_slopes(machine: Machine) -> Array:
    """Slopes of all equations by the movements of all unknowns a radian of the input: those of the centres creep."""
    sliding = machine.matrices.sliding * (1e3 * machine.length / machine.lever)
    contacts, moves = sliding.shape
    others = len(turning_members(machine.drive)) + machine.matrices.levers.size + 1
    return xp.pad(-sliding, ((contacts, moves + others), (2 * contacts, others)))


def in_order(x: Unknowns) -> Array:
    """Unknowns or residuals in the order of :func:`full_slopes`, shape (n,)."""
    parts = (x.normal, x.tangential, x.displacement, x.turn, x.pin, x.interference)
    return xp.concatenate([xp.ravel(part) for part in parts])


def _relative(machine: Machine, lobes: Lobes, speed: Array) -> Array:
    return speed[lobes.body] - speed[machine.drive.layout.carrier]


def _at_contacts(machine: Machine, lobes: Lobes) -> Array:
    """Form of a harmonic at both surfaces of each contact, then its slopes there, shape (4 contacts,) [-]."""
    first, second = waves_at_contacts(machine.drive, lobes)
    turned = 1j * lobes.harmonic
    return xp.concatenate([first, second, turned * first, turned * second])


def _by_form(rolling: RollingBalance) -> Array:
    """Slopes of all equations by the form at both surfaces of each contact and its slopes, shape (n, 4 contacts)."""
    machine, task, (x, responses, slides) = rolling

    def misfits(numbers: Array) -> Array:
        form = Form(*numbers.reshape(4, -1))
        return in_order(state_misfits(with_form(machine, form), task, 0, slides, x, responses).all)

    return jacobian(misfits, xp.zeros_like(xp.tile(x.normal, 4)))


def _round(machine: Machine) -> Form:
    """A drive without form errors."""
    return Form(*(xp.zeros(len(machine.drive.contacts)) for _ in range(4)))


def _ripples_of(rolling: RollingBalance, solved: SolvedWaves) -> Ripples:
    """What the solutions of all waves mean."""
    machine, _, (x, _, _) = rolling
    contacts = len(machine.drive.contacts)
    ends = np.cumsum([2 * contacts, x.displacement.size, x.turn.size, x.pin.size])
    over = np.split(np.asarray(solved.unknowns), ends, axis=1)
    normal, tangential = (np.asarray(each) for each in solved.forces(machine))
    pin = over[3] * float(machine.largest)
    return Ripples(
        frequency=np.asarray(solved.frequency),
        normal=normal,
        tangential=tangential,
        slip=np.asarray(slip_of_waves(rolling, solved)),
        pin=pin[:, : len(machine.drive.pinned)],
        displacement=over[1] * float(machine.length),
        speed=np.asarray(solved.speed(machine)),
        input_torque=_input_torque(rolling, solved, (normal, tangential, pin)),
    )


def slip_of_waves(rolling: RollingBalance, solved: SolvedWaves) -> Array:
    """Slopes of the tangential forces, without signs, over what the contacts bear, shape (waves, contacts) [1/m]."""
    normal, tangential = solved.forces(rolling.machine)
    _, force = contact_forces(rolling.machine, rolling.balance.unknowns)
    found = solved.responses
    bears = found.value.capacity
    share = abs(force) / bears
    by_normal = -share * found.by_normal.capacity
    by_tangential = xp.sign(force) - share * found.by_tangential.capacity
    return (as_complex(by_normal) * normal + as_complex(by_tangential) * tangential) / as_complex(bears)


def _input_torque(
    rolling: RollingBalance, solved: SolvedWaves, forces: tuple[np.ndarray, np.ndarray, np.ndarray]
) -> np.ndarray:
    """Torque at the input in the sense in which it turns, shape (waves,)."""
    machine, task, (x, responses, _) = rolling
    normal, tangential, pin = forces
    found = solved.responses
    resistance = Resistance(
        *(
            normal * np.asarray(by_normal) + tangential * np.asarray(by_tangential)
            for by_normal, by_tangential in zip(
                found.by_normal.resistance, found.by_tangential.resistance, strict=True
            )
        )
    )

    def torque(form: Form, at: tuple[Array, Array], pins: Array, resists: Resistance) -> Array:
        moments = moments_of(with_form(machine, form), task, at, pins, resists)
        return -machine.drive.sense * moments[machine.drive.layout.input]

    at = (
        _round(machine),
        contact_forces(machine, x),
        np.asarray(x.pin * machine.largest),
        responses.resistance,
    )
    directions = []
    for wave in range(len(normal)):
        moved = (
            (normal[wave], tangential[wave]),
            pin[wave],
            of_leaves(lambda rows, k=wave: rows[k], resistance),
        )
        form = Form(*np.asarray(solved.forms[wave]).reshape(4, -1))
        for part in (np.real, np.imag):
            directions.append((of_leaves(part, form), *of_leaves(part, moved)))
    _, slopes = value_and_slopes(torque, at, directions)
    values = np.array([float(slope) for slope in slopes])
    return values[0::2] + 1j * values[1::2]
