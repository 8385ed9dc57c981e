"""Instrument formats through the package SurfaceTopography, checked against the header of the file; repairs of X3P."""

from __future__ import annotations

import io
import math
import re
import struct
import zipfile
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.extras import optional_module
from asperity.surface.input_file import MEBIBYTE, metres_per_unit
from asperity.surface.topography import Topography

#: Formats that store no unit: releases of the reader package have assumed um and mm for them.
FORMATS_WITHOUT_UNIT = ("tmd",)
#: Text that begins like this belongs to an instrument format and is not a bare table of numbers.
TEXT_FORMATS = {
    b"aISO-1.0": "SDF (text)",
    b"fileformat = bcr": "BCR",
    b"WSxM file copyright": "WSxM",
    b"[DataSet]": "Nanosurf EZD",
    b"[p3dlin]": "QEP",
    b"fileType": "Molecular Imaging",
    b"\\*File list": "Nanoscope",
    b"<": "XML",
    b"\xef\xbb\xbf<": "XML",
}
_BINARY_FORMATS = {
    b"GWYP": "Gwyddion GWY",
    b"GWYO": "Gwyddion GWY (first version)",
    b"bISO-1.0": "SDF",
    b"DIGITAL SURF": "SUR",
    b"AliconaImaging": "AL3D",
    b"FRTM_GLIDERV": "FRT",
    b"Binary TrueMap": "TMD",
    b"PK\x03\x04": "zip container",
    b"\x89HDF": "HDF5",
}
#: Largest relative difference between sizes of the reader and of the header.
_SIZE_TOLERANCE = 1e-3
#: Largest content of a container, uncompressed, and of its description [bytes].
LARGEST_CONTENT = 4096 * MEBIBYTE
LARGEST_DESCRIPTION = 64 * MEBIBYTE


def text_format(beginning: bytes) -> str | None:
    """Name of the instrument format that the first bytes of a text belong to, or None for a bare table."""
    stripped = beginning.lstrip()
    return next((name for mark, name in TEXT_FORMATS.items() if stripped.startswith(mark)), None)


def instrument_topography(*, path: Path, beginning: bytes, height_unit: str | None) -> Topography:
    """Heights of an instrument file in metres, by its first bytes; a unit for formats that do not store one."""
    name = _format_name(path, beginning)
    if not beginning.strip(b"\0"):
        raise InputError(
            f"{path.name} begins with {len(beginning)} zeros: it is no surface file, or a damaged one"
        )
    if name == "XML":
        raise InputError(
            f"{path.name} is XML, not a table of numbers; of an X3P measurement give the .x3p file itself"
        )
    header: tuple[float, float] | None = None
    source: str | io.BytesIO = str(path)
    if is_x3p(path):
        name, (source, header) = "X3P", x3p_container(path)
    elif name.startswith("SDF"):
        header = _sdf_size(path)
    reader, measured, heights = _opened(path, source, name)
    topography = _in_metres(reader, measured, heights, height_unit, path.name)
    if header is not None:
        for got, stated in zip(topography.size, header, strict=False):
            if not abs(got - stated) <= _SIZE_TOLERANCE * abs(stated):
                raise InputError(
                    f"{path.name}: the reader of {name} files gives a size of {got:.6g} m where the header "
                    f"of the file says {stated:.6g} m; the file is not used"
                )
    return topography


def _format_name(path: Path, beginning: bytes) -> str:
    known = text_format(beginning) or next(
        (name for mark, name in _BINARY_FORMATS.items() if beginning.startswith(mark)), None
    )
    return known or (path.suffix.lstrip(".").upper() or "unknown")


def _opened(path: Path, source: str | io.BytesIO, name: str) -> tuple[Any, Any, NDArray[np.float64]]:
    """Reader, topography and heights in the unit of the file."""
    import logging
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        needs = f"{path.name} ({name}) is neither a table of numbers nor .npy, so it needs"
        SurfaceTopography = optional_module("SurfaceTopography", extra="surface", needs=needs)
    logging.getLogger("SurfaceTopography").setLevel(logging.ERROR)
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        try:
            reader = SurfaceTopography.open_topography(source)
            measured = reader.topography()
            heights = np.ma.filled(np.ma.asarray(measured.heights(), dtype=np.float64), np.nan)
            sizes = measured.physical_sizes
        except Exception as error:  # the readers raise whatever their parsers meet
            if "CannotDetect" in type(error).__name__:
                why = "its format is not known, or this variant of it is not"
            else:
                why = f"this variant is not understood ({_reason(error)})"
            raise InputError(
                f"{path.name} ({name}) cannot be read: {why}; export it as X3P with binary data, or as text"
            ) from None
    if sizes is None or not all(np.isfinite(size) and size > 0.0 for size in sizes):
        raise InputError(f"{path.name} ({name}): its size is {sizes or 'not given'}; it must be positive")
    return reader, measured, heights


def _reason(error: Exception) -> str:
    kind, text = type(error).__name__, " ".join(str(error).split()).rstrip(".")
    return kind if not text or len(text) > 120 else f"{kind}: {text}"


def _in_metres(
    reader: Any, measured: Any, heights: NDArray[np.float64], height_unit: str | None, source: str
) -> Topography:
    unit = None if reader.format() in FORMATS_WITHOUT_UNIT else measured.unit
    if unit is None:
        if height_unit is None:
            raise InputError(
                f"{source} does not name the unit of its lengths and heights; state it: mm, um, nm or m",
                options=["height-unit"],
            )
        unit = height_unit
    elif height_unit is not None and metres_per_unit(height_unit) != metres_per_unit(unit):
        raise InputError(
            f"{source} gives its unit as {unit}, not {height_unit}; do not state a unit",
            options=["height-unit"],
        )
    scale = metres_per_unit(unit)
    channels = len(reader.channels)
    notes = (f"the file has {channels} channels; the default one was read",) if channels > 1 else ()
    with np.errstate(over="ignore", invalid="ignore"):
        heights = heights * scale
    if measured.dim == 2:
        (length_x, length_y), (columns, rows) = measured.physical_sizes, measured.nb_grid_pts
        return Topography(
            np.ascontiguousarray(heights.T),
            float(length_x) * scale / columns,
            float(length_y) * scale / rows,
            source=source,
            notes=notes,
        )
    if not measured.is_uniform:
        raise InputError(f"{source}: positions are not equally spaced; resample the profile first")
    spacing = float(measured.physical_sizes[0]) * scale / heights.shape[0]
    return Topography(np.ascontiguousarray(heights), spacing, source=source, notes=notes)


def _sdf_size(path: Path) -> tuple[float, float] | None:
    """Lengths along x and y from the header of an SDF file [m] (ISO 25178-71)."""
    with path.open("rb") as file:
        head = file.read(4096)
    try:
        if head.startswith(b"b"):
            columns, rows, step_x, step_y = struct.unpack_from("<HHdd", head, 42)
        else:
            lines = (line.split("=", 1) for line in head.decode("latin-1").splitlines() if "=" in line)
            field = {key.strip().lower(): value.strip() for key, value in lines}
            columns, rows = int(field["numpoints"]), int(field["numprofiles"])
            step_x, step_y = float(field["xscale"]), float(field["yscale"])
    except (struct.error, KeyError, ValueError):
        return None  # the reader says what is wrong with it
    return columns * step_x, rows * step_y


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

    A copy has the entries on top, only those that its main.xml names, and empty offsets are written as zero.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            main = _descriptions(archive)[0]
            if archive.getinfo(main).file_size > LARGEST_DESCRIPTION:
                raise InputError(
                    f"{path.name}: its main.xml is larger than {LARGEST_DESCRIPTION / MEBIBYTE:g} MiB"
                )
            description = archive.read(main)
            size, points, links = _described(description, path.name)
            repaired = re.sub(rb"<Offset\s*/>|<Offset>\s*</Offset>", b"<Offset>0.0</Offset>", description)
            folder = main[: -len("main.xml")]
            names = [main, *(name for name in archive.namelist() if name.removeprefix(folder) in links)]
            content, most = sum(archive.getinfo(name).file_size for name in names[1:]), _content(points)
            if content > min(most, LARGEST_CONTENT):
                raise InputError(
                    f"{path.name} (X3P) holds {content / MEBIBYTE:.4g} MiB of heights; its main.xml speaks of "
                    f"{points} points, {most / MEBIBYTE:.4g} MiB, and {LARGEST_CONTENT / MEBIBYTE:g} MiB are the most "
                    "that is read"
                )
            if not folder and repaired == description and set(names) == set(archive.namelist()):
                return str(path), size
            rebuilt = io.BytesIO()
            with zipfile.ZipFile(rebuilt, "w") as copy:
                for name in names:
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


def _content(points: int) -> int:
    """Most bytes of the heights of so many points, of their flags, and of what surrounds them."""
    return 9 * points + MEBIBYTE


def _described(description: bytes, source: str) -> tuple[tuple[float, float], int, set[str]]:
    """Size along x and y [m], number of points, and entries with the data and the checksum, from main.xml."""
    try:
        root = ElementTree.fromstring(description)
    except (ElementTree.ParseError, ValueError, LookupError):
        raise InputError(f"{source} (X3P): its main.xml is not valid XML") from None

    def text(place: str) -> str:
        element = root.find(place)
        return "" if element is None or element.text is None else element.text.strip()

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
    sizes, points = [], 1
    for axis in "XY":
        count, increment = (
            text(f"Record3/MatrixDimension/Size{axis}"),
            text(f"Record1/Axes/C{axis}/Increment"),
        )
        try:
            points, size = points * int(count), int(count) * float(increment)
        except (ValueError, OverflowError):
            size = math.nan
        if not (size > 0.0 and math.isfinite(size)):
            raise InputError(
                f"{source} (X3P): {count or 'no'} points with an increment of {increment or 'no'} m along "
                f"{axis.lower()}; both must be positive"
            )
        sizes.append(size)
    layers = text("Record3/MatrixDimension/SizeZ")
    points *= int(layers) if layers.isdecimal() else 1
    links = {text(f"Record3/DataLink/{link}").lstrip("./") for link in ("PointDataLink", "ValidPointsLink")}
    return (sizes[0], sizes[1]), points, {*links - {""}, text("Record4/ChecksumFile") or "md5checksum.hex"}
