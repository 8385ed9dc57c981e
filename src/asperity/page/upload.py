"""Files that a user opens on the page: recognised by content, measured in a process with limited time and memory."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping
from typing import Any, Literal

from asperity.errors import InputError
from asperity.joint_file.reader import parse_case
from asperity.page.answer import stated_values
from asperity.page.child import LONGEST_END, Child, file_name
from asperity.page.computation import Computations
from asperity.page.joint_request import refuse_named_files, shown_name
from asperity.page.requests import MeasurementQuery, checked
from asperity.reading import LARGEST_FILE, parse_toml
from asperity.surface.file_formats import signed_format
from asperity.surface.measured_roughness import roughness_document, roughness_from_document
from asperity.surface.measurement import SCHEMA
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import parse_quantity

#: Largest result document that is recognised as such [byte].
LARGEST_RESULT = 8 * 1024**2

#: Largest file of a surface [byte], and the time in which it must be measured [s].
LARGEST_SURFACE = 64 * 1024**2
LONGEST_MEASUREMENT = 120.0

Kind = Literal["joint", "design", "measurement", "surface"]

#: A line of TOML: the head of a table, or a key with a value.
_TOML_LINE = re.compile(
    rb"^[ \t]*(\[\[?[^\]\n]+\]\]?[ \t]*(#.*)?|[A-Za-z_][\w.\"-]*[ \t]*=[^=].*)\r?$", re.MULTILINE
)

#: A row of a table of numbers.
_ROW = re.compile(rb"^[ \t]*[-+.\d][-+.,;\deE \t]*\r?$", re.MULTILINE)


def recognised(content: bytes, name: str) -> Kind:
    """What a file is, by its content; the ending ``.toml`` is taken at its word."""
    beginning = content[:4096].removeprefix(b"\xef\xbb\xbf")
    text = b"\0" not in beginning
    lines = sum(1 for line in beginning.splitlines() if line.strip())
    if text and not name.lower().endswith(".toml") and 2 * len(_ROW.findall(beginning)) > lines:
        return "surface"  # also below lines such as DX = 1.5
    if name.lower().endswith(".toml") or (
        text and signed_format(beginning) is None and _TOML_LINE.search(beginning)
    ):
        return "design" if re.search(rb"^[ \t]*\[variables[\].]", content, re.MULTILINE) else "joint"
    if text and beginning.lstrip().startswith(b"{"):
        return "measurement"
    return "surface"


def refuse_downloads(content: bytes, name: str) -> None:
    """Say of a result document or a report, as the page itself saves them, what to open in their place."""
    instead = "no joint can be read from it; open the joint file (.toml)"
    beginning = content[:4096].removeprefix(b"\xef\xbb\xbf").lstrip()
    if beginning.startswith(b"{") and b'"asperity_version"' in content and len(content) <= LARGEST_RESULT:
        try:
            document = json.loads(content)
        except (ValueError, RecursionError):
            return
        if document.get("schema") != SCHEMA and "asperity_version" in document:
            kind = (
                "the result document of a joint" if "torsional_stiffness" in document else "a result document"
            )
            raise InputError(f"{shown_name(name)}: this is {kind}: {instead}")
    last = "whose text is in the last section of the report"
    if beginning.startswith(b"%PDF-"):
        raise InputError(
            f"{shown_name(name)}: this is a PDF, such as the report of a joint: {instead}, {last}"
        )
    if beginning[:9].lower() == b"<!doctype" and b"<title>Traction-drive joint: " in beginning:
        raise InputError(f"{shown_name(name)}: this is the report of a joint: {instead}, {last}")


def opened_joint(content: bytes, name: str) -> Document:
    """A joint file with what it states."""
    refuse_downloads(content, name)
    name = shown_name(name)
    text = _text(content, name)
    tables = parse_toml(text, source=name)
    refuse_named_files(tables, source=name)
    return {
        "name": name,
        "toml": text,
        **stated_values(parse_case(text, source=name, measured=False), tables),
    }


def opened_design(content: bytes, name: str) -> Document:
    """The text of a design file; it is checked when the design begins."""
    name = shown_name(name)
    text = _text(content, name)
    parse_toml(text, source=name)
    return {"name": name, "design": text}


def _text(content: bytes, name: str) -> str:
    if len(content) > LARGEST_FILE:
        raise InputError(
            f"{name}: this file has {len(content)} bytes; at most {LARGEST_FILE} bytes are read here"
        )
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"{name}: this is not a text file in UTF-8 (byte {error.start})") from None


class Measurements:
    """Measurements of files, one after the other, which end with the server."""

    def __init__(self) -> None:
        self._waiting = Computations(longest=2.0 * LONGEST_MEASUREMENT)
        self._child: Child | None = None

    async def run(self, content: bytes, name: str, units: Mapping[str, str]) -> Document:
        """Wait for :func:`measured_upload`; also an ``AsperityError`` if too many files wait."""
        return await self._waiting.run(measured_upload, content, name, units, self._begun)

    def _begun(self, child: Child) -> None:
        self._child = child

    def close(self) -> None:
        """End the measurement that runs, whose folder is gone then, and drop those that wait."""
        self._waiting.close()
        if self._child is not None:
            self._child.stop()
        self._waiting.close(longest=LONGEST_END)


def measured_upload(
    content: bytes, name: str, units: Mapping[str, str], begun: Callable[[Child], Any] = lambda child: None
) -> Document:
    """The measurement of the file of an instrument, or one made before, and the ``surface`` that a joint takes of it.

    ``units``: what a :class:`MeasurementQuery` has, as texts, empty if not stated.
    """
    refuse_downloads(content, name)
    stated = checked(MeasurementQuery, {key: value for key, value in units.items() if value})
    options: Document = stated.model_dump(exclude_unset=True)
    if "spacing" in options:
        options["spacing"] = parse_quantity(options["spacing"], Dimension.LENGTH)
    options["document"] = recognised(content, "") == "measurement"
    safe = file_name(name, otherwise="surface")
    child = Child("measure", {safe: content}, options)
    begun(child)
    document = child.run(longest=LONGEST_MEASUREMENT)
    measured = roughness_from_document(document)
    usable = measured.fractal is not None or measured.spectra
    return {"name": safe, "document": document, "surface": roughness_document(measured) if usable else None}
