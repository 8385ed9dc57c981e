"""A joint that stands: vibration between motor and load, wind-up, and its exported models, by hand and closed form."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

import numpy as np
from jax import Array
from scipy.linalg import eigh

from asperity.compilation import call_compiled
from asperity.drive.structure.dynamics import dynamic_stiffness, frequency_response, natural_frequencies
from asperity.joint.play import NO_PLAY
from asperity.standing.parallel_elements import ParallelElements, parallel_elements
from asperity.standing.series_law import SeriesLaw, slip_elements
from asperity.standing.windup import Windup, windup_of
from asperity.types import Real
from asperity.validation.check import Check, compared


def vibrations() -> Iterator[Check]:
    """A joint between motor and load."""
    spring, motor, load, damping = 3e4, 2e-4, 5e-2, 30.0

    def found(stiffness: Array) -> tuple[list[Real], Array, list[Array]]:
        given = {"input_inertia": motor, "output_inertia": load}
        frequencies = natural_frequencies(stiffness=stiffness, **given)
        joint: dict[str, Real] = {"stiffness": stiffness, "loss_factor": 0.0}
        corner = stiffness / damping / (2.0 * math.pi)
        at_corner = dynamic_stiffness(frequency=corner, creep_damping=damping, **joint)
        stands = dynamic_stiffness(frequency=20.0, creep_damping=math.inf, **joint)
        response = frequency_response(frequency=20.0, stiffness=stands, **given)
        return [frequencies.locked, frequencies.free], at_corner, [response.motor, response.load]

    frequencies, at_corner, response = call_compiled(found, spring)
    matrix = spring * np.array([[1.0, -1.0], [-1.0, 1.0]])
    free = eigh(matrix, np.diag([motor, load]), eigvals_only=True)[1]
    check = functools.partial(compared, model="Joint between motor and load", tolerance=1e-9)
    yield check(
        reference="eigenvalues of two inertias on a spring: 30 kN·m/rad, 0.2 and 50 g·m²",
        quantity="natural frequency with the motor locked and free",
        unit="Hz",
        expected=np.sqrt([spring / load, free]) / (2.0 * math.pi),
        computed=frequencies,
    )
    yield check(
        reference="a spring and a damper in series: (1 + i)/2 of the spring at the corner frequency",
        quantity="dynamic stiffness, real and imaginary part",
        unit="N·m/rad",
        expected=[0.5 * spring, 0.5 * spring],
        computed=[at_corner.real, at_corner.imag],
    )
    yield check(
        reference="linear system of two inertias on a spring, 1 N·m at the motor, 20 Hz",
        quantity="angle of motor and load",
        unit="µrad",
        expected=1e6 * np.linalg.solve(matrix - np.diag([motor, load]) * (40.0 * math.pi) ** 2, [1.0, 0.0]),
        computed=1e6 * np.real(response),
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
