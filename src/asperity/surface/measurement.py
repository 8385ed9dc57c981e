"""The measurement document: D, G and their uncertainty as JSON in SI units, written and read back."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float
from scipy.stats import norm

from asperity.errors import InputError
from asperity.reading import read_json
from asperity.surface.conventions import validated_fractal
from asperity.surface.fractal_fit import FractalFit

#: Name and version of the document; a reader refuses others.
SCHEMA = "asperity-surface-measurement"
SCHEMA_VERSION = 1
#: Confidence of the intervals in the document.
CONFIDENCE = 0.95


class SurfaceMeasurement(eqx.Module):
    """Measured D and G of the Weierstrass-Mandelbrot profile, equation (6), with their covariance.

    Attributes
    ----------
    fractal_dimension : scalar array
        D [-], 1 to 2.
    fractal_roughness : scalar array
        G [m].
    frequency_ratio : scalar array
        gamma [-].
    covariance : array, shape (2, 2)
        Of (D, ln G); D and ln G are nearly fully correlated, so both must be drawn together.
    shortest_wavelength, longest_wavelength : scalar array
        Limits of the self-affine band [m].
    estimator : str
        How D and G were estimated.
    profiles : int
        Number of profiles averaged.
    source : str
        Files measured.
    """

    fractal_dimension: Float[Array, ""]
    fractal_roughness: Float[Array, ""]
    frequency_ratio: Float[Array, ""]
    covariance: Float[Array, "2 2"]
    shortest_wavelength: Float[Array, ""]
    longest_wavelength: Float[Array, ""]
    estimator: str = eqx.field(static=True)
    profiles: int = eqx.field(static=True)
    source: str = eqx.field(static=True)

    def interval(self, *, confidence: float) -> dict[str, tuple[float, float]]:
        """Confidence intervals of D [-] and G [m], from the normal law of (D, ln G)."""
        reach = float(norm.ppf(0.5 + 0.5 * confidence)) * np.sqrt(np.diag(np.asarray(self.covariance)))
        D, log_G = float(self.fractal_dimension), math.log(float(self.fractal_roughness))
        return {
            "fractal_dimension": (D - float(reach[0]), D + float(reach[0])),
            "fractal_roughness": (math.exp(log_G - float(reach[1])), math.exp(log_G + float(reach[1]))),
        }


def surface_measurement(*, fit: FractalFit, source: str) -> SurfaceMeasurement:
    """The measurement that a fit amounts to."""
    return SurfaceMeasurement(
        fractal_dimension=jnp.asarray(fit.fractal_dimension, dtype=jnp.float64),
        fractal_roughness=jnp.asarray(fit.fractal_roughness, dtype=jnp.float64),
        frequency_ratio=jnp.asarray(fit.frequency_ratio, dtype=jnp.float64),
        covariance=jnp.asarray(fit.covariance, dtype=jnp.float64),
        shortest_wavelength=jnp.asarray(fit.shortest_wavelength, dtype=jnp.float64),
        longest_wavelength=jnp.asarray(fit.longest_wavelength, dtype=jnp.float64),
        estimator=fit.estimator,
        profiles=fit.profiles,
        source=source,
    )


def measurement_document(*, measurement: SurfaceMeasurement) -> dict[str, Any]:
    """The measurement as plain numbers and words, units in the names, ready for JSON."""
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


def measurement_from_document(*, document: Any) -> SurfaceMeasurement:
    """Measurement from such a document.

    Raises
    ------
    InputError
        If the document is of another kind or version, was refused, misses a key or holds an impossible value.
    """
    if not isinstance(document, dict) or document.get("schema") != SCHEMA:
        raise InputError(f"this is not a surface measurement: its key 'schema' must be '{SCHEMA}'")
    if document.get("schema_version") != SCHEMA_VERSION:
        raise InputError(
            f"the measurement has schema version {document.get('schema_version')}; this release "
            f"reads version "
            f"{SCHEMA_VERSION}: measure again"
        )
    if "refused" in document:
        raise InputError(
            f"the measurement of {document.get('source', 'this surface')} was refused: {document['refused']}"
        )
    try:
        D, G = float(document["fractal_dimension"]), float(document["fractal_roughness_m"])
        covariance = np.asarray(document["covariance_of_dimension_and_log_roughness"], dtype=np.float64)
        gamma = float(document["frequency_ratio"])
        short, long = float(document["shortest_wavelength_m"]), float(document["longest_wavelength_m"])
        words = str(document["estimator"]), int(document["profiles"]), str(document.get("source", ""))
    except KeyError as error:
        raise InputError(f"the measurement has no key {error}") from None
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"the measurement holds a value that is not a number ({error})") from None
    validated_fractal(fractal_dimension=D, fractal_roughness=G)
    if (
        covariance.shape != (2, 2)
        or not np.isfinite(covariance).all()
        or np.linalg.eigvalsh(covariance).min() < (-1e-9 * np.trace(covariance))
    ):
        raise InputError("the covariance of (D, ln G) must be two by two and not negative")
    if not gamma > 1.0 or not 0.0 < short < long:
        raise InputError(
            f"the measurement has gamma = {gamma} and the band {short} .. {long} m; neither may be so"
        )
    return SurfaceMeasurement(
        fractal_dimension=jnp.asarray(D, dtype=jnp.float64),
        fractal_roughness=jnp.asarray(G, dtype=jnp.float64),
        frequency_ratio=jnp.asarray(gamma, dtype=jnp.float64),
        covariance=jnp.asarray(covariance, dtype=jnp.float64),
        shortest_wavelength=jnp.asarray(short, dtype=jnp.float64),
        longest_wavelength=jnp.asarray(long, dtype=jnp.float64),
        estimator=words[0],
        profiles=words[1],
        source=words[2],
    )


def read_measurement(*, path: str | Path) -> SurfaceMeasurement:
    """Measurement from a JSON file written by ``asperity surface measure --json``.

    Raises
    ------
    InputError
        If the file cannot be read or is not such a document.
    """
    try:
        document = read_json(path)
    except InputError as error:
        raise InputError(f"{error}; write it with 'asperity surface measure FILE --json'") from None
    try:
        return measurement_from_document(document=document)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
