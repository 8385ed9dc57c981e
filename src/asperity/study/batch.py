"""Evaluate a joint at many points: status, chosen results and, where asked, their exact derivatives.

One kernel serves all studies. It takes all numbers of the joint file, so that one compiled program serves every study
of joints of one structure; only for very many points it takes arrays of the varied ones, and the others once. Sweeps
and samples get results that are nan where they have no value. Searches get them as they are: the way to a good joint
may lead through impossible ones.
"""

from __future__ import annotations

import contextlib
import functools
import itertools
import json
import math
import os
import threading
from collections.abc import Callable, Generator, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from asperity.compilation import program_for_few, program_for_many
from asperity.engine import trees
from asperity.errors import InputError
from asperity.joint.status import OUT_OF_RANGE, UNBALANCED, has_value
from asperity.joint_file.any_joint import evaluated_points, results_of, with_nominal_sizes
from asperity.joint_file.form_parts import refuse_floating_runout
from asperity.joint_file.part_names import drive_type_of, type_of, with_structure
from asperity.joint_file.parts import layout_of
from asperity.joint_file.quantity_key import Key
from asperity.joint_file.si_tables import (
    MEASURED,
    Numbers,
    Values,
    key_at,
    numbers,
    replace_values,
    table_structure,
    with_numbers,
)
from asperity.precision import require_double_precision
from asperity.results import RESULTS
from asperity.study.measured_points import (
    STATE,
    WIDTH,
    Columns,
    heights_moved,
    refuse_derivatives,
    with_felt_surfaces,
)
from asperity.types import Array

BatchResult = tuple[Array, dict[str, Array]]
Kernel = Callable[..., BatchResult]

#: Points that pass through the program of a processor at once: few enough for its intermediate arrays to stay in the
#: cache.
BATCH = 1_024
#: Points that pass through that of another device, if its memory allows: enough to keep all of it busy. On an H100 a
#: planetary drive is assembled 2e5 times a second with 1,024 points a call, and 1.9e7 times with these.
DEVICE_BATCH = 524_288
#: Memory of a device for one point [byte]: that of a multiroller drive with its intermediate arrays.
_BYTES_A_POINT = 65_536
#: Up to this number of points, a program that compiles fast and runs slowly finishes sooner.
QUICK_POINTS = 20_000
#: Points of the smallest of these programs, which serves all studies of fewer points.
_FEWEST = 64
#: Most points of one call of the program with derivatives; more points are more calls.
DERIVATIVE_BATCH = 64
#: Calls in forward mode beyond which reverse mode, whose program takes half as long again to compile, finishes sooner.
_REVERSE_BLOCKS = 4
#: Held by a program that is compiled fast: XLA runs LAPACK on a large batch in its pool of threads, and as many such
#: calls at once as the pool has threads, from threads of ours, wait for each other for ever (jaxlib 0.10).
_ALONE = threading.Lock()


def points_at_once(device: Any = None) -> int:
    """Points that pass through a program at once on a device of JAX, by default the one that computes."""
    device = jax.devices()[0] if device is None else device
    if device.platform == "cpu":
        return BATCH
    memory = (device.memory_stats() or {}).get("bytes_limit", 0)
    most = min(DEVICE_BATCH, max(BATCH, memory // _BYTES_A_POINT))
    return 1 << (int(most).bit_length() - 1)


def _masked(status: Array, result_values: dict[str, Array]) -> dict[str, Array]:
    """Results that are nan where they have no value."""
    return {
        name: jnp.where(has_value(status, RESULTS[name].needs), value, jnp.nan)
        for name, value in result_values.items()
    }


def point_kernel(values: Values, paths: tuple[str, ...], results: tuple[str, ...]) -> Kernel:
    """The function that evaluates points: numbers of the file and arrays of the varied ones in, results out."""

    def kernel(base: Numbers, *arrays: Array) -> BatchResult:
        tables = replace_values(with_numbers(values, base), dict(zip(paths, arrays, strict=True)))
        points = jnp.broadcast_shapes(*(jnp.shape(array) for array in arrays))
        status, result_values = evaluated_points(tables, points, results)
        return status, _masked(status, result_values)

    return kernel


@functools.lru_cache(maxsize=32)
def _program(structure: str, paths: tuple[str, ...], results: tuple[str, ...], size: int) -> Kernel:
    """The optimised program of points of which only some numbers vary."""
    tables = json.loads(structure)
    base = tuple(jax.ShapeDtypeStruct((), jnp.float64) for _ in numbers(tables))
    arrays = [jax.ShapeDtypeStruct((size,), jnp.float64)] * len(paths)
    return program_for_many(point_kernel(tables, paths, results), base, *arrays)


def evaluate_points(
    values: Values,
    points: Mapping[str, np.ndarray],
    results: tuple[str, ...],
    *,
    in_all: int | None = None,
    batch: int | None = None,
    threads: int | None = None,
    report: Callable[[int], Any] | None = None,
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Status and results of a joint at many points.

    ``values``: tables of the joint file in SI units, :func:`asperity.joint_file.si_tables.si_values`; ``points``:
    dotted path → values in SI units, all of shape (n,); ``results``: names of
    :func:`asperity.joint_file.any_joint.results_of`. ``in_all``: points of all calls of a study, by default of this
    one: up to :data:`QUICK_POINTS` are evaluated by a program that compiles fast, runs slowly and serves any numbers
    that vary, more by one that is optimised. ``batch``: points for which to compile, at most, by default as many as
    there are; calls with the same one share a program. ``threads`` that run an optimised program on processors, by
    default one for each core. ``report`` is called with the number of points just done.

    Status codes are indices into :data:`asperity.joint.status.STATUSES`, shape (n,); results have the shape (n,) or
    (rows, n), nan where they have no value. On a measured surface every point has what its contacts feel at the widths
    that they have there. A ``PrecisionError`` is raised if JAX is in single precision.
    """
    require_double_precision()
    if MEASURED in values:
        options = {"in_all": in_all, "batch": batch, "threads": threads}
        return _evaluate_measured(values, points, results, report=report, **options)
    values = with_structure(values)
    _refuse_what_cannot_vary(values, tuple(points), results)
    columns = {path: np.asarray(column, dtype=float) for path, column in points.items()}
    count = next(iter(columns.values())).size
    outside = np.zeros(count, dtype=bool)
    for path, column in columns.items():
        outside |= _outside(key_at(path, type_of(values)), column)

    status = np.empty(count, dtype=np.int8)
    table = results_of(values)
    result_values = {name: np.empty((*table[name].row_shape, count), dtype=float) for name in results}
    parts, start = _parts(values, columns, results, max(in_all or 0, count), batch or count, threads), 0
    with contextlib.closing(parts):
        for code, done in parts:
            part = slice(start, start + code.size)
            status[part] = code
            for name, value in done.items():
                result_values[name][..., part] = value
            start += code.size
            if report is not None:
                report(code.size)
    status[outside] = OUT_OF_RANGE
    for name in results:
        result_values[name][..., outside] = np.nan
    return status, result_values


def _parts(
    values: Values, columns: Columns, results: tuple[str, ...], in_all: int, batch: int, threads: int | None
) -> Generator[Any]:
    """What :func:`evaluate_points` puts together, block by block."""
    count = next(iter(columns.values())).size
    size = min(points_at_once(), 1 << max(batch - 1, 0).bit_length())
    if in_all <= QUICK_POINTS:
        filled, size = replace_values(values, columns), max(size, _FEWEST)
        options, table = (table_structure(filled), results), _table(filled, count)
        for start in range(0, count, size):
            with _ALONE:
                done = _blockwise(_points, options, size, table[:, start : start + size])
            yield done
        return
    program = _program(table_structure(values), tuple(columns), results, size)
    base = tuple(np.float64(number) for number in numbers(values))

    def evaluated(start: int) -> Any:
        block = [column[start : start + size] for column in columns.values()]
        padded = [np.pad(column, (0, size - column.size), mode="edge") for column in block]
        return trees.map(lambda each: np.asarray(each)[..., : block[0].size], program(base, *padded))

    starts = range(0, count, size)
    if threads == 1 or jax.default_backend() != "cpu":
        yield from map(evaluated, starts)
        return
    with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
        yield from pool.map(evaluated, starts)


def _table(values: Values, points: int) -> np.ndarray:
    """All numbers of tables of numbers and arrays, shape (numbers, points)."""
    return np.stack([np.broadcast_to(np.asarray(number, float), (points,)) for number in numbers(values)])


def _points(structure: str, results: tuple[str, ...], table: Array) -> BatchResult:
    """Status and results of columns of numbers, for files of one structure."""
    result_values, status = _evaluated(structure, results)(table)
    return status, _masked(status, result_values)


def _evaluate_measured(
    values: Values,
    points: Mapping[str, np.ndarray],
    results: tuple[str, ...],
    *,
    report: Callable[[int], Any] | None,
    **options: Any,
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """What :func:`evaluate_points` returns of joints with a measured surface: the search for the widths is silent."""
    asked = tuple(dict.fromkeys((*results, *STATE)))

    def states(tables: Values, columns: Columns) -> dict[str, np.ndarray]:
        return evaluate_points(tables, columns, asked, **options)[1]

    tables, columns, settled = with_felt_surfaces(values, points, states)
    status, result_values = evaluate_points(tables, columns, asked, report=report, **options)
    status[~settled] = UNBALANCED
    known = np.isfinite(result_values[WIDTH]).all(axis=0)  # what the contacts feel
    for name, value in result_values.items():
        by_law = RESULTS[name].group == "capacity" or name == "torque_safety"
        value[..., ~settled | (by_law & ~known)] = np.nan
    return status, {name: result_values[name] for name in results}


def fixed_count(values: Values, results: Iterable[str]) -> str | None:
    """Path of the number of planets, or of rollers in a row, where it cannot vary; None where it can.

    Sections ``[[branch]]`` state it, too, and results of form errors are those of a drive with a known number.
    """
    sectors = drive_type_of(values).sectors
    fixed = "branch" in values or ("form" in values and _of_turn(results))
    return f"drive.{sectors.key}" if fixed and sectors is not None else None


def _of_turn(results: Iterable[str]) -> list[str]:
    return [name for name in results if RESULTS[name].group == "accuracy"]


def _refuse_what_cannot_vary(values: Values, paths: tuple[str, ...], results: tuple[str, ...]) -> None:
    """Refuse a number of sectors that is fixed, and form errors that one joint could not have either."""
    if _of_turn(results):
        refuse_floating_runout(values, layout_of(values)[0])
    count = fixed_count(values, results)
    if count not in paths:
        return
    if "branch" in values:
        raise InputError(
            f"{count} cannot vary: the file has {len(values['branch'])} sections [[branch]], one for each; leave them "
            "out to vary it"
        )
    raise InputError(
        f"{count} cannot vary with {_of_turn(results)[0]}: form errors are those of parts in a drive of a known "
        "number of sectors; leave it out, ask for other results, or leave [[form]] out of the file"
    )


def _outside(key: Key, column: np.ndarray) -> np.ndarray:
    """Which values are outside the range of their key."""
    if not key.integer and key.admits(float(column.min())) and key.admits(float(column.max())):
        return np.zeros(column.size, dtype=bool)
    distinct, where = np.unique(column, return_inverse=True)
    return ~np.array([key.admits(float(value)) for value in distinct])[where]


def _evaluated(structure: str, results: tuple[str, ...]) -> Callable[[Array], tuple[dict[str, Array], Array]]:
    """Results and status of columns of numbers, for files of one structure."""
    tables = json.loads(structure)

    def results_and_status(rows: Array) -> tuple[dict[str, Array], Array]:
        status, values = evaluated_points(with_numbers(tables, rows), rows.shape[1:], results)
        return values, status

    return results_and_status


def _directional(
    structure: str, results: tuple[str, ...], table: Array, directions: Array
) -> tuple[dict[str, Array], dict[str, Array], Array]:
    """Results, their derivatives along a direction and the status, for columns of numbers of files of one structure."""
    evaluated = _evaluated(structure, results)
    values, slopes, status = jax.jvp(evaluated, (table,), (directions,), has_aux=True)
    return values, slopes, status


def _gradients(structure: str, results: tuple[str, ...], table: Array, rows: Array) -> tuple[Any, Any, Array]:
    """Results, derivatives of one of their rows by all numbers, shape (numbers, points), and the status."""
    values, pull, status = jax.vjp(_evaluated(structure, results), table, has_aux=True)
    weights, start = {}, 0
    for name in sorted(values):
        shape = values[name].shape[:-1]
        places = np.arange(start, start + math.prod(shape)).reshape(*shape, 1)
        weights[name], start = (places == rows[0]).astype(table.dtype), start + places.size
    return values, pull(weights)[0], status


def derivatives_at(
    values: Values,
    changes: Mapping[str, Any],
    results: tuple[str, ...],
    variables: tuple[str, ...] = (),
    *,
    nominal: tuple[str, ...] = (),
    block: int = DERIVATIVE_BATCH,
) -> tuple[np.ndarray, dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Status, results and their exact derivatives by some of the numbers, at some points.

    ``values`` and ``results`` as for :func:`evaluate_points`; ``changes``: dotted path → numbers [SI], shape (points,),
    must contain the ``variables``, dotted paths by which to differentiate, and behind them ``nominal``: sizes whose
    nominal values, of :func:`asperity.joint_file.any_joint.with_nominal_sizes`, move with them. ``block``: points,
    repeated for each row or variable, of one call of the program, :func:`derivative_block`; calls with the same one
    share a program. Status codes have the shape (points,), results (rows, points) and slopes (rows, points, variables)
    [SI]; a single number has one row. Nothing is replaced by nan: a search may pass through joints that cannot exist.

    Forward-mode automatic differentiation, the points repeated along the batch axis once for each variable. Where that
    is many calls and there are fewer rows of results than variables: reverse mode, the points repeated for each row.
    """
    if MEASURED in values:
        return _derivatives_measured(values, changes, results, variables, nominal, block)
    _refuse_what_cannot_vary(values, variables, results)
    points = max((np.size(value) for value in changes.values()), default=1)
    filled = replace_values(with_structure(values), changes)
    table = _table(filled, points)
    nothing = with_numbers(filled, itertools.repeat(0.0))
    moved = [replace_values(nothing, {path: 1.0}) for path in (*variables, *nominal)]
    moved[len(variables) :] = map(with_nominal_sizes, moved[len(variables) :])
    directions = np.array([numbers(each) for each in moved], dtype=float).reshape(-1, len(table)).T
    options = (table_structure(filled), results)
    rows = sum(math.prod(results_of(values)[name].row_shape) for name in results)
    if rows < len(moved) and points * len(moved) > _REVERSE_BLOCKS * block:
        return _backwards(options, block, table, directions, rows)
    return _forwards(options, block, table, directions)


_Derivatives = tuple[np.ndarray, dict[str, np.ndarray], dict[str, np.ndarray]]


def _derivatives_measured(
    values: Values,
    changes: Mapping[str, Any],
    results: tuple[str, ...],
    variables: tuple[str, ...],
    nominal: tuple[str, ...],
    block: int,
) -> _Derivatives:
    """What :func:`derivatives_at` returns of joints with a measured surface.

    The heights that contacts feel move with the widths of the contacts, which move with the heights.
    """
    if variables:
        refuse_derivatives(values)
    asked = tuple(dict.fromkeys((*results, *STATE)))

    def states(tables: Values, columns: Columns) -> dict[str, np.ndarray]:
        return derivatives_at(tables, columns, asked, block=block)[1]

    points = max((np.size(value) for value in changes.values()), default=1)
    given = {path: np.broadcast_to(np.asarray(value, float), (points,)) for path, value in changes.items()}
    tables, columns, settled = with_felt_surfaces(values, given, states)
    felt = tuple(path for path in columns if path not in given) if variables else ()
    sizes, every = (*variables, *nominal), (*variables, *felt)
    status, first, slopes = derivatives_at(tables, columns, asked, every, nominal=nominal, block=block)
    status[~settled] = UNBALANCED
    if felt:
        count, known = len(sizes), len(variables)
        # those of what the contacts feel behind those of all sizes
        order = [*range(known), *range(len(every), count + len(felt)), *range(known, len(every))]
        slopes = {name: slope[..., order] for name, slope in slopes.items()}
        moved = heights_moved(values, columns, first[WIDTH], slopes[WIDTH], sizes)
        slopes = {
            name: slope[..., :count] + np.einsum("rpc,pcv->rpv", slope[..., count:], moved)
            for name, slope in slopes.items()
        }
    return status, {name: first[name] for name in results}, {name: slopes[name] for name in results}


def _forwards(
    options: tuple[Any, ...], block: int, table: np.ndarray, directions: np.ndarray
) -> _Derivatives:
    """What :func:`derivatives_at` returns, along one direction after the other."""
    (_, points), count = table.shape, max(directions.shape[1], 1)
    along = directions if directions.size else np.zeros((len(table), 1))
    values, slopes, status = _blockwise(
        _directional, options, block, np.tile(table, (1, count)), np.repeat(along, points, axis=1)
    )
    first = {name: value.reshape(-1, count, points)[:, 0] for name, value in values.items()}
    by_variable = {
        name: np.moveaxis(value.reshape(-1, count, points), 1, 2)[..., : directions.shape[1]]
        for name, value in slopes.items()
    }
    return status[:points], first, by_variable


def _backwards(
    options: tuple[Any, ...], block: int, table: np.ndarray, directions: np.ndarray, rows: int
) -> _Derivatives:
    """What :func:`derivatives_at` returns, from one row of the results after the other."""
    _, points = table.shape
    values, gradients, status = _blockwise(
        _gradients, options, block, np.tile(table, (1, rows)), np.repeat(np.arange(rows), points)[None]
    )
    by_rows = np.einsum("nrp,nv->rpv", gradients.reshape(-1, rows, points), directions)
    first = {name: values[name].reshape(-1, rows, points)[:, 0] for name in sorted(values)}
    ends = np.cumsum([value.shape[0] for value in first.values()])
    return status[:points], first, dict(zip(first, np.split(by_rows, ends[:-1]), strict=True))


def derivative_block(points: int) -> int:
    """Points of one call of the program with derivatives, where so many times variables are asked for at once."""
    return min(DERIVATIVE_BATCH, 1 << max(points - 1, 0).bit_length())


def _blockwise(function: Callable[..., Any], options: tuple[Any, ...], size: int, *tables: np.ndarray) -> Any:
    """Call a compiled function block by block; the last block is filled up with copies of its last point."""
    points = tables[0].shape[1]
    parts = []
    for start in range(0, points, size):
        block = [table[:, start : start + size] for table in tables]
        missing = size - block[0].shape[1]
        padded = [np.pad(part, ((0, 0), (0, missing)), mode="edge") for part in block]
        program = program_for_few(function, *padded, options=options)
        parts.append(trees.map(np.asarray, program(*padded)))
    return trees.map(lambda *pieces: np.concatenate(pieces, axis=-1)[..., :points], *parts)
