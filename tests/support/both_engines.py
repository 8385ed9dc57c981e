"""Formulas by NumPy and within one program of JAX: the same numbers in, the same numbers and slopes out."""

from __future__ import annotations

import inspect
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


class Formula(NamedTuple):
    """A function of one tree of numbers, and such a tree."""

    function: Callable[[Any], Any]
    numbers: Any


def over(generator: np.random.Generator, ranges: Mapping[str, tuple[float, float]]) -> dict[str, float]:
    """One number from each range."""
    return {name: generator.uniform(*ends) for name, ends in ranges.items()}


def rows(
    function: Callable[..., Any],
    ranges: Mapping[str, tuple[float, float]],
    *borders: Mapping[str, Any],
    edges: tuple[float, ...] = EDGES,
    **fixed: Any,
) -> Formula:
    """A formula of keywords, or of places, that takes rows of numbers: drawn ones, then borders and edges.

    A border gives the value of some arguments, or a function that makes it of the others; ``fixed`` are no numbers.
    """
    generator = np.random.default_rng(sum(map(ord, function.__name__)))
    made = [over(generator, ranges) for _ in range(DRAWN)]
    for border in [*borders, *({name: edge} for name in ranges for edge in edges)]:
        row = over(generator, ranges)
        for name, value in border.items():
            row[name] = value(row) if callable(value) else value
        made.append(row)
    places = [
        name
        for name, parameter in inspect.signature(function).parameters.items()
        if parameter.kind is parameter.POSITIONAL_OR_KEYWORD
    ]

    def of(numbers: dict[str, Any]) -> Any:
        return function(*(numbers[name] for name in places)) if places else function(**numbers, **fixed)

    return Formula(of, {name: np.array([row[name] for row in made]) for name in ranges})


def near(generator: np.random.Generator, tree: Any, share: float) -> Any:
    """A tree of numbers, each changed by up to a share of itself."""
    return trees.map(lambda leaf: leaf * (1.0 + share * generator.uniform(-1.0, 1.0, np.shape(leaf))), tree)


def direction(numbers: Any) -> Any:
    """Slopes of the numbers of a formula, each of the order of the typical number of its array."""
    generator = np.random.default_rng(1)

    def one(leaf: Any) -> np.ndarray:
        finite = np.abs(leaf[np.isfinite(leaf)])
        return generator.normal(size=np.shape(leaf)) * (np.median(finite) if finite.size else 1.0)

    return trees.map(one, numbers)


class Engines:
    """Formulas by their names, computed by NumPy one after the other and by JAX all in one program."""

    def __init__(self, formulas: Mapping[str, Formula]) -> None:
        self.formulas = {
            name: Formula(each.function, trees.map(lambda leaf: np.asarray(leaf, float), each.numbers))
            for name, each in formulas.items()
        }
        self._of_jax: tuple[dict[str, Any], dict[str, Exception]] | None = None

    def of_jax(self, name: str) -> tuple[Any, Any]:
        """The value within a program, and its slope there; what kept the formula out of it is raised."""
        if self._of_jax is None:
            failures: dict[str, Exception] = {}

            def program(numbers: dict[str, Any], slopes: dict[str, Any]) -> dict[str, Any]:
                found = {}
                for each, formula in self.formulas.items():
                    try:
                        _, slope = jax.jvp(formula.function, (numbers[each],), (slopes[each],))
                        found[each] = formula.function(numbers[each]), _without_conditions(slope)
                    except Exception as failure:  # noqa: BLE001 - the test of this formula raises it
                        failures[each] = failure
                return found

            numbers = {each: formula.numbers for each, formula in self.formulas.items()}
            slopes = {each: direction(formula.numbers) for each, formula in self.formulas.items()}
            self._of_jax = jax.jit(program)(numbers, slopes), failures
        found, failures = self._of_jax
        if name in failures:
            raise failures[name]
        return found[name]

    def check_value(self, name: str) -> None:
        """Equal numbers, and nan and infinite ones at the same places."""
        formula = self.formulas[name]
        assert_alike(formula.function(formula.numbers), self.of_jax(name)[0], VALUE_TOLERANCE)

    def check_slope(self, name: str) -> None:
        """Equal slopes, finite at the same places."""
        function, numbers = self.formulas[name]
        _, slope = value_and_slope(function, (numbers,), (direction(numbers),))
        assert_alike(slope, self.of_jax(name)[1], SLOPE_TOLERANCE, kinds=False)


def _without_conditions(slopes: Any) -> Any:
    """Slopes as JAX has them, with 0 for those of counts and conditions, which it does not have."""
    return jax.tree.map(lambda leaf: np.zeros(leaf.shape) if leaf.dtype == jax.float0 else leaf, slopes)


def assert_alike(
    ours: Any,
    theirs: Any,
    tolerance: float,
    *,
    kinds: bool = True,
    scale: Callable[[np.ndarray], Any] = np.median,
    skip: Iterable[str] = (),
) -> None:
    """Two trees of numbers with the same structure, and the same numbers but for rounding.

    Differences are measured by the number itself, or by the ``scale`` of the finite ones of its array where that is
    more: what is small in its array is not known better than the rest of it. ``kinds``: whether nan and both infinities
    are told apart. Fields with a name in ``skip`` are not compared.
    """
    ours_by_place, ours_structure = jax.tree.flatten_with_path(ours)
    theirs_by_place, theirs_structure = jax.tree.flatten_with_path(theirs)
    assert ours_structure == theirs_structure
    for (place, one), (_, other) in zip(ours_by_place, theirs_by_place, strict=True):
        name = jax.tree_util.keystr(place)
        if any(part in name for part in skip):
            continue
        a, b = np.asarray(one), np.asarray(other)
        assert a.shape == b.shape, name
        if a.dtype.kind in "biu":
            np.testing.assert_array_equal(a, b, err_msg=name)
            continue
        finite = np.isfinite(a) & np.isfinite(b)
        if kinds:
            np.testing.assert_array_equal(a[~finite], b[~finite], err_msg=name)
        else:
            np.testing.assert_array_equal(np.isfinite(a), np.isfinite(b), err_msg=name)
        size = np.abs(b[finite])
        allowed = tolerance * np.maximum(size, scale(size) if size.size else 0.0)
        misses = np.abs(a[finite] - b[finite]) > allowed
        assert not misses.any(), f"{name}: NumPy {a[finite][misses]}, JAX {b[finite][misses]}"


def both_ways(engines: Engines, names: Iterable[str]) -> pytest.MarkDecorator:
    """One test for each formula."""
    return pytest.mark.parametrize("name", list(names))
