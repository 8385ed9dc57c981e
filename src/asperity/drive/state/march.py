r"""A rolling drive with form errors from instant to instant, without a linear approximation.

The equations of steady rolling with the form at every instant, and the movement of the centres by backward differences
of second order over equal steps of the angle of the input:

.. math::
    \frac{du}{d\tau} = \frac{3 u_k - 4 u_{k-1} + u_{k-2}}{2 \Delta\tau}, \qquad
    \frac{d\phi_b}{d\tau} = \omega_b - \omega_c

The bodies turn by their own speeds, which creep and form change, not by the ideal ones: otherwise energy is lost.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.form import Form, Lobes, form_of_waves, waves_at_contacts
from asperity.drive.state.equations import (
    Machine,
    Task,
    Unknowns,
    contact_forces,
    contact_responses,
    speeds_and_turns,
    state_misfits,
)
from asperity.drive.state.form_terms import with_form
from asperity.drive.state.ripple import Ripples, velocity_slopes
from asperity.drive.state.rolling_balance import RollingBalance
from asperity.drive.state.search import Balance, newton, state_of
from asperity.drive.state.slopes import newton_step, responses_and_slopes, state_slopes
from asperity.drive.state.state import STATE_TOLERANCE
from asperity.engine.arrays import xp
from asperity.errors import NoSolutionError
from asperity.linear import solve_in_turn

#: Rounds in which the angles of the bodies and their speeds settle within one step.
_ROUNDS = 2


class Wave(NamedTuple):
    """A harmonic of a track with its amplitude [m] and its phase, at no turn of its body [rad]."""

    lobes: Lobes
    amplitude: float
    phase: float


class Turning(NamedTuple):
    """A drive over the angle of its input, one instant a row.

    ``angle`` of the input [rad]; ``normal``, ``tangential``, shape (instants, contacts) [N]; ``slip``, tangential force
    over what the contact bears, and ``creepage``, likewise [-]; ``speed`` of the members over that of the input, shape
    (instants, members) [-]; ``input_torque``, shape (instants,) [N·m].
    """

    angle: np.ndarray
    normal: np.ndarray
    tangential: np.ndarray
    slip: np.ndarray
    creepage: np.ndarray
    speed: np.ndarray
    input_torque: np.ndarray

    def error(self, member: int) -> np.ndarray:
        """Angle by which a member deviates from a steady rotation at its mean speed, its mean 0 [rad]."""
        speed = self.speed[:, member]
        deviates = speed - speed[1:].mean()
        steps = 0.5 * (deviates[1:] + deviates[:-1]) * np.diff(self.angle)
        angle = np.concatenate([[0.0], np.cumsum(steps)])
        shown: np.ndarray = angle - angle.mean()
        return shown


def march(
    rolling: RollingBalance, waves: Sequence[Wave], linear: Ripples, *, angle: float, steps: int
) -> Turning:
    """A drive with form errors over an angle of its input.

    Parameters
    ----------
    rolling : RollingBalance
        The unfolded drive with round tracks.
    waves : sequence of Wave
        Form errors of its tracks.
    linear : Ripples
        What they do to first order: where the march starts.
    angle : float
        Angle of the input in its ideal sense [rad].
    steps : int
        Number of equal steps, thirty or more to the shortest wave.

    Returns
    -------
    Turning
        Both ends included.

    Raises
    ------
    NoSolutionError
        If a contact slips as a whole or lifts off.

    References
    ----------
    Equations (R1) to (R3) of :doc:`/equations`; backward differences of second order (BDF2).
    """
    step = angle / steps
    lengths = float(rolling.machine.length)
    moved = np.asarray(rolling.balance.unknowns.displacement) * lengths
    before = [_linear_displacement(moved, waves, linear, -k * step) for k in (2, 1)]
    spun = [_linear_spin(rolling, waves, linear, -step)]
    speed = _linear_speed(rolling, waves, linear, -step)
    x, instants = rolling.balance.unknowns, []
    for k in range(steps + 1):
        guess, spin = speed, spun[-1]
        for _ in range(_ROUNDS):
            turned = spin + 0.5 * step * (_spins(rolling, speed) + _spins(rolling, guess))
            now = _Instant(rolling, waves, turned, before, step)
            x = now.found(x)
            guess = np.asarray(speeds_and_turns(now.machine, x, now.task.kind)[0])
        speed, spun = guess, [turned]
        before = [before[1], np.asarray(x.displacement) * lengths]
        instants.append(now.row(k * step, x))
    return Turning(*(np.array(each) for each in zip(*instants, strict=True)))


class _Instant:
    """The equations at one instant, of the angles of the bodies and the displacements at the two instants before."""

    def __init__(
        self,
        rolling: RollingBalance,
        waves: Sequence[Wave],
        turned: np.ndarray,
        before: list[np.ndarray],
        step: float,
    ) -> None:
        self.machine = with_form(rolling.machine, form_at(rolling.machine, waves, turned))
        self.task, self._before, self._step = rolling.task, before, step
        self._slides = xp.zeros_like(rolling.balance.slides)
        self._damping = xp.asarray(1.5 / step * velocity_slopes(rolling.machine))

    def _task_at(self, x: Unknowns) -> Task:
        moved = x.displacement * self.machine.length
        velocity = (3.0 * moved - 4.0 * self._before[1] + self._before[0]) / (2.0 * self._step)
        return self.task._replace(velocity=velocity)

    def found(self, start: Unknowns) -> Unknowns:
        """The unknowns at this instant."""
        contacts = start.normal.size
        moves = slice(2 * contacts, None)

        def step_at(x: Unknowns) -> Unknowns:
            task = self._task_at(x)
            responses = responses_and_slopes(self.machine, task, x)
            slopes = state_slopes(self.machine, task, 0, self._slides, x, responses)
            moved = self._damping[contacts : 2 * contacts, moves]
            slopes = slopes._replace(held_moves=slopes.held_moves + moved)
            misfits = state_misfits(self.machine, task, 0, self._slides, x, responses.value)
            return newton_step(slopes, misfits.all, solve_in_turn)

        x, _ = newton(step_at, start, positive=contacts)
        if not float(state_of(self.machine, self._task_at(x), self._balance(x)).residual) < STATE_TOLERANCE:
            raise NoSolutionError(
                "with these form errors a contact slips as a whole or lifts off within a turn: state smaller ones, or "
                "lower the torque"
            )
        return x

    def _balance(self, x: Unknowns) -> Balance:
        responses = contact_responses(self.machine, self._task_at(x), *contact_forces(self.machine, x))
        return Balance(x, responses, self._slides)

    def row(self, angle: float, x: Unknowns) -> tuple[float | np.ndarray, ...]:
        """What :class:`Turning` has at this instant."""
        balance = self._balance(x)
        state = state_of(self.machine, self._task_at(x), balance)
        return (
            angle,
            np.asarray(state.normal),
            np.asarray(state.tangential),
            np.abs(np.asarray(state.tangential)) / np.asarray(balance.responses.capacity),
            np.asarray(state.creepage),
            np.asarray(state.speed),
            float(state.input_torque),
        )


def form_at(machine: Machine, waves: Sequence[Wave], turned: np.ndarray) -> Form:
    """Form of the tracks at the contacts, of the angles by which the bodies have turned past the carrier [rad]."""
    total = [xp.zeros(len(machine.drive.contacts)) for _ in range(4)]
    for lobes, amplitude, phase in waves:
        wave = amplitude * np.exp(1j * (phase - lobes.harmonic * turned[lobes.body]))
        first, second = waves_at_contacts(machine.drive, lobes)
        form = form_of_waves(wave * first, wave * second, lobes.harmonic)
        parts = (form.first, form.second, form.first_slope, form.second_slope)
        total = [one + other for one, other in zip(total, parts, strict=True)]
    return Form(*total)


def _spins(rolling: RollingBalance, speed: np.ndarray) -> np.ndarray:
    """Speeds of the members past the carrier, shape (members,)."""
    spins: np.ndarray = speed - speed[rolling.machine.drive.layout.carrier]
    return spins


def _waves_at(waves: Sequence[Wave], linear: Ripples, angle: float) -> np.ndarray:
    """Each wave at an angle of the input as a complex number, shape (waves,) [m]."""
    sizes = np.array([wave.amplitude * np.exp(1j * wave.phase) for wave in waves], dtype=complex)
    at: np.ndarray = sizes * np.exp(1j * linear.frequency * angle)
    return at


def _linear_displacement(
    steady: np.ndarray, waves: Sequence[Wave], linear: Ripples, angle: float
) -> np.ndarray:
    moved: np.ndarray = steady + (_waves_at(waves, linear, angle) @ linear.displacement).real
    return moved


def _linear_speed(
    rolling: RollingBalance, waves: Sequence[Wave], linear: Ripples, angle: float
) -> np.ndarray:
    speed: np.ndarray = (
        np.asarray(rolling.state.speed) + (_waves_at(waves, linear, angle) @ linear.speed).real
    )
    return speed


def _linear_spin(rolling: RollingBalance, waves: Sequence[Wave], linear: Ripples, angle: float) -> np.ndarray:
    """Angles of the members past the carrier, 0 at the start but for what the form has added [rad]."""
    swung = (_waves_at(waves, linear, angle) / (1j * linear.frequency)) @ linear.speed
    steady = angle * np.asarray(rolling.state.speed)
    return _spins(rolling, steady + swung.real)
