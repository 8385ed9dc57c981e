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
    "--torque", help="Largest torque of the curve, with its unit; default: the file's output torque."
)
@click.option(
    "--level",
    type=click.Choice(LEVELS),
    default="assembly",
    show_default=True,
    help="Which stiffness is integrated.",
)
@click.option(
    "--stages",
    type=(float, float),
    default=(1.0 / 3.0, 2.0 / 3.0),
    show_default="one and two thirds",
    help="Bounds of the stages K1|K2|K3 as shares of the largest torque.",
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
    """Wind-up of the joint described in FILE: capacity, torque–angle curve, hysteresis, lost motion, K1/K2/K3.

    The output turns against the locked sun. The loop runs between plus and minus the largest torque.
    """
    from asperity.joint_file.reader import read_case

    check_file(csv_file, file)
    check_image(plot_file)
    case = read_case(file)
    from asperity.precision import use_compilation_cache, use_double_precision
    from asperity.units import Dimension, parse_quantity

    asked = None if torque is None else parse_quantity(torque, Dimension.TORQUE)
    use_double_precision()
    use_compilation_cache()
    from asperity.joint.windup_document import examined_windup, windup_document
    from asperity.joint_file.build import joint_from_case

    curve, capacity = examined_windup(
        joint_from_case(case),
        largest_torque=asked,
        level=level,  # type: ignore[arg-type]
        stage_shares=stages,
    )
    document = windup_document(curve, capacity, level=level)  # type: ignore[arg-type]
    if csv_file:
        _write_csv(curve, csv_file)
        say_written(csv_file)
    if plot_file:
        from asperity.show.windup_figure import windup_figure

        write_image(windup_figure(curve, title=f"Wind-up of {file}, {level} stiffness"), plot_file)
        say_written(plot_file)
    if as_json:
        import json

        click.echo(json.dumps(document, indent=2, allow_nan=False))
        return
    _show(document, file)


def _write_csv(curve: Windup, path: str) -> None:
    """The loading curve and both branches of the loop, one row a point, units in the column names."""
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
    from asperity.cli.terminal import console, table
    from asperity.units import format_quantity

    def arcminutes(key: str) -> str:
        return format_quantity(document[key], "arcmin")

    target = console()
    target.print(f"{file}: wind-up at the output, sun locked, {document['level']} stiffness\n")
    limit = document["torque_capacity_Nm"]
    summary = table(target, "Figures", "quantity", "value")
    summary.add_row(
        "torque capacity",
        "not limited by friction: the wedge tightens with the torque"
        if limit is None
        else f"{format_quantity(limit, 'N*m')}, {document['limiting_contact']} slips first",
    )
    summary.add_row("largest torque of the curve", format_quantity(document["largest_torque_Nm"], "N*m"))
    summary.add_row("wind-up there", arcminutes("windup_rad"))
    summary.add_row("width of the loop at zero torque", arcminutes("hysteresis_rad"))
    summary.add_row("lost motion (middle line, +-3 % of the torque)", arcminutes("lost_motion_rad"))
    summary.add_row("energy lost a cycle", f"{document['dissipated_energy_J']:.4g} J")
    target.print(summary)
    stages = table(
        target, "Catalogue stages (secant stiffness)", "stage", "from N·m", "to N·m", "N·m/rad", "N·m/arcmin"
    )
    for stage in document["stages"]:
        stiffness = stage["stiffness_Nm_per_rad"]
        stages.add_row(
            stage["name"],
            f"{stage['from_Nm']:.4g}",
            f"{stage['to_Nm']:.4g}",
            f"{stiffness:.5g}",
            format_quantity(stiffness, "N*m/arcmin").split(" ")[0],
        )
    target.print(stages)
