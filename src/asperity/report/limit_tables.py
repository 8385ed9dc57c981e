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
    "function": "the joint fails",
    "damage": "the joint is damaged",
    "accuracy": "outside the range of the model",
    "state": "a state of the joint, with a consequence",
}


def margins_table(margins: Sequence[Margin]) -> Iterator[Block]:
    """Required and actual values."""
    yield Paragraph(
        "Each requirement at its worst contact or clearance: first those that fail, most serious first, then those "
        "that are not known, then states of the joint with a consequence, then all others, tightest first. A "
        "requirement of the model that fails means that the published contact law is outside its range, not that the "
        "joint fails."
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
                margin.label,
                margin.severity,
                margin.place.replace("_", " "),
                "–" if margin.state else " and ".join(bounds),
                quantity(margin.actual, unit),
                margin.outcome,
            )
        )
    head = ("requirement", "concerns", "where", "required", "actual", "result")
    yield Table("Safety margins", head, rows, words=(0, 1, 2), verdicts=True)


def _rank(margin: Margin) -> tuple[int, float]:
    """Key to sort margins: not met, not known, states, then by the share of their limit."""
    if margin.state:
        return 2, 0.0
    if not margin.passes:
        return int(not margin.known), 0.0
    return 3, math.inf if math.isnan(margin.utilisation) else -margin.utilisation


def warnings(document: Document) -> Iterator[Block]:
    """Every limit that is crossed, with its meaning and what to do; the range of the published law is none."""
    crossed = crossed_limits(document, model=False)
    if not crossed:
        yield Paragraph("No warnings: all limits are met.")
        return
    items = []
    for entries in crossed:
        first = entries[0]
        values = ", ".join(
            f"{entry['shown']} {(entry['contact'] or '').replace('_', ' ')}".strip() for entry in entries
        )
        remedies = [entry["remedy"] for entry in entries if entry["remedy"]]
        remedy = f" What to do: {remedies[0]}." if remedies else ""
        meanings = "; ".join(dict.fromkeys(entry["meaning"] for entry in entries))
        items.append(
            f"{first['label']}: {values} ({first.get('state') or 'limit ' + first['limit_shown']}; "
            f"{_WARNINGS_ABOUT[first['severity']] if first['known'] else 'not checked'}). "
            f"Meaning: {meanings}.{remedy}"
        )
    yield Bullets(items)
