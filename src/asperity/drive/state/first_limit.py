"""Torque capacity: the largest output torque before the first limit is reached (A9)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from asperity.engine import trees
from asperity.engine.arrays import uses_jax, xp
from asperity.engine.control import vectorised, while_loop
from asperity.engine.derivatives import without_slopes
from asperity.engine.dual import highest_level
from asperity.implicit import implicit_root
from asperity.types import Array, Real

#: Relative width of the last interval of the search.
SEARCH_TOLERANCE = 1e-13
#: Share of the first guess below which a drive has no capacity at all.
SMALLEST_SHARE = 1e-12

#: How far a search goes beyond its first guess: forty doublings, 10^12 times the guess.
FARTHEST = 2.0**40

_MOST_STEPS = 150  # with ninety halvings, which reach any interval's last digit
_NUDGE = 0.2  # of the square of the relative width
_ALL_BUT_REACHED = 1e-6

#: Values that searches by NumPy look at together, of all searches: as many take hardly longer than one.
_TOGETHER = 64
#: Where each looks around the root of its chord, in parts of what that may be off; elsewhere it looks evenly.
_AROUND = np.array([-256.0, -16.0, -1.0, -1.0 / 16.0, 1.0 / 16.0, 1.0, 16.0, 256.0])


class FirstLimit(NamedTuple):
    """Where the first of several limits is reached.

    Parameters
    ----------
    value : Array
        Largest value that keeps all limits; infinite where none is reached, 0 where one is reached at once.
    which : Array
        Which limit it is; −1 where none is reached.
    """

    value: Array
    which: Array


class _Search(NamedTuple):
    lower: Array  # no limit is reached here
    upper: Array  # one is, once bracketed; before, the next values end here
    below: Array  # the largest excess at the lower bound; at 0 taken as that of a ratio to its limit
    above: Array  # and at the upper one
    bracketed: Array
    slack: Array  # width that as many halvings would have left
    which: Array  # the one reached at the upper bound
    nearest: Array  # the one of the largest excess at the lower bound
    steps: Array


def _chord(state: _Search) -> tuple[Array, Array]:
    """Where the chord says that the limit is reached, and how far it may be off."""
    lower, upper = state.lower, state.upper
    chord = (state.above * lower - state.below * upper) / (state.above - state.below)
    off = xp.maximum(_NUDGE * (upper - lower) ** 2 / upper, 0.5 * SEARCH_TOLERANCE * upper)
    return chord, off


def _within(state: _Search) -> Array:
    """The one value to look at next: near the root of the chord, but no farther off than halving can make up for."""
    lower, upper = state.lower, state.upper
    width, half = upper - lower, 0.5 * (lower + upper)
    chord, nudge = _chord(state)
    side = xp.sign(half - chord)
    near = xp.where(nudge < abs(half - chord), chord + side * nudge, half)
    reach = xp.maximum(state.slack - 0.5 * width, 0.0)
    trial = xp.where(abs(near - half) <= reach, near, half - side * reach)
    return xp.where(xp.isfinite(trial), trial, half)


def _several_within(state: _Search, looks: int) -> Array:
    """Values to look at next, in order: some even, which end any search, and some around the root of the chord."""
    lower, upper = state.lower, state.upper
    chord, off = _chord(state)
    others = looks - _AROUND.size
    even = lower + _along(np.arange(1, others + 1) / (others + 1), lower) * (upper - lower)
    around = xp.clip(xp.where(xp.isfinite(chord), chord, upper) + _along(_AROUND, lower) * off, lower, upper)
    return xp.sort(xp.concatenate([even, around]), axis=0)


def _ahead(state: _Search, start: Array, looks: int) -> Array:
    """The values to look at while no limit is reached: up to the end of the interval; next to nothing at first."""
    lower = state.lower
    even = lower + _along(np.arange(1, looks + 1) / looks, lower) * (state.upper - lower)
    first = xp.where(state.steps == 0, SMALLEST_SHARE * start, even[0])
    return xp.concatenate([first[None], even[1:]])


def _along(values: Any, of: Array) -> Array:
    """Values along an axis before those of another array."""
    along: Array = values.reshape(-1, *(1 for _ in of.shape))
    return along


def slip_ratio(*, normal_force: Real, tangential_force: Real, friction_coefficient: Real) -> Array:
    r"""Traction used over traction available, :math:`|T|/(\mu N)`.

    Parameters
    ----------
    normal_force, tangential_force : Real
        N and T of a contact [N].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Array
        Ratio [-]; the contact slips grossly from 1 on. Infinite for a force without a normal load, 0 for neither.

    References
    ----------
    Amontons–Coulomb friction; Zou et al. 2025, equation (22).
    """
    limit = friction_coefficient * normal_force
    touching = limit > 0.0
    force = xp.abs(tangential_force)
    return xp.where(touching, force / xp.where(touching, limit, 1.0), xp.where(force > 0.0, xp.inf, 0.0))


def _searched(excesses: Callable[[Array], Array], start: Array, farthest: Real, looks: int) -> _Search:
    """The interval of the first limit, narrowed to its last digits; none beyond so many times the start.

    The excesses are those of ``looks`` values at once, along an axis before those of the start.
    """

    def searching(state: _Search) -> Array:
        wide = (state.upper - state.lower > SEARCH_TOLERANCE * state.upper) & (
            state.upper > SMALLEST_SHARE * start
        )
        return ~state.bracketed & (state.upper <= farthest * start) | state.bracketed & wide

    def unfinished(state: _Search) -> Array:
        return xp.any(searching(state)) & (state.steps < _MOST_STEPS)

    def narrow(state: _Search) -> _Search:
        """Next to nothing, then the first guess, doubled until a limit is reached; then narrow the interval."""
        within = _within(state)[None] if looks == 1 else _several_within(state, looks)
        trials = xp.where(state.bracketed, within, _ahead(state, start, looks))
        excess = excesses(trials)
        beyond = excess >= 0.0
        any_beyond = xp.any(beyond, axis=0)
        reached = xp.any(any_beyond, axis=0)
        first = xp.argmax(any_beyond, axis=0)  # of the values at which a limit is reached
        last = xp.where(reached, first, looks) - 1  # of those before it
        known = xp.where(xp.isnan(excess), -1.0, excess)
        largest, at = xp.max(known, axis=0), xp.argmax(known, axis=0)
        further = xp.where((state.steps == 0) & (looks == 1), start, 2.0 * state.upper)
        narrowed = _Search(
            lower=_before(last, trials, state.lower),
            upper=xp.where(reached, _at(first, trials), xp.where(state.bracketed, state.upper, further)),
            below=_before(last, largest, state.below),
            above=xp.where(reached, _at(first, largest), state.above),
            bracketed=state.bracketed | reached,
            slack=xp.where(
                state.bracketed, 0.5 * state.slack, xp.where(reached, _at(first, trials) - state.lower, 0.0)
            ),
            which=xp.where(reached, _at(first, xp.argmax(beyond, axis=0)), state.which),
            nearest=_before(last, at, state.nearest),
            steps=state.steps + 1,
        )
        goes_on = searching(state)
        kept: _Search = trees.map(lambda new, old: xp.where(goes_on, new, old), narrowed, state)
        return kept._replace(steps=narrowed.steps)

    nowhere = xp.zeros_like(start, dtype=bool)
    nothing = xp.zeros_like(start)
    first = _Search(
        lower=nothing,
        upper=start if looks > 1 else SMALLEST_SHARE * start,
        below=nothing - 1.0,
        above=nothing,
        bracketed=nowhere,
        slack=nothing,
        which=xp.argmax(nowhere[None], axis=0),
        nearest=xp.argmax(nowhere[None], axis=0),
        steps=xp.asarray(0),
    )
    last: _Search = while_loop(unfinished, narrow, first)
    # where nothing can be computed beyond a limit, the one that is all but reached below it
    return last._replace(which=xp.where(last.below > -_ALL_BUT_REACHED, last.nearest, last.which))


def _at(number: Array, values: Array) -> Array:
    """The values of one of the looks, by its number."""
    return xp.take_along_axis(values, number[None], axis=0)[0]


def _before(number: Array, values: Array, otherwise: Array) -> Array:
    """The same of the last look before a limit, or what was known before all of them."""
    return xp.where(number >= 0, _at(xp.maximum(number, 0), values), otherwise)


def first_limit_of_numbers(
    *, excesses: Callable[[Any], Any], first_guess: Real, farthest: Real = FARTHEST
) -> FirstLimit:
    """That of :func:`first_limit`, without derivatives, of functions of several values at once.

    ``excesses``: values, shape (looks, ...), to the functions, shape (limits, looks, ...); under NumPy many values take
    hardly longer than one. Limits are looked for up to ``farthest`` times the first guess [-]: up to it with 1, not at
    all with 0.
    """
    start = xp.asarray(first_guess, dtype=float)
    last = _searched(excesses, start, farthest, max(2 * _AROUND.size, _TOGETHER // start.size))
    return _found(last, first_guess)


def of_each(excesses: Callable[..., Array], *given: np.ndarray) -> Callable[[Array], Array]:
    """Functions of one value, shape (limits,), as those of several values of several searches at once.

    ``given``: numbers of each search, further arguments of the functions.
    """
    each = vectorised(excesses)

    def of_all(values: Array) -> Array:
        beside = [xp.broadcast_to(number, values.shape).ravel() for number in given]
        return each(values.ravel(), *beside).T.reshape(-1, *values.shape)

    return of_all


def _one_look(excesses: Callable[[Array], Array]) -> Callable[[Array], Array]:
    """Functions of one value as those of several, of which there is one."""
    return lambda values: excesses(values[0])[:, None]


def _found(last: _Search, start: Real) -> FirstLimit:
    """What a search has found: 0 where a limit is reached at once, infinite where none is."""
    at_once = last.bracketed & (last.upper <= SMALLEST_SHARE * start)
    value = xp.where(last.bracketed, xp.where(at_once, 0.0, last.lower), xp.inf)
    return FirstLimit(value, xp.where(last.bracketed, last.which, -1))


def first_limit(*, excesses: Callable[[Array], Array], first_guess: Real) -> FirstLimit:
    r"""Smallest positive value at which one of several functions becomes positive.

    .. math:: \max_i g_i(x) = 0

    Parameters
    ----------
    excesses : callable
        Values, shape (...), to the functions g, shape (limits, ...); negative before a limit, and not negative at it
        and beyond. A nan counts as not reached.
    first_guess : Real
        Value of the right order, shape (...), where the search begins; in the unit of the values [any].

    Returns
    -------
    FirstLimit
        The value, shape (...), with the implicit derivative of the limit that is reached; and which one that is.

    Notes
    -----
    A first look next to zero, for limits that are reached at once; doubling from the guess until one is reached; then
    the interval shrinks by chords that are nudged to the other side of the root and bounded, so that it never takes
    more steps than halving and one. A limit that jumps instead of passing through zero has no implicit derivative; 0 is
    returned for it.

    References
    ----------
    Equation (A9) of :doc:`/equations`. I. F. D. Oliveira and R. H. C. Takahashi, ACM Trans. Math. Softw. 47 (2021) 5.
    """
    at_guess = excesses(xp.asarray(first_guess))
    if not uses_jax(first_guess, at_guess):
        start = without_slopes(xp.asarray(first_guess, dtype=float))
        one = _one_look(lambda value: without_slopes(excesses(value)))
        found = _found(_searched(one, start, FARTHEST, 1), start)
        return with_derivative(excesses=excesses, limit=found) if highest_level([at_guess]) else found
    import jax

    excesses = jax.jit(excesses)  # traced once for the search and for the derivative
    found = searched_limit(excesses=excesses, first_guess=first_guess)
    return with_derivative(excesses=excesses, limit=found)


def searched_limit(
    *, excesses: Callable[[Array], Array], first_guess: Real, farthest: Real = FARTHEST
) -> FirstLimit:
    """That of :func:`first_limit`, without derivatives, which are not traced either."""
    start, farthest = without_slopes((xp.asarray(first_guess), xp.asarray(farthest)))
    import jax

    program = jax.make_jaxpr(jax.jit(excesses))(start)
    fixed = without_slopes(program.consts)

    def excesses_of(value: Array) -> Array:
        (excess,) = jax.core.eval_jaxpr(program.jaxpr, fixed, value)
        return excess

    found: FirstLimit = without_slopes(_found(_searched(_one_look(excesses_of), start, farthest, 1), start))
    return found


def with_derivative(*, excesses: Callable[[Array], Array], limit: FirstLimit) -> FirstLimit:
    """A limit that is known, with its implicit derivative; none where it is reached at once, or never."""
    reached = (limit.which >= 0) & (limit.value > 0.0)
    known = xp.where(reached, limit.value, 1.0)

    def excess(value: Array) -> Array:
        at = xp.where(reached, limit.which, 0)
        chosen = xp.take_along_axis(excesses(value), at[None], axis=0)[0]
        return xp.where(reached, chosen, value - known)

    def divide(linear, right_side: Array) -> Array:  # type: ignore[no-untyped-def]
        slope = linear(xp.ones_like(right_side))
        return right_side / xp.where(slope == 0.0, 1.0, slope)

    # the root is known: the search returns it, and implicit_root gives it the implicit derivative
    root = implicit_root(excess, known, lambda _, known_root: known_root, divide)
    return FirstLimit(xp.where(reached, root, limit.value), limit.which)
