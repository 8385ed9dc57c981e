"""Tables of a joint file apart from their numbers: files of one structure share one compiled program."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterable, Iterator
from typing import Any

from asperity.joint_file.si_tables import Values

Numbers = tuple[Any, ...]


def numbers(values: Values) -> Numbers:
    """All numbers of the tables of a joint file, in a fixed order.

    Parameters
    ----------
    values : dict
        Tables in SI units.

    Returns
    -------
    tuple of float
        The leaves that are numbers, by sorted names.
    """
    return tuple(value for value in _leaves(values) if not isinstance(value, str))


def _leaves(node: Any) -> Iterator[Any]:
    if isinstance(node, dict):
        for name in sorted(node):
            yield from _leaves(node[name])
    else:
        yield node


def with_numbers(values: Values, replaced: Iterable[Any]) -> Values:
    """The same tables in SI units with other numbers or arrays, in the order of :func:`numbers`."""
    filled: Values = _filled(values, iter(replaced))
    return filled


def _filled(node: Any, replaced: Iterator[Any]) -> Any:
    if isinstance(node, dict):
        return {name: _filled(node[name], replaced) for name in sorted(node)}
    return node if isinstance(node, str) else next(replaced)


def table_structure(values: Values) -> str:
    """The tables of a joint file as JSON with 1.0 for every number, to recognise files of the same structure."""
    return json.dumps(with_numbers(values, itertools.repeat(1.0)))
