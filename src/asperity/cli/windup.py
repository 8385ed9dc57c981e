"""``asperity windup``: torque–angle curve, hysteresis loop, lost motion and catalogue stiffness of a joint."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import say_written
from asperity.writing import check_file, check_image, replacing, write_image

if TYPE_CHECKING:
    from asperity.joint.windup import Windup

LEVELS = ("assembly", "series_with_bulk", "published")


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--torque",
    help="Largest output torque of the curve, with its unit, e.g. '10 N*m'; default: the file's output torque. "
    "The curve covers both directions, so the sign does not matter.",
)
@click.option(
    "--level",
    type=click.Choice(LEVELS),
    default="assembly",
    show_default=True,
    help="Level of the stiffness that is integrated.",
)
@click.option(
    "--stages",
    type=(float, float),
    default=(1.0 / 3.0, 2.0 / 3.0),
    show_default="one and two thirds",
    help="Torques at which K1 ends and K3 begins, as shares of the largest torque.",
)
@click.option("--csv", "csv_file", type=click.Path(dir_okay=False), help="Write the curves to this CSV file.")
@click.option(
    "--plot",
    "plot_file",
    type=click.Path(dir_okay=False),
    help="Draw the curves: PNG, SVG or PDF.",
)
@click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON document in SI units instead of a table."
)
def windup(
    file: str,
    torque: str | None,
    level: str,
    stages: tuple[float, float],
    csv_file: str | None,
    plot_file: str | None,
    as_json: bool,
) -> None:
    """Wind-up of the joint described in FILE: torque–angle curve, hysteresis, lost motion, K1/K2/K3, capacity.

    The output turns against the locked sun, play included. The loop runs between plus and minus the largest torque. It
    is an estimate, because the normal forces change with the torque.
    """
    from asperity.errors import InputError
    from asperity.joint_file.reader import read_case

    check_file(csv_file, file)
    check_image(plot_file)
    case = read_case(file)
    from asperity.precision import use_compilation_cache, use_double_precision
    from asperity.units import Dimension, parse_quantity

    try:
        asked = None if torque is None else parse_quantity(torque, Dimension.TORQUE)
    except InputError as error:
        raise InputError(f"--torque: {error}") from None
    first, second = stages
    if not 0.0 < first < second < 1.0:
        raise InputError(f"--stages {first:g} {second:g}: allowed are two shares with 0 < first < second < 1")
    use_double_precision()
    use_compilation_cache()
    from asperity.joint.windup_document import examined_windup, windup_document
    from asperity.joint_file.build import joint_from_case

    source = "load.output_torque" if asked is None else "--torque"
    try:
        curve, solutions = examined_windup(
            joint_from_case(case),
            largest_torque=asked,
            level=level,  # type: ignore[arg-type]
            stage_shares=stages,
        )
    except InputError as error:
        raise InputError(f"{source}: {error}" if "torque" in str(error) else str(error)) from None
    document = windup_document(curve, solutions, level=level)  # type: ignore[arg-type]
    if csv_file:
        _write_csv(curve, csv_file)
        say_written(csv_file)
    if plot_file:
        from asperity.show.style import plain_title
        from asperity.show.windup_figure import windup_figure

        write_image(
            windup_figure(curve, title=f"Wind-up of {plain_title(file)}, {level} stiffness"), plot_file
        )
        say_written(plot_file)
    if as_json:
        import json

        click.echo(json.dumps(document, indent=2, allow_nan=False))
        return
    _show(document, file)


def _write_csv(curve: Windup, path: str) -> None:
    """The loading curves and both branches of the loop at the same torques; units in the column names."""
    import csv

    import numpy as np

    from asperity.joint.windup_document import windup_columns

    columns = windup_columns(curve)
    rows = np.column_stack([np.asarray(column) for column in columns.values()])
    with replacing(path) as part, part.open("w", newline="") as target:
        writer = csv.writer(target)
        writer.writerow(columns)
        writer.writerows([repr(float(value)) for value in row] for row in rows)


def _show(document: dict[str, Any], file: str) -> None:
    import math

    from asperity.cli.joint_table import capacity_text
    from asperity.cli.terminal import console, table
    from asperity.units import format_quantity

    def arcminutes(key: str) -> str:
        return format_quantity(document[key], "arcmin")

    target = console()
    target.print(f"{file}: wind-up at the output, sun locked, {document['level']} stiffness\n")
    same = math.isclose(document["windup_rad"], document["reverse_windup_rad"], rel_tol=1e-9)
    summary = table(target, "Figures", "quantity", "value")
    summary.add_row("torque capacity", capacity_text(document["torque_capacity"]))
    summary.add_row("largest torque of the curve", format_quantity(document["largest_torque_Nm"], "N*m"))
    if same:
        summary.add_row("angle at the largest torque", arcminutes("windup_rad"))
    else:
        summary.add_row("angle at plus the largest torque", arcminutes("windup_rad"))
        summary.add_row("angle at minus the largest torque", "-" + arcminutes("reverse_windup_rad"))
    summary.add_row("hysteresis (width of the loop at zero torque)", arcminutes("hysteresis_rad"))
    summary.add_row(
        "lost motion (middle of the loop, between ±3 % of the torque)", arcminutes("lost_motion_rad")
    )
    summary.add_row("energy lost per cycle", f"{document['dissipated_energy_J']:.4g} J")
    target.print(summary)
    columns = ["stage", "from N·m", "to N·m", "N·m/rad", "N·m/arcmin"]
    columns += [] if same else ["reverse N·m/rad", "reverse N·m/arcmin"]
    stages = table(target, "Stages of the loading curve (secant stiffness)", *columns)
    for stage in document["stages"]:
        cells = [stage["name"], f"{stage['from_Nm']:.4g}", f"{stage['to_Nm']:.4g}"]
        for key in ("stiffness_Nm_per_rad", "reverse_stiffness_Nm_per_rad")[: 1 if same else 2]:
            cells += [f"{stage[key]:.5g}", format_quantity(stage[key], "N*m/arcmin").split(" ")[0]]
        stages.add_row(*cells)
    target.print(stages)
