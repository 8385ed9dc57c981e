"""Roots with implicit derivatives: those of roots that are known in closed form."""

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.engine.arrays import xp
from asperity.engine.control import fori_loop, vectorised
from asperity.engine.derivatives import linearised, value_and_slope
from asperity.implicit import implicit_root, settled_root


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


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_a_root_and_its_derivatives_in_both_modes():
    numbers = jnp.array([0.25, 2.0, 9.0])
    np.testing.assert_allclose(square_root(numbers), np.sqrt(numbers), rtol=1e-15)
    slopes = jnp.diag(0.5 / jnp.sqrt(numbers))
    np.testing.assert_allclose(jax.jacfwd(square_root)(numbers), slopes, rtol=1e-14)
    np.testing.assert_allclose(jax.jacrev(square_root)(numbers), slopes, rtol=1e-14)
    np.testing.assert_allclose(jax.jit(jax.vmap(jax.grad(square_root)))(numbers), np.diag(slopes), rtol=1e-14)


def test_what_the_search_returns_is_not_changed():
    assert float(square_root(jnp.asarray(2.0), wrong=1e-3)) == pytest.approx(np.sqrt(2.0) + 1e-3, rel=1e-15)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
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


@pytest.mark.programs("derivatives by JAX, one operation after the other")
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


def rooted(number):
    """Root of x² = number by the loop of the package, which is Python's for known numbers."""

    def search(equations, start):
        return fori_loop(0, 40, lambda _, x: x - equations(x) / (2.0 * x), start)

    return implicit_root(
        lambda x: x * x - number, 1.0 + 0.0 * number, search, lambda linear, y: y / linear(1.0 + 0.0 * y)
    )


def test_slopes_of_a_root_of_known_numbers_are_those_of_jax():
    numbers, along = np.array([0.25, 2.0, 9.0]), np.array([1.0, -2.0, 0.5])
    found = value_and_slope(rooted, (numbers,), (along,))
    expected = jax.jit(lambda *given: jax.jvp(rooted, given[:1], given[1:]))(numbers, along)
    assert all(type(each) is np.ndarray for each in found)
    np.testing.assert_allclose(found, expected, rtol=1e-14)
    np.testing.assert_allclose(found, [np.sqrt(numbers), 0.5 * along / np.sqrt(numbers)], rtol=1e-14)
    np.testing.assert_allclose(rooted(numbers), np.sqrt(numbers), rtol=1e-15)
    of_many = vectorised(lambda x, y: value_and_slope(rooted, (x,), (y,)))(numbers, along)
    np.testing.assert_allclose(of_many, found, rtol=1e-14)


def test_slopes_of_slopes_of_a_root_of_known_numbers_are_those_of_jax():
    """By one number twice, and by one inside and another outside."""

    def twice(slope, x):
        return slope(lambda y: slope(rooted, (y,), (1.0,)), (x,), (1.0,))

    def mixed(slope, x, y):
        return slope(lambda y: slope(lambda x: rooted(x * y), (x,), (1.0,)), (y,), (1.0,))

    for function, at in ((twice, (np.float64(4.0),)), (mixed, (np.float64(2.0), np.float64(8.0)))):
        found = jax.tree.leaves(function(value_and_slope, *at))
        expected = jax.jit(partial(function, jax.jvp))(*at)
        np.testing.assert_allclose(found, jax.tree.leaves(expected), rtol=1e-13)


def test_a_search_may_take_slopes_of_the_equations():
    """Newton's method for u² + v = p and u - v = 2, of which p has slopes of two levels: u² + u = p + 2."""

    def root(p):
        def solve(linear, y):
            one, zero = xp.ones_like(y[0]), xp.zeros_like(y[0])
            (a, c), (b, d) = linear((one, zero)), linear((zero, one))
            determinant = a * d - b * c
            return (d * y[0] - b * y[1]) / determinant, (a * y[1] - c * y[0]) / determinant

        def search(equations, x):
            for _ in range(8):
                value, linear = linearised(equations, x)
                x = tuple(each - step for each, step in zip(x, solve(linear, value), strict=True))
            return x

        def equations(x):
            return x[0] ** 2 + x[1] - p, x[0] - x[1] - 2.0

        return implicit_root(equations, (np.array([3.0, 3.0]), np.array([1.0, 1.0])), search, solve)[0]

    p, along = np.array([4.0, 10.0]), np.array([1.0, -2.0])
    discriminant = np.sqrt(4.0 * p + 9.0)
    np.testing.assert_allclose(root(p), 0.5 * (discriminant - 1.0), rtol=1e-14)
    found = value_and_slope(lambda q: value_and_slope(root, (q,), (along,)), (p,), (along,))
    (value, first), (again, second) = found
    np.testing.assert_allclose(value, root(p), rtol=1e-14)
    np.testing.assert_allclose([first, again], [along / discriminant] * 2, rtol=1e-14)
    np.testing.assert_allclose(second, -2.0 * along**2 / discriminant**3, rtol=1e-13)


def settled(p):
    """Numbers above 0 that a function of them gives back."""

    def change(x):
        return xp.stack([0.3 * xp.cos(p * x[0]) + 0.5 - x[0], 1.0 + 0.1 * p * x[0] * x[1] - x[1]])

    return settled_root(change, xp.stack([0.5 + 0.0 * p, 1.0 + 0.0 * p]))


def test_numbers_that_a_function_gives_back_and_their_slopes_are_those_of_jax():
    """x = 0.3 cos(p x) + 0.5 and y = 1/(1 - p x/10), of which the second follows from the first."""
    of_jax = jax.jit(lambda p: jax.jvp(settled, (p,), (1.0,)))
    for at in (1.0, 1.4):
        (x, y), (dx, dy) = value_and_slope(settled, (np.float64(at),), (np.float64(1.0),))
        assert x == pytest.approx(0.3 * np.cos(at * x) + 0.5, rel=1e-8)
        assert y == pytest.approx(1.0 / (1.0 - 0.1 * at * x), rel=1e-8)
        sine = 0.3 * np.sin(at * x)
        assert dx == pytest.approx(-sine * x / (1.0 + sine * at), rel=1e-12)
        assert dy == pytest.approx(0.1 * y * (x + at * dx) / (1.0 - 0.1 * at * x), rel=1e-8)
        np.testing.assert_allclose([[x, y], [dx, dy]], of_jax(at), rtol=1e-9)
    found = vectorised(lambda p: value_and_slope(settled, (p,), (1.0,)))(np.array([1.0, 1.4]))
    np.testing.assert_allclose([found[0][1], found[1][1]], [[x, y], [dx, dy]], rtol=1e-9)


@pytest.mark.programs("operations by JAX, one after the other")
def test_slopes_of_slopes_of_numbers_that_a_function_gives_back_are_those_of_jax():
    def twice(slope, p):
        return slope(lambda p: slope(settled, (p,), (1.0,)), (p,), (1.0,))

    found, expected = twice(value_and_slope, 1.2), jax.jit(partial(twice, jax.jvp))(1.2)
    np.testing.assert_allclose(jax.tree.leaves(found), jax.tree.leaves(expected), rtol=1e-8)
