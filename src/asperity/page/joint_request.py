"""What the page asks about: a joint file as text or as tables, with some of its values changed."""

from __future__ import annotations

import copy
import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import tomlkit

from asperity.errors import InputError, one_line, quoted
from asperity.joint_file.case_types import CASES, WedgeCase
from asperity.joint_file.choices import FINISH, choices_of
from asperity.joint_file.edited_text import entered_key_at, leave_out, set_texts, set_words, with_measurement
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.measured_surface import case_with_surface
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import type_of
from asperity.joint_file.reader import case_from_tables
from asperity.joint_file.section import models_of
from asperity.joint_file.si_tables import key_at
from asperity.page.list_changes import MOST_LOADS, arrange, places_of_lists, rearranged_text, without_lists
from asperity.reading import check_depth, parse_toml
from asperity.surface.measured_roughness import measurement_of, roughness_from_document, two_bodies

#: What a file need not state beside the finish of all surfaces.
_GIVEN_BY_FINISH = ("surface.fractal_dimension", "surface.frequency_ratio")

#: Name of the file of a measured surface beside a joint file that the page writes.
MEASUREMENT_FILE = "measured_surface.json"
MOST_CHANGES = 600
LONGEST_VALUE = 200
LONGEST_NAME = 120


@dataclass(frozen=True)
class JointRequest:
    """One joint, by what messages call it, as TOML or, where that is empty, as the tables of a joint file.

    ``changes``: dotted path → new value as a file states it; ``surfaces``: documents of measurements, of the surface of
    all contacts or of both bodies, which take the place of the surfaces of the file.
    """

    name: str
    text: str
    changes: Mapping[str, Any] = field(default_factory=dict)
    tables: Mapping[str, Any] = field(default_factory=dict)
    surfaces: tuple[Any, ...] = ()
    _made: dict[str, Any] = field(default_factory=dict, init=False, repr=False, compare=False)

    @property
    def identity(self) -> str:
        """A name of the content, the same for the same content; of changes that exclude each other the last holds."""
        changes = list(self.changes.items())
        content = json.dumps([self.name, self.text, changes, self.tables, self.surfaces], sort_keys=True)
        return hashlib.sha256(content.encode("utf-8", "surrogatepass")).hexdigest()[:32]

    def case(self) -> Case:
        """The checked joint file, with the surfaces that it states itself.

        Raises
        ------
        InputError
            If it contains something that is not allowed, has too many loads, or names another file.
        """
        return self._once("case", self._checked)

    def solved_case(self) -> Case:
        """The joint file that is solved: with what its contacts feel of measured surfaces."""
        return self._once("measured", self._with_surfaces) if self.surfaces else self.case()

    def _with_surfaces(self) -> Case:
        try:
            case = self.case()
            measured = [roughness_from_document(document) for document in self.surfaces]
            if len(measured) == 2:
                return case_with_surface(case, two_bodies(*measured))
            stated = case.surface.measurement_of if isinstance(case.surface, SurfaceEntry) else None
            return case_with_surface(case, measurement_of(measured[0], stated))
        except InputError as error:
            raise InputError(f"{self.name}: {error}") from None

    def _checked(self) -> Case:
        tables = copy.deepcopy(self.file_tables)
        refuse_named_files(tables, source=self.name)
        surface = tables.get("surface")
        if not self.surfaces and isinstance(surface, Mapping) and "measurement" in surface:
            raise InputError(
                f"{self.name}: surface.measurement: the page opens no other files; open the measured surface "
                f"{quoted(surface['measurement'])} on the page, too, and put it into the joint"
            )
        try:
            places = places_of_lists(tables, self.changes, _model_of(tables))
            arrange(tables, places)
            _apply(tables, without_lists(self.changes, places))
        except InputError as error:
            raise InputError(f"{self.name}: {error}") from None
        loads = tables.get("duty")
        if isinstance(loads, list) and len(loads) > MOST_LOADS:
            raise InputError(
                f"{self.name}: the page takes at most {MOST_LOADS} loads in [[duty]], got {len(loads)}"
            )
        return case_from_tables(tables, source=self.name)

    @property
    def file_tables(self) -> dict[str, Any]:
        """The tables of the file without the changes, which nobody may change."""
        return self._once("file_tables", self._parsed)

    def _parsed(self) -> dict[str, Any]:
        return dict(self.tables) if self.tables else parse_toml(self.text, source=self.name)

    def _once(self, name: str, make: Callable[[], Any]) -> Any:
        """The result of ``make``, computed once for this request and name."""
        # not by functools.cached_property: in Python 3.11 its lock lets one request wait for the file of another
        if name not in self._made:
            self._made[name] = make()
        return self._made[name]

    def file_text(self) -> str:
        """The joint file that is solved, with the comments and the layout of the original text."""
        measured = self.solved_case().measured
        if measured is None:
            return self.stated_text()
        comment = (
            f"{measured.measured.source}: the file that 'Save measurement' on the page saves, beside this one"
        )
        return with_measurement(self.stated_text(), MEASUREMENT_FILE, comment=comment)

    def measurement_file(self) -> dict[str, bytes]:
        """The file that :meth:`file_text` names, with its name; empty without a measured surface."""
        measured = self.solved_case().measured
        return {} if measured is None else {MEASUREMENT_FILE: measured.text.encode()}

    def stated_text(self) -> str:
        """The file with its changes and the surfaces that it states itself, with its comments and layout."""
        text = self.text or tomlkit.dumps(dict(self.tables))
        places = places_of_lists(self.file_tables, self.changes, _model_of(self.file_tables))
        for name, wanted in places.items():
            text = rearranged_text(text, wanted, name=name)
        document = tomlkit.parse(text)
        _apply(document, without_lists(self.changes, places))
        return tomlkit.dumps(document)


def _model_of(tables: Mapping[str, Any]) -> type[Case]:
    """Model of a joint file; that of the paper's drive where its type is none."""
    kind = type_of(tables)
    return CASES.get(kind, WedgeCase)


def _apply(tables: Any, changes: Mapping[str, Any]) -> None:
    try:
        kind, model = type_of(tables), _model_of(tables)
        choices = choices_of(model, tables.get("bodies", {}))
        numbers = {path: value for path, value in changes.items() if path not in choices}
        empty = [path for path, value in numbers.items() if value == "" and _may_be_absent(path, model, kind)]
        for path in empty:
            for absent in (path, *_surface_paths(tables, path)):
                leave_out(tables, absent)
            del numbers[path]
        set_texts(tables, numbers)
        words = {path: str(value) for path, value in changes.items() if path in choices}
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


def refuse_named_files(tables: Mapping[str, Any], *, source: str) -> None:
    """Refuse a joint file that names another file: nothing that arrives by the network may open one."""
    materials = tables.get("materials")
    for name, entry in materials.items() if isinstance(materials, Mapping) else ():
        if isinstance(entry, Mapping) and "file" in entry:
            raise InputError(
                f"{source}: materials.{name}.file: the page opens no other files; write the numbers of the material "
                "into the joint file, or start 'asperity serve' with it"
            )


def shown_name(name: str) -> str:
    """The name of a joint file as messages and documents show it."""
    return one_line(name)[:LONGEST_NAME] or "joint.toml"


def joint_request(body: Any) -> JointRequest:
    """The joint that the JSON body of a request asks about.

    ``toml`` (text) or ``joint`` (nested tables); optional ``changes`` (dotted path → value), ``surfaces`` (documents of
    measurements) and ``name``. An ``InputError`` is raised if an entry is missing, unknown or of the wrong kind.
    """
    if not isinstance(body, dict):
        raise InputError("the body must be a JSON object with the joint file as 'toml' or 'joint'")
    known = ("toml", "joint", "changes", "surfaces", "name")
    if unknown := sorted(set(body) - set(known)):
        raise InputError(f"unknown entry {quoted(unknown[0])}; known are {', '.join(known)}")
    text, tables = body.get("toml", ""), body.get("joint", {})
    changes, name = body.get("changes", {}), body.get("name", "joint.toml")
    if not isinstance(text, str) or not isinstance(tables, dict) or bool(text.strip()) == bool(tables):
        raise InputError(
            "give the joint either as 'toml', the text of a joint file, or as 'joint', its tables"
        )
    if not isinstance(name, str) or not 0 < len(name) <= LONGEST_NAME:
        raise InputError(f"'name' must be text of at most {LONGEST_NAME} characters")
    if not isinstance(changes, dict) or len(changes) > MOST_CHANGES:
        raise InputError(f"'changes' must be an object of at most {MOST_CHANGES} dotted paths and values")
    for path, value in changes.items():
        if len(path) > LONGEST_VALUE:
            raise InputError(
                f"{quoted(path)}: a path has at most {LONGEST_VALUE} characters, got {len(path)}"
            )
        if isinstance(value, bool) or not isinstance(value, str | int | float):
            raise InputError(f"{path}: a value is text with its unit or a number, got {quoted(value)}")
        if isinstance(value, str) and len(value) > LONGEST_VALUE:
            raise InputError(f"{path}: a value has at most {LONGEST_VALUE} characters, got {len(value)}")
    surfaces = body.get("surfaces", [])
    if not isinstance(surfaces, list) or len(surfaces) > 2:
        raise InputError(
            "'surfaces' must be a list of one measured surface, or of one for each of two bodies"
        )
    for tree in (tables, *surfaces):
        check_depth(tree, name)
    return JointRequest(
        name=shown_name(name), text=text, changes=changes, tables=tables, surfaces=tuple(surfaces)
    )
