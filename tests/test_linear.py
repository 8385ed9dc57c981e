"""Small linear systems, against NumPy."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.linear import least_squares, optimised, solve, solve_in_turn


@pytest.mark.parametrize("count", [1, 2, 5, 17])
def test_systems_and_their_derivatives(count):
    rng = np.random.default_rng(count)
    matrix, change = rng.normal(size=(2, count, count))
    right = rng.normal(size=count)
    matrix[0, 0] = 0.0 if count > 1 else 2.0  # needs another pivot
    found, slope = jax.jvp(
        solve, (jnp.array(matrix), jnp.array(right)), (jnp.array(change), jnp.zeros(count))
    )
    expected = np.linalg.solve(matrix, right)
    np.testing.assert_allclose(found, expected, rtol=1e-10)
    np.testing.assert_allclose(slope, -np.linalg.solve(matrix, change @ expected), rtol=1e-9)
    back = jax.grad(lambda b: jnp.sum(solve(jnp.array(matrix), b) ** 2))(jnp.array(right))
    np.testing.assert_allclose(back, np.linalg.solve(matrix.T, 2.0 * expected), rtol=1e-9)


def test_least_squares_of_consistent_and_other_equations():
    rng = np.random.default_rng(1)
    matrix = rng.normal(size=(6, 3)) * np.array([1.0, 1e-3, 30.0])
    exact = np.array([1.0, 200.0, -0.1])
    np.testing.assert_allclose(least_squares(jnp.array(matrix), jnp.array(matrix @ exact)), exact, rtol=1e-12)
    right = rng.normal(size=6)
    expected = np.linalg.lstsq(matrix, right, rcond=None)[0]
    np.testing.assert_allclose(least_squares(jnp.array(matrix), jnp.array(right)), expected, rtol=1e-9)


def test_a_singular_system_has_no_number():
    assert not np.all(np.isfinite(solve(jnp.ones((2, 2)), jnp.array([1.0, 2.0]))))


def test_a_batch_needs_no_lapack():
    systems = jnp.zeros((4, 5, 5))
    program = jax.jit(jax.vmap(solve)).lower(systems, jnp.zeros((4, 5))).as_text()
    assert "lapack" not in program


@pytest.mark.parametrize("count", [1, 2, 6])
def test_one_system_and_a_batch_in_a_step_of_an_iteration(count):
    rng = np.random.default_rng(count)
    matrices, right = rng.normal(size=(70, count, count)), rng.normal(size=(70, count))
    matrices += 10.0 * np.eye(count)  # none is nearly singular
    matrices[0, 0, 0] = 0.0 if count > 1 else 2.0  # needs another pivot
    expected = np.linalg.solve(matrices, right[..., None])[..., 0]
    np.testing.assert_allclose(
        solve_in_turn(jnp.array(matrices[0]), jnp.array(right[0])), expected[0], rtol=1e-10
    )
    np.testing.assert_allclose(
        jax.vmap(solve_in_turn)(jnp.array(matrices), jnp.array(right)), expected, rtol=1e-10
    )
    with optimised():
        np.testing.assert_allclose(
            jax.vmap(solve_in_turn)(jnp.array(matrices), jnp.array(right)), expected, rtol=1e-10
        )
    one_matrix = jax.vmap(solve_in_turn, in_axes=(None, 0))(jnp.array(matrices[0]), jnp.array(right))
    np.testing.assert_allclose(one_matrix, np.linalg.solve(matrices[0], right.T).T, rtol=1e-10)
    one_side = jax.vmap(solve_in_turn, in_axes=(0, None))(jnp.array(matrices), jnp.array(right[0]))
    np.testing.assert_allclose(one_side, np.linalg.solve(matrices, right[0]), rtol=1e-10)


def test_only_a_batch_needs_lapack_in_a_step_of_an_iteration():
    systems, right = jnp.zeros((4, 5, 5)), jnp.zeros((4, 5))
    assert "lapack" in jax.jit(jax.vmap(solve_in_turn)).lower(systems, right).as_text()
    assert "lapack" not in jax.jit(solve_in_turn).lower(systems[0], right[0]).as_text()
    with optimised():
        assert "lapack" not in jax.jit(jax.vmap(solve_in_turn)).lower(systems, right).as_text()


def test_solving_again_compiles_nothing(caplog):
    matrix, right = jnp.array([[2.0, 1.0], [0.0, 4.0]]), jnp.array([4.0, 8.0])
    solve(matrix, right)
    with jax.log_compiles():
        assert solve(matrix, right).tolist() == [1.0, 2.0]
    assert "ompiling" not in caplog.text
