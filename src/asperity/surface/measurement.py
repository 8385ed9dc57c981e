"""The measurement document: D, G and their uncertainty as JSON in SI units, written and read."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asperity.engine.module import Module, static
from asperity.errors import InputError
from asperity.reading import read_json
from asperity.surface.conventions import validated_fractal
from asperity.surface.fractal_fit import FractalFit
from asperity.types import Array, ArrayLike, Document

#: Name and version of the document; a reader refuses others.
SCHEMA = "asperity-surface-measurement"
SCHEMA_VERSION = 1
#: Confidence of the intervals in the document.
CONFIDENCE = 0.95


class SurfaceMeasurement(Module):
    """Measured D and G of the Weierstrass-Mandelbrot profile, equation (6), with their covariance; scalar arrays.

    ``fractal_dimension``: D [-], 1 to 2; ``fractal_roughness``: G [m]; ``frequency_ratio``: gamma [-]; ``covariance``
    of (D, ln G), shape (2, 2): they are nearly fully correlated, so both must be drawn together;
    ``shortest_wavelength`` and ``longest_wavelength``: limits of the self-affine band [m]; ``estimator`` of D and G;
    number of ``profiles`` averaged; ``source``: files measured.
    """

    fractal_dimension: Array
    fractal_roughness: Array
    frequency_ratio: Array
    covariance: Array
    shortest_wavelength: Array
    longest_wavelength: Array
    estimator: str = static()
    profiles: int = static()
    source: str = static()

    def interval(self, *, confidence: float) -> dict[str, tuple[float, float]]:
        """Confidence intervals of D [-] and G [m], from the normal law of (D, ln G)."""
        reach = NormalDist().inv_cdf(0.5 + 0.5 * confidence) * np.sqrt(np.diag(np.asarray(self.covariance)))
        D, log_G = float(self.fractal_dimension), math.log(float(self.fractal_roughness))
        return {
            "fractal_dimension": (D - float(reach[0]), D + float(reach[0])),
            "fractal_roughness": (math.exp(log_G - float(reach[1])), math.exp(log_G + float(reach[1]))),
        }


def surface_measurement(*, fit: FractalFit, source: str) -> SurfaceMeasurement:
    """The measurement that corresponds to a fit."""
    numbers = (fit.fractal_dimension, fit.fractal_roughness, fit.frequency_ratio, fit.covariance)
    band = (fit.shortest_wavelength, fit.longest_wavelength)
    return measured(*numbers, *band, estimator=fit.estimator, profiles=fit.profiles, source=source)


def measured(*numbers: ArrayLike, estimator: str, profiles: int, source: str) -> SurfaceMeasurement:
    """A measurement of its numbers, in the order of its fields."""
    given: list[Any] = [np.asarray(number, dtype=float) for number in numbers]
    D, G, gamma, covariance, short, long = given
    return SurfaceMeasurement(D, G, gamma, covariance, short, long, estimator, profiles, source)


def measurement_document(*, measurement: SurfaceMeasurement) -> Document:
    """The measurement as plain numbers and text for JSON, units in the names."""
    interval = measurement.interval(confidence=CONFIDENCE)
    return {
        "schema": SCHEMA,
        "schema_version": SCHEMA_VERSION,
        "source": measurement.source,
        "fractal_dimension": float(measurement.fractal_dimension),
        "fractal_dimension_interval_95": list(interval["fractal_dimension"]),
        "fractal_roughness_m": float(measurement.fractal_roughness),
        "fractal_roughness_interval_95_m": list(interval["fractal_roughness"]),
        "frequency_ratio": float(measurement.frequency_ratio),
        "covariance_of_dimension_and_log_roughness": np.asarray(measurement.covariance).tolist(),
        "shortest_wavelength_m": float(measurement.shortest_wavelength),
        "longest_wavelength_m": float(measurement.longest_wavelength),
        "estimator": measurement.estimator,
        "profiles": measurement.profiles,
    }


def refuse_other_documents(document: Any) -> None:
    """Raise unless this is a measurement of this version, not one of an earlier release that was refused."""
    if not isinstance(document, dict) or document.get("schema") != SCHEMA:
        raise InputError(f"this is not a surface measurement: its key 'schema' must be '{SCHEMA}'")
    if document.get("schema_version") != SCHEMA_VERSION:
        raise InputError(
            f"the measurement has schema version {_brief(document.get('schema_version'))}; this release reads "
            f"version {SCHEMA_VERSION}: measure again"
        )
    if "refused" in document:
        raise InputError(
            f"the measurement of {document.get('source', 'this surface')} was refused by an earlier release: measure "
            f"again; {document['refused']}"
        )


def measurement_from_document(*, document: Any) -> SurfaceMeasurement:
    """D and G from a document of this kind and version that has them."""
    refuse_other_documents(document)
    if "no_power_law" in document:
        raise InputError(
            f"the measurement of {document.get('source', 'this surface')} has no D and G: {document['no_power_law']}"
        )
    D, G = _number(document, "fractal_dimension"), _number(document, "fractal_roughness_m")
    gamma = _number(document, "frequency_ratio")
    short, long = _number(document, "shortest_wavelength_m"), _number(document, "longest_wavelength_m")
    profiles = _number(document, "profiles")
    covariance = _covariance(document)
    words = []
    for key in ("estimator", "source"):
        if not isinstance(document.get(key, ""), str) or (key == "estimator" and key not in document):
            raise InputError(f"the measurement has no text for the key '{key}'")
        words.append(document.get(key, ""))
    if not (profiles >= 1.0 and profiles == int(profiles)):
        raise InputError(f"the measurement has {profiles:g} profiles; a whole number of at least 1 is needed")
    validated_fractal(fractal_dimension=D, fractal_roughness=G)
    if G > 1.0:
        raise InputError(f"the measurement has G = {G:g} m; that of a surface is below 1 m")
    if not (gamma > 1.0 and 0.0 < short < long):
        raise InputError(
            f"the measurement has gamma = {gamma:g} and the band {short:g} m to {long:g} m; gamma must be above "
            "1, and the shortest wavelength positive and below the longest"
        )
    numbers = (D, G, gamma, covariance, short, long)
    return measured(*numbers, estimator=words[0], profiles=int(profiles), source=words[1])


def _number(document: Document, key: str) -> float:
    """A finite number of a document."""
    if key not in document:
        raise InputError(f"the measurement has no key '{key}'")
    value = document[key]
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) <= sys.float_info.max:
        raise InputError(f"the key '{key}' of the measurement must be a finite number, not {_brief(value)}")
    return float(value)


def _covariance(document: Document) -> NDArray[np.float64]:
    """The covariance of a document, two by two, symmetric and not negative."""
    key = "covariance_of_dimension_and_log_roughness"
    if key not in document:
        raise InputError(f"the measurement has no key '{key}'")
    rows = document[key]
    flat = [x for row in rows for x in row] if _two(rows) and all(_two(row) for row in rows) else []
    numbers = [x for x in flat if isinstance(x, int | float) and not isinstance(x, bool)]
    if len(numbers) == 4 and all(abs(x) < 1e5 for x in numbers):
        (a, b), (c, d) = rows
        if a >= 0.0 and d >= 0.0 and abs(b - c) <= 1e-6 * abs(b) and b * c <= a * d * (1.0 + 1e-9):
            return np.array([[a, b], [c, d]], dtype=np.float64)
    raise InputError(
        f"the covariance of (D, ln G) of the measurement must be two by two, symmetric and not negative, "
        f"not {_brief(rows)}"
    )


def _two(value: Any) -> bool:
    return isinstance(value, list) and len(value) == 2


def _brief(value: Any) -> str:
    """A value of a document for a message: short, whatever it is."""
    if isinstance(value, list | dict):
        return "a list" if isinstance(value, list) else "a table"
    text = repr(value)
    return text if len(text) <= 40 else text[:37] + "..."


def read_measurement_document(*, path: str | Path) -> Any:
    """The JSON document of a file, which may be any."""
    try:
        return read_json(path)
    except InputError as error:
        raise InputError(
            f"{error}; expected is the JSON document of a measured surface, as 'asperity surface measure' prints it"
        ) from None


def read_measurement(*, path: str | Path) -> SurfaceMeasurement:
    """D and G from a JSON file written by ``asperity surface measure --json``.

    An ``InputError`` if the file cannot be read or is not such a document, or has no D and G.
    """
    document = read_measurement_document(path=path)
    try:
        return measurement_from_document(document=document)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
