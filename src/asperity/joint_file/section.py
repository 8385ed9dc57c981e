"""What every section of a joint file is, and the dotted paths of its numbers."""

from __future__ import annotations

import ast
import functools
import inspect
import itertools
import types
from collections.abc import Iterator, Mapping
from typing import Annotated, Any, ClassVar, Literal, Self, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, ConfigDict, GetJsonSchemaHandler, PrivateAttr
from pydantic_core import CoreSchema

from asperity.joint_file.quantity_key import Entered, Key
from asperity.types import Document

#: Marks in pydantic's error locations that are no keys of the file.
ONE_FOR_ALL, ONE_FOR_EACH = "<one for all>", "<one for each>"


class Section(BaseModel):
    """A table of the file: frozen, and without room for unknown keys."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    #: Meanings of keys that no docstring states: of a section that is made of data.
    stated_meanings: ClassVar[Mapping[str, str]] = {}

    @classmethod
    def __get_pydantic_json_schema__(cls, core_schema: CoreSchema, handler: GetJsonSchemaHandler) -> Document:
        """The JSON schema with the meaning of each key, which pydantic does not read."""
        schema = handler(core_schema)
        for name, entry in handler.resolve_ref_schema(schema)["properties"].items():
            said = meaning(cls, name)
            if said:
                entry.setdefault("description", said)
        return schema


def meaning(model: type[BaseModel], name: str) -> str:
    """What a key of a section means, in one line; empty where nothing says it.

    That is the description of its field, where it has one, or the docstring below it. Docstrings are read when they are
    asked for. Pydantic would read all of them whenever a command starts.

    Examples
    --------
    >>> from asperity.joint_file.sections import PlayEntry
    >>> meaning(PlayEntry, "angle")
    'Angle that the output turns freely on passing zero torque, from one side to the other.'
    """
    field = model.model_fields.get(name)
    if field is not None and field.description:
        return field.description
    return next((said[name] for said in map(_meanings, model.__mro__) if name in said), "")


@functools.cache
def _meanings(model: type[Any]) -> dict[str, str]:
    """The docstrings of the keys that a section itself declares."""
    if not issubclass(model, Section) or model.__pydantic_generic_metadata__["args"]:
        return {}
    if "stated_meanings" in vars(model) and model is not Section:
        return dict(model.stated_meanings)
    try:
        (definition,) = ast.parse(inspect.getsource(model)).body
    except OSError:  # it is written nowhere, as the keys that contact laws state
        return {}
    assert isinstance(definition, ast.ClassDef)
    meanings = {}
    for statement, below in itertools.pairwise(definition.body):
        match statement, below:
            case ast.AnnAssign(target=ast.Name(id=name)), ast.Expr(value=ast.Constant(value=str(text))):
                meanings[name] = " ".join(text.split())
    return meanings


_Leaf = TypeVar("_Leaf")


def leaves(
    node: Any, kinds: type[_Leaf] | tuple[type[_Leaf], ...], path: str = ""
) -> Iterator[tuple[str, _Leaf]]:
    """Dotted path and value of everything of some types in and below a section at ``path``, in the order of the file.

    The entries of a list have their numbers from 1 on in their paths.
    """
    if isinstance(node, kinds):
        yield path, node
    elif isinstance(node, tuple):
        yield from leaves({str(index): value for index, value in enumerate(node, start=1)}, kinds, path)
    elif isinstance(node, BaseModel | dict):
        for name, value in node.items() if isinstance(node, dict) else node:
            yield from leaves(value, kinds, f"{path}.{name}" if path else name)


class WholeFile(Section):
    """All tables of a file, and the text that they were read from."""

    _text: str = PrivateAttr(default="")

    @property
    def text(self) -> str:
        """The text of the file with its comments; empty for a case that was not read from one."""
        return self._text

    def with_text(self, text: str) -> Self:
        """A copy of the case, which remembers the TOML that it was read from; empty to forget it."""
        copy = self.model_copy()
        copy._text = text
        return copy

    def __eq__(self, other: object) -> bool:
        """Whether both say the same, in whatever words."""
        return type(other) is type(self) and dict(self) == dict(other)


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


def is_list(annotation: Any) -> bool:
    """Whether a section of a joint file is a list of tables, by its annotation."""
    return annotation is not None and (
        get_origin(annotation) is tuple or any(is_list(part) for part in get_args(annotation))
    )
