"""Files made after public reports, with the numbers of their makers: read rightly, or refused with a remedy."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.height_parameters import height_parameters
from asperity.surface.levelling import default_form, levelled
from asperity.surface.measure_files import read_surface
from asperity.surface.suspicious_heights import disagreement
from asperity.surface.topography import without_missing


@pytest.mark.parametrize(
    ("name", "options", "rms_um", "digits"),
    [
        ("sampling_length.txt", {"spacing": 1.5e-6, "height_unit": "um"}, 0.0979, 4),
        ("cutoff_line.csv", {}, 0.0979, 4),
        ("resolution_line.txt", {"spacing": 1.5e-6}, 0.245, 3),
        ("tenth_of_nm.csv", {}, 0.2448, 4),
        ("bit2nm.asc", {"spacing": 0.5e-6}, 0.01669, 5),
        ("axes_in_matrix.csv", {"spacing": 0.5e-6, "height_unit": "nm"}, 0.001669, 6),
        ("five_columns.dat", {"column": "2"}, 0.00491, 5),
        ("count_line.txt", {}, 0.245, 3),
        ("utf16.csv", {}, 0.2539, 4),
    ],
)
def test_the_right_height(reproducers, name, options, rms_um, digits):
    got = read_surface(path=reproducers / name, **options)
    flat = levelled(topography=got, form=default_form(got))
    assert round(1e6 * height_parameters(topography=flat).root_mean_square, digits) == rms_um


@pytest.mark.parametrize(
    ("name", "options", "says", "option"),
    [
        ("sampling_length.txt", {"spacing": 1.5e-6}, "does not name the unit of its heights", "height-unit"),
        (
            "bit2nm.asc",
            {"height_unit": "nm"},
            r"0\.05 nm by line 6, '# Bit2nm = 0\.05', not nm",
            "height-unit",
        ),
        ("slopes.txt", {"height_unit": "nm"}, r"column 2 is headed 'Slope \(urad\)'.*no length", "column"),
        ("five_columns.dat", {"spacing": 1e-3}, "more than one column may hold the heights", "column"),
    ],
)
def test_a_refusal_with_the_option_that_decides(reproducers, name, options, says, option):
    with pytest.raises(InputError, match=says) as refused:
        read_surface(path=reproducers / name, **options)
    assert refused.value.options == (option,)


def test_two_decimal_signs(reproducers):
    with pytest.raises(InputError, match=r"line 19 holds '-1\.183', a point in a table of decimal commas"):
        read_surface(path=reproducers / "thousands_point.csv")


@pytest.mark.parametrize(
    ("name", "options", "points", "missing"),
    [
        ("nodata_declared.asc", {"spacing": 0.5e-6, "height_unit": "nm"}, 1536, 8),
        ("first_rows_na.csv", {"spacing": 0.5e-6, "height_unit": "nm"}, 1536, 15),
        ("invalid_flag.csv", {}, 800, 40),
    ],
)
def test_missing_points_are_counted(reproducers, name, options, points, missing):
    got = read_surface(path=reproducers / name, **options)
    assert (got.heights.size, got.missing_points) == (points, missing)


def test_y_before_x(reproducers):
    got = read_surface(path=reproducers / "y_before_x.csv")
    assert got.size == pytest.approx((24e-6, 16e-6))
    steps = [1e9 * np.sqrt(np.mean(np.diff(got.heights, axis=axis) ** 2)) for axis in (1, 0)]
    assert [round(step, 2) for step in steps] == [5.52, 1.67]


def test_profiles_of_one_surface_that_differ_a_hundredfold(reproducers):
    both = [read_surface(path=reproducers / f"same_surface_{i}.csv") for i in (1, 2)]
    flat = [levelled(topography=without_missing(one, choice="refuse"), form="line") for one in both]
    with pytest.raises(
        InputError, match=r"\(Pq 0\.0915\d* um\) and .*\(Pq (10|9\.99\d) um\) are no profiles of one surface"
    ):
        disagreement(flat)
