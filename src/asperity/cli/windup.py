"""``asperity windup``: torque–angle curve, hysteresis loop and catalogue stiffness; the angle behind once it turns."""

from __future__ import annotations

from typing import Any

import click

from asperity.cli.terminal import (
    about,
    about_torque,
    json_option,
    plot_option,
    prepare_computation,
    print_json,
    read_option,
    save_image,
    say_written,
)
from asperity.made_files import table_with
from asperity.standing import STAGE_SHARES
from asperity.writing import check_apart, check_file, check_image, write_columns

WINDUP_CURVES = table_with(
    "the curves of a wind-up",
    "torque_Nm",
    "loading_angle_rad",
    "incremental_stiffness_Nm_per_rad",
    "unloading_angle_rad",
    "reloading_angle_rad",
)
ROLLING_CURVES = table_with(
    "the curve beyond a wind-up",
    "input_angle_rad",
    "output_angle_rad",
    "angle_behind_rad",
    "drift_per_swing_rad",
)
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
    default=STAGE_SHARES,
    show_default="one and two thirds",
    help="Torques at which K1 ends and K3 begins, as shares of the largest torque.",
)
@click.option(
    "--creep-share",
    type=float,
    default=0.05,
    show_default=True,
    help="For an input that turns: creep over wind-up up to which the static curve is said to hold.",
)
@click.option("--csv", "csv_file", type=click.Path(dir_okay=False), help="Write the curves to this CSV file.")
@click.option(
    "--rolling-csv",
    "rolling_file",
    type=click.Path(dir_okay=False),
    help="Write the angle behind over the angle turned, and the drift of swings, to this CSV file.",
)
@plot_option("Draw the curves: PNG, SVG or PDF.")
@json_option("Print one JSON document in SI units instead of a table.")
def windup(
    file: str,
    torque: str | None,
    level: str,
    stages: tuple[float, float],
    creep_share: float,
    csv_file: str | None,
    rolling_file: str | None,
    plot_file: str | None,
    as_json: bool,
) -> None:
    """Wind-up of the joint described in FILE: torque–angle curve, hysteresis, lost motion, K1/K2/K3, capacity.

    The output turns against the locked input, play included. The loop runs between plus and minus the largest torque.
    It is an estimate, because the normal forces change with the torque.

    Stiffness holds for an input that stands. Once it turns under torque, the contacts creep and the output drifts:
    the second table says from which angle on, and by how much. 'asperity roll' has more on the drift.
    """
    from asperity.cli.terminal import read_case_of_branches
    from asperity.errors import InputError

    check_apart(csv=csv_file, rolling_csv=rolling_file, plot=plot_file)
    check_file(csv_file, file, kind=WINDUP_CURVES)
    check_file(rolling_file, file, kind=ROLLING_CURVES)
    check_image(plot_file, file)
    case = read_case_of_branches(file)
    if torque is not None:
        from asperity.unit_table import Dimension

        read_option("torque", torque, Dimension.TORQUE)  # refuses what is no torque
    first, second = stages
    if not 0.0 < first < second < 1.0:
        raise InputError(f"--stages {first:g} {second:g}: allowed are two shares with 0 < first < second < 1")
    if not 0.0 < creep_share < float("inf"):
        raise InputError(f"--creep-share {creep_share:g}: allowed is a number above 0, e.g. 0.05")
    prepare_computation()
    from asperity.api.joint import DescribedJoint
    from asperity.api.windup import windup as wound_up
    from asperity.results.windup_document import rolling_columns, windup_columns

    with about(file), about_torque(torque):
        wound = wound_up(
            DescribedJoint(case, file),
            torque=torque,
            level=level,  # type: ignore[arg-type]
            stages=stages,
            creep_share=creep_share,
        )
    if csv_file:
        write_columns(windup_columns(wound.curve), csv_file, kind=WINDUP_CURVES)
        say_written(csv_file)
    if rolling_file:
        if wound.onset is None:
            raise InputError(f"--rolling-csv: {wound.document['rolling']['unknown_because'][0]}")
        write_columns(rolling_columns(wound.onset), rolling_file, kind=ROLLING_CURVES)
        say_written(rolling_file)
    if plot_file:
        save_image(wound.plot(), plot_file)
    if as_json:
        print_json(wound.document)
        return
    _show(wound.document, file)


def _show(document: dict[str, Any], file: str) -> None:
    import math

    from asperity.cli.joint_table import capacity_text
    from asperity.cli.terminal import console, table
    from asperity.joint.pin_bound import bounded
    from asperity.joint.torque_limits import first_slip_words
    from asperity.results.windup_document import stages_title
    from asperity.units import format_quantity

    def arcminutes(key: str) -> str:
        return format_quantity(document[key], "arcmin")

    target = console()
    whose = ", of its own branches" if document["of_own_branches"] else ""
    whose = bounded(f"{document['level']} stiffness{whose}", document["stiffness_bound"])
    target.print(f"{file}: wind-up at the output, input locked, {whose}\n")
    same = math.isclose(document["windup_rad"], document["reverse_windup_rad"], rel_tol=1e-9)
    summary = table(target, "Figures", "quantity", "value")
    summary.add_row("standing torque capacity", capacity_text(document["standing_torque_capacity"]))
    for text in first_slip_words(document["standing_torque_capacity"]):
        summary.add_row("first slip", text)
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
    stages = table(target, stages_title(document), *columns)
    for stage in document["stages"]:
        cells = [stage["name"], f"{stage['from_Nm']:.4g}", f"{stage['to_Nm']:.4g}"]
        for key in ("stiffness_Nm_per_rad", "reverse_stiffness_Nm_per_rad")[: 1 if same else 2]:
            per_arcminute = format_quantity(stage[key], "N*m/arcmin").split(" ")[0]
            cells += [format_quantity(stage[key], "1", 5), per_arcminute]
        stages.add_row(*cells)
    target.print(stages)
    _show_rolling(document, same)


def _show_rolling(document: dict[str, Any], same: bool) -> None:
    """Up to which angle the static curve holds, and what follows it."""
    from asperity.cli.document_text import in_unit, print_wrapped
    from asperity.cli.terminal import console, show_table, table
    from asperity.units import format_quantity

    target, rolling = console(), document["rolling"]
    torque = format_quantity(document["largest_torque_Nm"], "N*m")
    if rolling["unknown_because"]:
        print_wrapped(
            target, f"When the input turns under {torque}: {rolling['unknown_because'][0]}.", indent=0
        )
        return
    columns = ["", "input", "output"] + ([] if same else ["input, reverse", "output, reverse"])
    ways = [rolling] if same or rolling["reverse"]["unknown_because"] else [rolling, rolling["reverse"]]
    shown = table(target, f"When the input turns under {torque}", *columns[: 1 + 2 * len(ways)])
    share = f"{100.0 * rolling['creep_share_of_windup']:.3g} %"
    for key, words in (
        ("static_curve_up_to", f"static curve holds up to (creep {share} of the wind-up)"),
        ("steady_creep_from", "steady creep from (every contact has rolled its width)"),
        ("swing_without_drift", "largest swing to and fro without lasting drift"),
    ):
        cells = [in_unit(way[key][side], "deg") for way in ways for side in ("input_rad", "output_rad")]
        shown.add_row(words, *cells)
    drift = [in_unit(way["drift_rad_per_output_turn"], "arcmin") for way in ways]
    shown.add_row("drift per output turn in steady rolling", *(cell for text in drift for cell in ("", text)))
    target.print(shown)
    head = ("contact", "width", "rolled by it after, input", "output", "share of the drift")
    rows = (
        (
            name,
            in_unit(contact["width_m"], "um"),
            *(in_unit(contact["rolls_its_width_in"][side], "deg") for side in ("input_rad", "output_rad")),
            f"{100.0 * contact['share_of_drift']:.3g} %",
        )
        for name, contact in rolling["contacts"].items()
    )
    show_table(target, "Contacts", head, rows)
    print_wrapped(
        target,
        "Stiffness and drift are two regimes. The wind-up is elastic and comes back when the torque is taken off. The "
        "drift grows with every angle turned under torque, in either direction; turning back does not recover it.",
        indent=0,
    )
