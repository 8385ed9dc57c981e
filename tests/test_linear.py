"""Small linear systems of known numbers, with slopes, of many at once and in programs, against NumPy."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.engine.arrays import xp
from asperity.engine.control import vectorised
from asperity.engine.derivatives import value_and_slope
from asperity.linear import least_squares, product, solve, solve_in_turn

RNG = np.random.default_rng(5)
# as many systems as unknowns: an axis taken for another changes numbers, not only shapes
MATRICES = RNG.normal(size=(4, 4, 4)) + 3.0 * np.eye(4)
RIGHT = RNG.normal(size=(4, 4))
SOLUTIONS = np.linalg.solve(MATRICES, RIGHT[..., None])[..., 0]


def test_products_of_matrices_and_vectors():
    expected = np.einsum("...ij,...j->...i", MATRICES, RIGHT)
    np.testing.assert_allclose(product(MATRICES, RIGHT), expected, rtol=1e-13)
    np.testing.assert_allclose(vectorised(product)(MATRICES, RIGHT), expected, rtol=1e-13)
    one_stack = vectorised(lambda vector: product(MATRICES, vector))(RIGHT)
    np.testing.assert_allclose(one_stack, np.einsum("kij,nj->nki", MATRICES, RIGHT), rtol=1e-13)
    one_matrix = vectorised(lambda vectors: product(MATRICES[0], vectors))(MATRICES)
    np.testing.assert_allclose(one_matrix, np.einsum("ij,nkj->nki", MATRICES[0], MATRICES), rtol=1e-13)
    many_stacks = vectorised(lambda a, b: product(xp.stack([a, 2.0 * a, -a, a.T]), b))(MATRICES, RIGHT)
    stacks = np.stack([MATRICES, 2.0 * MATRICES, -MATRICES, MATRICES.transpose(0, 2, 1)], axis=1)
    np.testing.assert_allclose(many_stacks, np.einsum("nkij,nj->nki", stacks, RIGHT), rtol=1e-13)
    assert product([[1.0, 2.0]], [3.0, 4.0]).tolist() == [11.0]
    assert isinstance(product(MATRICES[0], jnp.array(RIGHT[0])), jax.Array)


@pytest.mark.parametrize("function", [solve, solve_in_turn])
def test_the_numbers_choose_the_engine(function):
    for given in (np.asarray, jnp.asarray):
        found = function(given(MATRICES[0]), RIGHT[0])
        assert isinstance(found, jax.Array) == (given is jnp.asarray)
        np.testing.assert_allclose(found, SOLUTIONS[0], rtol=1e-12)
    assert isinstance(function(MATRICES[0], jnp.asarray(RIGHT[0])), jax.Array)


@pytest.mark.parametrize("function", [solve, solve_in_turn])
def test_many_systems_at_once(function):
    np.testing.assert_allclose(vectorised(function)(MATRICES, RIGHT), SOLUTIONS, rtol=1e-12)
    one_matrix = vectorised(lambda b: function(MATRICES[0], b))(RIGHT)
    np.testing.assert_allclose(one_matrix, np.linalg.solve(MATRICES[0], RIGHT.T).T, rtol=1e-12)
    one_side = vectorised(lambda a: function(a, RIGHT[0]))(MATRICES)
    np.testing.assert_allclose(one_side, np.linalg.solve(MATRICES, RIGHT[0]), rtol=1e-12)


@pytest.mark.parametrize("function", [solve, solve_in_turn])
def test_a_singular_system_has_no_number(function):
    """And among many the others have theirs."""
    singular = np.ones((2, 2))
    for number in (np.asarray, jnp.asarray):
        found = function(number(singular), number([1.0, 2.0]))
        assert found.shape == (2,)
        assert not np.all(np.isfinite(found))
    several = np.stack([2.0 * np.eye(2), singular, np.eye(2)]), np.array([[2.0, 4.0], [1.0, 2.0], [5.0, 6.0]])
    for over in (vectorised, jax.vmap):
        found = over(function)(*several)
        assert not np.all(np.isfinite(found[1]))
        assert found[0].tolist() == [1.0, 2.0]
        assert found[2].tolist() == [5.0, 6.0]


def test_slopes_are_those_of_the_equation():
    """A x' = b' - A' x, also where only one of both changes."""
    a, b, da, db = MATRICES[0], RIGHT[0], MATRICES[1], RIGHT[1]
    x = SOLUTIONS[0]
    by_matrix, by_right = -np.linalg.solve(a, da @ x), np.linalg.solve(a, db)
    for slopes in (value_and_slope, jax.jvp):
        found = [
            slopes(solve, (a, b), (da, db))[1],
            slopes(lambda a: solve(a, b), (a,), (da,))[1],
            slopes(lambda b: solve(a, b), (b,), (db,))[1],
        ]
        np.testing.assert_allclose(found, [by_matrix + by_right, by_matrix, by_right], rtol=1e-11)


def test_slopes_of_slopes_and_of_many_systems():
    """A x'' = -2 A' x' of systems that change at a constant rate."""
    rates = MATRICES[::-1].copy(), RIGHT[::-1].copy()
    slopes = np.linalg.solve(MATRICES, (rates[1] - np.einsum("kij,kj->ki", rates[0], SOLUTIONS))[..., None])
    second = np.linalg.solve(MATRICES, -2.0 * rates[0] @ slopes)

    def twice(*given):
        at, along = given[:2], given[2:]
        return value_and_slope(lambda *x: value_and_slope(solve, x, along), at, along)

    (found, first), (again, last) = vectorised(twice)(MATRICES, RIGHT, *rates)
    np.testing.assert_allclose(found, SOLUTIONS, rtol=1e-12)
    for each in (first, again):
        np.testing.assert_allclose(each, slopes[..., 0], rtol=1e-11)
    np.testing.assert_allclose(last, second[..., 0], rtol=1e-10)
    alone = twice(MATRICES[2], RIGHT[2], rates[0][2], rates[1][2])
    np.testing.assert_allclose(alone, [[found[2], first[2]], [again[2], last[2]]], rtol=1e-11)


def test_slopes_of_one_system_of_which_many_right_sides_change():
    found = vectorised(
        lambda b, db: value_and_slope(lambda p: solve(MATRICES[0] * (1.0 + p), b + p * db), (0.0,), (1.0,))[1]
    )(RIGHT, RIGHT[::-1].copy())
    expected = np.linalg.solve(MATRICES[0], (RIGHT[::-1]).T).T - np.linalg.solve(MATRICES[0], RIGHT.T).T
    np.testing.assert_allclose(found, expected, rtol=1e-11)


def test_least_squares_of_consistent_and_other_equations():
    matrix = RNG.normal(size=(6, 3)) * np.array([1.0, 1e-3, 30.0])
    exact, right = np.array([1.0, 200.0, -0.1]), RNG.normal(size=6)
    expected = np.linalg.solve(matrix.T @ matrix, matrix.T @ right)
    for number in (np.asarray, jnp.asarray):
        # normal equations refined once leave some (cond^2 eps)^2, and rounding of the residual times cond, 3e4 here
        np.testing.assert_allclose(least_squares(number(matrix), number(matrix @ exact)), exact, rtol=1e-10)
        np.testing.assert_allclose(least_squares(number(matrix), number(right)), expected, rtol=1e-8)
    assert isinstance(least_squares(matrix, jnp.asarray(right)), jax.Array)


def test_least_squares_of_many_equations_at_once():
    matrices, right = RNG.normal(size=(3, 5, 3)), RNG.normal(size=(3, 5))
    expected = [np.linalg.solve(a.T @ a, a.T @ b) for a, b in zip(matrices, right, strict=True)]
    np.testing.assert_allclose(vectorised(least_squares)(matrices, right), expected, rtol=1e-11)
    one_side = vectorised(lambda a: least_squares(a, right[0]))(matrices)
    np.testing.assert_allclose(one_side, [np.linalg.pinv(a) @ right[0] for a in matrices], rtol=1e-11)
    one_matrix = vectorised(lambda b: least_squares(matrices[0], b))(right)
    np.testing.assert_allclose(one_matrix, right @ np.linalg.pinv(matrices[0]).T, rtol=1e-11)
    right[1, 0] = np.nan
    found = vectorised(least_squares)(matrices, right)
    assert np.isnan(found[1]).all()
    np.testing.assert_allclose([found[0], found[2]], [expected[0], expected[2]], rtol=1e-11)


def test_least_squares_of_too_few_equations_are_the_shortest():
    found = least_squares(np.array([[1.0, 1.0], [2.0, 2.0]]), np.array([2.0, 4.0]))
    np.testing.assert_allclose(found, [1.0, 1.0], rtol=1e-14)


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_least_squares_of_what_is_not_finite_are_no_number(bad):
    matrix, right = np.eye(3)[:, :2], np.ones(3)
    assert np.isnan(least_squares(matrix, np.array([1.0, bad, 1.0]))).tolist() == [True, True]
    assert np.isnan(least_squares(np.where(matrix > 0.0, bad, 0.0), right)).tolist() == [True, True]


def test_a_system_within_a_formula():
    """The stiffness 1/(1ᵀ K⁻¹ 1) of springs k and k² in series, k³/(k + k²), by both engines."""

    def stiffness(k):
        between = solve(xp.diag(xp.stack([k, k * k])), np.ones(2))
        return 1.0 / xp.sum(between)

    k = 3.0
    expected = k**3 / (k + k**2), 1.0 - 1.0 / (1.0 + k) ** 2
    assert value_and_slope(stiffness, (k,), (1.0,)) == pytest.approx(expected, rel=1e-14)
    np.testing.assert_allclose(jax.jvp(stiffness, (k,), (1.0,)), expected, rtol=1e-13)
