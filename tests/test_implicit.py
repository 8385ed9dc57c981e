"""Roots with implicit derivatives: those of roots that are known in closed form."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.implicit import implicit_root


def square_root(number, wrong=0.0):
    """Root of x² = number by Newton's method, a little off if wanted."""

    def search(equations, start):
        x = jax.lax.fori_loop(0, 40, lambda _, x: x - equations(x) / (2.0 * x), start)
        return x + wrong

    return implicit_root(
        lambda x: x * x - number,
        jnp.ones_like(number),
        search,
        lambda linear, y: y / linear(jnp.ones_like(y)),
    )


def test_a_root_and_its_derivatives_in_both_modes():
    numbers = jnp.array([0.25, 2.0, 9.0])
    np.testing.assert_allclose(square_root(numbers), np.sqrt(numbers), rtol=1e-15)
    slopes = jnp.diag(0.5 / jnp.sqrt(numbers))
    np.testing.assert_allclose(jax.jacfwd(square_root)(numbers), slopes, rtol=1e-14)
    np.testing.assert_allclose(jax.jacrev(square_root)(numbers), slopes, rtol=1e-14)
    np.testing.assert_allclose(jax.jit(jax.vmap(jax.grad(square_root)))(numbers), np.diag(slopes), rtol=1e-14)


def test_what_the_search_returns_is_not_changed():
    assert float(square_root(jnp.asarray(2.0), wrong=1e-3)) == pytest.approx(np.sqrt(2.0) + 1e-3, rel=1e-15)


def test_unknowns_with_a_structure():
    def root(p):
        def equations(x):  # u + v = p, u - v = p²
            return {"u": x["u"] + x["v"] - p, "v": x["u"] - x["v"] - p * p}

        def solve(linear, y):
            return {"u": 0.5 * (y["u"] + y["v"]), "v": 0.5 * (y["u"] - y["v"])}

        start = {"u": jnp.zeros(()), "v": jnp.zeros(())}
        return implicit_root(
            equations, start, lambda f, x: jax.tree.map(lambda r: -r, solve(None, f(x))), solve
        )

    value, slope = root(3.0), jax.grad(lambda p: root(p)["u"] * root(p)["v"])(3.0)
    assert (float(value["u"]), float(value["v"])) == (6.0, -3.0)
    # u v = (p² - p⁴)/4
    assert float(slope) == pytest.approx((2.0 * 3.0 - 4.0 * 3.0**3) / 4.0, rel=1e-14)


def test_a_root_inside_a_loop_over_whole_numbers():
    """The loop's counter is a number that the equations close over, but nothing to differentiate."""

    def total(number):
        def add(sum_, k):
            def equations(x):
                return x * x - number * (k + 1).astype(float)

            def search(f, start):
                return jax.lax.fori_loop(0, 40, lambda _, x: x - f(x) / (2.0 * x), start)

            root = implicit_root(
                equations, jnp.ones(()), search, lambda linear, y: y / linear(jnp.ones_like(y))
            )
            return sum_ + root, None

        return jax.lax.scan(add, jnp.zeros(()), jnp.arange(3))[0]

    factor = 1.0 + np.sqrt(2.0) + np.sqrt(3.0)
    assert float(jax.jit(total)(4.0)) == pytest.approx(2.0 * factor, rel=1e-14)
    assert float(jax.jit(jax.grad(total))(4.0)) == pytest.approx(factor / 4.0, rel=1e-14)


def test_a_derivative_inside_a_derivative():
    """A value that is returned beside its slope has its own slope, and the slope has one too."""

    def value_and_slope(number):
        return jax.jvp(square_root, (number,), (jnp.ones_like(number),))

    (value, slope), (first, second) = jax.jvp(value_and_slope, (4.0,), (1.0,))
    assert [float(each) for each in (value, slope, first, second)] == pytest.approx(
        [2.0, 1 / 4, 1 / 4, -1 / 32], rel=1e-14
    )
    _, shown = jax.jvp(lambda x: jax.jvp(square_root, (x,), (1.0,))[0], (4.0,), (1.0,))
    assert float(shown) == pytest.approx(1 / 4, rel=1e-14)
