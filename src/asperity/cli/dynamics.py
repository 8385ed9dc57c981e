"""``asperity dynamics``: natural frequencies and frequency response of a joint between motor and load."""

from __future__ import annotations

import click

from asperity.cli.terminal import (
    about,
    json_option,
    plot_option,
    prepare_computation,
    print_json,
    save_image,
    say_written,
    show_blocks,
)
from asperity.made_files import table_with
from asperity.writing import check_apart, check_file, check_image, write_columns

RESPONSE = table_with(
    "a frequency response",
    "frequency_Hz",
    *(
        f"{state}_{side}_{part}"
        for state in ("standing", "turning")
        for side in ("motor", "load")
        for part in ("rad_per_Nm", "phase_deg")
    ),
)


@click.command()
@click.argument("file", type=click.Path())
@plot_option("Draw the frequency response, and the natural frequencies over torque: PNG, SVG or PDF.")
@click.option(
    "--csv",
    "csv_file",
    type=click.Path(dir_okay=False),
    help="Write the frequency response to this CSV file.",
)
@json_option()
def dynamics(file: str, plot_file: str | None, csv_file: str | None, as_json: bool) -> None:
    """Natural frequencies and frequency response of the joint described in FILE, with motor and load.

    The section [dynamics] of FILE gives the inertias of motor and load. The joint is linear about its output torque.
    While it turns, creep acts as a damper in series with its spring.
    """
    from asperity.cli.terminal import read_case_of_branches

    check_apart(plot=plot_file, csv=csv_file)
    check_image(plot_file, file)
    check_file(csv_file, file, kind=RESPONSE)
    case = read_case_of_branches(file)
    prepare_computation()
    from asperity.api.joint import DescribedJoint
    from asperity.api.structure import dynamics as dynamics_of

    with about(file):
        solved = dynamics_of(DescribedJoint(case, file))
    if csv_file:
        write_columns(solved.response(), csv_file, kind=RESPONSE)
        say_written(csv_file)
    if plot_file:
        save_image(solved.plot(), plot_file)
    if as_json:
        print_json(solved.document)
        return
    show_blocks(*solved.blocks())
