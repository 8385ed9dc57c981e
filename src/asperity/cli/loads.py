"""``asperity loads``: what pins, bearings, shafts and housing carry."""

from __future__ import annotations

import csv
from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import about, json_option, prepare_computation, print_json, say_written
from asperity.writing import check_file, replacing

if TYPE_CHECKING:
    from asperity.joint_file.model import Case

Document = dict[str, Any]

#: Units of the table and of the CSV file for those of the document.
_SHOWN = {"N": "N", "N*m": "N*m", "Pa": "MPa", "rad/s": "rpm"}


@click.command()
@click.argument("file", type=click.Path())
@click.option("--csv", "csv_file", type=click.Path(dir_okay=False), help="Write the table to this CSV file.")
@json_option("Print one JSON document in SI units instead of a table.")
def loads(file: str, csv_file: str | None, as_json: bool) -> None:
    """Forces and torques on pins, bearings, shafts and housing of the joint described in FILE, for their supplier.

    One column each: without torque, under the working torque, and under every load [[duty]] of FILE.
    """
    from asperity.joint_file.reader import read_case

    check_file(csv_file, file)
    case = read_case(file)
    prepare_computation()
    with about(file):
        document = _document(case)
    if csv_file:
        _write(document, csv_file)
        say_written(csv_file)
    if as_json:
        print_json(document)
        return
    _show(document, file)


def _document(case: Case) -> Document:
    from asperity.joint_file.solved_document import solved_case
    from asperity.results.loads_document import bearing_entries, loads_document

    solved = solved_case(case)
    bearings = bearing_entries(solved)
    return loads_document(solved, bearings)


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
    from asperity.units import from_si

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
    for row in document["loads"]:
        part = f"{row['part']}, {row['position']}"
        unit = _SHOWN[row["unit"]]
        values = [None if value is None else from_si(value, unit) for value in row["values"]]
        if part != last:
            shown.add_row(part)
            last = part
        shown.add_row(f"  {row['quantity']}", *map(number, values), unit.replace("*", "·"))
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
    from asperity.units import from_si

    columns = [_column(case, ", ") for case in document["cases"]]
    with replacing(path) as part, part.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(["part", "position", "load", "unit", *columns])
        for row in document["loads"]:
            unit = _SHOWN[row["unit"]]
            values = ["" if value is None else repr(float(from_si(value, unit))) for value in row["values"]]
            writer.writerow([row["part"], row["position"], row["quantity"], unit, *values])
