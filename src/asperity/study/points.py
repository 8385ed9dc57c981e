"""Evaluate a joint at many points: one compiled program, fed with batches of some of the joint's numbers."""

from __future__ import annotations

import functools
import json
from collections.abc import Callable, Mapping
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.joint.description import with_one_rank
from asperity.joint.evaluation import evaluate
from asperity.joint.results import GROUPS, RESULTS, result_values
from asperity.joint.status import LOCKED, OUT_OF_RANGE, SLIPS, joint_status
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.key import Key
from asperity.joint_file.structure import Numbers, numbers, table_structure, with_numbers
from asperity.joint_file.values import Values, key_at, replace_values
from asperity.precision import require_double_precision

Kernel = Callable[..., tuple[Array, dict[str, Array]]]

#: Points that pass through the program at once: few enough for its intermediate arrays to stay in the cache.
BATCH = 32_768
#: The same where the assembly, whose equations take some kilobytes a point, is among the results.
ASSEMBLY_BATCH = 4_096
#: Up to so many points a program that compiles fast and runs at a fraction of the speed is done sooner.
QUICK_POINTS = 20_000


def point_kernel(values: Values, paths: tuple[str, ...], results: tuple[str, ...]) -> Kernel:
    """The function that evaluates points: numbers of the file and arrays of the varied ones in, results out.

    Parameters
    ----------
    values : dict
        Tables of the joint file, for their structure and names; the numbers in them are not used.
    paths : tuple of str
        Dotted paths of the varied numbers.
    results : tuple of str
        Names of :data:`asperity.joint.results.RESULTS`.

    Returns
    -------
    callable
        Of the :func:`numbers` of a file and one array for each path, all of one shape, in SI units, to the status
        codes and the results, which are nan where they mean nothing; pure, for ``jit``. Because the file's numbers
        are arguments, one compiled program serves all files of the same structure.
    """

    def kernel(base: Numbers, *arrays: Array) -> tuple[Array, dict[str, Array]]:
        tables = replace_values(with_numbers(values, base), dict(zip(paths, arrays, strict=True)))
        joint = with_one_rank(joint_from_values(tables))
        found = evaluate(joint)
        points = jnp.broadcast_shapes(*(jnp.shape(array) for array in arrays))
        # surfaces, hardness and the springs of the structure do not reach the force balance: one status for all points
        code = jnp.broadcast_to(joint_status(joint, found), points)
        masks = {
            "geometry": (code == 0) | (code >= LOCKED),
            "balance": (code == 0) | (code == SLIPS),
            "operation": code == 0,
        }
        masked = {}
        for name, value in result_values(results, joint, found).items():
            shape = (5, *points) if RESULTS[name].per_contact else points
            masked[name] = jnp.where(masks[RESULTS[name].needs], jnp.broadcast_to(value, shape), jnp.nan)
        return code, masked

    return kernel


def batch_size(results: tuple[str, ...]) -> int:
    """Points that pass through the program at once.

    Parameters
    ----------
    results : tuple of str
        What is computed.

    Returns
    -------
    int
        A power of two.
    """
    return ASSEMBLY_BATCH if set(results) & set(GROUPS["assembly"]) else BATCH


@functools.lru_cache(maxsize=32)
def _program(
    structure: str, paths: tuple[str, ...], results: tuple[str, ...], size: int, quick: bool
) -> Kernel:
    tables = json.loads(structure)
    base = tuple(jax.ShapeDtypeStruct((), jnp.float64) for _ in numbers(tables))
    arrays = [jax.ShapeDtypeStruct((size,), jnp.float64)] * len(paths)
    if quick:
        return compile_fast(_evaluated, base, *arrays, options=(structure, paths, results))
    return jax.jit(point_kernel(tables, paths, results)).lower(base, *arrays).compile()


def _evaluated(
    structure: str, paths: tuple[str, ...], results: tuple[str, ...], base: Any, *columns: Array
) -> Any:
    """The kernel as a function that is known by its name, so that its program is kept."""
    return point_kernel(json.loads(structure), paths, results)(base, *columns)


def evaluate_points(
    values: Values,
    points: Mapping[str, np.ndarray],
    results: tuple[str, ...],
    *,
    quick: bool | None = None,
    batch: int | None = None,
    report: Callable[[int], Any] | None = None,
) -> tuple[np.ndarray, dict[str, np.ndarray]]:
    """Status and results of a joint at many points.

    Parameters
    ----------
    values : dict
        Tables of the joint file in SI units, :func:`asperity.joint_file.values.si_values`.
    points : mapping
        Dotted path → values in SI units, all of shape (n,).
    results : tuple of str
        Names of :data:`asperity.joint.results.RESULTS`.
    quick : bool, optional
        Whether to compile fast and run slowly; by default up to :data:`QUICK_POINTS` points.
    batch : int, optional
        Points for which to compile, at most; by default as many as there are. Calls with the same one share a program.
    report : callable, optional
        Called with the number of points just done.

    Returns
    -------
    status : ndarray
        Codes of :data:`asperity.joint.status.STATUS_MEANINGS`, shape (n,).
    found : dict of ndarray
        Name → values, shape (n,) or (5, n); nan where they mean nothing.

    Raises
    ------
    PrecisionError
        If JAX is in single precision.
    """
    require_double_precision()
    paths = tuple(points)
    columns = {path: np.asarray(column, dtype=float) for path, column in points.items()}
    count = next(iter(columns.values())).size
    quick = count <= QUICK_POINTS if quick is None else quick
    size = min(batch_size(results), 1 << max((batch or count) - 1, 0).bit_length())
    program = _program(table_structure(values), paths, results, size, quick)
    base = tuple(np.float64(number) for number in numbers(values))
    outside = np.zeros(count, dtype=bool)
    for path, column in columns.items():
        outside |= _outside(key_at(path), column)

    status = np.empty(count, dtype=np.int8)
    found = {
        name: np.empty((5, count) if RESULTS[name].per_contact else count, dtype=float) for name in results
    }
    for start in range(0, count, size):
        part = slice(start, min(start + size, count))
        missing = size - (part.stop - start)
        padded = [np.pad(column[part], (0, missing), mode="edge") for column in columns.values()]
        code, done = program(base, *padded)
        status[part] = np.asarray(code)[: size - missing]
        for name, value in done.items():
            found[name][..., part] = np.asarray(value)[..., : size - missing]
        if report is not None:
            report(part.stop - start)
    status[outside] = OUT_OF_RANGE
    for name in results:
        found[name][..., outside] = np.nan
    return status, found


def _outside(key: Key, column: np.ndarray) -> np.ndarray:
    """Which values are outside the range of their key."""
    if not key.whole and key.admits(float(column.min())) and key.admits(float(column.max())):
        return np.zeros(column.size, dtype=bool)
    distinct, where = np.unique(column, return_inverse=True)
    return ~np.array([key.admits(float(value)) for value in distinct])[where]
