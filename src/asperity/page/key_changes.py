"""Changes of single keys of a joint file on the page: numbers, words, and keys that are left out."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from asperity.errors import InputError
from asperity.joint_file.case_types import CASES, DefaultCase
from asperity.joint_file.choices import FINISH, choices_of
from asperity.joint_file.edited_text import entered_key_at, leave_out, set_texts, set_words
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import type_of
from asperity.joint_file.section import models_of
from asperity.joint_file.si_tables import key_at
from asperity.page.list_changes import word_in_list

#: What a file need not state beside the finish of all surfaces.
_GIVEN_BY_FINISH = ("surface.fractal_dimension", "surface.frequency_ratio")


def model_of(tables: Mapping[str, Any]) -> type[Case]:
    """Model of a joint file; that of the paper's drive where its type is none."""
    kind = type_of(tables)
    return CASES.get(kind, DefaultCase)


def apply_changes(tables: Any, changes: Mapping[str, Any]) -> None:
    """Set dotted paths of a joint file to new values, in its tables or in its document; empty ones are left out.

    An ``InputError`` is raised where a path is none of this file.
    """
    try:
        kind, model = type_of(tables), model_of(tables)
        choices = choices_of(model, tables.get("bodies", {}))
        words = {path: str(value) for path, value in changes.items() if path in choices or word_in_list(path)}
        numbers = {path: value for path, value in changes.items() if path not in words}
        empty = [path for path, value in numbers.items() if value == "" and _may_be_absent(path, model, kind)]
        for path in empty:
            for absent in (path, *_surface_paths(tables, path)):
                leave_out(tables, absent)
            del numbers[path]
        set_words(tables, {path: words.pop(path) for path in [*words] if word_in_list(path)})
        set_texts(tables, numbers)
        if FINISH in words and _surface_paths(tables, FINISH):
            _set_finishes(tables, words.pop(FINISH))
        set_words(tables, words)
        for section in {
            path.split(".")[0] for path in (*empty, *(path for path in words if not words[path]))
        }:
            if not model.model_fields[section].is_required() and not tables.get(section, True):
                del tables[section]  # all its fields were emptied
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError("the changes do not fit the sections of this joint file") from None


def _surface_paths(tables: Any, path: str) -> list[str]:
    """A path of the surface of all contacts in the surfaces of a file that states one for each; else none."""
    section, *rest = path.split(".")
    surface = tables.get("surface", {})
    named = [name for name in surface if isinstance(surface[name], Mapping)]
    return [f"surface.{name}.{rest[0]}" for name in named] if section == "surface" and len(rest) == 1 else []


def _set_finishes(tables: Any, word: str) -> None:
    for path in _surface_paths(tables, FINISH):
        if word:
            tables["surface"][path.split(".")[1]]["finish"] = word
        else:
            leave_out(tables, path)


def _may_be_absent(path: str, model: type[Case], kind: str) -> bool:
    """Whether a number of the joint file, or its section, is optional, or given by a finish."""
    if entered_key_at(path, kind) is None:
        key_at(path, kind)
    if path in _GIVEN_BY_FINISH or path.startswith("branch."):
        return True
    section, *_, name = path.split(".")
    if not model.model_fields[section].is_required():
        return True
    models = models_of(model.model_fields[section].annotation)
    return any(name in model.model_fields and not model.model_fields[name].is_required() for model in models)
