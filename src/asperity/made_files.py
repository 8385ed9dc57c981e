"""Kinds of files that this package makes, and how those that it has made are told from all others.

A file that is there already is replaced only if the package has made it, and as what is to be written now: whatever
else bears its name, or stands behind a link of its name, is somebody's work. What tells is said by the file itself, at
the place where the package says it: in the file's own metadata, in its first line, or by all of its columns. A file
that quotes or contains one of the package's is not the package's. An empty file is nobody's work.
"""

from __future__ import annotations

import csv
import json
import re
import struct
import zipfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO
from xml.etree import ElementTree

from asperity.errors import InputError, one_line

#: What stands in the metadata of images and reports.
MARK = "asperity"
#: What stands in the head of every exported file.
WRITTEN_BY = "written by asperity"
#: First words of joint files that a design or a calibration has made.
DESIGNED_BY, CALIBRATED_BY = "Designed by asperity", "Calibrated by asperity"
_PNG, _PNG_MARK = b"\x89PNG\r\n\x1a\n", b"Software\0asperity"
_PDF = b"%PDF-"
_SVG = "{http://www.w3.org/2000/svg}"
#: Place of the creator in the metadata of an SVG file.
_SVG_CREATOR = "/".join(
    (
        "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}RDF",
        "{http://creativecommons.org/ns#}Work",
        "{http://purl.org/dc/elements/1.1/}creator",
        "{http://creativecommons.org/ns#}Agent",
        "{http://purl.org/dc/elements/1.1/}title",
    )
)
#: What the document information of a PDF file says: a figure by matplotlib, a report by typst.
_PDF_FIGURE, _PDF_REPORT = b"/Creator (asperity)", b"/Keywords(asperity)"
#: End of a PDF file that has been written once: the number of the information, and where the table of objects is.
_PDF_END = re.compile(rb"trailer\s*<<[^>]*/Info (\d+) 0 R.*>>\s*startxref\s+(\d+)\s+%%EOF\s*\Z", re.DOTALL)
_PDF_OBJECT = re.compile(rb"\d+ 0 obj\s*<<(.*?)>>\s*endobj", re.DOTALL)
#: Bytes of a line of that table.
_PDF_LINE = 20
_HTML = re.compile(
    rb'<!DOCTYPE html>\s*<html[^<>]*><head>(?:<meta [^<>]*>\s*)*?<meta name="generator" content="asperity">'
)
_IN_DXF = re.compile(rb"\$CUSTOMPROPERTY\s+1\s+asperity\s")
_FMU = re.compile(rb'<fmiModelDescription\b[^<>]*\sgenerationTool="asperity [^"]*"')
#: Bytes at the head or the end of a file that are looked at.
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


def _head(file: Path) -> bytes:
    with file.open("rb") as stream:
        return stream.read(_LOOKED_AT)


def _is_image(file: Path) -> bool:
    """Whether the metadata of a picture itself, not of one that it contains, name what has made it."""
    with file.open("rb") as stream:
        first = stream.read(len(_PNG))
        if first == _PNG:
            return _png_is_marked(stream)
        if first.startswith(_PDF):
            return _PDF_FIGURE in _pdf_information(stream)
        stream.seek(0)
        return _svg_creator(stream) == MARK


def _png_is_marked(stream: BinaryIO) -> bool:
    """Whether a chunk in front of the picture is the mark; the stream is behind the signature."""
    while True:
        length, kind = struct.unpack(">I4s", stream.read(8))
        if kind in (b"IDAT", b"IEND"):
            return False
        content = stream.read(length + 4)[:length]  # its checksum follows
        if kind == b"tEXt" and content == _PNG_MARK:
            return True


def _svg_creator(stream: BinaryIO) -> str | None:
    """The creator that the first element of an SVG file names, if this is its metadata; None otherwise."""
    elements = ElementTree.iterparse(stream, events=("start", "end"))
    wanted = iter((f"{_SVG}svg", f"{_SVG}metadata"))
    metadata: ElementTree.Element | None = None
    for event, element in elements:
        if metadata is not None:
            if event == "end" and element is metadata:
                return metadata.findtext(_SVG_CREATOR)
        elif event == "start":
            expected = next(wanted)
            if element.tag != expected:
                return None
            metadata = element if expected == f"{_SVG}metadata" else None
    return None


def _pdf_information(stream: BinaryIO) -> bytes:
    """The document information to which the end of a PDF file points; an error where there is none such."""
    size = stream.seek(0, 2)
    stream.seek(max(size - _LOOKED_AT, 0))
    end = stream.read()
    found = _PDF_END.match(end, end.rindex(b"trailer"))
    number, table = map(int, found.groups())  # type: ignore[union-attr]
    stream.seek(table)
    first = re.match(rb"xref\s+0 \d+\s*?\n", stream.read(_LOOKED_AT))
    stream.seek(table + first.end() + _PDF_LINE * number)  # type: ignore[union-attr]
    stream.seek(int(stream.read(_PDF_LINE).split()[0]))
    return _PDF_OBJECT.match(stream.read(_LOOKED_AT))[1]  # type: ignore[index]


def _is_report(file: Path) -> bool:
    with file.open("rb") as stream:
        if stream.read(len(_PDF)) == _PDF:
            return _PDF_REPORT in _pdf_information(stream)
    return bool(_HTML.match(_head(file)))


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
        return bool(_FMU.search(archive.read("modelDescription.xml")[:_LOOKED_AT]))


def _begins(first_lines: str, what: str) -> Callable[[Path], bool]:
    """Whether a file begins with these lines, in which ``%s`` is the sentence that says what has been written."""
    sentence = rf"{what} of the joint in [^\n]*, {WRITTEN_BY} \S+\r?\n"
    pattern = re.compile((first_lines % sentence).encode())
    return lambda file: bool(pattern.match(_head(file)))


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


IMAGE = Kind("an image", _is_image)
REPORT = Kind("a report", _is_report)
DRAWING = Kind("a drawing", lambda file: bool(_IN_DXF.search(_head(file))))
DOCUMENT = Kind("a document of checks", _is_document)
#: What a design or a calibration has made of a joint file.
MADE_JOINT = Kind("a joint file", _begins_with_comment)
#: Ending → the file of an exported joint.
EXPORTS = {
    ".csv": Kind("an export", _begins("# %s", "Table")),
    ".xml": Kind("an export", _begins(r"<mujoco model=[^\n]*>\r?\n\s*<!--\r?\n\s*%s", "MuJoCo model")),
    ".mo": Kind("an export", _begins("// %s", "Modelica package")),
    ".mat": Kind("an export", lambda file: _head(file).startswith(b"MATLAB 5.0 MAT-file, asperity ")),
    ".fmu": Kind("an export", _is_fmu),
}


def table_with(what: str, *header: str) -> Kind:
    """A CSV table that has these columns, units included, in this order, and no others."""
    return table_where(what, lambda columns: columns == list(header))


def table_where(what: str, known: Callable[[list[str]], bool]) -> Kind:
    """A CSV table whose columns, units included, are ``known`` as those that this package writes."""

    def made_here(file: Path) -> bool:
        first = _head(file).decode("utf-8", "replace").splitlines()[0]
        (columns,) = csv.reader([first])
        return known(columns)

    return Kind(what, made_here)
