"""Dotted paths of the numbers of a joint file, from the annotations of its sections."""

from __future__ import annotations

import functools
import types
from collections.abc import Iterator
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel

from asperity.joint_file.quantity_key import Entered, Key


def variants(annotation: Any) -> Iterator[Any]:
    """An annotation without its wrappers."""
    origin = get_origin(annotation)
    if origin is Annotated:
        yield from variants(get_args(annotation)[0])
    elif origin in (Union, types.UnionType):
        for member in get_args(annotation):
            yield from variants(member)
    else:
        yield annotation


def models_of(annotation: Any) -> list[type[BaseModel]]:
    """Models of the sections that the annotation of a field allows.

    a section, or a union, dictionary or list of them.
    """
    entries = [entry for variant in variants(annotation) for entry in variants(_entry_of(variant))]
    return [v for v in entries if isinstance(v, type) and issubclass(v, BaseModel)]


def _entry_of(annotation: Any) -> Any:
    """What one entry of a dictionary or a list is; anything else is itself."""
    place = {dict: 1, tuple: 0}.get(get_origin(annotation))
    return annotation if place is None else get_args(annotation)[place]


@functools.cache
def keys_by_path(
    model: type[BaseModel], *, numbers: Literal["varied", "entered", "all"] = "varied"
) -> dict[str, Key]:
    """Every key of a joint file in which a number stands, with ``*`` for the name of a material.

    Dotted path → what the key measures and its range, in the order of the file's sections. ``numbers``: those that
    studies vary, those that they do not, such as an Rz or the share of a load, or all.
    """
    return {
        path: note.key if isinstance(note, Entered) else note
        for path, note in _notes(model).items()
        if numbers == "all" or (numbers == "entered") == isinstance(note, Entered)
    }


def _notes(model: type[BaseModel]) -> dict[str, Key | Entered]:
    notes_by_path: dict[str, Key | Entered] = {}
    for name, field in model.model_fields.items():
        notes_by_path.update(_notes_of(name, field.annotation, tuple(field.metadata)))
    return notes_by_path


def _notes_of(path: str, annotation: Any, metadata: tuple[Any, ...]) -> dict[str, Key | Entered]:
    stated = [note for note in metadata if isinstance(note, Key | Entered)]
    notes_by_path: dict[str, Key | Entered] = {path: stated[0]} if stated else {}
    origin = get_origin(annotation)
    if origin is Annotated:
        inner, *notes = get_args(annotation)
        notes_by_path.update(_notes_of(path, inner, tuple(notes)))
    elif origin in (Union, types.UnionType):
        for member in get_args(annotation):
            notes_by_path.update(_notes_of(path, member, ()))
    elif origin is tuple:
        notes_by_path.update(_notes_of(f"{path}.*", get_args(annotation)[0], ()))
    elif origin is dict:
        notes_by_path.update(_notes_of(f"{path}.*", get_args(annotation)[1], ()))
    elif isinstance(annotation, type) and issubclass(annotation, BaseModel):
        notes_by_path.update({f"{path}.{below}": key for below, key in _notes(annotation).items()})
    return notes_by_path
