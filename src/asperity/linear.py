"""Small systems of linear equations by elimination, and batches of them by LAPACK where that is safe.

XLA runs LAPACK on a batch in threads of its own and waits for them in one of them. On a machine with two cores two such
calls that run at once wait for each other for ever (jaxlib 0.10). Only calls that cannot run at once use LAPACK: the
steps of Newton's method, which follow each other, and the least squares of
:func:`asperity.drive.layout.closing.closed`, a program of its own that ends before any other begins.

Where XLA optimises a program (:func:`optimised`), elimination that is written out takes a quarter of LAPACK's time, for
13 unknowns 1.2 instead of 4.4 µs; in a program that is compiled fast it takes twice as long.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from contextvars import ContextVar

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.typing import ArrayLike

from asperity.engine.arrays import Dual, directions_at, highest_level, slopes_at, uses_jax, value_at, xp

#: Whether XLA optimises the program that is traced now.
_OPTIMISED: ContextVar[bool] = ContextVar("XLA optimises", default=False)
#: Systems that are eliminated together: their tables stay in the nearest cache.
_TOGETHER = 64


@contextlib.contextmanager
def optimised() -> Iterator[None]:
    """Trace a program in this block that XLA optimises."""
    before = _OPTIMISED.set(True)
    try:
        yield
    finally:
        _OPTIMISED.reset(before)


def product(matrix: ArrayLike, vector: ArrayLike) -> Array:
    """Product of matrix (..., m, n) and vector (..., n), in the program around it instead of a call of its own."""
    result: Array = (xp.asarray(matrix) * xp.asarray(vector)[..., None, :]).sum(axis=-1)
    return result


def solve(matrix: Array, right_side: Array) -> Array:
    """The x, shape (n,), of :math:`A x = b`; not finite where A is singular.

    NumPy's numbers by LAPACK; within programs by Gauss-Jordan elimination with partial pivoting. Derivatives are those
    of the equation, not of the elimination.
    """
    if uses_jax(matrix, right_side):
        return _solved_by_jax(matrix, right_side)
    level = highest_level((matrix, right_side))
    if level == 0:
        return _by_lapack(matrix, right_side)
    values = value_at(matrix, level)
    x = solve(values, value_at(right_side, level))
    count = directions_at((matrix, right_side), level)
    both = zip(slopes_at(matrix, level, count), slopes_at(right_side, level, count), strict=True)
    slopes = [
        solve(
            values,
            (0.0 * x if of_right is None else of_right)
            - (0.0 if of_matrix is None else product(of_matrix, x)),
        )
        for of_matrix, of_right in both
    ]
    return Dual(x, slopes, level)  # type: ignore[return-value]


def _by_lapack(matrix: np.ndarray, right_side: np.ndarray) -> np.ndarray:
    """Of NumPy's numbers; nan where the matrix is singular."""
    try:
        return np.linalg.solve(matrix, right_side)
    except np.linalg.LinAlgError:
        return np.full(np.shape(right_side), np.nan)


@jax.jit  # traced once for each size
def _solved_by_jax(matrix: Array, right_side: Array) -> Array:
    return solve_with(lambda x: product(matrix, x), jax.lax.stop_gradient(matrix), right_side)


def solve_with(linear: Callable[[Array], Array], matrix: Array, right_side: Array) -> Array:
    r"""Solve :math:`A x = b` with the derivatives of a linear function, shape (n,)."""
    return jax.lax.custom_linear_solve(
        linear,
        right_side,
        solve=lambda _, vector: _eliminated(matrix, vector),
        transpose_solve=lambda _, vector: _eliminated(matrix.T, vector),
    )


def solve_in_turn(matrix: Array, right_side: Array) -> Array:
    r"""Solve :math:`A x = b` in a step of an iteration: one system by elimination; a batch by LAPACK, or written out.

    Shape (n,).
    """
    if uses_jax(matrix, right_side):
        return _one_in_turn(matrix, right_side)
    return _by_lapack(matrix, right_side)


@jax.custom_batching.custom_vmap
def _one_in_turn(matrix: Array, right_side: Array) -> Array:
    return _eliminated(matrix, right_side)


@_one_in_turn.def_vmap
def _batch_in_turn(size: int, batched: list[bool], matrix: Array, right_side: Array) -> tuple[Array, bool]:
    matrix, right_side = (
        given if many else jnp.broadcast_to(given, (size, *given.shape))
        for given, many in zip((matrix, right_side), batched, strict=True)
    )
    if _OPTIMISED.get():
        return jax.lax.map(lambda one: _written_out(*one), (matrix, right_side), batch_size=_TOGETHER), True
    return jnp.linalg.solve(matrix, right_side[..., None])[..., 0], True


def _written_out(matrix: Array, vector: Array) -> Array:
    """Gaussian elimination with partial pivoting, without loops."""
    table, pivot_rows = jnp.column_stack([matrix, vector]), []
    for left in range(vector.size, 0, -1):
        pivot = jnp.argmax(jnp.abs(table[:, 0]))
        row = table[pivot]
        pivot_rows.append(row)
        rest = jnp.where((jnp.arange(1, left) == pivot)[:, None], table[0], table[1:])
        table = rest[:, 1:] - (rest[:, 0] / row[0])[:, None] * row[1:]
    solution: list[Array] = []
    for row in reversed(pivot_rows):
        found = sum((row[1 + k] * x for k, x in enumerate(solution)), start=-row[-1])
        solution.insert(0, -found / row[0])
    return jnp.stack(solution)


def least_squares(matrix: Array, right_side: Array) -> Array:
    """The x, shape (n,), that makes :math:`|A x - b|` smallest, by the normal equations, refined once.

    Where A, shape (m, n), has a rank below n it is not finite, or with NumPy's numbers the shortest of all; nan where A
    or b is not finite.
    """
    if uses_jax(matrix, right_side):
        return _by_normal_equations(matrix, right_side)
    if not (np.all(np.isfinite(matrix)) and np.all(np.isfinite(right_side))):
        return xp.full(matrix.shape[1], np.nan)
    shortest: Array = xp.linalg.lstsq(matrix, right_side, rcond=None)[0]
    return shortest


@jax.jit
def _by_normal_equations(matrix: Array, right_side: Array) -> Array:
    square = jnp.sum(matrix[:, :, None] * matrix[:, None, :], axis=0)
    solution = solve(square, product(matrix.T, right_side))
    return solution + solve(square, product(matrix.T, right_side - product(matrix, solution)))


@jax.jit
def _eliminated(matrix: Array, vector: Array) -> Array:
    rows = jnp.arange(matrix.shape[0])

    def without_column(k: Array, state: tuple[Array, Array]) -> tuple[Array, Array]:
        table, place = state
        pivot = jnp.argmax(
            jnp.where(place < 0, jnp.abs(table[:, k]), -1.0)
        )  # among the rows without an unknown
        row = table[pivot] / table[pivot, k]
        here = rows == pivot
        table = jnp.where(here[:, None], row, table - table[:, k, None] * row)
        return table, jnp.where(here, k, place)

    start = jnp.column_stack([matrix, vector]), jnp.full_like(rows, -1)
    table, place = jax.lax.fori_loop(0, rows.size, without_column, start)
    return jnp.where(place == rows[:, None], table[:, -1], 0.0).sum(axis=1)
