"""Profiles in records of text: ISO 5436-2 (``.smd``), the layout of NPL (``.prf``), and ISO 25178-71 (``.sdf``).

The first two say of each axis its number of points, its unit and scale; then come notes, then one height a line. The
records of ISO 5436-2 end with the control character 3 and its texts with NUL, those of NPL with EOR, those of
ISO 25178-71 with an asterisk.
"""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np

from asperity.errors import InputError
from asperity.surface.file_formats import MEBIBYTE, file_bytes, metres_per_unit
from asperity.surface.topography import Topography
from asperity.text_table.decoding import decoded

#: Larger files are refused [bytes]; a profile of a million points takes some 10 MiB.
LARGEST_RECORDS = 64 * MEBIBYTE
_BEGINNING = re.compile(rb"\s*(ISO 5436|\d+[ \t]+\d+\s*\n[^\n]*\bPRF\b)")
_SDF_PROFILE = re.compile(rb"(?i)\s*a[^\n]{1,9}\n\s*ManufacID\s*=[^*]*\n\s*NumProfiles\s*=\s*1\s*\n")
#: Steps between stated positions differ by less than this share of the mean one.
_EVEN = 1e-3


def in_records(beginning: bytes) -> bool:
    """Whether the first bytes of a file are those of a profile in records."""
    return bool(_BEGINNING.match(beginning) or _SDF_PROFILE.match(beginning))


def record_topography(*, path: Path) -> Topography:
    """The profile of such a file, in metres.

    An ``InputError`` if it lacks an axis, a unit or the spacing, is a map, or has not as many numbers as it says.

    References
    ----------
    ISO 5436-2:2012, the file of reference data of type F1; the files of NPL's softgauges, as `Nmm2Profile` (BEV) writes
    and `surfile` (INRIM) reads them; ISO 25178-71:2017, with the examples of NPL's softgauges and of the NIST Virtual
    Surface Calibration Database, which have their own names in place of ISO-1.0.
    """
    text = decoded(file_bytes(path=path, largest=LARGEST_RECORDS), source=path.name).replace("\0", " ")
    if _SDF_PROFILE.match(text[:4096].encode()):
        return _surface_data(path, text)
    records = re.split(r"\x03|^EOR\s*$", text, maxsplit=3, flags=re.MULTILINE)
    head = [line.split() for record in records[:2] for line in record.splitlines()]
    along, across, up = (
        next((words for words in head if words[:1] == [name]), None) for name in ("CX", "CY", "CZ")
    )
    if across is not None:
        raise InputError(f"{path.name} is a map in records, which is not read; export it as X3P or SDF")
    if along is None or up is None or len(records) < 3:
        raise InputError(f"{path.name} has no axes CX and CZ, or no heights: it is damaged")
    try:
        lateral, vertical = _scale(along), _scale(up)
        stated = next((words[2] for words in head if words[:2] == ["SPACING", "CX"]), along[6:7])
        columns = len(records[2].strip().partition("\n")[0].split())
        numbers = np.array(records[2].split(), dtype=float).reshape(-1, columns)
        count = round(float(up[2]))
        step = float(stated if isinstance(stated, str) else stated[0]) if stated else None
    except (ValueError, IndexError, OverflowError, ZeroDivisionError) as error:
        raise InputError(f"{path.name}: its records cannot be read ({error}): it is damaged") from None
    if len(numbers) != count or columns > 2:
        raise InputError(f"{path.name} speaks of {count} points and has {len(numbers)}: it is damaged")
    if numbers.shape[1] == 2:
        steps = np.diff(numbers[:, 0])
        step = float(np.mean(steps))
        if not np.all(np.abs(steps - step) <= _EVEN * abs(step)):
            raise InputError(f"{path.name}: its points are not evenly spaced, which profiles must be")
    if step is None or not step > 0.0:
        raise InputError(f"{path.name} states no spacing of its points, or none above 0; export it as text")
    return Topography(vertical * numbers[:, -1], lateral * step, source=path.name)


def _scale(axis: list[str]) -> float:
    """Metres in one count of an axis: name, type, points, unit, scale."""
    return _positive(axis[4], axis[0]) * metres_per_unit(axis[3].lower())


def _positive(word: str, name: str) -> float:
    scale = float(word)
    if not (scale > 0.0 and math.isfinite(scale)):
        raise ValueError(f"the scale of {name} is {scale}")
    return scale


def _surface_data(path: Path, text: str) -> Topography:
    """The profile of an SDF file as text; points called BAD are missing."""
    head, body = (text + "**").split("*")[:2]
    stated = dict(re.findall(r"^\s*(\w+)\s*=\s*(\S*)", head.lower(), re.MULTILINE))
    words = body.upper().replace("BAD", "nan").split()
    try:
        count, compression = int(stated["numpoints"]), int(stated["compression"])
        step, scale = (_positive(stated[key], key) for key in ("xscale", "zscale"))
        heights = scale * np.array(words, dtype=float)
    except (KeyError, ValueError) as error:
        raise InputError(f"{path.name}: its records cannot be read ({error}): it is damaged") from None
    if compression:
        raise InputError(f"{path.name}: its heights are compressed, which is not read; export it without")
    if heights.size != count:
        raise InputError(f"{path.name} speaks of {count} points and has {heights.size}: it is damaged")
    return Topography(heights, step, source=path.name)
