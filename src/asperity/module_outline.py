"""The outline of nested results as plain data: which classes, lists and dictionaries hold the numbers, without these.

An outline is read without running code: it names classes that are there already, which hold the numbers and no more.
"""

from __future__ import annotations

import dataclasses
import sys
from typing import Any

import equinox

_PLAIN = (str, int, float, bool, type(None))


def outline(tree: Any) -> Any:
    """Nested results as lists, texts and numbers.

    Parameters
    ----------
    tree : object
        Modules of equinox, named tuples, tuples, lists and dictionaries; anything else is a number.

    Returns
    -------
    object
        For :func:`of_outline`, also after a way through JSON.
    """
    if tree is None:
        return ["none"]
    if isinstance(tree, equinox.Module):
        own = {field.name: field.metadata.get("static", False) for field in dataclasses.fields(tree)}
        parts = [
            [name, "static" if static else "part", (_plain if static else outline)(getattr(tree, name))]
            for name, static in own.items()
        ]
        return ["module", *_named(type(tree)), parts]
    if isinstance(tree, dict):
        return ["dict", [[_plain(name), outline(part)] for name, part in tree.items()]]
    if isinstance(tree, tuple) and hasattr(tree, "_fields"):
        return ["named", *_named(type(tree)), [outline(part) for part in tree]]
    if isinstance(tree, tuple | list):
        return ["tuple" if isinstance(tree, tuple) else "list", [outline(part) for part in tree]]
    return ["number"]


def of_outline(stated: Any) -> Any:
    """Nested results with zeros for their numbers; ValueError for no outline or what is no class of results."""
    match stated:
        case ["none"]:
            return None
        case ["number"]:
            return 0
        case ["tuple", [*parts]]:
            return tuple(of_outline(part) for part in parts)
        case ["list", [*parts]]:
            return [of_outline(part) for part in parts]
        case ["dict", [*parts]]:
            return {_of_plain(name): of_outline(part) for name, part in parts}
        case ["named", str(room), str(name), [*parts]]:
            made = _class(room, name, tuple)
            return made._make(of_outline(part) for part in parts)
        case ["module", str(room), str(name), [*parts]]:
            empty = object.__new__(_class(room, name, equinox.Module))
            for field, kind, part in parts:
                object.__setattr__(empty, field, (_of_plain if kind == "static" else of_outline)(part))
            return empty
    raise ValueError("this is no outline of results")


def _plain(value: Any) -> Any:
    """A value that is no number of the results: a text, or a tuple of texts, also a named one."""
    if isinstance(value, tuple) and hasattr(value, "_fields"):
        return ["named", *_named(type(value)), [_plain(each) for each in value]]
    if type(value) is tuple:
        return ["tuple", [_plain(each) for each in value]]
    if type(value) not in _PLAIN:
        raise ValueError(f"{type(value).__name__} is no plain value")
    return value


def _of_plain(stated: Any) -> Any:
    match stated:
        case ["tuple", [*parts]]:
            return tuple(_of_plain(each) for each in parts)
        case ["named", str(room), str(name), [*parts]]:
            return _class(room, name, tuple)._make(_of_plain(each) for each in parts)
        case str() | int() | float() | None:
            return stated
    raise ValueError("this is no plain value")


def _named(kind: type) -> tuple[str, str]:
    return kind.__module__, kind.__qualname__


def _class(room: str, name: str, above: type) -> Any:
    """A class of a module that is loaded."""
    found = getattr(sys.modules.get(room), name, None)
    if not (isinstance(found, type) and issubclass(found, above)) or _named(found) != (room, name):
        raise ValueError(f"{room}.{name} is no class of results")
    return found
