"""Safety margins of one solved joint: what is required, what there is, and whether that is enough."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from asperity.results import SEVERITIES, Limit, Result, Severity
from asperity.results.all_limits import further_checks
from asperity.results.limit_check import LimitCheck, with_pins
from asperity.results.notes import Note
from asperity.results.solved import SolvedJoint
from asperity.results.table import results_of_joint
from asperity.results.torque_capacity import ends_in_damage

#: Results without a limit of their own that must nevertheless exceed a bound for the joint to exist.
_MUST_EXCEED = ("clearance", "torque_safety")
#: Severities of what a verdict is about.
_JUDGED: tuple[Severity, ...] = ("function", "damage")


@dataclass(frozen=True, slots=True)
class Margin:
    """One requirement of a joint, at the contact or clearance where it is met worst.

    ``result``: the row of the table of results; ``place``: which contact or clearance, empty for the whole drive. Its
    value ``actual`` must lie between ``lowest`` and ``highest`` [SI]; ``passes``: whether it does, never where the
    value is nan; ``severity``: how serious it is if it does not.
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
    requirements = [
        _as_its_limit(_worst(row, rows), solved) for row in judged if (rows := row.rows_of(solved))
    ]
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
    """The note that is farthest beyond its limit, or else nearest to it."""
    note = max(
        notes,
        key=lambda note: (
            not note.ok,
            -SEVERITIES.index(note.severity),
            note.value - note.limit if note.ok else abs(note.value - note.limit),
        ),
    )
    below = note.value < note.limit and not note.ok
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
    row = Result(note.name, note.label, note.dimension, note.display_unit, note.name, limit=rule)
    return Margin(row, note.contact or "", note.value, lowest, highest, note.ok, note.severity)


def _as_its_limit(margin: Margin, solved: SolvedJoint) -> Margin:
    """A torque beyond the capacity is as serious as the limit that ends the capacity; every other margin as it is."""
    if margin.result.name != "torque_safety" or margin.passes or not ends_in_damage(solved):
        return margin
    return dataclasses.replace(margin, severity="damage")


def _worst(row: Result, rows: dict[str, float]) -> Margin:
    values = np.array(list(rows.values()))
    if row.limit is None:
        lowest, highest, severity = row.lowest_limit, math.inf, SEVERITIES[0]
    else:
        lowest, highest, severity = row.limit.lowest, row.limit.highest, row.limit.severity
    room = np.where(np.isnan(values), np.nan, np.inf)  # an infinite bound is infinitely far away
    if math.isfinite(lowest):
        room = np.minimum(room, values - lowest)
    if math.isfinite(highest):
        room = np.minimum(room, highest - values)
    index = int(np.argmin(np.where(np.isnan(room), -np.inf, room)))
    actual = float(values[index])
    passes = row.limit.is_kept(actual) if row.limit else actual > lowest
    return Margin(row, list(rows)[index], actual, lowest, highest, bool(passes), severity)


def verdict_document(judged: Sequence[Margin], rims: dict[str, Any]) -> dict[str, Any]:
    """Whether a joint works, as a part of its document, from every requirement and the stresses of bodies that bend.

    ``works``: whether all requirements of function are met, None where one is not known or the numbers cannot be relied
    on; ``holds``: likewise those of strength; ``title``: both in a few words; ``words``: what is not met and what is
    not known; ``nearest``: of the requirements that are met, that which uses most of its limit, or None.
    """
    doubtful = [m.result.label for m in judged if m.severity == "accuracy" and not m.passes]
    words = [_verdict(judged, rims)]
    if doubtful:
        words.append(
            f"The numbers cannot be relied on before these warnings are settled: {', '.join(doubtful)}."
        )
    used = [m for m in judged if m.severity in _JUDGED and m.passes and math.isfinite(m.utilisation)]
    nearest = max(used, key=lambda margin: margin.utilisation, default=None)
    works, holds = (None if doubtful else _is_met(judged, severity) for severity in _JUDGED)
    if holds and _endurance_unknown(rims):
        holds = None
    return {
        "title": _title(works, holds),
        "works": works,
        "holds": holds,
        "words": " ".join(words),
        "nearest": nearest
        and {
            "label": nearest.result.label,
            "place": nearest.place or None,
            "share_of_limit": nearest.utilisation,
        },
    }


def _title(works: bool | None, holds: bool | None) -> str:
    """That something fails, is not known, or that the joint works."""
    if works is False:
        return "Does not work"
    if holds is False:
        return "Is damaged"
    return "Works" if works and holds else "Not known in full"


def _is_met(judged: Sequence[Margin], severity: Severity) -> bool | None:
    """Whether all requirements of one kind are met; None where none fails but one is not known."""
    crossed = [margin for margin in judged if margin.severity == severity and not margin.passes]
    if any(not math.isnan(margin.actual) for margin in crossed):
        return False
    return None if crossed else True


def _endurance_unknown(rims: dict[str, Any]) -> list[str]:
    """Bodies that bend and have no safety against fatigue."""
    return [
        name
        for name, rim in rims.items()
        if rim["yield_safety"] is not None and rim["fatigue_safety"] is None
    ]


def _verdict(judged: Sequence[Margin], rims: dict[str, Any]) -> str:
    """Whether the requirements of function and strength are met, and which are not known."""
    crossed = [margin for margin in judged if not margin.passes and margin.severity in _JUDGED]
    failed, unknown = (
        [
            f"{margin.result.label} ({margin.place.replace('_', ' ') or 'drive'})"
            for margin in crossed
            if math.isnan(margin.actual) == is_open
        ]
        for is_open in (False, True)
    )
    unknown += [
        f"safety of the {name.replace('_', ' ')} against fatigue (no fatigue_strength of its material)"
        for name in _endurance_unknown(rims)
    ]
    start = "Requirements of function and strength that are not"
    rest = f"; not known: {', '.join(unknown)}" if unknown else ""
    if failed:
        return f"{start} met: {', '.join(failed)}{rest}."
    if unknown:
        return f"{start} known: {', '.join(unknown)}. All others of function and strength are met."
    return "All requirements of function and strength are met."
