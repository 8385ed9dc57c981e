"""Columns of numbers in their dialects, bare arrays, and measured text files with the numbers known about them."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.height_parameters import height_parameters
from asperity.surface.levelling import levelled
from asperity.surface.measure_files import read_surface

X = np.arange(50) * 0.25
Z = np.round(np.sin(X), 4)


@pytest.mark.parametrize("end", ["\n", "\r", "\r\n"])
@pytest.mark.parametrize(
    ("separator", "comma"),
    [("\t", False), (";", False), (",", False), ("  ", False), (";", True), ("\t", True)],
)
def test_line_ends_separators_and_decimal_signs(tmp_path, end, separator, comma):
    rows = [f"{x:.2f}{separator}{z:.4f}" for x, z in zip(X, Z, strict=True)]
    if comma:
        rows = [row.replace(".", ",") for row in rows]
    file = tmp_path / "p.txt"
    file.write_bytes(end.join(rows).encode())
    got = read_surface(path=file, position_unit="mm", height_unit="um")
    np.testing.assert_allclose(got.heights, 1e-6 * Z, atol=1e-15)
    assert got.spacing == pytest.approx(0.25e-3)


def test_heading_names_the_units_and_missing_values_are_counted(tmp_path):
    file = tmp_path / "p.csv"
    file.write_text("machine 7\nX [mm];Z [nm]\n" + "".join(f"{x};{z}\n" for x, z in zip(X, Z, strict=True)))
    assert read_surface(path=file).heights[3] == pytest.approx(1e-9 * Z[3], rel=1e-9, abs=0.0)
    file.write_text(file.read_text() + "12.5;NaN\n12.75;\n13.0;0.1\n")
    assert read_surface(path=file).missing_points == 2


def test_rounded_positions_give_the_true_spacing_and_unequal_ones_are_refused(tmp_path):
    file = tmp_path / "p.txt"
    true = 0.156 * np.arange(500)
    np.savetxt(file, np.stack([np.round(true, 1), np.sin(true)], axis=1), fmt="%.4f")
    got = read_surface(path=file, position_unit="um", height_unit="um")
    assert got.spacing == pytest.approx(0.156e-6, rel=1e-4)
    assert "rounded" in got.notes[0]
    np.savetxt(file, np.stack([true**1.1, np.sin(true)], axis=1), fmt="%.4f")
    with pytest.raises(InputError, match="not equally spaced"):
        read_surface(path=file, position_unit="um", height_unit="um")


def test_columns_of_heights_xyz_grids_and_npy(tmp_path):
    random = np.random.default_rng(0)
    grid = random.standard_normal((6, 5))
    np.savetxt(tmp_path / "m.txt", grid)
    got = read_surface(path=tmp_path / "m.txt", height_unit="um", spacing=2e-6)
    np.testing.assert_allclose(got.heights, 1e-6 * grid)
    x, y = np.meshgrid(np.arange(5) * 2.0, np.arange(6) * 3.0)
    table = np.stack([x.ravel(), y.ravel(), grid.ravel()], axis=1)
    np.savetxt(tmp_path / "xyz.txt", table[random.permutation(30)])
    got = read_surface(path=tmp_path / "xyz.txt", position_unit="um", height_unit="um")
    np.testing.assert_allclose(got.heights, 1e-6 * grid)
    assert (got.spacing, got.spacing_across) == pytest.approx((2e-6, 3e-6))
    np.save(tmp_path / "a.npy", grid)
    got = read_surface(path=tmp_path / "a.npy", height_unit="nm", spacing=1e-6)
    np.testing.assert_allclose(got.heights, 1e-9 * grid)
    with pytest.raises(InputError, match="and the distance of its points"):
        read_surface(path=tmp_path / "a.npy", height_unit="nm")


def test_the_spacing_before_the_heights_is_no_height(tmp_path):
    """Text files of NIST's SMATS and of NPL's softgauges: the spacing, then the heights, one a line, in micrometres."""
    file = tmp_path / "reference.txt"
    file.write_bytes("\r\n".join(["0.500", *(f"{z:.6f}" for z in Z)]).encode())
    got = read_surface(path=file, height_unit="um", spacing=0.5e-6)
    np.testing.assert_allclose(got.heights, 1e-6 * Z, atol=1e-15)
    assert "the first number is the spacing" in got.notes[0]
    assert len(read_surface(path=file, height_unit="um", spacing=0.4e-6).heights) == 51
    with pytest.raises(InputError, match="in text files of NIST and NPL their first number"):
        read_surface(path=file, height_unit="um")


def test_a_grid_of_positions_may_have_gaps_in_half_of_its_places_but_none_twice(tmp_path):
    x, y = np.meshgrid(np.arange(5) * 2.0, np.arange(6) * 3.0)
    table = np.stack([x.ravel(), y.ravel(), np.arange(30.0)], axis=1)
    chosen = [*range(0, 30, 2)]  # 15 places, every column and row among them
    np.savetxt(tmp_path / "half.txt", table[chosen])
    units = {"position_unit": "um", "height_unit": "nm"}
    got = read_surface(path=tmp_path / "half.txt", **units)
    assert (got.heights.shape, got.missing_points) == ((6, 5), 15)
    assert got.heights.ravel()[4] == pytest.approx(4e-9)
    for rows, name in ((chosen[:-1], "less.txt"), ([*range(30), 7], "twice.txt")):
        np.savetxt(tmp_path / name, table[rows])
        with pytest.raises(InputError, match=rf"{len(rows)} rows do not fill 5 by 6 places"):
            read_surface(path=tmp_path / name, **units)


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"", "is empty"),
        (b"0 1\n1 2\n2 3\n3 4\n4 x5\n", "not a number"),
        (b"1,5\n2,5\n3,5\n", "decimal comma"),
        (b"0 1\n1 2\n2 3\n", "name the unit"),
        (b"1 0.1\n1 0.2\n1 0.3\n1 0.2\n", "all positions are 1"),
        (b"<?xml version='1.0'?>\n<p>0 1</p>\n", "is XML"),
        (b"0 nan\n1 nan\n2 nan\n", "no valid height"),
    ],
)
def test_wrong_files_get_one_clear_message(tmp_path, content, says):
    file = tmp_path / "w.txt"
    file.write_bytes(content)
    units = {} if says == "name the unit" else {"position_unit": "mm", "height_unit": "um"}
    with pytest.raises(InputError, match=says):
        read_surface(path=file, **units)


def test_signalling_numbers_in_an_array_are_missing_points(tmp_path):
    z = np.zeros(64)
    z.view(np.uint64)[3] = 0x7FF0000000000001
    z[4] = 1e-7
    np.save(tmp_path / "a.npy", z)
    assert read_surface(path=tmp_path / "a.npy", height_unit="m", spacing=1e-6).missing_points == 1


# Numbers of the SOURCE.txt files: asserted in SurfaceTopography's own tests, or printed by the instrument.
EXAMPLES = "surfacetopography_examples"


def test_dektak_header_values(shared_data):
    got = read_surface(path=shared_data / EXAMPLES / "dektak-1.csv")
    assert got.spacing == pytest.approx(0.156e-6, rel=5e-3)  # the header prints 0.156 um/sample
    part = levelled(topography=got.cut(start=468e-6, stop=733e-6), form="line")
    h = height_parameters(topography=part)
    assert round(1e6 * h.arithmetic_mean, 5) == 0.00525
    assert round(1e6 * h.root_mean_square, 5) in (0.01143, 0.01144)  # header 0.01143; the ends are rounded
    assert h.skewness == pytest.approx(6.96, abs=0.01)


@pytest.mark.parametrize(
    ("name", "spacing_um", "rms_um"),
    [("81212-RE-1", 1.166, 0.097), ("NU206-RE-1", 1.240, 0.127), ("NU206-IR-1", 1.736, 0.139)],
)
def test_bearing_profiles_with_carriage_returns(shared_data, name, spacing_um, rms_um):
    got = read_surface(
        path=shared_data / "bearing_roller_profiles" / f"{name}.txt", position_unit="mm", height_unit="um"
    )
    assert 1e6 * got.spacing == pytest.approx(spacing_um, rel=1e-3)
    middle = got.cut(start=0.3 * got.size[0], stop=0.7 * got.size[0])
    flat = levelled(topography=middle, form="polynomial", degree=2)
    assert 1e6 * height_parameters(topography=flat).root_mean_square == pytest.approx(rms_um, abs=0.004)


def test_positions_too_large_for_their_squares_are_refused_without_a_warning(tmp_path):
    file = tmp_path / "a.csv"
    file.write_text("x [mm];z [um]\n" + "\n".join(f"{i};{i % 3}" for i in range(20)) + "\n1e308;1\n")
    with pytest.raises(InputError, match="must be positive"):
        read_surface(path=file)
