"""Formulas by NumPy and within programs of JAX: the same numbers in, the same numbers and slopes out."""

from __future__ import annotations

import inspect
import zlib
from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

import jax
import numpy as np
import pytest

from asperity.engine import trees
from asperity.engine.derivatives import value_and_slope

#: Largest differences of the numbers and of their slopes, over the scale of what is compared.
VALUE_TOLERANCE, SLOPE_TOLERANCE = 1e-12, 1e-9
#: Rows of arguments that are drawn for a formula, before those at the borders of its regimes.
DRAWN = 8
#: What every argument is in a row of its own.
EDGES = (0.0, np.nan, np.inf)

Scale = Callable[[np.ndarray], Any]


class Formula(NamedTuple):
    """A function of one tree of numbers, such a tree, and what differences are measured by.

    That is the number itself, or the ``scale`` of its array where it is more: of rows their median, for they
    have nothing to do with each other, and of one array its largest number.
    """

    function: Callable[[Any], Any]
    numbers: Any
    scale: Scale = np.max


def rows(
    function: Callable[..., Any],
    ranges: Mapping[str, tuple[float, float]],
    *borders: Mapping[str, Any],
    edges: tuple[float, ...] = EDGES,
    **fixed: Any,
) -> Formula:
    """A formula of keywords, or of places, that takes rows of numbers: drawn ones, then borders and edges.

    A border gives the value of some arguments, or a function that makes it of the others; ``fixed`` are no
    numbers.
    """
    generator = np.random.default_rng(zlib.crc32(function.__name__.encode()))

    def drawn() -> dict[str, float]:
        return {name: generator.uniform(*ends) for name, ends in ranges.items()}

    made = [drawn() for _ in range(DRAWN)]
    for border in [*borders, *({name: edge} for name in ranges for edge in edges)]:
        row = drawn()
        made.append(row | {name: value(row) if callable(value) else value for name, value in border.items()})
    places = [
        name
        for name, parameter in inspect.signature(function).parameters.items()
        if parameter.kind is parameter.POSITIONAL_OR_KEYWORD
    ]

    def of(numbers: dict[str, Any]) -> Any:
        return function(*(numbers[name] for name in places)) if places else function(**numbers, **fixed)

    return Formula(of, {name: np.array([row[name] for row in made]) for name in ranges}, np.median)


def direction(numbers: Any) -> Any:
    """Slopes of the numbers of a formula, each of the order of the typical number of its array."""
    generator = np.random.default_rng(1)

    def one(leaf: Any) -> np.ndarray:
        finite = np.abs(leaf[np.isfinite(leaf)])
        return generator.normal(size=np.shape(leaf)) * (np.median(finite) if finite.size else 1.0)

    return trees.map(one, numbers)


class Engines:
    """Formulas by their names, computed by NumPy one after the other and by JAX all in one program.

    Those ``alone`` have a program each that takes seconds to compile; their tests are slow ones.
    """

    def __init__(self, formulas: Mapping[str, Formula], alone: Mapping[str, Formula] | None = None) -> None:
        self._formulas = {
            name: each._replace(numbers=trees.map(lambda leaf: np.asarray(leaf, float), each.numbers))
            for name, each in {**formulas, **(alone or {})}.items()
        }
        self._groups = [tuple(formulas), *((name,) for name in alone or ())]
        self._found: dict[str, tuple[Any, Any]] = {}
        self._failures: dict[str, Exception] = {}
        self.names = [*formulas, *(pytest.param(name, marks=pytest.mark.slow) for name in alone or ())]

    def tests(self) -> tuple[Callable[[str], None], Callable[[str], None]]:
        """Two tests of every formula for a module to name: of its numbers, and of their slopes."""

        @pytest.mark.parametrize("name", self.names)
        def value(name: str) -> None:
            self.check_value(name)

        @pytest.mark.parametrize("name", self.names)
        def slope(name: str) -> None:
            self.check_slope(name)

        return value, slope

    def check_value(self, name: str) -> None:
        """Equal numbers, and nan and infinite ones at the same places."""
        function, numbers, scale = self._formulas[name]
        assert_alike(function(numbers), self._of_jax(name)[0], VALUE_TOLERANCE, scale=scale)

    def check_slope(self, name: str) -> None:
        """Equal slopes, finite at the same places."""
        function, numbers, scale = self._formulas[name]
        value, slope = value_and_slope(function, (numbers,), (direction(numbers),))
        assert_alike(slope, self._of_jax(name)[1], SLOPE_TOLERANCE, scale=scale, beside=value, kinds=False)

    def _of_jax(self, name: str) -> tuple[Any, Any]:
        """The value within a program, and its slope there; what kept the formula out of it is raised."""
        if name not in self._found and name not in self._failures:
            self._compute(next(group for group in self._groups if name in group))
        if name in self._failures:
            raise self._failures[name]
        return self._found[name]

    def _compute(self, group: tuple[str, ...]) -> None:
        def program(numbers: dict[str, Any], slopes: dict[str, Any]) -> dict[str, Any]:
            found = {}
            for name in group:
                function, given = self._formulas[name].function, (numbers[name],)
                try:
                    _, slope = jax.jvp(function, given, (slopes[name],))
                    found[name] = function(*given), _without_conditions(slope)
                except Exception as failure:
                    self._failures[name] = failure
            return found

        numbers = {name: self._formulas[name].numbers for name in group}
        slopes = {name: direction(self._formulas[name].numbers) for name in group}
        self._found |= jax.jit(program)(numbers, slopes)


def engine_tests(names: Iterable[Any]) -> tuple[Callable[..., None], Callable[..., None]]:
    """As :meth:`Engines.tests`, of formulas that a fixture ``engines`` makes, by their names."""
    every = pytest.mark.parametrize("name", list(names))

    def value(engines: Engines, name: str) -> None:
        engines.check_value(name)

    def slope(engines: Engines, name: str) -> None:
        engines.check_slope(name)

    return every(value), every(slope)


def _without_conditions(slopes: Any) -> Any:
    """Slopes as JAX has them, with 0 for those of counts and conditions, which it does not have."""
    return jax.tree.map(
        lambda leaf: np.zeros(leaf.shape) if leaf.dtype == jax.dtypes.float0 else leaf, slopes
    )


def assert_alike(
    ours: Any,
    theirs: Any,
    tolerance: float,
    *,
    scale: Scale = np.max,
    beside: Any = None,
    kinds: bool = True,
    skip: Iterable[str] = (),
) -> None:
    """Two trees of numbers with the same structure, and the same numbers but for rounding.

    ``scale`` as of :class:`Formula`, also of the arrays ``beside`` them in a tree of this structure: what is
    0 but for rounding, as the slope of a number that does not change, is known as well as these. ``kinds``:
    whether nan and both infinities are told apart. Places with one of the names in ``skip`` are not compared.
    """
    ours_by_place, ours_structure = jax.tree_util.tree_flatten_with_path(ours)
    theirs_by_place, theirs_structure = jax.tree_util.tree_flatten_with_path(theirs)
    assert ours_structure == theirs_structure
    others = [None] * len(ours_by_place) if beside is None else jax.tree.leaves(beside)
    for (place, one), (_, other), next_to in zip(ours_by_place, theirs_by_place, others, strict=True):
        name = jax.tree_util.keystr(place)
        if any(part in name for part in skip):
            continue
        a, b = np.asarray(one), np.asarray(other)
        assert a.shape == b.shape, name
        if a.dtype.kind in "biu":
            np.testing.assert_array_equal(a, b, err_msg=name)
            continue
        finite = np.isfinite(a) & np.isfinite(b)
        of_kind = np.asarray if kinds else np.isfinite
        np.testing.assert_array_equal(of_kind(a)[~finite], of_kind(b)[~finite], err_msg=name)
        _assert_close(name, a[finite], b[finite], tolerance, scale, next_to)


def _assert_close(
    name: str, ours: np.ndarray, theirs: np.ndarray, tolerance: float, scale: Scale, beside: Any
) -> None:
    if not ours.size:
        return
    size = scale(np.abs(theirs))
    if beside is not None:
        known = np.abs(np.asarray(beside, dtype=float))
        size = max(size, scale(known[np.isfinite(known)])) if np.isfinite(known).any() else size
    excess = np.abs(ours - theirs) - tolerance * np.maximum(np.abs(theirs), size)
    worst = np.argmax(excess)
    assert excess[worst] <= 0.0, f"{name}: NumPy {ours[worst]!r}, JAX {theirs[worst]!r}"
