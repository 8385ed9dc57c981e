"""Small linear systems without LAPACK, against LAPACK."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.planar.linear import least_squares, solve


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


def test_solving_again_compiles_nothing(caplog):
    matrix, right = jnp.array([[2.0, 1.0], [0.0, 4.0]]), jnp.array([4.0, 8.0])
    solve(matrix, right)
    with jax.log_compiles():
        assert solve(matrix, right).tolist() == [1.0, 2.0]
    assert "ompiling" not in caplog.text
