"""Which library computes with given numbers."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
import scipy.special

from asperity.engine.arrays import (
    OwnNumber,
    any_xp,
    as_numbers,
    complex_number,
    entry_of,
    is_of_jax,
    special,
    uses_jax,
    xp,
)
from asperity.engine.dual import Dual
from asperity.engine.many import Many
from asperity.engine.module import Module

DUAL = Dual(np.ones(2), [np.ones(2)], 1)
MANY = Many(np.ones((3, 2)))


class Numbers(Module):
    one: object
    other: object = None


def test_numpy_for_known_numbers_and_jax_for_its_own():
    assert not uses_jax(1.0, np.ones(2), {"a": 2}, Numbers(1.0, (np.ones(1), [3])), None)
    assert uses_jax(1.0, {"a": jnp.ones(2)})
    assert uses_jax(Numbers(1.0, (2.0, [jnp.asarray(3.0)])))
    assert not uses_jax(DUAL, MANY)
    seen = []
    jax.jit(lambda x: seen.append((uses_jax(x, 1.0), uses_jax(1.0), is_of_jax(x))) or x)(1.0)
    assert seen == [(True, False, True)]


@pytest.mark.parametrize(
    "number", [1.0, 1, True, None, "a", np.float32(1.0), np.ones(2), DUAL, MANY, object()]
)
def test_what_is_no_array_of_jax(number):
    assert not is_of_jax(number)


@pytest.mark.parametrize(
    "given", [1.0, 2, np.float64(0.5), np.float16(0.5), np.ones(2), np.ones(2, np.uint16)]
)
def test_a_function_of_known_numbers_is_that_of_numpy(given):
    found, expected = xp.add(given, given), np.add(given, given)
    assert type(found) is type(expected)
    assert found.dtype == expected.dtype
    assert np.all(found == expected)


def test_an_array_of_jax_among_the_arguments_decides():
    two = np.full(2, 2.0)

    def of_jax(one):
        return [
            *(xp.add(two, one), xp.add(one, 1.0), xp.stack([two, one]), xp.stack((two, [1.0, one][1]))),
            *(xp.concatenate([two, one]), xp.block([[two, one], [two, two]]), xp.where(two > 1.0, one, 0.0)),
            *(xp.clip(two, 0.0, one), xp.full((2,), fill_value=one[0]), xp.sum(a=one), xp.linalg.norm(one)),
            *(special.erf(one), xp.linalg.solve(one * np.eye(2), two), entry_of(two, one.astype(int))),
        ]

    kinds = []
    jax.jit(lambda one: kinds.extend(map(is_of_jax, of_jax(one))) or 0.0)(np.ones(2))
    assert len(kinds) == 14
    assert all(kinds)
    for found in (
        *(xp.add(two, 1.0), xp.stack([two, two]), xp.sum(two, axis=0), xp.zeros(3), xp.eye(2)),
        *(
            special.erf(two),
            xp.linalg.norm(two),
            xp.block([[two, two]]),
            entry_of([1.0, 2.0], 1),
            xp.arange(3),
        ),
    ):
        assert isinstance(found, np.ndarray | np.float64)


def test_within_a_program_constants_stay_those_of_numpy():
    seen = []

    def program(x):
        seen.extend([type(xp.zeros(2)), type(xp.sin(1.0)), isinstance(xp.sin(x), jax.Array)])
        return xp.sum(xp.stack([x, xp.asarray(2.0)]))

    assert jax.jit(program)(1.0) == 3.0
    assert seen == [np.ndarray, np.float64, True]


def test_numbers_of_our_own_bring_their_functions_and_those_of_higher_rank_decide():
    assert isinstance(xp.add(DUAL, 1.0), Dual)
    assert isinstance(xp.add(MANY, 1.0), Many)
    for both in (
        xp.add(DUAL, MANY),
        xp.add(MANY, DUAL),
        xp.stack([MANY, [DUAL][0]]),
        DUAL + MANY,
        MANY + DUAL,
    ):
        assert isinstance(both, Dual)
        assert isinstance(both.value, Many)
    assert isinstance(xp.sum(xp.stack([1.0, DUAL[0]]), axis=0), Dual)


def test_numbers_of_our_own_and_those_of_jax_do_not_mix():
    with pytest.raises(TypeError):
        xp.add(jnp.ones(2), DUAL)
    with pytest.raises(TypeError):
        xp.stack([MANY, jnp.ones(2)])
    with pytest.raises(NotImplementedError):
        OwnNumber.function("sin")


def test_names_that_are_no_functions_are_those_of_numpy():
    assert xp.pi == np.pi
    assert np.isnan(xp.nan)
    assert xp.inf == np.inf
    assert xp.float64 is np.float64
    assert xp.int8 is np.int8
    assert any_xp is xp
    with pytest.raises(AttributeError):
        _ = xp.no_such_function


def test_a_function_is_looked_up_once():
    assert xp.hypot is xp.hypot
    assert xp.linalg is xp.linalg
    assert special.gamma is special.gamma


def test_functions_that_numpy_lacks():
    x = np.array([0.3, 1.7])
    np.testing.assert_array_equal(special.erf(x), scipy.special.erf(x))
    np.testing.assert_allclose(special.gamma(jnp.asarray(x)), scipy.special.gamma(x), rtol=1e-14)
    found = special.erf(Dual(x, [np.ones(2)], 1))
    np.testing.assert_allclose(found.slopes[0], 2.0 / np.sqrt(np.pi) * np.exp(-(x**2)), rtol=1e-14)


def test_the_numbers_of_one_joint():
    found = as_numbers(Numbers(1, {"a": [2.5, np.array([1, 2])], "b": None}))
    assert isinstance(found, Numbers)
    assert (type(found.one), found.one.dtype, found.one.shape) == (np.ndarray, float, ())
    assert found.other["a"][1].dtype == float
    assert found.other["b"] is None


@pytest.mark.parametrize(
    ("real", "imaginary"),
    [(1.0, 2.0), (np.inf, 1.0), (1.0, -np.inf), (np.nan, 2.0), (0.0, np.nan), (-0.0, 0.0)],
)
def test_a_complex_number_has_its_parts_in_both_engines(real, imaginary):
    for number in (np.float64, np.array, jnp.asarray):
        found = complex_number(number(real), number(imaginary))
        np.testing.assert_array_equal([found.real, found.imag], [real, imaginary])


def test_parts_of_complex_numbers_of_two_shapes_and_of_all_kinds():
    real, imaginary = np.array([1.0, 2.0]), np.array([[3.0], [4.0]])
    expected = real + 1j * imaginary
    for one, other in ((real, imaginary), (jnp.asarray(real), imaginary), (real, jnp.asarray(imaginary))):
        found = complex_number(one, other)
        assert isinstance(found, jax.Array) == (is_of_jax(one) or is_of_jax(other))
        np.testing.assert_array_equal(found, expected)
    several = complex_number(Many(np.array([[1.0, 2.0]])), Many(np.array([3.0])))
    np.testing.assert_array_equal(several.values, [[1.0 + 3.0j, 2.0 + 3.0j]])


def test_entries_of_a_table_beyond_its_ends():
    table = [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]
    for place in (np.array([0, 2, 3, -1]), jnp.array([0, 2, 3, -1])):
        found = entry_of(table, place)
        np.testing.assert_array_equal(found, [[1.0, 2.0], [5.0, 6.0], [5.0, 6.0], [1.0, 2.0]])
