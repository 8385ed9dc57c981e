"""Kinds of files that this package makes, and how those that it has made are told from all others.

A file that is there already is replaced only if the package has made it, and as what is to be written now: whatever
else bears its name, or stands behind a link of its name, is somebody's work. What tells is said by the file itself: a
word in its metadata or in its head, or its columns. An empty file is nobody's work.
"""

from __future__ import annotations

import csv
import json
import re
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from asperity.errors import InputError, one_line

#: What stands in the metadata of images and reports.
MARK = "asperity"
#: What stands in the head of every exported file.
WRITTEN_BY = "written by asperity"
#: First words of joint files that a design or a calibration has made.
DESIGNED_BY, CALIBRATED_BY = "Designed by asperity", "Calibrated by asperity"
_IN_IMAGES = (
    b"Software\0asperity",  # PNG
    b"<dc:title>asperity</dc:title>",  # SVG, as its creator
    b"/Creator (asperity)",  # PDF by matplotlib
)
_IN_REPORTS = (b'<meta name="generator" content="asperity">', b"/Keywords(asperity)")  # HTML, PDF by typst
_IN_DXF = re.compile(rb"\$CUSTOMPROPERTY\s+1\s+asperity\s")
#: Bytes at either end of a file that are looked at.
_LOOKED_AT = 1 << 16


@dataclass(frozen=True)
class Kind:
    """A kind of file, by what it is, with its article, and by whether a file is one that this package has made.

    ``made_here`` may raise whatever reading a foreign file leads to.
    """

    what: str
    made_here: Callable[[Path], bool]

    def is_made(self, file: Path) -> bool:
        """Whether a file is there that this package has made as one of this kind."""
        try:
            return self.made_here(file)
        except Exception:  # there is none, or whatever reading a foreign file leads to
            return False

    def refuse_other(self, path: str | Path) -> None:
        """Raise an ``InputError`` if a regular file is there that this package has not made as one of this kind."""
        file = Path(path)
        if not file.is_file() or not file.stat().st_size or self.is_made(file):
            return
        found = (
            f"this is a link to {one_line(str(file.resolve()))}, which"
            if file.is_symlink()
            else "this exists and"
        )
        raise InputError(
            f"{path}: {found} is not {self.what} that asperity has made; give another name, or remove it"
        )


def _ends(file: Path) -> bytes:
    """The bytes at both ends of a file."""
    with file.open("rb") as stream:
        head = stream.read(_LOOKED_AT)
        stream.seek(max(file.stat().st_size - _LOOKED_AT, len(head)))
        return head + stream.read()


def _head(file: Path) -> bytes:
    with file.open("rb") as stream:
        return stream.read(_LOOKED_AT)


def _marked(what: str, marks: tuple[bytes, ...]) -> Kind:
    """Files with one of these marks at one of their ends."""

    def made_here(file: Path) -> bool:
        ends = _ends(file)
        return any(mark in ends for mark in marks)

    return Kind(what, made_here)


def _begins_with_comment(file: Path) -> bool:
    """Whether one of the comments before the first entry of a TOML file names what has made it."""
    for line in _head(file).decode("utf-8", "replace").splitlines():
        if line.startswith((f"# {DESIGNED_BY}", f"# {CALIBRATED_BY}")):
            return True
        if line.strip() and not line.startswith("#"):
            return False
    return False


def _is_fmu(file: Path) -> bool:
    with zipfile.ZipFile(file) as archive:
        return b'generationTool="asperity ' in archive.read("modelDescription.xml")[:_LOOKED_AT]


def _is_document(file: Path) -> bool:
    document = json.loads(file.read_bytes())
    return {"asperity_version", "checks"} <= document.keys()


def refuse_existing(path: str | Path) -> None:
    """Raise an ``InputError`` if a file is there and not empty, as files of heights do not say what has made them."""
    if Path(path).is_file() and Path(path).stat().st_size:
        raise InputError(
            f"{path}: this exists already, and such a file does not say what has made it; give another name, or remove "
            "it"
        )


IMAGE = _marked("an image", _IN_IMAGES)
REPORT = _marked("a report", _IN_REPORTS)
DRAWING = Kind("a drawing", lambda file: bool(_IN_DXF.search(_head(file))))
DOCUMENT = Kind("a document of checks", _is_document)
#: What a design or a calibration has made of a joint file.
MADE_JOINT = Kind("a joint file", _begins_with_comment)
#: Ending → the file of an exported joint.
EXPORTS = {
    **dict.fromkeys(
        (".csv", ".xml", ".mo"), Kind("an export", lambda file: WRITTEN_BY.encode() in _head(file))
    ),
    ".mat": Kind("an export", lambda file: b"MAT-file, asperity " in _head(file)[:116]),
    ".fmu": Kind("an export", _is_fmu),
}


def table_with(what: str, *names: str) -> Kind:
    """A CSV table that has columns of these names among others, whatever their units in brackets."""

    def made_here(file: Path) -> bool:
        return set(names) <= set(header(file))

    return Kind(what, made_here)


def header(file: Path) -> list[str]:
    """Names of the columns of a CSV table, without units in brackets."""
    first = _head(file).decode("utf-8").splitlines()[0]
    (cells,) = csv.reader([first])
    return [cell.partition(" [")[0] for cell in cells]
