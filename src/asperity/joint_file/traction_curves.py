"""Measured curves of traction in a joint file: their files, and the films that they are of."""

from __future__ import annotations

import functools
import re
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

from asperity.contact.measured_traction import even_slip_coefficients
from asperity.errors import InputError, quoted
from asperity.reading import read_bytes
from asperity.text_table.decoding import decoded
from asperity.text_table.headings import Heading, factor_and_unit
from asperity.text_table.text_table import text_table
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import parse_quantity

#: Points of a curve: slide-roll ratio and traction coefficient, both positive, the first one rising.
Points = tuple[tuple[float, float], ...]

#: Points that a curve needs, those beyond which a file is averaged, and to how many.
FEWEST, MOST, AVERAGED = 5, 60, 40
#: Surfaces of which one stands slip by twice their mean speed; no oil has more traction than this.
_LARGEST_RATIO, _LARGEST_TRACTION = 2.0, 0.3
_LARGEST_FILE = 50_000_000

_NAMES = {
    "slide-roll ratio": ("srr", "slide roll ratio", "slide to roll ratio", "slip", "creepage", "creep"),
    "traction": (
        "mu",
        "µ",
        "μ",
        "traction",
        "traction coefficient",
        "friction",
        "friction coefficient",
        "cof",
    ),
}


def fill_in_curves(tables: Mapping[str, object], *, folder: Path) -> tuple[Document, dict[str, str]]:
    """The tables of a joint file with the points of the curves whose files it names, and what was refused.

    ``folder`` is that of the joint file; what was refused, by the dotted path of the oil.
    """
    filled: Document = dict(tables)
    refused: dict[str, str] = {}
    sections = filled.get("fluids")
    if not isinstance(sections, dict):
        return filled, refused
    oils = dict(sections)
    for name, oil in sections.items():
        stated = oil.get("traction_curve") if isinstance(oil, dict) else None
        curves = [{"file": stated}] if isinstance(stated, str) else stated
        if not isinstance(curves, list):
            continue
        try:
            oils[name] = oil | {"traction_curve": [_with_points(curve, folder) for curve in curves]}
        except InputError as error:
            refused[f"fluids.{name}"] = f"fluids.{name}.traction_curve: {error}"
    return filled | {"fluids": oils}, refused


def _with_points(curve: object, folder: Path) -> object:
    """The table of a curve with the points of its file."""
    if not isinstance(curve, dict) or not isinstance(curve.get("file"), str) or "points" in curve:
        return curve
    return curve | {"points": [list(point) for point in read_curve(folder / curve["file"])]}


def read_curve(path: Path) -> Points:
    """The points of a file with columns for the slide-roll ratio and the traction coefficient.

    Both directions count alike; of more than 60 rows 40 means over the logarithm of the ratio are left. An
    ``InputError`` if it cannot be read, is stated in per cent without saying so, or has too few rows.
    """
    table = text_table(decoded(read_bytes(path, largest=_LARGEST_FILE), source=str(path)), source=str(path))
    columns = [_column(heading) for heading in table.headings]
    found = {}
    for name, known in _NAMES.items():
        at = [place for place, (column, _) in enumerate(columns) if column in (name, *known)]
        if not at and table.width == 2 and not any(heading.text for heading in table.headings):
            at = [0 if name == "slide-roll ratio" else 1]
        if len(at) != 1:
            words = ", ".join(f"'{heading.text}'" for heading in table.headings)
            raise InputError(
                f"{path}: needs one column for the {name}, e.g. '{known[0]}', and has {words or 'no headings'}"
            )
        found[name] = table.values[:, at[0]] * columns[at[0]][1]
    ratio, traction = found.values()
    whole = np.isfinite(ratio) & np.isfinite(traction) & (ratio != 0.0)
    ratio, traction = np.abs(ratio[whole]), (traction * np.sign(ratio))[whole]
    if traction.size and np.median(traction) < 0.0:  # one sign of the sensor for both
        traction = -traction
    try:
        return checked_points(_averaged(ratio, traction))
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def _column(heading: Heading) -> tuple[str, float]:
    """Name of a column in small letters, and the factor by which its numbers are shares."""
    name = " ".join(re.sub(r"[_\-–]", " ", heading.name or heading.text).lower().split())
    if not heading.unit or heading.unit.strip() in ("-", "1"):
        return name, 1.0
    try:
        factor, unit = factor_and_unit(heading.unit)
        return name, factor * parse_quantity(f"1 {unit}", Dimension.DIMENSIONLESS)
    except InputError:
        return name, 1.0


def _averaged(ratio: np.ndarray, traction: np.ndarray) -> Iterable[tuple[float, float]]:
    """Points in rising order; those of one ratio, or of many of nearly one, are their mean."""
    order = np.argsort(ratio, kind="stable")
    ratio, traction = ratio[order], traction[order]
    if len(ratio) > MOST:
        share = np.log(ratio / ratio[0]) / max(np.log(ratio[-1] / ratio[0]), 1e-300)
        group = np.minimum((share * AVERAGED).astype(int), AVERAGED - 1)
    else:
        group = np.unique(ratio, return_inverse=True)[1]
    members = [group == number for number in np.unique(group)]
    return [(float(np.exp(np.mean(np.log(ratio[m])))), float(np.mean(traction[m]))) for m in members]


def checked_points(points: Iterable[tuple[float, float]]) -> Points:
    """The points of a curve, refused where they cannot be one."""
    curve = tuple((float(ratio), float(traction)) for ratio, traction in points)
    if len(curve) < FEWEST:
        raise InputError(f"a curve of {len(curve)} points is too short; it needs at least {FEWEST} ratios")
    ratios, tractions = (np.array(column) for column in zip(*curve, strict=True))
    for what, numbers, most in (
        ("slide-roll ratio", ratios, _LARGEST_RATIO),
        ("traction coefficient", tractions, _LARGEST_TRACTION),
    ):
        if numbers.max() > most:
            raise InputError(
                f"the {what} goes up to {numbers.max():.4g}, above {most:g}: it is a share, not %; divide by 100, or "
                "write the unit % into the heading of the column of a file"
            )
        if numbers.min() <= 0.0:
            raise InputError(
                f"the {what} {numbers[numbers <= 0.0][0]:.4g} must be above 0: traction goes with the slip; take off "
                "the zero of the sensor, and leave out pure rolling"
            )
    if np.any(np.diff(ratios) <= 0.0):
        raise InputError("the slide-roll ratios must rise from point to point; sort them")
    return curve


@functools.lru_cache(maxsize=32)
def of_film(points: Points, modulus: float | None, peak_pressure: float | None) -> Points:
    """The points of the film alone, without what the discs of the rig yield [Pa]; as they are without a rig.

    An ``InputError`` where the curve is as steep as its discs alone.
    """
    if modulus is None or peak_pressure is None:
        return points
    ratio, traction = (np.array(column) for column in zip(*points, strict=True))
    stick = modulus / peak_pressure * ratio
    if np.any(traction >= stick):
        at = int(np.argmax(traction >= stick))
        raise InputError(
            f"at the slide-roll ratio {ratio[at]:.4g} the traction coefficient {traction[at]:.4g} is steeper than the "
            f"discs alone, which reach {stick[at]:.4g} where they stick: look at the zero of the ratio, at its unit "
            "and at the rig"
        )
    even = even_slip_coefficients(
        creepage=ratio, coefficient=traction, rig_modulus=modulus, rig_peak_pressure=peak_pressure
    )
    if not np.all(np.isfinite(even)):
        raise InputError(
            "the discs cannot be taken off a curve as rough as this one: smooth it, or leave rig out, whose discs then "
            f"count twice, got {quoted(len(points))} points"
        )
    return tuple(zip(ratio.tolist(), even.tolist(), strict=True))
