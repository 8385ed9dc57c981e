"""What the page asks about: a joint file as text or as tables, with some of its values changed."""

from __future__ import annotations

import copy
import hashlib
import json
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import tomlkit

from asperity.errors import InputError, one_line, quoted
from asperity.joint_file.edited_text import with_measurement
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.measured_surface import case_with_surface
from asperity.joint_file.model import Case
from asperity.joint_file.reader import case_from_tables
from asperity.page.key_changes import apply_changes, model_of
from asperity.page.list_changes import MOST_LOADS, arrange, places_of_lists, rearranged_text, without_lists
from asperity.page.requests import LONGEST_NAME, Request, checked
from asperity.reading import check_depth, parse_toml
from asperity.surface.measured_roughness import measurement_of, roughness_from_document, two_bodies
from asperity.types import Document

#: Name of the file of a measured surface beside a joint file that the page writes.
MEASUREMENT_FILE = "measured_surface.json"


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
    _made: Document = field(default_factory=dict, init=False, repr=False, compare=False)

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
            places = places_of_lists(tables, self.changes, model_of(tables))
            arrange(tables, places)
            apply_changes(tables, without_lists(self.changes, places))
        except InputError as error:
            raise InputError(f"{self.name}: {error}") from None
        loads = tables.get("duty")
        if isinstance(loads, list) and len(loads) > MOST_LOADS:
            raise InputError(
                f"{self.name}: the page takes at most {MOST_LOADS} loads in [[duty]], got {len(loads)}"
            )
        return case_from_tables(tables, source=self.name)

    @property
    def file_tables(self) -> Document:
        """The tables of the file without the changes, which nobody may change."""
        return self._once("file_tables", self._parsed)

    def _parsed(self) -> Document:
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
        places = places_of_lists(self.file_tables, self.changes, model_of(self.file_tables))
        for name, wanted in places.items():
            text = rearranged_text(text, wanted, name=name)
        document = tomlkit.parse(text)
        apply_changes(document, without_lists(self.changes, places))
        return tomlkit.dumps(document)


def refuse_named_files(tables: Mapping[str, Any], *, source: str) -> None:
    """Refuse a joint file that names another file: nothing that arrives by the network may open one."""
    materials = tables.get("materials")
    for name, entry in materials.items() if isinstance(materials, Mapping) else ():
        if isinstance(entry, Mapping) and "file" in entry:
            raise InputError(
                f"{source}: materials.{name}.file: the page opens no other files; write the numbers of the material "
                "into the joint file, or start 'asperity serve' with it"
            )
    _refuse_curve_files(tables, source=source)


def _refuse_curve_files(tables: Mapping[str, Any], *, source: str) -> None:
    """Refuse curves of traction that stand in other files."""
    oils = tables.get("fluids")
    for name, oil in oils.items() if isinstance(oils, Mapping) else ():
        curves = oil.get("traction_curve") if isinstance(oil, Mapping) else None
        if isinstance(curves, str) or any(
            isinstance(curve, Mapping) and "file" in curve
            for curve in (curves if isinstance(curves, list) else ())
        ):
            raise InputError(
                f"{source}: fluids.{name}.traction_curve: the page opens no other files; write the points of the curve "
                "into the joint file, or start 'asperity serve' with it"
            )


def shown_name(name: str) -> str:
    """The name of a joint file as messages and documents show it."""
    return one_line(name)[:LONGEST_NAME] or "joint.toml"


def attachment(name: str, end: str) -> str:
    """Header by which a browser keeps an answer about a joint file of this name as a file with another end."""
    stem = re.sub(r"[^A-Za-z0-9._-]", "_", name.removesuffix(".toml")) or "joint"
    return f'attachment; filename="{stem}{end}"'


def joint_request(body: object) -> JointRequest:
    """The joint that the JSON body of a request asks about; an ``InputError`` where the body is none of its model."""
    return asked_joint(checked(Request, body))


def asked_joint(request: Request) -> JointRequest:
    """The joint of a checked request."""
    for tree in (request.joint, *request.surfaces):
        check_depth(tree, request.name)
    return JointRequest(
        name=shown_name(request.name),
        text=request.toml,
        changes=request.changes,
        tables=request.joint,
        surfaces=tuple(request.surfaces),
    )
