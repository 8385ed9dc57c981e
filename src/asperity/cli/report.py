"""``asperity report``: one document about a joint for a design review."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from asperity.cli.terminal import (
    about,
    prepare_computation,
    say_written,
    surface_option,
    title_of,
    title_options,
)
from asperity.errors import InputError
from asperity.writing import check_file, replacing, write_text

if TYPE_CHECKING:
    from asperity.joint_file.si_tables import AnyCase
    from asperity.report.study_sections import ReportStudies


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--out",
    default="report.html",
    show_default=True,
    type=click.Path(dir_okay=False),
    help="Write the report to this file: .html or .pdf.",
)
@surface_option
@click.option("--sensitivity", is_flag=True, help="Add how much every number of the file moves the results.")
@click.option(
    "--tolerances",
    is_flag=True,
    help="Add intervals of the results from the tolerances that the file states.",
)
@click.option(
    "--distribution",
    metavar="TEXT",
    help="For tolerances whose distribution the file does not state, as for 'asperity uncertainty'.",
)
@click.option(
    "--design",
    "design_file",
    type=click.Path(),
    metavar="DESIGN",
    help="Add the design of this joint that the design file DESIGN asks for: before and after, with its limits.",
)
@title_options
def report(
    file: str,
    out: str,
    surfaces: tuple[str, ...],
    sensitivity: bool,
    tolerances: bool,
    distribution: str | None,
    design_file: str | None,
    **stated: str,
) -> None:
    """Write one document about the joint described in FILE: inputs, drawing, results, margins and warnings.

    The report contains everything that a design review asks for, and the joint file itself, from which it can be
    made again. The same input gives the same report, byte for byte. HTML is one file without scripts; PDF needs the
    optional package typst.
    """
    from asperity.joint_file.reader import parse_case
    from asperity.reading import read_text

    suffix = Path(out).suffix.lower()
    if suffix not in (".html", ".pdf"):
        raise InputError(f"{out}: the name of a report must end in .html or .pdf")
    title = title_of(stated)
    check_file(out, file, *surfaces, *([design_file] if design_file else []))
    if suffix == ".pdf":
        from asperity.report.pdf import require_typst

        require_typst()
    text = read_text(file, hint="'asperity init' writes an example")
    case = parse_case(text, source=file, folder=Path(file).parent)
    prepare_computation()
    from asperity.cli.terminal import progress_bar
    from asperity.report.joint_report import ReportSource, joint_report

    if distribution is not None and not tolerances:
        raise InputError("--distribution belongs to --tolerances")
    measured = None
    texts: tuple[str, ...] = ()
    if surfaces:
        from asperity.joint.measured_surface import measured_surface
        from asperity.joint_file.measured_surface import case_with_surface

        texts = tuple(read_text(path) for path in surfaces)
        with about(file):
            measured = case_with_surface(case, measured_surface(surfaces))
        case = measured.case
    source = ReportSource(
        name=Path(file).name,
        text=text,
        case=case,
        measurement=measured,
        measurement_texts=texts,
        title=title,
        studies=_studies(file, case, sensitivity, tolerances, distribution, design_file),
    )
    with progress_bar("the report") as done, about(file):
        done(0, 2)
        made = joint_report(source)
        done(2, 2)
    if suffix == ".pdf":
        from asperity.report.pdf import report_pdf

        content = report_pdf(made)
        with replacing(out) as part:
            part.write_bytes(content)
    else:
        from asperity.report.html import report_html

        write_text(report_html(made), out)
    say_written(out)


def _studies(
    file: str,
    case: AnyCase,
    sensitivity: bool,
    tolerances: bool,
    distribution: str | None,
    design_file: str | None,
) -> ReportStudies:
    """Make the studies that a report is to show."""
    from asperity.cli.terminal import about, progress_bar
    from asperity.joint_file.quantity_key import parse_distribution
    from asperity.reading import read_text
    from asperity.report.study_sections import STUDIED, ReportStudies

    sensitivities = spread = designed = None
    options = []
    otherwise = None if distribution is None else parse_distribution(distribution)
    if tolerances:
        from asperity.study.tolerances.uncertainty import toleranced_inputs

        with about(file):
            toleranced_inputs(case, otherwise=otherwise)  # refuses before anything long begins
    problem = None
    if design_file is not None:
        from asperity.study.design.design_file import read_design

        problem = read_design(design_file)
        if len(problem.objectives) > 1:
            raise InputError(
                f"{design_file}: a report shows one design, and a Pareto front has many; state one objective"
            )
        if problem.case != case:
            raise InputError(
                f"{design_file}: it designs {problem.joint_file}, which is not the joint of this report, {file}"
            )
    if sensitivity:
        from asperity.study.tolerances.sensitivity import sensitivity as differentiate

        with progress_bar("sensitivities") as done, about(file):
            done(0, 1)
            sensitivities = differentiate(case, STUDIED)
            done(1, 1)
        options.append("--sensitivity")
    if tolerances:
        from asperity.study.tolerances.uncertainty import uncertainty

        with progress_bar("samples") as done, about(file):
            spread = uncertainty(case, results=STUDIED, distribution=otherwise, report=done)
        options += ["--tolerances", *([f"--distribution '{distribution}'"] if distribution else [])]
    if problem is not None:
        from asperity.study.design.design import design

        with progress_bar("searches") as done:
            designed = design(problem, progress=done)
        options.append(f"--design {Path(design_file or '').name}")
    return ReportStudies(
        sensitivities,
        spread,
        designed,
        design_name=Path(design_file or "").name,
        design_text=read_text(design_file) if design_file else "",
        options=tuple(options),
    )
