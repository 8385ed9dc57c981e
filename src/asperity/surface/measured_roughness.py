"""What measurements tell of a surface, or of two together: waves, D and G of a power law; from and to the document."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError, NoSolutionError
from asperity.surface import conventions
from asperity.surface.height_spectrum import HeightSpectrum, spectrum_from_document
from asperity.surface.measurement import (
    SCHEMA,
    SCHEMA_VERSION,
    SurfaceMeasurement,
    measured,
    measurement_document,
    measurement_from_document,
    read_measurement_document,
    refuse_other_documents,
)


@dataclass(frozen=True)
class MeasuredRoughness:
    """A measured surface, or two that meet, with the files measured.

    ``fractal``: D and G of both together, None without a power law, for the reason ``no_power_law``; ``spectra`` of
    each body, empty in documents of earlier releases.
    """

    fractal: SurfaceMeasurement | None
    no_power_law: str
    spectra: tuple[HeightSpectrum, ...]
    source: str


def roughness_document(roughness: MeasuredRoughness) -> dict[str, Any]:
    """A measured surface as plain numbers and text for JSON, units in the names."""
    document: dict[str, Any]
    if roughness.fractal is None:
        document = {
            "schema": SCHEMA,
            "schema_version": SCHEMA_VERSION,
            "source": roughness.source,
            "no_power_law": roughness.no_power_law,
        }
    else:
        document = measurement_document(measurement=roughness.fractal)
    if roughness.spectra:
        document["spectra"] = [spectrum.document() for spectrum in roughness.spectra]
    return document


def roughness_from_document(document: Any) -> MeasuredRoughness:
    """A measured surface from its document.

    An ``InputError`` if this is no such document, or one of an earlier release that was refused.
    """
    refuse_other_documents(document)
    spectra = document.get("spectra", [])
    if not isinstance(spectra, list) or len(spectra) > 2:
        raise InputError("the key 'spectra' of the measurement must be a list of at most two spectra")
    read = tuple(spectrum_from_document(spectrum) for spectrum in spectra)
    reason = document.get("no_power_law")
    if reason is None:
        fractal = measurement_from_document(document=document)
        return MeasuredRoughness(fractal, "", read, fractal.source)
    if not isinstance(reason, str) or not isinstance(document.get("source", ""), str):
        raise InputError("the keys 'no_power_law' and 'source' of the measurement must be texts")
    return MeasuredRoughness(None, reason, read, document.get("source", ""))


def read_roughness(*, path: str | Path) -> MeasuredRoughness:
    """A measured surface from a JSON file written by ``asperity surface measure --json``.

    An ``InputError`` if the file cannot be read or is not such a document.
    """
    document = read_measurement_document(path=path)
    try:
        return roughness_from_document(document)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def two_bodies(first: MeasuredRoughness, second: MeasuredRoughness) -> MeasuredRoughness:
    """Two measured surfaces that meet: the mean squares of their waves add, and their structure functions.

    Without D and G where one of them has none, or both together have none.
    """
    source = f"{first.source} + {second.source}"
    complete = bool(first.spectra) and bool(second.spectra)
    spectra = (*first.spectra, *second.spectra) if complete else ()
    if first.fractal is None or second.fractal is None:
        reasons = [f"{body.source}: {body.no_power_law}" for body in (first, second) if body.fractal is None]
        return MeasuredRoughness(None, "; ".join(reasons), spectra, source)
    try:
        both = equivalent_surface(first=first.fractal, second=second.fractal)
    except NoSolutionError as error:
        if not complete:
            raise
        return MeasuredRoughness(None, str(error), spectra, source)
    return MeasuredRoughness(both, "", spectra, source)


_LAGS = 200
#: Largest error of ln S of the equivalent power law that is accepted [-].
LARGEST_MISFIT = 0.15


def equivalent_surface(*, first: SurfaceMeasurement, second: SurfaceMeasurement) -> SurfaceMeasurement:
    r"""One D and G for the gap between two independent rough surfaces.

    .. math::
        S(\tau) = S_1(\tau) + S_2(\tau)

    For equal D exactly :math:`G^{2(D-1)} = G_1^{2(D-1)} + G_2^{2(D-1)}`. Otherwise the sum of two power laws is not
    one; the straight line that fits ln S best, evenly in the logarithm of lag over the common band, is returned. The
    covariance follows from those of both by the derivatives of that rule. An ``InputError`` if the two were measured
    for different gamma; a ``NoSolutionError`` if the bands share less than a decade, or the sum departs from a power
    law by more than 15 % rms.
    """
    gamma = float(first.frequency_ratio)
    if abs(float(second.frequency_ratio) - gamma) > 1e-9 * gamma:
        raise InputError(
            f"the surfaces were measured for gamma = {gamma} and {float(second.frequency_ratio)}; use one gamma"
        )
    short = max(float(first.shortest_wavelength), float(second.shortest_wavelength))
    long = min(float(first.longest_wavelength), float(second.longest_wavelength))
    if long < 10.0 * short * (1.0 - 1e-9):
        raise NoSolutionError(
            f"the self-affine bands of the two surfaces share only {short:.3g} .. {long:.3g} m; a decade is needed"
        )
    lag = np.geomspace(0.5 * short, 0.5 * long, _LAGS)
    both = (first, second)
    values = np.array(
        [(float(s.fractal_dimension), math.log(float(s.fractal_roughness))) for s in both]
    ).ravel()
    result, misfit = _combined(values, lag)
    if misfit > LARGEST_MISFIT:
        raise NoSolutionError(
            f"the sum of the two surfaces departs from a power law by {100 * misfit:.0f} % rms of its structure "
            f"function (limit {100 * LARGEST_MISFIT:.0f} %): D = {values[0]:.3f} and {values[2]:.3f} differ too much"
        )
    jacobian = np.empty((2, 4))
    for i in range(4):
        step = np.zeros(4)
        step[i] = 1e-6 * (min(values[i] - 1.0, 2.0 - values[i]) if i in (0, 2) else 1.0)
        change = _combined(values + step, lag)[0] - _combined(values - step, lag)[0]
        jacobian[:, i] = 0.5 * change / step[i]
    scatter = np.zeros((4, 4))
    scatter[:2, :2], scatter[2:, 2:] = np.asarray(first.covariance), np.asarray(second.covariance)
    covariance = jacobian @ scatter @ jacobian.T
    return measured(
        *(result[0], math.exp(result[1]), gamma, covariance, short, long),
        estimator=f"sum of {first.estimator} and {second.estimator}",
        profiles=first.profiles + second.profiles,
        source=f"{first.source} + {second.source}",
    )


def _combined(values: NDArray[np.float64], lag: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """(D, ln G) of the straight line through ln(S1 + S2), and its rms misfit."""
    logs = []
    for D, log_G in (values[:2], values[2:]):
        c = conventions.structure_function_constant(fractal_dimension=float(D))
        logs.append(math.log(c) + 2.0 * (D - 1.0) * log_G + (4.0 - 2.0 * D) * np.log(lag))
    total = np.logaddexp(*logs)
    slope, level = np.polyfit(np.log(lag), total, 1)
    D = 2.0 - 0.5 * float(slope)
    inside = 1.0 + 1e-9 < D < 2.0 - 1e-9
    c = conventions.structure_function_constant(fractal_dimension=D) if inside else math.nan
    log_G = (float(level) - math.log(c)) / (2.0 * (D - 1.0)) if inside else math.nan
    if not log_G <= 0.0:
        raise NoSolutionError(f"the sum of the two surfaces has D = {D:.10g}, too near to 1 or 2")
    misfit = float(np.sqrt(np.mean((total - slope * np.log(lag) - level) ** 2)))
    return np.array([D, log_G]), misfit
