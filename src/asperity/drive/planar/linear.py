"""Small systems of linear equations by elimination, without LAPACK.

XLA runs LAPACK on a batch in threads of its own and waits for them in one of them. On a machine with two cores two such
calls that run at once wait for each other for ever (jaxlib 0.10). Only calls that cannot run at once use LAPACK: the
steps of Newton's method, which follow each other, and the least squares of
:func:`asperity.drive.planar.closure.closed`, a program of its own that ends before any other begins.
"""

from __future__ import annotations

import jax
import jax.numpy as jnp
from jax import Array


@jax.jit  # traced once for each size
def solve(matrix: Array, right_side: Array) -> Array:
    r"""Solve :math:`A x = b` by Gauss-Jordan elimination with partial pivoting.

    Parameters
    ----------
    matrix : Array
        A, shape (n, n).
    right_side : Array
        b, shape (n,).

    Returns
    -------
    Array
        x, shape (n,); not finite where A is singular.

    Notes
    -----
    Derivatives are those of the equation, not of the elimination.
    """
    fixed = jax.lax.stop_gradient(matrix)
    return jax.lax.custom_linear_solve(
        lambda x: matrix @ x,
        right_side,
        solve=lambda _, vector: _eliminated(fixed, vector),
        transpose_solve=lambda _, vector: _eliminated(fixed.T, vector),
    )


@jax.jit
def least_squares(matrix: Array, right_side: Array) -> Array:
    r"""The x that makes :math:`|A x - b|` smallest, by the normal equations, refined once.

    Parameters
    ----------
    matrix : Array
        A, shape (m, n), of rank n.
    right_side : Array
        b, shape (m,).

    Returns
    -------
    Array
        x, shape (n,); not finite where A has a smaller rank.
    """
    square = matrix.T @ matrix
    found = solve(square, matrix.T @ right_side)
    return found + solve(square, matrix.T @ (right_side - matrix @ found))


def _eliminated(matrix: Array, vector: Array) -> Array:
    count = matrix.shape[0]
    rows = jnp.arange(count)

    def without_column(k: int, table: Array) -> Array:
        column = table[:, k]
        pivot = jnp.argmax(jnp.where(rows >= k, jnp.abs(column), -1.0))
        first, second = table[k], table[pivot]
        table = table.at[pivot].set(first).at[k].set(second)
        factor = jnp.where(rows == k, 0.0, table[:, k] / second[k])
        return table - factor[:, None] * second

    table = jax.lax.fori_loop(0, count, without_column, jnp.column_stack([matrix, vector]))
    return table[:, -1] / jnp.diagonal(table)
