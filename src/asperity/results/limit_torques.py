"""The torque at which each limit of a joint is reached, of many joints at once: of one over temperature or preload."""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from asperity.drive.state.first_limit import SMALLEST_SHARE, FirstLimit, first_limit_of_numbers
from asperity.drive.state.state import STATE_TOLERANCE
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import at_once, vectorised
from asperity.joint.assembled import Pressed, assembled
from asperity.joint.capacity import first_guess, loading
from asperity.joint.description import Joint, without_duty
from asperity.joint.evaluation import joint_result, states_under_torque
from asperity.joint.loading_cam import mean_preload
from asperity.joint.machine import JointMachine, joint_machine
from asperity.results import RESULTS, Result
from asperity.results.all_limits import film_too_thin, required_life_row
from asperity.results.solved import SolvedJoint
from asperity.results.torque_capacity import (
    ALIKE,
    CAPACITY_LIMITS,
    JUDGED_ROWS,
    LimitEntry,
    LimitsUnderTorque,
    entries_of_rows,
    entries_of_search,
    excesses_of_rows,
    only_in_rolling,
    place_names,
)
from asperity.types import Array

#: Limits of a joint that no torque reaches: it is loose, or not computed, and passes none.
NOT_PRESSED, NOT_COMPUTED = "not_pressed", "not_computed"
#: The life that a file requires, of the drive or of a bearing.
REQUIRED_LIFE = "required_life"
#: Limits that are shown, but do not end a torque capacity: beyond them the joint is softer than computed.
SHOWN_ONLY = ("seat_pressure",)
#: All of them, with those of a torque capacity, by their codes.
LIMITS = (*CAPACITY_LIMITS, *SHOWN_ONLY, REQUIRED_LIFE, NOT_PRESSED, NOT_COMPUTED)

#: Joints that are computed side by side: more take as long for each, and more memory.
_BLOCK = 48
#: Share of the torque at which a contact slips up to which rows are looked at: at it, their states need not exist.
_BELOW = 1.0 - 1e-9
#: Shares of it at which they are looked at first, and multiples of the first guess where nothing slips at any torque.
_SHARES = np.array([SMALLEST_SHARE, 1.0 / 3.0, 2.0 / 3.0, 1.0])
_DOUBLINGS = np.array([SMALLEST_SHARE, 1.0, 2.0**10, 2.0**39])


@dataclass(frozen=True)
class Ways:
    """Joints, and in which way each is loaded; arrays of one shape (n,).

    ``at`` and ``shift``: where on the axis, and at which end of its tolerances, −1 to 1; ``sign`` of the torque;
    ``speed`` of the input [rad/s].
    """

    at: np.ndarray
    shift: np.ndarray
    sign: np.ndarray
    speed: np.ndarray

    @property
    def parts(self) -> tuple[np.ndarray, ...]:
        """These arrays, in their order."""
        return self.at, self.shift, self.sign, self.speed


@dataclass(frozen=True)
class LimitTorques:
    """Torques at which joints reach their limits, as positive numbers; arrays of shape (limits, ...).

    ``torque`` [N·m] is infinite where a limit is not reached before a contact slips, 0 where it is crossed without
    torque; ``limit``: its code in :data:`LIMITS`; ``place``: that of
    :func:`~asperity.results.torque_capacity.place_names`. ``preload``: mean normal force without torque, shape (...)
    [N], 0 where not every contact is pressed.
    """

    torque: np.ndarray
    limit: np.ndarray
    place: np.ndarray
    preload: np.ndarray

    def first(self, *, stands: bool = False) -> FirstReached:
        """The smallest of these torques, and which limit it is; ``stands``: without limits of rolling."""
        counts = [name not in SHOWN_ONLY and not (stands and only_in_rolling(name)) for name in LIMITS]
        torque = np.where(np.array(counts)[self.limit], self.torque, np.inf)
        # of two alike the joint that stands is named, as by the torque capacity
        which = np.argmin(np.concatenate([torque[:1] * (1.0 - ALIKE), torque[1:]]), axis=0)[None]
        first, limit, place = (
            np.take_along_axis(part, which, axis=0)[0] for part in (torque, self.limit, self.place)
        )
        return FirstReached(first, np.where(np.isfinite(first), limit, LIMITS.index("none")), place)

    def reshaped(self, shape: tuple[int, ...]) -> LimitTorques:
        """The same joints in another shape."""
        torque, limit, place = (part.reshape(-1, *shape) for part in (self.torque, self.limit, self.place))
        return LimitTorques(torque, limit, place, self.preload.reshape(shape))

    def joined(self, other: LimitTorques) -> LimitTorques:
        """These joints and others, along the last axis."""
        return self._each(other, lambda mine, its: np.concatenate([mine, its], axis=-1))

    def some(self, *numbers: int | slice | np.ndarray) -> LimitTorques:
        """Some of the joints, by their numbers along the last axes."""
        return self._each(self, lambda part, _: part[(..., *numbers)])

    def _each(
        self, other: LimitTorques, function: Callable[[np.ndarray, np.ndarray], np.ndarray]
    ) -> LimitTorques:
        """A function of each of the arrays of two of them."""
        return LimitTorques(
            function(self.torque, other.torque),
            function(self.limit, other.limit),
            function(self.place, other.place),
            function(self.preload, other.preload),
        )


class FirstReached(NamedTuple):
    """The first limit of joints: its torque [N·m], its code in :data:`LIMITS`, and that of its place; shape (...)."""

    torque: np.ndarray
    limit: np.ndarray
    place: np.ndarray


class _Assembled(NamedTuple):
    """Joints at their speeds, assembled, side by side.

    ``machine`` has the duty of the joint, ``bare`` has none; ``guess``: torque of the right order [N·m]; ``pressed``
    and ``computed``: whether every contact is pressed, and walls and slices are within what is computed.
    """

    machine: JointMachine
    bare: JointMachine
    without_torque: Pressed
    sign: Array
    guess: Array
    preload: Array
    pressed: Array
    computed: Array

    def some(self, numbers: np.ndarray) -> _Assembled:
        """Some of many joints."""
        chosen: _Assembled = trees.map(lambda leaf: leaf[numbers], self)
        return chosen


@dataclass(frozen=True)
class LimitSearch:
    """The search for the limits of joints that differ in numbers, all side by side.

    ``joint_at`` gives the joint at a place of the axis and an end of its tolerances, with its duty; pure. ``reference``
    is one of them, solved, for the names of its parts. ``required_life`` [s]: None where none is required; under a duty
    the life is that under the whole duty, scaled so that the largest of its torques in each direction,
    ``duty_torque`` [N·m], is the torque that is looked at.
    """

    joint_at: Callable[[Array, Array], Joint]
    reference: SolvedJoint
    required_life: float | None
    duty_torque: tuple[float, float]

    def of(self, ways: Ways) -> LimitTorques:
        """The torques at which every limit is reached."""
        blocks = range(0, ways.at.size, _BLOCK)
        found = [self._of_block(Ways(*(part[n : n + _BLOCK] for part in ways.parts))) for n in blocks]
        return functools.reduce(LimitTorques.joined, found)

    def _of_block(self, ways: Ways) -> LimitTorques:
        """The same of as many joints as are computed side by side."""
        joints: _Assembled = at_once(vectorised(self._assembled), *ways.parts)
        pressed, computed = np.asarray(joints.pressed), np.asarray(joints.computed)
        passes = pressed & computed
        slips = [(_slip(joints, rolls=rolls), rolls) for rolls in (False, True)]
        found = [
            _named(first, passes, entries_of_search(self.reference, rolls=rolls)) for first, rolls in slips
        ]
        nowhere = len(place_names(self.reference)) - 1
        standing, rolling = (np.asarray(first.value) for first, _ in slips)
        lowest = np.where(passes, np.fmin(standing, rolling), 0.0)
        for name, closed in ((NOT_PRESSED, ~pressed), (NOT_COMPUTED, pressed & ~computed)):
            found.append(_closed(name, closed, nowhere))
        found += self._below_slip(self._rows, joints, lowest)
        found += self._of_lives(ways, joints, lowest)
        torque, limit, place = (np.stack(columns) for columns in zip(*found, strict=True))
        return LimitTorques(torque, limit, place, np.where(pressed, np.asarray(joints.preload), 0.0))

    @functools.cached_property
    def _rows(self) -> _Rows:
        """The rows that are judged or shown at every torque."""
        rows = (*JUDGED_ROWS, *(RESULTS[name] for name in SHOWN_ONLY))
        return _Rows(rows, tuple(entries_of_rows(self.reference, rows)), _under_torque)

    @functools.cached_property
    def _lives(self) -> _Rows:
        """The lives that are required, as rows with their limits."""
        lives: tuple[str, ...] = ()
        if self.required_life is not None:
            lives = ("duty_life", "bearing_duty_life") if self._has_duty else ("drive_life", "bearing_life")
        rows = tuple(required_life_row(name, self.required_life or math.nan, "", "") for name in lives)
        entries = [entry._replace(limit=REQUIRED_LIFE) for entry in entries_of_rows(self.reference, rows)]
        under = self._under_duty if self._has_duty else _under_torque
        return _Rows(rows, tuple(entries), under, of_lives=True)

    @property
    def _has_duty(self) -> bool:
        return bool(self.reference.joint.rolling.duty)

    def _of_lives(self, ways: Ways, joints: _Assembled, slip: np.ndarray) -> list[_Column]:
        """Where the lives reach what is required; those under a duty once for all speeds: it has its own."""
        if not self._has_duty:
            return self._below_slip(self._lives, joints, slip)
        alike = np.stack([ways.at, ways.shift, ways.sign], axis=1)
        _, first, each = np.unique(alike, axis=0, return_index=True, return_inverse=True)
        each = each.ravel()
        highest = np.zeros(first.size)
        np.maximum.at(highest, each, np.where(np.where(ways.sign > 0.0, *self.duty_torque) > 0.0, slip, 0.0))
        found = self._below_slip(self._lives, joints.some(first), highest)
        return [(torque[each], limit[each], place[each]) for torque, limit, place in found]

    def _assembled(self, at: Array, shift: Array, sign: Array, speed: Array) -> _Assembled:
        """One joint at a speed, assembled."""
        machine = joint_machine(dataclasses.replace(self.joint_at(at, shift), input_speed=speed))
        bare = dataclasses.replace(machine, joint=without_duty(machine.joint))
        pressed = assembled(bare)
        rest, guess = pressed.rest, xp.asarray(first_guess(machine.joint, pressed.rest), dtype=float)
        standing = LimitsUnderTorque(bare, pressed).under(sign * SMALLEST_SHARE * guess)[2].result
        slices = standing.diagnostics.slices_hold
        return _Assembled(
            machine=machine,
            bare=bare,
            without_torque=pressed,
            sign=sign,
            guess=guess,
            preload=mean_preload(machine.joint, rest.normal),
            pressed=(rest.worst < STATE_TOLERANCE) & xp.all(rest.normal > 0.0),
            computed=standing.walls_hold & (True if slices is None else xp.all(slices)),
        )

    def _under_duty(self, joint: _Assembled, torque: Array) -> SolvedJoint:
        """One joint under its duty, scaled so that the largest torque of its direction is a torque."""
        machine, pressed = joint.machine, joint.without_torque
        scale = torque / xp.where(joint.sign > 0.0, *self.duty_torque)
        scaled = tuple(
            dataclasses.replace(point, output_torque=scale * xp.asarray(point.output_torque))
            for point in machine.joint.rolling.duty
        )
        rolling = dataclasses.replace(machine.joint.rolling, duty=scaled)
        loaded = dataclasses.replace(machine.joint, rolling=rolling, output_torque=joint.sign * torque)
        there = dataclasses.replace(machine, joint=loaded)
        result = joint_result(there, pressed.laws, states_under_torque(there, pressed))
        return SolvedJoint(there.joint, result, pressed.laws)

    def _below_slip(self, rows: _Rows, joints: _Assembled, slip: np.ndarray) -> list[_Column]:
        """Where rows reach their limits below the torques at which joints slip; not looked at where that is 0."""
        names, of_entry = rows.groups
        torque = np.full((len(names), slip.size), np.inf)
        place = np.full(torque.shape, len(place_names(self.reference)) - 1)
        some = np.flatnonzero(slip > 0.0)
        if names and some.size:
            known = np.isfinite(slip[some])
            top = np.where(known, _BELOW * np.where(known, slip[some], 1.0), joints.guess[some])
            looks = np.where(known, _SHARES[:, None], _DOUBLINGS[:, None]) * top
            excess = at_once(_of_each(rows.excesses, joints.some(some)), looks)
            searched: list[tuple[int, int, float]] = []
            for group in range(len(names)):
                beyond = excess[of_entry == group] >= 0.0
                places = [entry.place for entry in rows.entries if entry.limit == names[group]]
                for joint in np.flatnonzero(beyond.any(axis=(0, 1))):
                    look = int(np.argmax(beyond[:, :, joint].any(axis=0)))
                    torque[group, some[joint]] = 0.0
                    place[group, some[joint]] = places[int(np.argmax(beyond[:, look, joint]))]
                    if look:
                        searched.append((group, int(some[joint]), float(looks[look, joint])))
            if searched:
                groups, of, starts = (np.array(column) for column in zip(*searched, strict=True))
                found = at_once(rows.first_reached, joints.some(of), groups.astype(float), starts)
                torque[groups, of] = found.value
                place[groups, of] = [rows.entries[which].place for which in found.which]
        limits = [np.full(slip.size, LIMITS.index(name)) for name in names]
        return list(zip(torque, limits, place, strict=True))


def _of_each(
    function: Callable[..., Array], joints: _Assembled, *given: np.ndarray
) -> Callable[[np.ndarray], np.ndarray]:
    """A function of one joint and a torque, shape (limits,), as one of several torques of each of many joints.

    ``given``: further arguments, a number for each joint.
    """
    each = vectorised(function)

    def of_all(torques: np.ndarray) -> np.ndarray:
        def again(leaf: np.ndarray) -> np.ndarray:
            return np.tile(leaf, (len(torques), *(1,) * (leaf.ndim - 1)))

        every, *numbers = trees.map(again, (joints, *given))
        found: np.ndarray = each(every, torques.ravel(), *numbers)
        return found.T.reshape(-1, *torques.shape)

    return of_all


def _slip(joints: _Assembled, *, rolls: bool) -> FirstLimit:
    """Where a contact of many joints slips first, standing, where every contact holds, or in rolling."""

    def excesses(joint: _Assembled, torque: Array) -> Array:
        return loading(joint.bare, joint.without_torque)(joint.sign * torque, rolls, not rolls).excesses

    def search(joints: _Assembled) -> FirstLimit:
        return first_limit_of_numbers(excesses=_of_each(excesses, joints), first_guess=joints.guess)

    found: FirstLimit = at_once(search, joints)
    return found


def _under_torque(joint: _Assembled, torque: Array) -> SolvedJoint:
    """One joint under a torque, without its duty."""
    return LimitsUnderTorque(joint.bare, joint.without_torque).under(joint.sign * torque)[2]


@dataclass(frozen=True)
class _Rows:
    """Rows with limits, their ``entries`` in the order of the excesses, and what one joint is under a torque [N·m].

    ``of_lives``: whether they are lives, of which a film too thin for any keeps none.
    """

    rows: tuple[Result, ...]
    entries: tuple[LimitEntry, ...]
    under: Callable[[_Assembled, Array], SolvedJoint]
    of_lives: bool = False

    @functools.cached_property
    def groups(self) -> tuple[list[str], np.ndarray]:
        """Names of the limits, and to which of them each entry belongs."""
        names = list(dict.fromkeys(entry.limit for entry in self.entries))
        return names, np.array([names.index(entry.limit) for entry in self.entries], dtype=int)

    def excesses(self, joint: _Assembled, torque: Array) -> Array:
        """By how much one joint exceeds the limits under a torque [N·m]."""
        solved = self.under(joint, torque)
        excesses = xp.asarray(excesses_of_rows(solved, self.rows))
        return xp.where(film_too_thin(solved), xp.inf, excesses) if self.of_lives else excesses

    def first_reached(self, joints: _Assembled, groups: np.ndarray, starts: np.ndarray) -> FirstLimit:
        """Where each of many joints reaches a limit of a group, below a torque at which it is crossed [N·m]."""
        of_entry = self.groups[1].astype(float)

        def excesses(joint: _Assembled, torque: Array, group: Array) -> Array:
            return xp.where(xp.asarray(of_entry) == group, self.excesses(joint, torque), -1.0)

        return first_limit_of_numbers(
            excesses=_of_each(excesses, joints, groups), first_guess=xp.asarray(starts), farthest=1.0
        )


_Column = tuple[np.ndarray, np.ndarray, np.ndarray]


def _closed(name: str, closed: np.ndarray, nowhere: int) -> _Column:
    """A limit that lets some joints pass no torque at all."""
    return (
        np.where(closed, 0.0, np.inf),
        np.full(closed.size, LIMITS.index(name)),
        np.full(closed.size, nowhere),
    )


def _named(found: FirstLimit, passes: np.ndarray, entries: list[LimitEntry]) -> _Column:
    """What a search for slip has found of the joints that pass any torque, with the codes of limits and places."""
    torque = np.where(passes & ~np.isnan(found.value), found.value, np.inf)
    limit = np.array([LIMITS.index(name) for name in ("none", *(entry.limit for entry in entries))])
    place = np.array([entries[-1].place, *(entry.place for entry in entries)])
    return torque, limit[1 + found.which], place[1 + found.which]
