"""Standard tolerances of sizes: the grades IT1 to IT18 of ISO 286-1."""

from __future__ import annotations

from bisect import bisect_left

#: Upper ends of the ranges of nominal sizes, which belong to them [mm].
SIZE_RANGES = (3.0, 6.0, 10.0, 18.0, 30.0, 50.0, 80.0, 120.0, 180.0, 250.0, 315.0, 400.0, 500.0)
_UP_TO_IT12 = (
    (0.8, 1.0, 1.0, 1.2, 1.5, 1.5, 2.0, 2.5, 3.5, 4.5, 6.0, 7.0, 8.0),
    (1.2, 1.5, 1.5, 2.0, 2.5, 2.5, 3.0, 4.0, 5.0, 7.0, 8.0, 9.0, 10.0),
    (2.0, 2.5, 2.5, 3.0, 4.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 13.0, 15.0),
    (3.0, 4.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 14.0, 16.0, 18.0, 20.0),
    (4.0, 5.0, 6.0, 8.0, 9.0, 11.0, 13.0, 15.0, 18.0, 20.0, 23.0, 25.0, 27.0),
    (6.0, 8.0, 9.0, 11.0, 13.0, 16.0, 19.0, 22.0, 25.0, 29.0, 32.0, 36.0, 40.0),
    (10.0, 12.0, 15.0, 18.0, 21.0, 25.0, 30.0, 35.0, 40.0, 46.0, 52.0, 57.0, 63.0),
    (14.0, 18.0, 22.0, 27.0, 33.0, 39.0, 46.0, 54.0, 63.0, 72.0, 81.0, 89.0, 97.0),
    (25.0, 30.0, 36.0, 43.0, 52.0, 62.0, 74.0, 87.0, 100.0, 115.0, 130.0, 140.0, 155.0),
    (40.0, 48.0, 58.0, 70.0, 84.0, 100.0, 120.0, 140.0, 160.0, 185.0, 210.0, 230.0, 250.0),
    (60.0, 75.0, 90.0, 110.0, 130.0, 160.0, 190.0, 220.0, 250.0, 290.0, 320.0, 360.0, 400.0),
    (100.0, 120.0, 150.0, 180.0, 210.0, 250.0, 300.0, 350.0, 400.0, 460.0, 520.0, 570.0, 630.0),
)
_TEN_TIMES = tuple(tuple(10.0 * width for width in row) for row in _UP_TO_IT12[7:])
#: Standard tolerances of IT1 to IT18 [µm], a row for each grade, a column for each range of sizes; those of IT13 and
#: coarser are ten times those of the grade five before.
STANDARD_TOLERANCES = (*_UP_TO_IT12, *_TEN_TIMES, tuple(10.0 * width for width in _TEN_TIMES[0]))


def tolerance_grade(size: float, width: float) -> str:
    r"""The coarsest standard grade whose tolerance is not wider than a stated one.

    Parameters
    ----------
    size : float
        Nominal size, for example a diameter [mm].
    width : float
        Upper less lower limit of the size [µm].

    Returns
    -------
    str
        ``"IT1"`` to ``"IT18"``; empty where the size is above 500 mm or the width below that of IT1.

    References
    ----------
    ISO 286-1:2010, table 1. IT5 and coarser are multiples of :math:`i = 0.45\,D^{1/3} + 0.001\,D` µm, with D the
    geometric mean of the ends of a range in mm, rounded.

    Examples
    --------
    >>> tolerance_grade(40.0, 20.0)
    'IT6'
    """
    if not 0.0 < size <= SIZE_RANGES[-1]:
        return ""
    column = bisect_left(SIZE_RANGES, size)
    kept = [
        grade for grade, row in enumerate(STANDARD_TOLERANCES, start=1) if row[column] <= width * (1.0 + 1e-9)
    ]
    return f"IT{kept[-1]}" if kept else ""
