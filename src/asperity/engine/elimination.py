"""Linear equations within the programs of JAX: elimination, and LAPACK for batches where that is safe.

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
from jax import Array

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


def _product(matrix: Array, vector: Array) -> Array:
    return (matrix * vector[..., None, :]).sum(axis=-1)


@jax.jit  # traced once for each size
def solve(matrix: Array, right_side: Array) -> Array:
    """The x of one system, shape (n,), by Gauss-Jordan elimination with partial pivoting."""
    return solve_with(lambda x: _product(matrix, x), jax.lax.stop_gradient(matrix), right_side)


def solve_with(linear: Callable[[Array], Array], matrix: Array, right_side: Array) -> Array:
    r"""Solve :math:`A x = b` with the derivatives of a linear function, shape (n,)."""
    return jax.lax.custom_linear_solve(
        linear,
        right_side,
        solve=lambda _, vector: _eliminated(matrix, vector),
        transpose_solve=lambda _, vector: _eliminated(matrix.T, vector),
    )


@jax.custom_batching.custom_vmap
def solve_in_turn(matrix: Array, right_side: Array) -> Array:
    r"""The x of :math:`A x = b`, shape (n,), in a step of an iteration.

    One system by elimination; a batch by LAPACK, or written out.
    """
    return _eliminated(matrix, right_side)


@solve_in_turn.def_vmap
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


@jax.jit
def least_squares(matrix: Array, right_side: Array) -> Array:
    """The x that makes :math:`|A x - b|` smallest, shape (n,), by the normal equations, refined once."""
    square = jnp.sum(matrix[:, :, None] * matrix[:, None, :], axis=0)
    solution = solve(square, _product(matrix.T, right_side))
    return solution + solve(square, _product(matrix.T, right_side - _product(matrix, solution)))


def solve_rows(matrix: Array, right_sides: Array) -> Array:
    r"""The x of :math:`A x = b` for several b, shape (m, n), real or complex, with derivatives.

    By the inverse, once refined: :math:`x = x_0 + A^{-1} (b - A x_0)`, which has the derivatives of the solution. For
    matrices that follow from a state, after the last step of Newton's method: by LAPACK as these steps are, in a
    thirteenth of the time, but where XLA optimises the program.
    """
    fixed = jax.lax.stop_gradient(matrix)
    inverse = _inverse(fixed) if _OPTIMISED.get() else jnp.linalg.inv(fixed)
    first = right_sides @ inverse.T
    return first + (right_sides - first @ matrix.T) @ inverse.T


@jax.jit
def _inverse(matrix: Array) -> Array:
    table, place = _without_columns(jnp.column_stack([matrix, jnp.eye(matrix.shape[0], dtype=matrix.dtype)]))
    here = place == jnp.arange(place.size)[:, None]
    return jnp.where(here[:, :, None], table[None, :, place.size :], 0.0).sum(axis=1)


@jax.jit
def _eliminated(matrix: Array, vector: Array) -> Array:
    table, place = _without_columns(jnp.column_stack([matrix, vector]))
    return jnp.where(place == jnp.arange(place.size)[:, None], table[:, -1], 0.0).sum(axis=1)


def _without_columns(table: Array) -> tuple[Array, Array]:
    """A matrix with right sides behind it by Gauss-Jordan elimination with partial pivoting, and where each x is."""
    rows = jnp.arange(table.shape[0])

    def without_column(k: Array, state: tuple[Array, Array]) -> tuple[Array, Array]:
        table, place = state
        pivot = jnp.argmax(
            jnp.where(place < 0, jnp.abs(table[:, k]), -1.0)
        )  # among the rows without an unknown
        row = table[pivot] / table[pivot, k]
        here = rows == pivot
        table = jnp.where(here[:, None], row, table - table[:, k, None] * row)
        return table, jnp.where(here, k, place)

    eliminated: tuple[Array, Array] = jax.lax.fori_loop(
        0, rows.size, without_column, (table, jnp.full_like(rows, -1))
    )
    return eliminated
