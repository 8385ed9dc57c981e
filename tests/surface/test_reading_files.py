"""Layouts of text files that instruments and people write: the right numbers, or a refusal that names line and remedy.

The heights are made here, so that every expected number is known without the reader.
"""

from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.measure_files import read_surface

RANDOM = np.random.default_rng(5)
#: Whole numbers, as an instrument counts.
COUNTS = np.round(400.0 * np.cumsum(RANDOM.standard_normal(60)) / 7.0)
GRID = np.round(300.0 * RANDOM.standard_normal((9, 12)).cumsum(axis=1))
MM = "position [mm],height [um]"


def rows(values=COUNTS / 1000.0, step=0.0015, sign=",", decimals=4):
    """Rows of positions and heights."""
    return [f"{step * i:.{decimals}f}{sign}{z:.4f}" for i, z in enumerate(values)]


def heights(values=COUNTS / 1000.0, pattern="{:.4f}"):
    return [pattern.format(z) for z in values]


def matrix(grid=GRID, sign="\t"):
    return [sign.join(f"{z:g}" for z in row) for row in grid]


def read(tmp_path: Path, lines, name="measured.txt", encoding="utf-8", **options):
    file = tmp_path / name
    text = lines if isinstance(lines, str) else "\n".join(lines) + "\n"
    file.write_bytes(text.encode(encoding))
    return read_surface(path=file, **options)


def same(got, expected=1e-9 * COUNTS):
    np.testing.assert_allclose(got.heights, expected, rtol=1e-9, atol=1e-18)


# --- units come from the heading of the column -------------------------------------------------------------------


@pytest.mark.parametrize(
    "above",
    [
        ["Lc,0.8 mm", MM],
        ["Tip radius,2 um", MM],
        ["Date,2:15 pm", MM],
        ["RES=0.0125 um", MM],
        [MM, "Lc,0.8 mm"],
        ["position [nm],height [nm]", MM],  # the last line of headings wins
        ["position,height", "mm,um"],
        ["position,height", "[mm],[um]"],
        ["# position [mm],height [um]"],
        ["position (mm),height (µm)"],
        ["position / mm,height / µm"],
        ["position in mm,height in um"],
        ["position_mm,height_um"],
        ["position mm,height um"],
        ['"position [mm]","height [um]"'],
        ["position [mm]\theight [um]"],
        ["Lateral Millimeters,Raw Micrometers"],
        ["position [mm],Profile 1 [um]"],
        ["position [mm] height [um]"],
        ["Meßlänge: 4 mm", "Cut-off (mm): 0.8", MM],
    ],
)
def test_the_unit_of_a_column_is_that_of_its_own_heading(tmp_path, above):
    got = read(tmp_path, [*above, *rows()])
    same(got)
    assert got.spacing == pytest.approx(1.5e-6)


@pytest.mark.parametrize(
    ("unit", "metres"),
    [
        ("0.1 nm", 1e-10),
        ("x10 nm", 1e-8),
        ("×10 nm", 1e-8),
        ("1e-9 m", 1e-9),
        ("10^-6 m", 1e-6),
        ("10⁻⁶ m", 1e-6),
        ("x2.5 nm", 2.5e-9),
        ("Å", 1e-10),
        ("µin", 2.54e-8),
    ],
)
def test_a_number_before_a_unit_is_a_factor(tmp_path, unit, metres):
    for brackets in ("[]", "()"):
        heading = f"x [mm];z {brackets[0]}{unit}{brackets[1]}"
        got = read(tmp_path, [heading, *rows(COUNTS * 1e-3, sign=";")], any_size=True)
        same(got, metres * 1e-3 * COUNTS)


@pytest.mark.parametrize("unit", ["V", "mV", "rad", "urad", "mrad", "%", "deg", "°", "s", "N", "um/m", "dB"])
def test_a_unit_that_is_no_length_refuses_the_column(tmp_path, unit):
    for option in ({}, {"height_unit": "um"}):
        with pytest.raises(InputError, match=r"column 2 is headed 'z .*no length"):
            read(tmp_path, [f"x [mm],z [{unit}]", *rows()], **option)


@pytest.mark.parametrize("unit", ["nm x 10", "MM", "A", "um RMS 2", "10E-6 m", "0.8 mm", "2 um"])
def test_a_unit_that_is_not_understood_is_asked_for(tmp_path, unit):
    lines = [f"x [mm],z [{unit}]", *rows()]
    with pytest.raises(InputError, match=r"unit in the heading .* is not understood") as refused:
        read(tmp_path, lines)
    assert refused.value.options == ("height-unit",)
    same(read(tmp_path, lines, height_unit="um"))


@pytest.mark.parametrize("heading", ["z [counts]", "z (px)", "z [-]", "z (raw)", "Gray_Value"])
def test_counts_have_the_height_that_is_stated(tmp_path, heading):
    lines = [f"x [mm],{heading}", *rows(COUNTS)]
    with pytest.raises(InputError, match="does not name the unit of its heights"):
        read(tmp_path, lines)
    same(read(tmp_path, lines, height_unit="0.5 nm"), 0.5e-9 * COUNTS)


@pytest.mark.parametrize(
    "above",
    [
        ["Sampling length: 0.8 mm"],
        ["Lc 0.8 mm"],
        ["Cutoff = 0.8 mm"],
        ["measured in steps of 2 um"],
        ["2:15 pm"],
        ["0.8 mm"],
    ],
)
def test_a_value_above_a_single_column_is_no_unit(tmp_path, above):
    lines = [*above, *heights()]
    with pytest.raises(InputError, match="does not name the unit of its heights"):
        read(tmp_path, lines, spacing=1.5e-6)
    same(read(tmp_path, lines, spacing=1.5e-6, height_unit="um"))


@pytest.mark.parametrize("heading", ["z [um]", "[um]", "um", "height (um)", "Z/um", "µm"])
def test_a_heading_of_a_single_column_has_its_unit(tmp_path, heading):
    same(read(tmp_path, [heading, *heights()], spacing=1.5e-6))


# --- what other lines state --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("above", "metres"),
    [
        (["RES=0.0125 um"], 0.0125e-6),
        (["z-scale: 2.5 nm"], 2.5e-9),
        (["Bit2nm = 0.05"], 0.05e-9),
        (["Height per count [nm],0.5"], 0.5e-9),
        (["z-unit: nm"], 1e-9),
        (["# Value units: m"], 1.0),
        (["Unit,um"], 1e-6),
    ],
)
def test_the_size_of_a_count_is_read(tmp_path, above, metres):
    got = read(tmp_path, [*above, *heights(COUNTS, "{:g}")], spacing=1.5e-6, any_size=True)
    same(got, metres * COUNTS)
    assert any("unit of the heights from line 1" in note for note in got.notes)
    with pytest.raises(InputError, match=r"unit of its heights is .* by line 1, .* not 3 nm"):
        read(tmp_path, [*above, *heights(COUNTS, "{:g}")], spacing=1.5e-6, height_unit="3 nm")


def test_the_resolution_of_an_instrument_is_no_unit_of_heights_that_are_no_counts(tmp_path):
    lines = ["RES=0.0125 um", *heights()]
    with pytest.raises(InputError, match=r"line 1, 'RES=0.0125 um' may be the height of one count"):
        read(tmp_path, lines, spacing=1e-6)
    same(read(tmp_path, lines, spacing=1e-6, height_unit="um"))


def test_two_units_of_the_heights_are_refused_until_one_is_stated(tmp_path):
    lines = ["z-unit = um", "Bit2nm = 0.5", *heights(COUNTS, "{:g}")]
    with pytest.raises(InputError, match=r"states two units of its heights: line 2.* and line 1"):
        read(tmp_path, lines, spacing=1e-6)
    same(read(tmp_path, lines, spacing=1e-6, height_unit="0.5 nm"), 0.5e-9 * COUNTS)


@pytest.mark.parametrize(
    "above",
    [
        "DX=1.5 um",
        "Spacing: 1.5 um",
        "Point spacing,1.5,um",
        '"Pitch","1.5","um"',
        "dx [um] = 1.5",
        "Step (um): 1.5",
    ],
)
def test_the_distance_of_the_points_is_read_and_held_against_the_stated_one(tmp_path, above):
    lines = [above, *heights()]
    got = read(tmp_path, lines, height_unit="um")
    assert got.spacing == pytest.approx(1.5e-6)
    same(got)
    same(read(tmp_path, lines, height_unit="um", spacing=1.5e-6))
    with pytest.raises(InputError, match=r"distance of the points is 1\.5 um by line 1, .* not 2 um"):
        read(tmp_path, lines, height_unit="um", spacing=2e-6)


def test_positions_are_held_against_the_stated_distance(tmp_path):
    assert read(tmp_path, [MM, *rows()], spacing=1.5e-6).spacing == pytest.approx(1.5e-6)
    with pytest.raises(
        InputError, match=r"distance of the points is 1\.5 um by the positions, not 1 um"
    ) as refused:
        read(tmp_path, [MM, *rows()], spacing=1e-6)
    assert refused.value.options == ("spacing",)
    with pytest.raises(
        InputError,
        match=r"two distances of its points: 1\.5 um by the positions, 2 um by line 1, 'dx = 2 um'",
    ):
        read(tmp_path, ["dx = 2 um", MM, *rows()])


def test_positions_without_a_unit_have_the_stated_distance(tmp_path):
    got = read(tmp_path, ["x,z [um]", *rows(step=1.5)], spacing=1.5e-6)
    assert got.spacing == 1.5e-6
    assert any("positions without a unit" in note for note in got.notes)
    with pytest.raises(
        InputError, match=r"advance by 0\.5, which in no unit of length is the stated distance"
    ) as refused:
        read(tmp_path, ["x,z [um]", *rows(step=0.5)], spacing=1.5e-6)
    assert refused.value.options == ("position-unit",)
    assert (
        read(tmp_path, ["x,z [um]", *rows(step=1.0)], spacing=1.5e-6).spacing == 1.5e-6
    )  # numbers of points


@pytest.mark.parametrize("metres", [1.0, 1e-2, 1e-3, 1e-6, 1e-9, 1e-10, 0.0254, 2.54e-5, 2.54e-8, 0.3048])
def test_the_stated_distance_fits_positions_in_any_unit(tmp_path, metres):
    step = 1.5e-6 / metres
    lines = ["x,z [um]", *(f"{step * i:.9e},{z:.4f}" for i, z in enumerate(COUNTS / 1000.0))]
    assert read(tmp_path, lines, spacing=1.5e-6).spacing == 1.5e-6
    with pytest.raises(InputError, match="in no unit of length"):
        read(tmp_path, lines, spacing=1.035 * 1.5e-6)


@pytest.mark.parametrize("above", ["POINTS=59", "Number of points: 61", "ncols 30", "x-pixels = 12"])
def test_other_numbers_of_points_than_stated_are_refused(tmp_path, above):
    with pytest.raises(InputError, match=r"line 1, .* speaks of .* points"):
        read(tmp_path, [above, *heights()], height_unit="um", spacing=1e-6)


def test_a_lone_number_that_equals_the_rows_counts_them(tmp_path):
    for above in ([MM, "60"], ["60", MM], ["60", "mm, um"], ["µm µm", "60"]):
        scale = 1e-3 if above[0] == "µm µm" else 1.0
        got = read(tmp_path, [*above, *rows()], any_size=True)
        assert got.heights.size == 60
        assert got.spacing == pytest.approx(1.5e-6 * scale)
        assert any("counts the points" in note for note in got.notes)
    got = read(tmp_path, ["60", *heights()], height_unit="um", spacing=1e-6)
    same(got)
    assert any("counts the points" in note for note in got.notes)


# --- missing points ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "mark", ["#N/A", "nan", "NaN", "Bad", "BAD", "No Data", "n/a", "---", "***", "", "NULL", "#NV"]
)
@pytest.mark.parametrize("place", [0, 1, 30, 59])
def test_marks_of_missing_values_are_missing_points_wherever_they_stand(tmp_path, mark, place):
    lines = rows(sign=";")
    lines[place] = f"{lines[place].split(';')[0]};{mark}"
    got = read(tmp_path, ["x [mm];z [um]", *lines])
    assert (got.heights.size, got.missing_points) == (60, 1)
    assert np.isnan(got.heights[place])


def test_rows_of_a_map_that_begin_with_missing_values_do_not_vanish(tmp_path):
    lines = [line.split("\t") for line in matrix()]
    for row in lines[:3]:
        row[:5] = ["#N/A"] * 5
    lines[1] = ["#N/A"] * 12
    got = read(tmp_path, ["\t".join(row) for row in lines], height_unit="nm", spacing=1e-6)
    assert (got.heights.shape, got.missing_points) == ((9, 12), 5 + 12 + 5)
    np.testing.assert_allclose(got.heights[3:], 1e-9 * GRID[3:])


def test_declared_and_stated_marks_are_missing_points(tmp_path):
    marked = COUNTS.copy()
    marked[7:9] = -9999.0
    text = heights(marked, "{:g}")
    for lines, options in ((["NODATA_value -9999", *text], {}), (text, {"no_data": "-9999"})):
        got = read(tmp_path, lines, height_unit="nm", spacing=1e-6, **options)
        assert list(np.flatnonzero(np.isnan(got.heights))) == [7, 8]
        assert any("mark missing points" in note for note in got.notes)
    with pytest.raises(InputError, match=r"2 points have exactly the lowest height, -9.999 um.*") as refused:
        read(tmp_path, text, height_unit="nm", spacing=1e-6)
    assert refused.value.options == ("no-data",)
    same(read(tmp_path, text, height_unit="nm", spacing=1e-6, no_data="none"), 1e-9 * marked)
    with pytest.raises(InputError, match="'x' marks no missing point"):
        read(tmp_path, text, height_unit="nm", spacing=1e-6, no_data="x")


@pytest.mark.parametrize("lines", [["#a comment", *rows()], [*rows(), "# end"], [*rows(), "END OF DATA"]])
def test_lines_that_are_not_used_are_named(tmp_path, lines):
    got = read(tmp_path, lines, position_unit="mm", height_unit="um")
    same(got)
    assert any("not used" in note and "line " in note for note in got.notes)


def test_a_comment_between_rows_is_left_out_and_named(tmp_path):
    lines = rows()
    lines.insert(20, "# pause")
    got = read(tmp_path, lines, position_unit="mm", height_unit="um")
    same(got)
    assert "not used between the rows: line 21, '# pause'" in got.notes


@pytest.mark.parametrize(
    ("place", "line", "says"),
    [
        (30, "0.0450,x5", "'x5' in line 31 is not a number"),
        (30, "0.0450", "line 31, '0.0450' has 1 column, the table has 2"),
        (30, "0.0450,1,2", "line 31, '0.0450,1,2' has 3 columns, the table has 2"),
        (30, "second profile", "line 31, 'second profile' stands between rows"),
        (60, "0.0900,x5", "'x5' in line 61 is not a number"),
        (60, "0.0900", "line 61, '0.0900' has 1 column, the table has 2"),
        (30, "0.0450,inf", "'inf' in line 31 is not a number|line 31 holds a number that is not finite"),
        (30, "0.0450,1e999", "line 31 holds a number that is not finite"),
    ],
)
def test_a_broken_row_is_refused_with_its_line(tmp_path, place, line, says):
    lines = rows()
    lines[place : place + 1] = [line]
    with pytest.raises(InputError, match=says):
        read(tmp_path, lines, position_unit="mm", height_unit="um")


# --- columns -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("heading", "order"),
    [
        ("Z [um],X [mm]", (1, 0)),
        ("height [um],position [mm]", (1, 0)),
        ("X [mm],Y [um]", (0, 1)),
        ("Y [mm],Z [um]", (0, 1)),
        ("Profile height [um],Profile position [mm]", (1, 0)),
    ],
)
def test_two_columns_are_told_by_their_names(tmp_path, heading, order):
    pairs = [row.split(",") for row in rows()]
    got = read(tmp_path, [heading, *(f"{pair[order[0]]},{pair[order[1]]}" for pair in pairs)])
    same(got)
    assert got.spacing == pytest.approx(1.5e-6)


def test_an_even_ramp_is_the_position_also_as_second_column(tmp_path):
    lines = [",".join(reversed(row.split(","))) for row in rows()]
    got = read(tmp_path, lines, position_unit="mm", height_unit="um")
    same(got)
    assert "heights from column 1, positions from column 2" in got.notes


@pytest.mark.parametrize(("name", "good"), [("Invalid", 0), ("valid", 1), ("Valid flag", 1), ("is_valid", 1)])
def test_flags_of_valid_and_of_invalid_points(tmp_path, name, good):
    flags = np.where(np.arange(60) % 20 == 3, 1 - good, good)
    lines = [f"{row},{flag}" for row, flag in zip(rows(), flags, strict=True)]
    got = read(tmp_path, [f"x [mm],z [um],{name}", *lines])
    assert list(np.flatnonzero(np.isnan(got.heights))) == [3, 23, 43]
    lines[9] = f"{lines[9][:-1]}7"
    with pytest.raises(InputError, match=r"line 11 has the flag 7 in column 3 .*must be 0 or 1"):
        read(tmp_path, [f"x [mm],z [um],{name}", *lines])


@pytest.mark.parametrize("order", ["XYZ", "YXZ", "ZXY", "ZYX"])
def test_the_columns_of_a_grid_are_told_by_their_names(tmp_path, order):
    y, x = np.mgrid[0:9, 0:12]
    columns = {"X": 0.5 * x.ravel(), "Y": 2.0 * y.ravel(), "Z": GRID.ravel()}
    units = {"X": "um", "Y": "um", "Z": "nm"}
    table = [",".join(f"{columns[name][i]:g}" for name in order) for i in range(x.size)]
    got = read(tmp_path, [",".join(f"{name} [{units[name]}]" for name in order), *table])
    np.testing.assert_allclose(got.heights, 1e-9 * GRID)
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 2e-6))


def test_each_column_of_positions_has_its_own_unit(tmp_path):
    y, x = np.mgrid[0:9, 0:12]
    table = [
        f"{0.5 * a:g} {0.002 * b:g} {z:g}" for a, b, z in zip(x.ravel(), y.ravel(), GRID.ravel(), strict=True)
    ]
    got = read(tmp_path, ["X[um] Y[mm] Z[nm]", *table])
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 2e-6))


def test_more_than_one_column_of_heights_asks_which(tmp_path):
    lines = [
        f"{row},{2.0 * z:.4f},{0.1 * i:.3f}"
        for i, (row, z) in enumerate(zip(rows(), COUNTS / 1000, strict=True))
    ]
    heading = "X (mm),Measured (um),Residual (um),Slope (urad)"
    with pytest.raises(
        InputError, match=r"column 2 'Measured \(um\)', column 3 'Residual \(um\)'; choose"
    ) as refused:
        read(tmp_path, [heading, *lines])
    assert refused.value.options == ("column",)
    same(read(tmp_path, [heading, *lines], column="2"))
    same(read(tmp_path, [heading, *lines], column="residual"), 2e-9 * COUNTS)
    with pytest.raises(InputError, match="'urad' is no length"):
        read(tmp_path, [heading, *lines], column="slope")
    with pytest.raises(InputError, match="has no single column 'zz'"):
        read(tmp_path, [heading, *lines], column="zz")
    bare = {"position_unit": "mm", "height_unit": "um"}
    with pytest.raises(InputError, match="more than one column may hold the heights"):
        read(tmp_path, lines, **bare, spacing=1.5e-6)
    same(read(tmp_path, lines, **bare, column="2"))


def test_pairs_side_by_side_have_their_own_positions(tmp_path):
    lines = [
        f"{row},{0.004 * i:.3f},{2.0 * z:.4f}"
        for i, (row, z) in enumerate(zip(rows(), COUNTS / 1000, strict=True))
    ]
    lines = ["x1 [mm],z1 [um],x2 [mm],z2 [um]", *lines]
    with pytest.raises(InputError, match=r"column 2 'z1 .*column 4 'z2"):
        read(tmp_path, lines)
    for column, spacing, scale in (("z1", 1.5e-6, 1.0), ("z2", 4e-6, 2.0)):
        got = read(tmp_path, lines, column=column)
        same(got, scale * 1e-9 * COUNTS)
        assert got.spacing == pytest.approx(spacing)


def test_what_is_stated_and_has_no_meaning_is_said(tmp_path):
    got = read(tmp_path, heights(), height_unit="um", spacing=1e-6, position_unit="mm")
    assert "the stated unit of the positions is not used: the file has none" in got.notes
    np.save(tmp_path / "a.npy", COUNTS)
    options = {"path": tmp_path / "a.npy", "height_unit": "nm", "spacing": 1e-6}
    notes = read_surface(**options, position_unit="mm", decimal="comma").notes
    assert [note.rsplit(":", 1)[0] for note in notes] == [
        "the stated unit of the positions is not used",
        "the stated decimal sign is not used",
    ]
    with pytest.raises(InputError, match="has no column '2'"):
        read_surface(**options, column="2")


def test_an_array_of_pairs_is_a_profile(tmp_path):
    pairs = np.stack([1.5 * np.arange(60), COUNTS], axis=1)
    for array in (pairs, pairs[:, ::-1], pairs.T):
        np.save(tmp_path / "a.npy", array)
        got = read_surface(path=tmp_path / "a.npy", position_unit="um", height_unit="nm")
        same(got)
        assert got.spacing == pytest.approx(1.5e-6)
        same(read_surface(path=tmp_path / "a.npy", spacing=1.5e-6, height_unit="nm"))
    with pytest.raises(InputError, match=r"distance of the points of 1\.5e-06 m, not 2e-06 m"):
        read_surface(path=tmp_path / "a.npy", position_unit="um", height_unit="nm", spacing=2e-6)
    with pytest.raises(InputError, match="give the units of both"):
        read_surface(path=tmp_path / "a.npy", height_unit="nm")


def test_a_single_column_of_lengths_beside_others_is_the_heights(tmp_path):
    lines = [f"{row},{0.1 * i % 3:.3f}" for i, row in enumerate(rows())]
    same(read(tmp_path, ["X (mm),Z (um),Intensity (V)", *lines]))


@pytest.mark.parametrize(
    "heading", ["Index,X [mm],Z [um]", "No.,X [mm],Z [um]", ",X [mm],Z [um]", " \tX [mm]\tZ [um]"]
)
def test_a_column_that_numbers_the_points_is_left_out(tmp_path, heading):
    sign = "\t" if "\t" in heading else ","
    lines = [f"{i}{sign}{row}" for i, row in enumerate(rows(sign=sign), start=1)]
    got = read(tmp_path, [heading, *lines])
    same(got)
    assert any("column 1 numbers the points" in note for note in got.notes)


# --- maps --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("corner", ["y\\x", "0", "", "nan"])
def test_axes_inside_a_matrix_are_no_heights(tmp_path, corner):
    sign = ";"
    lines = [sign.join([corner, *(f"{0.5 * i:g}" for i in range(12))])]
    lines += [sign.join([f"{2.0 * j:g}", *(f"{z:g}" for z in row)]) for j, row in enumerate(GRID)]
    got = read(tmp_path, lines, height_unit="nm", position_unit="um")
    np.testing.assert_allclose(got.heights, 1e-9 * GRID)
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 2e-6))
    got = read(tmp_path, lines, height_unit="nm", spacing=0.5e-6)
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 2e-6))
    with pytest.raises(InputError, match="unit of its positions"):
        read(tmp_path, lines, height_unit="nm")
    with pytest.raises(InputError, match="by the positions, not"):
        read(tmp_path, lines, height_unit="nm", position_unit="um", spacing=1e-6)


def test_a_first_row_or_column_of_positions_or_numbers(tmp_path):
    first_row = ["\t".join(f"{0.5 * i:g}" for i in range(12)), *matrix()]
    got = read(tmp_path, first_row, height_unit="nm", position_unit="um")
    np.testing.assert_allclose(got.heights, 1e-9 * GRID)
    assert got.spacing == pytest.approx(0.5e-6)
    numbers = ["\t".join(str(i) for i in range(1, 13)), *matrix()]
    got = read(tmp_path, numbers, height_unit="nm", spacing=0.5e-6)
    np.testing.assert_allclose(got.heights, 1e-9 * GRID)
    tall = np.vstack([GRID, GRID[::-1], GRID])
    wide = np.hstack([tall, tall])
    counted = [f"{j}\t{line}" for j, line in enumerate(matrix(wide))]
    got = read(tmp_path, counted, height_unit="nm", spacing=0.5e-6)
    np.testing.assert_allclose(got.heights, 1e-9 * wide)
    assert "the first column numbers the points" in got.notes


def test_falling_axes_are_turned_round(tmp_path):
    lines = ["\t".join(["", *(f"{5.5 - 0.5 * i:g}" for i in range(12))])]
    lines += ["\t".join([f"{2.0 * j:g}", *(f"{z:g}" for z in row)]) for j, row in enumerate(GRID)]
    got = read(tmp_path, lines, height_unit="nm", position_unit="um")
    np.testing.assert_allclose(got.heights, 1e-9 * GRID[:, ::-1])


def test_a_tilted_plane_has_no_axes(tmp_path):
    y, x = np.mgrid[0:9, 0:12]
    plane = 3.0 * x + 2.0 * y
    got = read(tmp_path, matrix(plane), height_unit="nm", spacing=1e-6)
    np.testing.assert_allclose(got.heights, 1e-9 * plane)


def test_heights_wrapped_to_lines_are_refused(tmp_path):
    smooth = np.round(1000.0 * np.sin(np.arange(800) / 15.0) + RANDOM.standard_normal(800))
    lines = matrix(smooth.reshape(80, 10), " ")
    with pytest.raises(InputError, match=r"80 lines of 10 heights .* one profile wrapped to lines"):
        read(tmp_path, lines, height_unit="nm", spacing=1e-6)
    with pytest.raises(InputError, match=r"line 1, 'POINTS=800' speaks of 800 points|wrapped"):
        read(tmp_path, ["POINTS=800", *lines], height_unit="nm", spacing=1e-6)
    with pytest.raises(InputError, match=r"line 81, .* has 3 columns, the table has 10"):
        read(tmp_path, [*lines, "1 2 3"], height_unit="nm", spacing=1e-6)


def test_two_tables_are_refused(tmp_path):
    options = {"height_unit": "nm", "spacing": 1e-6}
    with pytest.raises(InputError, match="line 10 between the rows is empty"):
        read(tmp_path, [*matrix(), "", *matrix()], **options)
    with pytest.raises(InputError, match="line 10, 'Second' stands between rows"):
        read(tmp_path, [*matrix(), "Second", *matrix()], **options)
    with pytest.raises(InputError, match="line 31 between the heights is empty"):
        read(tmp_path, [*heights()[:30], "", *heights()[30:]], **options)
    twice = rows()
    with pytest.raises(InputError, match=r"line 61 between the rows is empty"):
        read(tmp_path, [*twice, "", *twice], position_unit="mm", height_unit="um")
    y, x = np.mgrid[0:9, 0:12]
    table = [f"{a} {b} {z:g}" for a, b, z in zip(x.ravel(), y.ravel(), GRID.ravel(), strict=True)]
    with pytest.raises(InputError, match=r"108 rows|216 rows"):
        read(tmp_path, [*table, *table], position_unit="um", height_unit="nm")
    twice_at_a_place = [*table[:-12], *table[:3]]
    with pytest.raises(InputError, match="two heights at one place"):
        read(tmp_path, [*twice_at_a_place, table[-1]], position_unit="um", height_unit="nm")


def test_blank_lines_of_doubled_line_ends_and_of_blocks_of_a_grid_are_nothing(tmp_path):
    same(read(tmp_path, "\r\r\n".join(heights()), height_unit="um", spacing=1e-6))
    y, x = np.mgrid[0:9, 0:12]
    table = []
    for j in range(9):
        table += [f"{a} {b} {z:g}" for a, b, z in zip(x[j], y[j], GRID[j], strict=True)] + [""]
    got = read(tmp_path, table, position_unit="um", height_unit="nm")
    np.testing.assert_allclose(got.heights, 1e-9 * GRID)


def test_heights_one_a_line_of_a_map_whose_sizes_are_stated(tmp_path):
    above = ["# x-pixels = 12", "# y-pixels = 9", "# x-length = 6000", "# y-length = 18000", "# Bit2nm = 0.5"]
    got = read(tmp_path, [*above, *heights(GRID.ravel(), "{:g}")])
    np.testing.assert_allclose(got.heights, 0.5e-9 * GRID)
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 2e-6))


# --- formats by their labels -------------------------------------------------------------------------------------


def test_gwyddion(tmp_path):
    above = ["# Channel: Height", "# Width: 6.000 µm", "# Height: 18.00 µm", "# Value units: m"]
    lines = ["\t".join(f"{1e-9 * z:.6e}" for z in row) for row in GRID]
    got = read(tmp_path, [*above, *lines])
    np.testing.assert_allclose(got.heights, 1e-9 * GRID, rtol=1e-6)
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 2e-6))
    with pytest.raises(InputError, match=r"points is 500 nm by line 2, .* not 1 um"):
        read(tmp_path, [*above, *lines], spacing=1e-6)
    with pytest.raises(InputError, match="line 4, '# Value units: V' says that the numbers are no lengths"):
        read(tmp_path, [*above[:3], "# Value units: V", *lines])


def test_spip(tmp_path):
    above = [
        "# File Format = ASCII",
        "# x-pixels = 12",
        "# y-pixels = 9",
        "# x-length = 6000",
        "# y-length = 18000",
    ]
    got = read(tmp_path, [*above, "# Bit2nm = 0.05", "# Start of Data:", *matrix()])
    np.testing.assert_allclose(got.heights, 0.05e-9 * GRID)
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 2e-6))
    with pytest.raises(InputError, match=r"heights is 0\.05 nm by line 6, .* not nm"):
        read(tmp_path, [*above, "# Bit2nm = 0.05", *matrix()], height_unit="nm")


def test_esri(tmp_path):
    above = ["ncols 12", "nrows 9", "xllcorner 0", "yllcorner 0", "cellsize 0.5", "NODATA_value -9999"]
    grid = GRID.copy()
    grid[2, 3:5] = -9999
    got = read(tmp_path, [*above, *matrix(grid, " ")], position_unit="um", height_unit="nm")
    assert (got.spacing, got.spacing_across, got.missing_points) == (
        pytest.approx(0.5e-6),
        pytest.approx(0.5e-6),
        2,
    )
    assert np.isnan(got.heights[2, 3])
    with pytest.raises(InputError, match=r"cellsize 0.5"):
        read(tmp_path, [*above, *matrix(grid, " ")], position_unit="um", height_unit="nm", spacing=1e-6)


def test_mahr(tmp_path):
    above = ["PROFILE=D", "POINTS=60", "DX=1.5 um", "RES=0.0125 um"]
    got = read(tmp_path, [*above, *heights(COUNTS, "{:g}")])
    same(got, 0.0125e-6 * COUNTS)
    assert got.spacing == pytest.approx(1.5e-6)


def wyko(real=0, mult=1, blocks=1):
    """A map of 9 rows and 12 columns as Vision exports it: a line for each column, in waves or in nm."""
    scale = 1.0 if real else 1.0 / 635.3 * mult
    lines = [
        f"Wyko ASCII Data File Format\t0\t{real}\t1",
        "X Size\t12",
        "Y Size\t9",
        "Block Name\tType\tLength\tAttributes",
    ]
    lines += [
        "Wavelength\t7\t4\t635.3",
        "Aspect\t7\t4\t4",
        "Pixel_size\t7\t4\t0.0005",
        f"Mult\t6\t2\t{mult}",
    ]
    for name in ("RAW_DATA", "Intensity")[:blocks]:
        lines.append(f"{name}\t3\t432")
        lines += [
            "\t".join("Bad" if (i, j) == (4, 2) else f"{scale * z:.9g}" for j, z in enumerate(row))
            for i, row in enumerate(GRID.T)
        ]
    return lines


@pytest.mark.parametrize("made", [{}, {"real": 1}, {"mult": 100}, {"blocks": 2}])
def test_wyko(tmp_path, made):
    got = read(tmp_path, wyko(**made), name="map.asc")
    expected = 1e-9 * GRID
    expected[2, 4] = np.nan
    np.testing.assert_allclose(got.heights, expected, rtol=1e-7, atol=1e-15)
    assert (got.spacing, got.spacing_across) == pytest.approx((2e-6, 0.5e-6))
    with pytest.raises(InputError, match="has its units, not mm"):
        read(tmp_path, wyko(**made), height_unit="mm")


def test_zygo(tmp_path):
    head = ["Zygo XYZ Data File - Format 2", '0 0 0 0 0 " "', "0 0 0 0 0 0", "0 0 12 9", '" "', '" "', '" "']
    head += ["0 0.5 6.328e-07 0 1 0 5e-07 1234567890", *(["0 0 0 0"] * 6), "#"]
    y, x = np.mgrid[0:9, 0:12]
    table = [
        f"{a} {b} No Data" if (a, b) == (3, 2) else f"{a} {b} {1e-3 * z:.6f}"
        for a, b, z in zip(x.ravel(), y.ravel(), GRID.ravel(), strict=True)
    ]
    got = read(tmp_path, [*head, *table, "#"], name="map.xyz")
    expected = 1e-9 * GRID
    expected[2, 3] = np.nan
    np.testing.assert_allclose(got.heights, expected, rtol=1e-6)
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 0.5e-6))
    counts = " ".join(f"{z:g}" for z in GRID.ravel())
    with pytest.raises(InputError, match=r"Zygo.*ten heights a line"):
        read(tmp_path, ["Zygo ASCII Data File - Format 2", *head[1:-1], counts, "#"], name="map.asc")


def test_imagej(tmp_path):
    lines = [f"{i},{row}" for i, row in enumerate(rows(), start=1)]
    same(read(tmp_path, [" ,Distance_(mm),Gray_Value", *lines], height_unit="um"))


# --- encodings and signs -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("encoding", ["utf-16", "utf-8-sig", "latin-1", "utf-16-le"])
def test_encodings(tmp_path, encoding):
    text = "x [mm],z [µm]\n" + "\n".join(rows()) + "\n"
    if encoding == "utf-16-le":
        with pytest.raises(InputError, match="UTF-8"):
            read(tmp_path, text, encoding=encoding)
        return
    same(read(tmp_path, text, encoding=encoding))


@pytest.mark.parametrize("sign", [";", "\t", "  "])
def test_decimal_commas_and_two_decimal_signs(tmp_path, sign):
    lines = [row.replace(".", ",") for row in rows(sign=sign)]
    options = {"position_unit": "mm", "height_unit": "um"}
    same(read(tmp_path, lines, **options))
    lines[40] = f"{0.06:.4f}".replace(".", ",") + f"{sign}1.234"
    with pytest.raises(InputError, match=r"line 41 holds '1.234', a point in a table of decimal commas"):
        read(tmp_path, lines, **options)
    lines = rows(sign=sign)
    lines[40] = f"0.0600{sign}1,234.5"
    with pytest.raises(InputError, match=r"line 41 holds '1,234.5', a comma in a table of decimal points"):
        read(tmp_path, lines, **options)


def test_commas_with_and_without_a_blank_are_refused(tmp_path):
    with pytest.raises(InputError, match="commas with and without a blank"):
        read(tmp_path, [f"{i},5, {i % 7},25" for i in range(20)], height_unit="um", spacing=1e-6)


def test_typographic_minus(tmp_path):
    same(read(tmp_path, [MM, *(row.replace("-", "−") for row in rows())]))


# --- ranges that were exceeded, and files that disagree ------------------------------------------------------------


def test_a_range_that_was_exceeded_is_said(tmp_path):
    wave = np.round(1000.0 * np.sin(np.arange(600) / 30.0) + 3.0 * RANDOM.standard_normal(600))
    got = read(tmp_path, heights(wave, "{:g}"), height_unit="nm", spacing=1e-6)
    assert not any("exceeded" in note for note in got.notes)
    got = read(tmp_path, heights(np.minimum(wave, 700.0), "{:g}"), height_unit="nm", spacing=1e-6)
    assert [note[:4] for note in got.notes if "exceeded" in note] == [f"{100 * np.mean(wave >= 700):.3g}"[:4]]


def test_ordinary_surfaces_are_not_suspicious(tmp_path):
    for values in (
        np.round(RANDOM.standard_normal(500), 1),
        np.abs(RANDOM.standard_normal(500)),
        np.zeros(80) + 0.5,
    ):
        got = read(tmp_path, heights(values), height_unit="um", spacing=1e-6)
        assert not any("exceeded" in note for note in got.notes)


# --- what two readings of the same signs would make of it ------------------------------------------------------------


@pytest.mark.parametrize(("sign", "decimal"), [(".", "point"), (",", "comma")])
def test_signs_that_may_part_thousands_are_asked_for(tmp_path, sign, decimal):
    counts = (2.0 * COUNTS).astype(int)
    grouped = [f"{z:,}".replace(",", sign) for z in counts]
    assert any(sign in z for z in grouped)
    lines = ["x [um];z [nm]", *(f"{i};{z}" for i, z in enumerate(grouped))]
    with pytest.raises(InputError, match="sign between its thousands") as refused:
        read(tmp_path, lines)
    assert refused.value.options == ("decimal",)
    as_stated = [float(z.replace(sign, ".")) for z in grouped]
    same(read(tmp_path, lines, decimal=decimal), 1e-9 * np.array(as_stated))
    printed = [
        f"{i};{z:g}".replace(".", sign) for i, z in enumerate(COUNTS / 1000.0)
    ]  # 0.5 and 1.25 are no thousands
    same(read(tmp_path, ["x [um];z [um]", *printed]))


def test_decimal_commas_in_quotes_between_commas(tmp_path):
    lines = [
        "x [mm],z [um]",
        *(
            f'"{0.0015 * i:.4f}","{z:.4f}"'.replace(".", ",").replace('","', "|").replace("|", '","')
            for i, z in enumerate(COUNTS / 1000.0)
        ),
    ]
    got = read(tmp_path, lines)
    same(got)
    assert got.spacing == pytest.approx(1.5e-6)


@pytest.mark.parametrize("heading", ["Z x10 [um]", "Z*1000 [um]"])
def test_a_factor_in_a_name_is_asked_for(tmp_path, heading):
    lines = [f"x [mm],{heading}", *rows()]
    with pytest.raises(InputError, match="not understood"):
        read(tmp_path, lines)
    same(read(tmp_path, lines, height_unit="um"))


@pytest.mark.parametrize("line", ["Z scale = 0.05", "Height scale factor,0.1", "Z-Factor: 2 counts"])
def test_a_factor_without_a_unit_is_asked_for_and_then_said(tmp_path, line):
    with pytest.raises(InputError, match=r"line 1, .* may be a factor of the heights") as refused:
        read(tmp_path, [line, MM, *rows()])
    assert refused.value.options == ("height-unit",)
    got = read(tmp_path, [line, MM, *rows()], height_unit="um")
    same(got)
    assert any("line 1" in note and "is not used" in note for note in got.notes)


def test_a_scale_per_division_is_no_height_of_a_count(tmp_path):
    with pytest.raises(InputError, match="does not name the unit of its heights"):
        read(tmp_path, ["Z scale: 20 nm/div", "Spacing: 1 um", *heights()])


@pytest.mark.parametrize("above", [["Traverse length mm", "z"], ["Filter length in mm", "Heights"]])
def test_the_heading_of_one_column_is_the_last_line_of_words(tmp_path, above):
    with pytest.raises(InputError, match="does not name the unit of its heights"):
        read(tmp_path, [*above, *heights()], spacing=1e-6)
    same(read(tmp_path, [*above, *heights()], spacing=1e-6, height_unit="um"))


# --- rows and columns that are missing as a whole --------------------------------------------------------------------


@pytest.mark.parametrize("mark", ["***", "---", "", "nan", "Bad"])
def test_a_round_aperture_keeps_its_rows_and_columns(tmp_path, mark):
    y, x = np.mgrid[0:9, 0:12]
    grid = np.where(((x - 5.5) / 5.0) ** 2 + ((y - 4.0) / 3.2) ** 2 > 1.0, np.nan, GRID)
    assert np.isnan(grid[0]).all()
    assert np.isnan(grid[-1]).all()
    lines = ["\t".join(mark if np.isnan(z) else f"{z:g}" for z in row) for row in grid]
    above = ["# Channel: Z", "# Width: 12 um", "# Height: 9 um", "# Value units: nm"]
    got = read(tmp_path, [*above, *lines])
    same(got, 1e-9 * grid)
    assert (got.spacing, got.spacing_across) == pytest.approx((1e-6, 1e-6))


def test_columns_that_are_empty_everywhere_are_missing_unless_longer_lines_pad_them(tmp_path):
    lines = [f"{row},,," for row in matrix(sign=",")]
    got = read(tmp_path, lines, height_unit="nm", spacing=1e-6)
    assert got.heights.shape == (9, 15)
    assert np.isnan(got.heights[:, 12:]).all()
    padded = ["a,b,c,d,e,f,g,h,i,j,k,l,m,n,o", *lines]
    same(read(tmp_path, padded, height_unit="nm", spacing=1e-6), 1e-9 * GRID)


# --- two surfaces in one file ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("above", "between"),
    [
        (["# Channel: Z", "# Value units: nm"], ["", "# Channel: Z2", "# Value units: nm"]),
        (["#1"], ["#2"]),
        (["# first"], ["# second"]),
    ],
)
def test_two_maps_that_comments_part_are_refused(tmp_path, above, between):
    with pytest.raises(InputError, match=r"two (tables|maps)|stands between the heights"):
        read(tmp_path, [*above, *matrix(), *between, *matrix()], height_unit="nm", spacing=1e-6)


def test_two_profiles_that_comments_part_are_refused(tmp_path):
    with pytest.raises(InputError, match=r"line 62, '# second profile' stands between the heights"):
        read(tmp_path, ["z [um]", *heights(), "# second profile", *heights()], spacing=1e-6)
    with pytest.raises(InputError, match="states what a line above them does"):
        read(tmp_path, ["# profile 1", f"# {MM}", *rows(), "# profile 2", f"# {MM}", *rows()])
    commented = [*rows()[:30], "# break", *rows()[30:]]  # the positions go on
    got = read(tmp_path, [MM, *commented])
    same(got)
    assert any("line 32, '# break'" in note for note in got.notes)


# --- columns ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "good"),
    [
        ("not valid", 0),
        ("Non-valid", 0),
        ("unvalid", 0),
        ("outlier", 0),
        ("Bad", 0),
        ("ok", 1),
        ("gültig", 1),
    ],
)
def test_flags_by_other_names(tmp_path, name, good):
    lines = [f"{MM},{name}", *(f"{row},{good if i % 10 else 1 - good}" for i, row in enumerate(rows()))]
    expected = np.where(np.arange(60) % 10, 1e-9 * COUNTS, np.nan)
    same(read(tmp_path, lines), expected)


@pytest.mark.parametrize("name", ["flag", "mask", "status"])
def test_a_flag_of_unknown_sense_is_asked_for(tmp_path, name):
    lines = [f"{MM},{name}", *(f"{row},{int(i == 7)}" for i, row in enumerate(rows()))]
    with pytest.raises(InputError, match=rf"column 3 '{name}' holds 0 and 1 alone"):
        read(tmp_path, lines)
    same(read(tmp_path, lines, column="height"))


def test_columns_without_use_are_named(tmp_path):
    got = read(tmp_path, [f"{MM},Quality [%]", *(f"{row},{90 + i % 7}" for i, row in enumerate(rows()))])
    same(got)
    assert "column 3 'Quality [%]' is not used" in got.notes


@pytest.mark.parametrize(("row", "place"), [("row", "column"), ("Zeile", "Spalte"), ("line", "pixel")])
def test_numbers_of_rows_and_of_places_in_them(tmp_path, row, place):
    y, x = np.mgrid[0:9, 0:12]
    lines = [
        f"{row},{place},height [nm]",
        *(f"{a},{b},{z:g}" for a, b, z in zip(y.flat, x.flat, GRID.flat, strict=True)),
    ]
    got = read(tmp_path, lines, spacing=2e-6)
    same(got, 1e-9 * GRID)


def test_i_and_j_are_asked_for(tmp_path):
    y, x = np.mgrid[0:9, 0:12]
    lines = ["i,j,z [nm]", *(f"{a},{b},{z:g}" for a, b, z in zip(y.flat, x.flat, GRID.flat, strict=True))]
    with pytest.raises(InputError, match="which of the columns 'i' and 'j' numbers the rows"):
        read(tmp_path, lines, spacing=1e-6)


@pytest.mark.parametrize("name", ["Punkt", "Pkt.", "Messpunkt", "Count", "Record", "Sample No."])
def test_numbers_of_points_before_positions(tmp_path, name):
    lines = [f"{name};Länge [mm];Tiefe [µm]", *(f"{i + 1};{row}" for i, row in enumerate(rows(sign=";")))]
    for option in ({}, {"column": "3"}):
        got = read(tmp_path, lines, **option)
        same(got)
        assert got.spacing == pytest.approx(1.5e-6)


def test_a_time_is_no_position(tmp_path):
    lines = ["t [s];s [mm];h [µm]", *(f"{0.02 * i:.2f};{row}" for i, row in enumerate(rows(sign=";")))]
    got = read(tmp_path, lines)
    same(got)
    assert got.spacing == pytest.approx(1.5e-6)


def test_a_chosen_column_of_two_has_no_position_beside_it(tmp_path):
    lines = ["Left [um],Right [um]", *(f"{z / 2000.0:.4f},{z / 1000.0:.4f}" for z in COUNTS)]
    same(read(tmp_path, lines, column="2", spacing=1e-6))
    same(read(tmp_path, lines, column="1", spacing=1e-6), 5e-10 * np.round(COUNTS / 0.2) * 0.2)


def test_a_grid_of_one_line_is_a_profile(tmp_path):
    lines = ["x [mm],y [mm],z [um]", *(row.replace(",", ",0.25,") for row in rows())]
    got = read(tmp_path, lines)
    same(got)
    assert got.spacing == pytest.approx(1.5e-6)


# --- sizes of a map --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "stated", [["dx 0.5", "dy 1.0"], ["X length: 6", "Y length: 9"], ["dx = 2", "line spacing = 4"]]
)
def test_sizes_without_a_unit_keep_their_ratio_beside_a_stated_spacing(tmp_path, stated):
    got = read(tmp_path, [*stated, *matrix()], height_unit="nm", spacing=0.5e-6)
    same(got, 1e-9 * GRID)
    assert (got.spacing, got.spacing_across) == pytest.approx((0.5e-6, 1e-6))


@pytest.mark.parametrize("names", [("Breite", "Höhe"), ("Largeur", "Hauteur")])
def test_width_and_height_in_other_languages(tmp_path, names):
    above = [f"# {names[0]}: 24,0 µm", f"# {names[1]}: 36,0 µm"]
    got = read(tmp_path, [*above, *matrix()], height_unit="nm")
    assert (got.spacing, got.spacing_across) == pytest.approx((2e-6, 4e-6))


@pytest.mark.parametrize(("x", "y"), [(1.0, 2.0), (2.0, 1.0)])
def test_an_axis_that_counts_beside_one_with_positions_is_one_of_positions(tmp_path, x, y):
    lines = ["\t".join(["0", *(f"{x * j:g}" for j in range(12))])]
    lines += [f"{y * i:g}\t{row}" for i, row in enumerate(matrix())]
    got = read(tmp_path, lines, height_unit="nm", position_unit="um")
    same(got, 1e-9 * GRID)
    assert (got.spacing, got.spacing_across) == pytest.approx((x * 1e-6, y * 1e-6))


def test_a_corner_that_names_the_heights_has_their_unit(tmp_path):
    def lines(corner):
        first = ";".join([corner, *(f"{0.5 * j:g}" for j in range(12))])
        return [first, *(f"{0.5 * i:g};{row}" for i, row in enumerate(matrix(sign=";")))]

    got = read(tmp_path, lines("Height [nm]"), position_unit="um")
    same(got, 1e-9 * GRID)
    assert got.spacing == pytest.approx(0.5e-6)
    with pytest.raises(InputError, match="does not name the unit of its positions"):
        read(tmp_path, lines("Height [nm]"))
    with pytest.raises(InputError, match="names heights and positions"):
        read(tmp_path, lines("z (nm), x/y (um)"))


def test_a_grid_of_surfer_is_refused(tmp_path):
    with pytest.raises(InputError, match="grid of Surfer"):
        read(
            tmp_path, ["DSAA", "12 9", "0 11", "0 16", "-500 500", *matrix()], height_unit="nm", spacing=1e-6
        )


# --- counts and marks ------------------------------------------------------------------------------------------------


def test_counts_of_missing_points_are_no_marks(tmp_path):
    values = np.where(np.arange(60) % 20 == 3, 0.0, COUNTS / 1000.0)
    for line in ("NoData: 0 points", "Missing: 5"):
        got = read(tmp_path, [line, MM, *rows(values)])
        assert np.isfinite(got.heights).all()
    with pytest.raises(InputError, match="may count the missing points, or say that 0 marks them") as refused:
        read(tmp_path, ["No data: 0", MM, *rows(values)])
    assert refused.value.options == ("no-data",)
    assert np.isnan(read(tmp_path, ["No data: 0", MM, *rows(values)], no_data="0").heights[3])
    assert np.isfinite(read(tmp_path, ["No data: 0", MM, *rows(values)], no_data="none").heights).all()


def test_two_marks_of_missing_points(tmp_path):
    values = COUNTS / 1000.0
    values = np.where(np.arange(60) % 20 == 3, -9999.0, np.where(np.arange(60) % 20 == 5, 9999.0, values))
    with pytest.raises(InputError, match="3 points have exactly the lowest height"):
        read(tmp_path, [MM, *rows(values)], any_size=True)
    got = read(tmp_path, [MM, *rows(values)], no_data="-9999, 9999")
    assert np.flatnonzero(np.isnan(got.heights)).tolist() == [3, 5, 23, 25, 43, 45]


@pytest.mark.parametrize("line", ["Number of points: 60", "Columns: 2", "Points,60"])
def test_counts_that_agree(tmp_path, line):
    same(read(tmp_path, [line, MM, *rows()]))


def test_a_count_with_a_sign_between_thousands(tmp_path):
    values = np.tile(COUNTS / 1000.0, 20)
    got = read(tmp_path, ["Number of points: 1,200", MM, *rows(values)])
    assert got.heights.size == 1200
