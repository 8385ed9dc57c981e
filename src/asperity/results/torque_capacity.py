"""Torque capacity of a joint: the largest torque before its first limit of function or damage, standing or rolling.

The limits are those of the search for slip (:mod:`asperity.joint.capacity`), standing and in rolling, and every row of
the tables of results that is judged as function or damage: a new row of that kind limits the capacity by itself.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np

from asperity.drive.layout.wedge import wedges
from asperity.drive.state.first_limit import (
    FARTHEST,
    FirstLimit,
    first_limit_of_numbers,
    of_each,
    searched_limit,
    with_derivative,
)
from asperity.drive.state.states import DriveStates
from asperity.engine import trees
from asperity.engine.arrays import entry_of, xp
from asperity.engine.control import at_once, map_over, traced_once
from asperity.engine.module import Module
from asperity.joint.assembled import Pressed
from asperity.joint.capacity import UnderTorque, first_guess, limits_of, loading
from asperity.joint.description import without_duty
from asperity.joint.evaluation import joint_result
from asperity.joint.machine import JointMachine, joint_machine
from asperity.joint.torque_limits import LIMIT_KINDS, MODEL_LIMITS, TorqueCapacity, kind_words
from asperity.results import contact_rows, heat_rows, limit_rows, load_rows, rolling_rows, stiffness_rows
from asperity.results.notes import Severity
from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.types import Array, Document

#: Severities of the limits that a torque must keep.
JUDGED: tuple[Severity, ...] = ("function", "damage")

#: Judged rows whose limit the search for slip finds by itself, and the kind of limit that it is there.
FOUND_BY_SEARCH = {
    "slip_ratio": "gross_slip",
    "normal_force_over_preload": "lift_off",
    "balance_residual": "no_solution",
    "closure_residual": "no_solution",
}

#: Judged rows about the temperature of the joint: its torque capacity is that at this temperature, and the torque that
#: has none is found with it (:func:`asperity.joint.heat.steady_torque`).
OF_TEMPERATURE = ("ambient_reserve",)

#: All other judged rows, of any drive.
JUDGED_ROWS: tuple[Result, ...] = tuple(
    row
    for rows in (stiffness_rows, contact_rows, limit_rows, rolling_rows, heat_rows, load_rows)
    for row in rows.ROWS
    if row.limit is not None
    and row.limit.severity in JUDGED
    and row.name not in (*FOUND_BY_SEARCH, *OF_TEMPERATURE)
)

#: What a limit of the search is called where it is reached in rolling.
_IN_ROLLING = "rolling_"

#: Limits of a torque capacity, by the codes of :class:`JointCapacity`: of the search standing, in rolling, of rows.
CAPACITY_LIMITS = (
    *LIMIT_KINDS,
    *(f"{_IN_ROLLING}{kind}" for kind in LIMIT_KINDS[1:]),
    *(row.name for row in JUDGED_ROWS),
)

#: Share within which a joint slips standing and in rolling at one torque: then standing is named.
ALIKE = 1e-9

#: Share of the torque at which a contact slips up to which rows are looked at: at it, their states need not exist.
_BELOW = 1.0 - 1e-9

#: Parts of a drive at which a limit can be reached: axes of results, in the order of the codes of places.
PLACE_AXES = ("contact", "body", "bearing", "pin")


class JointCapacity(Module):
    """The torque capacity of a joint in one direction, or in both along the first axis.

    ``output_torque``: the largest that keeps every limit of function and damage, standing and in rolling [N·m]; 0 where
    one is crossed without torque, infinite where none is ever reached. ``limit``: code of the first one in
    :data:`CAPACITY_LIMITS`; ``place``: number of its contact, body, bearing or pin in :func:`place_names`.
    """

    output_torque: Array
    limit: Array
    place: Array


class LimitEntry(NamedTuple):
    """One limit at one place: its name in :data:`CAPACITY_LIMITS` or of a row, and the code of the place."""

    limit: str
    place: int


def place_names(solved: SolvedJoint) -> tuple[str, ...]:
    """Names of the places at which a limit can be reached, by their codes; the last one is none of them."""
    return place_labels({axis: solved.row_names(axis) for axis in PLACE_AXES})


def place_labels(names: dict[str, tuple[str, ...]]) -> tuple[str, ...]:
    """The same from the names of the parts of a drive: bearings and pins say that they are, bodies have those names."""
    endings = {"bearing": "_bearing", "pin": "_pin"}
    labels = [f"{name}{endings.get(axis, '')}" for axis in PLACE_AXES for name in names[axis]]
    return (*labels, "none")


def torque_capacities(solved: SolvedJoint) -> JointCapacity:
    """Torque capacities of a joint for positive and negative torques, as positive numbers, along the first axis.

    Equation (A9) of :doc:`/equations`. Of a joint that was solved by itself without derivatives, below the torques
    at which it is known to slip; of one in a program with derivatives.
    """
    return solved.once(_of_numbers if "solution" in vars(solved) else _of_program)


def torque_capacity(solved: SolvedJoint, *, reverse: bool = False) -> JointCapacity:
    """The same for positive torques, or for negative ones."""
    both = torque_capacities(solved)
    return trees.map(lambda leaf: leaf[int(reverse)], both)


def capacity_of_direction(solved: SolvedJoint) -> JointCapacity:
    """The same in the direction of the output torque."""
    both, torque = torque_capacities(solved), solved.joint.output_torque
    return trees.map(lambda leaf: xp.where(torque < 0.0, leaf[1], leaf[0]), both)


def torque_safety(solved: SolvedJoint) -> Any:
    """Torque capacity over the torque, both in the direction of the torque [-]; 0 where there is no capacity."""
    capacity = xp.asarray(capacity_of_direction(solved).output_torque)
    return xp.where(capacity > 0.0, capacity / xp.abs(xp.asarray(solved.joint.output_torque)), 0.0)


def excesses_of_rows(solved: SolvedJoint, rows: Iterable[Result] = JUDGED_ROWS) -> Array:
    """By how much rows of a joint exceed their limits, in the order of :func:`entries_of_rows` [-]."""
    excesses = []
    for row in _rows_of(solved, rows):
        assert row.limit is not None
        value = row.of(solved)
        if isinstance(value, list | tuple):
            value = xp.stack(xp.broadcast_arrays(*value))
        excess = row.limit.excess(xp.asarray(value, dtype=float))
        excesses.append(xp.atleast_1d(excess)[np.array(places_of_row(row, solved))])
    together: Array = xp.concatenate([*excesses, xp.zeros(0)])
    return together


def _rows_of(solved: SolvedJoint, rows: Iterable[Result]) -> list[Result]:
    """Those of some rows that a joint has."""
    of_drive = [row for row in rows if not row.needs_wedges or wedges(solved.joint.drive)]
    return [row for row in of_drive if places_of_row(row, solved)]


def places_of_row(row: Result, solved: SolvedJoint) -> list[int]:
    """Which rows of a result a joint has, by number."""
    count = 1 if row.axis == "one" else len(solved.row_names(row.axis))
    present = (True,) * count if row.present is None else row.present(solved)
    return [number for number, exists in enumerate(present) if exists]


def entries_of_search(solved: SolvedJoint, *, rolls: bool) -> list[LimitEntry]:
    """The limits of the search for slip, standing or in rolling, in the order of their excesses."""
    contacts, nowhere = len(solved.row_names("contact")), len(place_names(solved)) - 1
    prefix = _IN_ROLLING if rolls else ""
    return [
        LimitEntry(f"{prefix}{kind}", contact if contact < contacts else nowhere)
        for kind, contact in limits_of(solved.joint)
    ]


def entries_of_rows(solved: SolvedJoint, rows: Iterable[Result] = JUDGED_ROWS) -> list[LimitEntry]:
    """The limits of rows of a joint, in the order of :func:`excesses_of_rows`."""
    counts = [len(solved.row_names(axis)) for axis in PLACE_AXES]
    starts = dict(zip(PLACE_AXES, np.cumsum([0, *counts]).tolist(), strict=False))
    return [
        LimitEntry(row.name, starts[row.axis] + number if row.axis in starts else sum(counts))
        for row in _rows_of(solved, rows)
        for number in places_of_row(row, solved)
    ]


def _named(solved: SolvedJoint, limit: FirstLimit, entries: list[LimitEntry]) -> JointCapacity:
    nothing = LimitEntry("none", len(place_names(solved)) - 1)
    names, places = zip(nothing, *entries, strict=True)
    codes = [CAPACITY_LIMITS.index(name) for name in names]
    return JointCapacity(limit.value, entry_of(codes, 1 + limit.which), entry_of(places, 1 + limit.which))


def _of_numbers(solved: SolvedJoint) -> JointCapacity:
    """Both directions of one joint, of NumPy's numbers, whose slip is known: the rows are looked at below it."""
    solution, entries = solved.solution, entries_of_rows(solved)
    of_slip = (
        ((solution.first_slip, ""), (solution.rolling_capacity, _IN_ROLLING)),
        ((solution.reverse_first_slip, ""), (solution.reverse_rolling_capacity, _IN_ROLLING)),
    )
    slip = _stacked([_first_slip(*(_slip(solved, *way) for way in both)) for both in of_slip])
    if not entries:
        return slip
    rows = _named(solved, at_once(functools.partial(_limit_of_rows, solved), slip.output_torque), entries)
    return trees.map(lambda *ways: np.where(np.isfinite(rows.output_torque), *ways), rows, slip)


def _stacked(each: list[JointCapacity]) -> JointCapacity:
    return trees.map(lambda *ways: np.stack(ways), *each)


def _limit_of_rows(solved: SolvedJoint, slip: Array) -> FirstLimit:
    """Where the first row exceeds its limit below given torques, in both directions."""
    limits = _limits_under_torque(solved)
    return first_limit_of_numbers(
        excesses=of_each(lambda torque, sign: limits.of_rows(sign * torque), np.array([1.0, -1.0])),
        **_up_to(slip, limits.guess),
    )


def _slip(solved: SolvedJoint, capacity: TorqueCapacity, prefix: str) -> JointCapacity:
    """A capacity of the search for slip as one of all limits."""
    kind, contact = LIMIT_KINDS[int(capacity.limit)], int(capacity.limiting_contact)
    code = CAPACITY_LIMITS.index(kind if kind == "none" else f"{prefix}{kind}")
    place = contact if contact < len(solved.joint.drive.contacts) else len(place_names(solved)) - 1
    numbers: list[Any] = [np.asarray(number) for number in (capacity.output_torque, code, place)]
    return JointCapacity(*numbers)


def _first_slip(standing: JointCapacity, rolling: JointCapacity) -> JointCapacity:
    """Where a contact slips first, standing or in rolling."""
    first = float(standing.output_torque) * (1.0 - ALIKE) <= float(rolling.output_torque)
    return standing if first else rolling


def _up_to(slip: Any, guess: Any) -> Document:
    """Where the search for a limit of the rows begins, and how far it goes: to the torque at which a contact slips."""
    known = xp.isfinite(slip) & (slip > 0.0)
    return {
        "first_guess": xp.where(known, _BELOW * xp.where(known, slip, 1.0), guess),
        "farthest": xp.where(slip > 0.0, xp.where(known, 1.0, FARTHEST), 0.0),
    }


def _limits_under_torque(solved: SolvedJoint) -> LimitsUnderTorque:
    """The limits of a joint that is solved; what its duty does to its bearings is not that of another torque."""
    assert solved.laws is not None
    machine = joint_machine(without_duty(solved.joint), solved.laws.rims)
    return LimitsUnderTorque(machine, Pressed(solved.laws, solved.result.rest))


class LimitsUnderTorque:
    """By how much one joint exceeds its limits under other output torques [N·m]; each is what a joint of it has alone.

    ``guess``: torque of the right order. The machine has no duty.
    """

    def __init__(self, machine: JointMachine, without_torque: Pressed) -> None:
        self._machine, self._without_torque = machine, without_torque
        self.loaded = loading(machine, without_torque)
        self.guess = first_guess(machine.joint, without_torque.rest)

    def of_all(self, torque: Array) -> Array:
        """Limits of the search, standing and in rolling, then of the rows; every contact that stands holds."""
        standing, rolling, solved = self.under(torque)
        return xp.concatenate([standing.excesses, rolling.excesses, xp.asarray(excesses_of_rows(solved))])

    def of_rows(self, torque: Array) -> Array:
        """Limits of the rows alone."""
        return xp.asarray(excesses_of_rows(self.under(torque)[2]))

    def under(self, torque: Array) -> tuple[UnderTorque, UnderTorque, SolvedJoint]:
        """The joint under a torque, standing, every contact of which holds, and rolling; and its results there."""
        standing, rolling = _both(
            map_over(lambda rolls: self.loaded(torque, rolls, ~rolls), xp.array([False, True]))
        )
        pressed = None if self._machine.joint.cam is None else standing.pressed
        states = DriveStates(self._without_torque.rest, standing.state, rolling.state, pressed)
        there = self._machine.under(torque)
        result = joint_result(there, self._without_torque.laws, states)
        return standing, rolling, SolvedJoint(there.joint, result, self._without_torque.laws)


def _of_program(solved: SolvedJoint) -> JointCapacity:
    """Both directions of a joint inside a program, with derivatives."""
    limits = _limits_under_torque(solved)
    loaded, guess = limits.loaded, limits.guess
    at_rest, in_rolling = (entries_of_search(solved, rolls=rolls) for rolls in (False, True))
    before_rows = len(at_rest) + len(in_rolling)
    excesses = traced_once(limits.of_all)  # for the search and for the derivative

    def slip_of(given: tuple[Array, Array]) -> FirstLimit:
        """Where the first contact slips standing, or in rolling."""
        sign, rolls = given
        return searched_limit(
            excesses=lambda torque: loaded(sign * torque, rolls, ~rolls).excesses, first_guess=guess
        )

    def first_of(given: tuple[Array, FirstLimit]) -> FirstLimit:
        """The slip, unless a row exceeds its limit below it."""
        sign, slip = given
        rows = searched_limit(
            excesses=lambda torque: excesses(sign * torque)[before_rows:], **_up_to(slip.value, guess)
        )
        rows = rows._replace(which=before_rows + rows.which)
        first = trees.map(lambda *leaves: xp.where(xp.isfinite(rows.value), *leaves), rows, slip)
        return with_derivative(excesses=lambda torque: excesses(sign * torque), limit=first)

    ways = xp.array([1.0, -1.0])
    slips = map_over(slip_of, (xp.tile(ways, 2), xp.repeat(xp.array([False, True]), 2)))
    standing, rolling = _both(trees.map(lambda leaf: leaf.reshape(2, 2), slips))
    rolling = rolling._replace(which=xp.where(rolling.which < 0, -1, len(at_rest) + rolling.which))
    stands = standing.value * (1.0 - ALIKE) <= rolling.value
    slip = trees.map(lambda *leaves: xp.where(stands, *leaves), standing, rolling)
    entries = [*at_rest, *in_rolling, *entries_of_rows(solved)]
    return _named(solved, map_over(first_of, (ways, slip)), entries)


def _both(pair: Any) -> tuple[Any, Any]:
    """The two parts of arrays along their first axis."""
    first, second = (trees.map(lambda leaf, i=i: leaf[i], pair) for i in range(2))
    return first, second


def capacity_words(solved: SolvedJoint, capacity: JointCapacity) -> str:
    """What limits the torque capacity of one joint in one direction, and how: "contact sp slips, in rolling"."""
    limit = CAPACITY_LIMITS[int(capacity.limit)]
    if limit == "none":
        return kind_words(limit, "none")
    if limit == f"{_IN_ROLLING}no_solution":
        return "no steady rolling is found" + " without torque" * (float(capacity.output_torque) == 0.0)
    state, place = _state(solved, limit), int(capacity.place)
    if limit in LIMIT_KINDS or limit.startswith(_IN_ROLLING):
        contact = (*solved.row_names("contact"), "none")[min(place, len(solved.row_names("contact")))]
        said = kind_words(limit.removeprefix(_IN_ROLLING), contact)
    else:
        (row,) = (row for row in JUDGED_ROWS if row.name == limit)
        assert row.limit is not None
        where = place_words(solved, place)
        said = (
            f"{where} {row.limit.beyond}" if row.limit.beyond else f"{row.label} beyond its limit at {where}"
        )
    return f"{said} without torque" if float(capacity.output_torque) == 0.0 else f"{said}, {state}"


def _state(solved: SolvedJoint, limit: str) -> str:
    """Whether a limit is one of the joint that stands, or that rolls: loads are those of rolling where it turns."""
    works = "in rolling" if float(solved.joint.input_speed) != 0.0 else "standing"
    by_row = {row.name: row.value for row in JUDGED_ROWS}
    if limit in LIMIT_KINDS:
        return "standing"
    if limit not in by_row:
        return "in rolling"
    value = by_row[limit]
    if isinstance(value, str) and value.startswith("result."):
        return "in rolling" if only_in_rolling(limit) else "standing"
    return works


def only_in_rolling(limit: str) -> bool:
    """Whether a limit of :data:`CAPACITY_LIMITS` is one of the joint that rolls alone."""
    values = [row.value for row in JUDGED_ROWS if row.name == limit]
    of_rolling = [isinstance(value, str) and value.startswith("result.rolling.") for value in values]
    return limit.startswith(_IN_ROLLING) or any(of_rolling)


def place_words(solved: SolvedJoint, place: int) -> str:
    """A place by its code, in words, such as "contact sp" or "ring"."""
    for axis in PLACE_AXES:
        names = solved.row_names(axis)
        if place < len(names):
            name = names[place] if axis == "contact" else names[place].replace("_", " ")
            return name if axis == "body" else f"{axis} {name}"
        place -= len(names)
    return "the drive"


def torque_capacity_document(solved: SolvedJoint) -> Document:
    """The torque capacity of one joint in both directions as a part of its JSON document [N·m]."""
    forward, reverse = (_document(solved, torque_capacity(solved, reverse=way)) for way in (False, True))
    return {**forward, "reverse": reverse}


def _document(solved: SolvedJoint, capacity: JointCapacity) -> Document:
    torque, limit = float(capacity.output_torque), CAPACITY_LIMITS[int(capacity.limit)]
    place = place_names(solved)[int(capacity.place)]
    at_least = limit.removeprefix(_IN_ROLLING) in MODEL_LIMITS
    return {
        "output_torque_Nm": torque if math.isfinite(torque) else None,
        "limit": limit,
        "limiting_place": None if place == "none" else place,
        "state": None if limit == "none" else _state(solved, limit),
        "meaning": capacity_words(solved, capacity) + ("; the joint may carry more" if at_least else ""),
        "is_lower_bound": at_least,
    }
