"""Errors of a joint file in the user's words: the key, the value, what is allowed."""

from __future__ import annotations

import types
from collections.abc import Iterable, Iterator
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from asperity.joint_file.key import Key
from asperity.joint_file.model import ONE_FOR_ALL, ONE_FOR_EACH, Case

MOST_ERRORS = 12
LONGEST_VALUE = 60


def nearest(name: str, known: Iterable[str]) -> str:
    """``"; did you mean 'x'?"`` for the known name most like the given one, or nothing.

    Parameters
    ----------
    name : str
        What was written.
    known : iterable of str
        What could have been meant.

    Returns
    -------
    str
        The hint.
    """
    import difflib

    close = difflib.get_close_matches(name, list(known), n=3, cutoff=0.5)
    close.sort(
        key=lambda other: sorted(other) != sorted(name)
    )  # letters in the wrong order are the likeliest slip
    return f"; did you mean '{close[0]}'?" if close else ""


def _variants(annotation: Any) -> Iterator[Any]:
    """An annotation without its wrappers: the members of unions, the values of dictionaries."""
    origin = get_origin(annotation)
    if origin is Annotated:
        yield from _variants(get_args(annotation)[0])
    elif origin in (Union, types.UnionType):
        for member in get_args(annotation):
            yield from _variants(member)
    else:
        yield annotation


def _models(annotation: Any) -> list[type[BaseModel]]:
    return [v for v in _variants(annotation) if isinstance(v, type) and issubclass(v, BaseModel)]


def keys_by_path(model: type[BaseModel] = Case) -> dict[str, Key]:
    """Every numeric key of a joint file, with ``*`` for the name of a material.

    Parameters
    ----------
    model : type
        The section to look at.

    Returns
    -------
    dict
        Dotted path → what the key measures and its range.
    """
    found: dict[str, Key] = {}
    for name, field in model.model_fields.items():
        found.update(_keys_of(name, field.annotation, tuple(field.metadata)))
    return found


def _keys_of(path: str, annotation: Any, metadata: tuple[Any, ...]) -> dict[str, Key]:
    stated = [note for note in metadata if isinstance(note, Key)]
    found = {path: stated[0]} if stated else {}
    origin = get_origin(annotation)
    if origin is Annotated:
        inner, *notes = get_args(annotation)
        found.update(_keys_of(path, inner, tuple(notes)))
    elif origin in (Union, types.UnionType):
        for member in get_args(annotation):
            found.update(_keys_of(path, member, ()))
    elif origin is dict:
        found.update(_keys_of(f"{path}.*", get_args(annotation)[1], ()))
    elif isinstance(annotation, type) and issubclass(annotation, BaseModel):
        found.update({f"{path}.{below}": key for below, key in keys_by_path(annotation).items()})
    return found


def _known_names(path: tuple[str, ...]) -> list[str]:
    """Names that a table at this path may contain."""
    models: list[type[BaseModel]] = [Case]
    for part in path:
        annotations = [model.model_fields[part].annotation for model in models if part in model.model_fields]
        below = [v for annotation in annotations for v in _variants(annotation)]
        models = [m for v in below for m in _models(get_args(v)[1] if get_origin(v) is dict else v)]
        if any(get_origin(v) is dict for v in below):
            return _names_below(models) if len(path) > 1 else []
    return _names_below(models)


def _names_below(models: list[type[BaseModel]]) -> list[str]:
    return list(dict.fromkeys(name for model in models for name in model.model_fields))


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= LONGEST_VALUE else f"{text[:LONGEST_VALUE]}…"


def _sentence(error: ErrorDetails) -> str:
    """One error of pydantic as 'key: what is wrong'."""
    parts = tuple(str(part) for part in error["loc"] if part not in (ONE_FOR_ALL, ONE_FOR_EACH, "[key]"))
    path = ".".join(parts)
    kind, value, context = error["type"], error["input"], error.get("ctx", {})
    if kind == "extra_forbidden":
        known = _known_names(parts[:-1])
        hint = nearest(parts[-1], known)
        return f"{path}: unknown key{hint or '; known here are ' + ', '.join(known)}"
    if kind == "missing":
        return f"{path}: this key is missing{_wanted(parts)}"
    if kind in ("model_type", "model_attributes_type", "dict_type"):
        return f"{path}: expected a table with {', '.join(_known_names(parts)) or 'entries'}, got {_shown(value)}"
    if kind == "literal_error":
        allowed = context["expected"]
        return f"{path}: {_shown(value)} is not one of {allowed}"
    if kind == "string_pattern_mismatch":
        return f"{path}: a material's name is made of letters, digits, '-' and '_', got {_shown(value)}"
    if kind == "value_error":
        told = str(context["error"])
        return f"{path}: {told}" if path else told
    return f"{path}: {error['msg']}, got {_shown(value)}"


def _wanted(parts: tuple[str, ...]) -> str:
    generic = ".".join("*" if i == 1 and parts[0] == "materials" else part for i, part in enumerate(parts))
    key = keys_by_path().get(generic)
    return f": {key.dimension.label}, e.g. '{key.dimension.example}'" if key else ""


def explain(error: ValidationError) -> str:
    """All errors of a file, the first dozen of them in full.

    Parameters
    ----------
    error : ValidationError
        What pydantic found.

    Returns
    -------
    str
        One sentence, or a list of them.
    """
    sentences = [_sentence(each) for each in error.errors(include_url=False)]
    if len(sentences) == 1:
        return sentences[0]
    more = len(sentences) - MOST_ERRORS
    listed = "".join(f"\n  {sentence}" for sentence in sentences[:MOST_ERRORS])
    return f"{len(sentences)} errors{listed}" + (f"\n  and {more} more" if more > 0 else "")
