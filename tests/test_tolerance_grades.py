"""Standard tolerances: the table of ISO 286-1 against its own formula, and the grade of a stated tolerance."""

import math

import pytest

from asperity.tolerance_grades import SIZE_RANGES, STANDARD_TOLERANCES, tolerance_grade

#: IT5 to IT18 over the tolerance unit i, and IT1 as a constant and a slope (ISO 286-1:1988, annex A).
UNITS = (7.0, 10.0, 16.0, 25.0, 40.0, 64.0, 100.0, 160.0, 250.0, 400.0, 640.0, 1000.0, 1600.0, 2500.0)
MEANS = [math.sqrt(low * high) for low, high in zip((1.0, *SIZE_RANGES), SIZE_RANGES, strict=False)]


@pytest.mark.parametrize("grade", range(5, 19))
def test_a_standard_tolerance_is_its_multiple_of_the_unit_rounded(grade):
    """The standard rounds up to a sixth in the smallest range, a tenth in the next, a twentieth in the others."""
    rounding = (0.16, 0.10, *(0.06 for _ in SIZE_RANGES[2:]))
    for mean, width, share in zip(MEANS, STANDARD_TOLERANCES[grade - 1], rounding, strict=True):
        exact = UNITS[grade - 5] * (0.45 * mean ** (1.0 / 3.0) + 0.001 * mean)
        assert abs(width - exact) <= share * exact, (grade, mean)


def test_grades_below_five_lie_between_the_first_and_the_fifth():
    for mean, widths in zip(MEANS, zip(*STANDARD_TOLERANCES, strict=True), strict=True):
        assert widths[0] == pytest.approx(0.8 + 0.020 * mean, rel=0.22)
        ratio = (widths[4] / widths[0]) ** 0.25  # a geometric sequence, rounded
        for step in (1, 2, 3):
            assert widths[step] == pytest.approx(widths[0] * ratio**step, rel=0.21)
        assert list(widths) == sorted(widths)


@pytest.mark.parametrize(
    ("size", "width", "grade"),
    [
        (40.0, 25.0, "IT7"),  # H7 of 40 mm: 0 to 25 µm
        (40.0, 24.9, "IT6"),
        (30.0, 21.0, "IT7"),  # the end belongs to its range
        (30.001, 21.0, "IT6"),
        (8.0, 0.9, ""),
        (500.0, 63.0, "IT7"),
        (501.0, 63.0, ""),
        (2.0, 2e4, "IT18"),
    ],
)
def test_the_coarsest_grade_within_a_tolerance(size, width, grade):
    assert tolerance_grade(size, width) == grade
