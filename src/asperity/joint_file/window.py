"""The window of a joint file: over which of its numbers, between which ends, with its tolerances and its loads."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Literal

import numpy as np

from asperity.engine.control import at_once
from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.solve import joint_state, refuse_impossible_joint
from asperity.joint.temperature import temperature_span
from asperity.joint_file.build import toleranced_tracks, with_nominal_sizes
from asperity.joint_file.own_branches import at_steady_temperature, joint_with_branches
from asperity.joint_file.part_names import paths_of_track
from asperity.joint_file.si_tables import AnyCase, Values, key_at, numeric_keys, replace_values, si_values
from asperity.results.limit_torques import LIMITS, LimitSearch, Ways
from asperity.results.solved import SolvedJoint
from asperity.results.window import Load, Window, WindowAxis, window
from asperity.types import Array
from asperity.units import format_quantity

Over = Literal["temperature", "preload"]
#: What a window may extend over.
OVERS: tuple[Over, ...] = ("temperature", "preload")
#: Places of the axis unless others are asked for, and the most that are allowed.
POINTS, MOST_POINTS = 25, 500

_TEMPERATURE = "temperature.working"
#: Shares of the preload of the file from which and up to which a window may extend unless others are asked for.
_LEAST, _MOST = (1.0 / 4.0, 1.0 / 16.0, 1.0 / 64.0), (2.0, 4.0, 8.0)
_SLIP = ("gross_slip", "lift_off", "none")


def joint_window(
    case: AnyCase,
    *,
    over: Over | None = None,
    start: float | None = None,
    stop: float | None = None,
    points: int = POINTS,
    report: Callable[[int, int], None] | None = None,
) -> Window:
    """The window of a joint file: torques that it may pass over its working temperature, or over its preload.

    ``over``: None for the temperature where the preload or a seat in a housing depends on it, and for the preload
    elsewhere; ``start`` and ``stop`` of the axis [SI], None for those around the file. ``report`` takes the number of
    steps done, and of all. An ``InputError`` if an end or the number of points is not allowed, if temperature changes
    nothing, or the bodies do not fit.
    """
    if not 2 <= points <= MOST_POINTS:
        raise InputError(
            f"the number of points must be from 2 to {MOST_POINTS}, got {points}", options=["points"]
        )
    values = at_steady_temperature(si_values(case))
    key = window_key(values, over)
    search = _search(case, values, key)
    axis = _axis(values, key, search, start, stop, points)
    return window(
        axis,
        search,
        _loads(values, search.reference),
        has_tolerances=bool(_ends(case, values)),
        report=report,
    )


def temperature_matters(values: Values) -> bool:
    """Whether the preload of a joint, or the seat of its ring, depends on its temperature; of tables in SI units."""
    return "temperature" in values and ("interference" in values["load"] or "housing" in values)


def window_key(values: Values, over: Over | None) -> str:
    """The number of a joint file, of tables in SI units, that varies over a window.

    An ``InputError`` if it is to be the temperature, and that changes nothing.
    """
    matters = temperature_matters(values)
    if over == "preload" or (over is None and not matters):
        return "load.interference" if "interference" in values["load"] else "load.preload"
    if "temperature" not in values:
        raise InputError(
            "the joint file has no section [temperature], so that nothing in it depends on temperature; add it with "
            "assembly and working temperatures, or choose the window over preload",
            options=["over"],
        )
    if not matters:
        raise InputError(
            "temperature changes neither the preload, which load.preload keeps as a spring does, nor the seat of a "
            "ring; give load.interference in place of load.preload, or choose the window over preload",
            options=["over"],
        )
    return _TEMPERATURE


def _ends(case: AnyCase, values: Values) -> dict[str, float]:
    """By how much the numbers that make the preload differ at the end of their tolerances where it is greatest [SI]."""
    stated = {
        path: entry.tolerance
        for path, entry in numeric_keys(case).items()
        if entry.tolerance > 0.0 and path == paths_of_track(values, path)[0]
    }
    if "interference" not in values["load"]:
        return {path: stated[path] for path in ("load.preload",) if path in stated}
    effects: dict[str, float] = {}
    for track in toleranced_tracks(values, tuple(stated)):
        effects[track.path] = effects.get(track.path, 0.0) + float(np.sum(track.per_size))
    return {path: math.copysign(stated[path], effect) for path, effect in effects.items() if effect != 0.0}


def _search(case: AnyCase, values: Values, key: str) -> LimitSearch:
    """The search for the limits of the joint of a file, of which one number varies."""
    ends = _ends(case, values)
    stated = {path: entry.value for path, entry in numeric_keys(case).items()}
    tables = with_nominal_sizes(values) if ends else values

    def joint_at(at: Array, shift: Array) -> Joint:
        changes = {path: stated[path] + shift * by for path, by in ends.items()}
        changes[key] = at + shift * ends.get(key, 0.0)
        return joint_with_branches(replace_values(tables, changes))

    joint = at_once(lambda: joint_with_branches(_at_assembly(values)))
    joint = refuse_impossible_joint(dataclasses.replace(joint, output_torque=np.zeros(())))
    reference = SolvedJoint(joint, joint_state(joint), None)
    duty = [float(point.output_torque) for point in joint.rolling.duty]
    life = case.rolling.required_life if case.rolling is not None else None
    return LimitSearch(
        joint_at=joint_at,
        reference=reference,
        required_life=None if life is None else life.value,
        duty_torque=(max([0.0, *duty]), max([0.0, *(-torque for torque in duty)])),
    )


def _at_assembly(values: Values) -> Values:
    """The tables at the temperature of the assembly: no joint is loose there."""
    if "temperature" not in values:
        return values
    return replace_values(values, {_TEMPERATURE: values["temperature"]["assembly"]})


def _axis(
    values: Values, key: str, search: LimitSearch, start: float | None, stop: float | None, points: int
) -> WindowAxis:
    """The axis between its ends, or around the number of the file."""
    section, name = key.split(".")
    working, entry = values[section][name], key_at(key)
    if key == _TEMPERATURE:
        low, high = temperature_span(values["temperature"]["assembly"], working)
        label = "working temperature"
    else:
        low, high = _ends_of_preload(values, search, working)
        label = name
    low, high = (asked if asked is not None else end for asked, end in ((start, low), (stop, high)))
    for option, end in (("from", low), ("to", high)):
        try:
            entry.check(end)
        except InputError as error:
            raise InputError(f"{key}: {error}", options=[option]) from None
    if not low < high:
        raise InputError(
            f"the window must rise: from {format_quantity(low, entry.unit)} to {format_quantity(high, entry.unit)} it "
            "does not; choose a start below the end",
            options=["from", "to"],
        )
    over = "temperature" if key == _TEMPERATURE else "preload"
    return WindowAxis(over, key, label, entry.unit, np.linspace(low, high, points), float(working))


def _ends_of_preload(values: Values, search: LimitSearch, working: float) -> tuple[float, float]:
    """From a quarter to twice the preload or interference of the file.

    Less where a torque is allowed only there, to a 64th; more, to eight times, where slip governs no longer there.
    """
    places = np.array([working * share for share in (*_LEAST, *_MOST)])
    load = _loads(values, search.reference)[0]
    sign = math.copysign(1.0, load.torque) * np.ones_like(places)
    first = search.of(Ways(places, 0.0 * places, sign, load.speed * np.ones_like(places))).first()
    below, above = np.split(np.arange(places.size), [len(_LEAST)])
    opens = [number for number in below if first.torque[number] > 0.0]
    ends = [number for number in above if LIMITS[first.limit[number]].removeprefix("rolling_") not in _SLIP]
    return float(places[opens[0] if opens else below[0]]), float(places[ends[0] if ends else above[0]])


def _loads(values: Values, reference: SolvedJoint) -> list[Load]:
    """The torque of a file, and the loads of its duty."""
    own = Load(
        "output torque of the file",
        float(values["load"]["output_torque"]),
        float(reference.joint.input_speed),
    )
    return [
        own,
        *(
            Load(f"load {number} of the duty", float(point.output_torque), float(point.input_speed))
            for number, point in enumerate(reference.joint.rolling.duty, start=1)
        ),
    ]
