"""Surfaces of a joint file that name a finish of the library, and keys of a drawing that no surface can be made of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from asperity.errors import InputError, quoted
from asperity.joint_file import limits
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.quantity_key import Key, Quantity
from asperity.joint_file.si_tables import DEPTH, PARTNER_DEPTH
from asperity.library import FREQUENCY_RATIO, Finish, read_finishes
from asperity.surface.roughness_average import average_from_depth, depth_cut_off, standard_cut_off
from asperity.types import Document
from asperity.units import format_quantity

_PEAK_TO_VALLEY = ("rmax", "rt", "maximum_height")
_AVERAGE, _PARTNER = "roughness_average", "partner_roughness_average"
#: Rz → the Ra that it means, and the keys beside which it may not stand.
_AVERAGES = {DEPTH: (_AVERAGE, (_AVERAGE, "fractal_roughness")), PARTNER_DEPTH: (_PARTNER, (_PARTNER,))}
_MEANT = {"ra": _AVERAGE, "rz": DEPTH, "roughness_ra": _AVERAGE, "roughness_rz": DEPTH, "lambda_c": "cut_off"}
_MEANT |= dict.fromkeys(("rq", "sq"), "rms_height")


def fill_in_finishes(tables: Mapping[str, Any]) -> tuple[Document, dict[str, str]]:
    """The tables of a joint file in which a surface with a finish states its D, and one with an Rz its Ra."""
    surface = tables.get("surface")
    refused: dict[str, str] = {}
    if not isinstance(surface, dict):
        return dict(tables), refused
    twice = [name for name in surface if name in SurfaceEntry.model_fields]
    named = [f"[surface.{name}]" for name, entry in surface.items() if isinstance(entry, dict)]
    if twice and named:
        refused["surface"] = (
            f"surface: {', '.join(twice)} in [surface] {'is' if len(twice) == 1 else 'are'} of all contacts, and "
            f"{', '.join(named)} {'is' if len(named) == 1 else 'are'} of one each: a surface is stated twice; write "
            "one [surface] for all contacts, or a section for each"
        )
        return dict(tables), refused
    filled = dict(surface)
    for path, entry in _entries(surface):
        try:
            filled_entry = _filled_entry(entry)
        except InputError as error:
            refused[path] = f"{path}{error}"
            continue
        if path == "surface":
            filled = filled_entry
        else:
            filled[path.removeprefix("surface.")] = filled_entry
    return {**tables, "surface": filled}, refused


def dimension_text(*finishes: Finish) -> str:
    """The published range of D of finishes as a number with its tolerance."""
    ends = [one.published_dimension for one in finishes]
    low, high = min(low for low, _ in ends), max(high for _, high in ends)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    return f"{middle:.10g} +- {half:.10g}, uniform" if half > 0.0 else f"{middle:.10g}"


def _entries(surface: Document) -> Iterator[tuple[str, Document]]:
    """The tables of surfaces, one for all contacts or one for each, with their paths."""
    named = [name for name, entry in surface.items() if isinstance(entry, dict)]
    if named:
        yield from ((f"surface.{name}", surface[name]) for name in named)
    else:
        yield "surface", surface


def _filled_entry(entry: Document) -> Document:
    for key in entry:
        plain = key.lower()
        if plain in _PEAK_TO_VALLEY:
            raise InputError(
                f".{key}: no surface can be made of the largest peak-to-valley height, which a single scratch decides; "
                f"give roughness_average (Ra) or {DEPTH} (Rz, the mean over five sampling lengths)"
            )
        if plain in _MEANT and _MEANT[plain] not in entry:
            both = ", of both bodies together: sqrt(2) times that of one of two alike" * (plain[1] == "q")
            raise InputError(f".{key}: unknown key; did you mean '{_MEANT[plain]}'{both}?")
    if "measurement" in entry:  # no other key may stand beside it
        return entry
    name, known = entry.get("finish"), read_finishes()
    if name is None and _AVERAGE not in entry and DEPTH not in entry:
        return _with_averages(entry)
    finishes = [one for one in known.values() if name in (None, one.name)]  # of an Ra alone D is that of any
    if not finishes:
        raise InputError(f".finish: there is no finish {quoted(name)}; known are {', '.join(known)}")
    added = {"fractal_dimension": dimension_text(*finishes), "frequency_ratio": FREQUENCY_RATIO}
    return _with_averages({**added, **entry})


def _with_averages(entry: Document) -> Document:
    """A surface with the Ra that its Rz means, and that of its partner."""
    if DEPTH in entry:
        depth = _read(entry, DEPTH, limits.MEAN_ROUGHNESS_DEPTH)
        standard = depth_cut_off(mean_roughness_depth=depth.value)
        filled = _with_average(entry, DEPTH, depth, _cut_off(entry, standard))
    elif PARTNER_DEPTH in entry and _AVERAGE in entry:
        average = _read(entry, _AVERAGE, limits.ROUGHNESS_AVERAGE)
        filled, standard = entry, standard_cut_off(roughness_average=average.value)
    else:
        return entry
    if PARTNER_DEPTH not in entry:
        return filled
    depth = _read(entry, PARTNER_DEPTH, limits.MEAN_ROUGHNESS_DEPTH)
    partner_standard = depth_cut_off(mean_roughness_depth=depth.value)
    if "cut_off" not in entry and partner_standard != standard:
        raise InputError(
            f".{PARTNER_DEPTH}: ISO 4288 measures this Rz with the cut-off "
            f"{format_quantity(partner_standard, 'mm')} and the other body with {format_quantity(standard, 'mm')}; "
            "measure both with one cut-off, and give it as cut_off"
        )
    return _with_average(filled, PARTNER_DEPTH, depth, _cut_off(entry, standard))


def _cut_off(entry: Document, standard: float) -> float:
    """The cut-off that a surface states, or else the standard one [m]."""
    return _read(entry, "cut_off", limits.CUT_OFF).value if "cut_off" in entry else standard


def _with_average(entry: Document, key: str, depth: Quantity, cut_off: float) -> Document:
    """A surface with the Ra that one Rz means."""
    dimension = _read(entry, "fractal_dimension", limits.FRACTAL_DIMENSION)
    if depth.distribution and depth.distribution.kind != "uniform":
        raise InputError(
            f".{key}: its tolerance counts as the ends of a range; leave '{depth.distribution}' out, or give "
            f"{_AVERAGES[key][0]}"
        )
    for end in (dimension.value - dimension.tolerance, dimension.value + dimension.tolerance):
        if not limits.FRACTAL_DIMENSION.admits(end):
            raise InputError(
                f".fractal_dimension: the Ra of an Rz needs a range between 1 and 2, got {quoted(dimension.text)}"
            )
    try:
        average, half = average_from_depth(
            mean_roughness_depth=depth.value,
            tolerance=depth.tolerance,
            fractal_dimension=dimension.value,
            dimension_tolerance=dimension.tolerance,
            cut_off=cut_off,
        )
    except InputError as error:
        raise InputError(f".cut_off: {error}; or give {_AVERAGES[key][0]}") from None
    if half >= average:
        raise InputError(
            f".{key}: {quoted(depth.text)} leaves Ra open down to zero; its tolerance has to be smaller"
        )
    average_key, excluded = _AVERAGES[key]
    made = {
        average_key: f"{1e6 * average:.6g} um +- {1e6 * half:.6g} um, uniform",
        "cut_off": entry.get("cut_off", f"{1e3 * cut_off:.6g} mm"),
    }
    for other in excluded:
        if other in entry and entry[other] != made.get(other):  # tables that were filled in before state both
            raise InputError(f": both {key} and {other} are given; leave one of them out")
    return {**entry, **made}


def _read(entry: Document, name: str, key: Key) -> Quantity:
    try:
        return key.read(entry[name])
    except InputError as error:
        raise InputError(f".{name}: {error}") from None
