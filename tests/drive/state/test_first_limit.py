"""Slip ratios, and the search for the first of several limits of known functions."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.state.first_limit import first_limit, first_limit_of_numbers, of_each, slip_ratio
from asperity.engine.arrays import xp


def cubic(limit):
    """Two limits as by hand: x³ reaches its own first, the line would reach twice that."""
    return lambda x: jnp.stack([(x / limit) ** 3 - 1.0, 0.5 * x / limit - 1.0])


def cubic_of_any(x, limit):
    """As ``cubic``, of one value and with the numbers of any engine."""
    return xp.stack([(x / limit) ** 3 - 1.0, 0.5 * x / limit - 1.0])


@pytest.mark.parametrize("guess", [1e-3, 1.0, 7.0, 7.5, 1e6])
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_the_first_limit_is_found_from_any_guess(guess):
    found = first_limit(excesses=cubic(7.0), first_guess=guess)
    assert float(found.value) == pytest.approx(7.0, rel=1e-12)
    assert int(found.which) == 0


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_a_batch_finds_each_its_own():
    limits = jnp.array([0.3, 7.0, 2e5])
    found = first_limit(excesses=cubic(limits), first_guess=jnp.ones(3))
    np.testing.assert_allclose(found.value, limits, rtol=1e-12)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_no_limit_and_a_limit_at_once():
    never = first_limit(excesses=lambda x: jnp.stack([-1.0 / (1.0 + x)]), first_guess=1.0)
    at_once = first_limit(excesses=lambda x: jnp.stack([x - 5.0, 1.0 + x]), first_guess=1.0)
    assert (float(never.value), int(never.which)) == (math.inf, -1)
    assert (float(at_once.value), int(at_once.which)) == (0.0, 1)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_the_derivative_is_implicit():
    slope = jax.grad(lambda limit: first_limit(excesses=cubic(limit), first_guess=1.0).value)(7.0)
    assert float(slope) == pytest.approx(1.0, rel=1e-9)


def test_a_nan_is_no_limit_of_its_own():
    def with_hole(x):
        return jnp.stack([jnp.where(x > 3.0, jnp.nan, x - 7.0), jnp.where(x > 3.0, 1.0, -1.0)])

    found = first_limit(excesses=with_hole, first_guess=1.0)
    assert (float(found.value), int(found.which)) == (pytest.approx(3.0, rel=1e-12), 1)


def test_slip_ratio_of_an_open_contact():
    assert float(slip_ratio(normal_force=0.0, tangential_force=1.0, friction_coefficient=0.1)) == math.inf
    assert float(slip_ratio(normal_force=0.0, tangential_force=0.0, friction_coefficient=0.1)) == 0.0


def test_where_nothing_is_known_beyond_a_limit_it_is_that_which_is_all_but_reached():
    """A force that falls to nothing at 7, beyond which no state is found: not the limit of the search itself."""

    def lifts(x):
        lost = x > 7.0 - 1e-12
        return jnp.stack(
            [
                jnp.where(lost, jnp.nan, 0.5 * x / 7.0 - 1.0),
                jnp.where(lost, jnp.nan, x / 7.0 - 1.0),
                jnp.where(lost, 1.0, -1.0),
            ]
        )

    found = first_limit(excesses=lifts, first_guess=1.0)
    assert (float(found.value), int(found.which)) == (pytest.approx(7.0, rel=1e-11), 1)


def hole(x):
    """Nothing is known beyond 3, where the first function would reach its limit at 7."""
    return np.stack([np.where(x > 3.0, np.nan, x - 7.0), np.where(x > 3.0, 1.0, -1.0)])


def kinked(x):
    """The first function reaches its limit at 5, with another slope beyond 4.9."""
    return np.stack([np.where(x < 4.9, 0.1, 1.0) * (x - 4.9) - 0.1, x / 20.0 - 1.0])


def lost(x):
    """The second function all but reaches its limit at 7, beyond which nothing is known."""
    beyond = x > 7.0 - 1e-12
    known = [np.where(beyond, np.nan, share * x / 7.0 - 1.0) for share in (0.5, 1.0)]
    return np.stack([*known, np.where(beyond, 1.0, -1.0)])


def both_ways(x):
    """A limit at 2, kept again beyond 2.5: the first one counts."""
    return np.stack([(x - 2.0) * (2.5 - x), x / 50.0 - 1.0])


@pytest.mark.parametrize(
    ("functions", "value", "which", "most_looks"),
    [
        (lambda x: np.stack([(x / 7.0) ** 3 - 1.0, x / 14.0 - 1.0]), 7.0, 0, 7),
        (lambda x: np.stack([np.exp(x) - np.exp(0.3), x - 1.0]), 0.3, 0, 6),
        (lambda x: np.stack([x / 2e4 - 1.0]), 2e4, 0, 20),
        (lambda x: np.stack([x - 5.0, 1.0 + x]), 0.0, 1, 1),
        (lambda x: np.stack([-1.0 / (1.0 + x)]), math.inf, -1, 41),
        (hole, 3.0, 1, 17),
        (kinked, 5.0, 0, 7),
        (lost, 7.0, 1, 17),
        (both_ways, 2.0, 0, 7),
    ],
)
@pytest.mark.parametrize("searches", [1, 2, 3, 70])
def test_a_search_by_many_looks_at_once_finds_what_one_by_one_does(
    functions, value, which, most_looks, searches
):
    looks = []

    def excesses(x):
        looks.append(x.shape)
        return functions(x)

    found = first_limit_of_numbers(excesses=excesses, first_guess=np.ones(searches))
    np.testing.assert_allclose(found.value, np.full(searches, value), rtol=1e-12)
    assert found.which.tolist() == [which] * searches
    assert len(looks) <= most_looks
    with np.errstate(all="ignore"):
        alone = first_limit(excesses=functions, first_guess=1.0)
    np.testing.assert_allclose(found.value, float(alone.value), rtol=1e-12)
    assert int(alone.which) == which


def test_searches_side_by_side_find_each_its_own():
    limits = np.array([1e-9, 0.3, 7.0, 2e5])
    found = first_limit_of_numbers(excesses=of_each(cubic_of_any, limits), first_guess=np.ones(4))
    np.testing.assert_allclose(found.value, limits, rtol=1e-12)
    assert found.which.tolist() == [0] * 4


@pytest.mark.parametrize(("farthest", "value"), [(0.0, math.inf), (1.0, math.inf), (8.0, 7.0)])
def test_a_search_goes_no_farther_than_it_may(farthest, value):
    seen = []

    def excesses(x):
        seen.append(np.max(x))
        return np.stack([x / 7.0 - 1.0])

    found = first_limit_of_numbers(excesses=excesses, first_guess=np.ones(2), farthest=farthest)
    np.testing.assert_allclose(found.value, np.full(2, value), rtol=1e-12)
    assert max(seen, default=0.0) <= farthest


def test_a_search_that_has_ended_stays_where_it_ended_beside_one_that_goes_on():
    """Both have limits at 5; that from 2 may not look beyond 2."""
    limits = of_each(lambda x: xp.stack([x / 5.0 - 1.0]))
    found = first_limit_of_numbers(excesses=limits, first_guess=np.array([2.0, 9.0]), farthest=1.0)
    np.testing.assert_allclose(found.value, [math.inf, 5.0], rtol=1e-12)
    assert found.which.tolist() == [-1, 0]


@pytest.mark.parametrize(
    "excess",
    [
        lambda x: (x / 7.0) ** 41 - 1.0,
        lambda x: 1.0 - (7.0 / x) ** 41,
        lambda x: np.where(x > 7.0, 1e6, -1e-6),
        lambda x: np.where(x > 4.0 + 1e-9, 1.0, -1e-9),
    ],
)
def test_a_search_one_by_one_takes_no_more_looks_than_halving_and_one(excess):
    """Next to nothing, at 1, 2, 4 and 8 and at the end for its derivative; from 4 to 8 to 1e-13 of 7 in 43 halvings."""
    looks = []

    def excesses(x):
        looks.append(float(x))
        return np.stack([excess(x)])

    with np.errstate(all="ignore"):
        found = first_limit(excesses=excesses, first_guess=1.0)
    assert float(found.value) == pytest.approx(looks[-1], rel=1e-12)
    halvings = math.ceil(math.log2(4.0 / (1e-13 * float(found.value))))
    assert len(looks) <= 1 + 5 + halvings + 1


@pytest.mark.parametrize("excess", [lambda x: np.expm1(x - 7.0), lambda x: (x / 7.0) ** 8 - 1.0])
def test_a_search_one_by_one_follows_its_chords_where_they_are_bounded_at_first(excess):
    """A chord that is too far from the middle is followed as far as halving allows: 12 looks, not 50."""
    looks = []

    def excesses(x):
        looks.append(float(x))
        return np.stack([excess(x)])

    assert float(first_limit(excesses=excesses, first_guess=1.0).value) == pytest.approx(7.0, rel=1e-12)
    assert len(looks) <= 16


def test_a_limit_far_below_a_small_first_guess_is_no_limit_at_once():
    """A thousandth of the guess of 1e-6: what lies next to nothing is a share of the guess."""
    found = first_limit_of_numbers(
        excesses=of_each(lambda x: xp.stack([x / 1e-9 - 1.0])), first_guess=np.array([1e-6])
    )
    np.testing.assert_allclose(found.value, 1e-9, rtol=1e-12)


@pytest.mark.parametrize("guess", [1e-6, 1e6])
def test_a_limit_at_once_takes_one_look_whatever_the_first_guess(guess):
    looks = []

    def excesses(x):
        looks.append(x[0, 0])
        return np.stack([1.0 + x])

    found = first_limit_of_numbers(excesses=excesses, first_guess=np.array([guess]))
    assert (float(found.value[0]), looks) == (0.0, [pytest.approx(1e-12 * guess)])
