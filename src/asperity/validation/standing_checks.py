"""A joint that stands: vibration between motor and load, wind-up, and its exported models, by hand and closed form."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

import numpy as np
from scipy.linalg import eigh

from asperity.drive.structure.dynamics import SprungDrive, frequency_response, natural_frequencies
from asperity.joint.play import NO_PLAY
from asperity.standing.parallel_elements import ParallelElements, parallel_elements
from asperity.standing.series_law import SeriesLaw, slip_elements
from asperity.standing.windup import Windup, windup_of
from asperity.validation.check import Check, compared


def _chain(inertias: np.ndarray, springs: np.ndarray, dampers: np.ndarray) -> tuple[SprungDrive, np.ndarray]:
    """A roller between motor and load that turns against both, and the angles by which it winds its two springs.

    ``inertias`` of motor, roller and load [kg·m²]; ``springs`` [N·m/rad] and ``dampers`` [N·m·s/rad] in series on both
    sides of the roller. In the angles of motor, roller and load; the load turns at 1.25 of the motor.
    """
    length, between = 0.1, np.array([[-0.5, 1.0, 0.0], [0.0, -2.5, 1.0]])
    order = [1, 0, 2]  # motor and load are the last two coordinates
    joint = SprungDrive(
        laws=length**2 * np.diag(1.0 / springs),
        elongation=length * between[:, order],
        slides=np.zeros(2, dtype=bool),
        bearings=np.zeros(3),
        creep=length**2 * np.diag(1.0 / dampers),
        mass=np.diag(inertias[order]),
        rigid=np.array([0.5, 1.0, 1.25]),
        moves=0,
        length=length,
    )
    return joint, between


def vibrations() -> Iterator[Check]:
    """A joint between motor and load."""
    inertias, springs, dampers = np.array([2e-4, 1e-4, 5e-2]), np.array([3e4, 8e4]), np.array([30.0, 50.0])
    joint, between = _chain(inertias, springs, dampers)
    found = natural_frequencies(joint)
    matrix, mass, frequency = between.T @ np.diag(springs) @ between, np.diag(inertias), 20.0
    eigenvalues = (
        eigh(matrix[1:, 1:], mass[1:, 1:], eigvals_only=True)[0],
        eigh(matrix, mass, eigvals_only=True)[1],
    )
    check = functools.partial(compared, model="Joint between motor and load", tolerance=1e-8)
    yield check(
        reference="eigenvalues of motor, roller and load, 0.2, 0.1 and 50 g·m², on springs of 30 and 80 kN·m/rad",
        quantity="natural frequency with the motor locked and free",
        unit="Hz",
        expected=np.sqrt(eigenvalues) / (2.0 * math.pi),
        computed=[found.locked, found.free],
    )
    omega, ratio = 2.0 * math.pi * frequency, 1.25
    series = between.T @ np.diag(1.0 / (1.0 / springs + 1.0 / (1j * omega * dampers))) @ between
    # the torque of the motor and its angle referred to the load
    angles = np.linalg.solve(series - omega**2 * mass, [ratio, 0.0, 0.0])
    response = frequency_response(joint=joint, frequency=np.array([frequency]), loss_factor=0.0)
    expected, computed = [angles[0] * ratio, angles[2]], [response.motor[0], response.load[0]]
    yield check(
        reference="linear system of the same with dampers of 30 and 50 N·m·s/rad in series, 1 N·m, 20 Hz",
        quantity="angle of motor and load, real and imaginary part",
        unit="µrad",
        expected=1e6 * np.concatenate([np.real(expected), np.imag(expected)]),
        computed=1e6 * np.concatenate([np.real(computed), np.imag(computed)]),
    )


_LARGEST, _BASE, _SLIP = 5.0, 1.0 / 3e4, 2e-7  # N·m, rad/(N·m), rad/(N·m)³


def _wound_up() -> Windup:
    """A joint whose compliance grows with the square of the torque, all of it by slip."""
    return windup_of(
        lambda torque: (_BASE + 3.0 * _SLIP * torque**2, _BASE + 0.0 * torque),
        largest_torque=_LARGEST,
        stage_shares=(0.3, 0.6),
        play=NO_PLAY,
    )


def windup() -> Iterator[Check]:
    """Wind-up, hysteresis, and both models of them that are exported."""
    curve, slip = _wound_up(), _SLIP * _LARGEST**3
    law, torque = SeriesLaw(curve, NO_PLAY), np.array([-_LARGEST, 0.3 * _LARGEST, _LARGEST])
    source = "closed form by Masing's rule: compliance 1/(30 kN·m/rad) + 6e-7 T², up to 5 N·m"
    check = functools.partial(compared, model="Wind-up and hysteresis", reference=source, tolerance=1e-9)
    yield check(
        quantity="angle on first loading at the largest torque, and width of the loop at zero torque",
        unit="µrad",
        expected=1e6 * np.array([_BASE * _LARGEST + slip, 1.5 * slip]),
        computed=1e6 * np.array([curve.angle[-1], curve.hysteresis]),
    )
    yield check(
        quantity="energy lost in a cycle",
        unit="mJ",
        expected=2e3 * slip * _LARGEST,
        computed=1e3 * curve.dissipated_energy,
    )
    yield check(
        quantity="secant stiffness of the three stages",
        unit="N·m/rad",
        expected=[
            1.0 / (_BASE + _SLIP * (high**3 - low**3) / (high - low))
            for low, high in ((0.0, 1.5), (1.5, 3.0), (3.0, 5.0))
        ],
        computed=curve.stage_stiffness,
    )
    jenkins = ParallelElements(
        np.zeros(3), np.array([60.0, 30.0, 10.0]), np.array([0.3, 0.6, 1.0]) / [60, 30, 10]
    )
    yield compared(
        model="Exported elements, MuJoCo and Modelica",
        reference="MuJoCo 4.0, springyield: springs of 60, 30 and 10 N·m/rad that yield at 0.3, 0.6 and 1 N·m",
        quantity="angle at 1.2, -1.2 and 1.2 N·m, and after each of them without torque",
        unit="rad",
        expected=[0.030, 0.015, -0.030, -0.015, 0.030, 0.015],
        computed=jenkins.angles(np.array([1.2, 0.0, -1.2, 0.0, 1.2, 0.0]), largest_angle=1.0),
        tolerance=2e-5,
        absolute=True,
    )
    parallel = parallel_elements(law, elements=16)
    angles = parallel.angles(np.array([_LARGEST, 0.0, -_LARGEST, 0.0]), largest_angle=1e-2)
    yield compared(
        model="Exported elements, MuJoCo and Modelica",
        reference=source,
        quantity="angle at the largest torque of both signs, and width of the loop at zero torque",
        unit="µrad",
        expected=1e6 * np.array([_BASE * _LARGEST + slip, -_BASE * _LARGEST - slip, 1.5 * slip]),
        computed=1e6 * np.array([angles[0], angles[2], angles[1] - angles[3]]),
        tolerance=0.01,
    )
    series = slip_elements(law, elements=24)
    slipped = np.maximum(0.0, np.abs(torque)[:, None] - series.threshold) @ series.compliance
    yield compared(
        model="Exported elements, FMU",
        reference=source,
        quantity="slip at 30 and 100 % of the largest torque",
        unit="µrad",
        expected=1e6 * _SLIP * np.abs(torque) ** 3,
        computed=1e6 * slipped,
        tolerance=0.01,
    )
