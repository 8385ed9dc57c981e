"""Several right sides of one complex system: every engine and way, and derivatives."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.engine.elimination import optimised
from asperity.linear import solve_rows

COUNT, SIDES = 7, 3


def system(scale):
    """A system of waves of unlike sizes, whose rows need other pivots than the diagonal."""
    k = np.arange(COUNT * COUNT).reshape(COUNT, COUNT)
    matrix = np.cos(1.3 * k + 0.7 * k.T) + 1j * np.sin(0.9 * k) + 4.0 * np.eye(COUNT)[::-1]
    sides = np.cos(np.arange(SIDES * COUNT)).reshape(SIDES, COUNT) * (1.0 + 0.5j)
    return scale * matrix, sides


@pytest.mark.parametrize("optimise", [False, True])
def test_programs_against_lapack(optimise):
    matrix, sides = system(1.0)
    expected = np.linalg.solve(matrix, sides.T).T
    np.testing.assert_allclose(solve_rows(matrix, sides), expected, rtol=1e-13)

    def solved(scale):
        return solve_rows(scale * jnp.asarray(matrix), jnp.asarray(sides))

    def both(scale):
        if not optimise:
            return jax.jit(jax.vmap(lambda each: jax.jvp(solved, (each,), (jnp.ones_like(each),))))(scale)
        with optimised():
            return jax.jit(jax.vmap(lambda each: jax.jvp(solved, (each,), (jnp.ones_like(each),))))(scale)

    scales = jnp.array([1.0, 2.0], dtype=complex)
    found, slopes = both(scales)
    for k, scale in enumerate((1.0, 2.0)):
        np.testing.assert_allclose(found[k], expected / scale, rtol=1e-12)
        np.testing.assert_allclose(slopes[k], -expected / scale**2, rtol=1e-11)


def test_a_singular_system_has_no_numbers():
    assert not np.any(np.isfinite(solve_rows(np.zeros((2, 2)), np.ones((3, 2)))))
