"""A report as a PDF, set by typst from the fonts that come with matplotlib."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

from asperity.extras import optional_module
from asperity.report.content import Picture, Report
from asperity.report.typst_source import typst_source

if TYPE_CHECKING:
    import types


def require_typst() -> types.ModuleType:
    """The package typst.

    Returns
    -------
    module
        Imported.

    Raises
    ------
    MissingExtraError
        If it is not installed.
    """
    html = "a report with the ending .html needs no package"
    return optional_module("typst", extra="report", needs="a PDF needs", otherwise=html)


def report_pdf(report: Report) -> bytes:
    """Write a report as PDF.

    Parameters
    ----------
    report : Report
        The report.

    Returns
    -------
    bytes
        A PDF file; the same for the same report. No font of the system and nothing from the network is used.

    Raises
    ------
    MissingExtraError
        If typst is not installed.
    """
    import matplotlib

    typst = require_typst()
    pictures = [block.svg for block in report.blocks if isinstance(block, Picture)]
    names = [f"picture-{number}.svg" for number in range(len(pictures))]
    with tempfile.TemporaryDirectory(prefix="asperity-report-") as folder:
        for name, svg in zip(names, pictures, strict=True):
            Path(folder, name).write_text(svg, encoding="utf-8")
        source = Path(folder, "report.typ")
        source.write_text(typst_source(report, pictures=names), encoding="utf-8")
        made: bytes = typst.compile(
            str(source),
            root=folder,
            format="pdf",
            font_paths=[str(Path(matplotlib.get_data_path(), "fonts", "ttf"))],
            ignore_system_fonts=True,
        )
    return made
