r"""Maximum-likelihood fit of a power law with its departures at both ends to a binned spectrum.

The average of :math:`\nu` independent ordinates of a periodogram scatters about its expectation P by the
factor of a chi-square variable with :math:`2\nu` degrees of freedom, so the (Whittle) likelihood of a band is

.. math::
    -\ln\mathcal{L} = \sum_b \nu_b \left[ \ln P(f_b) + I_b / P(f_b) \right]

Real spectra leave the power law gradually: they roll off towards long waves, and noise or smoothing by the instrument
changes the short waves. Both departures are always part of the model, so that the covariance of D contains them:

.. math::
    P(f) = P_1 \left[ f^{-\beta} \left( 1 + c f^{-m} \right)^{-\beta/m} + n \right] + P_{folded}(f),
    \qquad \beta = 5 - 2D

c > 0 is a roll-off (m = 2: K-correlation; m = 8: a sharp corner), c < 0 remaining form or waviness; n > 0 is
white noise, n < 0 a loss of short waves.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq
from scipy.special import betainc, zeta

from asperity.surface.spectrum import BinnedSpectrum

#: Power above the sampling limit: absent, folded back below it, or (rows of a map) absent across the rows too.
TAILS: tuple[str, ...] = ("band_limited", "folded", "areal")
#: Exponents m of the roll-off: gradual (K-correlation) and sharp.
ROLL_OFFS = (2.0, 8.0)
#: The folded power of exponents nearer to 1 diverges; the fit may pass there on its way [-].
LEAST_FOLDING_EXPONENT = 1.02
#: The power law is usable where the departures change the density by less than this factor [-].
LARGEST_DEPARTURE = 2.0
#: Misfit of ln P beyond which no further care is taken of the weights [-].
HOPELESS_MISFIT = 0.4
#: Parameters: D, ln level, roll-off c, white part n.
PARAMETERS = 4
#: Iterations, trials of damping in each, and the change of the log-likelihood that ends them.
_STEPS = 40
_TRIALS = 12
_CONVERGED = 1e-8


@dataclass(frozen=True)
class SpectralFit:
    """A power law with its departures at long and short waves, fitted to the spectrum within a band.

    ``fractal_dimension`` D [-] is not confined to 1 .. 2; ``log_level`` is ln P of the power law [ln m^3] at
    ``reference_frequency`` [1/m]. Departures with their standard errors: ``floor``, the white part [m^3], negative
    where the instrument smooths the short waves; ``roll_off``, c of the roll-off [1/m^m], negative where the spectrum
    rises above the power law at long waves, m being its exponent.

    ``covariance`` of (D, ln level), shape (2, 2), includes the misfit and the uncertainty of both departures.
    ``misfit`` is the standard deviation of ln P about the fit that sampling scatter does not explain [-];
    ``chi_square``, the sum of squared normalised residuals, with its ``degrees`` of freedom; ``log_likelihood``, of the
    band, without constants. The band reaches from ``low`` to ``high`` [1/m]; ``sampling_frequency`` is the inverse of
    the spacing [1/m], and ``tail`` what is assumed about frequencies above the sampling limit: "band_limited", "folded"
    or "areal".
    """

    fractal_dimension: float
    log_level: float
    reference_frequency: float
    floor: float
    floor_error: float
    roll_off: float
    roll_off_error: float
    roll_off_exponent: float
    covariance: NDArray[np.float64]
    low: float
    high: float
    tail: str
    log_likelihood: float
    misfit: float
    chi_square: float
    degrees: int
    converged: bool
    sampling_frequency: float

    @property
    def usable_band(self) -> tuple[float, float]:
        """Limits [1/m] of the part of the band where the departures stay below a factor of two."""
        f = np.logspace(np.log10(self.low), np.log10(self.high), 400)
        ratio = self.expected(f) / self.density(f)
        positive = ratio > 0.0  # a law below zero fits nowhere
        departure = np.where(positive, np.abs(np.log(np.where(positive, ratio, 1.0))), np.inf)
        outside = departure > np.log(LARGEST_DEPARTURE)
        best = int(np.argmin(departure))
        if outside[best]:
            return float(f[best]), float(f[best])
        below, above = np.flatnonzero(outside[:best]), np.flatnonzero(outside[best:])
        low = self.low if below.size == 0 else float(f[below[-1] + 1])
        high = self.high if above.size == 0 else float(f[best + above[0] - 1])
        return low, high

    @property
    def roll_off_wavelength(self) -> float | None:
        """Wavelength of the roll-off [m], if the band contains it and its standard error is below a quarter."""
        m, c = self.roll_off_exponent, self.roll_off
        if c <= 0.0 or self.roll_off_error > 0.25 * m * c or self.bend(np.asarray(self.low)) > 0.5:
            return None
        return float(c ** (-1.0 / m))

    @property
    def decades(self) -> float:
        """Width of the usable band [decades]."""
        low, high = self.usable_band
        return float(np.log10(high / low))

    def expected(self, frequency: NDArray[np.float64]) -> NDArray[np.float64]:
        """The fitted density [m^3] with roll-off, white part and folding."""
        exponent = 5.0 - 2.0 * self.fractal_dimension
        density = self.density(frequency) * self.bend(frequency) + self.floor
        if self.tail == "areal":
            share = areal_share(2.0 * frequency / self.sampling_frequency, exponent)
            density = (density - self.floor) * share + self.floor
        if self.tail == "folded":
            s = max(exponent, LEAST_FOLDING_EXPONENT)
            x = frequency / self.sampling_frequency
            density = density + self.density(np.asarray(self.sampling_frequency)) * (
                zeta(s, 1.0 + x) + zeta(s, 1.0 - x)
            )
        return np.asarray(density)

    def bend(self, frequency: NDArray[np.float64]) -> NDArray[np.float64]:
        """Factor of the roll-off [-], at and above the lowest frequency of the band."""
        exponent, m = 5.0 - 2.0 * self.fractal_dimension, self.roll_off_exponent
        return np.asarray(np.maximum(1.0 + self.roll_off * frequency**-m, 1e-3) ** (-exponent / m))

    def density(self, frequency: NDArray[np.float64]) -> NDArray[np.float64]:
        """The pure power law [m^3], without its departures."""
        exponent = 5.0 - 2.0 * self.fractal_dimension
        return np.asarray(np.exp(self.log_level - exponent * np.log(frequency / self.reference_frequency)))

    def inside(self, spectrum: BinnedSpectrum) -> NDArray[np.bool_]:
        """Which bins of a spectrum lie in the usable band."""
        low, high = self.usable_band
        return (spectrum.frequency >= low * (1 - 1e-9)) & (spectrum.frequency <= high * (1 + 1e-9))


def fit_spectrum(
    *, spectrum: BinnedSpectrum, low: float, high: float, tail: str, roll_off_exponent: float
) -> SpectralFit | None:
    r"""Fit the power law and its departures to the bins between two frequencies [1/m].

    None if fewer than three bins more than parameters lie in the band, or the spectrum vanishes in one. The variance of
    ln P in a bin is :math:`1/\nu + \tau^2`; the misfit :math:`\tau` is such that the weighted sum of squared residuals
    equals its degrees of freedom (Paule & Mandel), zero if it is below. The covariance is enlarged by chi-square per
    degree of freedom where that says more.

    References
    ----------
    Paule & Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377.
    """
    inside = (spectrum.frequency >= low * (1 - 1e-9)) & (spectrum.frequency <= high * (1 + 1e-9))
    if int(inside.sum()) < PARAMETERS + 3 or not (spectrum.density[inside] > 0.0).all():
        return None
    f, data = spectrum.frequency[inside], spectrum.density[inside]
    nu, spread = spectrum.independent[inside], spectrum.spread[inside]
    reference = float(np.exp(np.average(np.log(f), weights=np.sqrt(nu))))
    model = _Model(f / reference, spread, 2.0 * spectrum.nyquist / reference, tail, roll_off_exponent)
    theta, converged = _maximise(model, model.start(data, nu), data, nu)
    degrees = int(f.size - PARAMETERS)
    chi_square = float(np.sum(nu * model.residual(theta, data)[0] ** 2))
    misfit_square = 0.0
    for _ in range(3):  # weights with the variance of the misfit in them, and the fit with these weights
        misfit_square = _misfit(model.residual(theta, data)[0], nu, degrees)
        if misfit_square == 0.0 or misfit_square > HOPELESS_MISFIT**2:
            break
        theta, converged = _maximise(model, theta, data, 1.0 / (1.0 / nu + misfit_square))
    _, jacobian = model.residual(theta, data)
    covariance = max(
        (
            _inverse(jacobian, 1.0 / (1.0 / nu + misfit_square)),
            _inverse(jacobian, nu) * max(1.0, chi_square / degrees),
        ),
        key=lambda c: float(c[0, 0]),
    )
    level, unit = float(np.exp(theta[1])), reference**roll_off_exponent
    # the white part is relative to the level, uncertain as well
    by_floor = np.array([0.0, theta[3], 0.0, 1.0])
    expected = model.log_density(theta)
    return SpectralFit(
        fractal_dimension=float(theta[0]),
        log_level=float(theta[1]),
        reference_frequency=reference,
        floor=level * float(theta[3]),
        floor_error=level * float(np.sqrt(by_floor @ covariance @ by_floor)),
        roll_off=unit * float(theta[2]),
        roll_off_error=unit * float(np.sqrt(covariance[2, 2])),
        roll_off_exponent=roll_off_exponent,
        covariance=covariance[:2, :2].copy(),
        low=float(f[0]),
        high=float(f[-1]),
        tail=tail,
        log_likelihood=float(-np.sum(nu * (expected + data * np.exp(-expected)))),
        misfit=float(np.sqrt(misfit_square)),
        chi_square=chi_square,
        degrees=degrees,
        converged=converged,
        sampling_frequency=2.0 * spectrum.nyquist,
    )


def areal_share(frequency_share: NDArray[np.float64], exponent: float) -> NDArray[np.float64]:
    r"""Share [-] of the profile spectrum left in a row of an isotropic map without power above the sampling limit.

    .. math::
        \frac{\int_0^{f_N} (f^2 + f_y^2)^{-(\beta + 1)/2} df_y}{\int_0^\infty (f^2 + f_y^2)^{-(\beta + 1)/2} df_y}
        = I_{1/(1 + (f/f_N)^2)}(\tfrac12, \tfrac{\beta}{2})
    """
    beta = max(exponent, LEAST_FOLDING_EXPONENT)
    return np.asarray(betainc(0.5, 0.5 * beta, 1.0 / (1.0 + frequency_share**2)))


class _Model:
    """ln of the expected density in bins at u = f / reference; parameters (D, ln level, c, n)."""

    def __init__(
        self, u: NDArray[np.float64], spread: NDArray[np.float64], sampling: float, tail: str, m: float
    ) -> None:
        self.u, self.log_u, self.spread = u, np.log(u), spread
        self.sampling, self.tail, self.m = sampling, tail, m
        self.long_waves = u**-m

    def start(self, data: NDArray[np.float64], nu: NDArray[np.float64]) -> NDArray[np.float64]:
        slope, level = np.polyfit(self.log_u, np.log(data), 1, w=np.minimum(np.sqrt(nu), 30.0))
        return np.array([np.clip(0.5 * (5.0 + slope), 0.7, 2.2), level, 0.0, 0.0])

    def shape(self, dimension: float, c: float) -> NDArray[np.float64]:
        """Power law with roll-off and folding, without the white part; nan where c is impossible."""
        beta = 5.0 - 2.0 * dimension
        bend = 1.0 + c * self.long_waves
        if bend.min() <= 0.0:
            return np.full_like(self.u, np.nan)
        power = np.exp(-beta * self.log_u) * bend ** (-beta / self.m) * (1.0 + 0.5 * beta**2 * self.spread)
        if self.tail == "areal":
            power = power * areal_share(2.0 * self.u / self.sampling, beta)
        if self.tail == "folded":
            s = max(beta, LEAST_FOLDING_EXPONENT)
            x = self.u / self.sampling
            power = power + self.sampling ** (-s) * (zeta(s, 1.0 + x) + zeta(s, 1.0 - x))
        return power

    def log_density(self, theta: NDArray[np.float64]) -> NDArray[np.float64]:
        """Ln of the density; nan where it is not positive."""
        density = self.shape(float(theta[0]), float(theta[2])) + theta[3]
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(theta[1] + np.log(density))

    def residual(
        self, theta: NDArray[np.float64], data: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Relative residuals I / P - 1 and the Jacobian of ln P."""
        D, c = float(theta[0]), float(theta[2])
        density = self.shape(D, c) + theta[3]
        h = 1e-5
        slope = (self.shape(D + h, c) - self.shape(D - h, c)) / (2.0 * h)
        beta = 5.0 - 2.0 * D
        bend = 1.0 + c * self.long_waves
        bent = -(beta / self.m) * self.long_waves * np.exp(-beta * self.log_u) * bend ** (-beta / self.m - 1)
        columns = [slope / density, np.ones_like(density), bent / density, 1.0 / density]
        return data * np.exp(-theta[1]) / density - 1.0, np.stack(columns, axis=1)


def _maximise(
    model: _Model, theta: NDArray[np.float64], data: NDArray[np.float64], weight: NDArray[np.float64]
) -> tuple[NDArray[np.float64], bool]:
    """Fisher scoring, damped where a full step does not lower the loss (Levenberg and Marquardt)."""

    def loss(t: NDArray[np.float64]) -> float:
        expected = model.log_density(t)
        value = float(np.sum(weight * (expected + data * np.exp(-expected))))
        return value if np.isfinite(value) else np.inf

    damping = 0.0
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):
        value = loss(theta)
        for _ in range(_STEPS):
            residual, jacobian = model.residual(theta, data)
            scale = np.sqrt(np.einsum("b,bi->i", weight, jacobian**2))
            if not (np.isfinite(scale).all() and (scale > 0.0).all()):
                return theta, False
            scaled = jacobian / scale
            information = scaled.T @ (weight[:, None] * scaled)
            gradient = scaled.T @ (weight * residual)
            for _ in range(_TRIALS):
                damped = information + (damping + 1e-12) * np.eye(PARAMETERS)
                step = np.linalg.solve(damped, gradient)
                decrease = float(step @ gradient)
                step = step / scale
                step *= min(1.0, 0.5 / max(abs(step[0]), 1e-300), 3.0 / max(abs(step[1]), 1e-300))
                trial = loss(theta + step)
                if trial <= value + 1e-13 * abs(value):
                    break
                damping = max(5.0 * damping, 1e-3)
            else:
                return theta, decrease < _CONVERGED
            gain, theta, value = value - trial, theta + step, trial
            if decrease < _CONVERGED and gain < _CONVERGED:
                return theta, True
            damping = 0.2 * damping if damping > 1e-4 else 0.0
    return theta, False


def _inverse(jacobian: NDArray[np.float64], weight: NDArray[np.float64]) -> NDArray[np.float64]:
    """Covariance of all parameters for given weights."""
    scale = np.sqrt(np.einsum("b,bi->i", weight, jacobian**2))
    scale = np.where(scale > 0.0, scale, 1.0)  # of a fit that did not converge
    scaled = jacobian / scale
    inverse = np.linalg.pinv(scaled.T @ (weight[:, None] * scaled), rcond=1e-14, hermitian=True)
    return np.asarray(inverse / np.outer(scale, scale))


def _misfit(residual: NDArray[np.float64], nu: NDArray[np.float64], degrees: int) -> float:
    """Variance of ln P about the fit beyond that of sampling, after Paule and Mandel."""

    def excess(square: float) -> float:
        return float(np.sum(residual**2 / (1.0 / nu + square))) - degrees

    if excess(0.0) <= 0.0:
        return 0.0
    largest = float(np.sum(residual**2)) / degrees  # the root of excess if sampling did not scatter at all
    return float(brentq(excess, 0.0, 2.0 * largest, rtol=1e-6))
