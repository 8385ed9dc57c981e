"""``asperity dynamics``: natural frequencies and frequency response of a joint between motor and load."""

from __future__ import annotations

from typing import Any

import click

from asperity.cli.terminal import (
    about,
    json_option,
    plot_option,
    prepare_computation,
    print_json,
    save_image,
    say_written,
)
from asperity.writing import check_file, check_image, write_columns


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

    check_image(plot_file)
    check_file(csv_file, file)
    case = read_case_of_branches(file)
    from asperity.joint_file.own_branches import with_own_branches
    from asperity.joint_file.section_build import inertias_from_case

    prepare_computation()
    from asperity.results.dynamics_document import dynamics_document, response_columns
    from asperity.standing.dynamics import dynamics as solved_dynamics

    with about(file):
        inertias = inertias_from_case(case)
        joint = with_own_branches(case)
        solved = solved_dynamics(joint, inertias)
    if csv_file:
        write_columns(response_columns(solved), csv_file)
        say_written(csv_file)
    if plot_file:
        from asperity.show.dynamics_figure import dynamics_figure
        from asperity.show.style import plain_title

        save_image(dynamics_figure(solved, title=f"{plain_title(file)} between motor and load"), plot_file)
    document = dynamics_document(solved, inertias) | {"of_own_branches": (joint.unlike is not None)}
    if as_json:
        print_json(document)
        return
    _show(document, file, damped=case.dynamics is not None and case.dynamics.loss_factor is not None)


def _show(document: dict[str, Any], file: str, *, damped: bool) -> None:
    from rich.markup import escape

    from asperity.cli.document_text import number, print_wrapped
    from asperity.cli.terminal import console, show_table

    target = console()
    at = document["at_torque"]
    target.print(escape(file) + (": of its own branches" if document["of_own_branches"] else ""))
    target.print()
    quantities = [
        ("torsional stiffness at the output, assembled", "stiffness_output_Nm_per_rad", "N·m/rad"),
        ("inertia of motor and input, at the output", "input_inertia_at_output_kg_m2", "kg·m²"),
        ("inertia of load and rollers", "output_inertia_kg_m2", "kg·m²"),
        ("natural frequency, motor locked (antiresonance)", "locked_frequency_Hz", "Hz"),
        ("natural frequency, both sides free (resonance)", "free_frequency_Hz", "Hz"),
    ]
    if at["creep_damping_Nms_per_rad"] is not None:
        quantities.append(("creep: torque per speed lost", "creep_damping_Nms_per_rad", "N·m·s/rad"))
        quantities.append(("creep: corner frequency", "corner_frequency_Hz", "Hz"))
    title = f"At an output torque of {number(at['output_torque_Nm'])} N·m"
    values = ((words, f"{number(at[key])} {unit}") for words, key, unit in quantities)
    show_table(target, title, ("quantity", "value"), values)
    over = document["over_torque"]
    columns = {
        "torque N·m": "output_torque_Nm",
        "stiffness N·m/rad": "stiffness_output_Nm_per_rad",
        "motor locked Hz": "locked_frequency_Hz",
        "both free Hz": "free_frequency_Hz",
        "creep corner Hz": "corner_frequency_Hz",
    }
    rows = zip(*(map(number, over[key][::4]) for key in columns.values()), strict=True)
    show_table(target, "Over torque", columns, rows)
    said = (
        "Below the creep corner frequency a joint that turns yields like a damper, above it like its spring. "
        if at["creep_damping_Nms_per_rad"] is not None
        else "The input stands: creep does not act. "
        if at["corner_frequency_Hz"] == 0.0
        else "Creep is left out: under this torque the joint does not roll steadily, or a branch of it slips. "
    )
    if not damped:
        said += (
            "No dynamics.loss_factor: the spring loses no work, and nothing but creep limits the resonance. "
        )
    print_wrapped(target, said + "Play is not part of it.", indent=0)
