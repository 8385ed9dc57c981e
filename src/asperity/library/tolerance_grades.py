r"""Standard tolerances of lengths: the width that a grade IT of ISO 286-1 allows at a nominal size.

The table of the standard, whose grades 5 to 12 are rounded multiples (7, 10, 16, 25, 40, 64, 100, 160) of

.. math:: i = 0.45 \sqrt[3]{D} + 0.001 D

in µm, D in mm the geometric mean of the range of sizes. Grades from 13 on are ten times those of five grades before.
"""

from __future__ import annotations

import bisect

from asperity.errors import InputError

#: Largest nominal size with a standard tolerance [m].
LARGEST_SIZE = 0.5
_GRADES = ("IT01", "IT0", *(f"IT{number}" for number in range(1, 19)))
#: Upper end of a range of nominal sizes [mm] → widths of the grades [µm]; the first range begins at 0.
_TABLE: dict[float, tuple[float, ...]] = {
    3: (0.3, 0.5, 0.8, 1.2, 2, 3, 4, 6, 10, 14, 25, 40, 60, 100),
    6: (0.4, 0.6, 1, 1.5, 2.5, 4, 5, 8, 12, 18, 30, 48, 75, 120),
    10: (0.4, 0.6, 1, 1.5, 2.5, 4, 6, 9, 15, 22, 36, 58, 90, 150),
    18: (0.5, 0.8, 1.2, 2, 3, 5, 8, 11, 18, 27, 43, 70, 110, 180),
    30: (0.6, 1, 1.5, 2.5, 4, 6, 9, 13, 21, 33, 52, 84, 130, 210),
    50: (0.6, 1, 1.5, 2.5, 4, 7, 11, 16, 25, 39, 62, 100, 160, 250),
    80: (0.8, 1.2, 2, 3, 5, 8, 13, 19, 30, 46, 74, 120, 190, 300),
    120: (1, 1.5, 2.5, 4, 6, 10, 15, 22, 35, 54, 87, 140, 220, 350),
    180: (1.2, 2, 3.5, 5, 8, 12, 18, 25, 40, 63, 100, 160, 250, 400),
    250: (2, 3, 4.5, 7, 10, 14, 20, 29, 46, 72, 115, 185, 290, 460),
    315: (2.5, 4, 6, 8, 12, 16, 23, 32, 52, 81, 130, 210, 320, 520),
    400: (3, 5, 7, 9, 13, 18, 25, 36, 57, 89, 140, 230, 360, 570),
    500: (4, 6, 8, 10, 15, 20, 27, 40, 63, 97, 155, 250, 400, 630),
}


def standard_tolerances(size: float) -> dict[str, float]:
    """Widths [m] of the grades IT01 to IT18 at a nominal size, a diameter [m]; the finest first.

    Raises
    ------
    InputError
        If the size is not above 0 and at most 500 mm.

    References
    ----------
    ISO 286-1:2010, tables 1 and annex A (IT01, IT0).
    """
    diameter, ends = round(1e3 * size, 9), list(_TABLE)
    if not 0.0 < diameter <= ends[-1]:
        raise InputError(f"standard tolerances are for sizes up to 500 mm, got {diameter:g} mm")
    widths = _TABLE[ends[bisect.bisect_left(ends, diameter)]]
    for _ in range(13, 19):
        widths = (*widths, 10.0 * widths[-5])
    return {grade: 1e-6 * width for grade, width in zip(_GRADES, widths, strict=True)}


def grade_within(size: float, width: float) -> str:
    """The coarsest grade whose width at a nominal size lies within a given one [m]; empty if none does."""
    within = [
        grade for grade, allowed in standard_tolerances(size).items() if allowed <= width * (1.0 + 1e-9)
    ]
    return within[-1] if within else ""
