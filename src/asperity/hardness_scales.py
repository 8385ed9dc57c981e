"""Hardness numbers of steels: Vickers as a pressure, Rockwell C and Brinell by the table of ASTM E140."""

from bisect import bisect_right

from asperity.errors import InputError

#: Pressure of one Vickers number, 1 kgf/mm² [Pa], as numerator and denominator.
VICKERS_PRESSURE = (9_806_650, 1)

#: Rockwell C of the first entry of the tables below; each further entry is one more.
_FIRST = 20
_VICKERS = (
    *(238, 243, 248, 254, 260, 266, 272, 279, 286, 294),  # 20 HRC to 29 HRC
    *(302, 310, 318, 327, 336, 345, 354, 363, 372, 382),
    *(392, 402, 412, 423, 434, 446, 458, 471, 484, 498),
    *(513, 528, 544, 560, 577, 595, 613, 633, 653, 674),
    *(697, 720, 746, 772, 800, 832, 865, 900, 940),  # 60 HRC to 68 HRC
)
# ball of tungsten carbide, 10 mm, 3000 kgf; the table ends at 65 HRC
_BRINELL = (
    *(226, 231, 237, 243, 247, 253, 258, 264, 271, 279),
    *(286, 294, 301, 311, 319, 327, 336, 344, 353, 362),
    *(371, 381, 390, 400, 409, 421, 432, 443, 455, 469),
    *(481, 496, 512, 525, 543, 560, 577, 595, 615, 634),
    *(654, 670, 688, 705, 722, 739),
)


def vickers_of_rockwell(*, rockwell_c: float) -> float:
    """Vickers number of a Rockwell C hardness of a steel that is not austenitic, linear between the entries.

    Parameters
    ----------
    rockwell_c : float
        HRC [-], 20 to 68.

    Returns
    -------
    float
        HV [-].

    Raises
    ------
    InputError
        If the hardness is outside the table.

    Notes
    -----
    A conversion between scales is approximate: it depends on the alloy and its heat treatment.

    References
    ----------
    ASTM E140, Standard Hardness Conversion Tables for Metals, table 1.

    Examples
    --------
    >>> vickers_of_rockwell(rockwell_c=60.0)
    697.0
    """
    last = _FIRST + len(_VICKERS) - 1
    if not _FIRST <= rockwell_c <= last:
        raise InputError(
            f"{rockwell_c:g} HRC is outside ASTM E140, which goes from {_FIRST} to {last} HRC; state the hardness in "
            "HV or as a pressure"
        )
    index = min(int(rockwell_c) - _FIRST, len(_VICKERS) - 2)
    low, high = _VICKERS[index : index + 2]
    return low + (rockwell_c - _FIRST - index) * (high - low)


def rockwell_of_vickers(*, vickers: float) -> float | None:
    """Rockwell C hardness of a Vickers number of such a steel, by the same table; None outside 238 to 940 HV."""
    if not _VICKERS[0] <= vickers <= _VICKERS[-1]:
        return None
    index = min(bisect_right(_VICKERS, vickers) - 1, len(_VICKERS) - 2)
    low, high = _VICKERS[index : index + 2]
    return _FIRST + index + (vickers - low) / (high - low)


def hardness_words(*, pressure: float) -> str:
    """A hardness [Pa] as a drawing states it: in HV, and, for steels within ASTM E140, in HRC.

    Examples
    --------
    >>> hardness_words(pressure=6.835e9), hardness_words(pressure=1.26e9)
    ('697 HV, of steel 60 HRC', '128 HV')
    """
    vickers = pressure * VICKERS_PRESSURE[1] / VICKERS_PRESSURE[0]
    rockwell = rockwell_of_vickers(vickers=vickers)
    return f"{vickers:.0f} HV" + ("" if rockwell is None else f", of steel {rockwell:.0f} HRC")


def rockwell_of_brinell(*, brinell: float) -> float | None:
    """Rockwell C hardness of a Brinell number of such a steel, by the same table; None outside 226 to 739 HBW."""
    if not _BRINELL[0] <= brinell <= _BRINELL[-1]:
        return None
    index = min(bisect_right(_BRINELL, brinell) - 1, len(_BRINELL) - 2)
    low, high = _BRINELL[index : index + 2]
    return _FIRST + index + (brinell - low) / (high - low)


def other_scale_words(scale: str, number: float) -> str:
    """What to state in place of a hardness by a scale that is not read."""
    if not scale.startswith("HB"):
        return f"'{scale}' is no scale that is read; state the hardness in HV or as a pressure, e.g. '700 HV'"
    said = "a Brinell number depends on ball and load; state the hardness in HV or as a pressure"
    rockwell = rockwell_of_brinell(brinell=number)
    if rockwell is None:
        return said
    vickers = vickers_of_rockwell(rockwell_c=rockwell)
    return f"{said}: {number:g} HBW of steel are {vickers:.0f} HV by ASTM E140, so that '{vickers:.0f} HV' is meant"
