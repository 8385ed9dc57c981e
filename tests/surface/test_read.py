"""Text dialects, bare arrays, wrong files; instrument files with the numbers known about them."""

import struct
import sys
import zipfile

import numpy as np
import pytest

from asperity.errors import InputError, MissingExtraError
from asperity.surface import read_instrument
from asperity.surface.height_parameters import height_parameters
from asperity.surface.levelling import levelled
from asperity.surface.read import read_surface

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
    assert read_surface(path=file).heights[3] == pytest.approx(1e-9 * Z[3])
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


def test_folder_absent_and_huge_files(tmp_path):
    with pytest.raises(InputError, match="folder"):
        read_surface(path=tmp_path)
    with pytest.raises(InputError, match="there is no such file"):
        read_surface(path=tmp_path / "no.txt")
    with (tmp_path / "huge.dat").open("wb") as file:
        file.truncate(5 * 1024**3)
    with pytest.raises(InputError, match="4096 MiB"):
        read_surface(path=tmp_path / "huge.dat")


def test_without_the_extra_the_message_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    (tmp_path / "a.sdf").write_bytes(b"\0\1\2\3" * 50)
    with pytest.raises(MissingExtraError, match=r"pip install '(asperity|\.)\[surface\]'"):
        read_surface(path=tmp_path / "a.sdf")


def profile_text(path, unit_x="mm", unit_z="um", rows=40, step=0.001):
    x = np.arange(rows) * step
    path.write_text(f"X [{unit_x}];Z [{unit_z}]\n" + "".join(f"{a:.6f};{np.sin(a):.6f}\n" for a in x))
    return path


def test_a_unit_that_contradicts_the_heading_is_refused(tmp_path):
    file = profile_text(tmp_path / "p.csv")
    assert read_surface(path=file, height_unit="micron").spacing == pytest.approx(1e-6)
    with pytest.raises(InputError, match="unit of its heights as um, not nm"):
        read_surface(path=file, height_unit="nm")


@pytest.mark.parametrize(
    ("unit_x", "unit_z", "step", "says"),
    [
        ("m", "um", 0.1, "its size is 4 m"),
        ("nm", "pm", 0.001, "its size is 4e-11 m"),
        ("um", "mm", 0.1, "heights span"),
    ],
)
def test_implausible_sizes_are_refused_unless_confirmed(tmp_path, unit_x, unit_z, step, says):
    file = profile_text(tmp_path / "p.csv", unit_x, unit_z, step=step)
    with pytest.raises(InputError, match=says):
        read_surface(path=file)
    assert read_surface(path=file, any_size=True).heights.shape == (40,)


@pytest.mark.parametrize("value", [1e300, 1e60])
def test_heights_that_overflow_are_refused_even_if_any_size_is_accepted(tmp_path, value):
    np.save(tmp_path / "a.npy", np.array([0.0, value, 1.0, -value]))
    with pytest.raises(InputError, match=r"cannot be evaluated|infinite heights"):
        read_surface(path=tmp_path / "a.npy", height_unit="m", spacing=1e-6, any_size=True)


def test_signalling_numbers_in_an_array_are_missing_points(tmp_path):
    z = np.zeros(64)
    z.view(np.uint64)[3] = 0x7FF0000000000001
    z[4] = 1e-7
    np.save(tmp_path / "a.npy", z)
    assert read_surface(path=tmp_path / "a.npy", height_unit="m", spacing=1e-6).missing_points == 1


class Sizeless:
    """A reader that opens a file and has no size for it, or cannot say one."""

    channels = (1,)

    def __init__(self, sizes):
        self.sizes = sizes

    def topography(self):
        return self

    def heights(self):
        return np.zeros((3, 3))

    @property
    def physical_sizes(self):
        if self.sizes == "raises":
            raise TypeError("'NoneType' object is not iterable")
        return self.sizes


@pytest.mark.parametrize(
    ("sizes", "says"),
    [(None, "not given"), ((np.nan, 1.0), "must be positive"), ("raises", "not understood")],
)
def test_a_reader_that_gives_no_size_is_refused(tmp_path, monkeypatch, sizes, says):
    package = pytest.importorskip("SurfaceTopography")
    monkeypatch.setattr(package, "open_topography", lambda _: Sizeless(sizes))
    (tmp_path / "a.dat").write_bytes(b"\0\1\2")
    with pytest.raises(InputError, match=says):
        read_surface(path=tmp_path / "a.dat")


def nanofocus(path, step_mm):
    """A NanoFocus file as the reader package understands it: z range, grid, spacing, 16-bit heights."""
    head = bytearray(3468)
    struct.pack_into("<dd", head, 16, 0.0, 2.0)
    struct.pack_into("<IIdd", head, 1368, 20, 16, step_mm, step_mm)
    data = np.arange(320, dtype="<u2") * 100
    path.write_bytes(bytes(head) + data.tobytes())
    return path


def test_a_reader_that_mistakes_the_unit_is_found_out(tmp_path):
    """Spacing in nm where the reader takes mm: 20 points of 500 nm would be 10 m."""
    pytest.importorskip("SurfaceTopography")
    with pytest.raises(InputError, match=r"its size is 10 m x 8 m.*allow any size"):
        read_surface(path=nanofocus(tmp_path / "a.nms", 500.0))
    assert read_surface(path=nanofocus(tmp_path / "b.nms", 5e-4)).size == pytest.approx((1e-5, 8e-6))


def text_sdf(path, zscale="1e-6", xscale="2e-6"):
    """ISO 25178-71, text variant: heights in units of Zscale [m]."""
    z = np.arange(48)
    path.write_text(
        "aISO-1.0\nManufacID = test\nCreateDate = 010120240000\nModDate = 010120240000\nNumPoints = 8\n"
        f"NumProfiles = 6\nXscale = {xscale}\nYscale = 3e-6\nZscale = {zscale}\nZresolution = -1\n"
        "Compression = 0\nDataType = 6\nCheckType = 0\n*\n" + "\n".join(map(str, z)) + "\n*\n"
    )
    return path


def test_text_sdf_is_read_by_its_signature_with_its_own_scales(tmp_path):
    pytest.importorskip("SurfaceTopography")
    got = read_surface(path=text_sdf(tmp_path / "a.sdf", zscale="1e-7"))
    assert got.heights.shape == (6, 8)
    assert got.size == pytest.approx((16e-6, 18e-6))
    np.testing.assert_allclose(got.heights.ravel(), 1e-7 * np.arange(48), rtol=1e-9, atol=1e-20)
    with pytest.raises(InputError, match="not nm"):
        read_surface(path=text_sdf(tmp_path / "a.sdf", zscale="1e-7"), height_unit="nm")


def x3p(path, kind="SUR", count="8", increment="1e-6", extra="", main=None, links=True):
    link = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>" if links else ""
    axes = "".join(
        f"<C{a}><AxisType>{t}</AxisType><DataType>D</DataType><Increment>{i}</Increment></C{a}>"
        for a, t, i in (("X", "I", increment), ("Y", "I", "2e-6"), ("Z", "A", "1"))
    )
    text = main or (
        "<p:ISO5436_2 xmlns:p='http://www.opengps.eu/2008/ISO5436_2'><Record1><Revision>ISO5436 - 2000"
        f"</Revision><FeatureType>{kind}</FeatureType><Axes>{axes}</Axes></Record1><Record3>"
        f"<MatrixDimension><SizeX>{count}</SizeX><SizeY>6</SizeY><SizeZ>1</SizeZ></MatrixDimension>{link}"
        f"{extra}</Record3></p:ISO5436_2>"
    )
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("main.xml", text)
        archive.writestr("bindata/data.bin", (1e-7 * np.arange(48.0)).tobytes())
    return path


def test_x3p_variants_are_named(tmp_path):
    pytest.importorskip("SurfaceTopography")
    got = read_surface(path=x3p(tmp_path / "a.x3p"))
    assert got.size == pytest.approx((8e-6, 12e-6))
    assert got.heights[1, 0] == pytest.approx(8e-7)
    for arguments, says in (
        ({"links": False, "extra": "<DataList><Datum>1</Datum></DataList>"}, "text inside main.xml"),
        ({"kind": "PRF"}, "feature type 'PRF'"),
        ({"count": "0"}, "0 points"),
        ({"increment": "-1e-6"}, "increment of -1e-6 m"),
        ({"increment": "1e300"}, "its size is 8e\\+300 m"),
        ({"increment": "wide"}, "increment of wide"),
        ({"main": "<open>"}, "not valid XML"),
        ({"count": "9"}, "cannot be read"),
    ):
        with pytest.raises(InputError, match=says):
            read_surface(path=x3p(tmp_path / "a.x3p", **arguments))


def test_a_size_that_is_not_that_of_the_header_is_refused(tmp_path, monkeypatch):
    pytest.importorskip("SurfaceTopography")
    file = x3p(tmp_path / "a.x3p")
    monkeypatch.setattr(read_instrument, "x3p_container", lambda path: (str(path), (8e-3, 12e-6)))
    with pytest.raises(InputError, match=r"8e-06 m where the header of the file says 0\.008 m"):
        read_surface(path=file)


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.gwy", b"GWYP\1\2\3" * 20, "Gwyddion GWY"),
        ("a.nms", b"\0\1\2" * 2000, "NMS"),
        ("a.npy", b"\x93NUMPY\1\0v\0{'descr': '<f8', 'fortran_order': False, (" + b" " * 70 + b"\n", "NumPy"),
        ("b.npy", b"\x93NUMPY\1\0v\0{'descr': '<f8', 'fortran_order': False, 'shape': (99999999999, 9), }"
         + b" " * 40 + b"\n", "NumPy"),
    ],
)  # fmt: skip
def test_damaged_files_get_one_message_that_names_the_format(tmp_path, name, content, says):
    pytest.importorskip("SurfaceTopography")
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=says):
        read_surface(path=tmp_path / name, height_unit="um", spacing=1e-6)


# Numbers of the SOURCE.txt files: asserted in SurfaceTopography's own tests, or printed by the instrument.
EXAMPLES = "surfacetopography_examples"


@pytest.mark.parametrize(
    ("name", "shape", "size", "rms", "tolerance"),
    [
        ("al3d-1.al3d", (296, 200), (87.6054e-6, 129.655992e-6), 7.688266102603082e-06, 1e-6),
        ("metropro-1.dat", (480, 640), (702.8812979e-6, 527.1609734e-6), 7.528822204734589e-08, 1e-6),
        ("x3p-2.x3p", (650, 650), (82.9767e-6, 204.4784e-6), 7.728033273597876e-08, 1e-6),
    ],
)
def test_rms_heights_of_instrument_files(shared_data, name, shape, size, rms, tolerance):
    pytest.importorskip("SurfaceTopography")
    got = read_surface(path=shared_data / EXAMPLES / name)
    assert got.heights.shape == shape
    assert got.size == pytest.approx(size, rel=1e-6)
    assert height_parameters(topography=got).root_mean_square == pytest.approx(rms, rel=tolerance)


def test_zygo_after_curvature_detrend(shared_data):
    pytest.importorskip("SurfaceTopography")
    got = read_surface(path=shared_data / EXAMPLES / "metropro-1.dat")
    flat = levelled(topography=got, form="polynomial", degree=2)
    assert np.sqrt(np.mean(flat.heights**2)) == pytest.approx(3.911386124282179e-09, rel=1e-6)


def test_frt_map_with_undefined_points(shared_data):
    """The published 2.047476e-05 m and 3.463934e-06 m divide by all points, not by the measured ones."""
    pytest.importorskip("SurfaceTopography")
    got = read_surface(path=shared_data / EXAMPLES / "frt-1.frt")
    assert got.heights.shape == (500, 500)
    assert got.size == pytest.approx((0.012, 0.012))
    assert got.missing_points == 76456
    z, total = got.heights[~np.isnan(got.heights)], got.heights.size
    published = np.sqrt(np.sum((z - z.sum() / total) ** 2) / total)
    assert published == pytest.approx(2.047476e-05, rel=1e-6)
    flat = levelled(topography=got, form="polynomial", degree=2).heights
    assert np.sqrt(np.nansum(flat**2) / total) == pytest.approx(3.463934e-06, rel=1e-4)


def test_dektak_pair_is_equal(shared_data):
    pytest.importorskip("SurfaceTopography")
    one = read_surface(path=shared_data / EXAMPLES / "opdx-3.opdx")
    two = read_surface(path=shared_data / EXAMPLES / "opdx-3.txt", position_unit="m", height_unit="m")
    assert one.heights.shape == two.heights.shape == (3001,)
    np.testing.assert_allclose(one.heights, two.heights, rtol=1e-7, atol=1e-16)
    assert one.spacing == pytest.approx(two.spacing, rel=1e-6)


def test_dektak_header_values(shared_data):
    got = read_surface(path=shared_data / EXAMPLES / "dektak-1.csv")
    assert got.spacing == pytest.approx(0.156e-6, rel=5e-3)  # the header prints 0.156 um/sample
    part = levelled(topography=got.cut(start=468e-6, stop=733e-6), form="line")
    h = height_parameters(topography=part)
    assert round(1e6 * h.arithmetic_mean, 5) == 0.00525
    assert round(1e6 * h.root_mean_square, 5) in (0.01143, 0.01144)  # header 0.01143; the ends are rounded
    assert h.skewness == pytest.approx(6.96, abs=0.01)


def test_x3p_in_a_subfolder_with_clutter(shared_data):
    pytest.importorskip("SurfaceTopography")
    got = read_surface(path=shared_data / "csafe_bullet_land_x3p" / "sample-land.x3p")
    assert got.heights.shape == (256, 918)
    assert got.spacing == pytest.approx(2.58e-6)
    assert got.missing_points == 25292


def test_undefined_points_and_valid_flags(shared_data):
    pytest.importorskip("SurfaceTopography")
    sur = read_surface(path=shared_data / EXAMPLES / "sur-2.sur")
    assert sur.heights.shape == (484, 563)
    assert sur.size == pytest.approx((1.9615e-3, 1.6863e-3), rel=1e-4)
    assert sur.missing_points > 0
    hfm = read_surface(path=shared_data / EXAMPLES / "hfm-1.hfm")
    assert hfm.heights.shape == (9600,)
    assert hfm.size == pytest.approx((4.8e-3,))


def test_format_without_a_unit_is_not_guessed(shared_data):
    pytest.importorskip("SurfaceTopography")
    with pytest.raises(InputError, match="name the unit"):
        read_surface(path=shared_data / EXAMPLES / "tmd-1.tmd")
    got = read_surface(path=shared_data / EXAMPLES / "tmd-1.tmd", height_unit="um")
    assert got.size == pytest.approx((18.9566e-6, 18.9566e-6), rel=1e-5)


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
