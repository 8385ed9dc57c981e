"""Sweeps: a joint evaluated on a grid of any of its numbers, in memory or streamed to disk."""

from __future__ import annotations

import dataclasses
import json
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from asperity.errors import InputError
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import AnyCase
from asperity.precision import require_double_precision
from asperity.study.datasets import common_attributes, coordinate, dataset
from asperity.study.parameters import SweepAxis
from asperity.study.sweep.cluster import run_on_cluster
from asperity.study.sweep.store import open_store, prepare_store, remove_store, write_block
from asperity.study.sweep.store_layout import repair_store, unfinished_blocks
from asperity.study.sweep.sweep_plan import PLAN, Plan, block_results, make_plan

if TYPE_CHECKING:
    import xarray

#: A larger sweep is streamed to a store instead of being held in memory.
IN_MEMORY_POINTS = 1_000_000
#: The same limit on the size of its results [byte].
IN_MEMORY_BYTES = 1_000_000_000
#: Up to this number of points a sweep runs in this process: local processes would take longer to start.
ONE_PROCESS_POINTS = 500_000

#: Called with the points done so far and the points of the whole sweep.
Report = Callable[[int, int], Any]


def sweep(
    case: AnyCase,
    axes: Sequence[SweepAxis],
    *,
    results: Sequence[str],
    store: str | Path | None = None,
    overwrite: bool = False,
    scheduler: str | None = None,
    workers: int | None = None,
    block_points: int | None = None,
    report: Report | None = None,
    notice: Callable[[str], Any] | None = None,
) -> xarray.Dataset:
    """Evaluate a joint on a grid.

    Parameters
    ----------
    case : Case
        The joint file.
    axes : sequence of Axis or ListedAxis
        What is varied, a dimension for each; :func:`asperity.study.parameters.parse_axis` reads them from text.
    results : sequence of str
        Results or groups of them, e.g. ``("stiffness", "slip_ratio")``; ``("all",)`` for every one. What is not
        asked for is not computed.
    store : str or Path, optional
        A Zarr store to stream to. An interrupted sweep with the same store continues where it stopped; what is already
        in it is verified, and computed again if it is damaged.
    overwrite : bool, optional
        Whether another sweep's store may be deleted.
    scheduler : str, optional
        Address of a running Dask scheduler, ``tcp://…``; its workers must see the store's folder.
    workers : int, optional
        Local processes; 0 for none, by default as many as there are cores where the sweep is large.
    block_points : int, optional
        Largest number of points of a block.
    report : callable, optional
        Called with the number of points done and of all points.
    notice : callable, optional
        Called with a sentence about a damaged store that is repaired.

    Returns
    -------
    xarray.Dataset
        A dimension for each axis, named by its key; results in SI units; ``status`` 0 where a point is solved, a reason
        elsewhere. Lazy if there is a store.

    Raises
    ------
    InputError
        If the axes, the results or the store are not usable, or the sweep is too large for memory.
    PrecisionError
        If JAX is in single precision.

    Notes
    -----
    A script that uses several processes needs ``if __name__ == "__main__":`` around what it does: the processes
    are spawned, and read the script again.
    """
    require_double_precision()
    plan = make_plan(case, axes, results, block_points=block_points)
    if store is None:
        return _in_memory(plan, scheduler, workers, report)
    if overwrite and Path(store).exists():
        remove_store(store)
    new = not Path(store).exists()
    blocks = prepare_store(store, plan) if new else _blocks_left(store, plan, notice)
    todo = _Progress(plan, blocks, report)
    if scheduler is None and (workers == 0 or (workers is None and todo.left <= ONE_PROCESS_POINTS)):
        for index in blocks:
            status, result_values = block_results(plan, plan.block(index), in_all=plan.points)
            write_block(store, plan, index, status, result_values)
            todo.finished(index)
    else:
        try:
            run_on_cluster(plan, store, blocks, scheduler=scheduler, workers=workers, finished=todo.finished)
        except InputError:
            if new and len(unfinished_blocks(store)) == plan.block_count:
                remove_store(store)
            raise
    return open_store(store, verify=False)


def _blocks_left(store: str | Path, plan: Plan, notice: Callable[[str], Any] | None) -> list[int]:
    """The blocks of an earlier store that are not finished or damaged."""
    blocks = prepare_store(store, plan)
    damaged = repair_store(store, plan)
    if damaged and notice is not None:
        notice(f"{len(damaged)} blocks of {store} are damaged or missing and are computed again")
    return sorted({*blocks, *damaged})


class _Progress:
    """Counts points as blocks are finished."""

    def __init__(self, plan: Plan, blocks: list[int], report: Report | None) -> None:
        self._sizes = {
            index: math.prod(part.stop - part.start for part in plan.block(index)) for index in blocks
        }
        self.left = sum(self._sizes.values())
        self._points = plan.points
        self._report = report
        self._tell(0)

    def _tell(self, more: int) -> None:
        self.left -= more
        if self._report is not None:
            self._report(self._points - self.left, self._points)

    def finished(self, index: int) -> None:
        """Count a block that has been written."""
        self._tell(self._sizes[index])


def _in_memory(
    plan: Plan, scheduler: str | None, workers: int | None, report: Report | None
) -> xarray.Dataset:
    if scheduler is not None or workers:
        raise InputError(
            "a cluster writes to a store, and none is given; give one, such as sweep.zarr", options=["out"]
        )
    if plan.points > IN_MEMORY_POINTS or plan.bytes > IN_MEMORY_BYTES:
        raise InputError(
            f"{plan.points} points with {len(plan.results)} results take {plan.bytes / 1e9:.3g} GB of memory; stream "
            "them to a store, such as sweep.zarr, or ask for fewer results",
            options=["out", "results"],
        )
    done = 0

    def count(points: int) -> None:
        nonlocal done
        done += points
        if report is not None:
            report(done, plan.points)

    one = dataclasses.replace(plan, block_shape=plan.shape)
    status, result_values = block_results(one, one.block(0), report=count)
    return dataset(
        dimensions=tuple(axis.path for axis in plan.axes),
        coordinates={axis.path: coordinate(axis) for axis in plan.axes},
        status=status,
        result_values=result_values,
        table=results_of(plan.values),
        attributes={**common_attributes("sweep of a joint"), PLAN: json.dumps(plan.as_dict())},
    )
