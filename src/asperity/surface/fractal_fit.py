"""D and G of measured profiles by four estimators, with covariance, band and refusal."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import digamma, ndtri

from asperity.errors import InputError, NoSolutionError
from asperity.surface.file_formats import LARGEST_SPAN
from asperity.surface.line_spectrum import fit_lines
from asperity.surface.scratches import scratches
from asperity.surface.self_affine_band import NARROWEST_DECADES, widest_power_law
from asperity.surface.spectral_likelihood import SpectralFit
from asperity.surface.spectrum import BinnedSpectrum, binned_spectrum, without_line
from asperity.surface.structure_function import (
    height_step,
    quantisation_noise_density,
    resolved_frequency,
    structure_line,
)

#: ``automatic`` takes ``lines`` where the spectrum is a Weierstrass-Mandelbrot comb, else ``likelihood``.
ESTIMATORS = ("automatic", "likelihood", "lines", "structure_function", "power_spectrum")
_BINS_PER_DECADE = 20
#: Standard errors by which D must lie inside 1 .. 2.
CERTAIN = 1.96
#: Heights that leave a straight line by less than this share of their span are rounding errors [-].
_ROUNDING = 1e-12


@dataclass(frozen=True)
class FractalFit:
    """D and G of one set of profiles.

    ``fractal_dimension``: D of a profile [-]; ``log_roughness``: ln G, G in metres; ``covariance`` of (D, ln G), shape
    (2, 2); ``frequency_ratio``: gamma of the model that G belongs to [-], G itself does not depend on it;
    ``shortest_wavelength`` and ``longest_wavelength``: limits of the self-affine band [m]; ``profiles`` averaged, of so
    many ``points`` each.

    ``noise_density``: white noise found in the spectrum, or of known quantisation [m^3], zero if there is none;
    ``roll_off_wavelength``: above it the spectrum falls below the power law [m], None if it does not within the record;
    ``height_step`` of quantised heights [m] or None; ``misfit``: standard deviation of ln P about the model that
    sampling scatter does not explain [-], of the estimator "lines" that of the logarithm of the amplitudes;
    ``reduced_chi_square`` of the spectrum per degree of freedom [-], None for "lines".
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
    roll_off_wavelength: float | None
    height_step: float | None
    misfit: float
    reduced_chi_square: float | None

    @property
    def fractal_roughness(self) -> float:
        """G [m]."""
        return math.exp(self.log_roughness)

    def dimension_interval(self, *, confidence: float) -> tuple[float, float]:
        """Confidence interval of D [-]."""
        reach = float(ndtri(0.5 + 0.5 * confidence)) * math.sqrt(self.covariance[0, 0])
        return self.fractal_dimension - reach, self.fractal_dimension + reach

    def roughness_interval(self, *, confidence: float) -> tuple[float, float]:
        """Confidence interval of G [m], symmetric in ln G."""
        reach = float(ndtri(0.5 + 0.5 * confidence)) * math.sqrt(self.covariance[1, 1])
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

    Heights [m] of shape (profiles, points), none missing; a tilt is removed here. The points lie at the distance
    ``spacing`` [m]; ``estimator`` is one of :data:`ESTIMATORS`; ``frequency_ratio`` is gamma of the
    Weierstrass-Mandelbrot model [-]; ``rows_of_a_map`` says whether the profiles are neighbouring rows of one map,
    which resemble each other, or independent. Limits of the band [m] that are None are searched for; so is, if None,
    the step to which the instrument rounded the heights [m], as seen before levelling.

    ``likelihood``: maximum (Whittle) likelihood of the averaged spectrum; the model contains a roll-off at long waves,
    white noise or smoothing at short waves, and folding at the sampling limit. ``structure_function``: weighted
    straight line of ln S against ln lag, its covariance by the jackknife over blocks. ``power_spectrum``: straight line
    of ln P against ln f, Hann window. Both straight lines use the band that the likelihood fit accepts, and their
    intervals contain the shift of D that the roll-off, the noise and the folding of that fit cause. ``lines``:
    amplitudes of the comb of the Weierstrass-Mandelbrot function.

    An ``InputError`` if an argument is out of range; a ``NoSolutionError`` if there is no power law over at least one
    decade, or scratches or spikes bend it; the message says why.
    """
    _refuse_arguments(estimator, frequency_ratio, shortest_wavelength, longest_wavelength)
    _refuse_no_roughness(profiles)
    if estimator in ("automatic", "lines"):
        lines = _from_lines(profiles, spacing, frequency_ratio)
        if lines is not None:
            return lines
        if estimator == "lines":
            raise NoSolutionError(
                f"the spectrum is not a series of lines at f0 * {frequency_ratio:g}^n with amplitudes of a "
                "power law; use the estimator 'likelihood' for a continuous spectrum"
            )
    step = known_height_step if known_height_step is not None else height_step(profiles=profiles)
    noise = quantisation_noise_density(step=step, spacing=spacing) if step is not None else 0.0
    spectrum = binned_spectrum(
        profiles=profiles,
        spacing=spacing,
        differenced=True,
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
    if search.fit is None:
        raise _refusal(search.reason, step)
    fit = search.fit
    _refuse_scratches(profiles, spacing, fit, rows_of_a_map)
    common = {
        "frequency_ratio": frequency_ratio,
        "profiles": profiles.shape[0],
        "points": profiles.shape[1],
        "noise_density": max(fit.floor if fit.floor > CERTAIN * fit.floor_error else 0.0, noise),
        "roll_off_wavelength": fit.roll_off_wavelength,
        "height_step": step,
        "misfit": fit.misfit,
        "reduced_chi_square": fit.chi_square / fit.degrees,
    }
    result = _estimated(profiles, spacing, estimator, fit, rows_of_a_map, common)
    D, reach = result.fractal_dimension, CERTAIN * math.sqrt(result.covariance[0, 0])
    if not (D - reach > 1.0 and D + reach < 2.0):
        raise _refusal(
            f"the 95 % interval of D, {D:.3f} ± {reach:.3f}, is not inside the range 1 to 2 of a fractal profile",
            step,
        )
    return result


def _refuse_arguments(
    estimator: str,
    frequency_ratio: float,
    shortest_wavelength: float | None,
    longest_wavelength: float | None,
) -> None:
    """Refuse an estimator that does not exist, and numbers out of range."""
    if estimator not in ESTIMATORS:
        raise InputError(f"there is no estimator '{estimator}'; known: {', '.join(ESTIMATORS)}")
    if not (frequency_ratio > 1.0 and math.isfinite(frequency_ratio)):
        raise InputError(f"the frequency ratio gamma is {frequency_ratio}; it must be above 1")
    limits = (shortest_wavelength, longest_wavelength)
    if any(limit is not None and not (limit > 0.0 and math.isfinite(limit)) for limit in limits):
        raise InputError(f"the limits of the band are {limits} m; a wavelength must be a positive length")
    if None not in limits and not shortest_wavelength < longest_wavelength:  # type: ignore[operator]
        raise InputError(
            f"the shortest wavelength, {shortest_wavelength} m, must be below the longest, {longest_wavelength} m"
        )


def _refuse_no_roughness(profiles: NDArray[np.float64]) -> None:
    """Refuse profiles that are too short, and heights without roughness or in a wrong unit."""
    if profiles.ndim != 2 or profiles.shape[1] < 64:
        raise NoSolutionError(
            f"profiles of {profiles.shape[-1]} points are too short for a fractal dimension; 64 or more are needed"
        )
    with np.errstate(over="ignore"):
        span = float(np.ptp(profiles))
    if span > LARGEST_SPAN:
        raise InputError(f"the heights span {span:.3g} m, which is too large; check their unit")
    if span < 1.0 / LARGEST_SPAN:
        raise NoSolutionError("all heights are equal: there is no roughness to measure")
    blocks = (profiles[start : start + 64] for start in range(0, profiles.shape[0], 64))
    if all(float(np.ptp(without_line(block))) <= _ROUNDING * span for block in blocks):
        raise NoSolutionError("all heights lie on a straight line: there is no roughness to measure")


def _refuse_scratches(
    profiles: NDArray[np.float64], spacing: float, fit: SpectralFit, rows_of_a_map: bool
) -> None:
    """Refuse heights with scratches or spikes within the band of the fit."""
    low, high = fit.usable_band
    blemish = scratches(
        profiles=profiles,
        spacing=spacing,
        shortest_wavelength=1.0 / high,
        longest_wavelength=1.0 / low,
        rows_of_a_map=rows_of_a_map,
    )
    if blemish:
        raise NoSolutionError(
            f"no D and G, because the heights are not normally distributed: {blemish}; measure another section, or "
            "begin the band at longer waves"
        )


def _estimated(
    profiles: NDArray[np.float64],
    spacing: float,
    estimator: str,
    fit: SpectralFit,
    rows_of_a_map: bool,
    common: dict,
) -> FractalFit:
    """D and G by an estimator, in the band of the likelihood fit; what all have in common is known."""
    if estimator == "structure_function":
        line = structure_line(profiles=profiles, spacing=spacing, fit=fit)
        return FractalFit(estimator=estimator, **vars(line), **common)
    if estimator == "power_spectrum":
        hann = binned_spectrum(
            profiles=profiles,
            spacing=spacing,
            differenced=False,
            bins_per_decade=_BINS_PER_DECADE,
            rows_of_a_map=rows_of_a_map,
        )
        return _result(*_straight_line(hann, fit), fit, estimator, common)
    return _result(fit.fractal_dimension, fit.log_level, fit.covariance, fit, "likelihood", common)


def _refusal(reason: str, step: float | None) -> NoSolutionError:
    quantised = "" if step is None else f"; the heights are quantised in steps of {1e6 * step:.4g} um"
    return NoSolutionError(
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
        roll_off_wavelength=None,
        height_step=None,
        misfit=lines.misfit,
        reduced_chi_square=None,
    )


def _result(
    D: float,
    log_level: float,
    covariance: NDArray[np.float64],
    fit: SpectralFit,
    estimator: str,
    common: dict,
) -> FractalFit:
    """From (D, ln P at the reference frequency) and their covariance to (D, ln G)."""
    if not 1.0 < D < 2.0:
        raise NoSolutionError(
            f"the estimator '{estimator}' gives D = {D:.3f}, outside 1 .. 2: no fractal profile"
        )
    log_f = math.log(fit.reference_frequency)
    log_G = (log_level + math.log(2.0) + (5.0 - 2.0 * D) * log_f) / (2.0 * (D - 1.0))
    jacobian = np.array([[1.0, 0.0], [-(log_f + log_G) / (D - 1.0), 0.5 / (D - 1.0)]])
    low, high = fit.usable_band
    return FractalFit(
        fractal_dimension=D,
        log_roughness=log_G,
        covariance=jacobian @ covariance @ jacobian.T,
        shortest_wavelength=1.0 / high,
        longest_wavelength=1.0 / low,
        estimator=estimator,
        **common,
    )


def _straight_line(spectrum: BinnedSpectrum, fit: SpectralFit) -> tuple[float, float, NDArray[np.float64]]:
    """Least squares of ln P on ln f within the band, the mean logarithm of chi-square subtracted."""
    inside = fit.inside(spectrum)
    f, nu = spectrum.frequency[inside], spectrum.independent[inside]
    y = np.log(spectrum.density[inside]) - (digamma(nu) - np.log(nu))
    u = np.log(f / fit.reference_frequency)
    design = np.stack([2.0 * u, np.ones_like(u)], axis=1)
    weight = 1.0 / (1.0 / nu + fit.misfit**2)
    covariance = np.linalg.inv(design.T @ (weight[:, None] * design))
    to_parameters = covariance @ (design.T * weight)  # slope = 2 D - 5
    D, level = to_parameters @ (y + 5.0 * u)
    shift = to_parameters @ np.log(fit.expected(f) / fit.density(f))
    scatter = max(1.0, fit.chi_square / fit.degrees)
    return float(D), float(level), covariance * scatter + np.outer(shift, shift)
