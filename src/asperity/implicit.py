"""Roots with implicit derivatives."""

from __future__ import annotations

import functools
import operator
from collections.abc import Callable

import numpy as np

from asperity.engine import trees
from asperity.engine.arrays import uses_jax, xp
from asperity.engine.control import vectorised, while_loop
from asperity.engine.derivatives import linearised, slopes_apart, value_and_slope, without_slopes
from asperity.engine.dual import Dual, constant_at, highest_level
from asperity.linear import solve
from asperity.types import Array, Tree

#: Relative change at which the numbers of :func:`settled_root` are those that they give back [-].
SETTLED = 1e-9
_ROUNDS = 20
#: Change relative to 1 and the root after which Newton's next one, its square, is not taken [-].
SMALL_STEP = 1e-8
#: Steps to a root between two ends, and the relative width of an interval that is not halved any more [-].
_MOST_STEPS, _RESOLVED = 120, 1e-15


def implicit_root(
    equations: Callable[[Tree], Tree],
    start: Tree,
    search: Callable[[Callable[[Tree], Tree], Tree], Tree],
    solve: Callable[[Callable[[Tree], Tree], Tree], Tree],
) -> Tree:
    r"""Root of equations, with their derivatives at it.

    .. math:: f(x; p) = 0 \quad\Rightarrow\quad \frac{\partial f}{\partial x}\,\dot x = -\frac{\partial f}{\partial p}\,
        \dot p

    Parameters
    ----------
    equations : callable
        f, from the unknowns to as many residuals of the same structure. The numbers p that it closes over may be
        differentiated.
    start : Array or module of Array
        Where the search begins.
    search : callable
        Finds x from f and the start; it is not differentiated.
    solve : callable
        Finds x' from the linear function L and y, so that L(x') = y.

    Returns
    -------
    Array or module of Array
        x, with derivatives in both modes. Whether it is a root is for the caller to check.

    Notes
    -----
    As :func:`jax.lax.custom_root`, but nothing is traced for the derivatives until they are wanted.

    References
    ----------
    The implicit function theorem.
    """
    if not uses_jax(start, equations(start)):
        return _root_of_numbers(equations, start, search, solve)
    import jax

    start = jax.lax.stop_gradient(start)
    # a function of its own, so that each of its uses and derivatives is written once
    program, shape = jax.make_jaxpr(jax.jit(equations), return_shape=True)(start)
    structure = jax.tree.structure(shape)

    def equations_of(x: Tree, numbers: list[Tree]) -> Tree:
        values = jax.core.eval_jaxpr(program.jaxpr, numbers, *trees.leaves(x))
        return jax.tree.unflatten(structure, values)

    fixed = jax.lax.stop_gradient(program.consts)
    solution = jax.lax.stop_gradient(search(lambda x: equations_of(x, fixed), start))

    @jax.custom_jvp
    def root(solution: Tree, numbers: Tree) -> Tree:
        return solution

    @root.defjvp
    def derivative(primals: Tree, tangents: Tree) -> Tree:
        (solution, given), (_, moved) = primals, tangents
        at = root(solution, given)  # the root itself, so that this may be differentiated in turn
        _, change = jax.jvp(lambda numbers: equations_of(at, numbers), (given,), (moved,))
        _, linear = jax.linearize(lambda x: equations_of(x, given), at)
        return at, trees.map(lambda leaf: -leaf, solve(linear, change))

    return root(solution, program.consts)


def _root_of_numbers(
    equations: Callable[[Tree], Tree],
    start: Tree,
    search: Callable[[Callable[[Tree], Tree], Tree], Tree],
    solve: Callable[[Callable[[Tree], Tree], Tree], Tree],
) -> Tree:
    """The root of NumPy's numbers; with slopes where the equations have some at it.

    The search does without slopes of the numbers that are given, but may find those of the equations.
    """
    start = without_slopes(start)
    given = highest_level(trees.leaves(equations(start)))
    found = without_slopes(search(lambda x: _without_levels(equations(x), 1, given), start))
    highest = highest_level(trees.leaves(equations(found)))
    for level in range(1, highest + 1):  # slopes of the higher ones have slopes of the lower ones

        def up_to(lowest: int, x: Tree) -> Tree:
            return _without_levels(equations(x), lowest, highest)

        misfit = up_to(level + 1, found)
        if highest_level(trees.leaves(misfit)) < level:
            continue
        linear = _known_once(linearised(functools.partial(up_to, level), found)[1])
        steps = [trees.map(operator.neg, solve(linear, change)) for change in slopes_apart(misfit, level)]
        found = trees.map(lambda leaf, *slopes, level=level: Dual(leaf, slopes, level), found, *steps)
    return found


def _without_levels(module: Tree, lowest: int, highest: int) -> Tree:
    """A module of numbers without their slopes of some levels."""
    for level in range(lowest, highest + 1):
        module = trees.map(lambda leaf, level=level: constant_at(leaf, level), module)
    return module


def _known_once(linear: Callable[[Tree], Tree]) -> Callable[[Tree], Tree]:
    """A linear function that is computed once for each direction of NumPy's numbers."""
    known: dict[bytes, Tree] = {}

    def of_direction(direction: Tree) -> Tree:
        if not isinstance(direction, np.ndarray):
            return linear(direction)
        key = direction.tobytes()
        if key not in known:
            known[key] = linear(direction)
        return known[key]

    return of_direction


def elementwise_root(
    function: Callable[[Tree, Array], Array],
    numbers: Tree,
    lower: Array,
    upper: Array,
    start: Array,
    *,
    small_step: float = SMALL_STEP,
) -> Array:
    """Root between two ends of a function that rises there, number by number, with its implicit derivative.

    The function is of a module of numbers, which may be differentiated, and of the unknowns. Newton's steps from the
    start, halved intervals where they leave the one that is known to hold the root. An end stands for a root beyond it.
    ``small_step``: change, relative to 1 and the root, after which the next one, its square, is not taken [-].
    """
    fixed = without_slopes(numbers)
    low, high, first = without_slopes((lower, upper, start))
    found = _between(functools.partial(function, fixed), low, high, first, small_step)
    if not highest_level(trees.leaves(numbers)) and not uses_jax(numbers, found):
        return found
    return implicit_root(functools.partial(function, numbers), found, lambda _, known: known, _divided)


def _between(
    function: Callable[[Array], Array], lower: Array, upper: Array, start: Array, small_step: float
) -> Array:
    """The root of each number between its ends."""

    def unfinished(state: tuple[Array, ...]) -> Array:
        rounds, _, _, _, step = state
        return (rounds < _MOST_STEPS) & xp.any(step > 0.0)

    def improved(state: tuple[Array, ...]) -> tuple[Array, ...]:
        rounds, low, high, x, before = state
        value, slope = value_and_slope(function, (x,), (xp.ones_like(x),))
        low, high = xp.where(value < 0.0, x, low), xp.where(value < 0.0, high, x)
        newton = x - value / xp.where(slope == 0.0, 1.0, slope)
        inside = (newton >= low) & (newton <= high) & (slope > 0.0) & (abs(newton - x) <= 0.5 * before)
        better = xp.where(before == 0.0, x, xp.where(inside, newton, 0.5 * (low + high)))
        step = abs(better - x)
        small = step <= xp.where(inside, small_step, _RESOLVED) * (1.0 + abs(better))
        return rounds + 1, low, high, better, xp.where(small, 0.0, step)

    return while_loop(unfinished, improved, (xp.asarray(0), lower, upper, start, 2.0 * (upper - lower)))[3]


def _divided(linear: Callable[[Array], Array], right: Array) -> Array:
    """The x for which a linear function, number by number, is another array."""
    return right / linear(xp.ones_like(right))


def settled_root(change: Callable[[Array], Array], start: Array) -> Array:
    """Numbers above 0 that a function gives back, by repetition; derivatives of the implicit function theorem.

    ``change`` is what the function adds to numbers of the shape of the start. After 20 rounds at the latest; whether
    the change is small there, :data:`SETTLED`, is for the caller to check.
    """
    return implicit_root(change, start, _repeated, _solved)


def _repeated(change: Callable[[Array], Array], start: Array) -> Array:
    def unsettled(state: tuple[Array, Array, Array]) -> Array:
        rounds, numbers, left = state
        return (rounds == 0) | ((rounds <= _ROUNDS) & (xp.max(xp.abs(left / numbers)) > SETTLED))

    def improved(state: tuple[Array, Array, Array]) -> tuple[Array, Array, Array]:
        rounds, numbers, left = state
        return rounds + 1, numbers + left, change(numbers + left)

    # the change of the start is found in the loop, so that its program is compiled once
    return while_loop(unsettled, improved, (xp.asarray(0), start, xp.zeros_like(start)))[1]


def _solved(linear: Callable[[Array], Array], right: Array) -> Array:
    """The x for which a linear function of an array is another of its shape."""
    unit = xp.eye(right.size).reshape(right.size, *right.shape)
    if uses_jax(right):
        unit = right.ravel()[0] * 0.0 + unit
    rows = vectorised(linear)(unit)
    return solve(rows.reshape(right.size, right.size).T, right.ravel()).reshape(right.shape)
