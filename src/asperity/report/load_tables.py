"""Loads of the structure, bearings and bending bodies, and unequal branches, as tables of a report."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from asperity.report.content import Block, Bullets, Heading, Paragraph, Table, number, quantity
from asperity.results.branch_document import deviations, force_size
from asperity.results.loads_document import shown_rows, state_of_case

Document = dict[str, Any]
_MISES = (
    "The safety against yield is that of the Mises stress in plane strain, as in the middle of a long body; at the "
    'faces of a short one it is up to 11 % lower, which model.plane_state = "plane_stress" counts everywhere.'
)


def loads(document: Document) -> Iterator[Block]:
    """What pins, bearings, shafts and housing carry, and how long the bearings live."""
    rows = [
        (f"{part}, {position}", quantity, *map(number, values), unit.replace("*", "·"))
        for part, position, quantity, unit, values in shown_rows(document)
    ]
    columns = (_column(case) for case in document["cases"])
    yield Table("Loads of the structure", ("part", "load", *columns, "unit"), rows, words=(0, 1))
    unknown = [f"{c['name']}: {c['unknown_because']}." for c in document["cases"] if c["unknown_because"]]
    if document["bearings"]:
        yield _bearings(document["bearings"])
    absent = [
        f"{bearing['bearing'].replace('_', ' ')} bearing: {reason}."
        for bearing in document["bearings"]
        for reason in bearing["absent_because"]
    ]
    yield Bullets([*unknown, *absent, *document["notes"]])


def _column(case: Document) -> str:
    if case["name"] == "without torque":
        return state_of_case(case)
    torque = quantity(case["output_torque_Nm"], "N*m")
    return f"{state_of_case(case)}\n{torque}\n{quantity(case['sun_speed_rad_per_s'], 'rpm')}"


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
                bearing["bearing"].replace("_", " "),
                bearing["type"],
                *(number(bearing[column]) for column in (*columns, *lives)),
            )
            for bearing in entries
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
                number(stresses[f"{name}_Pa"][rim], 1e-6)
                for name in ("stress_at_rest", "stress", "mean", "amplitude")
            ),
            number(stresses["yield_safety"]),
            number(stresses["fatigue_safety"]),
        )
        for body, stresses in document["rims"].items()
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


def branch_tables(branches: Document) -> Iterator[Block]:
    """What unequal branches do to a joint."""
    states, names = (branches["standing"], branches["rolling"]), deviations(branches)

    def of(state: Document | None, name: str, index: int, factor: float = 1.0) -> str:
        return number(None if state is None else state[name][index], factor)

    yield Heading("Branches by their own sizes")
    yield Paragraph(branches["note"])
    yield Table(
        "Branches",
        (
            branches["branch_is"],
            *(f"{words}\ndeviation µm" for words in names.values()),
            "interference\nµm",
            "preload\nN",
            "share\nstanding %",
            "share\nrolling %",
            "slip standing\nT/(mu N)",
            "slip rolling\nT/(mu N)",
        ),
        [
            (
                str(index + 1),
                *(number(entry[key], 1e6) for key in names),
                number(entry["interference_m"], 1e6),
                number(entry["preload_N"]),
                *(of(state, "share", index, 100.0) for state in states),
                *(of(state, "slip_ratio", index) for state in states),
            )
            for index, entry in enumerate(branches["branches"])
        ],
    )
    sun = (states[0] or branches["without_torque"])["sun"]
    when = ", standing" if states[0] else " without torque"
    rows = [
        (f"force on the bearings of the sun{when}", quantity(force_size(branches, sun["force_N"]), "N")),
        (f"displacement of the sun{when}", quantity(math.hypot(*sun["displacement_m"]), "um")),
    ]
    others = (states[0] or branches["without_torque"]).get("central_forces_N", {})
    rows += [
        (f"force on the {name.replace('_', ' ')}{when}", quantity(force_size(branches, force), "N"))
        for name, force in others.items()
    ]
    yield Table("Forces on the axis with unequal branches", ("quantity", "value"), rows)
