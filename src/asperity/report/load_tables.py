"""Loads of the structure, bearings and bending bodies as tables of a report."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from asperity.report.cells import number, quantity
from asperity.report.content import Block, Bullets, Paragraph, Table
from asperity.units import from_si

Document = dict[str, Any]
_MISES = (
    "The safety against yield is that of the Mises stress in plane strain, as in the middle of a long body; at the "
    'faces of a short one it is up to 11 % lower, which model.plane_state = "plane_stress" counts everywhere.'
)
_SHOWN = {"N": "N", "N*m": "N*m", "Pa": "MPa", "rad/s": "rpm"}


def loads(document: Document) -> Iterator[Block]:
    """What pins, bearings, shafts and housing carry, and how long the bearings live."""
    rows = []
    for row in document["loads"]:
        unit = _SHOWN[row["unit"]]
        values = (None if value is None else from_si(value, unit) for value in row["values"])
        part = f"{row['part']}, {row['position']}"
        rows.append((part, row["quantity"], *map(number, values), unit.replace("*", "·")))
    columns = (_column(case) for case in document["cases"])
    yield Table("Loads of the structure", ("part", "load", *columns, "unit"), rows, words=(0, 1))
    unknown = [f"{c['name']}: {c['unknown_because']}." for c in document["cases"] if c["unknown_because"]]
    if document["bearings"]:
        yield _bearings(document["bearings"])
    absent = [
        f"{each['bearing'].replace('_', ' ')} bearing: {reason}."
        for each in document["bearings"]
        for reason in each["absent_because"]
    ]
    yield Bullets([*unknown, *absent, *document["notes"]])


def _column(case: Document) -> str:
    if case["name"] == "without torque":
        return str(case["name"])
    torque = quantity(case["output_torque_Nm"], "N*m")
    return f"{case['name']}\n{torque}\n{quantity(case['sun_speed_rad_per_s'], 'rpm')}"


def _bearings(entries: list[Document]) -> Table:
    columns = ("dynamic_rating_N", "static_rating_N", "load_N", "load_over_dynamic_rating")
    lives = ("life_hours", "duty_life_hours", "static_safety")
    return Table(
        "Rolling bearings, each one alone",
        (
            "bearing",
            "type",
            "C\nN",
            "C_0\nN",
            "load\nN",
            "largest P/C",
            "life L10\nh",
            "under duty\nh",
            "static safety",
        ),
        [
            (
                each["bearing"].replace("_", " "),
                each["type"],
                *(number(each[column]) for column in (*columns, *lives)),
            )
            for each in entries
        ],
        words=(0, 1),
    )


def rims(document: Document) -> Iterator[Block]:
    """Stresses of the ring where it bends and of hollow rollers, if there are any."""
    rows = [
        (
            body.replace("_", " "),
            rim,
            *(
                number(each[f"{name}_Pa"][rim], 1e-6)
                for name in ("stress_at_rest", "stress", "mean", "amplitude")
            ),
            number(each["yield_safety"]),
            number(each["fatigue_safety"]),
        )
        for body, each in document["rims"].items()
        for rim in ("inner", "outer")
    ]
    if rows:
        head = ("body", "rim", "without torque\nMPa", "under torque\nMPa", "mean\nMPa", "amplitude\nMPa")
        yield Table(
            "Hoop stress of bodies that bend, and their safety",
            (*head, "safety against\nyield", "safety against\nfatigue"),
            rows,
            words=(0, 1),
        )
        yield Paragraph(_MISES)
