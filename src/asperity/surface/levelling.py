"""Removal of form (straight line, plane, polynomial, cylinder) and of outliers; Gaussian filters."""

from __future__ import annotations

import math

import numpy as np
import scipy.fft
import scipy.ndimage
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.topography import Topography
from asperity.units import format_quantity

#: Forms that can be removed.
FORMS = ("none", "mean", "line", "plane", "polynomial", "cylinder_x", "cylinder_y")
_HIGHEST_DEGREE = 12
#: Largest share of the variance of the heights that a tilt may have where it is not removed [-].
LARGEST_TILT_SHARE = 0.9
#: Constant of the Gaussian that passes half of the amplitude at the cutoff, sqrt(ln 2 / pi).
ALPHA = math.sqrt(math.log(2.0) / math.pi)


def default_form(topography: Topography) -> str:
    """The form that removes a tilt: ``line`` of a profile, ``plane`` of a map."""
    return "plane" if topography.is_map else "line"


def levelled(*, topography: Topography, form: str, degree: int | None = None) -> Topography:
    """The surface minus its least-squares form; missing points neither count nor change.

    The form is ``none``, ``mean``, ``line`` (of a profile), ``plane`` (of a map), ``polynomial`` (of the given total
    degree, 0 to 12), ``cylinder_x`` or ``cylinder_y`` (of a map: plane and a parabola along x or along y). One that
    leaves a tilt of more than :data:`LARGEST_TILT_SHARE` of the variance of the heights is refused.
    """
    if form not in FORMS:
        raise InputError(f"there is no form '{form}'; known: {', '.join(FORMS)}")
    if form in ("none", "mean"):
        _refuse_tilt(topography, form)
    if form == "none":
        return topography
    powers = _powers(topography, form, degree)
    z = topography.heights
    present = ~np.isnan(z)
    if int(present.sum()) <= len(powers):
        raise InputError(
            f"{topography.source}: {int(present.sum())} points are too few for the form '{form}'"
        )
    x = np.linspace(-1.0, 1.0, z.shape[-1], dtype=np.float64)
    y = np.linspace(-1.0, 1.0, z.shape[0], dtype=np.float64) if topography.is_map else np.zeros(1)
    highest = max(max(p) for p in powers)
    along = np.asarray(np.polynomial.legendre.legvander(x, highest), dtype=np.float64)
    across = np.asarray(np.polynomial.legendre.legvander(y, highest), dtype=np.float64)
    surfaces = _fitted(np.atleast_2d(z), np.atleast_2d(present), along, across, powers)
    return topography.with_heights(
        z - surfaces.reshape(z.shape),
        f"form removed: {form}{'' if degree is None else f' of degree {degree}'}",
    )


def _refuse_tilt(topography: Topography, form: str) -> None:
    """Refuse a surface whose heights are mostly a tilt that the form leaves in."""
    z = topography.heights
    tilt = default_form(topography)
    if int((~np.isnan(z)).sum()) <= 3 or not np.nanvar(z) > 0.0:
        return
    share = 1.0 - float(np.nanvar(levelled(topography=topography, form=tilt).heights) / np.nanvar(z))
    if share > LARGEST_TILT_SHARE:
        raise InputError(
            f"{topography.source or 'the surface'}: the tilt makes up {100 * share:.1f} % of the variance of "
            f"the heights, and the form '{form}' does not remove it; use the form '{tilt}'",
            options=["form"],
        )


def _powers(topography: Topography, form: str, degree: int | None) -> list[tuple[int, int]]:
    """Degrees along (x, y) of the terms of a form."""
    if form == "polynomial":
        if degree is None or not 0 <= degree <= _HIGHEST_DEGREE:
            raise InputError(
                f"a polynomial form needs a degree between 0 and {_HIGHEST_DEGREE}, not {degree}"
            )
        if not topography.is_map:
            return [(i, 0) for i in range(degree + 1)]
        return [(i, j) for i in range(degree + 1) for j in range(degree + 1 - i)]
    if form == "mean":
        return [(0, 0)]
    if topography.is_map == (form == "line"):
        raise InputError(f"the form '{form}' does not suit a {'map' if topography.is_map else 'profile'}")
    plane = [(0, 0), (1, 0), (0, 1)]
    extra = {"cylinder_x": [(2, 0)], "cylinder_y": [(0, 2)]}
    return [(0, 0), (1, 0)] if form == "line" else plane + extra.get(form, [])


def _fitted(
    z: NDArray[np.float64],
    present: NDArray[np.bool_],
    along: NDArray[np.float64],
    across: NDArray[np.float64],
    powers: list[tuple[int, int]],
) -> NDArray[np.float64]:
    """Least-squares sum of products of Legendre polynomials, by normal equations summed over rows."""
    complete = bool(present.all())
    data = z if complete else np.where(present, z, 0.0)
    n = along.shape[1]
    points = np.ones((1, z.shape[1])) if complete else present.astype(np.float64)
    pairs = np.einsum("ij,jk,jl->ikl", points, along, along, optimize=True)
    pairs = np.broadcast_to(pairs, (z.shape[0], n, n))
    gram4 = np.einsum("ikl,ip,iq->kplq", pairs, across, across, optimize=True)
    right = across.T @ (data @ along)
    index = [i * n + j for i, j in powers]
    gram = gram4.reshape(n * n, n * n)[np.ix_(index, index)]
    vector = right.T.reshape(n * n)[index]
    coefficients = np.zeros((n, n))
    solution = np.linalg.lstsq(gram, vector, rcond=None)[0]
    for (i, j), c in zip(powers, solution, strict=True):
        coefficients[j, i] = c
    return np.asarray(across @ coefficients @ along.T)


def without_outliers(*, topography: Topography, threshold: float, window: int) -> Topography:
    """The surface with outliers marked as missing; its notes say how many.

    A point is an outlier if it is further from the running median of its neighbours along x (an odd number of points)
    than ``threshold`` times the robust standard deviation (1.4826 times the median absolute value) of such distances;
    6 is gentle.
    """
    if not threshold > 0.0 or window < 3 or window % 2 == 0:
        raise InputError(
            f"outliers need a positive threshold and an odd window of 3 or more, not {threshold}, {window}"
        )
    z = np.atleast_2d(topography.heights)
    known = np.where(np.isnan(z), np.nanmedian(z), z)
    distance = np.abs(z - scipy.ndimage.median_filter(known, size=(1, window), mode="nearest"))
    scale = 1.4826 * float(np.nanmedian(distance))
    outlying = distance > threshold * scale if scale > 0.0 else np.zeros_like(distance, dtype=bool)
    marked = np.where(outlying, np.nan, z).reshape(topography.heights.shape)
    return topography.with_heights(marked, f"{int(outlying.sum())} outliers marked as missing")


def gaussian_lowpass(*, heights: NDArray[np.float64], spacing: float, cutoff: float) -> NDArray[np.float64]:
    r"""Long-wave part of profiles by the Gaussian filter.

    .. math::
        s(x) = \frac{1}{\alpha\lambda_c} \exp\left[-\pi\left(\frac{x}{\alpha\lambda_c}\right)^2\right], \qquad
        \frac{a_1}{a_0} = \exp\left[-\pi\left(\frac{\alpha\lambda_c}{\lambda}\right)^2\right]

    The weights are renormalised where they extend beyond an end or over a gap (NaN), so a constant stays a constant;
    within half a cutoff of the ends the result is that of the truncated weights.

    References
    ----------
    ISO 16610-21:2011, equations (1) and (3).
    """
    length = heights.shape[-1] * spacing
    if not 2.0 * spacing <= cutoff <= length:
        raise InputError(
            f"the cut-off is {format_quantity(cutoff, 'mm')}; it must lie between twice the spacing "
            f"({format_quantity(2.0 * spacing, 'mm')}) and the length of the surface ({format_quantity(length, 'mm')})",
            options=["cut-off", "short-cut-off"],
        )
    rows = np.atleast_2d(heights)
    reach = math.ceil(1.5 * cutoff / spacing)  # the weight falls to 1e-14 there
    x = np.arange(-reach, reach + 1) * spacing
    weight = np.exp(-math.pi * (x / (ALPHA * cutoff)) ** 2)
    weight /= weight.sum()
    present = ~np.isnan(rows)
    level = np.nanmean(rows)
    points = rows.shape[1]
    size = scipy.fft.next_fast_len(points + weight.size - 1, real=True)
    transform = scipy.fft.rfft(weight, size)
    total, share = (
        scipy.fft.irfft(scipy.fft.rfft(values, size) * transform, size)[:, reach : reach + points]
        for values in (
            np.where(present, rows - level, 0.0),
            (present[:1] if present.all() else present).astype(float),
        )
    )
    smooth = total / np.maximum(share, 1e-12) + level
    return np.where(present, smooth, np.nan).reshape(heights.shape)


def filtered(*, topography: Topography, short_cutoff: float | None, long_cutoff: float | None) -> Topography:
    """Roughness between two cutoffs [m]: waves shorter than lambda_s and longer than lambda_c removed, None keeps them.

    A map is filtered along x and then along y, which is the areal Gaussian filter.

    References
    ----------
    ISO 16610-21:2011 (profiles), ISO 16610-61:2015 (areal), ISO 21920-2:2021.
    """
    if short_cutoff is not None and long_cutoff is not None and not short_cutoff < long_cutoff:
        raise InputError(
            f"lambda_s, {format_quantity(short_cutoff, 'mm')}, must be shorter than lambda_c, "
            f"{format_quantity(long_cutoff, 'mm')}",
            options=["short-cut-off", "cut-off"],
        )
    out = topography
    if short_cutoff is not None:
        out = out.with_heights(
            _lowpass(out, short_cutoff), f"Gaussian filter, lambda_s = {short_cutoff:.4g} m"
        )
    if long_cutoff is not None:
        rough = out.heights - _lowpass(out, long_cutoff)
        out = out.with_heights(rough, f"Gaussian filter, lambda_c = {long_cutoff:.4g} m")
    return out


def _lowpass(topography: Topography, cutoff: float) -> NDArray[np.float64]:
    smooth = gaussian_lowpass(heights=topography.heights, spacing=topography.spacing, cutoff=cutoff)
    if topography.spacing_across is None:
        return smooth
    turned = np.ascontiguousarray(smooth.T)
    return gaussian_lowpass(heights=turned, spacing=topography.spacing_across, cutoff=cutoff).T
