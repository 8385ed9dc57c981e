"""Where a spectrum is a power law: the widest band that the model fits, or a refusal."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from asperity.surface.spectral_likelihood import ROLL_OFFS, TAILS, SpectralFit, fit_spectrum
from asperity.surface.spectrum import BinnedSpectrum

#: Narrowest band that is called a power law [decades].
NARROWEST_DECADES = 1.0
#: Largest misfit of ln P, beyond its sampling scatter, that is still called a power law [-].
LARGEST_MISFIT = 0.15
#: Largest change of the local D from one end of the band to the other, beyond its error [-].
LARGEST_DRIFT = 0.2
#: Lowest ordinates left out: what levelling and the finite record distort.
LOWEST_ORDINATE = 3
#: Folding is considered only for bands that reach up to this share of the sampling limit [-].
FOLDING_REACH = 0.75
_EDGES_PER_DECADE = 4
#: Misfit, in units of the largest accepted, that no other roll-off mends.
_HOPELESS = 2.0


@dataclass(frozen=True)
class BandSearch:
    """Outcome of the search: a fit, or the reason why there is none."""

    fit: SpectralFit | None
    reason: str


def widest_power_law(
    *,
    spectrum: BinnedSpectrum,
    low: float | None,
    high: float | None,
    noise_density: float,
    resolved_frequency: float,
) -> BandSearch:
    """Widest self-affine band of a spectrum between frequencies that may be given [1/m].

    A band is accepted if it spans at least one decade above any white floor (a known one is given [m^3]), 1 < D < 2,
    and ln P scatters and bends about the fit by no more than the limits of this module.
    """
    lowest = LOWEST_ORDINATE / (spectrum.points * spectrum.spacing)
    highest = min(spectrum.nyquist, resolved_frequency)
    loud = spectrum.density[spectrum.frequency >= lowest] > 2.0 * noise_density
    if not loud.all():
        first = int(np.argmin(loud))
        if first == 0:
            return BandSearch(
                None, "the spectrum lies in the noise of quantised heights even at its long waves"
            )
        highest = min(highest, float(spectrum.frequency[spectrum.frequency >= lowest][first - 1]))
    bottoms = [low] if low is not None else _edges(lowest, highest)
    tops = [high] if high is not None else _edges(lowest, highest)
    windows = sorted(
        ((b, t) for b in bottoms for t in tops if t / b >= 10.0**NARROWEST_DECADES * (1.0 - 1e-9)),
        key=lambda w: w[0] / w[1],
    )
    best: SpectralFit | None = None
    nearest: tuple[float, str] = (np.inf, "")
    for bottom, top in windows:
        if best is not None and best.decades >= np.log10(top / bottom):
            break
        fit = _best_model(spectrum, bottom, top)
        if fit is None:
            continue
        fault, grade = _fault(fit, spectrum)
        if not fault and (best is None or fit.decades > best.decades):
            best = fit
        elif fault and grade < nearest[0]:
            nearest = (grade, fault)
    if best is not None:
        return BandSearch(best, "")
    if not windows:
        return BandSearch(
            None,
            f"only {max(np.log10(highest / lowest), 0.0):.2f} decades of wavelength lie between the record length "
            "and the noise or sampling limit; at least one is needed",
        )
    return BandSearch(None, nearest[1] or "no band of one decade has enough frequencies to judge")


def _edges(lowest: float, highest: float) -> list[float]:
    if highest <= lowest:
        return []
    count = max(2, int(np.ceil(np.log10(highest / lowest) * _EDGES_PER_DECADE)) + 1)
    return [float(f) for f in np.logspace(np.log10(lowest), np.log10(highest), count)]


def _best_model(spectrum: BinnedSpectrum, low: float, high: float) -> SpectralFit | None:
    """The likeliest of the models (power above the sampling limit, roll-off gradual or sharp).

    What the others say differently enters the covariance with their likelihood as weight.
    """
    tails = TAILS if spectrum.rows_of_a_map else TAILS[:2]
    if high < FOLDING_REACH * spectrum.nyquist:
        tails = tails[:1]
    fits: list[SpectralFit] = []
    for m in ROLL_OFFS:
        for tail in tails:
            fit = fit_spectrum(spectrum=spectrum, low=low, high=high, tail=tail, roll_off_exponent=m)
            if fit is not None and fit.converged:
                fits.append(fit)
        if all(fit.misfit > _HOPELESS * LARGEST_MISFIT for fit in fits):
            break  # the sharp roll-off does not help either
    if not fits:
        return None
    best = max(fits, key=lambda fit: fit.log_likelihood)
    dispersion = max(1.0, best.chi_square / best.degrees)
    total, spread = 0.0, np.zeros((2, 2))
    for fit in fits:
        weight = float(np.exp((fit.log_likelihood - best.log_likelihood) / dispersion))
        off = np.array([fit.fractal_dimension - best.fractal_dimension, fit.log_level - best.log_level])
        total += weight
        spread += weight * np.outer(off, off)
    return replace(best, covariance=best.covariance + spread / total)


def _fault(fit: SpectralFit, spectrum: BinnedSpectrum) -> tuple[str, float]:
    """What forbids calling this band a power law, in words, and how far off it is; empty if nothing."""
    where = f"between the wavelengths {1 / fit.high:.3g} m and {1 / fit.low:.3g} m"
    if not 1.0 < fit.fractal_dimension < 2.0:
        off = max(1.0 - fit.fractal_dimension, fit.fractal_dimension - 2.0)
        return (
            f"{where} the spectrum falls as frequency^-{5 - 2 * fit.fractal_dimension:.2f}; a fractal profile "
            "(1 < D < 2) needs an exponent between 1 and 3",
            2.0 + off,
        )
    if fit.decades < NARROWEST_DECADES * (1.0 - 1e-9):
        return (
            f"{where} only {max(fit.decades, 0.0):.2f} decades follow a power law, between the roll-off at "
            "long waves and the noise or smoothing at short waves; at least one is needed",
            4.0 + NARROWEST_DECADES - fit.decades,
        )
    if fit.misfit > LARGEST_MISFIT:
        return (
            f"{where} the spectrum departs from a power law by {100 * fit.misfit:.0f} % rms, sampling scatter "
            f"not counted ({100 * LARGEST_MISFIT:.0f} % is the limit)",
            fit.misfit / LARGEST_MISFIT,
        )
    drift, error = _drift(fit, spectrum)
    if abs(drift) > LARGEST_DRIFT and abs(drift) > 2.0 * error:
        return (
            f"{where} the spectrum bends: the local D changes by {drift:+.2f} from the long to the "
            f"short waves ({LARGEST_DRIFT} is the limit)",
            abs(drift) / LARGEST_DRIFT,
        )
    return "", 0.0


def _drift(fit: SpectralFit, spectrum: BinnedSpectrum) -> tuple[float, float]:
    """Change of the local D across the band and its standard error, from a parabola in ln f."""
    inside = fit.inside(spectrum)
    f = spectrum.frequency[inside]
    if f.size < 6:
        return 0.0, np.inf
    weight = np.sqrt(1.0 / (1.0 / spectrum.independent[inside] + fit.misfit**2))
    u = np.log(f / np.sqrt(f[0] * f[-1]))
    design = np.stack([np.ones_like(u), u, u**2], axis=1) * weight[:, None]
    residual = (spectrum.density[inside] / fit.expected(f) - 1.0) * weight
    covariance = np.linalg.pinv(design.T @ design)
    curvature = float((covariance @ (design.T @ residual))[2])
    width = float(u[-1] - u[0])
    return curvature * width, float(np.sqrt(covariance[2, 2])) * width
