"""The plan of a sweep: joint file, axes and results, and the division of its grid into blocks."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import AnyCase, Values, si_values
from asperity.results import Result, chosen_results
from asperity.study.batch import evaluate_points
from asperity.study.parameters import SweepAxis, check_axes
from asperity.types import Document

#: Attribute of a dataset or a store with the sweep that it belongs to, as JSON.
PLAN = "asperity_sweep"
#: Points of one block; a block is computed, written and, after an interruption, repeated as a whole.
BLOCK_POINTS = 250_000
#: Numbers of one block: 64 MB of them, so that many results make the blocks smaller.
_BLOCK_NUMBERS = 8_000_000


@dataclass(frozen=True)
class Plan:
    """A sweep as plain data; it can be pickled and is stored with the results.

    ``values`` are the tables of the joint file in SI units; each of ``axes`` is a dimension; ``results`` are names of
    :func:`asperity.joint_file.any_joint.results_of`; ``block_shape`` is the number of points of a block along each
    axis.
    """

    values: Values
    axes: tuple[SweepAxis, ...]
    results: tuple[str, ...]
    block_shape: tuple[int, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """Points along each axis."""
        return tuple(axis.count for axis in self.axes)

    @property
    def points(self) -> int:
        """Points of the whole grid."""
        return math.prod(self.shape)

    @property
    def block_count(self) -> int:
        """Number of blocks."""
        return math.prod(self._block_grid)

    @property
    def _block_grid(self) -> tuple[int, ...]:
        return tuple(-(-count // step) for count, step in zip(self.shape, self.block_shape, strict=True))

    def block(self, index: int) -> tuple[slice, ...]:
        """Part of each axis where a block lies in the grid, by its number, the last axis running fastest."""
        return tuple(
            slice(place * step, min((place + 1) * step, count))
            for place, step, count in zip(self.block_place(index), self.block_shape, self.shape, strict=True)
        )

    def block_place(self, index: int) -> tuple[int, ...]:
        """Which block it is along each axis, from 0; the last axis runs fastest."""
        return tuple(int(place) for place in np.unravel_index(index, self._block_grid))

    @property
    def rows(self) -> tuple[Result, ...]:
        """The rows of the table of results that are computed."""
        table = results_of(self.values)
        return tuple(table[name] for name in self.results)

    @property
    def bytes(self) -> int:
        """Size of all results in memory, and about their size on disk."""
        return self.points * (1 + 8 * sum(len(row.row_names) for row in self.rows))

    def as_dict(self) -> Document:
        """Everything that the results depend on, as plain data."""
        return json.loads(
            json.dumps(
                {
                    "joint": self.values,
                    "axes": [asdict(axis) for axis in self.axes],
                    "results": list(self.results),
                    "block_shape": list(self.block_shape),
                }
            )
        )


def make_plan(
    case: AnyCase, axes: Sequence[SweepAxis], results: Sequence[str], *, block_points: int | None = None
) -> Plan:
    """Check a sweep and divide its grid into blocks."""
    check_axes(case, axes)
    values = si_values(case)
    table = results_of(values)
    names = chosen_results(results, table=table)
    numbers = sum(len(table[name].row_names) for name in names)
    most = block_points or max(min(BLOCK_POINTS, _BLOCK_NUMBERS // numbers), 1)
    return Plan(values, tuple(axes), names, block_shape(tuple(axis.count for axis in axes), most))


def block_shape(shape: tuple[int, ...], most: int) -> tuple[int, ...]:
    """Points of a block along each axis: whole last axes, even parts of the first one that does not fit.

    Examples
    --------
    >>> block_shape((100, 100, 100), 30_000), block_shape((7, 11), 1000)
    ((3, 100, 100), (7, 11))
    >>> block_shape((1000, 1000), 300_000)
    (250, 1000)
    """
    block = []
    room = max(most, 1)
    for count in reversed(shape):
        parts = math.ceil(count / max(min(count, room), 1))
        step = math.ceil(count / parts)
        block.append(step)
        room = room // step if step == count else 1
    return tuple(reversed(block))


def block_results(
    plan: Plan, block: tuple[slice, ...], **options: Any
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Status codes and results by name of one block of a sweep, in its shape, a contact axis first if there is one.

    ``options`` are those of :func:`asperity.study.batch.evaluate_points`.
    """
    values = [axis.values[part] for axis, part in zip(plan.axes, block, strict=True)]
    grid = np.meshgrid(*values, indexing="ij")
    points = {axis.path: column.reshape(-1) for axis, column in zip(plan.axes, grid, strict=True)}
    status, result_values = evaluate_points(
        plan.values, points, plan.results, batch=math.prod(plan.block_shape), **options
    )
    shape = grid[0].shape
    return status.reshape(shape), {
        name: value.reshape(value.shape[:-1] + shape) for name, value in result_values.items()
    }
