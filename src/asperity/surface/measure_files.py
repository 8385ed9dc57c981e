"""From files to a measurement: reading, the whole way of ``asperity surface measure``, and its document."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from asperity.errors import InputError
from asperity.surface.file_formats import (
    LARGEST_SPAN,
    MEBIBYTE,
    checked_file,
    file_bytes,
    file_format,
    signed_format,
)
from asperity.surface.fractal_fit import FractalFit
from asperity.surface.height_spectrum import (
    FEWEST_POINTS,
    HeightSpectrum,
    Lay,
    spectrum_of_map,
    spectrum_of_profiles,
)
from asperity.surface.levelling import default_form
from asperity.surface.measure import (
    Conditioning,
    DirectionalFits,
    MeasuredSurface,
    conditioned,
    directional_fits,
    pooled_profiles,
)
from asperity.surface.measured_roughness import MeasuredRoughness, roughness_document
from asperity.surface.measurement import surface_measurement
from asperity.surface.read_instrument import instrument_topography, nanofocus_topography, tiff_topography
from asperity.surface.read_numpy import numpy_topography
from asperity.surface.read_records import in_records, record_topography
from asperity.surface.read_text import text_topography
from asperity.surface.read_x3p import x3p_topography
from asperity.surface.stated import Stated, with_its_sizes
from asperity.surface.suspicious_heights import disagreement, end_notes, refuse_missing_marks
from asperity.surface.topography import Topography
from asperity.text_table.decoding import looks_like_text, refuse_unmarked_utf_16
from asperity.types import Document

#: Larger files are refused before they are opened [bytes].
LARGEST_FILE = 4096 * MEBIBYTE
#: A surface is expected to be longer and wider than the first and not larger than the second length [m].
EXPECTED_SIZES = (1e-6, 1.0)


@dataclass(frozen=True)
class MeasuredFiles:
    """Files that were measured together: the conditioned surface of each, and D and G along x and, of a map, along y.

    ``direction``, "x" or "y", is the one that counts as the result, in which the contact rolls; ``spectrum`` are the
    waves, None of fewer than sixteen points.
    """

    surfaces: tuple[MeasuredSurface, ...]
    fits: DirectionalFits
    direction: str
    spectrum: HeightSpectrum | None

    @property
    def fit(self) -> FractalFit | str:
        """The result, or the reason why there is none."""
        chosen = self.fits.along_y if self.direction == "y" else self.fits.along_x
        assert chosen is not None
        return chosen

    @property
    def topographies(self) -> list[Topography]:
        """The conditioned surfaces without their height parameters."""
        return [surface.topography for surface in self.surfaces]

    @property
    def roughness(self) -> MeasuredRoughness:
        """What a joint takes of the surface."""
        fit = self.fit
        measurement = None if isinstance(fit, str) else surface_measurement(fit=fit, source=self.source)
        return MeasuredRoughness(
            measurement,
            fit if isinstance(fit, str) else "",
            () if self.spectrum is None else (self.spectrum,),
            self.source,
        )

    @property
    def source(self) -> str:
        """Names of the files."""
        return " + ".join(topography.source for topography in self.topographies)


def measured_files(
    files: Sequence[str | Path],
    *,
    position_unit: str | None,
    height_unit: str | None,
    spacing: float | None,
    decimal: str,
    column: str | None,
    no_data: str | None,
    any_size: bool,
    start: float | None,
    stop: float | None,
    form: str | None,
    degree: int | None,
    missing: str,
    outlier_threshold: float | None,
    short_cutoff: float | None,
    long_cutoff: float | None,
    direction: str,
    lay: Lay | None,
    estimator: str,
    frequency_ratio: float,
    shortest_wavelength: float | None,
    longest_wavelength: float | None,
) -> MeasuredFiles:
    """Read files of one surface, several profiles or one map, condition them, and fit D and G to all of them.

    The spectra of profiles are averaged. The keys of reading are those of :func:`read_surface`, those of conditioning
    of :class:`asperity.surface.measure.Conditioning`, those of the fit of
    :func:`asperity.surface.measure.directional_fits`. ``start`` and ``stop``: section of a profile [m], None for its
    ends; ``form`` to remove, None for the line of a profile and the plane of a map; ``direction`` in a map that counts
    as the result, in which the contact rolls; ``lay`` of profiles: the direction of the grooves, which they cross, None
    if it is not known. A missing power law is a reason in place of a fit.

    An ``InputError`` if a file cannot be read, a step is impossible, or the files cannot be averaged; a
    ``MissingExtraError`` if the format of a file needs a package that is not installed.
    """
    surfaces = []
    for file in files:
        topography = read_surface(
            path=file,
            position_unit=position_unit,
            height_unit=height_unit,
            spacing=spacing,
            decimal=decimal,
            column=column,
            no_data=no_data,
            any_size=any_size,
        )
        if start is not None or stop is not None:
            topography = topography.cut(
                start=0.0 if start is None else start, stop=topography.size[0] if stop is None else stop
            )
        conditioning = Conditioning(
            form=form or default_form(topography),
            degree=degree,
            missing=missing,
            outlier_threshold=outlier_threshold,
            short_cutoff=short_cutoff,
            long_cutoff=long_cutoff,
        )
        surfaces.append(conditioned(topography=topography, conditioning=conditioning))
    if direction == "y" and not surfaces[0].topography.is_map:
        raise InputError("a profile has no direction y; leave the direction out")
    if lay is not None and surfaces[0].topography.is_map:
        raise InputError(
            "a map shows its lay; leave it out, and give the direction in which the contact rolls"
        )
    if len(surfaces) > 1:
        pooled_profiles(surfaces=[surface.topography for surface in surfaces], direction="x")  # or refused
        apart = disagreement([surface.topography for surface in surfaces])
        first = surfaces[0].topography
        surfaces[0] = replace(surfaces[0], topography=first.with_heights(first.heights, apart))
    fits = directional_fits(
        surfaces=surfaces,
        estimator=estimator,
        frequency_ratio=frequency_ratio,
        shortest_wavelength=shortest_wavelength,
        longest_wavelength=longest_wavelength,
    )
    return MeasuredFiles(tuple(surfaces), fits, direction, _spectrum(surfaces, direction, lay))


def _spectrum(surfaces: list[MeasuredSurface], direction: str, lay: Lay | None) -> HeightSpectrum | None:
    """The waves of the surfaces; None of surfaces of few points."""
    topographies = [surface.topography for surface in surfaces]
    if min(min(topography.heights.shape) for topography in topographies) < FEWEST_POINTS:
        return None
    if topographies[0].is_map:
        return spectrum_of_map(topography=topographies[0], rolling=direction)
    profiles, spacing, _ = pooled_profiles(surfaces=topographies, direction="x")
    source = " + ".join(topography.source for topography in topographies)
    return spectrum_of_profiles(profiles=profiles, spacing=spacing, lay=lay, source=source)


def files_document(measured: MeasuredFiles) -> Document:
    """D, G and their covariance, how they were found, and height parameters of files, in SI units, ready for JSON.

    ``no_power_law`` holds the reason where there is no D and G.
    """
    fit, document = measured.fit, roughness_document(measured.roughness)
    if not isinstance(fit, str):
        document["noise_density_m3"] = fit.noise_density
        document["height_step_m"] = fit.height_step
        document["misfit"] = fit.misfit
        document["reduced_chi_square"] = fit.reduced_chi_square
        document["roll_off_wavelength_m"] = fit.roll_off_wavelength
    document["direction"] = measured.direction
    document["anisotropy_ratio"] = measured.fits.anisotropy_ratio
    document["files"] = [_file_entry(surface) for surface in measured.surfaces]
    return document


def _file_entry(surface: MeasuredSurface) -> Document:
    topography, heights = surface.topography, surface.heights
    letter, total = ("S", "Sz") if topography.is_map else ("P", "Pt")
    entry = {
        "name": topography.source,
        "size_m": list(topography.size),
        "points": heights.points,
        "notes": list(topography.notes),
        f"{letter}a_m": heights.arithmetic_mean,
        f"{letter}q_m": heights.root_mean_square,
        f"{letter}sk": _finite(heights.skewness),
        f"{letter}ku": _finite(heights.kurtosis),
        f"{total}_m": heights.total_height,
    }
    if topography.is_map:
        return entry | {
            "scale_limited": surface.scale_limited,
            "cut_off_m": surface.filters[1],
            "short_cut_off_m": surface.filters[0],
            "Sdr": heights.developed_area_ratio,
            "Sal_m": heights.correlation_length,
            "Str": heights.aspect_ratio,
        }
    rough, crown = surface.roughness, surface.crown
    entry["PSm_m"] = heights.mean_element_width
    if isinstance(rough, str):
        entry["no_roughness"] = rough
    elif rough is not None:
        entry["roughness"] = {
            "cut_off_m": rough.cut_off,
            "short_cut_off_m": rough.short_cut_off,
            "sections": rough.sections,
            **{f"{symbol}_m": value for symbol, value in rough.lengths.items()},
            **{symbol: _finite(value) for symbol, value in rough.numbers.items()},
        }
    if crown is not None:
        radii = {"radius_m": crown.radius, "middle_radius_m": crown.middle_radius}
        entry["crown"] = {
            **{name: radius if math.isfinite(radius) else None for name, radius in radii.items()},
            "drop_m": crown.drop,
            "misfit_m": crown.misfit,
            "is_circular": crown.stands_out,
        }
        shape = surface.logarithmic
        entry["logarithmic_profile"] = shape and {
            "coefficient_m": shape.coefficient,
            "length_m": shape.length,
            "misfit_m": shape.misfit,
            "stands_out": shape.stands_out(crown),
        }
    return entry


def _finite(value: float) -> float | None:
    return value if value == value else None


def read_surface(
    *,
    path: str | Path,
    position_unit: str | None = None,
    height_unit: str | None = None,
    spacing: float | None = None,
    decimal: str = "auto",
    column: str | None = None,
    no_data: str | None = None,
    any_size: bool = False,
) -> Topography:
    """Profile or map from any supported file, heights and positions in metres; missing points are NaN and counted.

    The formats are those of :data:`asperity.surface.file_formats.FORMATS`; those of reader ``package`` need the extra
    ``surface``. What is stated is that of :class:`asperity.surface.stated.Stated`, needed only where the file does not
    say it, and refused where it contradicts the file. ``any_size`` accepts sizes outside :data:`EXPECTED_SIZES`, and
    heights larger than the longest side. Nothing is filled, levelled or filtered.
    """
    stated = Stated(position_unit, height_unit, spacing, decimal, column, no_data)
    path = checked_file(path=path, largest=LARGEST_FILE)
    beginning = file_bytes(path=path, largest=LARGEST_FILE, first=4096)
    topography = _read(path, beginning, stated)
    if np.isnan(topography.heights).all():
        raise InputError(
            f"{path.name} holds no valid height: all {topography.heights.size} points are missing"
        )
    if topography.heights.shape[-1] < 2:
        raise InputError(f"{path.name} holds {topography.heights.size} point(s); a profile needs more")
    if not stated.all_are_heights:
        refuse_missing_marks(topography)
    _check_plausibility(topography, any_size)
    return replace(topography, notes=(*topography.notes, *end_notes(topography)))


def _read(path: Path, beginning: bytes, stated: Stated) -> Topography:
    """The surface as its file has it."""
    if in_records(beginning):
        return with_its_sizes(record_topography(path=path), stated, path, "in records")
    if looks_like_text(beginning) and signed_format(beginning) is None:
        return text_topography(path=path, stated=stated)
    refuse_unmarked_utf_16(beginning, source=path.name)
    known = file_format(path, beginning)
    if known.reader == "npy":
        return numpy_topography(path=path, stated=stated)
    if known.reader == "tiff":
        image = tiff_topography(path=path, height_unit=stated.height_unit, spacing=stated.spacing)
        if image is not None:
            return image
    if known.reader in ("x3p", "nanofocus"):
        topography = x3p_topography(path=path) if known.reader == "x3p" else nanofocus_topography(path=path)
        return with_its_sizes(topography, stated, path, known.name)
    topography = instrument_topography(
        path=path, beginning=beginning, known=known, height_unit=stated.height_unit
    )
    position, height = stated.position_unit, stated.height_unit
    if known.stated and position is not None and stated.metres("position") != stated.metres("height"):
        raise InputError(
            f"{path.name} ({known.name}) has one unit of its lengths and heights: {height} is stated, and {position} "
            "for the positions; leave that out",
            options=["position-unit"],
        )
    as_stated = replace(stated, height_unit=None, position_unit=None if known.stated else position)
    return with_its_sizes(topography, as_stated, path, known.name)


def _check_plausibility(topography: Topography, any_size: bool) -> None:
    """Refuse sizes that a wrong unit explains better than a measured surface."""
    smallest, largest = EXPECTED_SIZES
    known = topography.heights[~np.isnan(topography.heights)]
    with np.errstate(over="ignore"):
        height = float(known.max() - known.min())
    if not height < LARGEST_SPAN:
        raise InputError(f"{topography.source}: its heights span {height:.3g} m, which cannot be evaluated")
    if any_size:
        return
    sizes = " x ".join(f"{size:.4g} m" for size in topography.size)
    if not all(smallest <= size <= largest for size in topography.size):
        fault = f"its size is {sizes}; expected are {smallest:g} m to {largest:g} m"
    elif height > max(topography.size):
        fault = f"its heights span {height:.4g} m on a size of {sizes}; expected is less than the size"
    else:
        return
    raise InputError(
        f"{topography.source}: {fault}. A unit is probably wrong, in the options, in the file or in its "
        "reader. If these sizes are right, allow any size",
        options=["any-size"],
    )
