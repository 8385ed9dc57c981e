"""Linear equations within the programs of JAX, against NumPy."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.engine.elimination import least_squares, optimised, solve, solve_in_turn, solve_with


def system(count, *, several=None):
    """Matrices and right sides, of which the first needs another pivot."""
    rng = np.random.default_rng(count)
    shape = (count,) if several is None else (several, count)
    matrix, right = rng.normal(size=(*shape, count)), rng.normal(size=shape)
    if several is not None:
        matrix += 10.0 * np.eye(count)  # none is nearly singular
    first = matrix if several is None else matrix[0]
    first[0, 0] = 0.0 if count > 1 else 2.0
    return matrix, right


@pytest.mark.parametrize("count", [1, 2, 5, 17])
def test_systems_and_their_derivatives(count):
    matrix, right = system(count)
    change, moved = np.random.default_rng(7).normal(size=(count, count)), np.cos(np.arange(count))

    @jax.jit
    def program(matrix, right):
        back = jax.grad(lambda b: jnp.sum(solve(matrix, b) ** 2))(right)
        return *jax.jvp(solve, (matrix, right), (jnp.array(change), jnp.array(moved))), back

    found, slope, back = program(matrix, right)
    expected = np.linalg.solve(matrix, right)
    np.testing.assert_allclose(found, expected, rtol=1e-10)
    np.testing.assert_allclose(slope, np.linalg.solve(matrix, moved - change @ expected), rtol=1e-9)
    np.testing.assert_allclose(back, np.linalg.solve(matrix.T, 2.0 * expected), rtol=1e-9)


def test_the_derivatives_are_those_of_the_linear_function():
    """(1 + p) A x = b, eliminated by a matrix that is taken for constant: x' = -x/(1 + p)."""
    matrix, right = system(3)

    def of(p, right):
        return solve_with(lambda x: (1.0 + p) * (matrix @ x), jnp.array(1.25 * matrix), right)

    @jax.jit
    def program(right):
        return *jax.jvp(lambda p: of(p, right), (0.25,), (1.0,)), jax.grad(lambda b: of(0.25, b)[1])(right)

    found, slope, back = program(right)
    x = np.linalg.solve(1.25 * matrix, right)
    np.testing.assert_allclose(found, x, rtol=1e-12)
    np.testing.assert_allclose(slope, -x / 1.25, rtol=1e-12)
    np.testing.assert_allclose(back, np.linalg.inv(1.25 * matrix)[1], rtol=1e-12)


def test_the_largest_pivot_is_taken_and_a_singular_system_has_no_number():
    """With the first pivot, 1e-20, the first unknown would be lost to rounding."""
    matrices = np.array([[[1e-20, 1.0], [1.0, 1.0]], [[1.0, 1.0], [1.0, 1.0]]])
    right = np.array([[1.0, 2.0], [1.0, 2.0]])

    @jax.jit
    def program(matrices, right):
        with optimised():
            written_out = jax.vmap(solve_in_turn)(matrices, right)
        return jax.vmap(solve)(matrices, right), jax.vmap(solve_in_turn)(matrices, right), written_out

    for found in program(matrices, right):
        np.testing.assert_allclose(found[0], [1.0, 1.0], rtol=1e-14)
        assert not np.all(np.isfinite(found[1]))


def test_a_batch_needs_no_lapack():
    systems = jnp.zeros((4, 5, 5))
    program = jax.jit(jax.vmap(solve)).lower(systems, jnp.zeros((4, 5))).as_text()
    assert "lapack" not in program


@pytest.mark.parametrize("count", [1, 2, 6])
def test_one_system_and_a_batch_in_a_step_of_an_iteration(count):
    matrices, right = system(count, several=70)

    @jax.jit
    def program(matrices, right):
        with optimised():
            written_out = jax.vmap(solve_in_turn)(matrices, right)
        return (
            solve_in_turn(matrices[0], right[0]),
            jax.vmap(solve_in_turn)(matrices, right),
            written_out,
            jax.vmap(solve_in_turn, in_axes=(None, 0))(matrices[0], right),
            jax.vmap(solve_in_turn, in_axes=(0, None))(matrices, right[0]),
        )

    one, batch, written_out, one_matrix, one_side = program(matrices, right)
    expected = np.linalg.solve(matrices, right[..., None])[..., 0]
    np.testing.assert_allclose(one, expected[0], rtol=1e-10)
    np.testing.assert_allclose(batch, expected, rtol=1e-10)
    np.testing.assert_allclose(written_out, expected, rtol=1e-10)
    np.testing.assert_allclose(one_matrix, np.linalg.solve(matrices[0], right.T).T, rtol=1e-10)
    np.testing.assert_allclose(one_side, np.linalg.solve(matrices, right[0]), rtol=1e-10)


def test_only_a_batch_needs_lapack_in_a_step_of_an_iteration():
    systems, right = jnp.zeros((4, 5, 5)), jnp.zeros((4, 5))
    assert "lapack" in jax.jit(jax.vmap(solve_in_turn)).lower(systems, right).as_text()
    assert "lapack" not in jax.jit(solve_in_turn).lower(systems[0], right[0]).as_text()
    with optimised():
        assert "lapack" not in jax.jit(jax.vmap(solve_in_turn)).lower(systems, right).as_text()


def test_optimisation_ends_with_its_block():
    """Also with one that fails; and a block within another does not end that one."""
    systems, right = jnp.zeros((4, 2, 2)), jnp.zeros((4, 2))

    def by_lapack():
        program = jax.jit(jax.vmap(lambda *given: solve_in_turn(*given)))  # traced anew
        return "lapack" in program.lower(systems, right).as_text()

    def fails():
        with optimised():
            with optimised():
                seen.append(by_lapack())
            seen.append(by_lapack())
            raise ArithmeticError

    seen = []
    with pytest.raises(ArithmeticError):
        fails()
    assert [*seen, by_lapack()] == [False, False, True]


def test_least_squares_of_consistent_and_other_equations():
    rng = np.random.default_rng(1)
    matrix = rng.normal(size=(6, 3)) * np.array([1.0, 1e-3, 30.0])
    exact = np.array([1.0, 200.0, -0.1])
    np.testing.assert_allclose(least_squares(jnp.array(matrix), jnp.array(matrix @ exact)), exact, rtol=1e-12)
    right = rng.normal(size=6)
    expected = np.linalg.lstsq(matrix, right, rcond=None)[0]
    np.testing.assert_allclose(least_squares(jnp.array(matrix), jnp.array(right)), expected, rtol=1e-9)


def test_solving_again_compiles_nothing(caplog):
    matrix, right = jnp.array([[2.0, 1.0], [0.0, 4.0]]), jnp.array([4.0, 8.0])
    solve(matrix, right)
    with jax.log_compiles():
        assert solve(matrix, right).tolist() == [1.0, 2.0]
    assert "ompiling" not in caplog.text
