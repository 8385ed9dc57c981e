"""One formula by NumPy and within a program of JAX: the same numbers in, the same numbers out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from asperity.engine import trees
from asperity.engine.derivatives import value_and_slope

#: Random rows of the arguments of each formula; rows with borders follow them.
RANDOM = 8
#: What every argument is at borders of its own, the others as they were drawn.
EDGES = (0.0, np.nan, np.inf)


class Formula(NamedTuple):
    """A function of modules of numbers, and some of these with their slopes."""

    name: str
    function: Callable[..., Any]
    numbers: tuple[Any, ...]
    slopes: tuple[Any, ...]
    rows: Any


class Both(NamedTuple):
    """Value and slope of a formula."""

    value: Any
    by_slopes: Any
    slope: Any


def drawn(rng, ranges, borders, edges=EDGES):
    rows = {name: rng.uniform(*ends, RANDOM) for name, ends in ranges.items()}
    kinds = ["random"] * RANDOM
    extra = [*borders, *({name: edge} for name in ranges for edge in edges)]
    for border in extra:
        kinds.append(str(border))
        row = {name: rng.uniform(*ends) for name, ends in ranges.items()}
        for name, value in border.items():
            row[name] = value(row) if callable(value) else value
        rows = {name: np.append(values, row[name]) for name, values in rows.items()}
    return rows, kinds


def slopes_of(rng, tree):
    def one(leaf):
        leaf = np.asarray(leaf)
        finite = np.abs(leaf[np.isfinite(leaf)])
        return rng.normal(size=leaf.shape) * (np.median(finite) if finite.size else 1.0)

    return trees.map(one, tree)


def both(formula, numbers, slopes):
    f = lambda n: formula.function(n)
    return Both(f(numbers), *value_and_slope(f, (numbers,), (slopes,)))
