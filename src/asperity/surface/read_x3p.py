"""X3P containers: what their description must say before they are read, and the form that the reader wants."""

from __future__ import annotations

import io
import math
import re
import zipfile
from pathlib import Path
from xml.etree import ElementTree

from asperity.errors import InputError
from asperity.surface.input_file import MEBIBYTE

#: Largest content of a container, uncompressed, and of its description [bytes].
LARGEST_CONTENT = 4096 * MEBIBYTE
LARGEST_DESCRIPTION = 64 * MEBIBYTE


def is_x3p(path: Path) -> bool:
    """Whether a file is a zip container with a ``main.xml``."""
    if not zipfile.is_zipfile(path):
        return False
    try:
        with zipfile.ZipFile(path) as archive:
            return len(_descriptions(archive)) == 1
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError):
        return False


def x3p_container(path: Path) -> tuple[str | io.BytesIO, tuple[float, float]]:
    """The container as the reader wants it, and its size along x and y [m], points times increment.

    A copy has the entries on top, is without clutter, and empty offsets are written as zero.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            names = _entries(archive)
            main = _descriptions(archive)[0]
            if sum(archive.getinfo(n).file_size for n in names) > LARGEST_CONTENT:
                raise InputError(
                    f"{path.name}: its content is larger than {LARGEST_CONTENT / MEBIBYTE:g} MiB"
                )
            if archive.getinfo(main).file_size > LARGEST_DESCRIPTION:
                raise InputError(
                    f"{path.name}: its main.xml is larger than {LARGEST_DESCRIPTION / MEBIBYTE:g} MiB"
                )
            description = archive.read(main)
            size = _size(description, path.name)
            repaired = re.sub(rb"<Offset\s*/>|<Offset>\s*</Offset>", b"<Offset>0.0</Offset>", description)
            folder = main[: -len("main.xml")]
            if not folder and repaired == description:
                return str(path), size
            rebuilt = io.BytesIO()
            with zipfile.ZipFile(rebuilt, "w") as copy:
                for name in (n for n in names if n.startswith(folder)):
                    copy.writestr(name[len(folder) :], repaired if name == main else archive.read(name))
    except InputError:
        raise
    except Exception as error:  # damaged containers fail in many ways
        raise InputError(f"{path.name} (X3P): the container is damaged ({type(error).__name__})") from None
    rebuilt.seek(0)
    return rebuilt, size


def _entries(archive: zipfile.ZipFile) -> list[str]:
    return [
        n for n in archive.namelist() if not n.startswith("__MACOSX/") and not n.endswith((".DS_Store", "/"))
    ]


def _descriptions(archive: zipfile.ZipFile) -> list[str]:
    return [n for n in _entries(archive) if n.rsplit("/", 1)[-1] == "main.xml"]


def _size(description: bytes, source: str) -> tuple[float, float]:
    """Size along x and y [m] from main.xml."""
    try:
        root = ElementTree.fromstring(description)
    except (ElementTree.ParseError, ValueError, LookupError):
        raise InputError(f"{source} (X3P): its main.xml is not valid XML") from None

    def text(place: str) -> str:
        found = root.find(place)
        return "" if found is None or found.text is None else found.text.strip()

    if root.find("Record3/DataList") is not None:
        raise InputError(
            f"{source} (X3P) holds its heights as text inside main.xml (DataList); only X3P with binary data "
            "is read: export it again with binary data"
        )
    kind = text("Record1/FeatureType")
    if kind != "SUR":
        raise InputError(
            f"{source} (X3P) is of the feature type '{kind}'; only equally spaced surfaces (SUR) are read: "
            "export it as text"
        )
    sizes = []
    for axis in "XY":
        count, increment = (
            text(f"Record3/MatrixDimension/Size{axis}"),
            text(f"Record1/Axes/C{axis}/Increment"),
        )
        try:
            size = int(count) * float(increment)
        except (ValueError, OverflowError):
            size = math.nan
        if not (size > 0.0 and math.isfinite(size)):
            raise InputError(
                f"{source} (X3P): {count or 'no'} points with an increment of {increment or 'no'} m along "
                f"{axis.lower()}; both must be positive"
            )
        sizes.append(size)
    return sizes[0], sizes[1]
