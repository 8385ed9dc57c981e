"""Length units met in instrument files, converted to metres."""

from __future__ import annotations

import re

from asperity.errors import InputError

#: Unit word, lower case -> metres.
METRES: dict[str, float] = {
    "m": 1.0, "meter": 1.0, "metre": 1.0, "cm": 1e-2, "mm": 1e-3, "millimeter": 1e-3, "millimetre": 1e-3,
    "um": 1e-6, "µm": 1e-6, "\u03bcm": 1e-6, "micron": 1e-6, "microns": 1e-6,
    "micrometer": 1e-6, "micrometre": 1e-6,
    "nm": 1e-9, "nanometer": 1e-9, "nanometre": 1e-9, "pm": 1e-12, "å": 1e-10, "angstrom": 1e-10,
    "in": 0.0254, "inch": 0.0254,
}  # fmt: skip

_QUANTITY = re.compile(r"^\s*([-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([^\d\s].*?)\s*$")


def metres_per_unit(unit: str) -> float:
    """Metres in one unit of length.

    Raises
    ------
    InputError
        If the unit is not known.

    Examples
    --------
    >>> metres_per_unit("um")
    1e-06
    """
    factor = METRES.get(unit.strip().lower())
    if factor is None:
        raise InputError(
            f"'{unit}' is not a known unit of length; known: m, cm, mm, um, nm, pm, angstrom, in"
        )
    return factor


def length_in_metres(text: str) -> float:
    """A length with its unit, such as ``"0.5 um"``, in metres.

    Raises
    ------
    InputError
        If there is no unit, or the number or unit cannot be read.

    Examples
    --------
    >>> length_in_metres("2.5 mm")
    0.0025
    """
    match = _QUANTITY.match(text)
    if match is None:
        raise InputError(f"'{text}' is not a length; write a number and a unit, such as '0.5 um'")
    try:
        number = float(match.group(1))
    except ValueError:
        raise InputError(f"'{text}' is not a length; write a number and a unit, such as '0.5 um'") from None
    return number * metres_per_unit(match.group(2))


def unit_in_words(text: str) -> str | None:
    """The unit of length in a column heading such as ``"[mm]"`` or ``"Lateral um"``, or None."""
    for word in re.findall(r"[^\W\d_]+", text.replace("°", " ")):
        if word.lower() in METRES and word.lower() != "in":
            return str(word)
    return None
