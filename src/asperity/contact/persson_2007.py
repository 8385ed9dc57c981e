"""Persson's theory of randomly rough elastic contact: area and interfacial stiffness from the spectrum."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from asperity.engine.arrays import special, xp
from asperity.engine.control import traced_once
from asperity.engine.module import Module
from asperity.types import Array, Real

#: Stiffness by this theory over that of boundary elements, elastic: nine states in ten, of the same measured surfaces
#: and pressures as :data:`asperity.contact.exponential.OVER_BOUNDARY_ELEMENTS`.
PERSSON_OVER_BOUNDARY_ELEMENTS = (0.43, 1.14)

#: Share of the full elastic energy that asperities store, gamma of Yang & Persson (2008), fitted there to
#: molecular dynamics.
ENERGY_FACTOR = 0.45


class WaveSpectrum(Module):
    """The waves of one surface, from long to short.

    Parameters
    ----------
    wavenumber : Array
        q, shape (waves,), rising [rad/m].
    slope_variance : Array
        Mean square gradient of each wave and all longer ones, shape (waves,) [-].
    rms_height, rms_slope : Array
        Root mean square of heights [m] and gradient [-].
    """

    wavenumber: Array
    slope_variance: Array
    rms_height: Array
    rms_slope: Array


def wave_spectrum(heights: NDArray[np.float64], *, sides: tuple[float, ...]) -> WaveSpectrum:
    """The waves of a periodic surface, without those of rounding.

    Parameters
    ----------
    heights : array
        Map or profile [m].
    sides : tuple of float
        Its lengths along all axes [m].

    Returns
    -------
    WaveSpectrum
        Every wave of the Fourier transform.

    References
    ----------
    :func:`numpy.fft.fftn`; Parseval's theorem.
    """
    axes = [2.0 * math.pi * np.fft.fftfreq(n, side / n) for n, side in zip(heights.shape, sides, strict=True)]
    q = np.sqrt(sum(axis**2 for axis in np.meshgrid(*axes, indexing="ij"))).ravel()
    variance = np.abs(np.fft.fftn(heights).ravel()) ** 2 / float(heights.size) ** 2
    used = (q > 0.0) & (variance > 1e-20 * variance.max())
    return sorted_waves(q[used], variance[used])


def sorted_waves(wavenumber: NDArray[np.float64], variance: NDArray[np.float64]) -> WaveSpectrum:
    """Waves in any order, from long to short.

    Parameters
    ----------
    wavenumber, variance : array, shape (waves,)
        Positive wavenumbers [rad/m] and shares in the mean square height [m^2].

    Returns
    -------
    WaveSpectrum
        All of them.

    References
    ----------
    Elementary: a wave has the mean square gradient :math:`q^2` times that of its heights.
    """
    order = np.argsort(wavenumber)
    slope = np.cumsum(variance[order] * wavenumber[order] ** 2)
    return WaveSpectrum(
        wavenumber=xp.asarray(wavenumber[order]),
        slope_variance=xp.asarray(slope),
        rms_height=xp.asarray(math.sqrt(variance.sum())),
        rms_slope=xp.asarray(math.sqrt(slope[-1])),
    )


def waves_along_line(
    wavenumber: NDArray[np.float64], variance: NDArray[np.float64], *, half_width: float
) -> WaveSpectrum:
    r"""Waves along the axis of a line contact, which its line load closes as a pressure closes those of a surface.

    .. math::
        q = \frac{\pi}{I_0(kb/2)\,K_0(kb/2)}

    Parameters
    ----------
    wavenumber, variance : array, shape (waves,)
        k [rad/m] and shares in the mean square height [m^2].
    half_width : float
        b of the contact [m].

    Returns
    -------
    WaveSpectrum
        Of the dimensionless q; all of the theory takes line loads [N/m] with it in place of pressures.

    Notes
    -----
    A wave of the amplitude A is closed by a line load that varies by qEA/2. :func:`persson_decay_length` is 0.75 to 2.5
    times that of boundary elements where the roller rests on a part of its line.

    References
    ----------
    Derived here, from the displacement :math:`2K_0(kr)/\pi E` by a line load, spread as under a flat punch.
    """
    z = np.maximum(0.5 * wavenumber * half_width, 1e-12)  # constant along the axis: closed
    import scipy.special

    return sorted_waves(np.pi / (scipy.special.ive(0, z) * scipy.special.kve(0, z)), variance)


def contact_fraction(*, mean_pressure: Real, contact_modulus: Real, rms_slope: Real) -> Array:
    r"""Real over nominal area of an elastic contact.

    .. math:: \frac{A_r}{A_0} = \operatorname{erf}\left(\frac{\sqrt2\, p}{E\, h'_{rms}}\right)

    Parameters
    ----------
    mean_pressure : Real
        Load over nominal area p [Pa].
    contact_modulus : Real
        E [Pa].
    rms_slope : Real
        Root mean square gradient h' of the surface [-].

    Returns
    -------
    Array
        Fraction [-].

    Notes
    -----
    Elastic, Gaussian, isotropic. Boundary elements give up to 10–20 % more at small pressure.

    References
    ----------
    B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840.

    Examples
    --------
    >>> float(contact_fraction(mean_pressure=1e9, contact_modulus=1e9, rms_slope=0.0001))
    1.0
    """
    return special.erf(xp.sqrt(2.0) * mean_pressure / (contact_modulus * rms_slope))


@traced_once
def persson_decay_length(*, spectrum: WaveSpectrum, mean_pressure: Real, contact_modulus: Real) -> Array:
    r"""Pressure over the stiffness per nominal area, the slope of pressure over mean gap.

    .. math::
        \frac{p A_0}{K_n} = \sqrt\pi \int q^2 C w\left[\gamma + 3(1-\gamma)P^2\right] e^{-(wp/E)^2}\,\mathrm dq
        = \sqrt{\frac2\pi} \int_0^{h'_{rms}} \left[\gamma + 3(1-\gamma)P^2\right] e^{-(wp/E)^2}
        \frac{\mathrm dh'}{q}, \quad w = \frac{\sqrt2}{h'(q)},\quad P = \operatorname{erf}\frac{wp}E

    Parameters
    ----------
    spectrum : WaveSpectrum
        Waves of the surface; h'(q) is the rms gradient of the waves longer than 2 pi/q.
    mean_pressure : Real
        Load over nominal area p [Pa], scalar or array.
    contact_modulus : Real
        E [Pa].

    Returns
    -------
    Array
        Length [m], shape of ``mean_pressure``; it goes to 0 towards complete contact.

    Notes
    -----
    At small pressure it does not depend on the pressure, about half the rms height: the exponential law. gamma = 0.45.
    Elastic; only the waves, not their directions, count. Each wave is integrated over h' by three points of Gauss.

    References
    ----------
    B. N. J. Persson, Phys. Rev. Lett. 99 (2007) 125502. C. Yang and B. N. J. Persson, J. Phys.: Condens. Matter 20
    (2008) 215214. Equation (A11) of :doc:`/equations`.
    """
    slopes = xp.sqrt(xp.concatenate([xp.zeros(1), spectrum.slope_variance]))
    x, weight = (xp.asarray(part) for part in np.polynomial.legendre.leggauss(3))
    inside = slopes[:-1, None] + 0.5 * (1.0 + x) * xp.diff(slopes)[:, None]
    measure = 0.5 * weight * (xp.diff(slopes) / spectrum.wavenumber)[:, None]
    p = xp.asarray(mean_pressure, dtype=xp.float64)[..., None, None]
    wp = math.sqrt(2.0) * p / (contact_modulus * xp.where(inside > 0.0, inside, 1.0))
    energy = ENERGY_FACTOR + 3.0 * (1.0 - ENERGY_FACTOR) * special.erf(wp) ** 2
    return math.sqrt(2.0 / math.pi) * xp.sum(energy * xp.exp(-(wp**2)) * measure, axis=(-2, -1))
