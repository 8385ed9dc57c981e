"""What a measurement tells of a surface: its waves, and D and G where it has a power law; from and to its document."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from asperity.errors import InputError, NoSolutionError
from asperity.surface.equivalent import equivalent_surface
from asperity.surface.height_spectrum import HeightSpectrum, spectrum_from_document
from asperity.surface.measurement import (
    SCHEMA,
    SCHEMA_VERSION,
    SurfaceMeasurement,
    measurement_document,
    measurement_from_document,
    read_measurement_document,
    refuse_other_documents,
)


@dataclass(frozen=True)
class MeasuredRoughness:
    """A measured surface, or two that meet.

    Attributes
    ----------
    fractal : SurfaceMeasurement or None
        D and G of both together; None without a power law.
    no_power_law : str
        Why there is none; empty where there is one.
    spectra : tuple of HeightSpectrum
        Of each body; empty in documents of earlier releases.
    source : str
        Files measured.
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

    Raises
    ------
    InputError
        If this is no such document, or one of an earlier release that was refused.
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

    Raises
    ------
    InputError
        If the file cannot be read or is not such a document.
    """
    document = read_measurement_document(path=path)
    try:
        return roughness_from_document(document)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def two_bodies(first: MeasuredRoughness, second: MeasuredRoughness) -> MeasuredRoughness:
    """Two measured surfaces that meet: the mean squares of their waves add, and their structure functions.

    Parameters
    ----------
    first, second : MeasuredRoughness
        The two bodies.

    Returns
    -------
    MeasuredRoughness
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
