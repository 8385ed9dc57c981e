r"""A joint between the inertia of its motor and that of its load: natural frequencies and frequency response.

All members turn and all floating centres move on the springs of contacts, pins, bearings and shafts. While the drive
turns, each contact's spring is in series with its creep: elastic above a corner frequency, viscous below it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive, speeds
from asperity.drive.stiffness.network import SpringLaws

_MASSLESS = 1e-14  # of the largest mass or eigenvalue: nothing but rounding


class SprungDrive(NamedTuple):
    r"""A drive on its springs between motor and load, its grounded member held. SI units.

    The coordinates are the motions of :func:`asperity.drive.structure.inertia.mass_matrix`, then the angles of motor
    and load.

    Parameters
    ----------
    laws, elongation, slides, bearings : ndarray
        As of :class:`asperity.drive.stiffness.network.SpringLaws`, for the forces of all sectors together; the shafts
        of motor and load are the last two springs.
    creep : ndarray
        Speeds of creep under the forces of the springs, shape (springs, springs) [m/(N·s)]; 0 for a drive that stands.
    mass : ndarray
        Masses and moments of inertia, shape (coordinates, coordinates).
    rigid : ndarray
        Motion that lengthens no spring, over the angle of the motor, shape (coordinates,).
    moves : int
        How many of the coordinates, the first ones, are displacements.
    length : float
        A radius that makes angles lengths [m].
    """

    laws: np.ndarray
    elongation: np.ndarray
    slides: np.ndarray
    bearings: np.ndarray
    creep: np.ndarray
    mass: np.ndarray
    rigid: np.ndarray
    moves: int
    length: float

    @property
    def total_inertia(self) -> float:
        """Inertia of everything that rolls without slip, referred to the load [kg·m^2]."""
        return float(self.rigid @ self.mass @ self.rigid / self.rigid[-1] ** 2)


def sprung_drive(
    *,
    drive: Drive,
    springs: SpringLaws,
    shafts: tuple[float, float],
    mass: np.ndarray,
    ends: tuple[float, float],
    creep: tuple[np.ndarray, np.ndarray] | None,
) -> SprungDrive:
    """A drive between motor and load.

    Parameters
    ----------
    drive : Drive
        The drive.
    springs : SpringLaws
        Its springs.
    shafts : tuple of float
        Compliances between motor and input, and between output and load [rad/(N·m)].
    mass : ndarray
        Of :func:`asperity.drive.structure.inertia.mass_matrix`.
    ends : tuple of float
        Moments of inertia of motor and load [kg·m^2].
    creep : tuple of ndarray or None
        Slopes of the speeds of creep by the normal and by the tangential forces of one sector, shape (contacts,)
        [m/(N·s)]; None for a drive that stands.

    Returns
    -------
    SprungDrive
        With its grounded member held.

    References
    ----------
    Equations (A8), (D1) and (D3) of :doc:`/equations`.
    """
    moves, members = 2 * len(drive.floating), drive.members
    length, sectors = float(np.max(drive.second_radius)), float(drive.sectors)
    inner, motions = np.shape(springs.elongation)
    laws = np.zeros((inner + 2, inner + 2))
    slides = np.append(np.asarray(springs.slides), [False, False])
    # of the forces of all sectors; what a contact that slides carries is a ratio
    laws[:inner, :inner] = np.where(slides[:inner, None], springs.laws, np.asarray(springs.laws) / sectors)
    laws[[inner, inner + 1], [inner, inner + 1]] = length**2 * np.asarray(shafts)
    elongation = np.zeros((inner + 2, motions + 2))
    elongation[:inner, :motions] = springs.elongation
    elongation[inner, [motions, moves + members.index(drive.input)]] = length, -length
    elongation[inner + 1, [motions + 1, moves + members.index(drive.output)]] = length, -length
    creeps, count = np.zeros_like(laws), len(drive.contacts)
    if creep is not None:
        rows = np.arange(count, 2 * count)
        creeps[rows, np.arange(count)], creeps[rows, rows] = (slope / sectors for slope in creep)
    masses = np.zeros((motions + 2,) * 2)
    masses[:motions, :motions] = mass
    masses[[motions, motions + 1], [motions, motions + 1]] = ends
    turns = drive.sense * np.asarray(speeds(drive), dtype=float)
    rigid = np.concatenate(
        [np.zeros(moves), turns, turns[[members.index(drive.input), members.index(drive.output)]]]
    )
    moving = np.delete(np.arange(motions + 2), moves + members.index(drive.grounded))
    return SprungDrive(
        laws=laws,
        elongation=elongation[:, moving],
        slides=slides,
        bearings=np.append(np.asarray(springs.bearings), [0.0, 0.0])[moving],
        creep=creeps,
        mass=masses[np.ix_(moving, moving)],
        rigid=rigid[moving],
        moves=moves,
        length=length,
    )


class _Scaled(NamedTuple):
    """A sprung drive in lengths: angles times its length, forces times a compliance."""

    laws: np.ndarray
    moved_by: np.ndarray
    loaded_by: np.ndarray
    bearings: np.ndarray
    creep: np.ndarray
    mass: np.ndarray
    rigid: np.ndarray
    compliance: float


def _scaled(joint: SprungDrive) -> _Scaled:
    size = np.where(np.arange(joint.rigid.size) < joint.moves, 1.0, 1.0 / joint.length)
    own = np.diag(joint.laws)[~joint.slides]
    compliance = float(np.mean(own[own > 0.0])) if np.any(own > 0.0) else np.nan
    loaded_by = joint.elongation * size
    return _Scaled(
        laws=np.where(joint.slides[:, None], joint.laws, joint.laws / compliance),
        moved_by=np.where(joint.slides[:, None], 0.0, loaded_by),
        loaded_by=loaded_by,
        bearings=joint.bearings * size**2 * compliance,
        creep=np.where(joint.slides[:, None], 0.0, joint.creep / compliance),
        mass=joint.mass * np.outer(size, size) * compliance,
        rigid=joint.rigid / size,
        compliance=compliance,
    )


def _flexibility(scaled: _Scaled) -> np.ndarray:
    """Coordinates under loads on them, the motor held, over the compliance of the scale [-]."""
    free = np.arange(scaled.rigid.size) != scaled.rigid.size - 2
    moved, loaded = scaled.moved_by[:, free], scaled.loaded_by[:, free]
    system = np.block([[scaled.laws, -moved], [loaded.T, np.diag(scaled.bearings[free])]])
    unit = np.concatenate([np.zeros((len(scaled.laws), free.sum())), np.eye(free.sum())])
    flexibility = np.zeros((scaled.rigid.size,) * 2)
    flexibility[np.ix_(free, free)] = np.linalg.solve(system, unit)[len(scaled.laws) :]
    return flexibility


class NaturalFrequencies(NamedTuple):
    """Frequencies of a joint between two inertias.

    Parameters
    ----------
    locked, free : float
        With the motor held, at which a torque of the motor does not move the motor; and with both sides free [Hz].
    """

    locked: float
    free: float


def natural_frequencies(joint: SprungDrive) -> NaturalFrequencies:
    r"""Natural frequency with the motor locked (antiresonance) and with both sides free (resonance).

    .. math:: G M\, q = \frac{1}{(2 \pi f_a)^2}\, q, \qquad
        \Bigl(1 - \frac{r\,r^\mathsf{T} M}{r^\mathsf{T} M r}\Bigr) G M\, q = \frac{1}{(2 \pi f_r)^2}\, q

    with the flexibility G of the drive whose motor is held, and the motion r that lengthens no spring.

    Parameters
    ----------
    joint : SprungDrive
        The joint.

    Returns
    -------
    NaturalFrequencies
        Of the mode that has most of the deflection between motor and load under a torque; nan where the springs are
        not known.

    Notes
    -----
    No roller is tied to input or output: the spin of each follows from the springs on its two sides, and its centre
    floats on them. Between soft and stiff contacts it does not turn as rolling without slip demands.

    References
    ----------
    Vibration of all bodies on all springs; equation (D2) of :doc:`/equations`.
    """
    scaled = _scaled(joint)
    if not np.all(np.isfinite(scaled.laws)):
        return NaturalFrequencies(math.nan, math.nan)
    flexibility, rigid = _flexibility(scaled), scaled.rigid
    weight = scaled.mass @ rigid
    released = np.eye(rigid.size) - np.outer(rigid, weight) / (rigid @ weight)
    between = np.zeros(rigid.size)
    between[-1], between[-2] = (
        1.0,
        -rigid[-1] / rigid[-2],
    )  # a torque at the load, and that at the motor against it
    return NaturalFrequencies(
        *(
            _frequency(turned, scaled.mass, between)
            for turned in (flexibility, released @ flexibility @ released.T)
        )
    )


def _frequency(flexibility: np.ndarray, mass: np.ndarray, between: np.ndarray) -> float:
    """Frequency of the mode that has most of the deflection under a load [Hz]."""
    weights, directions = np.linalg.eigh(mass)
    massive = weights > _MASSLESS * weights[-1]
    root = directions[:, massive] * np.sqrt(weights[massive])
    import scipy.linalg

    values, left, right = scipy.linalg.eig(root.T @ flexibility @ root, left=True, right=True)
    moving = np.abs(values) > _MASSLESS * np.max(np.abs(values))
    values, left, right = values[moving], left[:, moving], right[:, moving]
    share = (between @ flexibility @ root @ right) * (left.conj().T @ root.T @ flexibility @ between)
    share = share / (values * np.sum(left.conj() * right, axis=0))
    found = complex(values[np.argmax(np.abs(share))])
    return float(np.real(1.0 / np.sqrt(found)) / (2.0 * math.pi))


def inertia_at_motor(joint: SprungDrive) -> float:
    r"""Inertia of everything as the motor moves it while the load is held, :math:`x^\mathsf{T} M x`.

    Parameters
    ----------
    joint : SprungDrive
        The joint.

    Returns
    -------
    float
        About the axis of the motor [kg·m^2]; x is the deflection of the springs over the angle of the motor.

    References
    ----------
    Kinetic energy of the static deflection, as in Rayleigh's quotient; equation (D2) of :doc:`/equations`.
    """
    scaled = _scaled(joint)
    flexibility, rigid = _flexibility(scaled), scaled.rigid
    shape = rigid - flexibility[:, -1] * rigid[-1] / flexibility[-1, -1]
    return float(shape @ scaled.mass @ shape / scaled.compliance / (rigid[-2] / joint.length) ** 2)


class FrequencyResponse(NamedTuple):
    """Angles per torque of the motor, both referred to the output. Complex.

    Parameters
    ----------
    motor, load : ndarray
        Angle of motor and load per torque at the motor, shape (frequencies,) [rad/(N·m)].
    """

    motor: np.ndarray
    load: np.ndarray


def frequency_response(*, joint: SprungDrive, frequency: np.ndarray, loss_factor: float) -> FrequencyResponse:
    r"""Angles of motor and load under an oscillating torque of the motor.

    .. math::
        \Bigl(\frac{L}{1 + i\eta} + \frac{R}{i\omega}\Bigr) f = B q, \qquad
        B^\mathsf{T} f + (k - \omega^2 M)\,q = g

    Parameters
    ----------
    joint : SprungDrive
        The joint, with the creep R of its contacts where it turns.
    frequency : ndarray
        Frequencies, above 0, shape (frequencies,) [Hz].
    loss_factor : float
        Loss factor eta of all springs [-].

    Returns
    -------
    FrequencyResponse
        Angles per torque, both referred to the output; nan where springs or creep are not known.

    Notes
    -----
    Linear about the working torque; for frequencies at which the contacts roll farther than their width in one period.
    Above, creep begins more slowly (:mod:`asperity.contact.rolling_in`).

    References
    ----------
    Spring and creep of each contact in series; equation (D3) of :doc:`/equations`.
    """
    scaled, ratio = _scaled(joint), joint.rigid[-2] / joint.rigid[-1]
    if not np.all(np.isfinite(scaled.laws)) or not np.all(np.isfinite(scaled.creep)):
        unknown = np.full(frequency.shape, complex(math.nan, math.nan))
        return FrequencyResponse(unknown, unknown)
    omega = 2.0 * math.pi * frequency[:, None, None]
    springs, slides = len(scaled.laws), joint.slides[:, None]
    system = np.zeros((frequency.size, springs + scaled.rigid.size, springs + scaled.rigid.size), complex)
    elastic = np.where(slides, scaled.laws, scaled.laws / (1.0 + 1j * loss_factor))
    system[:, :springs, :springs] = elastic + scaled.creep / (1j * omega)
    system[:, :springs, springs:] = -scaled.moved_by
    system[:, springs:, :springs] = scaled.loaded_by.T
    system[:, springs:, springs:] = np.diag(scaled.bearings) - omega**2 * scaled.mass
    load = np.zeros((system.shape[1], 1), dtype=complex)
    load[-2] = 1.0 / (ratio * joint.length)
    moved = np.linalg.solve(system, np.broadcast_to(load, (frequency.size, *load.shape)))[:, -2:, 0]
    moved = moved * scaled.compliance / joint.length
    return FrequencyResponse(motor=moved[:, 0] / ratio, load=moved[:, 1])
