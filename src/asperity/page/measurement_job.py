"""The measurement of a surface that the page runs as a job."""

from __future__ import annotations

import contextlib
from dataclasses import replace

from asperity.page.job_process import Report
from asperity.surface.height_spectrum import with_lay
from asperity.surface.measure_files import files_document, measured_files
from asperity.surface.measured_roughness import measurement_of, read_roughness, roughness_document
from asperity.types import Document

#: Address space of a measurement [byte]: a file that unpacks into more ends with an error.
MOST_MEMORY = 8 * 1024**3


def measure(file: str, options: Document, report: Report) -> Document:
    """The document of a measured surface, from an instrument's file or from a document that the page was given."""
    lay, of = options.get("lay"), options.get("measurement_of")
    if options.get("document"):
        roughness = measurement_of(read_roughness(path=file), of)
        spectra = (one if one.is_map or one.lay else with_lay(one, lay) for one in roughness.spectra)
        return roughness_document(replace(roughness, spectra=tuple(spectra)))
    with contextlib.suppress(ImportError, ValueError, OSError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    left_out = ("start", "stop", "form", "degree", "outlier_threshold", "short_cutoff", "long_cutoff")
    measured = measured_files(
        [file],
        position_unit=options.get("position_unit"),
        height_unit=options.get("height_unit"),
        spacing=options.get("spacing"),
        decimal=options.get("decimal") or "auto",
        column=options.get("column"),
        no_data=options.get("no_data"),
        any_size=False,
        missing=options.get("missing", "refuse"),
        direction=options.get("direction", "x"),
        lay=lay,
        estimator="automatic",
        frequency_ratio=1.5,
        shortest_wavelength=None,
        longest_wavelength=None,
        **dict.fromkeys(left_out),
    )
    return files_document(measured) | {"measurement_of": measurement_of(measured.roughness, of).of}
