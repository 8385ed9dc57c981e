"""The limits of a joint: what is required and reached, and what is crossed."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence

from asperity.results.document import crossed_limits
from asperity.results.margins import Margin
from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table, Warned, Warnings
from asperity.views.numbers import quantity, words

#: What a crossed limit means for the joint, by its severity.
ABOUT = {
    "function": "Fails",
    "damage": "Damage",
    "accuracy": "Outside the model's range",
    "state": "State",
    "model": "Contact law",
}
_NOT_CHECKED = "Not checked"
#: What a limit concerns, by its severity.
CONCERNS = {
    "function": "function",
    "damage": "strength",
    "accuracy": "range of the model",
    "state": "state",
    "model": "range of the contact law",
}
#: Outcome of a limit that concerns the level of the asperities alone, by which no joint fails.
_OUTSIDE = "out of range"


def warnings(document: Document) -> Block:
    """Every crossed limit, the most serious first, with what to do; the range of the published law is no limit."""
    crossed = crossed_limits(document, model=False)
    contacts = max(Counter(e["name"] for e in document["diagnostics"] if e["contact"]).values(), default=0)
    if not crossed:
        verdict = document.get("verdict")  # of a whole joint
        complete = verdict is None or (verdict["works"] and verdict["holds"])
        met = "all limits are met" if complete else "no limit is crossed; what is not checked is said above"
        return Paragraph(f"No warnings: {met}.", strong=True)
    return Warnings([_warned(entries, contacts) for entries in crossed])


def _warned(entries: list[Document], contacts: int) -> Warned:
    first = entries[0]
    beside = first.get("state") or f"limit {first['limit_shown']}"
    remedies = [entry["remedy"] for entry in entries if entry["remedy"]]
    return Warned(
        first["severity"],
        ABOUT[first["severity"]] if first["known"] else _NOT_CHECKED,
        f"{first['label']} {_values(entries, contacts)} ({beside})",
        tuple(dict.fromkeys(entry["meaning"] for entry in entries)),
        remedies[0] if remedies else "",
    )


def _values(entries: list[Document], contacts: int) -> str:
    """Values by contact, or one value where all contacts have the same."""
    values = [entry["shown"] for entry in entries]
    if entries[0]["contact"] and len(entries) == contacts and len(set(values)) == 1:
        return f"{values[0]} at every contact"
    return ", ".join(
        f"{value} at {words(e['contact'])}" if e["contact"] else value
        for value, e in zip(values, entries, strict=True)
    )


def margins(judged: Sequence[Margin]) -> Iterator[Block]:
    """Required and actual values; residuals of the equations are no margins."""
    yield Paragraph(
        "Each requirement at its worst contact or clearance: first those that fail, most serious first, then those "
        "that are not known, then states of the joint with a consequence, then all others, tightest first. At the end "
        "stands where the contact law is out of range; it concerns the stiffness of the asperities alone, and no "
        "joint fails by it."
    )
    shown = sorted((margin for margin in judged if margin.result.group != "residuals"), key=_rank)
    rows = [
        (
            margin.label,
            CONCERNS[margin.severity],
            words(margin.place),
            "–" if margin.state else _bounds(margin),
            quantity(margin.actual, margin.result.display_unit),
            _OUTSIDE if _beside(margin) else margin.outcome,
        )
        for margin in shown
    ]
    shares = [
        margin.utilisation
        if margin.known and not margin.state and math.isfinite(margin.utilisation)
        else None
        for margin in shown
    ]
    head = ("requirement", "concerns", "where", "required", "actual", "result")
    yield Table("Safety margins", head, rows, words=(0, 1, 2), verdicts=True, shares=shares)


def _bounds(margin: Margin) -> str:
    unit = margin.result.display_unit
    inclusive = margin.result.limit is not None and margin.result.limit.inclusive
    signs = ("≥", "≤") if inclusive else (">", "<")
    bounds = zip(signs, (margin.lowest, margin.highest), strict=True)
    return " and ".join(f"{sign} {quantity(bound, unit)}" for sign, bound in bounds if math.isfinite(bound))


def _rank(margin: Margin) -> tuple[int, float]:
    """Key to sort margins: not met, not known, states, then by the share of their limit; what fails no joint last."""
    if _beside(margin):
        return 4, 0.0
    if margin.state:
        return 2, 0.0
    if not margin.passes:
        return int(not margin.known), 0.0
    return 3, math.inf if math.isnan(margin.utilisation) else -margin.utilisation


def _beside(margin: Margin) -> bool:
    """Whether this is a range of the contact law that is left: no limit of the joint."""
    return margin.severity == "model" and margin.failed
