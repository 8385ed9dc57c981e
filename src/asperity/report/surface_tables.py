"""What is known of the surfaces of a joint, and how far it lets the results range, as tables of a report."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from asperity.report.cells import number, percent, quantity
from asperity.report.content import Block, Paragraph, Table
from asperity.results.document import LEVEL_WORDS

Document = dict[str, Any]


def measured_stiffness(measured: Document, interval: Document) -> Iterator[Block]:
    """Interval of stiffness and drift that follows from the uncertainty of a measured surface."""
    yield from _interval(
        f"{percent(interval['confidence'])} interval from the measured surface, D = "
        f"{number(measured['fractal_dimension'])}, G = {quantity(measured['fractal_roughness_m'], 'mm')}",
        interval,
    )
    if interval["outside"] or interval["unsolved"] or interval["all_plastic"]:
        yield Paragraph(
            f"Of {number(interval['draws'])} draws of D and G, {interval['outside']} had a D outside 1 to 2, "
            f"{interval['unsolved']} had no solution and {interval['all_plastic']} had plastic spots only, where the "
            "contact law has no stiffness. These are left out."
        )


def drawn_stiffness(interval: Document | None) -> Iterator[Block]:
    """Interval of stiffness and drift over what the Ra of the surfaces leaves open."""
    if interval is not None:
        yield from _interval("Interval over what the Ra of the surfaces leaves open", interval)
        yield Paragraph(interval["words"])


def _interval(title: str, interval: Document) -> Iterator[Block]:
    ends = ("low", "high")
    yield Table(
        title,
        ("level of the model", "output from\nN·m/rad", "output to\nN·m/rad"),
        [
            (words, *(number(interval[level][f"{end}_Nm_per_rad"]) for end in ends))
            for level, words in LEVEL_WORDS
        ],
    )
    low, high = (quantity(interval["drift"][f"{end}_rad_per_output_turn"], "arcmin") for end in ends)
    yield Paragraph(f"Drift from {low} to {high} per output turn.")


def averages(document: Document) -> Table:
    """The Ra that belongs to the D and G of every surface."""
    rows = []
    for entry in document["surfaces"]:
        low, high = (number(entry[f"roughness_average_{end}_m"], 1e6) for end in ("low", "high"))
        rows.append(
            (
                "all"
                if len(entry["contacts"]) == len(document["standing"]["contacts"])
                else ", ".join(entry["contacts"]),
                number(entry["fractal_dimension"]),
                number(entry["fractal_roughness_m"], 1e3),
                number(entry["cut_off_m"], 1e3),
                number(entry["roughness_average_m"], 1e6),
                f"{low} to {high}",
            )
        )
    return Table(
        "Ra to which D and G correspond, on each of two like bodies; 95 % of measurements over five cut-offs lie in "
        "the range",
        ("contacts", "D\n-", "G\nmm", "cut-off\nmm", "Ra\nµm", "measured Ra\nµm"),
        rows,
    )
