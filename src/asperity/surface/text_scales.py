"""What a text file states of its units, sizes and missing points, held against each other and against the user."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.file_formats import metres_per_unit
from asperity.surface.stated import SAME_SPACING, Stated
from asperity.text_table.entries import Entry
from asperity.text_table.headings import Heading, factor_and_unit, is_counted, is_scale, is_unit
from asperity.text_table.text_table import TextTable
from asperity.unit_table import Dimension
from asperity.units import unit_exponents

What = Literal["position", "height"]

#: Keys of lines, in small letters without signs, by what they state; labels of Gwyddion, SPIP, Nova, Wyko, Mahr,
#: Accretech, ESRI and others. Lengths of what is measured, and of one step of it.
_COLUMNS = ("xpixels", "ncols", "ncolumns", "columns", "nx", "xpoints", "pointsx")
_ROWS = ("ypixels", "nrows", "rows", "ny", "ypoints", "pointsy")
_POINTS = (
    *("points", "numberofpoints", "npoints", "numpoints", "nopoints", "datapoints", "numberofdatapoints"),
    *("samples", "numberofsamples", "pointcount", "datacount", "profilepoints"),
)
_WIDTHS, _HEIGHTS = ("breite", "largeur"), ("höhe", "hoehe", "hauteur")
_LENGTH = {
    "x": ("xlength", "width", "xrange", "xreal", "sizex", *_WIDTHS),
    "y": ("ylength", "height", "yrange", "yreal", "sizey", *_HEIGHTS),
}
_STEP = {
    "x": (
        *(
            "dx",
            "xspacing",
            "spacing",
            "pixelsize",
            "pointspacing",
            "samplespacing",
            "xstep",
            "step",
            "stepsize",
        ),
        *(
            "xincrement",
            "xinc",
            "deltax",
            "pixelwidth",
            "samplinginterval",
            "sampleinterval",
            "interval",
            "pitch",
        ),
        *(
            "samplingpitch",
            "datapitch",
            "xpitch",
            "pointdistance",
            "cellsize",
            "scalex",
            "samplingstep",
            "spacingx",
        ),
    ),
    "y": (
        "dy",
        "yspacing",
        "ystep",
        "yincrement",
        "yinc",
        "deltay",
        "pixelheight",
        "ypitch",
        "scaley",
        "spacingy",
        *(
            "linespacing",
            "linepitch",
            "linedistance",
            "linestep",
            "profilespacing",
            "trackspacing",
            "rowspacing",
        ),
    ),
}
#: Steps that hold in both directions of a map.
_BOTH_WAYS = ("spacing", "pixelsize", "pointspacing", "cellsize", "stepsize")
_UNITS: dict[str, tuple[str, ...]] = {
    "position": (
        *("xunit", "xunits", "xyunit", "xyunits", "lateralunit", "lateralunits", "unitx", "positionunit"),
        *("unit", "units", "lengthunit"),
    ),
    "height": (
        *("zunit", "zunits", "valueunit", "valueunits", "dataunit", "dataunits", "heightunit", "heightunits"),
        *("unitdata", "unitz", "unit", "units", "lengthunit"),
    ),
}
#: Height of one count.
_COUNT = (
    *(
        "bit2nm",
        "zscale",
        "zscaling",
        "heightscale",
        "scalez",
        "scaledata",
        "zfactor",
        "zincrement",
        "lsb",
        "zlsb",
    ),
    *("heightconversionfactor", "heightpercount", "countheight", "heightscalefactor", "zscalefactor"),
)
#: The same where the heights are whole numbers; otherwise what the instrument resolves.
_RESOLUTION = ("res", "zres", "zresolution", "heightresolution", "verticalresolution")
_NO_DATA = (
    *(
        "nodatavalue",
        "nodata",
        "missingvalue",
        "badvalue",
        "voidvalue",
        "invalidvalue",
        "undefinedvalue",
    ),
    *("fillvalue", "nanvalue"),
)
#: All keys that mean something.
KNOWN_KEYS = frozenset(
    (
        *(*_COLUMNS, *_ROWS, *_POINTS, *_LENGTH["x"], *_LENGTH["y"], *_STEP["x"], *_STEP["y"]),
        *(*_UNITS["position"], *_UNITS["height"], *_COUNT, *_RESOLUTION, *_NO_DATA),
    )
)
#: Units that keys have in their names.
_UNIT_OF_KEY = {"bit2nm": "nm"}

#: Units in which positions may be that state none [m].
_METRES = (1.0, 1e-2, 1e-3, 1e-6, 1e-9, 1e-10, 2.54e-2, 2.54e-5, 2.54e-8, 0.3048)


@dataclass(frozen=True)
class Claim:
    """A length [m] that a file states, the words by which it does, and the length as it is written."""

    metres: float
    words: str
    shown: str


@dataclass(frozen=True)
class Scales:
    """What a table states beside its numbers, and what the user does."""

    table: TextTable
    stated: Stated

    def unit(
        self, what: What, column: int, heading: Heading | None = None, *, whole: bool = False
    ) -> tuple[float, str]:
        """Metres in the unit of a column, and a note of where that stands if not in its heading.

        ``heading``: another one than that above the column; ``whole``: whether its numbers are whole, as counts are.

        An ``InputError`` if neither file nor user state it, they contradict each other, or it is no length.
        """
        by_heading = self._of_heading(what, heading or self.table.headings[column], f"column {column + 1}")
        lines = [self._unit_entry(entry) for entry in self._entries(_UNITS[what])]
        claims = [claim for claim in (by_heading, *lines) if claim is not None]
        if what == "height" and (whole or not claims):
            claims = [*self._counts(whole), *claims]
        length, note = self._decided(what, claims)
        factors = [] if what == "position" else [e for e in self._entries(_COUNT) if self._is_open_factor(e)]
        if factors and self.stated.height_unit is None:
            raise InputError(
                f"{self.table.source}: {factors[0]} may be a factor of the heights, and states no unit; state the "
                "unit, or the length of one count such as '0.05 nm'",
                options=["height-unit"],
            )
        unused = [f"{entry} is not used: the unit of the heights is the stated one" for entry in factors]
        return length, "; ".join(filter(None, (note, *unused)))

    def _is_open_factor(self, entry: Entry) -> bool:
        """Whether a line states a factor of the heights other than 1 without a unit."""
        return (
            entry.number not in (None, 1.0)
            and entry.key not in _UNIT_OF_KEY
            and (not entry.unit or is_counted(entry.unit))
        )

    def _of_heading(self, what: What, heading: Heading, place: str) -> Claim | None:
        """The unit that the heading of a column states."""
        if heading.unit is None:
            return None
        factor, unit = factor_and_unit(heading.unit)
        is_length = unit_exponents(unit) == Dimension.LENGTH.exponents and not is_counted(unit)
        if is_length and is_scale(heading.unit):
            return Claim(factor * metres_per_unit(unit), f"the heading '{heading.text}'", heading.unit)
        if is_unit(heading.unit) and not is_length:
            raise InputError(
                f"{self.table.source}: {place} is headed '{heading.text}': '{unit}' is no length, so these "
                f"are no {what}s; choose the column of the heights",
                options=["column"],
            )
        if self.stated.metres(what) is None:
            raise InputError(
                f"{self.table.source}: the unit in the heading '{heading.text}' of {place} is not "
                "understood; state the unit, or the length of one count such as '0.1 nm'",
                options=[f"{what}-unit"],
            )
        return None

    def _entries(self, keys: Sequence[str]) -> list[Entry]:
        return [entry for entry in self.table.entries if entry.key in keys]

    def _unit_entry(self, entry: Entry) -> Claim | None:
        """The unit that a line such as ``Value units: m`` states."""
        factor, unit = factor_and_unit(entry.text)
        if unit_exponents(unit) == Dimension.LENGTH.exponents:
            return Claim(factor * metres_per_unit(unit), str(entry), entry.text)
        if is_unit(entry.text) and entry.key not in ("unit", "units"):
            raise InputError(
                f"{self.table.source}: {entry} says that the numbers are no lengths; export the heights"
            )
        return None

    def _counts(self, whole: bool) -> list[Claim]:
        """Heights of one count, by lines such as ``Bit2nm = 0.05``."""
        claims = []
        for entry in self._entries((*_COUNT, *(_RESOLUTION if whole else ()))):
            unit = entry.unit or _UNIT_OF_KEY.get(entry.key, "")
            metres = self._length(entry, unit)
            if metres is not None:
                claims.append(_stated_by(entry, metres))
        return claims

    def _length(self, entry: Entry, unit: str) -> float | None:
        """The length that an entry states; None where it has no number above zero or no unit of length."""
        plain, stroke, counted = (part.strip() for part in unit.partition("/"))
        if stroke and (unit_exponents(unit) is not None or not is_counted(counted)):
            plain = unit  # per something that is not counted
        if entry.number is None or not 0.0 < entry.number < math.inf or not plain:
            return None
        if unit_exponents(plain) != Dimension.LENGTH.exponents:
            return None
        return entry.number * metres_per_unit(plain)

    def _decided(self, what: What, claims: Sequence[Claim]) -> tuple[float, str]:
        """The one length of all claims and of what the user states."""
        stated, option, source = self.stated.metres(what), f"{what}-unit", self.table.source
        given = self.stated.position_unit if what == "position" else self.stated.height_unit
        if stated is not None:
            same = [claim for claim in claims if _agree(claim.metres, stated, 1e-6)]
            if claims and not same:
                raise InputError(
                    f"{source}: the unit of its {what}s is {claims[0].shown} by {claims[0].words}, not {given}; do "
                    "not state a unit, or correct the file",
                    options=[option],
                )
            return stated, ""
        if not claims:
            hints = [entry for entry in self._entries((*_COUNT, *_RESOLUTION)) if what == "height"]
            hint = f" ({'; '.join(map(str, hints))} may be the height of one count)" if hints else ""
            raise InputError(
                f"{source} does not name the unit of its {what}s{hint}; state it: mm, um, nm or m",
                options=[option],
            )
        if not all(_agree(claim.metres, claims[0].metres, 1e-6) for claim in claims):
            words = " and ".join(f"{claim.words} ({claim.shown})" for claim in claims)
            raise InputError(
                f"{source} states two units of its {what}s: {words}; state which one holds", options=[option]
            )
        words = claims[0].words
        return claims[0].metres, "" if words.startswith(
            "the heading"
        ) else f"unit of the {what}s from {words}"

    def _knows_positions(self, headings: Iterable[Heading]) -> bool:
        """Whether the unit of positions is stated, by the user, their headings or another line."""
        lines = any(self._unit_entry(entry) is not None for entry in self._entries(_UNITS["position"]))
        return lines or self.stated.position_unit is not None or any(h.unit is not None for h in headings)

    def steps(
        self, columns: Sequence[int], measured: Sequence[float], points: Sequence[int]
    ) -> tuple[tuple[float, ...], str]:
        """Distances of points along one or two columns of positions [m], and a note of where their unit stands.

        ``measured``: distances in the unit of the columns. Without a unit the spacing that the user states is that of
        the first column.
        """
        spacing = self.stated.spacing
        if spacing is not None and not self._knows_positions(self.table.headings[j] for j in columns):
            found, words = self.step("x", points[0], None)
            self._refuse_no_unit(measured[0])
            first = spacing if found is None else found
            said = words or "positions without a unit; the distance of the points is the stated one"
            return tuple(first * (one / measured[0]) for one in measured), said
        lengths, notes = [], []
        for axis, column, one, count in zip(("x", "y"), columns, measured, points, strict=False):
            metres, words = self.unit("position", column)
            length, _ = self.step("x" if axis == "x" else "y", count, one * metres)
            assert length is not None
            lengths.append(length)
            notes.append(words)
        return tuple(lengths), notes[0]

    def _refuse_no_unit(self, step: float) -> None:
        """Raise if positions that advance by a step, in no unit, advance by the stated spacing in none at all."""
        spacing = self.stated.spacing
        assert spacing is not None
        if step != 1.0 and not any(_agree(step * unit, spacing) for unit in _METRES):
            raise InputError(
                f"{self.table.source}: its positions advance by {step:.6g}, which in no unit of length is the stated "
                f"distance of the points, {_shown(spacing)}; state their unit in its place",
                options=["position-unit"],
            )

    def map_steps(
        self, x_step: float | None, y_step: float | None, shape: tuple[int, ...], corner: Heading
    ) -> tuple[tuple[float, float], tuple[str, ...]]:
        """Distances of the points of a map along x and y [m], and notes of where they are stated.

        ``x_step`` and ``y_step``: by its axes in their unit, None without one; ``shape``: rows and columns; ``corner``:
        what stands at the corner of the axes.
        """
        metres = None
        has_axes = x_step is not None or y_step is not None
        if has_axes and (self.stated.spacing is None or self._knows_positions((corner,))):
            claims = [self._of_heading("position", corner, "the corner")]
            claims += [self._unit_entry(entry) for entry in self._entries(_UNITS["position"])]
            metres, _ = self._decided("position", [claim for claim in claims if claim is not None])
        measured = [None if one is None or metres is None else one * metres for one in (x_step, y_step)]
        if has_axes and metres is None and x_step is not None:
            self._refuse_no_unit(x_step)
        along, words = self.step("x", shape[1], measured[0])
        across, more = self.step("y", shape[0], measured[1])
        along = self.stated.spacing if along is None else along
        if along is None:
            raise self.no_spacing()
        equal = ""
        if across is None:
            ratio = self._stated_ratio(shape) if x_step is None or y_step is None else y_step / x_step
            across = along if ratio is None else along * ratio
            equal = "rows and columns taken as equally spaced" if ratio is None else ""
        return (along, across), (equal, words, more)

    def _stated_ratio(self, shape: tuple[int, ...]) -> float | None:
        """Distance of the rows over that of the points in them, by lines of both without a unit; None without them."""
        for keys, points in ((_STEP, (1, 1)), (_LENGTH, (shape[1], shape[0]))):
            along, across = (
                [
                    e.number / count
                    for e in self._entries(keys[axis])
                    if e.number and e.number > 0.0 and not e.unit
                ]
                for axis, count in zip(("x", "y"), points, strict=True)
            )
            if along and across:
                return across[0] / along[0]
        return None

    def unused(self) -> tuple[str, ...]:
        """A note of the stated unit of the positions where a file has none."""
        steps = (*_STEP["x"], *_STEP["y"], *_LENGTH["x"], *_LENGTH["y"])
        used = any(entry.number is not None and not entry.unit for entry in self._entries(steps))
        return ("the stated unit of the positions is not used: the file has none",) * (
            self.stated.position_unit is not None and not used
        )

    def no_spacing(self) -> InputError:
        """That the distance of the points is not known."""
        table = self.table
        return InputError(
            f"{table.source} has {table.width} column(s) of heights and no positions; give the distance of the points, "
            "such as '0.5 um'; in text files of NIST and NPL their first number, in um",
            options=["spacing"],
        )

    def step(self, axis: Literal["x", "y"], points: int, measured: float | None) -> tuple[float | None, str]:
        """Distance of the points along an axis [m], and where it is stated; None where neither file nor user do.

        ``measured``: the distance by the positions of the file [m], None without positions. An ``InputError`` if the
        file contradicts itself or the user.
        """
        claims = [Claim(measured, "the positions", _shown(measured))] if measured is not None else []
        for entry in self._entries(_STEP[axis]):
            metres = self._length_in(entry)
            if metres is not None:
                claims.append(_stated_by(entry, metres))
        if axis == "y" and not claims:
            both = [(self._length_in(entry), entry) for entry in self._entries(_BOTH_WAYS)]
            claims = [_stated_by(entry, metres) for metres, entry in both if metres is not None]
        for entry in self._entries(_LENGTH[axis]):
            named = ("width", "height", *_WIDTHS, *_HEIGHTS)
            length = None if entry.key in named and not entry.unit else self._length_in(entry)
            if length is not None and points > 1:
                near = claims[0].metres if claims else self.stated.spacing if axis == "x" else None
                whole, outer = (
                    length / points,
                    length / (points - 1),
                )  # of all points, or between the outer ones
                is_outer = near is not None and _agree(outer, near) and abs(outer - near) < abs(whole - near)
                claims.append(_stated_by(entry, outer if is_outer else whole))
        return self._agreed(claims, axis)

    def _length_in(self, entry: Entry) -> float | None:
        """The length of an entry, in the unit of the positions where it has none of its own."""
        if entry.unit:
            return self._length(entry, entry.unit)
        if entry.number is None or not 0.0 < entry.number < math.inf:
            return None
        if any(other.key == "bit2nm" for other in self.table.entries):
            return 1e-9 * entry.number  # SPIP states lengths in nanometres
        units = [
            claim for e in self._entries(_UNITS["position"]) if (claim := self._unit_entry(e)) is not None
        ]
        unit = self.stated.metres("position") or (units[0].metres if units else None)
        return None if unit is None else entry.number * unit

    def _agreed(self, claims: Sequence[Claim], axis: str) -> tuple[float | None, str]:
        """The one step of all claims and of the spacing that the user states."""
        stated = self.stated.spacing
        if stated is not None and axis == "x":
            wrong = next((claim for claim in claims if not _agree(claim.metres, stated)), None)
            if wrong is not None:
                raise InputError(
                    f"{self.table.source}: the distance of the points is {_shown(wrong.metres)} by {wrong.words}, not "
                    f"{_shown(stated)}; do not state it, or correct the file",
                    options=["spacing"],
                )
        if not claims:
            return None, ""
        wrong = next((claim for claim in claims if not _agree(claim.metres, claims[0].metres)), None)
        if wrong is not None:
            raise InputError(
                f"{self.table.source} states two distances of its points: {_shown(claims[0].metres)} by "
                f"{claims[0].words}, {_shown(wrong.metres)} by {wrong.words}; correct the file"
            )
        words = claims[0].words
        return claims[0].metres, "" if words == "the positions" else f"distance of the points from {words}"

    def refuse_other_counts(self, rows: int, columns: int) -> None:
        """Raise if the file states another number of points than its table has."""
        checks: list[tuple[Iterable[Entry], tuple[int, ...], str]] = [
            (self._entries(_ROWS), (rows,) if columns > 1 else (1, rows), "rows"),
            (
                self._entries(_COLUMNS),
                (columns,) if columns > 1 else (1, rows, self.table.width),
                "points in a row",
            ),
            (self._entries(_POINTS), (rows * columns, rows, columns), "points"),
        ]
        for stated, right, what in checks:
            for entry in stated:
                counts = (entry.number, *map(float, re.findall(r"^\d+$", re.sub(r"[.,'\s]", "", entry.text))))
                if entry.number is not None and not entry.unit and not set(counts) & set(right):
                    raise InputError(
                        f"{self.table.source}: {entry} speaks of {entry.number:g} {what}, the table has "
                        f"{self.table.row_words}: it is cut off, or heights are wrapped, several to a line; save it "
                        "complete, one row of the map or one point a line"
                    )

    @property
    def _grid_counts(self) -> list[int]:
        """Rows and columns of a map as the file states them; fewer where it does not state both."""
        entries = [self._entries(keys) for keys in (_ROWS, _COLUMNS)]
        return [int(found[0].number) for found in entries if found and found[0].number is not None]

    @property
    def state_a_map(self) -> bool:
        """Whether the file states rows and columns of a map."""
        return len(self._grid_counts) == 2

    def grid_shape(self, points: int) -> tuple[int, int] | None:
        """Rows and columns of a map of so many points, if the file states them; otherwise None."""
        counts = self._grid_counts
        if len(counts) != 2 or min(counts) < 2 or counts[0] * counts[1] != points:
            return None
        return counts[0], counts[1]

    def without_marks(self, heights: NDArray[np.float64]) -> tuple[NDArray[np.float64], tuple[str, ...]]:
        """Heights in the unit of the file without the number that marks missing ones, and a note of how many."""
        marks = [(mark, "as stated") for mark in self.stated.missing_marks()]
        for entry in self._entries(_NO_DATA):
            if entry.number is None or (entry.unit and is_counted(entry.unit)):
                continue  # "5 points"
            unclear = entry.key == "nodata" and entry.number == 0.0 and self.stated.no_data is None
            if unclear and np.any(heights == 0.0):
                raise InputError(
                    f"{self.table.source}: {entry} may count the missing points, or say that 0 marks them; state 0 if "
                    "it does, or none if every number is a height",
                    options=["no-data"],
                )
            marks.append((entry.number, str(entry)))
        notes = []
        for mark, words in dict(marks).items():
            missing = heights == mark
            if missing.any() and not self.stated.all_are_heights:
                heights = np.where(missing, np.nan, heights)
                notes.append(f"{int(missing.sum())} numbers {mark:g} mark missing points ({words})")
        return heights, tuple(notes)


def _stated_by(entry: Entry, metres: float) -> Claim:
    """The length that a line states."""
    return Claim(metres, str(entry), _shown(metres))


def _agree(first: float, second: float, share: float = SAME_SPACING) -> bool:
    return first == second or abs(first - second) <= share * max(abs(first), abs(second))


def _shown(metres: float) -> str:
    """A length in the largest unit in which it is not below one."""
    for unit, size in (("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9)):
        if metres >= 0.99999 * size:
            return f"{metres / size:.6g} {unit}"
    return f"{metres / 1e-9:.6g} nm"
