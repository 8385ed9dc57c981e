"""Loops, branches and maps: Python's for known numbers, and what JAX makes of them in its programs."""

import math
import warnings

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.engine.arrays import is_of_jax, xp
from asperity.engine.control import (
    added_at,
    at_once,
    cond,
    entries,
    fori_loop,
    in_one,
    is_rounding,
    least_at,
    map_over,
    once,
    put,
    scan,
    stacked,
    traced_once,
    vectorised,
    while_loop,
)
from asperity.engine.derivatives import value_and_slope
from asperity.engine.dual import Dual
from asperity.engine.many import Many
from asperity.engine.module import Module

MATRIX = np.array([[0.3, -1.2, 2.0], [0.7, 0.1, -0.4], [-0.9, 1.1, 0.6]])


class Numbers(Module):
    one: object
    other: object = None


def doubled_until(limit, start):
    """A number, doubled until it is above a limit, and how often."""
    return while_loop(lambda state: state[0] <= limit, lambda state: (2.0 * state[0], state[1] + 1), start)


def newton_root(number):
    """The square root of a number by as many steps as it takes."""
    root, _ = while_loop(
        lambda state: xp.abs(state[0] * state[0] - number) > 1e-15 * number,
        lambda state: (0.5 * (state[0] + number / state[0]), state[1] + 1),
        (0.5 + 0.5 * number, xp.asarray(0)),
    )
    return root


def power_sum(x, count=4):
    """x + x²/2 + x³/3 + ... by a loop over whole numbers."""

    def body(k, state):
        term, total = state
        term = term * x
        return term, total + term / (k + 1.0)

    return fori_loop(0, count, body, (xp.ones_like(x), xp.zeros_like(x)))[1]


def test_a_loop_ends_as_soon_as_it_may():
    seen = []
    found = while_loop(lambda n: n < 5, lambda n: seen.append(n) or n + 2, 0)
    assert (found, seen) == (6, [0, 2, 4])
    assert while_loop(lambda n: n < 5, lambda n: n / 0, 7) == 7


def test_slopes_go_through_a_loop():
    value, slope = value_and_slope(newton_root, (9.0,), (1.0,))
    assert value == pytest.approx(3.0, rel=1e-15)
    assert slope == pytest.approx(1.0 / 6.0, rel=1e-14)


def test_each_of_many_keeps_what_it_had_when_its_loop_was_finished():
    limits, starts = np.array([1.0, 100.0, 5.0]), np.array([3.0, 1.0, 1.0])
    found, steps = vectorised(lambda limit, start: doubled_until(limit, (start, 0)))(limits, starts)
    assert found.tolist() == [3.0, 128.0, 8.0]
    assert steps.tolist() == [0, 7, 3]
    of_jax = jax.vmap(lambda limit, start: doubled_until(limit, (start, 0)))(limits, starts)
    np.testing.assert_array_equal(of_jax, [found, steps])


def test_each_of_many_keeps_its_array_when_its_loop_was_finished():
    """As many as the arrays are long."""
    found = vectorised(lambda row: while_loop(lambda x: xp.max(x) < 3.0, lambda x: x + xp.abs(row), row))(
        np.abs(MATRIX)
    )
    for one, row in zip(found, np.abs(MATRIX), strict=True):
        steps = np.ceil(3.0 / row.max())
        np.testing.assert_allclose(one, row * steps, rtol=1e-14)


def test_a_loop_inside_goes_on_only_for_those_that_the_loop_outside_wants():
    """The outer loop takes 1, 2 and 3 steps; the inner one as many as its number says, which grow from step to step."""
    inner_steps = []

    def count(number):
        steps = 0

        def step(left):
            nonlocal steps
            steps += 1
            return left - 1.0

        left = while_loop(lambda left: left > 0.0, step, number)
        inner_steps.append(steps)
        return left

    def outer(last):
        def improve(state):
            number, done = state
            return number + 10.0 + count(number), done + 1.0

        return while_loop(lambda state: state[1] < last, improve, (100.0 / last**2, 0.0 * last))

    last = np.array([1.0, 2.0, 3.0])
    found = vectorised(outer)(last)
    # 100 of the first, which takes no part any more; then 35 of the second; then 30 of the third, at 29.4
    assert inner_steps == [100, 35, 30]
    alone = [outer(each) for each in last]
    np.testing.assert_allclose(found[0], [number for number, _ in alone], rtol=1e-15)
    np.testing.assert_array_equal(found[1], last)


def test_a_branch_inside_a_loop_is_that_of_those_that_the_loop_wants():
    """Numbers above 5 have left the loop: nobody asks for their branch any more."""
    taken = []

    def branch(name, value):
        taken.append(name)
        return value

    def improve(number):
        return cond(
            number < 5.0,
            lambda x: branch("below", x + 2.0),
            lambda x: branch("above", x + 100.0),
            number,
        )

    found = vectorised(lambda number: while_loop(lambda x: x < 5.0, improve, number))(
        np.array([0.0, 4.0, 7.0])
    )
    np.testing.assert_array_equal(found, [6.0, 6.0, 7.0])
    assert taken == ["below"] * 3


def test_loops_inside_a_branch_go_on_for_those_of_this_branch():
    """Halved until it is below 1: of the branch of small numbers that is never, of the other one 3 times."""
    steps = []

    def halved(number):
        def half(x):
            steps.append(1)
            return 0.5 * x

        return while_loop(lambda x: x >= 1.0, half, number)

    found = vectorised(lambda x: cond(x < 3.0, lambda x: x, halved, x))(np.array([2.0, 4.0, 7.0]))
    np.testing.assert_array_equal(found, [2.0, 0.5, 0.875])
    assert len(steps) == 3


def test_steps_end_where_those_that_are_wanted_are_settled():
    """Newton's steps towards roots of 2 settle for the number that goes on, whatever the other one does."""
    steps = []

    def root(number):
        def step(_, x):
            steps.append(1)
            return 0.5 * (x + number / x)

        def settled(before, after):
            return is_rounding(abs(after / before - 1.0))

        return fori_loop(0, 50, step, number, settled=settled)

    def outer(number):
        return while_loop(lambda x: x > 3.0, root, number)

    found = vectorised(outer)(np.array([2.0, 6.0]))
    np.testing.assert_allclose(found, [2.0, math.sqrt(6.0)], rtol=1e-15)
    alone = len(steps)
    steps.clear()
    outer(np.array(6.0))
    assert alone == len(steps)


def test_slopes_of_many_go_through_a_loop():
    numbers = np.array([4.0, 9.0, 100.0])
    value, slope = vectorised(lambda n: value_and_slope(newton_root, (n,), (1.0,)))(numbers)
    np.testing.assert_allclose(value, np.sqrt(numbers), rtol=1e-15)
    np.testing.assert_allclose(slope, 0.5 / np.sqrt(numbers), rtol=1e-13)


def test_a_loop_in_a_program():
    value, slope = jax.jit(lambda x: jax.jvp(newton_root, (x,), (1.0,)))(9.0)
    np.testing.assert_allclose([value, slope], [3.0, 1.0 / 6.0], rtol=1e-14)


def test_a_known_state_of_a_loop_that_becomes_one_of_jax_on_the_way():
    """By the step, or by the question whether it is finished."""

    def by_step(x):
        return while_loop(lambda s: s[0] < 4, lambda s: (s[0] + 1, s[1] * x), (0, np.float64(1.0)))

    def by_question(x):
        return doubled_until(x, (np.float64(1.0), 0))

    program = jax.jit(lambda x: (by_step(x), by_question(x)))
    (steps, power), (found, doubled) = program(3.0)
    assert (int(steps), float(power), float(found), int(doubled)) == (4, 81.0, 4.0, 2)
    assert by_step(np.float64(3.0)) == (4, 81.0)
    assert float(by_step(jnp.asarray(3.0))[1]) == 81.0


def test_a_fixed_number_of_steps_of_known_numbers_slopes_and_many():
    x = np.array([0.5, -2.0, 0.0])
    expected = x + x**2 / 2.0 + x**3 / 3.0 + x**4 / 4.0
    slope = 1.0 + x + x**2 + x**3
    np.testing.assert_allclose(power_sum(x), expected, rtol=1e-15)
    for found in (
        value_and_slope(power_sum, (x,), (np.ones(3),)),
        vectorised(lambda x: value_and_slope(power_sum, (x,), (1.0,)))(x),
        jax.jit(lambda x: jax.jvp(power_sum, (x,), (jnp.ones(3),)))(x),
    ):
        np.testing.assert_allclose(found, [expected, slope], rtol=1e-15)


def test_without_a_step_the_state_stays():
    assert fori_loop(3, 3, lambda k, x: x / 0, 5.0) == 5.0


def test_steps_have_their_numbers():
    seen = []
    fori_loop(2, 5, lambda k, x: seen.append((k, x)) or x + 1, 10)
    assert seen == [(2, 10), (3, 11), (4, 12)]


def test_a_known_state_of_a_fixed_number_of_steps_that_becomes_one_of_jax_on_the_way():
    traced = []

    def total(x):
        return fori_loop(0, 6, lambda k, s: traced.append(k) or s + x * k, np.float64(1.0))

    assert float(jax.jit(total)(2.0)) == 31.0
    assert traced[0] == 0
    assert len(traced) < 6


def test_steps_end_once_the_state_is_settled():
    """Also for many at once, where all are."""

    def root(number, *, count=50):
        def settled(before, after):
            return is_rounding(xp.abs(after / before - 1.0))

        def step(k, x):
            steps.append(k)
            return 0.5 * (x + number / x)

        return fori_loop(0, count, step, number, settled=settled)

    steps = []
    assert root(2.0) == pytest.approx(np.sqrt(2.0), rel=1e-15)
    alone = len(steps)
    assert 4 < alone < 9
    steps.clear()
    numbers = np.array([2.0, 1e6])
    np.testing.assert_allclose(vectorised(root)(numbers), np.sqrt(numbers), rtol=1e-15)
    assert alone < len(steps) < 20
    assert float(jax.jit(root)(2.0)) == pytest.approx(np.sqrt(2.0), rel=1e-15)


def test_a_step_that_settles_is_the_last_and_is_kept():
    seen = []
    found = fori_loop(
        0,
        9,
        lambda k, x: x + 1.0,
        0.0,
        settled=lambda one, other: seen.append((one, other)) or other == 2.0,
    )
    assert found == 2.0
    assert seen == [(0.0, 1.0), (1.0, 2.0)]


@pytest.mark.parametrize(
    ("residual", "small"),
    [
        (8e-16, True),
        (9e-16, False),
        (np.array([0.0, 8e-16]), True),
        (np.array([0.0, 1e-15]), False),
        (Dual(np.array([1e-16]), [np.array([5.0])], 1), True),
        (Many(np.array([[1e-16], [1e-16]])), True),
        (Many(np.array([[1e-16], [1e-3]])), False),
        (Dual(Many(np.array([0.0, 1.0])), [np.array(0.0)], 1), False),
    ],
)
def test_what_is_as_small_as_rounding(residual, small):
    """Up to four times the spacing of numbers at 1, 8.9e-16."""
    assert is_rounding(residual) is small


def walked(x, given):
    """A walk with a step for each entry: the last place, and every place with half of it."""

    def step(place, one):
        place = place + x * one["a"] - one["b"][0]
        return place, (place, {"half": 0.5 * place})

    return scan(step, 0.0 * x, given)


STEPS = {"a": np.array([1.0, 2.0, -4.0]), "b": (np.array([0.5, 0.0, 1.0]),)}


def test_a_scan_of_known_numbers_slopes_and_many():
    x = np.array([1.0, 2.0, 3.0])
    places = np.cumsum(x[:, None] * STEPS["a"] - STEPS["b"][0], axis=1)
    last, (all_, halves) = walked(2.0, STEPS)
    assert (last, all_.tolist()) == (places[1, -1], places[1].tolist())
    assert halves["half"].tolist() == (0.5 * places[1]).tolist()
    for over, jit in ((vectorised, lambda f: f), (jax.vmap, jax.jit)):
        found = jit(over(lambda x: value_and_slope(lambda y: walked(y, STEPS), (x,), (1.0,))))(x)
        (last, (all_, halves)), (slope, (slopes, _)) = found
        np.testing.assert_allclose(last, places[:, -1], rtol=1e-15)
        np.testing.assert_allclose(all_, places, rtol=1e-15)
        np.testing.assert_allclose(halves["half"], 0.5 * places, rtol=1e-15)
        np.testing.assert_allclose(slope, [-1.0] * 3, rtol=1e-15)
        np.testing.assert_allclose(slopes, [np.cumsum(STEPS["a"])] * 3, rtol=1e-15)


def test_a_scan_over_what_is_another_for_each_of_many():
    found = vectorised(lambda row: scan(lambda s, x: (s + x, s * x), np.float64(1.0), row))(MATRIX)
    for last, products, row in zip(*found, MATRIX, strict=True):
        sums = 1.0 + np.cumsum(row)
        assert last == pytest.approx(sums[-1], rel=1e-15)
        np.testing.assert_allclose(products, np.array([1.0, *sums[:-1]]) * row, rtol=1e-15)


def test_a_scan_without_anything_given():
    last, outputs = scan(lambda s, none: (2 * s, (s, none)), 1, length=4)
    assert (last, outputs[0].tolist(), outputs[1]) == (16, [1, 2, 4, 8], None)


def test_a_known_state_of_a_scan_that_becomes_one_of_jax_on_the_way():
    program = jax.jit(lambda x: scan(lambda s, _: (s * x, s + 1.0), np.float64(1.0), length=3))
    last, outputs = program(2.0)
    assert (float(last), outputs.tolist()) == (8.0, [2.0, 3.0, 5.0])


def test_a_branch_that_is_not_taken_costs_nothing():
    assert cond(True, lambda x: x + 1.0, lambda x: x / 0, 1) == 2.0
    assert cond(np.bool_(False), lambda x: x / 0, lambda x: x - 1.0, 1) == 0.0
    assert cond(np.array(1.0) > 0.5, lambda: "yes", lambda: "no") == "yes"


def test_slopes_are_those_of_the_branch_that_is_taken():
    def function(x):
        return cond(x > 1.0, lambda x: x * x, lambda x: {"a": -x}["a"], x)

    assert value_and_slope(function, (3.0,), (1.0,)) == (9.0, 6.0)
    assert value_and_slope(function, (0.5,), (1.0,)) == (-0.5, -1.0)


def test_each_of_many_has_its_branch():
    """And where all have the same, the other one costs nothing."""

    def function(x):
        return cond(x[0] > 0.0, lambda x: (x, {"a": 2.0 * x[1]}), lambda x: (-x, {"a": 5.0}), x)

    first, second = vectorised(function)(MATRIX)
    np.testing.assert_array_equal(first, [MATRIX[0], MATRIX[1], -MATRIX[2]])
    assert second["a"].tolist() == [-2.4, 0.2, 5.0]
    assert vectorised(lambda x: cond(x > 0, lambda: x, lambda: x / None))(np.ones(2)).tolist() == [
        1.0,
        1.0,
    ]
    assert vectorised(lambda x: cond(x > 2, lambda: x / None, lambda: x))(np.ones(2)).tolist() == [
        1.0,
        1.0,
    ]


def test_slopes_of_many_are_those_of_their_branches():
    def function(x):
        return cond(x > 1.0, lambda x: x * x, lambda x: -x, x)

    found = vectorised(lambda x: value_and_slope(function, (x,), (1.0,)))(np.array([3.0, 0.5, 2.0]))
    np.testing.assert_array_equal(found, [[9.0, -0.5, 4.0], [6.0, -1.0, 4.0]])


def test_a_branch_in_a_program():
    program = jax.jit(lambda x, y: cond(x > 1.0, lambda a, b: a * b, lambda a, b: a - b, x, y))
    assert (float(program(2.0, 5.0)), float(program(0.5, 5.0))) == (10.0, -4.5)


def test_a_map_is_that_of_jax():
    given = {"a": MATRIX, "b": (np.array([1.0, 2.0, 3.0]),)}

    def function(one):
        return one["a"] * one["b"][0], {"sum": xp.sum(one["a"])}

    for found in (map_over(function, given), jax.jit(lambda given: map_over(function, given))(given)):
        np.testing.assert_allclose(found[0], MATRIX * given["b"][0][:, None], rtol=1e-15)
        np.testing.assert_allclose(found[1]["sum"], MATRIX.sum(axis=1), rtol=1e-15)


def test_a_vectorised_function_is_that_of_jax_in_a_program():
    def outer(x, *, axis):
        return vectorised(lambda row: xp.stack([row, row * x[0]]), out_axis=axis)(MATRIX + x[1])

    for axis in (0, 1, -1):
        found = jax.jit(lambda x, axis=axis: outer(x, axis=axis))(MATRIX[0])
        np.testing.assert_allclose(found, outer(MATRIX[0], axis=axis), rtol=1e-15)
        rows = [np.stack([row, row * 0.3]) for row in MATRIX - 1.2]
        np.testing.assert_allclose(found, np.stack(rows, axis=axis), rtol=1e-15)


def map_over_one(function):
    return lambda given: map_over(function, given)


BESIDE = {
    "an operator": lambda x, beside: x * beside,
    "an operator of JAX's": lambda x, beside: beside - x,
    "a function": lambda x, beside: xp.where(x > 1.0, beside, x),
    "a power": lambda x, beside: xp.sqrt(x) ** beside,
    "a product": lambda x, beside: xp.matmul(xp.stack([x, 2.0 * x]), xp.stack([beside, x])),
    "a loop": lambda x, beside: while_loop(lambda s: s[0] < beside, lambda s: (2.0 * s[0], s[1]), (x, 1.0))[
        0
    ],
    "a branch": lambda x, beside: cond(beside > 0.0, lambda: x, lambda: -x),
    "a place": lambda x, beside: put(xp.stack([x, x]), 1, beside)[1] + x,
    "a rule": lambda x, beside: value_and_slope(lambda n: n * x, (beside,), (1.0,))[1],
}


@pytest.mark.parametrize("over", [vectorised, map_over_one], ids=["vectorised", "map_over"])
@pytest.mark.parametrize("function", BESIDE.values(), ids=BESIDE.keys())
def test_what_is_mapped_may_close_over_numbers_of_jax(function, over):
    """The numbers that are mapped are NumPy's: a program takes them as constants."""
    numbers, beside = np.array([0.5, 1.0, 3.0]), 4.0

    def found(given):
        return over(lambda x: function(x, given))(numbers)

    expected = [float(function(jnp.asarray(x), jnp.asarray(beside))) for x in numbers]
    np.testing.assert_allclose(jax.jit(found)(beside), expected, rtol=1e-14)
    np.testing.assert_allclose(found(jnp.asarray(beside)), expected, rtol=1e-14)
    np.testing.assert_allclose(found(beside), expected, rtol=1e-14)


def test_slopes_go_through_a_vectorised_function():
    """By its arguments, and by what it closes over."""

    def function(m, x, y):
        return m(lambda row: row * y + xp.sum(row))(x)

    at, along = (MATRIX, np.array([1.0, 2.0, 3.0])), (MATRIX.T, np.array([0.5, -1.0, 2.0]))
    found = value_and_slope(lambda *given: function(vectorised, *given), at, along)
    (x, y), (dx, dy) = at, along
    np.testing.assert_allclose(found[0], x * y + x.sum(axis=1, keepdims=True), rtol=1e-14)
    np.testing.assert_allclose(found[1], dx * y + x * dy + dx.sum(axis=1, keepdims=True), rtol=1e-14)


def test_entries_of_a_module_and_modules_as_one():
    module = Numbers(MATRIX, {"a": (np.arange(3),)})
    apart = entries(module)
    assert [type(each) for each in apart] == [Numbers] * 3
    np.testing.assert_array_equal(apart[1].one, MATRIX[1])
    assert [each.other["a"][0] for each in apart] == [0, 1, 2]
    back = stacked(apart)
    np.testing.assert_array_equal(back.one, MATRIX)
    assert back.other["a"][0].tolist() == [0, 1, 2]
    np.testing.assert_array_equal(stacked(apart, axis=-1).one, MATRIX.T)
    assert stacked([1.0, 2]).tolist() == [1.0, 2.0]


def formula(module):
    return {"root": xp.sqrt(-module.one), "ratio": 1.0 / module.other, "kept": 2.0, "log": xp.log(0.0)}


def test_the_door_to_the_formula_code_is_silent_and_leaves_arrays_of_numpy():
    with warnings.catch_warnings(), np.errstate(all="warn"):
        warnings.simplefilter("error")
        found = at_once(formula, Numbers(1.0, np.zeros(2)))
        with pytest.raises(RuntimeWarning):  # as before
            np.log(np.zeros(1))
    assert all(type(leaf) is np.ndarray for leaf in found.values())
    assert np.isnan(found["root"])
    assert found["ratio"].tolist() == [np.inf, np.inf]
    assert (found["kept"].shape, float(found["kept"]), float(found["log"])) == ((), 2.0, -np.inf)


def test_numbers_of_python_come_in_as_arrays():
    kinds = []
    at_once(lambda *given: kinds.extend(map(type, given)) or 1.0, 1.0, 2, np.float64(3.0), True)
    assert kinds == [np.ndarray] * 4


def test_within_a_program_the_door_is_open():
    found = jax.jit(lambda x: at_once(formula, Numbers(x, x)))(0.0)
    assert (float(found["ratio"]), float(found["kept"])) == (np.inf, 2.0)
    seen = []
    assert is_of_jax(at_once(lambda x: seen.append(is_of_jax(x)) or x, jnp.asarray(1.0)))
    assert seen == [True]


def test_a_number_that_xla_computes_once():
    x = np.ones(2)
    assert once(x) is x
    values = {"x": np.array([0.0, -1.5, np.inf, np.nan]), "y": jnp.array([0.0, -1.5, jnp.inf, jnp.nan])}
    np.testing.assert_array_equal(once(values)["y"], values["y"])
    assert once(values)["x"] is values["x"]
    assert float(jax.grad(lambda x: once(3.0 * x))(2.0)) == 3.0

    def two_uses(keep):
        """Negations in a program of two loops over different places, of a number that takes one."""

        def values(x, one, other):
            number = keep(-x * x)
            return number[:, None] * one, number[:, None] * other

        arguments = np.ones(500), np.ones((500, 16)), np.ones((500, 17))
        return jax.jit(values).lower(*arguments).compile().as_text().count(" negate(")

    assert (two_uses(once), two_uses(lambda number: number)) == (1, 2)


def test_a_function_that_is_traced_once():
    traced = []

    @traced_once
    def plain(x):
        traced.append("plain")
        return 2.0 * x

    def chosen(x, kind):
        """Of a kind."""
        traced.append(kind)
        return x + (1.0 if kind == "a" else 2.0)

    chosen = traced_once(chosen, fixed=("kind",))
    assert (chosen.__doc__, chosen.__name__) == ("Of a kind.", "chosen")
    assert plain(3.0) == plain(3.0) == 6.0
    assert traced == ["plain", "plain"]
    traced.clear()
    program = jax.jit(lambda x: plain(x) + plain(2.0 * x) + chosen(x, kind="a") + chosen(x, kind="a"))
    assert float(program(1.0)) == 10.0
    assert traced == ["plain", "a"]
    assert float(chosen(jnp.asarray(1.0), kind="b")) == 3.0
    assert chosen(1.0, "b") == 3.0


MODULES = [
    Numbers(MATRIX, (np.array([1.0, 2.0]), 5.0, {"a": np.array([[7.0]])})),
    {"b": np.array([1.0, 2.0]), "a": np.array([3.0, 4.0]), "c": np.array(5.0)},
    (np.array([]), np.arange(3.0)),
]


@pytest.mark.parametrize("module", MODULES)
def test_all_numbers_in_one_array_and_apart_again(module):
    numbers, apart = in_one(module)
    leaves, structure = jax.tree.flatten(module)
    np.testing.assert_array_equal(numbers, np.concatenate([np.ravel(leaf) for leaf in leaves]))
    back = apart(2.0 * numbers)
    assert jax.tree.structure(back) == structure
    for one, other in zip(jax.tree.leaves(back), leaves, strict=True):
        assert np.shape(one) == np.shape(other)
        np.testing.assert_array_equal(one, 2.0 * np.asarray(other))


def test_all_numbers_in_one_array_with_slopes_and_of_many():
    def function(x, y):
        numbers, apart = in_one((x, [y, 3.0]))
        return apart(numbers * numbers)

    (x, (y, three)), (dx, (dy, nothing)) = value_and_slope(function, (MATRIX, 2.0), (MATRIX.T, 1.0))
    np.testing.assert_allclose(x, MATRIX**2, rtol=1e-15)
    np.testing.assert_allclose(dx, 2.0 * MATRIX * MATRIX.T, rtol=1e-15)
    assert (y, three, dy, nothing) == (4.0, 9.0, 4.0, 0.0)
    found = vectorised(function)(MATRIX, np.array([1.0, 2.0, 3.0]))
    np.testing.assert_allclose(found[0], MATRIX**2, rtol=1e-15)
    assert found[1][0].tolist() == [1.0, 4.0, 9.0]


CHANGED = {
    "one": (1, 7.0),
    "the last": (-1, 7.0),
    "some": (np.s_[:2], np.array([[5.0], [6.0]])),
    "all alike": (np.s_[1:], 4.0),
    "chosen": (np.array([2, 0]), np.array([[1.0], [2.0]])),
    "a column": (np.s_[:, 1], np.array([7.0, 8.0, 9.0])),
    "a column, all alike": (np.s_[:, 1], 8.0),
    "pairs": ((np.array([0, 2]), np.array([1, 1])), np.array([5.0, 6.0])),
    "a block": ((np.array([[0], [2]]), np.array([[1, 2]])), np.array([[5.0, 6.0], [7.0, 8.0]])),
    "the last axis": ((..., np.array([0, 2])), np.array([5.0, 6.0])),
    "where true": (MATRIX > 0.0, -1.0),
}
CHANGES = {"set": put, "add": added_at, "min": least_at}


def changed(array, place, values, how):
    """By NumPy, in a copy."""
    array = array.copy()
    if how == "set":
        array[place] = values
    elif how == "add":
        array[place] += values
    else:
        array[place] = np.minimum(array[place], values)
    return array


@pytest.mark.parametrize("how", CHANGES)
@pytest.mark.parametrize("name", CHANGED)
def test_an_array_with_other_values_at_some_places(name, how):
    place, values = CHANGED[name]
    before = MATRIX.copy()
    found = CHANGES[how](MATRIX, place, values)
    assert type(found) is np.ndarray
    np.testing.assert_array_equal(found, changed(MATRIX, place, values, how))
    np.testing.assert_array_equal(MATRIX, before)


def test_an_array_of_jax_with_other_values_at_some_places():
    def all_of(array, by_name):
        return {
            (name, how): (
                change(array, CHANGED[name][0], values),
                change(array, *CHANGED[name]),
                change(MATRIX, CHANGED[name][0], values),
            )
            for name, values in by_name.items()
            for how, change in CHANGES.items()
        }

    found = jax.jit(all_of)(MATRIX, {name: values for name, (_, values) in CHANGED.items()})
    for (name, how), each in found.items():
        expected = changed(MATRIX, *CHANGED[name], how)
        np.testing.assert_array_equal(each, [expected] * 3, err_msg=f"{name}, {how}")


@pytest.mark.parametrize("how", CHANGES)
@pytest.mark.parametrize("name", CHANGED)
def test_many_arrays_with_other_values_at_some_places(name, how):
    """Three at once, as many as there are rows: of the arrays, of the values, and of both."""
    place, values = CHANGED[name]
    arrays = MATRIX * np.array([1.0, 2.0, -1.0])[:, None, None]
    several = values * np.array([1.0, 0.5, -2.0]).reshape(-1, *(1,) * np.ndim(values))
    change = CHANGES[how]
    for found, given in (
        (vectorised(change_at(change, place))(arrays, several), zip(arrays, several, strict=True)),
        (vectorised(lambda x: change(x, place, values))(arrays), ((array, values) for array in arrays)),
        (vectorised(lambda y: change(MATRIX, place, y))(several), ((MATRIX, each) for each in several)),
    ):
        expected = [changed(array, place, each, how) for array, each in given]
        np.testing.assert_array_equal(found, expected)


def change_at(change, place):
    return lambda array, values: change(array, place, values)


@pytest.mark.parametrize("how", ["set", "add"])
@pytest.mark.parametrize("name", CHANGED)
def test_slopes_of_an_array_with_other_values_at_some_places(name, how):
    """What is linear in the array and the values makes the same of their slopes."""
    place, values = CHANGED[name]
    at, along = (MATRIX, values), (MATRIX.T, 0.5 - np.asarray(values))
    function = change_at(CHANGES[how], place)
    found = value_and_slope(function, at, along)
    expected = changed(MATRIX, place, values, how), changed(MATRIX.T, place, along[1], how)
    np.testing.assert_allclose(found, expected, rtol=1e-15)
    _, by_values = value_and_slope(lambda y: function(MATRIX, y), at[1:], along[1:])
    np.testing.assert_allclose(by_values, changed(np.zeros((3, 3)), place, along[1], how), rtol=1e-15)
    _, by_array = value_and_slope(lambda x: function(x, values), at[:1], along[:1])
    np.testing.assert_allclose(by_array, changed(MATRIX.T, place, 0.0, how), rtol=1e-15)


def test_values_added_at_the_same_place_add_up():
    place, values = np.array([0, 0, 2]), np.array([1.0, 2.0, 4.0])
    expected = [3.0, 0.0, 4.0]
    assert added_at(np.zeros(3), place, values).tolist() == expected
    assert vectorised(lambda y: added_at(np.zeros(3), place, y))(values[None]).tolist() == [expected]
    assert (
        value_and_slope(lambda y: added_at(np.zeros(3), place, y), (values,), (values,))[1].tolist()
        == expected
    )
    assert least_at(np.ones(3), place, -values).tolist() == [-2.0, 1.0, -4.0]


def test_slopes_of_slopes_and_of_many_arrays_with_other_values():
    def function(x):
        return put(x * x, np.array([0, 2]), x[:2] ** 3)

    x = np.array([2.0, 3.0, 5.0])

    def second(x):
        ones = np.ones(3)
        return value_and_slope(lambda x: value_and_slope(function, (x,), (ones,))[1], (x,), (ones,))

    expected = (
        np.array([3.0 * x[0] ** 2, 2.0 * x[1], 3.0 * x[1] ** 2]),
        np.array([6.0 * x[0], 2.0, 6.0 * x[1]]),
    )
    np.testing.assert_allclose(second(x), expected, rtol=1e-15)
    np.testing.assert_allclose(
        [each[1] for each in vectorised(second)(np.stack([x + 1.0, x, x]))], expected, rtol=1e-15
    )


def test_the_smaller_values_have_no_slopes():
    with pytest.raises((AssertionError, NotImplementedError)):
        least_at(Dual(np.ones(2), [np.ones(2)], 1), 0, 0.5)
