"""The window of a joint: the output torques that it may pass over its working temperature, or over its preload."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from asperity.engine.arrays import xp
from asperity.results.limit_torques import (
    LIMITS,
    NOT_COMPUTED,
    NOT_PRESSED,
    REQUIRED_LIFE,
    SHOWN_ONLY,
    FirstReached,
    LimitSearch,
    LimitTorques,
    Ways,
)
from asperity.results.solved import SolvedJoint
from asperity.results.torque_capacity import (
    CAPACITY_LIMITS,
    JointCapacity,
    capacity_words,
    place_names,
    place_words,
)
from asperity.units import format_quantity

#: Places that are looked at between two neighbours where another limit governs, and how often.
_BETWEEN, _ROUNDS = 7, 2


@dataclass(frozen=True)
class WindowAxis:
    """What a window extends over.

    ``over``: ``temperature`` or ``preload``; ``key`` of the joint file that varies, ``label`` and display ``unit``;
    ``places``, shape (n,), rising, and the place of the ``working`` point [SI].
    """

    over: str
    key: str
    label: str
    unit: str
    places: np.ndarray
    working: float


@dataclass(frozen=True)
class Load:
    """A load that the joint has to pass: its name, torque at the output [N·m], and speed of the input [rad/s]."""

    name: str
    torque: float
    speed: float

    @property
    def stands(self) -> bool:
        """Whether the input stands: limits in rolling do not apply."""
        return self.speed == 0.0


@dataclass(frozen=True)
class Region:
    """What a joint may pass in one direction, over the axis.

    ``sign`` of the torque; ``capacity``, the first limit at every place; ``limits``: every limit; ``least`` and
    ``greatest`` capacity of parts within their tolerances, shape (n,) [N·m], None where the file states none.
    """

    sign: float
    capacity: FirstReached
    limits: LimitTorques
    least: np.ndarray | None
    greatest: np.ndarray | None


@dataclass(frozen=True)
class JudgedLoad:
    """A load, and what the joint may pass in its place at its speed, over the axis.

    ``capacity``: the first limit of its direction; ``inside``: whether the load is below it, at every place, and
    ``surely_inside``, whether with all parts within their tolerances; shape (n,).
    """

    load: Load
    capacity: FirstReached
    inside: np.ndarray
    surely_inside: np.ndarray


@dataclass(frozen=True)
class Window:
    """The window of a joint.

    ``at``: places of the axis, those asked for and those at which another limit governs, rising, shape (n,) [SI];
    ``asked``, which of them were asked for; ``preload``, mean normal force without torque [N], 0 where it is loose;
    ``regions`` of the direction of the file's torque and, where a load has the other one, of that; ``loads``;
    ``reference``: the joint, for the names of its parts; ``required_life`` [s]; ``has_tolerances`` of its preload.
    """

    axis: WindowAxis
    at: np.ndarray
    asked: np.ndarray
    preload: np.ndarray
    regions: tuple[Region, ...]
    loads: tuple[JudgedLoad, ...]
    reference: SolvedJoint
    required_life: float | None
    has_tolerances: bool

    @property
    def working(self) -> int:
        """Number of the place at which the joint works."""
        return int(np.flatnonzero(self.at == self.axis.working)[0])

    @property
    def place_names(self) -> tuple[str, ...]:
        """Names of the places at which a limit can be reached, by their codes."""
        return place_names(self.reference)

    def allowed(self, *, surely: bool = False) -> list[tuple[int, int]]:
        """Numbers of the first and last places of every stretch over which all loads lie inside."""
        kept = np.all([load.surely_inside if surely else load.inside for load in self.loads], axis=0)
        return stretches(kept)

    def words(self, reached: FirstReached, place: int) -> str:
        """What limits the torque at a place of the axis, for example "contact sp slips, in rolling"."""
        return self.limit_words(
            LIMITS[reached.limit[place]], int(reached.place[place]), float(reached.torque[place])
        )

    def limit_words(self, limit: str, place: int, torque: float) -> str:
        """The same of a limit by name, the code of its place, and the torque at which it is reached [N·m]."""
        without = " without torque" if torque == 0.0 else ""
        where = place_words(self.reference, place)
        if limit == REQUIRED_LIFE:
            assert self.required_life is not None
            whose = "the rating life" if where == "the drive" else f"the rating life of the {where}"
            thin = ", or an oil film is too thin for one" * (
                self.reference.joint.rolling.cleanliness is not None
            )
            return (
                f"{whose} falls below the required {format_quantity(self.required_life, 'h')}{thin}{without}"
            )
        if limit == NOT_PRESSED:
            return "no preload is left: the drive is loose"
        if limit == NOT_COMPUTED:
            return "a wall or a crowned contact is outside of what is computed"
        if limit in SHOWN_ONLY:
            return f"the {where} lifts off its housing between the rollers{without}"
        numbers = (torque, CAPACITY_LIMITS.index(limit), place)
        return capacity_words(self.reference, JointCapacity(*map(xp.asarray, numbers)))


def stretches(kept: np.ndarray) -> list[tuple[int, int]]:
    """First and last numbers of every run of true entries."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], kept, [False]]).astype(int)))
    return [(int(first), int(end) - 1) for first, end in zip(edges[::2], edges[1::2], strict=True)]


class _Way(NamedTuple):
    """One direction at one speed of the input [rad/s]."""

    sign: float
    speed: float


def window(
    axis: WindowAxis,
    search: LimitSearch,
    loads: Sequence[Load],
    *,
    has_tolerances: bool,
    report: Callable[[int, int], None] | None = None,
) -> Window:
    """The window of a joint over an axis, with places between those of the axis where another limit governs.

    The first load is that of the file: the regions hold at its speed. ``report`` takes the number of steps done, and
    of all.
    """
    own = _Way(_sign(loads[0], 1.0), loads[0].speed)
    of_loads = [_Way(_sign(load, own.sign), load.speed) for load in loads]
    signs = dict.fromkeys((own.sign, *(way.sign for way in of_loads)))
    ways = list(dict.fromkeys((*(_Way(sign, own.speed) for sign in signs), *of_loads)))
    shifts = (0.0, -1.0, 1.0) if has_tolerances else (0.0,)
    at = np.unique([*axis.places, axis.working])
    limits = _limits(search, ways, shifts, at)
    for done in range(1, 1 + _ROUNDS):
        if report is not None:
            report(done, 1 + _ROUNDS)
        judged = [_judged(load, limits, ways.index(way)) for load, way in zip(loads, of_loads, strict=True)]
        between = _between(at, _signature(limits, len(signs), judged))
        if not between.size:
            break
        order = np.argsort(np.concatenate([at, between]))
        at = np.concatenate([at, between])[order]
        limits = limits.joined(_limits(search, ways, shifts, between)).some(order)
    judged = [_judged(load, limits, ways.index(way)) for load, way in zip(loads, of_loads, strict=True)]
    kept = _kept(at, axis, _signature(limits, len(signs), judged))
    at, limits = at[kept], limits.some(kept)
    return Window(
        axis=axis,
        at=at,
        asked=np.isin(at, axis.places),
        preload=limits.preload[0, 0],
        regions=tuple(_region(limits, number, sign) for number, sign in enumerate(signs)),
        loads=tuple(
            _judged(load, limits, ways.index(way)) for load, way in zip(loads, of_loads, strict=True)
        ),
        reference=search.reference,
        required_life=search.required_life,
        has_tolerances=has_tolerances,
    )


def _sign(load: Load, otherwise: float) -> float:
    """Direction of a load; that of others where it has none."""
    return otherwise if load.torque == 0.0 else math.copysign(1.0, load.torque)


def _limits(
    search: LimitSearch, ways: Sequence[_Way], shifts: Sequence[float], at: np.ndarray
) -> LimitTorques:
    """Every limit in every way, at both ends of the tolerances, at every place: shape (limits, ways, shifts, n)."""
    grid = itertools.product(ways, shifts, at.tolist())
    rows = [(place, shift, way.sign, way.speed) for way, shift, place in grid]
    found = search.of(Ways(*np.array(rows, dtype=float).T))
    return found.reshaped((len(ways), len(shifts), len(at)))


def _region(limits: LimitTorques, way: int, sign: float) -> Region:
    every = limits.some(way, 0, slice(None))
    shifted = limits.some(way, slice(None), slice(None)).first().torque
    varies = len(shifted) > 1
    return Region(
        sign=sign,
        capacity=every.first(),
        limits=every,
        least=shifted.min(axis=0) if varies else None,
        greatest=shifted.max(axis=0) if varies else None,
    )


def _judged(load: Load, limits: LimitTorques, way: int) -> JudgedLoad:
    first = limits.some(way, slice(None), slice(None)).first(stands=load.stands)
    inside: np.ndarray = np.asarray(abs(load.torque) < first.torque)
    return JudgedLoad(load, FirstReached(*(part[0] for part in first)), inside[0], np.all(inside, axis=0))


def _signature(limits: LimitTorques, regions: int, judged: Sequence[JudgedLoad]) -> np.ndarray:
    """What is one and the same over a stretch of the axis: limits that govern, and loads inside; shape (m, n)."""
    first = limits.some(slice(regions), 0, slice(None)).first()
    governing = np.where(first.torque > 0.0, first.limit, -1)
    loads = [np.all([part(load) for load in judged], axis=0) for part in (_inside, _surely_inside)]
    return np.concatenate([governing, np.array(loads, dtype=int)])


def _inside(load: JudgedLoad) -> np.ndarray:
    return load.inside


def _surely_inside(load: JudgedLoad) -> np.ndarray:
    return load.surely_inside


def _between(at: np.ndarray, signature: np.ndarray) -> np.ndarray:
    """Places between neighbours of which not the same is true."""
    changes = np.flatnonzero(np.any(signature[:, 1:] != signature[:, :-1], axis=0))
    shares = np.arange(1, 1 + _BETWEEN) / (1 + _BETWEEN)
    return (at[changes, None] + shares * (at[changes + 1] - at[changes])[:, None]).ravel()


def _kept(at: np.ndarray, axis: WindowAxis, signature: np.ndarray) -> np.ndarray:
    """The places that were asked for, that of the working point, and those on both sides of a change."""
    changes = np.any(signature[:, 1:] != signature[:, :-1], axis=0)
    beside = np.concatenate([changes, [False]]) | np.concatenate([[False], changes])
    return np.flatnonzero(beside | np.isin(at, axis.places) | (at == axis.working))
