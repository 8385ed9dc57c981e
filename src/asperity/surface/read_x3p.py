"""X3P (ISO 25178-72, ISO 5436-2): maps and profiles in a zip container, heights as binary data or text in main.xml."""

from __future__ import annotations

import math
import zipfile
from array import array
from pathlib import Path
from typing import IO
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.file_formats import MEBIBYTE, descriptions
from asperity.surface.topography import Topography

#: Largest main.xml and most heights that are read [bytes].
LARGEST_DESCRIPTION = 256 * MEBIBYTE
LARGEST_CONTENT = 4096 * MEBIBYTE
# most elements of a main.xml beside its heights
_MOST_ELEMENTS = 100_000
_NUMBER_TYPES = {"I": "<i2", "L": "<i4", "F": "<f4", "D": "<f8"}


def x3p_topography(*, path: Path) -> Topography:
    """Heights [m] of an equally spaced map (SUR) or profile (PRF); points that are marked as invalid are NaN."""
    try:
        with zipfile.ZipFile(path) as archive:
            main = descriptions(archive)[0]
            if archive.getinfo(main).file_size > LARGEST_DESCRIPTION:
                raise InputError(f"its main.xml is larger than {LARGEST_DESCRIPTION / MEBIBYTE:g} MiB")
            with archive.open(main) as stream:
                root, data = _parsed(stream)
            kind = _text(root, "Record1/FeatureType")
            axes = ("X", "Y") if kind == "SUR" else ("X",)
            if kind not in ("SUR", "PRF") or any(
                _text(root, f"Record1/Axes/C{a}/AxisType") == "A" for a in axes
            ):
                raise InputError(
                    f"it is of the feature type '{kind}'; only equally spaced maps (SUR) and profiles (PRF) are read: "
                    "export it as text"
                )
            counts = [_count(root, axis) for axis in "XYZ"]
            spacings = [_spacing(root, axis) for axis in axes]
            if any(count != 1 for count in counts[len(axes) :]):
                raise InputError(
                    f"it has {' x '.join(map(str, counts))} points; only one layer or profile is read"
                )
            points = math.prod(counts)
            if 8 * points > LARGEST_CONTENT:
                raise InputError(
                    f"its main.xml speaks of {points} points; {LARGEST_CONTENT / MEBIBYTE:g} MiB of heights are the "
                    "most that is read"
                )
            if data is None:
                folder = main.removesuffix("main.xml")
                heights = _linked(archive, folder, root, points)
            else:
                heights = np.frombuffer(data, dtype=np.float64)
        if heights.size != points:
            raise InputError(f"it holds {heights.size} heights; its main.xml speaks of {points} points")
        scale, offset = (
            _number(root, f"Record1/Axes/CZ/{n}", d) for n, d in (("Increment", 1.0), ("Offset", 0.0))
        )
        with np.errstate(over="ignore", invalid="ignore"):
            heights = heights * scale + offset
    except InputError as error:
        raise InputError(f"{path.name} (X3P): {error}") from None
    except Exception as error:  # damaged containers fail in many ways
        raise InputError(f"{path.name} (X3P): the container is damaged ({type(error).__name__})") from None
    shape = (counts[1], counts[0]) if kind == "SUR" else (counts[0],)
    return Topography(heights.reshape(shape), spacings[0], [*spacings, None][1], source=path.name)


def _parsed(stream: IO[bytes]) -> tuple[ElementTree.Element, array[float] | None]:
    """The description without its list of heights, and these heights as they are stored; None where there is none."""
    data: array[float] | None = None
    listed: ElementTree.Element | None = None
    root: ElementTree.Element | None = None
    elements = 0
    try:
        for event, element in ElementTree.iterparse(stream, events=("start", "end")):
            root = element if root is None else root
            if element.tag == "DataList" and event == "start":
                listed, data = element, array("d")
            elif element.tag == "Datum" and event == "end" and data is not None and listed is not None:
                data.append(_height(element.text or ""))
                listed.clear()
            elif event == "end":
                elements += 1
                if elements > _MOST_ELEMENTS:
                    raise InputError(
                        f"its main.xml holds more than {_MOST_ELEMENTS} elements beside its heights"
                    )
    except InputError:
        raise
    except (ElementTree.ParseError, ValueError, LookupError):
        raise InputError("its main.xml is not valid XML") from None
    assert root is not None
    return root, data


def _height(text: str) -> float:
    """The last number of a Datum, which may begin with positions; NaN of an empty one, a missing point."""
    value = text.rsplit(";", 1)[-1].strip()
    try:
        return float(value) if value else math.nan
    except ValueError:
        raise InputError(f"'{value[:40]}' in its list of heights is not a number") from None


def _linked(
    archive: zipfile.ZipFile, folder: str, root: ElementTree.Element, points: int
) -> NDArray[np.float64]:
    """Heights as they are stored in the entry that main.xml names, NaN where its flags say so."""
    kind = _text(root, "Record1/Axes/CZ/DataType")
    if kind not in _NUMBER_TYPES:
        raise InputError(
            f"its heights are numbers of the type '{kind}'; known are {', '.join(_NUMBER_TYPES)}"
        )
    dtype = np.dtype(_NUMBER_TYPES[kind])
    stored = np.frombuffer(_entry(archive, folder, root, "PointDataLink", points * dtype.itemsize), dtype)
    heights = stored.astype(np.float64)
    if _text(root, "Record3/DataLink/ValidPointsLink"):
        packed = np.frombuffer(_entry(archive, folder, root, "ValidPointsLink", -(-points // 8)), np.uint8)
        heights[np.unpackbits(packed, bitorder="little")[:points] == 0] = np.nan
    return heights


def _entry(archive: zipfile.ZipFile, folder: str, root: ElementTree.Element, link: str, size: int) -> bytes:
    """The content of an entry of so many bytes that main.xml names."""
    name = _text(root, f"Record3/DataLink/{link}").removeprefix("./").lstrip("/")
    if folder + name not in archive.namelist():
        raise InputError(f"its main.xml names the data '{name}', which are not in the container")
    held = archive.getinfo(folder + name).file_size
    if held != size:
        raise InputError(f"{name} holds {held} bytes; by its main.xml it has {size}")
    return archive.read(folder + name)


def _text(root: ElementTree.Element, place: str) -> str:
    return (root.findtext(place) or "").strip()


def _number(root: ElementTree.Element, place: str, default: float) -> float:
    text = _text(root, place)
    try:
        return float(text) if text else default
    except ValueError:
        raise InputError(
            f"{place.rsplit('/', 1)[-1]} in its main.xml is '{text[:40]}', not a number"
        ) from None


def _count(root: ElementTree.Element, axis: str) -> int:
    text = _text(root, f"Record3/MatrixDimension/Size{axis}")
    if not text.isdecimal() or int(text) == 0:
        raise InputError(f"{text[:40] or 'no'} points along {axis.lower()}; there must be one or more")
    return int(text)


def _spacing(root: ElementTree.Element, axis: str) -> float:
    spacing = _number(root, f"Record1/Axes/C{axis}/Increment", math.nan)
    if not (spacing > 0.0 and math.isfinite(spacing)):
        raise InputError(f"an increment of {spacing:g} m along {axis.lower()}; it must be positive")
    return spacing
