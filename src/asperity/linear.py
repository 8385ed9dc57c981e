"""Small systems of linear equations: by LAPACK for NumPy's numbers, by elimination within the programs of JAX."""

from __future__ import annotations

from typing import Any

import numpy as np

from asperity.engine.arrays import any_xp, is_of_jax, uses_jax, xp
from asperity.engine.dual import Dual, directions_at, highest_level, slopes_at, value_at
from asperity.engine.many import Many, one_by_one
from asperity.types import Array, ArrayLike


def product(matrix: ArrayLike, vector: ArrayLike) -> Array:
    """Product of matrix (..., m, n) and vector (..., n); in programs a part of them instead of a call of its own."""
    result: Any
    if is_of_jax(matrix) or is_of_jax(vector):
        result = (xp.asarray(matrix) * xp.asarray(vector)[..., None, :]).sum(axis=-1)
    elif np.ndim(vector) == 1:
        result = any_xp.matmul(matrix, vector)
    else:
        result = any_xp.matmul(matrix, vector[..., None])[..., 0]  # type: ignore[index]
    found: Array = result
    return found


def solve(matrix: Array, right_side: Array) -> Array:
    """The x, shape (n,), of :math:`A x = b`; not finite where A is singular.

    NumPy's numbers by LAPACK; within programs by Gauss-Jordan elimination with partial pivoting. Derivatives are those
    of the equation, not of the elimination.
    """
    if uses_jax(matrix, right_side):
        from asperity.engine import elimination

        return elimination.solve(matrix, right_side)
    level = highest_level((matrix, right_side))
    if level == 0:
        found: Array = _by_lapack(matrix, right_side)
        return found
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


def _by_lapack(matrix: Any, right_side: Any) -> Any:
    """Of NumPy's numbers; nan where the matrix is singular."""
    try:
        return xp.linalg.solve(matrix, right_side)
    except np.linalg.LinAlgError:
        if isinstance(matrix, Many) or isinstance(right_side, Many):
            return one_by_one(_by_lapack, (matrix, right_side))
        return xp.full(np.shape(right_side), np.nan)


def solve_in_turn(matrix: Array, right_side: Array) -> Array:
    """The x, shape (n,), of :math:`A x = b` in a step of an iteration, whose derivatives nobody asks for.

    NumPy's numbers by LAPACK; within programs one system by elimination, a batch by LAPACK or written out.
    """
    if uses_jax(matrix, right_side):
        from asperity.engine import elimination

        return elimination.solve_in_turn(matrix, right_side)
    found: Array = _by_lapack(matrix, right_side)
    return found


def solve_rows(matrix: Array, right_sides: Array) -> Array:
    """The x of :math:`A x = b` for several b, real or complex, shape (m, n); not finite where A is singular.

    For a matrix that follows from a state, behind the last step of a :func:`solve_in_turn`; within programs with
    derivatives.
    """
    if uses_jax(matrix, right_sides):
        from asperity.engine import elimination

        return elimination.solve_rows(matrix, right_sides)
    found: Array = any_xp.swapaxes(_by_lapack(matrix, any_xp.swapaxes(right_sides, 0, 1)), 0, 1)
    return found


def least_squares(matrix: Array, right_side: Array) -> Array:
    """The x, shape (n,), that makes :math:`|A x - b|` smallest.

    NumPy's numbers by LAPACK; within programs by the normal equations, refined once. Where A, shape (m, n), has a rank
    below n it is not finite, or with NumPy's numbers the shortest of all; nan where A or b is not finite.
    """
    if uses_jax(matrix, right_side):
        from asperity.engine import elimination

        return elimination.least_squares(matrix, right_side)
    if (level := highest_level((matrix, right_side))) > 0:
        return _slopes_of_least_squares(matrix, right_side, level)
    if isinstance(matrix, Many) or isinstance(right_side, Many):
        several: Array = one_by_one(least_squares, (matrix, right_side))
        return several
    if not (np.all(np.isfinite(matrix)) and np.all(np.isfinite(right_side))):
        return xp.full(matrix.shape[1], np.nan)
    shortest: Array = xp.linalg.lstsq(matrix, right_side, rcond=None)[0]
    return shortest


def _slopes_of_least_squares(matrix: Any, right_side: Any, level: int) -> Any:
    """Least squares of numbers with slopes, by the normal equations, of a matrix of full rank."""
    a, b = value_at(matrix, level), value_at(right_side, level)
    x = least_squares(a, b)
    square, left = any_xp.matmul(a.T, a), b - product(a, x)
    count = directions_at((matrix, right_side), level)
    slopes = []
    for of_matrix, of_right in zip(
        slopes_at(matrix, level, count), slopes_at(right_side, level, count), strict=True
    ):
        change: Any = np.zeros(np.shape(b)) if of_right is None else of_right
        right: Any = product(a.T, change)
        if of_matrix is not None:
            right = product(a.T, change - product(of_matrix, x)) + product(of_matrix.T, left)
        slopes.append(solve(square, right))
    return Dual(x, slopes, level)
