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

from asperity.drive.layout.form import Form, Lobes, form_of_waves, waves_at_contacts
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
from asperity.engine.arrays import xp
from asperity.engine.derivatives import value_and_slopes
from asperity.engine.trees import map as of_leaves
from asperity.errors import NoSolutionError
from asperity.types import Array


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
        r"""Angle by which a member deviates from its steady rotation, over the amplitudes, shape (waves,) [rad/m].

        .. math:: \int (\omega - \bar\omega)\,d\tau = \frac{\Omega}{i \nu}
        """
        return self.speed[:, member] / (1j * self.frequency)


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
    machine, task, (x, _, slides) = rolling
    found = responses_and_slopes(machine, task, x)
    slopes = state_slopes(machine, task, 0, slides, x, found)
    speed = np.asarray(rolling.state.speed)
    at_contacts = [waves_at_contacts(machine.drive, lobes) for lobes in waves]
    forms = [
        form
        for lobes, (first, second) in zip(waves, at_contacts, strict=True)
        for form in (
            form_of_waves(first, second, lobes.harmonic),
            form_of_waves(-1j * first, -1j * second, lobes.harmonic),
        )
    ]
    driven = _by_forms(rolling, forms)
    matrix, damping = full_slopes(slopes), velocity_slopes(machine)
    frequency = np.array([-lobes.harmonic * _relative(machine, lobes, speed) for lobes in waves])
    try:
        solution = np.linalg.solve(
            matrix[None] + 1j * frequency[:, None, None] * damping[None], -driven[:, :, None]
        )[:, :, 0]
    except np.linalg.LinAlgError:
        raise NoSolutionError(
            "the equations of a form error have no solution: nothing holds a part of the drive"
        ) from None
    return _ripples_of(rolling, found, frequency, solution, forms)


def full_slopes(slopes: Slopes) -> np.ndarray:
    """Slopes of all equations by all unknowns, those of the contacts first: normal, tangential, then the structure."""
    approach = np.asarray(slopes.approach)
    normal = approach if approach.ndim > 1 else np.diag(approach)
    return np.block(
        [
            [normal, np.zeros_like(normal), slopes.approach_moves],
            [slopes.held_normal, slopes.held_tangential, slopes.held_moves],
            [slopes.normal, slopes.tangential, slopes.structure],
        ]
    )


def velocity_slopes(machine: Machine) -> np.ndarray:
    """Slopes of all equations by the movements of all unknowns a radian of the input: those of the centres creep."""
    sliding = np.asarray(machine.matrices.sliding) * float(1e3 * machine.length / machine.lever)
    contacts, moves = sliding.shape
    structure = moves + len(turning_members(machine.drive)) + machine.matrices.levers.size + 1
    slopes = np.zeros((2 * contacts + structure, 2 * contacts + structure))
    slopes[contacts : 2 * contacts, 2 * contacts : 2 * contacts + moves] = -sliding
    return slopes


def in_order(x: Unknowns) -> np.ndarray:
    """Unknowns or residuals in the order of :func:`full_slopes`, shape (n,)."""
    parts = (x.normal, x.tangential, x.displacement, x.turn, x.pin, x.interference)
    return np.concatenate([np.asarray(part) for part in parts])


def _relative(machine: Machine, lobes: Lobes, speed: np.ndarray) -> float:
    return float(speed[lobes.body] - speed[machine.drive.layout.carrier])


def _by_forms(rolling: RollingBalance, forms: Sequence[Form]) -> np.ndarray:
    """Slopes of all equations by pairs of forms, the real and imaginary part of a wave, shape (waves, n)."""
    machine, task, (x, responses, slides) = rolling

    def misfits(form: Form) -> Unknowns:
        return state_misfits(with_form(machine, form), task, 0, slides, x, responses).all

    _, directions = value_and_slopes(misfits, (_round(machine),), [(form,) for form in forms])
    rows = np.array([in_order(direction) for direction in directions])
    return rows[0::2] + 1j * rows[1::2]


def _round(machine: Machine) -> Form:
    """A drive without form errors."""
    return Form(*(xp.zeros(len(machine.drive.contacts)) for _ in range(4)))


def _ripples_of(
    rolling: RollingBalance,
    found: ResponsesAndSlopes,
    frequency: np.ndarray,
    solution: np.ndarray,
    forms: Sequence[Form],
) -> Ripples:
    """What the solutions of all waves mean."""
    machine, _, (x, _, _) = rolling
    contacts = len(machine.drive.contacts)
    ends = np.cumsum([contacts, contacts, x.displacement.size, x.turn.size, x.pin.size])
    over = np.split(solution, ends, axis=1)
    reference = np.asarray(machine.laws.reference_force)
    normal, tangential = over[0] * reference, over[1] * np.asarray(machine.friction) * reference
    pin = over[4] * float(machine.largest)
    layout = machine.drive.layout
    return Ripples(
        frequency=frequency,
        normal=normal,
        tangential=tangential,
        slip=_slip(rolling, found, normal, tangential),
        pin=pin[:, : len(machine.drive.pinned)],
        displacement=over[2] * float(machine.length),
        speed=over[3] @ layout.unit[layout.turning],
        input_torque=_input_torque(rolling, found, forms, (normal, tangential, pin)),
    )


def _slip(
    rolling: RollingBalance, found: ResponsesAndSlopes, normal: np.ndarray, tangential: np.ndarray
) -> np.ndarray:
    """Slopes of the tangential forces, without signs, over what the contacts bear, shape (waves, contacts)."""
    _, force = contact_forces(rolling.machine, rolling.balance.unknowns)
    bears = np.asarray(found.value.capacity)
    more = normal * np.asarray(found.by_normal.capacity) + tangential * np.asarray(
        found.by_tangential.capacity
    )
    share = np.abs(force) / bears
    return (np.sign(force) * tangential - share * more) / bears


def _input_torque(
    rolling: RollingBalance,
    found: ResponsesAndSlopes,
    forms: Sequence[Form],
    forces: tuple[np.ndarray, np.ndarray, np.ndarray],
) -> np.ndarray:
    """Torque at the input in the sense in which it turns, shape (waves,)."""
    machine, task, (x, responses, _) = rolling
    normal, tangential, pin = forces
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
        for part, form in zip((np.real, np.imag), forms[2 * wave : 2 * wave + 2], strict=True):
            directions.append((form, *of_leaves(part, moved)))
    _, slopes = value_and_slopes(torque, at, directions)
    values = np.array([float(slope) for slope in slopes])
    return values[0::2] + 1j * values[1::2]
