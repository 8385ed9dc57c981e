"""Unequal branches of a joint as tables of a report."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from asperity.report.cells import number, quantity
from asperity.report.content import Block, Bullets, Heading, Paragraph, Table
from asperity.results.branch_document import deviations, force_size

Document = dict[str, Any]


def equal_branches(document: Document) -> Iterator[Block]:
    """What of a joint holds for equal branches only."""
    if "branches" in document:
        yield Paragraph(document["branches"]["note"])


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
    if "output_stiffness_Nm_per_rad" in branches:
        stiffness = quantity(branches["output_stiffness_Nm_per_rad"], "N*m/arcmin")
        rows.append(("torsional stiffness of these branches at the output, assembled", stiffness))
    if "turning" in branches:
        turning = branches["turning"]
        if turning["unknown_because"]:
            yield Bullets([f"{reason}." for reason in turning["unknown_because"]])
        rows += [
            (
                "drift of these branches per output turn",
                quantity(turning["drift_rad_per_output_turn"], "arcmin"),
            ),
            ("losses of these branches", quantity(turning["losses_W"]["total"], "W")),
            ("efficiency with these branches, %", number(turning["efficiency"], 100.0)),
        ]
    for words, entry in (
        ("torque capacity", branches["torque_capacity"]),
        ("torque capacity, rolling", branches["rolling_torque_capacity"]),
    ):
        rows += [
            (
                f"{words}: contact {entry['first_contact']} of {branches['branch_is']} {entry['first_branch']} "
                f"{entry['first_event']} first",
                quantity(entry["first_slip_Nm"], "N*m"),
            ),
            *(
                []
                if entry["all_slip_Nm"] is None
                else [(f"{words}: all branches slip", quantity(entry["all_slip_Nm"], "N*m"))]
            ),
            (f"{words} of equal branches", quantity(entry["equal_branches_Nm"], "N*m")),
        ]
    yield Table("Sun and capacity with unequal branches", ("quantity", "value"), rows)
