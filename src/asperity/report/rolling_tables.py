"""The joint that turns as tables of a report: drift beside stiffness, losses, life."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from asperity.report.cells import number, percent, quantity
from asperity.report.content import Block, Bullets, Paragraph, Table
from asperity.results.position_rows import position_rows

Document = dict[str, Any]
_CAUSES = ("creep", "skew", "hysteresis", "oil")


def rolling(document: Document) -> Iterator[Block]:
    """Drift, losses, contacts, thrust and life.

    Parameters
    ----------
    document : dict
        As :func:`asperity.results.document.joint_document` makes it.

    Yields
    ------
    Block
        Tables, and why numbers are absent.
    """
    found = document["rolling"]
    if found["unknown_because"]:
        yield Bullets([f"{reason}." for reason in found["unknown_because"]])
    yield _position(document)
    yield _losses(found)
    yield _contacts(document)
    if any(each["axial_force_N"] for each in found["contacts"].values()):
        thrust = found["axial_thrust_N"]
        yield Table(
            "Axial thrust on each body, N",
            tuple(name.replace("_", " ") for name in thrust),
            [tuple(number(force) for force in thrust.values())],
            words=(),
        )
    else:
        yield Paragraph("Axial thrust: none, the axes are parallel.")
    yield from _life(document)


def _position(document: Document) -> Table:
    return Table(
        "Position of the output: drift beside stiffness",
        ("quantity", "value", "what it is"),
        [(label, quantity(value, unit), meaning) for label, value, unit, meaning in position_rows(document)],
        words=(0, 2),
    )


def _losses(found: Document) -> Table:
    rows = [
        (
            name,
            *(number(each["losses_W"][cause]) for cause in _CAUSES),
            number(each["losses_W"]["total"]),
        )
        for name, each in found["contacts"].items()
    ]
    sums = found["losses_W"]
    rows.append(("bearings and pins", "", "", "", "", number(sums["bearings"])))
    rows.append(("all", *(number(sums[cause]) for cause in _CAUSES), number(sums["total"])))
    title = (
        f"Losses, W; efficiency {percent(found['efficiency'])}, power in "
        f"{quantity(found['input_power_W'], 'W')}, out {quantity(found['output_power_W'], 'W')}"
    )
    return Table(title, ("contact", *_CAUSES, "sum"), rows)


def _contacts(document: Document) -> Table:
    rows = [
        (
            name,
            number(each["creepage"], 1e3),
            number(each["traction_coefficient"]),
            number(each["shakedown_ratio"]),
            number(each["life_output_turns"]),
        )
        for name, each in document["rolling"]["contacts"].items()
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
    found = document["rolling"]
    rows = [("the drive", number(found["life_hours"]), number(found["life_output_turns"]))]
    rows += [
        (name.replace("_", " "), number(hours), number(found["body_life_output_turns"][name]))
        for name, hours in found["body_life_hours"].items()
    ]
    if document["input"].get("duty"):
        rows.append(
            (
                "the drive under its duty",
                number(found["duty_life_hours"]),
                number(found["duty_life_output_turns"]),
            )
        )
    share = number(float(found["reliability"]), 100.0)
    yield Table(
        f"Fatigue life that {share} % of the drives reach", ("life of", "hours", "output turns"), rows
    )
    if found["no_life_because"]:
        reason = found["no_life_because"]
        yield Paragraph(f"{reason[0].upper()}{reason[1:]}.")
