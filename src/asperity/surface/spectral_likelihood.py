r"""Maximum-likelihood fit of the power law to a binned spectrum, the most precise on self-affine noise.

The average of :math:`\nu` independent ordinates of a periodogram scatters about its expectation P by the
factor of a chi-square variable with :math:`2\nu` degrees of freedom, so the (Whittle) likelihood of a band is

.. math::
    -\ln\mathcal{L} = \sum_b \nu_b \left[ \ln P(f_b) + I_b / P(f_b) \right]
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import zeta

from asperity.surface.spectrum import BinnedSpectrum

#: How power above the sampling limit appears: not at all, or folded back below it.
TAILS = ("band_limited", "folded")
#: The folded power of exponents nearer to 1 diverges; the fit may pass there on its way [-].
LEAST_FOLDING_EXPONENT = 1.02
#: Scatter of ln P beyond which no further care is taken of the weights [-].
HOPELESS_MISFIT = 1.0
_STEPS = 40


@dataclass(frozen=True)
class SpectralFit:
    """A power law with or without a white floor, fitted to the spectrum within a band.

    Attributes
    ----------
    fractal_dimension : float
        D [-]; not confined to 1 .. 2.
    log_level : float
        ln P of the power law [ln m^3] at ``reference_frequency`` [1/m].
    floor : float
        White floor [m^3], zero if none was fitted.
    covariance : array, shape (2, 2)
        Of (D, ln level), with the misfit taken into account.
    low, high : float
        Limits of the band [1/m].
    tail : {"band_limited", "folded"}
        What is assumed about frequencies above the sampling limit.
    log_likelihood : float
        Of the band, without constants.
    parameters : int
        Number of fitted parameters.
    misfit : float
        Scatter of ln P about the fit beyond what chance explains [-].
    chi_square, degrees : float, int
        Sum of squared normalised residuals and its degrees of freedom.
    converged : bool
        Whether the iteration came to rest.
    sampling_frequency : float
        Inverse of the spacing [1/m].
    """

    fractal_dimension: float
    log_level: float
    reference_frequency: float
    floor: float
    covariance: NDArray[np.float64]
    low: float
    high: float
    tail: str
    log_likelihood: float
    parameters: int
    misfit: float
    chi_square: float
    degrees: int
    converged: bool
    sampling_frequency: float

    @property
    def usable_high(self) -> float:
        """Upper end of the band [1/m], below where the power law sinks into floor or folded power."""
        f = np.logspace(np.log10(self.low), np.log10(self.high), 200)
        sunk = np.flatnonzero(self.expected(f) > 2.0 * self.density(f))
        return float(f[sunk[0]]) if sunk.size else self.high

    @property
    def decades(self) -> float:
        """Width of the usable band [decades]."""
        return float(np.log10(self.usable_high / self.low))

    def expected(self, frequency: NDArray[np.float64]) -> NDArray[np.float64]:
        """The fitted density [m^3] with floor and folding."""
        density = self.density(frequency) + self.floor
        if self.tail == "folded":
            s = max(5.0 - 2.0 * self.fractal_dimension, LEAST_FOLDING_EXPONENT)
            x = frequency / self.sampling_frequency
            density = density + self.density(np.asarray(self.sampling_frequency)) * (
                zeta(s, 1.0 + x) + zeta(s, 1.0 - x)
            )
        return np.asarray(density)

    def density(self, frequency: NDArray[np.float64]) -> NDArray[np.float64]:
        """The pure power law [m^3], without floor and folding."""
        exponent = 5.0 - 2.0 * self.fractal_dimension
        return np.asarray(np.exp(self.log_level - exponent * np.log(frequency / self.reference_frequency)))


def fit_spectrum(
    *, spectrum: BinnedSpectrum, low: float, high: float, tail: str, with_floor: bool
) -> SpectralFit | None:
    """Fit D and the level, and a white floor if wanted, to the bins between two frequencies [1/m].

    Returns
    -------
    SpectralFit or None
        None if fewer than three bins more than parameters lie in the band, or the spectrum vanishes in one.
    """
    inside = (spectrum.frequency >= low * (1 - 1e-9)) & (spectrum.frequency <= high * (1 + 1e-9))
    parameters = 3 if with_floor else 2
    if int(inside.sum()) < parameters + 3 or not (spectrum.density[inside] > 0.0).all():
        return None
    f, data = spectrum.frequency[inside], spectrum.density[inside]
    nu, spread = spectrum.independent[inside], spectrum.spread[inside]
    reference = float(np.exp(np.average(np.log(f), weights=np.sqrt(nu))))
    model = _Model(f / reference, spread, 2.0 * spectrum.nyquist / reference, tail, with_floor)

    theta = model.start(data, nu)
    theta, converged = _maximise(model, theta, data, nu)
    misfit_square = 0.0
    for _ in range(3):  # weights with a variance of the misfit in them, and the fit with these weights
        residual, jacobian = model.residual(theta, data)
        misfit_square = _misfit(residual, jacobian, nu)
        if misfit_square == 0.0:
            break
        if misfit_square > HOPELESS_MISFIT**2:
            break
        theta, converged = _maximise(model, theta, data, 1.0 / (1.0 / nu + misfit_square))
    residual, jacobian = model.residual(theta, data)
    weight = 1.0 / (1.0 / nu + misfit_square)
    information = jacobian.T @ (weight[:, None] * jacobian)
    covariance = np.asarray(np.linalg.pinv(information)[:2, :2], dtype=np.float64)
    expected = model.log_density(theta)
    return SpectralFit(
        fractal_dimension=float(theta[0]),
        log_level=float(theta[1]),
        reference_frequency=reference,
        floor=float(np.exp(theta[2])) if with_floor else 0.0,
        covariance=covariance,
        low=float(f[0]),
        high=float(f[-1]),
        tail=tail,
        log_likelihood=float(-np.sum(nu * (expected + data * np.exp(-expected)))),
        parameters=parameters,
        misfit=float(np.sqrt(misfit_square)),
        chi_square=float(np.sum(nu * residual**2)),
        degrees=int(f.size - parameters),
        converged=converged,
        sampling_frequency=2.0 * spectrum.nyquist,
    )


class _Model:
    """ln of the expected density in bins at u = f / reference; parameters (D, ln level, ln floor)."""

    def __init__(
        self,
        u: NDArray[np.float64],
        spread: NDArray[np.float64],
        sampling: float,
        tail: str,
        with_floor: bool,
    ) -> None:
        self.u, self.log_u, self.spread = u, np.log(u), spread
        self.sampling, self.tail, self.with_floor = sampling, tail, with_floor

    def start(self, data: NDArray[np.float64], nu: NDArray[np.float64]) -> NDArray[np.float64]:
        slope, level = np.polyfit(self.log_u, np.log(data), 1, w=np.minimum(np.sqrt(nu), 30.0))
        theta = [np.clip(0.5 * (5.0 + slope), 0.7, 2.2), level]
        if self.with_floor:
            theta.append(np.log(0.3 * data.min()))
        return np.asarray(theta)

    def shape(self, dimension: float) -> NDArray[np.float64]:
        beta = 5.0 - 2.0 * dimension
        power = np.exp(-beta * self.log_u) * (1.0 + 0.5 * beta**2 * self.spread)
        if self.tail == "folded":
            s = max(beta, LEAST_FOLDING_EXPONENT)
            x = self.u / self.sampling
            power = power + self.sampling ** (-s) * (zeta(s, 1.0 + x) + zeta(s, 1.0 - x))
        return power

    def log_density(self, theta: NDArray[np.float64]) -> NDArray[np.float64]:
        density = np.exp(theta[1]) * self.shape(float(theta[0]))
        if self.with_floor:
            density = density + np.exp(theta[2])
        return np.log(density)

    def residual(
        self, theta: NDArray[np.float64], data: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Relative residuals I / P - 1 and the Jacobian of ln P."""
        shape = self.shape(float(theta[0]))
        h = 1e-5
        slope = (self.shape(float(theta[0] + h)) - self.shape(float(theta[0] - h))) / (2.0 * h)
        level = np.exp(theta[1])
        floor = np.exp(theta[2]) if self.with_floor else 0.0
        density = level * shape + floor
        columns = [level * slope / density, level * shape / density]
        if self.with_floor:
            columns.append(floor / density)
        return data / density - 1.0, np.stack(columns, axis=1)


def _maximise(
    model: _Model, theta: NDArray[np.float64], data: NDArray[np.float64], weight: NDArray[np.float64]
) -> tuple[NDArray[np.float64], bool]:
    """Fisher scoring with step halving."""

    def loss(t: NDArray[np.float64]) -> float:
        expected = model.log_density(t)
        with np.errstate(over="ignore"):
            value = float(np.sum(weight * (expected + data * np.exp(-expected))))
        return value if np.isfinite(value) else np.inf

    value = loss(theta)
    for _ in range(_STEPS):
        residual, jacobian = model.residual(theta, data)
        if model.with_floor and jacobian[:, 2].max() < 1e-3:
            return theta, False  # the floor vanishes: the model without one says the same
        information = jacobian.T @ (weight[:, None] * jacobian)
        information[np.diag_indices_from(information)] += 1e-12 * np.trace(information)
        if not np.isfinite(information).all():
            return theta, False
        step = np.linalg.solve(information, jacobian.T @ (weight * residual))
        step *= min(1.0, 0.5 / max(abs(step[0]), 1e-300), 5.0 / max(float(np.abs(step).max()), 1e-300))
        decrease = float(step @ (information @ step))
        for _ in range(25):
            trial = loss(theta + step)
            if trial <= value:
                break
            step = 0.5 * step
        else:
            return theta, decrease < 1e-6
        theta, value = theta + step, trial
        if decrease < 1e-9 or abs(step[:2]).max() < 1e-10:
            return theta, True
    return theta, False


def _misfit(residual: NDArray[np.float64], jacobian: NDArray[np.float64], nu: NDArray[np.float64]) -> float:
    """Variance of ln P about the fit that chance does not explain, equal weight per bin."""
    degrees = residual.size - jacobian.shape[1]
    chance = np.sum(1.0 / nu) * degrees / residual.size
    excess = (np.sum(residual**2) - chance) / degrees
    scatter = np.sqrt(2.0 * np.sum(1.0 / nu**2)) / degrees
    return float(excess) if excess > 2.0 * scatter else 0.0
