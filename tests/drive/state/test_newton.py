"""Roots of equations with positive unknowns, and their derivatives."""

import jax
import jax.flatten_util
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.state.newton import newton


def step_of(equations):
    """Newton steps with the slopes of forward differentiation."""

    def step_at(x):
        flat, shape = jax.flatten_util.ravel_pytree(x)

        def residual(at):
            return jax.flatten_util.ravel_pytree(equations(shape(at)))[0]

        return shape(jnp.linalg.solve(jax.jacfwd(residual)(flat), residual(flat)))

    return step_at


def test_circle_and_hyperbola():
    """x^2 + y^2 = 5 and x y = 2 meet at (2, 1), beside (1, 2) and both negatives."""

    def equations(x):
        return {"a": x["a"] ** 2 + x["b"] ** 2 - 5.0, "b": x["a"] * x["b"] - 2.0}

    found, last = newton(step_of(equations), {"a": jnp.asarray(3.0), "b": jnp.asarray(0.5)}, positive=2)
    assert float(last) < 1e-6
    assert (float(found["a"]), float(found["b"])) == pytest.approx((2.0, 1.0), rel=1e-12)


def test_positive_unknowns_stay_positive():
    """ln x = -3 from 1: the whole first step would lead to -2, where the logarithm has no value."""
    found, _ = newton(step_of(lambda x: jnp.log(x) + 3.0), jnp.array([1.0]), positive=1)
    assert float(found[0]) == pytest.approx(np.exp(-3.0), rel=1e-12)


def test_a_step_keeps_a_fifth_of_a_positive_unknown():
    """x = -3 has no positive root: sixty steps that each keep a fifth."""
    found, last = newton(step_of(lambda x: x + 3.0), jnp.array([1.0]), positive=1)
    assert float(last) == pytest.approx(3.0)
    assert float(jnp.log(found[0])) == pytest.approx(60.0 * np.log(0.2), rel=1e-12)


def test_a_search_for_unknowns_that_are_not_determined_is_given_up():
    """x + y = 1 and x + y = 2 have no root; the first step is as long as rounding makes it."""
    _, last = newton(
        step_of(lambda x: jnp.array([x[0] + x[1] - 1.0, (1.0 + 1e-14) * x[0] + x[1] - 2.0])),
        jnp.ones(2),
        positive=1,
        longest=1e4,
    )
    assert not float(last) < 1e4


@pytest.mark.parametrize(
    ("equation", "start", "steps"),
    [
        # x^2 = 2: after 1e-4 a step of 1e-8/(2 sqrt 2), and the next one would be 4e-18
        (lambda x: x * x - 2.0, 2.0**0.5 + 1e-4, 2),
        # x^2 = 0: every step is half as long as the one before, until a quarter of one is below 1e-13
        (lambda x: x * x, 1.0, 42),
    ],
)
def test_a_search_ends_where_the_next_step_would_be_rounding(equation, start, steps):
    count = []

    def step_at(x):
        jax.debug.callback(lambda _: count.append(1), x[0])
        return step_of(equation)(x)

    x, _ = newton(step_at, jnp.array([start]), positive=1)
    jax.block_until_ready(x)
    jax.effects_barrier()
    assert len(count) == steps
    assert abs(float(equation(x[0]))) < 1e-15
