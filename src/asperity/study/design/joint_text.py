"""A joint file written back: the tables of a case as TOML, with some of its numbers replaced, to the last digit."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from pydantic import BaseModel

from asperity.joint_file.key import Quantity
from asperity.joint_file.model import Case
from asperity.joint_file.values import key_at, numeric_keys, replace_values
from asperity.unit_table import Dimension
from asperity.units import from_si


def exact_text(value_si: float, unit: str) -> str:
    """A quantity as text that reads back as the same number to rounding.

    Parameters
    ----------
    value_si : float
        Value in SI units.
    unit : str
        Unit to write.

    Returns
    -------
    str
        Number with all its digits, and unit.

    Examples
    --------
    >>> exact_text(0.0135, "mm")
    '13.5 mm'
    """
    number = repr(float(from_si(value_si, unit)))
    return number if unit == "1" else f"{number} {unit}"


def joint_file_text(case: Case, changes: Mapping[str, float], *, comment: str) -> str:
    """The text of a joint file that says what a case says, but for some numbers.

    Parameters
    ----------
    case : Case
        The joint file to start from.
    changes : mapping
        Dotted path → new value [SI]. A number that has a tolerance keeps it.
    comment : str
        Lines for the head of the file, without the comment sign.

    Returns
    -------
    str
        TOML. Comments of the original file are not kept.
    """
    stated = numeric_keys(case)
    written = {}
    for path, value in changes.items():
        key = key_at(path)
        text = exact_text(value, key.unit)
        tolerance = stated[path].tolerance if path in stated else 0.0
        plain = key.dimension is Dimension.DIMENSIONLESS and not tolerance
        written[path] = float(value) if plain else text
        if tolerance:
            written[path] = f"{text} +- {exact_text(tolerance, key.unit)}"
    tables = replace_values(_texts(case), written)
    head = "".join(f"# {line}".rstrip() + "\n" for line in comment.splitlines())
    return head + "\n".join(_lines(tables, ())).rstrip() + "\n"


def _texts(node: Any) -> Any:
    if isinstance(node, Quantity):
        plain = node.text.replace("_", "").replace(".", "").isdigit()
        return (int(node.text) if node.text.isdigit() else float(node.text)) if plain else node.text
    if isinstance(node, BaseModel):
        return {name: _texts(value) for name, value in node if value is not None}
    if isinstance(node, dict):
        return {name: _texts(value) for name, value in node.items()}
    return node


def _scalar(value: Any) -> str:
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{name} = {_scalar(each)}" for name, each in value.items()) + " }"
    return repr(value)


def _lines(table: Mapping[str, Any], path: tuple[str, ...]) -> Iterator[str]:
    """Lines of a table: its own keys first, then its sub-tables; tables of plain values below a key go on one line."""
    below = {
        name: value for name, value in table.items() if isinstance(value, dict) and _is_section(path, value)
    }
    own = {name: value for name, value in table.items() if name not in below}
    if own:
        if path:
            yield f"[{'.'.join(path)}]"
        yield from (f"{name} = {_scalar(value)}" for name, value in own.items())
        yield ""
    for name, value in below.items():
        yield from _lines(value, (*path, name))


def _is_section(path: tuple[str, ...], value: dict[str, Any]) -> bool:
    return not path or path[0] in ("materials", "surface")
