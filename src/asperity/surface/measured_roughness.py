"""What measurements tell of a surface, or of two together: waves, D and G of a power law; from and to the document."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asperity.engine.arrays import xp
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
from asperity.surface.measurement_of import MeasurementOf, known_measurement_of
from asperity.types import Document


@dataclass(frozen=True)
class MeasuredRoughness:
    """A measured surface, or two that meet, with the files measured.

    ``fractal``: D and G, None without a power law, for the reason ``no_power_law``; ``spectra`` of each body, empty in
    documents of earlier releases. ``of``: whether both are those of one body, or of both together.
    """

    fractal: SurfaceMeasurement | None
    no_power_law: str
    spectra: tuple[HeightSpectrum, ...]
    source: str
    of: MeasurementOf = "body"

    @property
    def pair(self) -> MeasuredRoughness:
        r"""What a contact has: the measurement of a pair as it is; of one body that of two such bodies, both alike.

        Mean squares of waves and structure functions double:

        .. math::
            h_{rms}^2 \to 2 h_{rms}^2, \qquad G^{2(D-1)} \to 2\, G^{2(D-1)}

        at the same D. One measurement tells of both bodies, so that its error is that of both alike: the covariance
        follows by the derivatives of this rule, and is not that of two independent measurements.
        """
        if self.of == "pair":
            return self
        spectra = tuple(replace(spectrum, bodies=2) for spectrum in self.spectra)
        if self.fractal is None:
            return replace(self, spectra=spectra, of="pair")
        try:
            fractal, reason = _of_two_alike(self.fractal), ""
        except NoSolutionError as error:
            if not spectra:
                raise
            return MeasuredRoughness(None, str(error), spectra, self.source, "pair")
        return MeasuredRoughness(fractal, reason, spectra, self.source, "pair")

    @property
    def words(self) -> str:
        """Of what the measurement is, and what a joint makes of that."""
        if self.of == "pair":
            return f"measured surface: the pair as measured: {self.source}"
        return (
            f"measured surface: each body as measured: {self.source}; both are alike, and their mean squares add; if "
            'it was measured of both together, state measurement_of = "pair"'
        )


def measurement_of(measured: MeasuredRoughness, stated: str | None) -> MeasuredRoughness:
    """A measurement that somebody states to be of one body or of the pair; an ``InputError`` if it says otherwise."""
    if stated is None:
        return measured
    of = known_measurement_of(stated)
    if of == "body" and measured.of == "pair":
        raise InputError(
            f"{measured.source}: the document is that of a pair, such as 'asperity surface combine' makes of two "
            "bodies, not of one body; leave out of what the measurement is",
            options=["measurement-of"],
        )
    return replace(measured, of=of)


def roughness_document(roughness: MeasuredRoughness) -> Document:
    """A measured surface as plain numbers and text for JSON, units in the names."""
    document: Document
    if roughness.fractal is None:
        document = {
            "schema": SCHEMA,
            "schema_version": SCHEMA_VERSION,
            "source": roughness.source,
            "no_power_law": roughness.no_power_law,
        }
    else:
        document = measurement_document(measurement=roughness.fractal)
    document["measurement_of"] = roughness.of
    if roughness.spectra:
        document["spectra"] = [spectrum.document() for spectrum in roughness.spectra]
    return document


def roughness_from_document(document: Any) -> MeasuredRoughness:
    """A measured surface from its document.

    An ``InputError`` if this is no such document, or one of an earlier release that was refused. Documents of earlier
    releases do not say of what they are: those of two surfaces are of a pair.
    """
    refuse_other_documents(document)
    spectra = document.get("spectra", [])
    if not isinstance(spectra, list) or len(spectra) > 2:
        raise InputError("the key 'spectra' of the measurement must be a list of at most two spectra")
    read = tuple(spectrum_from_document(spectrum) for spectrum in spectra)
    reason = document.get("no_power_law")
    combined = len(read) == 2 or str(document.get("estimator", "")).startswith(_SUM)
    try:
        of = known_measurement_of(document.get("measurement_of", "pair" if combined else "body"))
    except InputError as error:
        raise InputError(f"the key 'measurement_of' of the measurement: {error}") from None
    if combined and of == "body":
        raise InputError("the key 'measurement_of' of a measurement of two surfaces must be 'pair'")
    if reason is None:
        fractal = measurement_from_document(document=document)
        return MeasuredRoughness(fractal, "", read, fractal.source, of)
    if not isinstance(reason, str) or not isinstance(document.get("source", ""), str):
        raise InputError("the keys 'no_power_law' and 'source' of the measurement must be texts")
    return MeasuredRoughness(None, reason, read, document.get("source", ""), of)


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

    Without D and G where one of them has none, or both together have none. An ``InputError`` if one of them is that of
    a pair already.
    """
    for body in (first, second):
        if body.of == "pair":
            raise InputError(
                f"{body.source}: a measurement of both bodies together; two measurements are of one body each"
            )
    source = f"{first.source} + {second.source}"
    complete = bool(first.spectra) and bool(second.spectra)
    spectra = (*first.spectra, *second.spectra) if complete else ()
    if first.fractal is None or second.fractal is None:
        reasons = [f"{body.source}: {body.no_power_law}" for body in (first, second) if body.fractal is None]
        return MeasuredRoughness(None, "; ".join(reasons), spectra, source, "pair")
    try:
        both = equivalent_surface(first=first.fractal, second=second.fractal)
    except NoSolutionError as error:
        if not complete:
            raise
        return MeasuredRoughness(None, str(error), spectra, source, "pair")
    return MeasuredRoughness(both, "", spectra, source, "pair")


def _of_two_alike(measurement: SurfaceMeasurement) -> SurfaceMeasurement:
    """D and G of two bodies with the same measured surface, and their covariance: that of one error of both."""
    D, log_G = float(measurement.fractal_dimension), math.log(float(measurement.fractal_roughness))
    shift = math.log(2.0) / (2.0 * (D - 1.0))
    if not log_G + shift <= 0.0:
        raise NoSolutionError(f"two such surfaces together have D = {D:.10g}, too near to 1")
    jacobian = np.array([[1.0, 0.0], [-shift / (D - 1.0), 1.0]])
    return replace(
        measurement,
        fractal_roughness=xp.asarray(math.exp(log_G + shift)),
        covariance=xp.asarray(jacobian @ np.asarray(measurement.covariance) @ jacobian.T),
    )


_LAGS = 200
#: How the estimator of two surfaces together begins.
_SUM = "sum of "
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
        estimator=f"{_SUM}{first.estimator} and {second.estimator}",
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
