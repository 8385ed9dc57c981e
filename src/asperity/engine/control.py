"""Loops, branches and maps of the formula code: Python's for numbers that are known, XLA's within its programs.

Under NumPy a loop ends as soon as it may, a branch that is not taken costs nothing, and a map computes all its entries
at once.
"""

from __future__ import annotations

import contextlib
import functools
import itertools
import math
import threading
from collections.abc import Callable, Iterator

import numpy as np

from asperity.engine import trees
from asperity.engine.arrays import MeetsJaxError, OwnNumber, is_of_jax, refuse_own, uses_jax, xp
from asperity.engine.dual import Dual, directions_at, highest_level, plain, slopes_at, value_at
from asperity.engine.many import Many, aligned, chosen, many, together
from asperity.types import Tree


class _ManyAtOnce(threading.local):
    """Whether a function of many numbers at once is being computed in this thread, and of which it is wanted."""

    active = False
    wanted: np.ndarray | None = None


_MANY = _ManyAtOnce()


def _wanted(conditions: np.ndarray) -> np.ndarray:
    """Conditions of many numbers, where the numbers are wanted."""
    return conditions if _MANY.wanted is None else conditions & _MANY.wanted


@contextlib.contextmanager
def _only(wanted: np.ndarray) -> Iterator[None]:
    """Within it only some of many numbers are wanted: loops and branches need not go on for the others."""
    before, _MANY.wanted = _MANY.wanted, wanted
    try:
        yield
    finally:
        _MANY.wanted = before


def while_loop(unfinished: Callable[[Tree], Tree], improve: Callable[[Tree], Tree], state: Tree) -> Tree:
    """A state, improved while it is unfinished, as :func:`jax.lax.while_loop`.

    A state of NumPy's numbers that becomes one of JAX's on the way, by what the functions close over, goes on as one.
    Of many states at once each keeps what it had when it was finished; loops and branches inside go on for the others.
    """
    while not uses_jax(state):
        going = unfinished(state)
        if is_of_jax(going):
            break
        if isinstance(going, Many):
            wanted = _wanted(going.values)
            if not wanted.any():
                return state
            with _only(wanted):
                better = improve(state)
            state = better if wanted.all() else chosen(Many(wanted), better, state)
            continue
        if not going:
            return state
        state = improve(state)
    import jax

    return jax.lax.while_loop(unfinished, improve, state)


def fori_loop(
    lower: int,
    upper: int,
    body: Callable[[Tree, Tree], Tree],
    state: Tree,
    *,
    settled: Callable[[Tree, Tree], Tree] | None = None,
) -> Tree:
    """A state after a fixed number of steps, as :func:`jax.lax.fori_loop`.

    Under NumPy it ends after the first step of which ``settled``, of the states before and after it, says so: further
    ones would change no more than rounding does.
    """
    for index in range(lower, upper):
        if uses_jax(state):
            import jax

            return jax.lax.fori_loop(index, upper, body, state)
        before, state = state, body(index, state)
        if settled is not None and not uses_jax(state) and settled(before, state):
            break
    return state


def is_rounding(residual: Tree) -> bool:
    """Whether residuals of equations whose terms are of order 1 are all as small as rounding makes them."""
    left = plain(residual)
    if isinstance(left, Many):
        most = left.values.reshape(len(left.values), -1).max(axis=1, initial=0.0)
        return not np.any(_wanted(most > _ROUNDING))
    return not np.any(left > _ROUNDING)


#: Four times the relative rounding error of a double.
_ROUNDING = 4.0 * float(np.finfo(float).eps)


def scan(
    step: Callable[[Tree, Tree], tuple[Tree, Tree]], state: Tree, given: Tree = None, length: int = 0
) -> Tree:
    """The last state and what each step gave, stacked, as :func:`jax.lax.scan`."""
    count = length if given is None else len(trees.leaves(given)[0])
    if uses_jax(state, given):
        import jax

        return jax.lax.scan(step, state, given, length=count)
    outputs = []
    for index in range(count):
        now = None if given is None else trees.map(lambda leaf, i=index: leaf[i], given)
        state, output = step(state, now)
        outputs.append(output)
    return state, stacked(outputs)


def cond(condition: Tree, yes: Callable[..., Tree], no: Callable[..., Tree], *numbers: Tree) -> Tree:
    """One of two functions of the numbers, as :func:`jax.lax.cond`."""
    if is_of_jax(condition):
        import jax

        def for_jax(function: Callable[..., Tree]) -> Callable[..., Tree]:
            def result(*numbers: Tree) -> Tree:
                found = function(*numbers)
                refuse_own(trees.leaves(found))
                return found

            return result

        return jax.lax.cond(condition, for_jax(yes), for_jax(no), *numbers)
    if not isinstance(condition, Many):
        return yes(*numbers) if condition else no(*numbers)
    met, missed = _wanted(condition.values), _wanted(~condition.values)
    if not missed.any():
        return yes(*numbers)
    if not met.any():
        return no(*numbers)
    with _only(met):
        of_met = yes(*numbers)
    with _only(missed):
        of_missed = no(*numbers)
    return chosen(condition, of_met, of_missed)


def map_over(function: Callable[[Tree], Tree], given: Tree) -> Tree:
    """A function of each entry of a module's first axis, as :func:`jax.lax.map`; under NumPy of all at once."""

    def by_jax(given: Tree) -> Tree:
        import jax

        return jax.lax.map(function, given)

    return _over(function, by_jax, (given,), out_axis=0)


def vectorised(function: Callable[..., Tree], *, out_axis: int = 0) -> Callable[..., Tree]:
    """A function over the first axes of its arguments, as :func:`jax.vmap`."""

    def by_jax(*arguments: Tree) -> Tree:
        import jax

        return jax.vmap(function, out_axes=out_axis)(*arguments)

    return lambda *arguments: _over(function, by_jax, arguments, out_axis)


def _over(
    function: Callable[..., Tree], by_jax: Callable[..., Tree], arguments: tuple[Tree, ...], out_axis: int
) -> Tree:
    """A function over the first axes of its arguments; by JAX where these or what it closes over are JAX's."""
    if uses_jax(arguments):
        return by_jax(*arguments)
    # one after the other where numbers have slopes, and where what the function closes over may be many already
    if _MANY.active or any(isinstance(leaf, Dual) for leaf in trees.leaves(arguments)):
        return stacked([function(*each) for each in entries(arguments)], axis=out_axis)
    _MANY.active = True
    try:
        return together(function(*many(arguments)), len(trees.leaves(arguments)[0]), out_axis)
    except MeetsJaxError:
        pass
    finally:
        _MANY.active = False
    return by_jax(*arguments)


def entries(given: Tree) -> list[Tree]:
    """The entries of a module of arrays along their first axis."""
    count = len(trees.leaves(given)[0])
    return [trees.map(lambda leaf, i=i: leaf[i], given) for i in range(count)]


def stacked(modules: list[Tree], axis: int = 0) -> Tree:
    """Modules of numbers as one with an axis more."""
    return trees.map(lambda *leaves: xp.stack([xp.asarray(leaf) for leaf in leaves], axis=axis), *modules)


def at_once(function: Callable[..., Tree], *modules: Tree) -> Tree:
    """A function of modules of numbers: under NumPy without its warnings, with NumPy's arrays as leaves.

    This is the door to the formula code. Formulas choose between regimes by ``where``, so that what is not chosen may
    divide by zero; nan and infinite numbers mean the same in both engines. Inside of it, with numbers of the engine's
    own or of JAX, the function is called as it is.
    """
    if uses_jax(modules) or any(isinstance(leaf, OwnNumber) for leaf in trees.leaves(modules)):
        return function(*modules)
    with np.errstate(all="ignore"):
        return trees.map(np.asarray, function(*trees.map(np.asarray, modules)))


def once(number: Tree) -> Tree:
    """A module of numbers that XLA computes once, not anew for every use.

    XLA writes what is cheap into each loop that uses it: a number of a contact into those over all its places. It does
    not with a division, and does not see that this one is by 1.
    """

    def divided(leaf: Tree) -> Tree:
        return leaf / xp.where(leaf == leaf, 1.0, xp.nan) if is_of_jax(leaf) else leaf

    return trees.map(divided, number) if uses_jax(number) else number


def traced_once(function: Callable[..., Tree], *, fixed: tuple[str, ...] = ()) -> Callable[..., Tree]:
    """A function that is traced once for all its uses in the programs of JAX; ``fixed`` arguments are no numbers."""

    @functools.cache
    def of_jax() -> Callable[..., Tree]:
        import jax

        return jax.jit(function, static_argnames=fixed)

    @functools.wraps(function)
    def either(*arguments: Tree, **options: Tree) -> Tree:
        return (of_jax() if uses_jax(arguments, options) else function)(*arguments, **options)

    return either


def in_one(module: Tree) -> tuple[Tree, Callable[[Tree], Tree]]:
    """All numbers of a module in one array of one axis, and the function that makes such a module of an array."""
    leaves = trees.leaves(module)
    sizes = [math.prod(np.shape(leaf)) for leaf in leaves]
    starts = [0, *itertools.accumulate(sizes)]

    def apart(numbers: Tree) -> Tree:
        places = iter(zip(starts, sizes, strict=False))

        def part(leaf: Tree) -> Tree:
            start, size = next(places)
            return numbers[start : start + size].reshape(np.shape(leaf))

        return trees.map(part, module)

    return xp.concatenate([xp.ravel(leaf) for leaf in leaves]), apart


def put(array: Tree, place: Tree, values: Tree) -> Tree:
    """An array with other values at some places, as ``array.at[place].set(values)`` of JAX."""
    return _changed(array, place, values, "set")


def added_at(array: Tree, place: Tree, values: Tree) -> Tree:
    """An array with values added at some places."""
    return _changed(array, place, values, "add")


def least_at(array: Tree, place: Tree, values: Tree) -> Tree:
    """An array with the smaller ones of its values and others at some places."""
    return _changed(array, place, values, "min")


_CHANGES: dict[str, Callable[..., None]] = {
    "set": lambda array, place, values: array.__setitem__(place, values),
    "add": np.add.at,
    "min": np.minimum.at,
}


def _changed(array: Tree, place: Tree, values: Tree, how: str) -> Tree:
    if uses_jax(array, values):
        import jax.numpy as jnp

        return getattr(jnp.asarray(array).at[place], how)(values)
    if isinstance(array, Dual) or isinstance(values, Dual):
        return _changed_with_slopes(array, place, values, how)
    if isinstance(array, Many) or isinstance(values, Many):
        return _changed_of_many(array, place, values, how)
    changed = np.array(array)
    _CHANGES[how](changed, place, values)
    return changed


def _changed_with_slopes(array: Tree, place: Tree, values: Tree, how: str) -> Tree:
    assert how != "min"
    level = highest_level([array, values])
    count = directions_at([array, values], level)
    given = zip(slopes_at(array, level, count), slopes_at(values, level, count), strict=True)
    slopes = [
        _changed(np.zeros(array.shape) if one is None else one, place, 0.0 if other is None else other, how)
        for one, other in given
    ]
    return Dual(_changed(value_at(array, level), place, value_at(values, level), how), slopes, level)


def _changed_of_many(array: Tree, place: Tree, values: Tree, how: str) -> Tree:
    count = len((array if isinstance(array, Many) else values).values)
    changed = np.array(together(array, count))
    at = (slice(None), *place) if isinstance(place, tuple) else (slice(None), place)
    _CHANGES[how](changed, at, aligned(values, changed[at].ndim - 1))
    return Many(changed)
