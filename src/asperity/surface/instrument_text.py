"""Text files of instruments whose numbers mean something only with their headings: Wyko and Zygo."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np

from asperity.errors import InputError
from asperity.surface.topography import Topography
from asperity.text_table.text_table import text_table

_WYKO = re.compile(r"\s*Wyko ASCII Data File Format\s+\d+\s+(?P<real>\d+)")
_ZYGO_GRID = re.compile(r"\s*Zygo XYZ Data File")
_ZYGO_COUNTS = re.compile(r"\s*Zygo ASCII Data File")
#: Lines of a file in which its headings stand.
_HEAD = 40
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


def is_instrument_text(text: str) -> bool:
    """Whether a text begins as one of these files does."""
    return any(pattern.match(text) for pattern in (_WYKO, _ZYGO_GRID, _ZYGO_COUNTS))


def instrument_text_topography(text: str, *, path: Path) -> Topography:
    """The map of such a text, in metres.

    An ``InputError`` if a heading is missing or a row is none, or heights are wrapped, ten to a line.

    References
    ----------
    Headings as two public readers of each take them, which agree: SurfaceTopography and pydatalab for Wyko (a line
    for each column of the map; waves unless the second flag says that they are nm), two readers of MetroPro's XYZ
    (places count pixels of the camera's resolution, the eighth line's seventh number [m]; heights in um).
    """
    wyko = _WYKO.match(text)
    if wyko is not None:
        return _wyko(text, path, in_nm=int(wyko["real"]) != 0)
    if _ZYGO_COUNTS.match(text):
        raise InputError(
            f"{path.name} is a Zygo ASCII file: counts of the phase, ten heights a line; export it as .dat, .datx or "
            "XYZ"
        )
    return _zygo(text, path)


def _wyko(text: str, path: Path, *, in_nm: bool) -> Topography:
    """The block of heights, whose lines are the columns of the map."""
    lines = re.split(r"\r\n|\n|\r", text)
    begins = next((i for i, line in enumerate(lines[:_HEAD]) if re.match(r"\s*(RAW_DATA|OPD)\b", line)), None)
    head = "\n".join(lines[: begins or 0])
    values = dict(re.findall(rf"^\s*(\w[\w ]*?)\s+(?:\d+\s+\d+\s+)?({_NUMBER})\s*$", head, re.MULTILINE))
    try:
        columns, rows = int(values["X Size"]), int(values["Y Size"])
        pixel = 1e-3 * float(values["Pixel_size"])
        aspect = float(values.get("Aspect", "1"))
        metres = 1e-9 if in_nm else 1e-9 * float(values["Wavelength"]) / float(values.get("Mult", "1"))
    except (KeyError, ValueError, ZeroDivisionError) as error:
        raise InputError(
            f"{path.name} is a Wyko ASCII file without {error} above its block RAW_DATA; export it again"
        ) from None
    if begins is None or not all(0.0 < size < math.inf for size in (pixel, aspect, metres)):
        raise InputError(
            f"{path.name} is a Wyko ASCII file without a block RAW_DATA, or a size is not positive"
        )
    block = "\n" * (begins + 1) + "\n".join(lines[begins + 1 : begins + 1 + columns])
    table = text_table(block, source=path.name, decimal="point")
    if table.values.shape != (columns, rows):
        raise InputError(
            f"{path.name} speaks of {columns} by {rows} points, its block of heights has {table.row_words}: it is cut "
            "off"
        )
    notes = ("heights of a Wyko ASCII file in " + ("nm" if in_nm else "waves"),)
    heights = np.ascontiguousarray(table.values.T) * metres
    return Topography(heights, pixel * aspect, pixel, source=path.name, notes=notes)


def _zygo(text: str, path: Path) -> Topography:
    """Heights in um at places that count the pixels of the camera."""
    lines = re.split(r"\r\n|\n|\r", text)
    begins = next((i for i, line in enumerate(lines[:_HEAD]) if line.strip() == "#"), 13)
    try:
        pixel = float(lines[7].split()[6])
    except (IndexError, ValueError):
        pixel = math.nan
    if not 0.0 < pixel < math.inf:
        raise InputError(
            f"{path.name} is a Zygo XYZ file without the resolution of its camera, the seventh number of line 8; "
            "export it as .dat or .datx"
        )
    table = text_table(
        "\n" * (begins + 1) + "\n".join(lines[begins + 1 :]), source=path.name, decimal="point"
    )
    x, y = (table.values[:, j] for j in (0, 1))
    whole = (
        np.isfinite(x).all()
        and np.isfinite(y).all()
        and np.all(x == np.round(x))
        and np.all(y == np.round(y))
    )
    if table.width != 3 or not whole:
        raise InputError(f"{path.name} is a Zygo XYZ file whose rows are not two whole numbers and a height")
    column, row = (x - x.min()).astype(int), (y - y.min()).astype(int)
    heights = np.full((row.max() + 1, column.max() + 1), np.nan)
    heights[row, column] = 1e-6 * table.values[:, 2]
    return Topography(heights, pixel, pixel, source=path.name, notes=("a Zygo XYZ file: pixels and um",))
