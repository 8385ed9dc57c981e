"""Periodic Weierstrass–Mandelbrot surface for periodic boundary elements."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.conventions import areal_roughness_from_profile, validated_fractal

#: Waves per frequency; low frequencies have fewer directions.
RIDGES = 24


def periodic_weierstrass_surface(
    *,
    points: int,
    side: float,
    longest_wavelength: float,
    shortest_wavelength: float,
    fractal_dimension: float,
    fractal_roughness: float,
    frequency_ratio: float,
    random: np.random.Generator,
) -> NDArray[np.float64]:
    r"""Isotropic Weierstrass–Mandelbrot height map on a periodic square.

    .. math::
        z = \sqrt{\ln\gamma}\,G_a^{D-1} \sum_n f_n^{D-2}\, \frac{1}{\sqrt{M_n}} \sum_{m=1}^{M_n}
        \cos(2\pi\,\mathbf k_{nm}\cdot\mathbf x + \phi_{nm}), \qquad f_n = \gamma^n f_0

    Parameters
    ----------
    points : int
        Points along each side, at least 8.
    side : float
        Side of the square and period [m].
    longest_wavelength, shortest_wavelength : float
        Wavelengths of the first and of the last frequency at most [m]; at most the side and at least two
        pixels.
    fractal_dimension, fractal_roughness : float
        D [-] and G [m] of the profiles.
    frequency_ratio : float
        gamma [-], above 1.
    random : numpy.random.Generator
        Source of the phases and directions.

    Returns
    -------
    array, shape (points, points)
        Height [m], mean zero.

    Raises
    ------
    InputError
        For a surface that does not fit the grid.

    Notes
    -----
    The areal sum of Yan and Komvopoulos with the wavevectors moved to the nearest ones that fit the period (by
    at most half a lattice step: 25 % of the lowest frequency if that has two waves per side); amplitudes are
    those of the exact frequencies. G is converted from profile to area so that profiles have the given D and G.

    References
    ----------
    Yan & Komvopoulos, J. Appl. Phys. 84 (1998) 3617, equation (6); Zou et al. 2025, equation (6).
    """
    D, G = validated_fractal(fractal_dimension=fractal_dimension, fractal_roughness=fractal_roughness)
    if points < 8 or not frequency_ratio > 1.0 or not side > 0.0:
        raise InputError(
            f"points = {points}, side = {side:g} m, frequency_ratio = {frequency_ratio:g}: at least 8 "
            "points, a positive side and a ratio above 1 are needed"
        )
    if not 2.0 * side / points <= shortest_wavelength <= longest_wavelength <= side:
        raise InputError(
            f"wavelengths from {shortest_wavelength:g} to {longest_wavelength:g} m do not fit {points} points "
            f"on {side:g} m: they must lie between {2.0 * side / points:g} m (two pixels) and the side"
        )
    areal = areal_roughness_from_profile(fractal_dimension=D, fractal_roughness=G)
    column, row = np.meshgrid(np.arange(points // 2 + 1), np.fft.fftfreq(points, 1.0 / points))
    distance = np.hypot(column, row)
    spectrum = np.zeros(column.shape, dtype=np.complex128)
    octaves = math.log(longest_wavelength / shortest_wavelength) / math.log(frequency_ratio)
    terms = 1 + math.floor(octaves + 1e-9)
    for n in range(terms):
        frequency = frequency_ratio**n / longest_wavelength
        # One of each pair of opposite wavevectors; the rim of the half-plane holds both, the upper one is taken.
        near = (
            (np.abs(distance - frequency * side) <= 0.5) & (column < points // 2) & ((column > 0) | (row > 0))
        )
        candidates = np.flatnonzero(near)
        chosen = random.choice(candidates, size=min(RIDGES, candidates.size), replace=False)
        amplitude = math.sqrt(math.log(frequency_ratio)) * areal ** (D - 1.0) * frequency ** (D - 2.0)
        phases = np.exp(2j * math.pi * random.random(chosen.size))
        spectrum.flat[chosen] += amplitude / math.sqrt(chosen.size) * phases
    return np.fft.irfft2(_hermitian(spectrum), s=(points, points)) * (points**2 / 2.0)


def _hermitian(spectrum: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Fill the conjugate half of the first column, which contains both waves of each opposite pair."""
    complete = spectrum.copy()
    complete[:, 0] += np.conj(np.roll(spectrum[::-1, 0], 1))
    return complete
