"""Random rough surfaces of known D and G: exact self-affine noise and spectral synthesis, profile and map.

All of them take a NumPy random generator, so that a seed fixes the surface.
"""

from __future__ import annotations

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface import conventions


def self_affine_profile(
    *,
    points: int,
    spacing: float,
    fractal_dimension: float,
    fractal_roughness: float,
    random: np.random.Generator,
) -> NDArray[np.float64]:
    r"""Exact self-affine noise: fractional Brownian motion, :math:`S(\tau) = c(D) G^{2(D-1)} \tau^{4-2D}`.

    Heights [m] at points a ``spacing`` [m] apart, from zero on, of D [-] and G [m]. The structure function is exact at
    every lag of the record; nothing is periodic and no frequency is cut off: frequencies above the sampling limit are
    folded back, as they are when a real surface is sampled point by point. The increments are a stationary Gaussian
    sequence; its covariance is embedded in a circulant matrix, which one Fourier transform diagonalises (Davies and
    Harte, Biometrika 74 (1987) 95).
    """
    D, G = conventions.validated_fractal(
        fractal_dimension=fractal_dimension, fractal_roughness=fractal_roughness
    )
    _check_points(points, spacing)
    H = 2.0 - D
    n = scipy.fft.next_fast_len(points - 1, real=True)
    k = np.arange(n + 1, dtype=np.float64)
    covariance = 0.5 * ((k + 1.0) ** (2 * H) - 2.0 * k ** (2 * H) + np.abs(k - 1.0) ** (2 * H))
    power = scipy.fft.rfft(np.concatenate([covariance, covariance[-2:0:-1]])).real
    if power.min() < -1e-9 * power.max():
        raise InputError(f"the covariance for D = {D} cannot be embedded")  # proven impossible for 0 < H < 1
    white = scipy.fft.rfft(random.standard_normal(2 * n))
    increments = scipy.fft.irfft(white * np.sqrt(np.maximum(power, 0.0)), n=2 * n)[: points - 1]
    step = np.sqrt(conventions.structure_function(lag=spacing, fractal_dimension=D, fractal_roughness=G))
    return np.concatenate([[0.0], np.cumsum(step * increments)])


def spectral_profile(
    *,
    points: int,
    spacing: float,
    fractal_dimension: float,
    fractal_roughness: float,
    periodic: bool,
    random: np.random.Generator,
) -> NDArray[np.float64]:
    r"""Gaussian profile [m] whose spectrum is :math:`P(f)` up to the sampling limit and nothing above.

    One period of a periodic profile, or a quarter cut from a periodic profile four times as long.
    """
    D, G = conventions.validated_fractal(
        fractal_dimension=fractal_dimension, fractal_roughness=fractal_roughness
    )
    _check_points(points, spacing)
    n = points if periodic else scipy.fft.next_fast_len(4 * points, real=True)
    frequency = scipy.fft.rfftfreq(n, spacing)
    density = np.zeros_like(frequency)
    density[1:] = conventions.power_spectral_density(
        frequency=frequency[1:], fractal_dimension=D, fractal_roughness=G
    )
    spectrum = scipy.fft.rfft(random.standard_normal(n)) * np.sqrt(density / (2.0 * spacing))
    return scipy.fft.irfft(spectrum, n=n)[:points]


def spectral_surface(
    *,
    rows: int,
    columns: int,
    spacing: float,
    fractal_dimension: float,
    areal_fractal_roughness: float,
    periodic: bool,
    random: np.random.Generator,
) -> NDArray[np.float64]:
    r"""Isotropic Gaussian height map [m] with the areal density :math:`C(f)` up to the sampling limit.

    Its points are a ``spacing`` [m] apart; D [-] is that of its profiles, and the areal G [m] belongs to that of
    :func:`asperity.surface.conventions.profile_roughness_from_areal`. ``periodic`` is one period, otherwise it is a
    quarter cut from a period twice as long and wide. White noise times the square root of the density, by Fourier
    transform; the corners of the frequency square are kept, so that a row of the map has the profile spectrum apart
    from what its cross frequencies lack above the sampling limit.
    """
    D, G = conventions.validated_fractal(
        fractal_dimension=fractal_dimension, fractal_roughness=areal_fractal_roughness
    )
    _check_points(min(rows, columns), spacing)
    factor = 1 if periodic else 2
    height, width = factor * rows, factor * columns
    fx = scipy.fft.rfftfreq(width, spacing)
    fy = scipy.fft.fftfreq(height, spacing)
    spectrum = scipy.fft.rfft2(random.standard_normal((height, width)), workers=2)
    level = G ** (2.0 * (D - 1.0)) / (4.0 * np.pi * spacing**2)
    for row, f in zip(spectrum, fy, strict=True):  # row by row: the density never exists as a whole
        square = fx**2 + f**2
        square[square == 0.0] = np.inf
        row *= np.sqrt(level * square ** (D - 3.0))
    surface = scipy.fft.irfft2(spectrum, s=(height, width), workers=2, overwrite_x=True)
    return np.ascontiguousarray(surface[:rows, :columns])


def _check_points(points: int, spacing: float) -> None:
    if points < 2 or not (spacing > 0.0 and np.isfinite(spacing)):
        raise InputError(
            f"a surface needs at least 2 points at a positive distance, not {points} at {spacing} m"
        )
