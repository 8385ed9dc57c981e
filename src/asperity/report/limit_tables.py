"""Limits of a joint in a report: what is required and reached, and what is crossed."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import Any

from asperity.report.content import Block, Bullets, Paragraph, Table, quantity
from asperity.results.document import crossed_limits
from asperity.results.margins import Margin

Document = dict[str, Any]

_WARNINGS_ABOUT = {
    "function": "the joint does not work as it should",
    "damage": "the joint is damaged",
    "accuracy": "the numbers cannot be trusted",
    "state": "a state of the joint, with a consequence",
}


def margins_table(margins: Sequence[Margin]) -> Iterator[Block]:
    """Required and actual values."""
    yield Paragraph(
        "Each requirement at the contact or clearance where it is met worst. First stand those that are not met, the "
        "most serious first, then those that are not known, then states of the joint that have a consequence, then all "
        "others, those that use most of their limit first. A requirement of the model that is not met says that the "
        "published contact law is outside its range, not that the joint fails."
    )
    rows = []
    for margin in sorted(margins, key=_rank):
        unit = margin.result.display_unit
        bounds = [f"> {quantity(margin.lowest, unit)}"] if math.isfinite(margin.lowest) else []
        bounds += [f"< {quantity(margin.highest, unit)}"] if math.isfinite(margin.highest) else []
        if margin.result.limit is not None and margin.result.limit.inclusive:
            bounds = [bound.replace("<", "≤").replace(">", "≥") for bound in bounds]
        rows.append(
            (
                margin.result.label,
                margin.severity,
                margin.place.replace("_", " "),
                "–" if margin.state else " and ".join(bounds),
                quantity(margin.actual, unit),
                margin.state
                or ("pass" if margin.passes else "unknown" if math.isnan(margin.actual) else "FAIL"),
            )
        )
    head = ("requirement", "concerns", "where", "required", "actual", "result")
    yield Table("Safety margins", head, rows, words=(0, 1, 2), verdicts=True)


def _rank(margin: Margin) -> tuple[int, float]:
    """Key to sort margins: not met, not known, states, then by the share of their limit."""
    if margin.state:
        return 2, 0.0
    if not margin.passes:
        return int(math.isnan(margin.actual)), 0.0
    return 3, math.inf if math.isnan(margin.utilisation) else -margin.utilisation


def warnings(document: Document) -> Iterator[Block]:
    """Every limit that is crossed, with its meaning and what to do; the range of the published law is none."""
    crossed = crossed_limits(document, model=False)
    if not crossed:
        yield Paragraph("No warnings: every limit is kept.")
        return
    items = []
    for entries in crossed:
        first = entries[0]
        values = ", ".join(
            f"{entry['shown']} {(entry['contact'] or '').replace('_', ' ')}".strip() for entry in entries
        )
        meanings = "; ".join(dict.fromkeys(entry["meaning"] for entry in entries))
        items.append(
            f"{first['label']}: {values} ({first.get('state') or 'limit ' + first['limit_shown']}; "
            f"{_WARNINGS_ABOUT[first['severity']]}). "
            f"Meaning: {meanings}. What to do: {first['remedy']}."
        )
    yield Bullets(items)
