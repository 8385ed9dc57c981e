r"""Definition of D and G, and their conversion to other conventions.

The reference is equation (6): term n of the Weierstrass-Mandelbrot profile has the frequency :math:`f_n = \gamma^n / L`
and the amplitude :math:`(\ln\gamma)^{1/2} G^{D-1} f_n^{-(2-D)}`. Random phases give

.. math::
    S(\tau) = \langle [z(x+\tau) - z(x)]^2 \rangle
            = \ln\gamma \, G^{2(D-1)} \sum_n f_n^{-2(2-D)} [1 - \cos(2\pi f_n \tau)]

Since the frequencies are :math:`\ln\gamma` apart in :math:`\ln f`, the sum over n times :math:`\ln\gamma` is
the integral over :math:`df/f` on average over one logarithmic period: the factor :math:`(\ln\gamma)^{1/2}` of
(6) is there to make G independent of gamma. Everything below is that integral.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import gamma as gamma_function

from asperity.errors import InputError


def validated_fractal(*, fractal_dimension: float, fractal_roughness: float) -> tuple[float, float]:
    """D and G, if they are inside the range where the Weierstrass-Mandelbrot model means something.

    An ``InputError`` unless 1 < D < 2 and G is positive and finite.
    """
    if not 1.0 < fractal_dimension < 2.0:
        raise InputError(
            f"the fractal dimension is {fractal_dimension}; that of a profile lies between 1 and 2 (that of a "
            "surface minus 1)"
        )
    if not (fractal_roughness > 0.0 and math.isfinite(fractal_roughness)):
        raise InputError(f"the fractal roughness G is {fractal_roughness} m; it must be a positive length")
    return float(fractal_dimension), float(fractal_roughness)


def power_spectral_density(
    *, frequency: ArrayLike, fractal_dimension: float, fractal_roughness: float
) -> NDArray[np.float64]:
    r"""One-sided power spectral density of a profile against spatial frequency.

    .. math::
        P(f) = \tfrac12 G^{2(D-1)} f^{-(5-2D)}, \qquad \int_0^\infty P \, df = \langle z^2 \rangle

    Of f [1/m], in cycles per metre, D [-] and G [m]: P [m^3], half of the squared amplitude of term n, spread over the
    distance :math:`f_n \ln\gamma` of the frequencies.

    Examples
    --------
    >>> float(power_spectral_density(frequency=1.0, fractal_dimension=1.5, fractal_roughness=1.0))
    0.5
    """
    f = np.asarray(frequency, dtype=np.float64)
    D = fractal_dimension
    return np.asarray(
        0.5 * np.exp(2.0 * (D - 1.0) * math.log(fractal_roughness) - (5.0 - 2.0 * D) * np.log(f))
    )


def structure_function_constant(*, fractal_dimension: float) -> float:
    r"""Constant c(D) of the structure function :math:`S(\tau) = c(D)\, G^{2(D-1)} \tau^{4-2D}`.

    .. math::
        c(D) = (2\pi)^{2H} \int_0^\infty \frac{1 - \cos u}{u^{1+2H}} du
             = \frac{\pi (2\pi)^{2H}}{2\,\Gamma(1+2H)\,\sin(\pi H)}, \qquad H = 2 - D

    Examples
    --------
    >>> round(structure_function_constant(fractal_dimension=1.5) / math.pi**2, 12)
    1.0
    """
    H = 2.0 - fractal_dimension
    return math.pi * (2.0 * math.pi) ** (2.0 * H) / (2.0 * math.gamma(1.0 + 2.0 * H) * math.sin(math.pi * H))


def structure_function(
    *, lag: ArrayLike, fractal_dimension: float, fractal_roughness: float
) -> NDArray[np.float64]:
    r"""Structure function of the model, :math:`S(\tau) = c(D)\, G^{2(D-1)} \tau^{4-2D}` [m^2], tau in [m].

    It is exact for the continuous spectrum, and for the Weierstrass-Mandelbrot profile with all n from minus
    to plus infinity it is the average of :math:`S \tau^{-2H}` over one logarithmic period :math:`\ln\gamma`.
    """
    tau = np.asarray(lag, dtype=np.float64)
    c = structure_function_constant(fractal_dimension=fractal_dimension)
    D = fractal_dimension
    return np.asarray(
        c * np.exp(2.0 * (D - 1.0) * math.log(fractal_roughness) + (4.0 - 2.0 * D) * np.log(tau))
    )


def roughness_from_structure_function(*, level: float, lag: float, fractal_dimension: float) -> float:
    r"""G [m] from the value S [m^2] of the structure function at the lag tau [m]."""
    c = structure_function_constant(fractal_dimension=fractal_dimension)
    D = fractal_dimension
    return math.exp((math.log(level / c) - (4.0 - 2.0 * D) * math.log(lag)) / (2.0 * (D - 1.0)))


def mean_cosine_power(*, fractal_dimension: float) -> float:
    r"""Mean of :math:`|\cos\theta|^{2H}` over directions, :math:`\Gamma(H+\frac12)/(\sqrt\pi\Gamma(H+1))`."""
    H = 2.0 - fractal_dimension
    return float(gamma_function(H + 0.5) / (math.sqrt(math.pi) * gamma_function(H + 1.0)))


def profile_roughness_from_areal(*, fractal_dimension: float, areal_fractal_roughness: float) -> float:
    r"""G of a straight profile across an isotropic surface whose areal sum has :math:`G_a`.

    .. math::
        G^{2(D-1)} = G_a^{2(D-1)} \langle |\cos\theta|^{2H} \rangle

    A wave of frequency f that runs at the angle theta to the profile shows the lower frequency :math:`f\cos\theta`.
    """
    m = mean_cosine_power(fractal_dimension=fractal_dimension)
    return areal_fractal_roughness * m ** (1.0 / (2.0 * (fractal_dimension - 1.0)))


def areal_roughness_from_profile(*, fractal_dimension: float, fractal_roughness: float) -> float:
    """Areal G of an isotropic surface from the G of its profiles; inverse of the function above."""
    m = mean_cosine_power(fractal_dimension=fractal_dimension)
    return fractal_roughness * m ** (-1.0 / (2.0 * (fractal_dimension - 1.0)))
