r"""The Weierstrass-Mandelbrot surface: a profile (equation (6)), and a periodic map.

With :math:`f_n = \gamma^n / L` the term of index n has the amplitude
:math:`(\ln\gamma)^{1/2} G^{D-1} f_n^{D-2}`: the profile length L only fixes where the frequencies sit, and
the mean power density does not depend on :math:`\gamma` (see :mod:`asperity.surface.conventions`).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from asperity.engine.arrays import xp
from asperity.engine.control import scan
from asperity.errors import InputError
from asperity.surface.conventions import areal_roughness_from_profile, validated_fractal
from asperity.types import Array, ArrayLike


def weierstrass_mandelbrot_profile(
    *,
    position: ArrayLike,
    profile_length: ArrayLike,
    fractal_dimension: ArrayLike,
    fractal_roughness: ArrayLike,
    frequency_ratio: ArrayLike,
    phases: ArrayLike,
    lowest_index: int,
) -> Array:
    r"""Height of the Weierstrass-Mandelbrot profile, equation (6).

    .. math::
        z(x) = L \left(\frac{G}{L}\right)^{D-1} (\ln\gamma)^{1/2} \sum_{n=n_l}^{n_h} \gamma^{(D-2)n}
               \left[\cos\phi_n - \cos\left(\frac{2\pi\gamma^n x}{L} - \phi_n\right)\right]

    Parameters
    ----------
    position : array, any shape
        Where the height is wanted, x [m].
    profile_length : scalar
        L [m], the wavelength of the term n = 0.
    fractal_dimension : scalar
        D of the profile [-], between 1 and 2.
    fractal_roughness : scalar
        G [m], positive.
    frequency_ratio : scalar
        gamma [-], above 1; the field uses 1.5.
    phases : array, shape (terms,)
        phi_n [rad], one per term; their number fixes the highest index.
    lowest_index : int
        n_l, the index of the first phase.

    Returns
    -------
    array, shape of ``position``
        Height z [m]; z(0) = 0 whatever the phases.

    Notes
    -----
    Valid for 1 < D < 2, G > 0, gamma > 1. The terms are summed one after another, so memory does not grow
    with their number. Differentiable in every floating-point argument. Values outside the range of validity
    give NaN or a meaningless height: :func:`asperity.surface.conventions.validated_fractal` checks them.

    References
    ----------
    Zou et al., Materials 18 (2025) 2866, equation (6). Majumdar & Tien, Wear 136 (1990) 313.

    Examples
    --------
    >>> import numpy as np
    >>> z = weierstrass_mandelbrot_profile(
    ...     position=np.array([0.0, 0.5]), profile_length=1.0, fractal_dimension=1.5, fractal_roughness=1.0,
    ...     frequency_ratio=np.e, phases=np.zeros(1), lowest_index=0)
    >>> [round(float(v), 12) for v in z]  # one term: 1 - cos(2 pi x)
    [0.0, 2.0]
    """
    x = xp.asarray(position, dtype=float)
    phi = xp.asarray(phases, dtype=float)
    L = xp.asarray(profile_length, dtype=float)
    D = xp.asarray(fractal_dimension, dtype=float)
    G = xp.asarray(fractal_roughness, dtype=float)
    gamma = xp.asarray(frequency_ratio, dtype=float)
    n = xp.asarray(lowest_index, dtype=float) + xp.arange(phi.shape[0], dtype=float)

    amplitude = L * (G / L) ** (D - 1.0) * xp.sqrt(xp.log(gamma)) * gamma ** ((D - 2.0) * n)  # (6)
    wavenumber = 2.0 * xp.pi * gamma**n / L

    def add_term(height: Array, term: tuple[Array, Array, Array]) -> tuple[Array, None]:
        a, q, p = term
        return height + a * (xp.cos(p) - xp.cos(q * x - p)), None

    height, _ = scan(add_term, xp.zeros_like(x), (amplitude, wavenumber, phi))
    return height


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
    r"""Isotropic Weierstrass–Mandelbrot height map of mean zero [m] on a periodic square.

    .. math::
        z = \sqrt{\ln\gamma}\,G_a^{D-1} \sum_n f_n^{D-2}\, \frac{1}{\sqrt{M_n}} \sum_{m=1}^{M_n}
        \cos(2\pi\,\mathbf k_{nm}\cdot\mathbf x + \phi_{nm}), \qquad f_n = \gamma^n f_0

    At least 8 points along each ``side`` [m], which is the period; the wavelengths [m] of the first and of the last
    frequency are at most the side and at least two pixels. D [-] and G [m] are those of the profiles. An ``InputError``
    for a surface that does not fit the grid.

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
