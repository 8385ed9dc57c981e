"""Safety margins of one solved joint, and its verdict: what is required, what there is, and whether that is enough."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from asperity.results import SEVERITIES, Limit, Result, Severity
from asperity.results.all_limits import further_checks
from asperity.results.limit_check import LimitCheck, with_pins
from asperity.results.notes import Note
from asperity.results.solved import SolvedJoint
from asperity.results.table import results_of_joint
from asperity.types import Document
from asperity.units import format_quantity

#: Results without a limit of their own that must nevertheless exceed a bound for the joint to exist.
_MUST_EXCEED = ("clearance", "torque_safety")
#: Severities of what a verdict is about.
_JUDGED: tuple[Severity, ...] = ("function", "damage")
#: Requirements of the user, not of the joint: their bounds are called required.
_ASKED = "required_"
#: Digits with which a value and its bound are told apart.
_MOST_DIGITS = 9
_OUTSIDE = "Outside the model's range until these are resolved"


@dataclass(frozen=True, slots=True)
class Margin:
    """One requirement of a joint, at the contact or clearance where it is met worst.

    ``result``: the row of the table of results; ``place``: which contact or clearance, empty for the whole drive. Its
    value ``actual`` must lie between ``lowest`` and ``highest`` [SI]; ``passes``: whether it does, never where the
    value is nan or still lacks something; ``severity``: how serious it is if it does not.
    """

    result: Result
    place: str
    actual: float
    lowest: float
    highest: float
    passes: bool
    severity: Severity

    @property
    def state(self) -> str:
        """The state of the joint where it is no failure that the limit is crossed; otherwise empty."""
        return "" if self.passes or self.result.limit is None else self.result.limit.state

    @property
    def known(self) -> bool:
        """Whether it is known that it is met or not."""
        if self.passes or self.result.limit is None:
            return self.passes or not math.isnan(self.actual)
        return self.result.limit.is_known(self.actual)

    @property
    def failed(self) -> bool:
        """Whether it is known that it is not met."""
        return self.known and not self.passes

    @property
    def outcome(self) -> str:
        """The state of the joint, or ``pass``, ``FAIL`` or ``unknown``."""
        return self.state or ("pass" if self.passes else "FAIL" if self.failed else "unknown")

    @property
    def label(self) -> str:
        """What is required, with what its value lacks."""
        return f"{self.result.label}{self._lacks}"

    @property
    def where(self) -> str:
        """Its place after its value, with a blank before it; empty for the whole drive."""
        return f" at {self.place.replace('_', ' ')}" if self.place else ""

    @property
    def words(self) -> str:
        """What it is, its value, its place, and its bound, such as "slip ratio 1.2 at sp, at most 1"."""
        actual, *ends = _told_apart(self.actual, self.lowest, self.highest, self.result)
        if len(ends) == 2:
            bound = " to ".join(ends)
        elif self.result.name.startswith(_ASKED):
            bound = f"required {ends[0]}"
        else:
            bound = f"{'at least' if math.isfinite(self.lowest) else 'at most'} {ends[0]}"
        return f"{self.result.label} {actual}{self.where}, {bound}{self._lacks}"

    @property
    def tightness(self) -> str:
        """How near it is to its bound: the share of the limit that is used, or value and bound if that is a least."""
        subject, limit = self.result.used or ("", "")
        if not subject and math.isfinite(self.lowest):
            return self.words
        share = 100.0 * self.utilisation
        part = format_quantity(share, "1", 2 if share < 99.0 else 4)
        return f"{subject or self.result.label}{self.where}, {part} % of {limit or 'its limit'}"

    @property
    def check(self) -> str:
        """What is to be checked where nothing is known, and what that lacks."""
        return f"{self.result.label}{self.where}{self._lacks}"

    @property
    def _lacks(self) -> str:
        """What a value lacks, in brackets after a blank; empty where there is no value or it lacks nothing."""
        if self.result.limit is None or math.isnan(self.actual) or not self.result.limit.missing:
            return ""
        return f" ({self.result.limit.missing})"

    @property
    def utilisation(self) -> float:
        """Share of the limit that is used [-]: beyond 1 it is crossed; nan where a share has no meaning."""
        if math.isinf(self.lowest) and self.highest > 0.0:
            return self.actual / self.highest
        if math.isinf(self.highest) and self.lowest > 0.0 and self.actual > 0.0:
            return self.lowest / self.actual
        return math.nan


def margins(solved: SolvedJoint) -> tuple[Margin, ...]:
    """Every requirement of one joint, the most serious first: what its diagnostics judge, and what must exceed a bound.

    One for each judged result that the joint has and for each name of its notes, where it is met worst; and those of
    unequal branches and of a duty.
    """
    table = results_of_joint(solved).values()
    judged = [with_pins(row, solved) for row in table if row.limit or row.name in _MUST_EXCEED]
    requirements = [_worst(row, rows) for row in judged if (rows := row.rows_of(solved))]
    requirements = [margin for margin in requirements if not _repeats(margin)]
    requirements += map(_further, further_checks(solved))
    by_name: dict[str, list[Note]] = {}
    for note in solved.notes:
        by_name.setdefault(note.name, []).append(note)
    requirements += map(_worst_note, by_name.values())
    return tuple(sorted(requirements, key=lambda margin: SEVERITIES.index(margin.severity)))


def _further(check: LimitCheck) -> Margin:
    rule = check.rule
    place = check.contact or ""
    return Margin(check.result, place, check.value, rule.lowest, rule.highest, check.ok, rule.severity)


def _worst_note(notes: list[Note]) -> Margin:
    """The note that is farthest beyond its limit, or else nearest to it; of states the smallest value."""

    def excess(note: Note) -> float:
        if note.state and not note.upper:
            return note.limit - note.value
        return note.value - note.limit if note.ok else abs(note.value - note.limit)

    note = max(notes, key=lambda note: (not note.ok, -SEVERITIES.index(note.severity), excess(note)))
    below = not note.upper and (bool(note.state) or (note.value < note.limit and not note.ok))
    lowest, highest = (note.limit, math.inf) if below else (-math.inf, note.limit)
    rule = Limit(
        note.severity,
        note.meaning,
        note.meaning,
        note.remedy or "",
        lowest,
        highest,
        inclusive=True,
        state=note.state,
    )
    row = Result(
        note.name, note.label, note.dimension, note.display_unit, note.name, limit=rule, used=note.used
    )
    return Margin(row, note.contact or "", note.value, lowest, highest, note.ok, note.severity)


def _closeness(margin: Margin) -> tuple[float, bool]:
    """How near a margin is to its bound; of two alike, the limit itself rather than the capacity that it ends."""
    return round(margin.utilisation, 9), margin.result.name != "torque_safety"


def _repeats(margin: Margin) -> bool:
    """Whether a margin only repeats others: each limit that ends the torque capacity is a requirement by itself."""
    return margin.result.name == "torque_safety" and not margin.passes


def _worst(row: Result, rows: dict[str, float]) -> Margin:
    """The place where a bound is crossed farthest; or else one that has no value, or else the nearest to its bound."""
    if row.limit is None:
        lowest, highest, severity = row.lowest_limit, math.inf, SEVERITIES[0]
    else:
        lowest, highest, severity = row.limit.lowest, row.limit.highest, row.limit.severity

    def kept(value: float) -> bool:
        return row.limit.is_kept(value) if row.limit else value > lowest

    def room(margin: Margin) -> tuple[int, float]:
        """Order of the places, and the distance from the nearer bound; an infinite one is infinitely far away."""
        order = 0 if margin.failed else 2 if margin.passes else 1
        to_bounds = ((margin.actual - lowest, lowest), (highest - margin.actual, highest))
        left = min((distance for distance, bound in to_bounds if math.isfinite(bound)), default=math.inf)
        return order, left if margin.known else 0.0

    places = [
        Margin(row, place, value, lowest, highest, kept(value), severity) for place, value in rows.items()
    ]
    return min(places, key=room)


def verdict_document(
    judged: Sequence[Margin], rims: Mapping[str, Any], materials: Mapping[str, str] = MappingProxyType({})
) -> Document:
    """Whether a joint works, as a part of its document, from every requirement and the stresses of bodies that bend.

    ``works``: whether all requirements of function are met, None where none fails but one is not known, or the numbers
    are outside the range of the model; ``holds``: likewise those of strength; ``title``: both in a few words;
    ``words``: what fails, and then what is not known; ``nearest``: of the requirements that are met, that which uses
    most of its limit, or None. ``materials``: body → name of its material in the joint file.
    """
    failed = {kind: [m for m in judged if m.severity == kind and m.failed] for kind in _JUDGED}
    unknown = [m for m in judged if m.severity in (*_JUDGED, "accuracy") and not m.known]
    doubtful = [margin for margin in judged if margin.severity == "accuracy" and margin.failed]
    bodies = _endurance_unknown(rims)
    works, holds = (
        False if failed[kind] else None if doubtful or any(m.severity == kind for m in unknown) else True
        for kind in _JUDGED
    )
    missing = [margin.check for margin in unknown]
    title, *sentences = _sentences(
        ["; ".join(margin.words for margin in failed[kind]) for kind in _JUDGED],
        "; ".join(margin.words for margin in doubtful),
        missing + _fatigue_checks(bodies, materials),
    )
    used = [
        m
        for m in judged
        if m.severity in _JUDGED
        and m.passes
        and math.isfinite(m.utilisation)
        and m.result.group != "residuals"  # which say that the equations are solved, not how near a limit is
    ]
    nearest = max(used, key=_closeness, default=None)
    return {
        "title": title,
        "works": works,
        "holds": None if holds and bodies else holds,
        "words": " ".join(sentences),
        "nearest": nearest
        and {
            "label": nearest.result.label,
            "place": nearest.place or None,
            "share_of_limit": nearest.utilisation,
            "words": nearest.tightness,
        },
    }


def _sentences(failed: list[str], outside: str, missing: list[str]) -> tuple[str, ...]:
    """Title of a verdict, what follows it after a colon, and further sentences, the most serious first."""
    function, damage = failed
    checks = "one check" if len(missing) == 1 else f"{len(missing)} checks"
    parts = [
        ("Fails", "Fails", function),
        ("Is damaged", "Damaged", damage),
        (_OUTSIDE, _OUTSIDE, outside),
        (f"Works, {checks} missing", "Not checked", ", ".join(missing)),
    ]
    (title, _, first), *others = [part for part in parts if part[2]] or [
        ("Works", "", "every requirement of function and strength is met")
    ]
    return title, f"{first}.", *(f"{start}: {text}." for _, start, text in others)


def _endurance_unknown(rims: Mapping[str, Any]) -> list[str]:
    """Bodies that bend and have no safety against fatigue."""
    return [
        name
        for name, rim in rims.items()
        if rim["yield_safety"] is not None and rim["fatigue_safety"] is None
    ]


def _fatigue_checks(bodies: list[str], materials: Mapping[str, str]) -> list[str]:
    """The check against fatigue that each body lacks, and what to enter for it."""
    return [
        f"{body.replace('_', ' ')} fatigue (enter fatigue_strength of "
        + (f"material {materials[body]})" if body in materials else "its material)")
        for body in bodies
    ]


def _told_apart(actual: float, lowest: float, highest: float, row: Result) -> list[str]:
    """A value and its finite bounds as a sentence says them, with as many digits as tell them apart."""
    numbers = [actual, *(bound for bound in (lowest, highest) if math.isfinite(bound))]
    digits = 3 if row.display_unit == "1" else 4
    shown = [_shown(number, row, digits) for number in numbers]
    while digits < _MOST_DIGITS and any(
        text == shown[0] and bound != actual for text, bound in zip(shown[1:], numbers[1:], strict=True)
    ):
        digits += 1
        shown = [_shown(number, row, digits) for number in numbers]
    return shown


def _shown(value: float, row: Result, digits: int) -> str:
    """A value as a sentence says it, thousands apart."""
    if math.isinf(value):
        return "infinite"
    text = format_quantity(value, row.display_unit, digits)
    return re.sub(r"(?<![\d.])\d{4,}", lambda digits: f"{int(digits[0]):,}", text)
