"""The window of a joint as one JSON document: what governs where, and whether every load lies inside."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from asperity.results.limit_torques import LIMITS, SHOWN_ONLY
from asperity.results.window import JudgedLoad, Region, Window, stretches
from asperity.types import Document
from asperity.units import format_quantity

#: Display unit of the axis → end of the keys that hold its numbers in SI units.
_SI_KEYS = {"degC": "degC", "N": "N", "um": "m"}


#: What is said of a limit that is crossed without torque, at the end.
WITHOUT_TORQUE = " without torque"


class Border(NamedTuple):
    """One limit over the axis: its name, what it is, and the torque where it is reached, infinite elsewhere [N·m]."""

    limit: str
    meaning: str
    torque: np.ndarray


class Stretch(NamedTuple):
    """A part of the axis where one limit governs: numbers of its ends, and what the limit is.

    ``closed``: whether no torque at all is allowed there.
    """

    first: int
    last: int
    limit: str
    meaning: str
    closed: bool


def borders(window: Window, region: Region) -> list[Border]:
    """Every limit that is reached somewhere on the axis."""
    limits, found = region.limits, []
    for code in dict.fromkeys(limits.limit.ravel().tolist()):
        of = limits.limit == code
        torque = np.where(of, limits.torque, np.inf).min(axis=0)
        reached = np.isfinite(torque)
        if reached.any():
            places = limits.place[of & (limits.torque == torque) & reached]
            known = float(torque[reached].max())
            meaning = window.limit_words(LIMITS[code], Counter(places.tolist()).most_common(1)[0][0], known)
            found.append(Border(LIMITS[code], meaning, torque))
    return found


def governing(window: Window, region: Region) -> list[Stretch]:
    """Which limit governs where, from one end of the axis to the other."""
    capacity, found = region.capacity, []
    closed = capacity.torque == 0.0
    codes = np.where(closed, -1, capacity.limit)
    for code in dict.fromkeys(codes.tolist()):
        for first, last in stretches(codes == code):
            said = [window.words(capacity, number) for number in range(first, last + 1)]
            meaning = Counter(said).most_common(1)[0][0]
            limit = LIMITS[int(capacity.limit[first + said.index(meaning)])]
            meaning = meaning.removesuffix(WITHOUT_TORQUE) if closed[first] else meaning
            found.append(Stretch(first, last, limit, meaning, bool(closed[first])))
    return sorted(found)


def axis_key(window: Window) -> str:
    """End of the keys that hold numbers of the axis in SI units: degC, N or m."""
    return _SI_KEYS[window.axis.unit]


def window_document(window: Window) -> Document:
    """A window in SI units, ready for :func:`json.dumps`, the unit at the end of every key."""
    unit = axis_key(window)
    return {
        "over": window.axis.over,
        "key": window.axis.key,
        "axis": window.axis.label,
        "axis_unit": window.axis.unit,
        f"working_{unit}": window.axis.working,
        "input_speed_rad_per_s": window.loads[0].load.speed,
        "required_life_s": window.required_life,
        "life_has_film_factor": window.reference.joint.rolling.cleanliness is not None,
        "has_tolerances": window.has_tolerances,
        "verdict": verdict(window),
        f"at_{unit}": window.at.tolist(),
        "preload_N": window.preload.tolist(),
        "regions": [_region(window, region) for region in window.regions],
        "loads": [_load(window, load) for load in window.loads],
        "allowed": [_allowed(window, *ends) for ends in window.allowed()],
        "allowed_with_tolerances": [_allowed(window, *ends) for ends in window.allowed(surely=True)]
        if window.has_tolerances
        else None,
    }


def _region(window: Window, region: Region) -> Document:
    unit, names = axis_key(window), window.place_names
    return {
        "direction": "forward" if region.sign > 0.0 else "reverse",
        "torque_capacity_Nm": _finite(region.capacity.torque),
        "limit": [LIMITS[code] for code in region.capacity.limit],
        "limiting_place": [names[code] for code in region.capacity.place],
        "least_torque_capacity_Nm": None if region.least is None else _finite(region.least),
        "greatest_torque_capacity_Nm": None if region.greatest is None else _finite(region.greatest),
        "governing": [
            {
                f"from_{unit}": float(window.at[part.first]),
                f"to_{unit}": float(window.at[part.last]),
                "limit": part.limit,
                "meaning": part.meaning,
                "closed": part.closed,
            }
            for part in governing(window, region)
        ],
        "limits": [
            {
                "limit": border.limit,
                "meaning": border.meaning,
                "ends_the_capacity": border.limit not in SHOWN_ONLY,
                "torque_Nm": _finite(border.torque),
            }
            for border in borders(window, region)
        ],
    }


def _finite(torque: np.ndarray) -> list[float | None]:
    """Torques for JSON; None where no torque is a limit."""
    return [value if math.isfinite(value) else None for value in torque.tolist()]


def _load(window: Window, judged: JudgedLoad) -> Document:
    number = window.working
    capacity = float(judged.capacity.torque[number])
    return {
        "name": judged.load.name,
        "output_torque_Nm": judged.load.torque,
        "input_speed_rad_per_s": judged.load.speed,
        "inside": bool(judged.inside[number]),
        "inside_with_tolerances": bool(judged.surely_inside[number]) if window.has_tolerances else None,
        "torque_capacity_Nm": capacity if math.isfinite(capacity) else None,
        "share_of_capacity": abs(judged.load.torque) / capacity if capacity > 0.0 else None,
        "limit": LIMITS[judged.capacity.limit[number]],
        "meaning": window.words(judged.capacity, number),
    }


def _allowed(window: Window, first: int, last: int) -> Document:
    """A stretch over which every load lies inside, and what ends it on both sides; None where the axis does."""
    unit = axis_key(window)
    return {
        f"from_{unit}": float(window.at[first]),
        "begins_with": _ended(window, first - 1),
        f"to_{unit}": float(window.at[last]),
        "ends_with": _ended(window, last + 1),
    }


def _ended(window: Window, number: int) -> str | None:
    """What keeps a load outside at a place beside a stretch of the axis; None beyond the axis."""
    if not 0 <= number < window.at.size:
        return None
    outside = [load for load in window.loads if not load.inside[number]]
    outside += [load for load in window.loads if not load.surely_inside[number]]
    return f"{outside[0].load.name}: {window.words(outside[0].capacity, number)}"


def verdict(window: Window) -> Document:
    """Whether all loads lie inside where the joint works: ``inside``, a ``title``, and further ``words``."""
    number = window.working
    where = f"at {_on_axis(window, window.axis.working)}"
    if window.axis.over == "preload":
        where = f"{where} of {window.axis.label}"
    loads, outside = window.loads, [load for load in window.loads if not load.inside[number]]
    if outside:
        which = (
            "The output torque of the file" if len(loads) == 1 else f"{len(outside)} of {len(loads)} loads"
        )
        title = f"{which} {'lies' if len(outside) == 1 else 'lie'} outside the window {where}"
        said = _beyond(window, outside, number)
    else:
        which = "The output torque of the file lies" if len(loads) == 1 else f"All {len(loads)} loads lie"
        title = f"{which} inside the window {where}"
        said = _nearest(window, number)
    sentences = [f"{said[:1].upper()}{said[1:]}.", *_stretches(window)]
    return {"inside": not outside, "title": title, "words": " ".join(sentences)}


def _beyond(window: Window, outside: list[JudgedLoad], number: int) -> str:
    """Why loads lie outside, those with one reason together."""
    reasons: dict[str, list[str]] = {}
    for judged in outside:
        reached = float(judged.capacity.torque[number])
        words = window.words(judged.capacity, number)
        why = f"beyond {format_quantity(reached, 'N*m')}, at which {words}"
        if reached == 0.0:
            why = f"no torque is allowed: {words.removesuffix(WITHOUT_TORQUE)}"
        torque = format_quantity(abs(judged.load.torque), "N*m")
        reasons.setdefault(why, []).append(f"{judged.load.name} ({torque})")
    return "; ".join(f"{', '.join(names)}: {why}" for why, names in reasons.items())


def _nearest(window: Window, number: int) -> str:
    """The load that uses most of its capacity."""
    judged = max(
        window.loads,
        key=lambda each: abs(each.load.torque) / max(float(each.capacity.torque[number]), math.ulp(0.0)),
    )
    reached = float(judged.capacity.torque[number])
    if math.isinf(reached):
        return "no limit is reached at any torque"
    share = format_quantity(100.0 * abs(judged.load.torque) / reached, "1", 3)
    named = "" if len(window.loads) == 1 else f"{judged.load.name}, "
    return (
        f"the nearest limit: {named}{format_quantity(abs(judged.load.torque), 'N*m')} is {share} % of the "
        f"{format_quantity(reached, 'N*m')} at which {window.words(judged.capacity, number)}"
    )


def _stretches(window: Window) -> Iterator[str]:
    """Over which part of the axis every load lies inside, also with all parts within their tolerances."""
    whole = f"from {_at(window, 0)} to {_at(window, window.at.size - 1)}"
    if all(np.all(region.capacity.torque == 0.0) for region in window.regions):
        reason = governing(window, window.regions[0])
        why = "; ".join(dict.fromkeys(part.meaning for part in reason))
        yield f"No torque is allowed anywhere {whole}: {why}."
        return
    subject = "The load lies" if len(window.loads) == 1 else "All loads lie"
    nominal = _said(window, window.allowed())
    yield from _largest(window)
    yield f"{subject} inside {nominal}." if nominal else f"{subject} inside nowhere {whole}."
    if window.has_tolerances:
        surely = _said(window, window.allowed(surely=True))
        stated = "Wherever the preload lies within the tolerances of the file"
        if surely == nominal and nominal:
            yield f"{stated}, that holds as well."
        elif surely:
            yield f"{stated}: {surely}."
        elif nominal:
            yield f"{stated}, it holds nowhere."


def _largest(window: Window) -> Iterator[str]:
    """Where on the axis the capacity in the direction of the file is largest."""
    capacity = window.regions[0].capacity.torque
    number = int(np.argmax(capacity))
    if math.isfinite(capacity[number]):
        largest = format_quantity(float(capacity[number]), "N*m")
        yield f"The largest capacity on the axis is {largest}, at {_at(window, number)}."


def _said(window: Window, parts: list[tuple[int, int]]) -> str:
    """Stretches of the axis in words, with what ends them; empty where there is none."""
    return " and ".join(f"from {_end(window, first, -1)} to {_end(window, last, 1)}" for first, last in parts)


def _end(window: Window, number: int, way: int) -> str:
    why = _ended(window, number + way)
    if why is None:
        return f"{_at(window, number)} (end of the axis)"
    return f"{_at(window, number)} ({why.partition(': ')[2].removesuffix(WITHOUT_TORQUE)})"


def _at(window: Window, number: int) -> str:
    return _on_axis(window, float(window.at[number]))


def window_columns(window: Window) -> dict[str, np.ndarray]:
    """The window as columns: names with units → arrays of shape (n,); infinite where no torque is a limit."""
    columns = {
        f"{window.axis.key.partition('.')[2]}_{axis_key(window)}": window.at,
        "preload_N": window.preload,
    }
    for region in window.regions:
        way = "" if region.sign == window.regions[0].sign else "reverse_"
        columns[f"{way}torque_capacity_Nm"] = region.capacity.torque
        if region.least is not None and region.greatest is not None:
            columns[f"{way}least_torque_capacity_Nm"] = region.least
            columns[f"{way}greatest_torque_capacity_Nm"] = region.greatest
        for border in borders(window, region):
            columns[f"{way}{border.limit}_Nm"] = border.torque
    return columns


def _on_axis(window: Window, value: float) -> str:
    """A value of the axis with its unit, micrometres as people write them."""
    return format_quantity(value, window.axis.unit.replace("um", "µm"))
