"""Derivatives of the formula code under both engines: slopes of functions, and functions with rules for theirs."""

from __future__ import annotations

import contextlib
import functools
import operator
import threading
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from asperity.engine import trees
from asperity.engine.arrays import uses_jax, xp
from asperity.engine.dual import Dual, directions_at, highest_level, plain, slopes_at, value_at
from asperity.types import Tree


class _Levels(threading.local):
    highest = 0


_LEVELS = _Levels()


@contextlib.contextmanager
def _next_level() -> Iterator[int]:
    _LEVELS.highest += 1
    try:
        yield _LEVELS.highest
    finally:
        _LEVELS.highest -= 1


def without_slopes(tree: Tree) -> Tree:
    """A module of numbers whose derivatives are 0, whatever they depend on."""
    if uses_jax(tree):
        import jax

        return jax.lax.stop_gradient(tree)
    return trees.map(plain, tree) if _LEVELS.highest else tree


def value_and_slope(
    function: Callable[..., Tree], primals: tuple[Tree, ...], tangents: tuple[Tree, ...]
) -> tuple[Tree, Tree]:
    """A function of modules of numbers and its slope in one direction: :func:`jax.jvp` under both engines."""
    if uses_jax(primals, tangents):
        import jax

        return jax.jvp(function, primals, tangents)
    value, (slope,) = value_and_slopes(function, primals, [tangents])
    return value, slope


def value_and_slopes(
    function: Callable[..., Tree], primals: tuple[Tree, ...], directions: Sequence[tuple[Tree, ...]]
) -> tuple[Tree, list[Tree]]:
    """A function of modules of numbers, and its slopes in several directions, each of the structure of the value."""
    if uses_jax(primals, directions):
        import jax

        value, along = jax.linearize(function, *primals)
        return value, [along(*direction) for direction in directions]
    with _next_level() as level:
        given = trees.map(
            lambda leaf, *slopes: _with_slopes(leaf, slopes, level),
            primals,
            *directions,
        )
        return _apart(function(*given), level, len(directions))


def value_and_partial_slopes(
    function: Callable[..., Tree], numbers: tuple[Tree, ...]
) -> tuple[Tree, list[Tree]]:
    """A function of arrays, element by element, and its slopes by each of them, of the structure of the value.

    Under JAX each slope has a program of its own, in which the other arrays have none.
    """
    if not uses_jax(numbers):
        ones = [xp.ones_like(number) for number in numbers]
        directions = [
            tuple(one if j == k else 0.0 * one for j, one in enumerate(ones)) for k in range(len(numbers))
        ]
        return value_and_slopes(function, numbers, directions)
    import jax

    value, slopes = None, []
    for k, number in enumerate(numbers):
        value, slope = jax.jvp(
            lambda one, k=k: function(*numbers[:k], one, *numbers[k + 1 :]),
            (number,),
            (xp.ones_like(number),),
        )
        slopes.append(slope)
    return value, slopes


def _with_slopes(number: Tree, slopes: tuple[Tree, ...], level: int) -> Tree:
    """A number with its slopes; as it is where it has none, or is none of which there are any."""
    if not _is_continuous(number):
        return number
    known = [None if type(slope) is np.ndarray and not slope.any() else slope for slope in slopes]
    return number if all(slope is None for slope in known) else Dual(number, known, level)


def _is_continuous(number: Tree) -> bool:
    """Whether a number is one of which there are slopes, no count and no condition."""
    return isinstance(number, float) or getattr(getattr(number, "dtype", None), "kind", "") in ("f", "c")


def jacobian(function: Callable[[Tree], Tree], at: Tree) -> Tree:
    """Slopes of an array by an array, both with one axis, shape (values, numbers): :func:`jax.jacfwd`."""
    if uses_jax(at):
        import jax

        return jax.jacfwd(function)(at)
    value, slopes = value_and_slopes(function, (at,), [(row,) for row in np.eye(np.size(at))])
    return xp.stack(slopes, axis=-1) if slopes else np.zeros((*np.shape(value), 0))


def linearised(function: Callable[[Tree], Tree], at: Tree) -> tuple[Tree, Callable[[Tree], Tree]]:
    """A function of a module of numbers and its slope there, as a function of the direction: :func:`jax.linearize`."""
    if uses_jax(at):
        import jax

        return jax.linearize(function, at)
    return function(at), lambda direction: value_and_slope(function, (at,), (direction,))[1]


def _apart(result: Tree, level: int, count: int) -> tuple[Tree, list[Tree]]:
    """The value of a result and its slopes in each direction."""
    value = trees.map(lambda leaf: value_at(leaf, level), result)
    return value, [trees.map(lambda leaf, k=k: _slope(leaf, level, count, k), result) for k in range(count)]


def slopes_apart(module: Tree, level: int) -> list[Tree]:
    """Slopes of a module of numbers at a level, one module for each direction."""
    count = directions_at(trees.leaves(module), level)
    return [trees.map(lambda leaf, k=k: _slope(leaf, level, count, k), module) for k in range(count)]


def _slope(leaf: Tree, level: int, count: int, k: int) -> Tree:
    """Slope of one number in one direction."""
    found = slopes_at(leaf, level, count)[k]
    return np.zeros(np.shape(plain(leaf))) if found is None else found


#: Stands for a slope of 0 in a tree, where None would be no leaf.
_NO_SLOPE = object()


class with_rule:  # noqa: N801 - a decorator
    """A function with a rule for its derivatives: as :class:`jax.custom_jvp`, under both engines.

    ``fixed`` leading arguments are no numbers. With ``none_for_zero`` the other arguments are numbers, no modules
    of them, and the rule is given None for a tangent that is 0.
    """

    def __init__(self, function: Callable[..., Tree], *, fixed: int = 0, none_for_zero: bool = False) -> None:
        self._function, self._fixed, self._none_for_zero = function, fixed, none_for_zero
        self._rule: Callable[..., tuple[Tree, Tree]] | None = None
        self._knowing = threading.local()
        self.__doc__, self.__name__ = function.__doc__, function.__name__
        self.__module__, self.__wrapped__ = function.__module__, function

    def defjvp(self, rule: Callable[..., tuple[Tree, Tree]]) -> Callable[..., tuple[Tree, Tree]]:
        """Set the rule, of the fixed arguments, the primals and the tangents."""
        self._rule = rule
        return rule

    @functools.cached_property
    def _of_jax(self) -> Callable[..., Tree]:
        """The same for JAX."""
        import jax

        assert self._rule is not None
        function, rule = jax.custom_jvp(self._function, nondiff_argnums=tuple(range(self._fixed))), self._rule

        def with_none(*given: Tree) -> tuple[Tree, Tree]:
            *fixed, primals, tangents = given
            zero = jax.custom_derivatives.SymbolicZero
            return rule(*fixed, primals, tuple(None if isinstance(one, zero) else one for one in tangents))

        if self._none_for_zero:
            function.defjvp(with_none, symbolic_zeros=True)
        else:
            function.defjvp(rule)
        return function

    def __call__(self, *arguments: Tree) -> Tree:
        """The function, its slopes by the rule."""
        fixed, numbers = arguments[: self._fixed], arguments[self._fixed :]
        known = self._known
        if known is not None and all(map(operator.is_, arguments, known[0])):
            return known[1]
        leaves = trees.leaves(numbers)
        if uses_jax(leaves):
            return self._of_jax(*arguments)
        level = highest_level(leaves)
        if level == 0:
            return self._function(*arguments)
        return self._with_slopes(fixed, numbers, level, directions_at(leaves, level))

    @property
    def _known(self) -> tuple[tuple[Tree, ...], Tree] | None:
        """Numbers whose value is known while their slopes are found."""
        found: tuple[tuple[Tree, ...], Tree] | None = getattr(self._knowing, "value", None)
        return found

    def _with_slopes(
        self, fixed: tuple[Tree, ...], numbers: tuple[Tree, ...], level: int, count: int
    ) -> Tree:
        assert self._rule is not None
        primals = trees.map(lambda leaf: value_at(leaf, level), numbers)
        value, slopes, before = self(*fixed, *primals), [], self._known
        self._knowing.value = (*fixed, *primals), value
        try:
            for k in range(count):
                if all(slopes_at(leaf, level, count)[k] is None for leaf in trees.leaves(numbers)):
                    slopes.append(trees.map(lambda leaf: _NO_SLOPE, value))
                    continue
                slopes.append(self._rule(*fixed, primals, self._tangents(numbers, level, count, k))[1])
        finally:
            self._knowing.value = before

        def with_its_slopes(leaf: Tree, *along: Tree) -> Dual:
            return Dual(leaf, [None if slope is _NO_SLOPE else slope for slope in along], level)

        return trees.map(with_its_slopes, value, *slopes)

    def _tangents(self, numbers: tuple[Tree, ...], level: int, count: int, k: int) -> tuple[Tree, ...]:
        if not self._none_for_zero:
            return trees.map(lambda leaf: _slope(leaf, level, count, k), numbers)
        assert len(trees.leaves(numbers)) == len(numbers)
        return tuple(slopes_at(leaf, level, count)[k] for leaf in numbers)
