"""The Gaussian profile and areal filter of ISO 16610."""

from __future__ import annotations

import math

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.topography import Topography

#: Constant of the Gaussian that passes half of the amplitude at the cutoff, sqrt(ln 2 / pi).
ALPHA = math.sqrt(math.log(2.0) / math.pi)


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
            f"the cutoff is {cutoff:.4g} m; it must lie between twice the spacing "
            f"({2 * spacing:.4g} m) and the "
            f"length of the profile ({length:.4g} m)"
        )
    rows = np.atleast_2d(heights)
    reach = math.ceil(1.5 * cutoff / spacing)  # the weight falls to 1e-14 there
    x = np.arange(-reach, reach + 1) * spacing
    weight = np.exp(-math.pi * (x / (ALPHA * cutoff)) ** 2)
    weight /= weight.sum()
    present = ~np.isnan(rows)
    level = np.nanmean(rows)
    total = scipy.signal.fftconvolve(
        np.where(present, rows - level, 0.0), weight[None, :], mode="same", axes=1
    )
    if present.all():
        share = scipy.signal.fftconvolve(np.ones((1, rows.shape[1])), weight[None, :], mode="same", axes=1)
    else:
        share = scipy.signal.fftconvolve(present.astype(float), weight[None, :], mode="same", axes=1)
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
        raise InputError(f"lambda_s = {short_cutoff} m must be shorter than lambda_c = {long_cutoff} m")
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
