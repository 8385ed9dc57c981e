"""``asperity report``: one document about a joint for a design review."""

from __future__ import annotations

import click

from asperity.cli.terminal import (
    about,
    check_title,
    prepare_computation,
    refuse_lonely_measurement_of,
    say_written,
    surface_option,
    title_options,
)
from asperity.errors import InputError


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
    measurement_of: str | None,
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
    from asperity.api.documents import check_report
    from asperity.joint_file.reader import read_case

    check_report(out, file, *surfaces, *([design_file] if design_file else []))
    check_title(stated)
    refuse_lonely_measurement_of(surfaces, measurement_of)
    if distribution is not None and not tolerances:
        raise InputError("--distribution belongs to --tolerances")
    case = read_case(file, measured=not surfaces)
    prepare_computation()
    from asperity.api.documents import write_report
    from asperity.api.joint import DescribedJoint
    from asperity.cli.terminal import progress_bar

    with about(file, *surfaces, design_file):
        write_report(
            DescribedJoint(case, file),
            out,
            surfaces=surfaces,
            measurement_of=measurement_of,
            sensitivity=sensitivity,
            tolerances=tolerances,
            distribution=distribution,
            design=design_file,
            title=stated,
            progress=progress_bar,
        )
    say_written(out)
