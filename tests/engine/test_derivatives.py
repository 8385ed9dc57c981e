"""Slopes of functions, and functions with rules for theirs, under both engines."""

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.engine.arrays import is_of_jax, xp
from asperity.engine.control import vectorised
from asperity.engine.derivatives import (
    jacobian,
    linearised,
    slopes_apart,
    value_and_partial_slopes,
    value_and_slope,
    value_and_slopes,
    with_rule,
    without_slopes,
)
from asperity.engine.dual import Dual
from asperity.engine.many import Many
from asperity.engine.module import Module, static


class Numbers(Module):
    one: object
    other: object = None
    kind: str = static(default="a")


def formula(module, factor):
    """Numbers of several shapes, of which some do not depend on all that is given."""
    area = module.one * module.one
    return Numbers(factor * area, {"sum": xp.sum(area), "factor": xp.exp(factor), "count": 3}, "made")


AT = Numbers(np.array([1.0, -2.0]), None, "b"), 0.5
ALONG = Numbers(np.array([0.25, 4.0]), None, "b"), -3.0
AREA, CHANGE = np.array([1.0, 4.0]), np.array([0.5, -16.0])


def test_value_and_slope_of_modules():
    value, slope = value_and_slope(formula, AT, ALONG)
    assert (value.kind, slope.kind) == ("made", "made")
    np.testing.assert_allclose(value.one, 0.5 * AREA, rtol=1e-15)
    np.testing.assert_allclose(slope.one, 0.5 * CHANGE - 3.0 * AREA, rtol=1e-15)
    assert (value.other["sum"], slope.other["sum"]) == (5.0, -15.5)
    assert value.other["factor"] == pytest.approx(np.exp(0.5), rel=1e-15)
    assert slope.other["factor"] == pytest.approx(-3.0 * np.exp(0.5), rel=1e-15)
    assert (value.other["count"], slope.other["count"]) == (3, 0.0)


def test_slopes_in_several_directions_with_and_without_jax():
    nothing = Numbers(np.zeros(2), None, "b"), 0.0
    only = Numbers(np.zeros(2), None, "b"), 1.0

    def of_both(*at):
        value, slopes = value_and_slopes(lambda *given: formula(*given).one, at, [ALONG, nothing, only])
        return [value, *slopes]

    expected = [0.5 * AREA, 0.5 * CHANGE - 3.0 * AREA, 0.0 * AREA, AREA]
    np.testing.assert_allclose(of_both(*AT), expected, rtol=1e-15)
    np.testing.assert_allclose(jax.jit(of_both)(*AT), expected, rtol=1e-15)


def test_numbers_of_jax_among_the_directions_or_the_numbers():
    for at, along in (((2.0,), (jnp.asarray(3.0),)), ((jnp.asarray(2.0),), (3.0,))):
        value, slope = value_and_slope(lambda x: x * x, at, along)
        assert (float(value), float(slope)) == (4.0, 12.0)
        assert is_of_jax(slope)
        assert float(value_and_slopes(lambda x: x * x, at, [along])[1][0]) == 12.0


@pytest.mark.parametrize("engine", [np, jnp])
def test_slopes_by_each_of_several_arrays(engine):
    x, y = engine.asarray([1.0, -2.0]), engine.asarray([3.0, 0.5])
    value, slopes = value_and_partial_slopes(
        lambda x, y: {"product": x * x * y, "sum": x + xp.exp(y)}, (x, y)
    )
    np.testing.assert_allclose(value["product"], [3.0, 2.0], rtol=1e-15)
    for slope, product, total in zip(slopes, ([6.0, -2.0], [1.0, 4.0]), (1.0, np.exp(y)), strict=True):
        np.testing.assert_allclose(slope["product"], product, rtol=1e-15)
        np.testing.assert_allclose(slope["sum"], total + np.zeros(2), rtol=1e-15)


def test_counts_and_conditions_are_no_numbers_with_slopes():
    seen = []

    def function(x, count, chosen, places):
        seen.extend([type(count), type(chosen), places.dtype])
        return x[places] * count if chosen else x

    given = np.array([1.0, 2.0]), 3, True, np.array([1, 0])
    value, slope = value_and_slope(function, given, (np.array([5.0, 7.0]), 1, True, np.array([1, 1])))
    assert seen == [int, bool, np.dtype(int)]
    assert (value.tolist(), slope.tolist()) == ([6.0, 3.0], [21.0, 15.0])


def test_what_has_no_slope_costs_nothing():
    kinds = []

    def function(x, y):
        kinds.append((type(x), type(y)))
        return x + y

    nothing = np.zeros(2)
    value_and_slope(function, (np.ones(2), np.ones(2)), (np.ones(2), nothing))
    value_and_slopes(function, (np.ones(2), np.ones(2)), [(nothing, nothing), (nothing, np.ones(2))])
    value_and_slope(function, (np.ones(2), np.ones(2)), (np.array([np.nan, 0.0]), nothing))
    assert kinds == [(Dual, np.ndarray), (np.ndarray, Dual), (Dual, np.ndarray)]


def test_levels_end_also_where_a_function_fails():
    def fails(x):
        raise ArithmeticError

    with pytest.raises(ArithmeticError):
        value_and_slope(fails, (1.0,), (1.0,))
    levels = []
    value_and_slope(lambda x: levels.append(x.level) or x, (1.0,), (1.0,))
    assert levels == [1]


def partly_constant(x):
    module = without_slopes(Numbers(x * x, (x,)))
    return x * module.one + module.other[0]


def test_numbers_without_slopes_count_as_constants():
    assert value_and_slope(partly_constant, (3.0,), (1.0,)) == (30.0, 9.0)
    value, slope = jax.jvp(partly_constant, (3.0,), (1.0,))
    assert (float(value), float(slope)) == (30.0, 9.0)


def test_numbers_without_slopes_have_none_of_any_level():
    second = value_and_slope(lambda x: value_and_slope(partly_constant, (x,), (1.0,)), (3.0,), (1.0,))
    assert second == ((30.0, 9.0), (9.0, 0.0))


def test_where_nothing_has_slopes_the_module_stays_the_same():
    module = Numbers(1.0)
    assert without_slopes(module) is module


def of_three(x):
    return xp.stack([x[0] * x[1], xp.sin(x[2]), 4.0 * x[0], xp.asarray(5.0)])


X = np.array([2.0, 3.0, 0.5])
BY_THREE = np.array([[3.0, 2.0, 0.0], [0.0, 0.0, np.cos(0.5)], [4.0, 0.0, 0.0], [0.0, 0.0, 0.0]])


def test_slopes_of_an_array_by_an_array():
    for found in (jacobian(of_three, X), jax.jit(lambda x: jacobian(of_three, x))(X)):
        np.testing.assert_allclose(found, BY_THREE, rtol=1e-15)


def test_slopes_of_a_number_and_of_a_constant_and_by_nothing():
    assert jacobian(lambda x: x[0] * x[2], X).tolist() == [0.5, 0.0, 2.0]
    assert jacobian(lambda x: np.ones(2), X).tolist() == [[0.0] * 3] * 2
    assert jacobian(lambda x: np.ones(2), np.zeros(0)).shape == (2, 0)


def test_slopes_of_an_array_by_an_array_for_each_of_many():
    points = np.stack([X, 2.0 * X, X[::-1]])
    expected = jax.jit(jax.vmap(jax.jacfwd(of_three)))(points)
    np.testing.assert_allclose(vectorised(lambda x: jacobian(of_three, x))(points), expected, rtol=1e-14)


def test_slopes_of_slopes_of_an_array_by_an_array():
    def function(x):
        return x[0] * x[0] * x[1] + xp.cos(x[2])

    hessian = [[6.0, 4.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, -np.cos(0.5)]]
    np.testing.assert_allclose(jacobian(lambda x: jacobian(function, x), X), hessian, rtol=1e-15)
    along = np.array([1.0, -2.0, 4.0])
    found = value_and_slope(lambda x: jacobian(function, x), (X,), (along,))[1]
    np.testing.assert_allclose(found, hessian @ along, rtol=1e-14)


def scaled(module):
    return Numbers(module.one * module.other, xp.sum(module.one))


POINT = Numbers(np.array([2.0, 3.0]), np.array([5.0, 7.0]))
DIRECTION = Numbers(np.array([1.0, -1.0]), np.array([0.5, 2.0]))


def test_value_and_slope_as_a_function_of_the_direction():
    def both(at, along):
        value, linear = linearised(scaled, at)
        return value, linear(along), linear(at)

    for found in (both(POINT, DIRECTION), jax.jit(both)(POINT, DIRECTION)):
        value, slope, other = found
        np.testing.assert_allclose(value.one, [10.0, 21.0], rtol=1e-15)
        np.testing.assert_allclose(slope.one, [6.0, -1.0], rtol=1e-15)
        np.testing.assert_allclose(other.one, [20.0, 42.0], rtol=1e-15)
        assert [float(each.other) for each in found] == [5.0, 0.0, 5.0]


def test_slopes_of_a_linearised_function():
    def of_point(x):
        _, linear = linearised(lambda y: y * y * y, x)
        return linear(2.0)

    assert value_and_slope(of_point, (3.0,), (1.0,)) == (54.0, 36.0)
    _, linear = linearised(lambda y: y * y * y, 3.0)
    assert value_and_slope(linear, (2.0,), (1.0,)) == (54.0, 27.0)


def test_a_linearised_function_of_many():
    found = vectorised(lambda x, y: linearised(lambda z: z * z, x)[1](y))(np.arange(3.0), np.arange(1.0, 4.0))
    assert found.tolist() == [0.0, 4.0, 12.0]


def test_slopes_of_a_module_one_module_for_each_direction():
    module = Numbers(Dual(np.ones(2), [np.array([3.0, 4.0]), None], 2), (Dual(1.0, [5.0], 1), np.zeros(3)))
    first, second = slopes_apart(module, 2)
    assert (first.one.tolist(), second.one.tolist()) == ([3.0, 4.0], [0.0, 0.0])
    assert (first.other[0], first.other[1].tolist()) == (0.0, [0.0] * 3)
    (lower,) = slopes_apart(module, 1)
    assert (lower.one.tolist(), lower.other[0]) == ([0.0, 0.0], 5.0)
    assert slopes_apart(Numbers(1.0), 1) == []


@with_rule
def marked(x, y):
    """x² y."""
    marked.calls.append((x, y))
    return x * x * y


@marked.defjvp
def _marked_slope(primals, tangents):
    """Ten times what it should be by y, so that it is seen whose slope is found."""
    (x, y), (dx, dy) = primals, tangents
    marked.rules.append(tangents)
    value = marked(x, y)
    return value, 2.0 * x * y * dx + 10.0 * (value / y) * dy


@pytest.fixture(autouse=True)
def _nothing_called():
    marked.calls, marked.rules = [], []


def test_a_function_with_a_rule_where_nothing_has_slopes():
    assert marked(3.0, 2.0) == 18.0
    assert float(marked(jnp.asarray(3.0), 2.0)) == 18.0
    assert vectorised(marked)(np.array([3.0, 4.0]), np.array([2.0, 1.0])).tolist() == [18.0, 16.0]
    assert (marked.__doc__, marked.__name__, marked.__module__) == ("x² y.", "marked", __name__)
    assert marked.rules == []


def test_the_slope_is_that_of_the_rule_in_both_engines():
    at, along = (3.0, 2.0), (1.0, 0.5)
    expected = 18.0, 12.0 + 45.0
    assert value_and_slope(marked, at, along) == expected
    np.testing.assert_allclose(jax.jvp(marked, at, along), expected, rtol=1e-15)
    assert [float(each) for each in jax.grad(marked, argnums=(0, 1))(*at)] == [12.0, 90.0]
    found = vectorised(lambda x: value_and_slope(marked, (x, 2.0), along))(np.array([3.0, 1.0]))
    np.testing.assert_allclose(found, [[18.0, 2.0], [57.0, 9.0]], rtol=1e-15)


def test_slopes_of_slopes_follow_the_rule_of_the_rule():
    def twice(slope):
        return slope(lambda x, y: slope(marked, (x, y), (1.0, 0.5)), (3.0, 2.0), (-1.0, 4.0))

    found = twice(value_and_slope)
    np.testing.assert_allclose(jax.tree.leaves(found), jax.tree.leaves(twice(jax.jvp)), rtol=1e-14)
    # 2 x y + 5 x², of which x² y is taken by its rule: 2 (x' y + x y') + 5 (2 x x' + 9 x² y'/y)
    assert found[1][1] == pytest.approx(2.0 * (-2.0 + 12.0) + 5.0 * (-6.0 + 9.0 * 9.0 * 4.0 / 2.0), rel=1e-14)


def test_the_value_is_computed_once_for_all_directions():
    value, slopes = value_and_slopes(marked, (3.0, 2.0), [(1.0, 0.0), (np.zeros(()), 1.0), (2.0, -1.0)])
    assert (value, slopes) == (18.0, [12.0, 90.0, -66.0])
    assert marked.calls == [(3.0, 2.0)]
    assert len(marked.rules) == 3


def test_a_direction_in_which_nothing_changes_costs_nothing():
    nothing = np.zeros(2)
    given = np.array([1.0, 2.0]), np.array([3.0, 4.0])
    found = value_and_slopes(marked, given, [(nothing, nothing), (np.ones(2), nothing), (nothing, nothing)])
    assert [slope.tolist() for slope in found[1]] == [[0.0, 0.0], [6.0, 16.0], [0.0, 0.0]]
    assert len(marked.rules) == 1
    assert marked.rules[0][1].tolist() == [0.0, 0.0]


def test_a_value_is_known_only_while_its_slopes_are_found():
    x, y = np.float64(3.0), np.float64(2.0)
    for _ in range(2):
        value_and_slope(marked, (x, y), (np.float64(1.0), np.float64(1.0)))
    marked(x, y)
    assert len(marked.calls) == 3


def test_a_rule_that_fails_leaves_no_value_behind():
    @with_rule
    def function(x):
        return next(values)

    @function.defjvp
    def rule(primals, tangents):
        assert function(*primals) == 1.0
        raise ArithmeticError

    values = iter([1.0, 2.0])
    x = np.float64(0.0)
    with pytest.raises(ArithmeticError):
        value_and_slope(function, (x,), (np.float64(1.0),))
    assert function(x) == 2.0


def test_the_rule_may_ask_for_the_function_of_other_numbers():
    """Meanwhile the number itself stays known."""

    @with_rule
    def exponential(x):
        calls.append(x)
        return xp.exp(x)

    @exponential.defjvp
    def rule(primals, tangents):
        (x,), (dx,) = primals, tangents
        half = exponential(0.5 * x)
        _, slope = value_and_slope(lambda y: y * half, (x,), (dx,))
        return exponential(x), half * slope

    calls = []
    value, slope = value_and_slope(exponential, (1.0,), (1.0,))
    assert value == pytest.approx(np.e, rel=1e-15)
    assert slope == pytest.approx(np.e, rel=1e-15)
    assert calls == [1.0, 0.5]


def test_a_function_within_the_rule_of_which_it_finds_the_slope_in_turn():
    """x to the power of k by its rule in terms of the power k - 1, down to the first."""

    @with_rule
    def power(x, exponent):
        calls.append(exponent)
        return x**exponent

    @power.defjvp
    def rule(primals, tangents):
        (x, exponent), (dx, _) = primals, tangents
        value = power(x, exponent)
        if exponent == 1:
            return value, dx
        lower, slope = value_and_slope(lambda y: power(y, exponent - 1), (x,), (dx,))
        assert power(x, exponent) is value
        return value, lower * dx + x * slope

    calls = []
    assert value_and_slope(lambda x: power(x, 4), (3.0,), (1.0,)) == (81.0, 108.0)
    assert calls == [4, 3, 2, 1]


def test_a_rule_for_modules_and_several_results():
    @with_rule
    def function(module, factor):
        return {"a": module.one * factor, "b": (xp.sum(module.other["c"]),)}

    @function.defjvp
    def rule(primals, tangents):
        (module, factor), (along, changed) = primals, tangents
        value = function(module, factor)
        slope = along.one * factor + module.one * changed
        return value, {"a": 100.0 * slope, "b": (100.0 * xp.sum(along.other["c"]),)}

    at = Numbers(np.array([1.0, 2.0]), {"c": np.array([3.0, 4.0])}), 5.0
    along = Numbers(np.array([1.0, 0.0]), {"c": np.array([0.5, 0.5])}), 2.0
    for slope in (value_and_slope, jax.jvp):
        value, change = slope(lambda module, factor: function(module, factor), at, along)
        np.testing.assert_allclose(value["a"], [5.0, 10.0], rtol=1e-15)
        np.testing.assert_allclose(change["a"], [700.0, 400.0], rtol=1e-15)
        assert (float(value["b"][0]), float(change["b"][0])) == (7.0, 100.0)


def test_fixed_arguments_are_no_numbers():
    def of(function):
        rule = partial(with_rule, fixed=2)(lambda power, kind, x: x**power)

        @rule.defjvp
        def slope(power, kind, primals, tangents):
            assert kind == "kind"
            return rule(power, kind, *primals), 100.0 * power * primals[0] ** (power - 1) * tangents[0]

        return function(lambda x: rule(3, "kind", x), (2.0,), (0.5,))

    assert of(value_and_slope) == (8.0, 600.0)
    np.testing.assert_array_equal(of(jax.jvp), [8.0, 600.0])


def test_a_known_value_is_that_of_the_fixed_arguments():
    """The rule asks for the function of the same number with another power."""
    power_of = partial(with_rule, fixed=1)(lambda power, x: x**power)

    @power_of.defjvp
    def slope(power, primals, tangents):
        return power_of(power, *primals), power * power_of(power - 1, *primals) * tangents[0]

    expected = 8.0, 12.0
    np.testing.assert_array_equal(jax.jvp(lambda x: power_of(3, x), (2.0,), (1.0,)), expected)
    assert value_and_slope(lambda x: power_of(3, x), (2.0,), (1.0,)) == expected


def test_a_rule_that_is_given_none_for_a_tangent_that_is_zero():
    seen = []
    product = partial(with_rule, none_for_zero=True)(lambda x, y: x * y)

    @product.defjvp
    def slope(primals, tangents):
        (x, y), (dx, dy) = primals, tangents
        seen.append((dx is None, dy is None))
        return product(x, y), (0.0 * x if dx is None else 10.0 * dx * y) + (0.0 if dy is None else x * dy)

    x, y = np.array([2.0, 3.0]), np.array([5.0, 7.0])
    for slopes in (value_and_slope, jax.jvp):
        seen.clear()
        by_first = slopes(lambda x: product(x, y), (x,), (np.ones(2),))
        by_second = slopes(lambda y: product(x, y), (y,), (np.ones(2),))
        by_both = slopes(lambda x: product(x, x), (x,), (np.ones(2),))
        np.testing.assert_array_equal(by_first, [x * y, 10.0 * y])
        np.testing.assert_array_equal(by_second, [x * y, x])
        np.testing.assert_array_equal(by_both, [x * x, 11.0 * x])
        assert seen == [(False, True), (True, False), (False, False)]


def test_a_rule_for_numbers_of_several_levels():
    """By one number inside, by the other outside."""

    def mixed(slope):
        return slope(lambda y: slope(lambda x: marked(x, y), (3.0,), (1.0,)), (2.0,), (1.0,))

    found = mixed(value_and_slope)
    assert found == ((18.0, 12.0), (90.0, 6.0))
    np.testing.assert_allclose(jax.tree.leaves(mixed(jax.jvp)), jax.tree.leaves(found), rtol=1e-15)


def test_a_rule_in_a_program_with_known_numbers_among_the_arguments():
    found = jax.jit(lambda y: value_and_slope(lambda y: marked(np.float64(3.0), y), (y,), (1.0,)))(2.0)
    np.testing.assert_array_equal(found, [18.0, 90.0])


def test_many_numbers_with_slopes_through_a_rule():
    found = vectorised(lambda x, y: value_and_slope(lambda x: xp.sum(marked(x, y)), (x,), (np.ones(2),)))(
        np.array([[1.0, 2.0], [3.0, 4.0]]), np.array([[5.0, 6.0], [7.0, 8.0]])
    )
    np.testing.assert_allclose(found, [[29.0, 191.0], [34.0, 106.0]], rtol=1e-15)
    assert isinstance(marked.calls[0][0], Many)
