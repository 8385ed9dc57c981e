r"""Ra of a surface whose mean roughness depth Rz is known.

Rz is the mean, over the five sampling lengths of an evaluation length, of the highest peak minus the deepest valley in
each. The more independent heights a sampling length holds, the farther its extremes lie apart: for normally
distributed heights with the spectrum of :mod:`asperity.surface.conventions` the ratio of Rz to Ra depends on D, and on
how far the two filters of the instrument, at :math:`\lambda_c` and :math:`\lambda_s`, lie apart.

The ratio and the scatter are fits to simulated profiles: normally distributed Fourier coefficients of variance
proportional to

.. math::
    f^{-1-2H} \left(1 - 2^{-(f\lambda_c)^2}\right)^2 2^{-2(f\lambda_s)^2}, \qquad H = 2 - D

at a spacing of :math:`\lambda_s/6.4`, 5400 to 18000 evaluation lengths at each of eleven D from 1.01 to 1.99. The fits
lie within 0.1 % of the simulated ratio, which has a standard error up to 0.16 %, and within 0.0015 of the simulated
relative scatter, 0.05 to 0.12.

References
----------
Rz: ISO 4287:1997, 4.1.3, and ISO 4288:1996; pairs of cut-offs: ISO 3274:1996, table 1; filters: ISO 16610-21.
"""

from __future__ import annotations

import math

from asperity.errors import InputError
from asperity.units import format_quantity

#: Largest Rz [m] → cut-off [m] of the profile filter; above the last Rz the cut-off is the last one.
DEPTH_CUT_OFFS = ((0.1e-6, 0.08e-3), (0.5e-6, 0.25e-3), (10e-6, 0.8e-3), (50e-6, 2.5e-3), (math.inf, 8e-3))

# ratio of the cut-offs -> coefficients of (D - 1.5)^n in Rz/Ra, and in the relative standard deviation of Rz
_FITS = {
    32: ((5.2001, 1.8570, -0.0566, -0.3366, -0.2344), (0.0904, -0.0553, 0.0175)),
    100: ((5.5614, 2.7487, 0.5898, -0.8619, -1.2345), (0.0828, -0.0675, 0.0157)),
    320: ((5.7940, 3.6100, 1.7432, -1.2113, -3.0217), (0.0789, -0.0770, 0.0110)),
}
# long-wave cut-off [m] -> ratio to the short-wave one: 2.5, 2.5, 2.5, 8 and 25 um; 2.5 mm / 8 um is 312
_RATIOS = {0.08e-3: 32, 0.25e-3: 100, 0.8e-3: 320, 2.5e-3: 320, 8e-3: 320}


def depth_cut_off(*, mean_roughness_depth: float) -> float:
    r"""Cut-off :math:`\lambda_c` [m] of the profile filter with which a given Rz [m] is measured.

    Up to 0.1, 0.5, 10 and 50 µm: 0.08, 0.25, 0.8 and 2.5 mm, above 8 mm. ISO 4288:1996, table 2 (profiles that are not
    periodic).

    >>> depth_cut_off(mean_roughness_depth=1.6e-6)
    0.0008
    """
    return next(cut_off for largest, cut_off in DEPTH_CUT_OFFS if mean_roughness_depth <= largest)


def depth_over_average(*, fractal_dimension: float, cut_off: float) -> float:
    """Ratio Rz/Ra [-] of the means of normally distributed heights, both behind the same filters.

    Notes
    -----
    Real processes differ: one scratch raises Rz and leaves Ra, a plateau lowers both unequally.
    The Ra of :func:`asperity.surface.roughness_average.roughness_average` is taken without the short-wave filter, which
    takes 0.4 % of it at D = 1.5 and 7 % at D = 1.8 for cut-offs from 0.8 mm, 4 % and 19 % for 0.08 mm.

    Examples
    --------
    >>> f"{depth_over_average(fractal_dimension=1.3, cut_off=0.8e-3):.2f}"
    '5.15'
    """
    return _fitted(0, fractal_dimension, cut_off)


def scatter_of_depth(*, fractal_dimension: float, cut_off: float) -> float:
    """Relative standard deviation [-] of Rz over five sampling lengths from one evaluation length to the next."""
    return _fitted(1, fractal_dimension, cut_off)


def average_from_depth(
    *,
    mean_roughness_depth: float,
    tolerance: float,
    fractal_dimension: float,
    dimension_tolerance: float,
    cut_off: float,
) -> tuple[float, float]:
    """Ra [m] of normally distributed heights with a given Rz [m], and how far it may be from there to both sides [m].

    The distance holds Ra for every D of the range and every Rz of the tolerance; with the tolerance 0 Rz is that of one
    evaluation length, within two standard deviations of the mean.
    """
    average = mean_roughness_depth / depth_over_average(fractal_dimension=fractal_dimension, cut_off=cut_off)
    half = 0.0
    for sign in (-1.0, 1.0):  # ratio and scatter rise or fall with D all the way
        d = fractal_dimension + sign * dimension_tolerance
        scatter = 2.0 * scatter_of_depth(fractal_dimension=d, cut_off=cut_off)
        spread = tolerance / mean_roughness_depth if tolerance > 0.0 else scatter
        end = mean_roughness_depth / depth_over_average(fractal_dimension=d, cut_off=cut_off)
        half = max(half, end * (1.0 + spread) - average, average - end * (1.0 - spread))
    return average, half


def _fitted(which: int, fractal_dimension: float, cut_off: float) -> float:
    ratio = next(
        (ratio for known, ratio in _RATIOS.items() if math.isclose(known, cut_off, rel_tol=1e-9)), None
    )
    if ratio is None:
        known = ", ".join(format_quantity(tabulated, "mm") for tabulated in _RATIOS)
        raise InputError(
            f"Rz/Ra is known for the cut-offs of ISO 3274, {known}, got {format_quantity(cut_off, 'mm')}"
        )
    x = fractal_dimension - 1.5
    return sum(c * x**power for power, c in enumerate(_FITS[ratio][which]))
