"""D and G of measured profiles by four estimators, with covariance, band and refusal."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import digamma
from scipy.stats import norm

from asperity.errors import InputError, NoSolutionError
from asperity.surface import conventions
from asperity.surface.line_spectrum import fit_lines
from asperity.surface.quantisation import height_step, quantisation_noise_density, resolved_frequency
from asperity.surface.self_affine_band import NARROWEST_DECADES, BandSearch, widest_power_law
from asperity.surface.spectral_likelihood import SpectralFit
from asperity.surface.spectrum import BinnedSpectrum, binned_spectrum
from asperity.surface.structure_function import logarithmic_lags, structure_functions

#: ``automatic`` takes ``lines`` where the spectrum is a Weierstrass-Mandelbrot comb, else ``likelihood``.
ESTIMATORS = ("automatic", "likelihood", "lines", "structure_function", "power_spectrum")
_BINS_PER_DECADE = 20
_SEGMENTS = 12
#: Standard errors by which D must lie inside 1 .. 2.
CERTAIN = 1.96


@dataclass(frozen=True)
class FractalFit:
    """D and G of one set of profiles.

    Attributes
    ----------
    fractal_dimension : float
        D of a profile [-].
    log_roughness : float
        ln G, G in metres.
    covariance : array, shape (2, 2)
        Of (D, ln G).
    frequency_ratio : float
        gamma of the model that G belongs to [-]; G itself does not depend on it.
    shortest_wavelength, longest_wavelength : float
        Limits of the self-affine band [m].
    estimator : str
        Which estimator this is.
    profiles, points : int
        Number of profiles averaged and points of each.
    noise_density : float
        White floor found in the spectrum, or of known quantisation [m^3].
    height_step : float or None
        Step of quantised heights [m].
    misfit : float
        Scatter about the power law beyond chance [-].
    """

    fractal_dimension: float
    log_roughness: float
    covariance: NDArray[np.float64]
    frequency_ratio: float
    shortest_wavelength: float
    longest_wavelength: float
    estimator: str
    profiles: int
    points: int
    noise_density: float
    height_step: float | None
    misfit: float

    @property
    def fractal_roughness(self) -> float:
        """G [m]."""
        return math.exp(self.log_roughness)

    def dimension_interval(self, *, confidence: float) -> tuple[float, float]:
        """Confidence interval of D [-]."""
        reach = float(norm.ppf(0.5 + 0.5 * confidence)) * math.sqrt(self.covariance[0, 0])
        return self.fractal_dimension - reach, self.fractal_dimension + reach

    def roughness_interval(self, *, confidence: float) -> tuple[float, float]:
        """Confidence interval of G [m], symmetric in ln G."""
        reach = float(norm.ppf(0.5 + 0.5 * confidence)) * math.sqrt(self.covariance[1, 1])
        return math.exp(self.log_roughness - reach), math.exp(self.log_roughness + reach)


def fractal_fit(
    *,
    profiles: NDArray[np.float64],
    spacing: float,
    estimator: str,
    frequency_ratio: float,
    rows_of_a_map: bool,
    shortest_wavelength: float | None = None,
    longest_wavelength: float | None = None,
    known_height_step: float | None = None,
) -> FractalFit:
    """Fractal dimension and roughness of parallel profiles, or a refusal.

    Parameters
    ----------
    profiles : array, shape (profiles, points)
        Heights [m], no missing points; tilt need not be taken off.
    spacing : float
        Distance of the points [m].
    estimator : str
        One of :data:`ESTIMATORS`.
    frequency_ratio : float
        gamma of the Weierstrass-Mandelbrot model [-].
    rows_of_a_map : bool
        Whether the profiles are neighbouring rows of one map, which resemble each other, or independent.
    shortest_wavelength, longest_wavelength : float or None
        Limits of the band [m]; None lets the search choose.
    known_height_step : float or None
        Step to which the instrument rounded the heights [m], as seen before levelling; None looks for one.

    Returns
    -------
    FractalFit

    Raises
    ------
    InputError
        If an argument is out of range.
    NoSolutionError
        If there is no power law over at least one decade; the message says why.

    Notes
    -----
    ``likelihood``: maximum (Whittle) likelihood of the averaged spectrum, with folding at the sampling limit
    or a white floor where the data call for it. ``structure_function``: weighted straight line of ln S
    against ln lag, its covariance by the jackknife over blocks. ``power_spectrum``: straight line of ln P
    against ln f, Hann window. ``lines``: amplitudes of the comb of the Weierstrass-Mandelbrot function.
    """
    if estimator not in ESTIMATORS:
        raise InputError(f"there is no estimator '{estimator}'; known: {', '.join(ESTIMATORS)}")
    if not (frequency_ratio > 1.0 and math.isfinite(frequency_ratio)):
        raise InputError(f"the frequency ratio gamma is {frequency_ratio}; it must be above 1")
    if profiles.ndim != 2 or profiles.shape[1] < 64:
        raise NoSolutionError(
            f"profiles of {profiles.shape[-1]} points are too short for a fractal dimension; 64 or "
            f"more are needed"
        )
    if np.ptp(profiles) == 0.0:
        raise NoSolutionError("all heights are equal: there is no roughness to measure")
    if estimator in ("automatic", "lines"):
        lines = _from_lines(profiles, spacing, frequency_ratio)
        if lines is not None:
            return lines
        if estimator == "lines":
            raise NoSolutionError(
                f"the spectrum is not a comb of lines at f0 * {frequency_ratio:g}^n with amplitudes "
                f"of a power law; "
                "use the estimator 'likelihood' for a continuous spectrum"
            )
    step = known_height_step if known_height_step is not None else height_step(profiles=profiles)
    noise = quantisation_noise_density(step=step, spacing=spacing) if step is not None else 0.0
    hann = estimator == "power_spectrum"
    spectrum = binned_spectrum(
        profiles=profiles,
        spacing=spacing,
        differenced=not hann,
        bins_per_decade=_BINS_PER_DECADE,
        rows_of_a_map=rows_of_a_map,
    )
    search = widest_power_law(
        spectrum=spectrum,
        low=None if longest_wavelength is None else 1.0 / longest_wavelength,
        high=None if shortest_wavelength is None else 1.0 / shortest_wavelength,
        noise_density=noise,
        resolved_frequency=math.inf
        if step is None
        else resolved_frequency(profiles=profiles, step=step, spacing=spacing),
    )
    fit = _accepted(search, step)
    common = {
        "frequency_ratio": frequency_ratio,
        "profiles": profiles.shape[0],
        "points": profiles.shape[1],
        "noise_density": max(fit.floor, noise),
        "height_step": step,
    }
    if estimator == "structure_function":
        return _from_structure_function(profiles, spacing, fit, common)
    if estimator == "power_spectrum":
        return _from_straight_line(spectrum, fit, common)
    D = fit.fractal_dimension
    return _result(
        D, fit.log_level, fit.reference_frequency, fit.covariance, fit, "likelihood", fit.misfit, common
    )


def _accepted(search: BandSearch, step: float | None) -> SpectralFit:
    if search.fit is not None:
        D, error = search.fit.fractal_dimension, math.sqrt(search.fit.covariance[0, 0])
        if D - CERTAIN * error > 1.0 and D + CERTAIN * error < 2.0:
            return search.fit
        reason = (
            f"D = {D:.3f} +- {CERTAIN * error:.3f} (95 %) cannot be told from the limits 1 and 2 of a "
            "fractal profile"
        )
    else:
        reason = search.reason
    quantised = "" if step is None else f"; the heights are quantised in steps of {1e6 * step:.4g} um"
    raise NoSolutionError(
        f"no power law over at least {NARROWEST_DECADES:g} decade, so no D and G: {reason}{quantised}"
    )


def _from_lines(profiles: NDArray[np.float64], spacing: float, gamma: float) -> FractalFit | None:
    lines = fit_lines(profiles=profiles, spacing=spacing, frequency_ratio=gamma)
    if lines is None:
        return None
    return FractalFit(
        fractal_dimension=lines.fractal_dimension,
        log_roughness=lines.log_roughness,
        covariance=lines.covariance,
        frequency_ratio=gamma,
        shortest_wavelength=1.0 / lines.high,
        longest_wavelength=1.0 / lines.low,
        estimator="lines",
        profiles=profiles.shape[0],
        points=profiles.shape[1],
        noise_density=0.0,
        height_step=None,
        misfit=lines.misfit,
    )


def _result(
    D: float,
    log_level: float,
    reference: float,
    covariance: NDArray[np.float64],
    fit: SpectralFit,
    estimator: str,
    misfit: float,
    common: dict,
) -> FractalFit:
    """From (D, ln P at a reference frequency) and their covariance to (D, ln G)."""
    if not 1.0 < D < 2.0:
        raise NoSolutionError(
            f"the estimator '{estimator}' gives D = {D:.3f}, outside 1 .. 2: no fractal profile"
        )
    log_f = math.log(reference)
    log_G = (log_level + math.log(2.0) + (5.0 - 2.0 * D) * log_f) / (2.0 * (D - 1.0))
    jacobian = np.array([[1.0, 0.0], [-(log_f + log_G) / (D - 1.0), 0.5 / (D - 1.0)]])
    return FractalFit(
        fractal_dimension=D,
        log_roughness=log_G,
        covariance=jacobian @ covariance @ jacobian.T,
        shortest_wavelength=1.0 / fit.usable_high,
        longest_wavelength=1.0 / fit.low,
        estimator=estimator,
        misfit=misfit,
        **common,
    )


def _from_straight_line(spectrum: BinnedSpectrum, fit: SpectralFit, common: dict) -> FractalFit:
    """Least squares of ln P on ln f within the band, the mean logarithm of chi-square taken off."""
    inside = (spectrum.frequency >= fit.low * (1 - 1e-9)) & (
        spectrum.frequency <= fit.usable_high * (1 + 1e-9)
    )
    nu = spectrum.independent[inside]
    y = np.log(spectrum.density[inside]) - (digamma(nu) - np.log(nu))
    reference = fit.reference_frequency
    u = np.log(spectrum.frequency[inside] / reference)
    design = np.stack([np.ones_like(u), u], axis=1)
    weight = 1.0 / (1.0 / nu + fit.misfit**2)
    covariance = np.linalg.inv(design.T @ (weight[:, None] * design))
    level, slope = covariance @ (design.T @ (weight * y))
    to_dimension = np.array([[0.0, 0.5], [1.0, 0.0]])  # D = (5 + slope) / 2
    covariance = to_dimension @ covariance @ to_dimension.T
    return _result(
        0.5 * (5.0 + float(slope)),
        float(level),
        reference,
        covariance,
        fit,
        "power_spectrum",
        fit.misfit,
        common,
    )


def _from_structure_function(
    profiles: NDArray[np.float64], spacing: float, fit: SpectralFit, common: dict
) -> FractalFit:
    """Straight line of ln S on ln lag, weights 1/lag; covariance by leaving out one block at a time."""
    pieces = profiles
    if profiles.shape[0] < _SEGMENTS:
        cut = max(1, _SEGMENTS // profiles.shape[0])
        length = profiles.shape[1] // cut
        pieces = profiles[:, : cut * length].reshape(-1, length)
    lags = logarithmic_lags(points=pieces.shape[1], per_decade=12, longest_fraction=0.25)
    tau = lags.astype(np.float64) * spacing
    used = (tau >= 0.5 / fit.usable_high * (1 - 1e-9)) & (tau <= 0.5 / fit.low)
    if used.sum() < 4 or np.log10(tau[used][-1] / tau[used][0]) < NARROWEST_DECADES - 1e-9:
        raise NoSolutionError(
            "less than one decade of lags lies in the self-affine band: no structure function fit"
        )
    S = structure_functions(profiles=pieces, lags=lags[used])
    blocks = np.array_split(np.arange(pieces.shape[0]), min(_SEGMENTS, pieces.shape[0]))
    sums = np.stack([S[b].sum(axis=0) for b in blocks])
    counts = np.array([b.size for b in blocks], dtype=np.float64)
    whole = _line(tau[used], sums.sum(axis=0) / counts.sum())
    left_out = np.stack(
        [
            _line(tau[used], (sums.sum(axis=0) - s) / (counts.sum() - c))
            for s, c in zip(sums, counts, strict=True)
        ]
    )
    k = len(blocks)
    covariance = (k - 1) * np.cov(left_out.T, bias=True)
    D, log_G = whole
    if not 1.0 < D < 2.0:
        raise NoSolutionError(f"the structure function gives D = {D:.3f}, outside 1 .. 2: no fractal profile")
    return FractalFit(
        fractal_dimension=float(D),
        log_roughness=float(log_G),
        covariance=covariance,
        shortest_wavelength=2.0 * float(tau[used][0]),
        longest_wavelength=2.0 * float(tau[used][-1]),
        estimator="structure_function",
        misfit=fit.misfit,
        **common,
    )


def _line(tau: NDArray[np.float64], S: NDArray[np.float64]) -> NDArray[np.float64]:
    """(D, ln G) of the straight line through ln S."""
    slope, level = np.polyfit(np.log(tau / tau[0]), np.log(S), 1, w=np.sqrt(tau[0] / tau))
    D = min(max(2.0 - 0.5 * slope, 1.0 + 1e-6), 2.0 + 1e-6)
    if D >= 2.0:
        return np.array([D, np.nan])
    level_S = math.exp(level)
    G = conventions.roughness_from_structure_function(level=level_S, lag=float(tau[0]), fractal_dimension=D)
    return np.array([D, math.log(G)])
