r"""A wind-up as springs in parallel: a reversible one, and elasto-plastic ones that make the hysteresis loop.

.. math::
    T(\varphi) = a \varphi + b \varphi^2 + c \varphi^3 + \sum_i k_i \, (\varphi - p_i),
    \qquad |\varphi - p_i| \le y_i

Each element is a spring in series with a slider (Jenkins), whose position p moves only at the limits. Many of them side
by side are Iwan's model, which follows Masing's rule. The wind-up itself is a reversible spring in series with slip
that follows Masing's rule; the fit therefore has an error, which it states.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.optimize import brentq, nnls

from asperity.standing.series_law import SeriesLaw

_POINTS = 121  # of each piece of a path
_LOOP_WEIGHT = 30.0  # of the loop's torque width, over that of the torque
_NO_SLIP = 1e-9  # slip over wind-up below which there is no loop
_ALIKE = 1e-9  # difference of both directions over wind-up below which they are the same


@dataclass(frozen=True)
class ParallelElements:
    """Springs in parallel. SI units.

    Parameters
    ----------
    spring : ndarray
        Coefficients a, b, c of the reversible spring, shape (3,) [N·m/rad, N·m/rad^2, N·m/rad^3].
    stiffness, yield_angle : ndarray
        Stiffness of the elasto-plastic elements, and the angle at which each yields, shape (n,) [N·m/rad, rad].
    """

    spring: np.ndarray
    stiffness: np.ndarray
    yield_angle: np.ndarray

    def _torque(self, angle: float, slider: np.ndarray) -> float:
        a, b, c = self.spring
        stretch = np.clip(angle - slider, -self.yield_angle, self.yield_angle)
        return angle * (a + angle * (b + angle * c)) + float(stretch @ self.stiffness)

    def torques(self, angles: np.ndarray) -> np.ndarray:
        """Torque along a path of angles [rad] in their order, beginning at rest, shape (m,) [N·m]."""
        return _columns(angles, self.yield_angle, 1.0) @ np.concatenate([self.spring, self.stiffness])

    def angles(self, torques: np.ndarray, *, largest_angle: float) -> np.ndarray:
        """Angle along a path of torques [N·m] in their order, beginning at rest, shape (m,) [rad].

        Bounded by a largest one.
        """
        slider, made = np.zeros_like(self.yield_angle), []
        for torque in torques:
            angle = brentq(
                lambda x, at=slider, wanted=torque: self._torque(x, at) - wanted,
                -largest_angle,
                largest_angle,
                xtol=1e-14 * largest_angle,
            )
            slider = angle - np.clip(angle - slider, -self.yield_angle, self.yield_angle)
            made.append(angle)
        return np.array(made)


@dataclass(frozen=True)
class FitError:
    """Largest deviations of parallel elements from the wind-up they stand for, at equal torque [rad].

    Of the angle, on first loading in both directions, on the loop between plus and minus the largest torque, and on a
    loop of half that torque; and of the width of both loops.
    """

    angle: float
    loop_width: float


def parallel_elements(law: SeriesLaw, *, elements: int) -> ParallelElements:
    """Fit parallel elements to a wind-up."""
    largest, scale = law.largest_torque, _largest_angle(law)
    yield_angle = _yield_angles(law, scale, elements)
    matrices, targets = [], []
    for size in (largest, 0.5 * largest):
        loading_torque, back = np.linspace(0.0, size, _POINTS)[1:], np.linspace(size, -size, 2 * _POINTS)[1:]
        torque = np.concatenate([loading_torque, back, -back])
        angle = np.concatenate(
            [
                law.loading(loading_torque),
                law.branch(back, size=size, sense=-1.0),
                law.branch(-back, size=size, sense=1.0),
            ]
        )
        columns = _columns(angle, yield_angle, scale)
        down, up = np.split(np.arange(loading_torque.size, angle.size), 2)
        down = down[::-1]  # angles that grow, for interpolation

        def lowered(
            values: np.ndarray, angle: np.ndarray = angle, down: Any = down, up: Any = up
        ) -> np.ndarray:
            return values[up] - np.interp(angle[up], angle[down], values[down])

        width = np.stack([lowered(column) for column in columns.T], axis=1)
        matrices += [
            columns,
            _columns(law.loading(-loading_torque), yield_angle, scale),
            _LOOP_WEIGHT * width,
        ]
        targets += [torque, -loading_torque, _LOOP_WEIGHT * lowered(torque)]
    matrix = np.concatenate(matrices)
    if _is_odd(law, scale):
        matrix[:, 1] = 0.0
    both_signs = np.concatenate([matrix, -matrix[:, 1:3]], axis=1)
    coefficients, _ = nnls(both_signs, np.concatenate(targets) / largest, maxiter=100 * both_signs.shape[1])
    coefficients *= largest
    coefficients[1:3] -= coefficients[-2:]
    stiffness = coefficients[3:-2] / scale
    used = stiffness > 0.0
    return ParallelElements(coefficients[:3] / scale ** np.arange(1, 4), stiffness[used], yield_angle[used])


def fit_error(law: SeriesLaw, fitted: ParallelElements) -> FitError:
    """Compare parallel elements with the wind-up they stand for, under control of the torque."""
    bound = 2.0 * _largest_angle(law)
    angle_error, width_error = 0.0, 0.0
    for size in (law.largest_torque, 0.5 * law.largest_torque):
        loading_torque, back = np.linspace(0.0, size, _POINTS)[1:], np.linspace(size, -size, _POINTS)[1:]
        angles = fitted.angles(np.concatenate([loading_torque, back, -back]), largest_angle=bound)
        loading, down, up = np.split(angles, [loading_torque.size, loading_torque.size + back.size])
        other = fitted.angles(-loading_torque, largest_angle=bound)
        true_down, true_up = (law.branch(way * -back, size=size, sense=way) for way in (-1.0, 1.0))
        deviations = (
            loading - law.loading(loading_torque),
            other - law.loading(-loading_torque),
            down - true_down,
            up - true_up,
        )
        angle_error = max(angle_error, *(float(np.max(np.abs(deviation))) for deviation in deviations))
        widths = (down[:-1] - up[-2::-1]) - (true_down[:-1] - true_up[-2::-1])
        width_error = max(width_error, float(np.max(np.abs(widths))))
    return FitError(angle_error, width_error)


def _largest_angle(law: SeriesLaw) -> float:
    return float(np.max(np.abs(law.loading(np.array([-law.largest_torque, law.largest_torque])))))


def _is_odd(law: SeriesLaw, scale: float) -> bool:
    torque = law.slip_torque
    return bool(np.max(np.abs(law.loading(torque) + law.loading(-torque))) < _ALIKE * scale)


def _columns(angles: np.ndarray, yield_angle: np.ndarray, scale: float) -> np.ndarray:
    """What each unknown of the fit adds along a path: powers of the angle, and stretch of each element."""
    stretch = np.empty((angles.size, yield_angle.size))
    slider = np.zeros_like(yield_angle)
    for index, angle in enumerate(angles):
        stretch[index] = np.clip(angle - slider, -yield_angle, yield_angle)
        slider = angle - stretch[index]
    powers = (angles[:, None] / scale) ** np.arange(1, 4)
    return np.concatenate([powers, stretch / scale], axis=1)


def _yield_angles(law: SeriesLaw, scale: float, elements: int) -> np.ndarray:
    """Knots of a piecewise straight line that follows the slip: denser where it bends more."""
    torque, slip = law.slip_torque, law.slip_angle
    if elements == 0 or slip[-1] < _NO_SLIP * scale:
        return np.zeros(0)
    bend = np.sqrt(np.abs(np.gradient(np.gradient(slip, torque), torque)))
    density = bend + 0.05 * np.max(bend)
    grown = np.concatenate([[0.0], np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(torque))])
    knots = np.interp(np.arange(1, elements + 1) / (elements + 1) * grown[-1], grown, torque)
    return 0.5 * (law.loading(knots) - law.loading(-knots))
