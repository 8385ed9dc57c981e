r"""The course of wear of one joint: from its first interference to the first contact that slides, and to nothing left.

The time is an integral over the interference of the drive, :math:`k t = \int d\delta/w(\delta)`. The rate w has a
root's slope where a contact begins to slide, and :math:`\delta = \delta_e + (\delta_0 - \delta_e)\,y^2` takes it
away. Where the drive feels more than one number, with unlike sectors, several self-stresses or crowns, the
interferences of all contacts follow along the same Gauss points, pass by pass (Picard's iteration), with many states
side by side.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

import numpy as np

from asperity.drive.state.state import STATE_TOLERANCE
from asperity.engine import trees
from asperity.engine.control import at_once, vectorised
from asperity.errors import NoSolutionError
from asperity.joint.capacity import limits_of
from asperity.rolling.wear_integral import PLACES, integral_from
from asperity.rolling.wear_rates import (
    MOST,
    Wearing,
    WearLoad,
    WearState,
    Worn,
    felt_interference,
    flat_excess,
    others_carry,
    unworn,
    wear_state,
)

#: Share of the interference above which nothing is left where no balance is found.
_ALL_BUT_GONE = 1.0 - 1e-3
#: By how much further a joint must still hold where one contact slides, relative to the interference that is left.
_FURTHER = 1e-4
#: Passes along the path of the contacts' interferences, and by how much the last one changes it, relative.
_PASSES, _SETTLED = 25, 1e-6
#: Change over the whole below which passes must stay, to the power of their number; halvings of a stage that does not.
_FALLING, _HALVINGS = 0.75, 8
#: What ends a part of a stage: nothing.
_GOES_ON = ""
_NEARLY = 1e-3  # change from which on the end of a stage is looked for anew
_LAST = 1e-3  # last bit of y, along whose slope a path goes on beyond its end
_FINEST = 2001  # points at which the time of a stage is tabled
#: Values at which the end of a stage is looked for at a time, rounds of the search, its last width over the whole;
#: least guess of it, how far beyond a guess it is looked for, and how near to where it was one pass before.
_LOOKS, _ROUNDS, _NARROW = 16, 60, 1e-10
_LEAST_GUESS, _BEYOND_GUESS, _NEAR = 1e-3, 1.25, 1e-3
#: Values around the root of the chord, in parts of what that may be off: many take hardly longer than one.
_AROUND = np.array([sign * 4.0**power for power in range(-4, 5) for sign in (-1.0, 1.0)])


class WearEnd(NamedTuple):
    """Where a stage of wear ends: wear coefficient times time [s/Pa], interference left [m], what, where, which load.

    ``kind`` of :data:`asperity.joint.torque_limits.LIMIT_KINDS`, "loose" where the whole interference is gone,
    "flat" where a crown is; ``contact`` and ``load`` are numbers, -1 for none.
    """

    coefficient_time: float
    interference: float
    kind: str
    contact: int
    load: int


class WearStage(NamedTuple):
    """Wear while the same contacts slide.

    ``lost``: interference of the drive that wear has taken, rising, shape (n,) [m]; at each of them
    ``coefficient_time`` [s/Pa], ``worn`` off the contacts, and ``depth`` of the tracks, shape (n, 2, contacts) [m].
    ``sliding``: signs of the contacts that slide under each load, shape (loads, contacts) [-].
    """

    lost: np.ndarray
    coefficient_time: np.ndarray
    worn: Worn
    depth: np.ndarray
    sliding: np.ndarray


class WornCourse(NamedTuple):
    """Stages of wear with their ends; ``carries_on``: whether the joint may do more than the last one says."""

    stages: tuple[WearStage, ...]
    ends: tuple[WearEnd, ...]
    carries_on: bool


def states_at(wearing: Wearing, worn: Worn, loads: WearLoad) -> WearState:
    """The joint at states of wear, shape (n, ...), under all loads, shape (loads, ...).

    Numbers of shape (n, loads, ...).
    """
    count, each = len(worn.interference), len(loads.share)
    states: Worn = trees.map(lambda leaf: np.repeat(np.asarray(leaf), each, axis=0), worn)
    under: WearLoad = trees.map(lambda leaf: np.tile(leaf, (count, *(1,) * (leaf.ndim - 1))), loads)

    def over_all(wearing: Wearing, states: Worn, under: WearLoad) -> WearState:
        return vectorised(lambda *given: wear_state(wearing, *given))(states, under)

    found: WearState = at_once(over_all, wearing, states, under)
    return trees.map(lambda leaf: leaf.reshape(count, each, *leaf.shape[1:]), found)


def worn_course(wearing: Wearing, loads: WearLoad) -> WornCourse:
    """Wear of a joint that loses its interference, from the first state to the last that carries every load.

    The first state carries them. ``loads`` of shape (loads,), no contact sliding.
    """
    lost, state = 0.0, unworn(wearing)
    time, depth = 0.0, np.zeros((2, len(wearing.machine.drive.contacts)))
    stages: list[WearStage] = []
    ends: list[WearEnd] = []
    here = states_at(wearing, state, loads)
    whole = float(here.interference[0, 0])
    while True:
        start = _Start(lost, whole, state, time, depth, here)
        stage, kind, contact, load = _stage(wearing, loads, start)
        stages.append(stage)
        lost, time = float(stage.lost[-1]), float(stage.coefficient_time[-1])
        state, depth = trees.map(lambda leaf: leaf[-1:], stage.worn), stage.depth[-1]
        here = states_at(wearing, state, loads)
        if kind == _GOES_ON:
            continue
        ends.append(WearEnd(time, whole - lost, kind, contact, load))
        if kind != "gross_slip":
            return WornCourse(tuple(stages), tuple(ends), _is_followed(wearing, kind))
        sliding = loads.sliding.copy()
        sliding[load, contact] = np.sign(here.tangential[0, load, contact])
        loads = loads._replace(sliding=sliding)
        if _has_other_friction(wearing):
            others = others_carry(wearing.machine.drive, contact)
            return WornCourse(tuple(stages), tuple(ends), carries_on=others)
        here = _further(wearing, state, loads, whole - lost)
        if not (np.all(here.worst < STATE_TOLERANCE) and np.all(here.excesses < 0.0)):
            return WornCourse(tuple(stages), tuple(ends), carries_on=False)


def _is_followed(wearing: Wearing, kind: str) -> bool:
    """Whether a joint works on beyond what is computed: a crown that is worn flat, and a cam without interference."""
    return kind == "flat" or (kind == "loose" and wearing.machine.joint.cam is not None)


def _has_other_friction(wearing: Wearing) -> bool:
    """Whether a contact that slides bears something else than its friction."""
    rolling = wearing.machine.joint.rolling
    return rolling.skew is not None or rolling.lubricant is not None


class _Start(NamedTuple):
    """Where a stage begins: interference lost, the whole of it [m], what is worn, k t [s/Pa], depths [m], the state."""

    lost: float
    whole: float
    worn: Worn
    time: float
    depth: np.ndarray
    state: WearState


def _further(wearing: Wearing, worn: Worn, loads: WearLoad, left: float) -> WearState:
    """The joint a little beyond a state of wear, with other contacts that slide."""
    pattern = np.asarray(wearing.machine.joint.pattern)
    return states_at(wearing, Worn(worn.interference + _FURTHER * left * pattern, worn.curvature), loads)


def _duty_mean(values: np.ndarray, loads: WearLoad) -> np.ndarray:
    """Mean over the loads by their shares of the time, of numbers of shape (n, loads, ...)."""
    return np.tensordot(np.moveaxis(values, 1, -1), loads.share, axes=1)


_Stage = tuple[WearStage, str, int, int]


def _stage(wearing: Wearing, loads: WearLoad, start: _Start) -> _Stage:
    """One stage with what ends it, or a part of it; equation (W4)."""
    room = MOST * (start.whole - start.lost)
    for halvings in range(_HALVINGS):
        found = _settled_stage(wearing, loads, start, room / 2.0**halvings, whole=halvings == 0)
        if found is not None:
            return found
    raise NoSolutionError(
        "the interferences of the contacts do not settle over their wear; state smaller deviations, other crown "
        "radii (none, where they are nearly flat), or a smaller torque"
    )


def _settled_stage(
    wearing: Wearing, loads: WearLoad, start: _Start, room: float, *, whole: bool
) -> _Stage | None:
    """A stage up to a loss of interference [m], ``whole`` of what is left or a part; None where it does not settle.

    The path of the contacts' interferences over that of the drive is taken straight first, then along its slopes, until
    it stays: at once where the drive feels one number.
    """
    path, length, end = _straight(wearing, loads, start), room, None
    looks = _ahead(_guess(start), room)
    change = 0.0
    for number in range(_PASSES):
        if change < _NEARLY:
            end = _first_excess(partial(_excesses_along, wearing, path, loads), room, looks)
            length = room if end is None else end[0]
            looks = np.minimum(length * (1.0 + _AROUND * _NEAR), room)
        before = path(length * (1.0 - PLACES**2))
        state = states_at(wearing, before, loads)
        per_y = 2.0 * length * PLACES / _duty_mean(state.drive_rate, loads)
        taken = _Taken(wearing, start, length, per_y, state, loads)
        path = taken.path
        change, last = _change(before, path(length * (1.0 - PLACES**2)), length, wearing), change
        if change < _SETTLED and last < _NEARLY:
            if end is not None:
                named = _named(wearing, len(loads.share), end[1])
                gone = named[0] == "no_solution" and length > _ALL_BUT_GONE * room
                return taken.stage(), *(("loose", -1, -1) if gone and whole else named)
            return taken.stage(), "loose" if whole else _GOES_ON, -1, -1
        if not change < _FALLING**number:
            return None
    return None


def _straight(wearing: Wearing, loads: WearLoad, start: _Start) -> Callable[[np.ndarray], Worn]:
    """States of wear over the interference that the drive has lost since the start, at the slopes of the start."""
    slopes = _slopes(wearing, start.state, loads) / _duty_mean(start.state.drive_rate, loads)[:, None]

    def path(lost: np.ndarray) -> Worn:
        return _worn(start, np.asarray(lost)[:, None] * slopes)

    return path


def _slopes(wearing: Wearing, state: WearState, loads: WearLoad) -> np.ndarray:
    """Rates of what the drive feels: interferences of the contacts, then curvatures of crowns, shape (n, numbers)."""
    felt = _duty_mean(state.rates.interference, loads) @ felt_interference(wearing.machine).T
    if state.rates.curvature is None:
        return felt
    return np.concatenate([felt, _duty_mean(state.rates.curvature, loads)], axis=1)


def _worn(start: _Start, change: np.ndarray) -> Worn:
    """States of wear by what has changed since the start, shape (n, numbers)."""
    contacts = start.worn.interference.shape[1]
    curvature = start.worn.curvature
    return Worn(
        start.worn.interference + change[:, :contacts],
        None if curvature is None else curvature + change[:, contacts:],
    )


class _Taken:
    """What wear takes in one stage, from rates at its Gauss points; interference lost is length times 1 − y²."""

    def __init__(
        self,
        wearing: Wearing,
        start: _Start,
        length: float,
        per_y: np.ndarray,
        state: WearState,
        loads: WearLoad,
    ) -> None:
        slopes = _slopes(wearing, state, loads)
        depths = _duty_mean(state.depth, loads).reshape(len(per_y), -1)
        every = np.concatenate([np.ones((len(per_y), 1)), depths, slopes], axis=1)
        self._start, self._length, self._loads = start, length, loads
        self._numbers = 1 + depths.shape[1]
        self._per_y = per_y[:, None] * every

    def _from(self, y: np.ndarray) -> np.ndarray:
        """Time, depths and what is worn off until y, shape (n, numbers)."""
        return np.asarray(integral_from(y, self._per_y))

    def path(self, lost: np.ndarray) -> Worn:
        """States of wear over the interference lost since the start; beyond the end as at its last bit."""
        left = 1.0 - np.asarray(lost) / self._length
        inside = self._from(np.sqrt(np.maximum(left, 0.0)))[:, self._numbers :]
        last = self._from(np.array([_LAST, 0.0]))[:, self._numbers :]
        beyond = np.maximum(-left, 0.0)[:, None] * (last[1] - last[0]) / _LAST**2
        return _worn(self._start, inside + beyond)

    def stage(self) -> WearStage:
        """The stage, over evenly spaced y."""
        start, fine = self._start, np.linspace(1.0, 0.0, _FINEST)
        taken = self._from(fine)
        return WearStage(
            lost=start.lost + self._length * (1.0 - fine**2),
            coefficient_time=start.time + taken[:, 0],
            worn=_worn(start, taken[:, self._numbers :]),
            depth=start.depth + taken[:, 1 : self._numbers].reshape(_FINEST, *start.depth.shape),
            sliding=self._loads.sliding,
        )


def _change(before: Worn, after: Worn, length: float, wearing: Wearing) -> float:
    """By how much two paths of wear differ, over the interference of the stage and the largest crown [-]."""
    change = float(np.max(np.abs(after.interference - before.interference))) / length
    if after.curvature is None or before.curvature is None:
        return change
    crowns = np.max(np.asarray(wearing.machine.contacts.crown_curvature))
    return max(change, float(np.max(np.abs(after.curvature - before.curvature)) / crowns))


def _excesses(wearing: Wearing, worn: Worn, loads: WearLoad) -> np.ndarray:
    """Excesses of all limits under all loads, one after the other, then of crowns worn flat, shape (n, limits) [-]."""
    found = states_at(wearing, worn, loads).excesses
    found = np.where(np.isnan(found), -1.0, found).reshape(len(found), -1)
    if worn.curvature is None:
        return found
    flat = np.asarray(flat_excess(wearing.machine, worn.curvature))
    return np.concatenate([found, flat], axis=1)


def _excesses_along(
    wearing: Wearing, path: Callable[[np.ndarray], Worn], loads: WearLoad, lost: np.ndarray
) -> np.ndarray:
    """The same along a path, over the interference lost since the start of the stage, shape (n,) [m]."""
    return _excesses(wearing, path(lost), loads)


def _named(wearing: Wearing, loads: int, which: int) -> tuple[str, int, int]:
    """Kind, contact and load of a limit by its number in :func:`_excesses`."""
    entries, contacts = limits_of(wearing.machine.joint), len(wearing.machine.drive.contacts)
    load, place = divmod(which, len(entries))
    if load >= loads:
        return "flat", place, -1
    kind, contact = entries[place]
    return kind, contact if contact < contacts else -1, load


def _guess(start: _Start) -> float:
    """About how much interference may go until a contact slides: forces are taken in proportion to what is left [m]."""
    worst = float(np.nanmax(start.state.excesses))
    return max(-worst, _LEAST_GUESS) * (start.whole - start.lost)


def _ahead(guess: float, most: float) -> np.ndarray:
    """Values up to somewhat beyond a guess, at which the end of a stage is looked for first."""
    return np.minimum(_BEYOND_GUESS * guess, most) * np.arange(1, _LOOKS + 1) / _LOOKS


def _first_excess(
    excesses: Callable[[np.ndarray], np.ndarray], most: float, looks: np.ndarray
) -> tuple[float, int] | None:
    """Where the first of several limits is reached between 0, where none is, and ``most``, and which; None for none.

    ``excesses`` of values, shape (n,), have the shape (n, limits). Several values are looked at side by side: those
    given, evenly beyond them while none reaches a limit, and then around the root of the chord.
    """
    lower, upper, below, above, which = 0.0, most, -1.0, np.inf, -1
    trials = np.unique(looks[looks > 0.0])
    for _ in range(_ROUNDS):
        found = excesses(trials)
        largest = found.max(axis=1)
        reached = np.flatnonzero(largest >= 0.0)
        if reached.size:
            first = reached[0]
            upper, above, which = trials[first], largest[first], int(np.argmax(found[first]))
        last = (reached[0] if reached.size else trials.size) - 1
        if last >= 0:
            lower, below = trials[last], largest[last]
        if which < 0:
            if lower >= most:
                return None
            further = np.minimum(2.0 * lower, most) - lower
            trials = lower + further * np.arange(1, _LOOKS + 1) / _LOOKS
            continue
        width = upper - lower
        if width <= _NARROW * most:
            break
        chord = lower - below * width / (above - below)
        off = max(0.2 * width**2 / most, 0.2 * _NARROW * most)
        around = np.clip(chord + off * _AROUND, lower, upper)
        trials = np.unique(np.concatenate([around, np.linspace(lower, upper, 6)]))
        trials = trials[(trials > lower) & (trials < upper)]
    return lower, which
