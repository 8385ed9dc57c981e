"""Where each row of the table of results stands in the JSON document of a joint, and how the document is filled."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

import numpy as np

from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.results.table import results_of_joint
from asperity.types import Document

#: Group of a row → section of the document for the rows that state no place; of other groups the section is the group.
_SECTIONS = {
    "assembly": "torsional_stiffness.assembly",
    "series": "torsional_stiffness.series_with_bulk",
    "published": "torsional_stiffness.published",
    "forces": "standing.forces",
    "residuals": "standing.forces",
    "contacts": "standing",
    "diagnostics": "standing",
    "rolling": "rolling",
    "losses": "rolling",
    "life": "rolling",
    "bearings": "rated_bearings",
    "size": "",
}

#: Ends of keys whose unit is not that of the row → the value in their unit.
OTHER_UNITS: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "_hours": lambda seconds: seconds / 3600.0,
    "_per_hour": lambda per_second: 3600.0 * per_second,
}

_WAITS: Final = object()


def unit_of_key(unit: str) -> str:
    """A unit as the end of a key: N*m/rad is _Nm_per_rad."""
    return "" if unit == "1" else "_" + unit.replace("*", "").replace("^", "").replace("/", "_per_")


def place(row: Result) -> str:
    """Dotted path of a row in the document, ``*`` for the name of its contact, body or other part; empty for none.

    By group, name and unit where the row states none. What is judged stands among ``diagnostics``.
    """
    if row.place is not None:
        return row.place
    if row.limit is not None or row.categories:
        return ""
    section, key = _SECTIONS.get(row.group, row.group), row.name + unit_of_key(row.si_unit)
    if row.axis == "contact":
        return f"{'rolling' if section == 'rolling' else 'standing'}.contacts.*.{key}"
    return f"{section}.{key}".removeprefix(".") + ("" if row.axis == "one" else ".*")


def in_order(keys: str) -> Document:
    """Entries for rows, by their keys with spaces between them; those that no row of a joint fills are left out."""
    return dict.fromkeys(keys.split(), _WAITS)


def with_rows(document: Document, solved: SolvedJoint) -> Document:
    """A document with every row of a joint at its place: in the entries that wait for them, and behind all others.

    A ``ValueError`` is raised where something else stands at the place of a row.
    """
    filled = _copied(document)
    for row in results_of_joint(solved).values():
        if where := place(row):
            for name, value in _values(row, where, solved).items():
                _put(filled, [name if part == "*" else part for part in where.split(".")], value)
    return _without_waiting(filled)


def _values(row: Result, where: str, solved: SolvedJoint) -> Document:
    """Values by the names of the rows [unit of the key]; nan for those that the joint does not have."""
    names = row.row_names
    present = row.present is None or any(row.present(solved))
    values = np.asarray(row.of(solved) if present else np.nan, dtype=float)
    for end, converted in OTHER_UNITS.items():
        if where.removesuffix(".*").endswith(end):
            values = converted(values)
    return dict(zip(names, np.broadcast_to(values, (len(names),)), strict=True))


def _put(document: Document, path: list[str], value: Any) -> None:
    """Set the entry at a path, which waits for it or does not exist."""
    *above, key = path
    node = document
    for part in above:
        if node.get(part, _WAITS) is _WAITS:
            node[part] = {}
        node = node[part]
    if node.get(key, _WAITS) is not _WAITS:
        raise ValueError(f"{'.'.join(path)}: two entries of the document have this place")
    node[key] = value


def _copied(node: Any) -> Any:
    """The tables of a document, copied."""
    return {name: _copied(value) for name, value in node.items()} if isinstance(node, dict) else node


def _without_waiting(node: Any) -> Any:
    """A document without the entries that no row has filled."""
    if not isinstance(node, dict):
        return node
    return {name: _without_waiting(value) for name, value in node.items() if value is not _WAITS}
