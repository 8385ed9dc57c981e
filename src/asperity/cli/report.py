"""``asperity report``: one document about a joint for a design review."""

from __future__ import annotations

from pathlib import Path

import click

from asperity.cli.terminal import say_written
from asperity.errors import InputError
from asperity.writing import check_file, replacing, write_text

_LONGEST_DATE = 40


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--out",
    default="report.html",
    show_default=True,
    type=click.Path(dir_okay=False),
    help="Write the report to this file: .html or .pdf.",
)
@click.option(
    "--surface",
    "surfaces",
    multiple=True,
    type=click.Path(),
    metavar="MEASUREMENT",
    help="Measured surface of all contacts, from 'asperity surface measure --json'; twice: one for each body.",
)
@click.option("--date", default="", help="Date for the title block; without it, the report has none.")
def report(file: str, out: str, surfaces: tuple[str, ...], date: str) -> None:
    """Write one document about the joint described in FILE: inputs, drawing, results, margins and warnings.

    The report contains everything that a design review asks for, and the joint file itself, from which it can be
    made again. The same input gives the same report, letter by letter. HTML is one file without scripts; PDF needs the
    optional package typst.
    """
    from asperity.joint_file.reader import parse_case
    from asperity.reading import read_text

    suffix = Path(out).suffix.lower()
    if suffix not in (".html", ".pdf"):
        raise InputError(f"{out}: the name of a report must end in .html or .pdf")
    if len(date) > _LONGEST_DATE:
        raise InputError(f"--date: at most {_LONGEST_DATE} characters, got {len(date)}")
    check_file(out, file, *surfaces)
    if suffix == ".pdf":
        from asperity.report.pdf import require_typst

        require_typst()
    text = read_text(file, hint="'asperity init' writes an example")
    case = parse_case(text, source=file, folder=Path(file).parent)
    from asperity.precision import use_compilation_cache, use_double_precision

    use_double_precision()
    use_compilation_cache()
    from asperity.report.joint_report import ReportSource, joint_report

    measured = None
    texts: tuple[str, ...] = ()
    if surfaces:
        from asperity.joint.measured_surface import measured_surface
        from asperity.joint_file.measured_surface import with_measured_surface

        measured = measured_surface(surfaces)
        texts = tuple(read_text(each) for each in surfaces)
        case = with_measured_surface(case, measured)
    source = ReportSource(
        name=Path(file).name, text=text, case=case, measurement=measured, measurement_texts=texts, date=date
    )
    made = joint_report(source)
    if suffix == ".pdf":
        from asperity.report.pdf import report_pdf

        content = report_pdf(made)
        with replacing(out) as part:
            part.write_bytes(content)
    else:
        from asperity.report.html import report_html

        write_text(report_html(made), out)
    say_written(out)
