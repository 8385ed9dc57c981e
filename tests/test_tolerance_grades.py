"""The table of ISO 286-1 against the formulas that the standard made it from."""

import itertools
import math

import pytest

from asperity.errors import InputError
from asperity.library.tolerance_grades import grade_within, standard_tolerances

ENDS = (1, 3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500)
UNITS = (7, 10, 16, 25, 40, 64, 100, 160, 250, 400, 640, 1000, 1600, 2500)
MULTIPLES = {f"IT{grade}": units for grade, units in enumerate(UNITS, start=5)}


@pytest.mark.parametrize(("low", "high"), list(itertools.pairwise(ENDS)))
def test_grades_from_5_on_are_rounded_multiples_of_the_unit(low, high):
    """The standard rounds by its own series, in the first range by more than 10 %."""
    mean = math.sqrt(low * high)
    unit = 0.45 * mean ** (1 / 3) + 0.001 * mean
    widths = standard_tolerances(1e-3 * high)
    for grade, multiple in MULTIPLES.items():
        assert 1e6 * widths[grade] == pytest.approx(multiple * unit, rel=0.16 if high == 3 else 0.1), grade


def test_fine_grades_up_to_180_mm_follow_their_lines_and_steps():
    for low, high in itertools.pairwise(ENDS[:9]):
        mean, widths = math.sqrt(low * high), standard_tolerances(1e-3 * high)
        for grade, line in (
            ("IT01", 0.3 + 0.008 * mean),
            ("IT0", 0.5 + 0.012 * mean),
            ("IT1", 0.8 + 0.02 * mean),
        ):
            assert 1e6 * widths[grade] == pytest.approx(line, abs=0.25, rel=0.1), (high, grade)
        for before, grade, after in (("IT1", "IT2", "IT3"), ("IT2", "IT3", "IT4"), ("IT3", "IT4", "IT5")):
            assert widths[grade] ** 2 == pytest.approx(widths[before] * widths[after], rel=0.3), (
                high,
                grade,
            )


def test_every_row_and_every_column_grows():
    rows = [list(standard_tolerances(1e-3 * end).values()) for end in ENDS[1:]]
    for row in rows:
        assert all(one < other for one, other in itertools.pairwise(row))
    for one, other in itertools.pairwise(rows):
        assert all(fine <= coarse for fine, coarse in zip(one, other, strict=True))


def test_known_fits():
    """H7 of 50 mm is 25 um wide, h6 16 um; the ends of a range belong to it."""
    assert standard_tolerances(0.05)["IT7"] == pytest.approx(25e-6)
    assert standard_tolerances(0.05)["IT6"] == pytest.approx(16e-6)
    assert standard_tolerances(0.0500001)["IT6"] == pytest.approx(19e-6)
    assert standard_tolerances(0.018)["IT5"] == pytest.approx(8e-6)


def test_the_coarsest_grade_within_a_width():
    assert grade_within(0.045, 16e-6) == "IT6"
    assert grade_within(0.045, 15.9e-6) == "IT5"
    assert grade_within(0.045, 1e-8) == ""
    assert grade_within(0.002, 20e-3) == "IT18"
    with pytest.raises(InputError, match="up to 500 mm, got 600 mm"):
        standard_tolerances(0.6)
