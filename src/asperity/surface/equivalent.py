"""The equivalent rough surface of two bodies: the sum surface, of which the structure functions add."""

from __future__ import annotations

import math

import jax.numpy as jnp
import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError, NoSolutionError
from asperity.surface import conventions
from asperity.surface.measurement import SurfaceMeasurement

_LAGS = 200
#: Largest error of ln S of the equivalent power law that is accepted [-].
LARGEST_MISFIT = 0.15


def equivalent_surface(*, first: SurfaceMeasurement, second: SurfaceMeasurement) -> SurfaceMeasurement:
    r"""One D and G for the gap between two independent rough surfaces.

    .. math::
        S(\tau) = S_1(\tau) + S_2(\tau)

    Parameters
    ----------
    first, second : SurfaceMeasurement
        The two bodies.

    Returns
    -------
    SurfaceMeasurement
        For equal D exactly :math:`G^{2(D-1)} = G_1^{2(D-1)} + G_2^{2(D-1)}`. Otherwise the sum of two power
        laws is not one; the straight line that fits ln S best, evenly in the logarithm of lag over the common
        band, is returned. The covariance follows from those of both by the derivatives of that rule.

    Raises
    ------
    InputError
        If the two were measured for different gamma.
    NoSolutionError
        If the bands share less than a decade, or the sum departs from a power law by more than 15 % rms.
    """
    gamma = float(first.frequency_ratio)
    if abs(float(second.frequency_ratio) - gamma) > 1e-9 * gamma:
        raise InputError(
            f"the surfaces were measured for gamma = {gamma} and {float(second.frequency_ratio)}; "
            f"use one gamma"
        )
    short = max(float(first.shortest_wavelength), float(second.shortest_wavelength))
    long = min(float(first.longest_wavelength), float(second.longest_wavelength))
    if long < 10.0 * short * (1.0 - 1e-9):
        raise NoSolutionError(
            f"the self-affine bands of the two surfaces share only {short:.3g} .. {long:.3g} m; a "
            f"decade is needed"
        )
    lag = np.geomspace(0.5 * short, 0.5 * long, _LAGS)
    values = np.array(
        [
            float(first.fractal_dimension),
            math.log(float(first.fractal_roughness)),
            float(second.fractal_dimension),
            math.log(float(second.fractal_roughness)),
        ]
    )
    result, misfit = _combined(values, lag)
    if misfit > LARGEST_MISFIT:
        raise NoSolutionError(
            f"the sum of the two surfaces departs from a power law by {100 * misfit:.0f} % rms of "
            f"its structure "
            f"function (limit {100 * LARGEST_MISFIT:.0f} %): D = {values[0]:.3f} and "
            f"{values[2]:.3f} differ too much"
        )
    jacobian = np.empty((2, 4))
    for i in range(4):
        step = np.zeros(4)
        step[i] = 1e-6
        jacobian[:, i] = (_combined(values + step, lag)[0] - _combined(values - step, lag)[0]) / 2e-6
    both = np.zeros((4, 4))
    both[:2, :2], both[2:, 2:] = np.asarray(first.covariance), np.asarray(second.covariance)
    return SurfaceMeasurement(
        fractal_dimension=jnp.asarray(result[0], dtype=jnp.float64),
        fractal_roughness=jnp.asarray(math.exp(result[1]), dtype=jnp.float64),
        frequency_ratio=jnp.asarray(gamma, dtype=jnp.float64),
        covariance=jnp.asarray(jacobian @ both @ jacobian.T, dtype=jnp.float64),
        shortest_wavelength=jnp.asarray(short, dtype=jnp.float64),
        longest_wavelength=jnp.asarray(long, dtype=jnp.float64),
        estimator=f"sum of {first.estimator} and {second.estimator}",
        profiles=first.profiles + second.profiles,
        source=f"{first.source} + {second.source}",
    )


def _combined(values: NDArray[np.float64], lag: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """(D, ln G) of the straight line through ln(S1 + S2), and its rms misfit."""
    logs = []
    for D, log_G in (values[:2], values[2:]):
        c = conventions.structure_function_constant(fractal_dimension=float(D))
        logs.append(math.log(c) + 2.0 * (D - 1.0) * log_G + (4.0 - 2.0 * D) * np.log(lag))
    total = np.logaddexp(*logs)
    slope, level = np.polyfit(np.log(lag), total, 1)
    D = 2.0 - 0.5 * float(slope)
    c = conventions.structure_function_constant(fractal_dimension=D)
    log_G = (float(level) - math.log(c)) / (2.0 * (D - 1.0))
    misfit = float(np.sqrt(np.mean((total - slope * np.log(lag) - level) ** 2)))
    return np.array([D, log_G]), misfit
