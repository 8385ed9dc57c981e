"""``asperity loads``: what pins, bearings, shafts and housing carry."""

from __future__ import annotations

import csv
from typing import Any

import click

from asperity.cli.terminal import (
    about,
    json_option,
    prepare_computation,
    print_json,
    read_option,
    say_written,
)
from asperity.writing import check_file, replacing

Document = dict[str, Any]


@click.command()
@click.argument("file", type=click.Path())
@click.option("--mounting-gap", default="0 um", show_default=True, metavar="LENGTH",
              help="Radial gap between a ring and its rollers while it is slipped on.")  # fmt: skip
@click.option("--csv", "csv_file", type=click.Path(dir_okay=False), help="Write the table to this CSV file.")
@json_option("Print one JSON document in SI units instead of a table.")
def loads(file: str, mounting_gap: str, csv_file: str | None, as_json: bool) -> None:
    """Forces and torques on pins, bearings, shafts and housing of the joint described in FILE, for their supplier.

    And the force, or the temperature, that mounts its rings, and their stress. One column each: without torque, under
    the working torque, and under every load [[duty]] of FILE.
    """
    from asperity.joint_file.reader import read_case
    from asperity.unit_table import Dimension

    gap = read_option("mounting-gap", mounting_gap, Dimension.LENGTH)
    check_file(csv_file, file)
    case = read_case(file)
    prepare_computation()
    from asperity.joint_file.solved_document import solved_case
    from asperity.results.loads_document import bearing_entries, loads_document

    with about(file):
        solved = solved_case(case)
        document = loads_document(solved, bearing_entries(solved), gap)
    if csv_file:
        _write(document, csv_file)
        say_written(csv_file)
    if as_json:
        print_json(document)
        return
    _show(document, file)


def _column(case: Document, line: str) -> str:
    """Title of a column: the load, its torque and the speed of the sun."""
    from asperity.units import format_quantity

    if case["name"] == "without torque":
        return str(case["name"])
    torque = format_quantity(case["output_torque_Nm"], "N*m")
    return f"{case['name']}{line}{torque}{line}{format_quantity(case['sun_speed_rad_per_s'], 'rpm')}"


def _show(document: Document, file: str) -> None:
    from rich.markup import escape

    from asperity.cli.document_text import number, print_wrapped
    from asperity.cli.terminal import console, table
    from asperity.results.loads_document import shown_rows

    target = console()
    target.print(escape(file))
    target.print()
    shown = table(
        target,
        "Loads of the structure",
        "load",
        *(_column(case, "\n") for case in document["cases"]),
        "unit",
    )
    last = ""
    for *part, quantity, unit, values in shown_rows(document):
        if (title := ", ".join(part)) != last:
            shown.add_row(last := title)
        shown.add_row(f"  {quantity}", *map(number, values), unit.replace("*", "·"))
    target.print(shown)
    if document["bearings"]:
        _show_bearings(document["bearings"])
    for case in document["cases"]:
        if case["unknown_because"]:
            print_wrapped(target, f"{case['name']}: {case['unknown_because']}", indent=2)
    for note in document["notes"]:
        print_wrapped(target, note, indent=2)


def _show_bearings(entries: list[Document]) -> None:
    from asperity.cli.document_text import number, print_wrapped
    from asperity.cli.terminal import console, show_table

    target = console()
    columns = {
        "C\nN": "dynamic_rating_N",
        "C_0\nN": "static_rating_N",
        "load\nN": "load_N",
        "largest P/C\n-": "load_over_dynamic_rating",
        "life L10\nh": "life_hours",
        "under the duty\nh": "duty_life_hours",
        "static safety\n-": "static_safety",
    }
    rows = (
        (entry["bearing"].replace("_", " "), entry["type"], *(number(entry[key]) for key in columns.values()))
        for entry in entries
    )
    show_table(target, "Rolling bearings, each one alone", ("bearing", "type", *columns), rows)
    for entry in entries:
        for reason in entry["absent_because"]:
            print_wrapped(target, f"{entry['bearing'].replace('_', ' ')}: {reason}", indent=2)


def _write(document: Document, path: str) -> None:
    """The table as a CSV file: one row a load, one column a case."""
    from asperity.results.loads_document import shown_rows

    columns = [_column(case, ", ") for case in document["cases"]]
    with replacing(path) as part, part.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(["part", "position", "load", "unit", *columns])
        for *words, values in shown_rows(document):
            writer.writerow([*words, *("" if value is None else repr(value) for value in values)])
