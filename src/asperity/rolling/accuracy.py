r"""Accuracy of a joint over a turn: what form errors of its parts do to its output, its forces and its input torque.

To first order in the form errors, in the whole drive with every sector by itself
(:func:`asperity.drive.state.ripple.ripples`). The transmission error is the deviation of the output from steady
rotation; its mean speed is drift, which creep and sizes make. Where phases are not known,

.. math:: \hat y = \sum_j |H_j| A_j \ \text{at worst}, \qquad y_{rms} = \sqrt{\tfrac12 \sum_j |H_j|^2 A_j^2}

Harmonics of one number on alike parts have one frequency: where their phases are known, they add up with these.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive
from asperity.drive.layout.form import Lobes, lobes_of, orders
from asperity.drive.state.creep import ROLLING_TOLERANCE, drift_per_turn
from asperity.drive.state.ripple import Ripples, ripples, slip_of_waves, solved_waves, swing
from asperity.drive.state.rolling_balance import RollingBalance, rolling_balance
from asperity.engine import trees
from asperity.engine.arrays import as_numbers, complex_number, xp
from asperity.engine.control import at_once
from asperity.errors import NoSolutionError
from asperity.joint.assembled import assembled
from asperity.joint.description import Joint, without_duty
from asperity.joint.laws import creep_under, rolling_load
from asperity.joint.loading_cam import pressed_at
from asperity.joint.machine import joint_machine
from asperity.types import Array, Number, Real


class FormError(NamedTuple):
    """A harmonic of the form of one track.

    ``part``: name of the track in the joint file; ``sector``, counted from 1, 0 of a part on the axis; ``sides``, the
    contacts of the drive on it, (name, "first" or "second"); ``harmonic``, its waves round the track; ``amplitude``
    [m]; ``phase``, at the polar angle 0 of the body [rad], None where it is not known.
    """

    part: str
    sector: int
    sides: tuple[tuple[str, str], ...]
    harmonic: int
    amplitude: Real
    phase: Real | None


class Component(NamedTuple):
    """What one form error does: complex amplitudes, whose waves are added to the steady values.

    ``error`` of form; ``order``, waves per turn of the output, and ``frequency``, per angle of the input [-];
    ``transmission_error`` [rad]; ``normal``, ``tangential`` [N] and ``slip`` of the contacts, shape (contacts,), the
    latter without signs over what they bear [-]; ``input_torque`` [N·m].
    """

    error: FormError
    order: float
    frequency: float
    transmission_error: complex
    normal: np.ndarray
    tangential: np.ndarray
    slip: np.ndarray
    input_torque: complex


class Budget(NamedTuple):
    """Largest deviation from the steady value over all phases that are not known, and root mean square."""

    worst: np.ndarray
    rms: np.ndarray


class Accuracy(NamedTuple):
    """A joint with form errors that rolls in one direction. SI units.

    ``contact_names`` of the whole drive; without form errors: ``normal`` and ``tangential`` forces of the contacts,
    ``slip``, shape (contacts,), ``input_torque`` [N·m], and ``drift_per_output_turn`` [rad];
    ``output_per_input``, speed of the output over that of the input, with its sign [-].
    """

    contact_names: tuple[str, ...]
    components: tuple[Component, ...]
    normal: np.ndarray
    tangential: np.ndarray
    slip: np.ndarray
    input_torque: float
    drift_per_output_turn: float
    output_per_input: float

    @property
    def transmission_error(self) -> Budget:
        """Of the transmission error, shape () [rad]."""
        return self.budget("transmission_error")

    def budget(self, name: str) -> Budget:
        """Of one quantity of the components, by its name there."""
        return budget(self.components, np.array([getattr(one, name) for one in self.components]))

    @property
    def may_slip(self) -> np.ndarray:
        """Whether a contact may slip as a whole within a turn, by the worst sum to first order, shape (contacts,)."""
        found: np.ndarray = self.slip + self.budget("slip").worst >= 1.0
        return found


class OverTurn(NamedTuple):
    """A joint over one turn of its output; phases that are not known are 0.

    ``angle`` of the output, shape (instants,) [rad]; ``transmission_error``, likewise [rad]; ``input_torque`` [N·m];
    ``normal``, ``slip`` of the contacts, shape (instants, contacts) [N] and [-].
    """

    angle: np.ndarray
    transmission_error: np.ndarray
    input_torque: np.ndarray
    normal: np.ndarray
    slip: np.ndarray


#: Relative difference of frequencies below which they are one.
_SAME_FREQUENCY = 1e-9
#: Points to the shortest wave over a turn, and the most of all.
_POINTS, _MOST_POINTS = 24, 20_000


def under_interference(joint: Joint) -> Joint:
    """A joint whose preload is a force with the interference that makes it: parts that turn change the force; pure."""
    if joint.interference is not None:
        return joint
    rest, pattern = assembled(joint_machine(joint)).rest, xp.asarray(joint.pattern)
    interference = xp.sum(pattern * rest.interference) / xp.sum(pattern**2)
    return dataclasses.replace(joint, preload=None, interference=interference)


def rolling_balance_of(
    joint: Joint, *, torque: Real | None = None, backwards: bool = False
) -> RollingBalance:
    """A joint in steady rolling with the equations that it fulfils, of an output torque, of its own if None; pure.

    ``backwards``: with the input the other way round, under the same torque.
    """
    machine = joint_machine(joint)
    pressed = pressed_at(machine, assembled(machine))
    speed = -joint.input_speed if backwards else joint.input_speed
    machine = machine.under(joint.output_torque if torque is None else torque, speed)
    laws, rest = pressed(machine.joint.output_torque)
    return rolling_balance(
        drive=machine.drive,
        laws=laws,
        rest=rest,
        load=rolling_load(machine),
        creep_of=creep_under(machine),
    )


def rolling_balance_at_once(joint: Joint, *, backwards: bool = False) -> RollingBalance:
    """The same for a joint of numbers; raises NoSolutionError if it does not roll."""
    numbers: Joint = as_numbers(without_duty(joint))
    rolling: RollingBalance = at_once(functools.partial(rolling_balance_of, backwards=backwards), numbers)
    if not float(rolling.state.residual) < ROLLING_TOLERANCE:
        raise NoSolutionError(
            "the joint does not roll steadily under its torque: a contact slips or lifts off; lower the torque "
            "(load.output_torque), or raise the preload or the interference; 'asperity roll' says up to which torque "
            "it rolls"
        )
    return rolling


def accuracy_of(rolling: RollingBalance, errors: Sequence[FormError]) -> Accuracy:
    r"""What form errors do to a joint that rolls, each for itself, to first order.

    Parameters
    ----------
    rolling : RollingBalance
        The whole drive in steady rolling.
    errors : sequence of FormError
        Form errors of its tracks.

    Returns
    -------
    Accuracy
        Responses to all of them.

    References
    ----------
    Equations (R1) to (R4) of :doc:`/equations`.
    """
    drive, state = rolling.machine.drive, rolling.state
    waves = [lobes_of(drive, error.sides, error.harmonic) for error in errors]
    with np.errstate(all="ignore"):
        found = ripples(rolling, waves)
    out = drive.layout.output
    numbers: RollingBalance = trees.map(np.asarray, rolling)
    return Accuracy(
        contact_names=tuple(contact.name for contact in drive.contacts),
        components=tuple(_components(drive, np.asarray(state.speed), errors, waves, found)),
        normal=np.asarray(state.normal),
        tangential=np.asarray(state.tangential),
        slip=np.abs(np.asarray(state.tangential)) / np.asarray(numbers.balance.responses.capacity),
        input_torque=float(state.input_torque),
        drift_per_output_turn=float(drift_per_turn(state.speed_loss)),
        output_per_input=float(state.speed[out]) / float(state.speed[drive.layout.input]),
    )


def _components(
    drive: Drive, speed: np.ndarray, errors: Sequence[FormError], waves: Sequence[Lobes], found: Ripples
) -> list[Component]:
    """The responses at the stated amplitudes and phases."""
    swung = found.error(drive.layout.output)
    made = []
    for k, (error, wave) in enumerate(zip(errors, waves, strict=True)):
        size = error.amplitude * np.exp(1j * (error.phase or 0.0))
        made.append(
            Component(
                error=error,
                order=float(orders(drive, wave, xp.asarray(speed))),
                frequency=float(found.frequency[k]),
                transmission_error=complex(size * swung[k]),
                normal=size * found.normal[k],
                tangential=size * found.tangential[k],
                slip=size * found.slip[k],
                input_torque=complex(size * found.input_torque[k]),
            )
        )
    return made


def budget(components: Sequence[Component], values: np.ndarray) -> Budget:
    r"""Largest sum and root mean square of complex amplitudes, shape (components, ...).

    .. math::
        \hat y = \sum_j |y_j|, \qquad y_{rms} = \sqrt{\tfrac12 \sum_j |y_j|^2}

    Parameters
    ----------
    components : sequence of Component
        Those of one frequency whose phases are known count as one.
    values : ndarray
        Complex amplitudes, components first.

    Returns
    -------
    Budget
        Of the shape of the values without the first axis, and in their unit.

    References
    ----------
    Sums of waves of unlike frequencies; equation (R4) of :doc:`/equations`.
    """
    if not components:
        return Budget(np.zeros(values.shape[1:]), np.zeros(values.shape[1:]))
    frequency = np.array([component.frequency for component in components])
    sums = waves_together(values, frequency, [one.error.phase is not None for one in components])
    return Budget(*(np.asarray(each) for each in sums))


def waves_together(values: Number, frequency: Number, known: Sequence[bool]) -> tuple[Array, Array]:
    """Largest sum and root mean square of waves, shape (waves, ...): those of one frequency count as one.

    If their phases are ``known``. Equation (R4).
    """
    phased = np.array(known, dtype=bool)
    close = abs(frequency[:, None] - frequency) <= _SAME_FREQUENCY * abs(frequency)
    same = xp.where(phased[:, None] & phased, close, np.eye(len(phased), dtype=bool)).astype(float)
    beside = [1] * (values.ndim - 1)
    real, imaginary = (xp.tensordot(same, part, axes=1) for part in (xp.real(values), xp.imag(values)))
    share = (1.0 / xp.sum(same, axis=1)).reshape(-1, *beside)
    square = real**2 + imaginary**2
    swings = square > 0.0
    size = xp.where(swings, xp.sqrt(xp.where(swings, square, 1.0)), 0.0)
    mean = 0.5 * xp.sum(share * square, axis=0)
    moves = mean > 0.0
    return xp.sum(share * size, axis=0), xp.where(moves, xp.sqrt(xp.where(moves, mean, 1.0)), 0.0)


class TurnErrors(NamedTuple):
    """What form errors do over a turn: largest and rms transmission error [rad], largest slip ratio of a contact [-].

    nan where the joint does not roll.
    """

    transmission_error: Real
    transmission_error_rms: Real
    slip_ratio: Real


def turn_errors(
    rolling: RollingBalance, errors: Sequence[FormError], groups: Sequence[int] | None = None
) -> TurnErrors:
    r"""The sums of :func:`accuracy_of` alone; pure: for many joints at once by JAX, with derivatives.

    Parameters
    ----------
    rolling : RollingBalance
        The whole drive in steady rolling.
    errors : sequence of FormError
        Form errors of its tracks, whose amplitudes and phases may be traced.
    groups : sequence of int or None, optional
        A number for each, alike for those of one frequency, as of one harmonic of a part in equal sectors.

    Returns
    -------
    TurnErrors
        Worst and rms transmission error [rad], and the largest slip ratio at the worst phases [-].

    References
    ----------
    Equations (R1) to (R4) of :doc:`/equations`.
    """
    drive, state = rolling.machine.drive, rolling.state
    solved = solved_waves(rolling, [lobes_of(drive, each.sides, each.harmonic) for each in errors], groups)
    angle = xp.stack([xp.asarray(0.0 if each.phase is None else each.phase, dtype=float) for each in errors])
    amplitude = xp.stack([xp.asarray(each.amplitude, dtype=float) for each in errors])
    size = complex_number(amplitude * xp.cos(angle), amplitude * xp.sin(angle))
    known = [each.phase is not None for each in errors]
    swung = swing(solved.speed(rolling.machine)[:, drive.layout.output], solved.frequency)
    worst, rms = waves_together(size * swung, solved.frequency, known)
    slip, _ = waves_together(size[:, None] * slip_of_waves(rolling, solved), solved.frequency, known)
    slips = xp.abs(state.tangential) / rolling.balance.responses.capacity
    rolls = state.residual < ROLLING_TOLERANCE
    return TurnErrors(*(xp.where(rolls, each, xp.nan) for each in (worst, rms, xp.max(slips + slip))))


def over_turn(accuracy: Accuracy) -> OverTurn:
    """A joint over one turn of its output to first order; phases that are not known are 0."""
    highest = max((component.order for component in accuracy.components), default=1.0)
    points = int(min(_MOST_POINTS, max(720, _POINTS * np.ceil(highest))))
    angle = np.linspace(0.0, 2.0 * np.pi, points + 1)
    turned = np.exp(
        1j * np.outer(angle / abs(accuracy.output_per_input), [one.frequency for one in accuracy.components])
    )

    def added(name: str) -> np.ndarray:
        amplitudes = np.array([getattr(one, name) for one in accuracy.components])
        waves: np.ndarray = (turned @ amplitudes).real
        return waves

    return OverTurn(
        angle=angle,
        transmission_error=added("transmission_error"),
        input_torque=accuracy.input_torque + added("input_torque"),
        normal=accuracy.normal + added("normal"),
        slip=accuracy.slip + added("slip"),
    )


def bidirectional(forward: Accuracy, backward: Accuracy) -> Budget:
    r"""Difference of the transmission errors of both directions at the same positions, :math:`|H^+ - H^-|` [rad]."""
    both = zip(forward.components, backward.components, strict=True)
    values = np.array([one.transmission_error - other.transmission_error for one, other in both])
    return budget(forward.components, values)
