"""Surfaces of a joint file that name a finish of the library, and keys of a drawing that no surface can be made of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from asperity.errors import InputError, quoted
from asperity.library import FREQUENCY_RATIO, Finish, read_finishes

_PEAK_TO_VALLEY = ("rz", "rmax", "rt", "maximum_height", "mean_roughness_depth")
_MEANT = {"ra": "roughness_average", "lambda_c": "cut_off"}


def fill_in_finishes(tables: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, str]]:
    """The tables of a joint file in which every surface with a finish states its D and frequency ratio.

    Parameters
    ----------
    tables : mapping
        The joint file as TOML reads it. ``surface = {finish = "ground", roughness_average = "0.2 um"}`` gets the
        published range of D of ground surfaces as a tolerance about its middle; what the file states stays.

    Returns
    -------
    tables : dict
        New tables; everything else is checked by the reader of joint files.
    refused : dict
        Dotted path of a surface → why no surface can be made of it. Its table is left unchanged.
    """
    surface = tables.get("surface")
    refused: dict[str, str] = {}
    if not isinstance(surface, dict):
        return dict(tables), refused
    filled = dict(surface)
    for path, entry in _entries(surface):
        try:
            whole = _whole(entry)
        except InputError as error:
            refused[path] = f"{path}{error}"
            continue
        if path == "surface":
            filled = whole
        else:
            filled[path.removeprefix("surface.")] = whole
    return {**tables, "surface": filled}, refused


def dimension_text(finish: Finish) -> str:
    """The published range of D of a finish as a number with its tolerance.

    Parameters
    ----------
    finish : Finish
        A finish of the library.

    Returns
    -------
    str
        For example ``1.325 +- 0.175, uniform``; the number alone where the source gives one value.
    """
    low, high = finish.published_dimension
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    return f"{middle:.10g} +- {half:.10g}, uniform" if half > 0.0 else f"{middle:.10g}"


def _entries(surface: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """The tables of surfaces, one for all contacts or one for each, with their paths."""
    named = [name for name, entry in surface.items() if isinstance(entry, dict)]
    if named:
        yield from ((f"surface.{name}", surface[name]) for name in named)
    else:
        yield "surface", surface


def _whole(entry: dict[str, Any]) -> dict[str, Any]:
    for key in entry:
        plain = key.lower()
        if plain in _PEAK_TO_VALLEY:
            raise InputError(
                f".{key}: no surface can be made of a peak-to-valley height, because its ratio to Ra depends on the "
                "process and on single scratches; give roughness_average, the Ra of the drawing or of a measurement"
            )
        if plain in _MEANT and _MEANT[plain] not in entry:
            raise InputError(f".{key}: unknown key; did you mean '{_MEANT[plain]}'?")
    if "finish" not in entry:
        if "roughness_average" in entry and "fractal_dimension" not in entry:
            raise InputError(
                ": roughness_average alone makes no surface, because Ra fixes one combination of D and G; add a finish "
                f"({', '.join(read_finishes())}), or fractal_dimension with its range, e.g. '1.3 +- 0.2'"
            )
        return entry
    name, known = entry["finish"], read_finishes()
    if not isinstance(name, str) or name not in known:
        raise InputError(f".finish: there is no finish {quoted(name)}; known are {', '.join(known)}")
    added = {"fractal_dimension": dimension_text(known[name]), "frequency_ratio": FREQUENCY_RATIO}
    return {**added, **entry}
