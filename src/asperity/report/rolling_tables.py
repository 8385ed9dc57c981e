"""The joint that turns as tables of a report: drift beside stiffness, losses, life."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from asperity.report.content import Block, Bullets, Paragraph, Table, number, percent, quantity
from asperity.results.notes import surface_rows
from asperity.results.position_rows import position_rows
from asperity.rolling.document import rating_life_name

Document = dict[str, Any]
_CAUSES = ("creep", "skew", "hysteresis", "oil")


def rolling(document: Document) -> Iterator[Block]:
    """Drift, losses, contacts, thrust and life, tables, and why numbers are absent."""
    in_rolling = document["rolling"]
    if in_rolling["unknown_because"]:
        yield Bullets([f"{reason}." for reason in in_rolling["unknown_because"]])
    yield Table(
        "Position of the output: drift beside stiffness",
        ("quantity", "value", "what it is"),
        [(label, quantity(value, unit), meaning) for label, value, unit, meaning in position_rows(document)],
        words=(0, 2),
    )
    yield _losses(in_rolling)
    yield _contacts(document)
    surfaces = surface_rows(in_rolling["contacts"])
    if surfaces:
        yield Table(
            "Surfaces in rolling",
            (
                "contact",
                "flash temperature\nK",
                "smallest oil film\nµm",
                "film ratio λ\n-",
                "lubrication",
            ),
            [(name, *(number(value) for value in numbers), band or "–") for name, *numbers, band in surfaces],
            words=(0, 4),
        )
    if any(contact["axial_force_N"] for contact in in_rolling["contacts"].values()):
        thrust = in_rolling["axial_thrust_N"]
        yield Table(
            "Axial thrust on each body, N",
            tuple(name.replace("_", " ") for name in thrust),
            [tuple(number(force) for force in thrust.values())],
            words=(),
        )
    else:
        yield Paragraph("Axial thrust: none, the axes are parallel.")
    yield from _life(document)


def _losses(in_rolling: Document) -> Table:
    rows = [
        (
            name,
            *(number(contact["losses_W"][cause]) for cause in _CAUSES),
            number(contact["losses_W"]["total"]),
        )
        for name, contact in in_rolling["contacts"].items()
    ]
    sums = in_rolling["losses_W"]
    rows.append(("bearings and pins", "", "", "", "", number(sums["bearings"])))
    rows.append(("all", *(number(sums[cause]) for cause in _CAUSES), number(sums["total"])))
    title = (
        f"Losses, W; efficiency {percent(in_rolling['efficiency'])}, power in "
        f"{quantity(in_rolling['input_power_W'], 'W')}, out {quantity(in_rolling['output_power_W'], 'W')}"
    )
    return Table(title, ("contact", *_CAUSES, "sum"), rows)


def _contacts(document: Document) -> Table:
    rows = [
        (
            name,
            number(contact["creepage"], 1e3),
            number(contact["traction_coefficient"]),
            number(contact["shakedown_ratio"]),
            number(contact["life_output_turns"]),
        )
        for name, contact in document["rolling"]["contacts"].items()
    ]
    head = (
        "contact",
        "creepage\n10⁻³",
        "traction\nT/N",
        "pressure over\nshakedown limit",
        "life\noutput turns",
    )
    return Table("Contacts in rolling", head, rows)


def _life(document: Document) -> Iterator[Block]:
    in_rolling = document["rolling"]
    rows = [("the drive", number(in_rolling["life_hours"]), number(in_rolling["life_output_turns"]))]
    rows += [
        (name.replace("_", " "), number(hours), number(in_rolling["body_life_output_turns"][name]))
        for name, hours in in_rolling["body_life_hours"].items()
    ]
    if document["input"].get("duty"):
        rows.append(
            (
                "the drive under the duty",
                number(in_rolling["duty_life_hours"]),
                number(in_rolling["duty_life_output_turns"]),
            )
        )
    name = rating_life_name(float(in_rolling["reliability"]))
    yield Table(name, ("life of", "hours", "output turns"), rows)
    if in_rolling["no_life_because"]:
        reason = in_rolling["no_life_because"]
        yield Paragraph(f"{reason[0].upper()}{reason[1:]}.")
