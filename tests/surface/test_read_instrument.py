"""Instrument formats: sizes and units that a reader mistakes are found out; files with the numbers known about them."""

import struct
import sys

import numpy as np
import pytest

from asperity.errors import InputError, MissingExtraError
from asperity.surface import read_instrument
from asperity.surface.file_formats import MEBIBYTE
from asperity.surface.height_parameters import height_parameters
from asperity.surface.levelling import levelled
from asperity.surface.measure_files import read_surface


def test_without_the_extra_the_message_says_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    (tmp_path / "a.sdf").write_bytes(b"\0\1\2\3" * 50)
    with pytest.raises(MissingExtraError, match=r"pip install '(asperity|\.)\[surface\]'"):
        read_surface(path=tmp_path / "a.sdf")


class Sizeless:
    """A reader that opens a file and has no size for it, or cannot say one."""

    channels = (1,)
    format = staticmethod(lambda: "sur")

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


def test_a_format_without_a_signature_is_not_guessed(tmp_path):
    """Any file of 2 n^2 bytes is a map of the Earth to one reader of the package."""
    pytest.importorskip("SurfaceTopography")
    (tmp_path / "a.bin").write_bytes(b"\0\1" * 1201**2)
    with pytest.raises(InputError, match=r"a\.bin \(BIN\) cannot be read"):
        read_surface(path=tmp_path / "a.bin")


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


@pytest.mark.parametrize(
    ("name", "content", "says"),
    [
        ("a.gwy", b"GWYP\1\2\3" * 20, "Gwyddion GWY"),
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


def test_a_file_of_zeros_is_refused_at_once(tmp_path):
    """Sparse, of 1 GiB: no reader has to go through it."""
    file = tmp_path / "a.dat"
    with file.open("wb") as stream:
        stream.truncate(1024 * MEBIBYTE)
    with pytest.raises(InputError, match=r"a\.dat begins with 4096 zeros"):
        read_surface(path=file)


def test_a_size_that_is_not_that_of_the_header_is_refused(tmp_path, monkeypatch):
    pytest.importorskip("SurfaceTopography")
    file = text_sdf(tmp_path / "a.sdf")
    monkeypatch.setattr(read_instrument, "_sdf_size", lambda path: (16e-3, 18e-6))
    with pytest.raises(InputError, match=r"1\.6e-05 m where the header of the file says 0\.016 m"):
        read_surface(path=file)


def gwy_text(text):
    return text.encode() + b"\0"


def gwy_object(name, **components):
    """An object of a Gwyddion file: name, size, and components of the kinds that a data field has."""
    body = b""
    for key, value in components.items():
        body += gwy_text(key.replace("__", "/"))
        if isinstance(value, bytes):
            body += b"o" + value
        elif isinstance(value, str):
            body += b"s" + gwy_text(value)
        elif isinstance(value, int):
            body += b"i" + struct.pack("<i", value)
        elif isinstance(value, float):
            body += b"d" + struct.pack("<d", value)
        else:
            body += b"D" + struct.pack("<I", value.size) + value.astype("<f8").tobytes()
    return gwy_text(name) + struct.pack("<I", len(body)) + body


def gwy(path, heights, size, unit="m", height_unit="m", magic=b"GWYP", mask=None):
    """A Gwyddion file of one channel."""

    def field(data, **units):
        rows, columns = data.shape
        return gwy_object(
            "GwyDataField", xres=columns, yres=rows, xreal=size[0], yreal=size[1], **units, data=data.ravel()
        )

    units = {"si_unit_xy": gwy_object("GwySIUnit", unitstr=unit)}
    if height_unit is not None:
        units["si_unit_z"] = gwy_object("GwySIUnit", unitstr=height_unit)
    entries = {"__0__data": field(heights, **units)}
    if mask is not None:
        entries["__0__mask"] = field(mask)
    path.write_bytes(magic + gwy_object("GwyContainer", **entries))
    return path


def test_gwyddion_files_with_units_of_their_own_and_masks(tmp_path):
    pytest.importorskip("SurfaceTopography")
    z = 1e-9 * np.arange(24.0).reshape(4, 6)
    got = read_surface(path=gwy(tmp_path / "a.gwy", z, (6e-6, 8e-6)))
    assert (got.spacing, got.spacing_across) == pytest.approx((1e-6, 2e-6))
    np.testing.assert_allclose(got.heights, z, rtol=1e-12)
    other = read_surface(path=gwy(tmp_path / "b.gwy", 1e9 * z, (6.0, 8.0), unit="µm", height_unit="nm"))
    assert other.size == pytest.approx(got.size)
    np.testing.assert_allclose(other.heights, z, rtol=1e-12)
    masked = read_surface(path=gwy(tmp_path / "c.gwy", z, (6e-6, 8e-6), mask=(z == 0.0).astype(float)))
    assert masked.missing_points == 1
    assert np.isnan(masked.heights[0, 0])


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"height_unit": "V"}, "no channel of heights"),
        ({"height_unit": None}, "no channel of heights"),
        ({"magic": b"GWYO"}, "open it in Gwyddion and save it again"),
    ],
)
def test_gwyddion_files_without_heights_say_so(tmp_path, arguments, says):
    pytest.importorskip("SurfaceTopography")
    with pytest.raises(InputError, match=says):
        read_surface(path=gwy(tmp_path / "a.gwy", np.ones((4, 6)), (6e-6, 8e-6), **arguments))


IMAGE = pytest.importorskip("PIL.Image")


def nanofocus(path, *, pixel=312.5, version=b"OM_MS_2.0", intensity=True, lowest=0, missing_bytes=0):
    """A NanoFocus map of 20 x 16 points whose numbers rise by 100 from 0, heights of 2 to 6 um."""
    head = bytearray(3468)
    struct.pack_into("<iiiidd", head, 0, 2, 1, lowest, 65535, 2.0, 6.0)
    head[32 : 32 + len(version)] = version
    struct.pack_into("<iidd", head, 1368, 20, 16, pixel, 2.0 * pixel)
    struct.pack_into("<i", head, 1416, int(intensity))
    light = np.full(320, 90, dtype=np.uint8)
    light[33] = 0
    content = bytes(head) + (100 * np.arange(320, dtype="<u2")).tobytes() + light.tobytes() * intensity
    path.write_bytes(content[: len(content) - missing_bytes])
    return path


def test_the_length_of_a_nanofocus_pixel_is_in_nanometres(tmp_path):
    """512 pixels of 312.5 nm are the 160 um of an objective; the package takes them for mm."""
    got = read_surface(path=nanofocus(tmp_path / "a.nms"))
    assert got.heights.shape == (16, 20)
    assert (got.spacing, got.spacing_across) == pytest.approx((312.5e-9, 625e-9))
    assert np.flatnonzero(np.isnan(got.heights)).tolist() == [33]
    assert got.heights[2, 5] == pytest.approx(1e-6 * (2.0 + 4.0 * 4500 / 65535))
    whole = read_surface(path=nanofocus(tmp_path / "b.nms", intensity=False))
    assert whole.missing_points == 0


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"version": b"OM_MS_1.0"}, "version OM_MS_2.0"),
        ({"missing_bytes": 1}, "20 x 16 points, 4428 bytes.* it has 4427 bytes"),
        ({"lowest": 70000}, "numbers from 70000 to 65535"),
        ({"pixel": 0.0}, "must be positive"),
        ({"pixel": 5e8}, "its size is 10 m x 16 m"),
    ],
)
def test_damaged_nanofocus_files_are_refused(tmp_path, arguments, says):
    with pytest.raises(InputError, match=says):
        read_surface(path=nanofocus(tmp_path / "a.nms", **arguments))


def tiff(path, numbers, **options):
    IMAGE.fromarray(numbers).save(path, format="TIFF", **options)
    return path


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.int32, np.float32])
@pytest.mark.parametrize("compression", [None, "tiff_lzw"])
def test_grey_levels_times_the_height_of_one(tmp_path, kind, compression):
    numbers = np.arange(30).reshape(5, 6).astype(kind)
    file = tiff(tmp_path / "a.tif", numbers, compression=compression)
    got = read_surface(path=file, height_unit="2.5 nm", spacing=1e-6)
    np.testing.assert_allclose(got.heights, 2.5e-9 * numbers.astype(float), rtol=1e-12)
    assert got.size == pytest.approx((6e-6, 5e-6))


def test_heights_in_a_float_image_may_be_missing(tmp_path):
    numbers = np.ones((5, 6), dtype=np.float32)
    numbers[2, 3] = np.nan
    assert (
        read_surface(path=tiff(tmp_path / "a.tif", numbers), height_unit="nm", spacing=1e-6).missing_points
        == 1
    )


def test_an_image_that_is_no_map_of_heights_is_refused(tmp_path):
    grey = np.arange(30, dtype=np.uint16).reshape(5, 6)
    colour = np.zeros((5, 6, 3), dtype=np.uint8)
    pair = {"save_all": True, "append_images": [IMAGE.fromarray(grey)]}
    for numbers, options, says in ((colour, {}, "3 channel"), (grey, pair, "2 image")):
        with pytest.raises(InputError, match=says):
            read_surface(path=tiff(tmp_path / "a.tif", numbers, **options), height_unit="nm", spacing=1e-6)
    with pytest.raises(InputError, match="the height of one level") as caught:
        read_surface(path=tiff(tmp_path / "b.tif", grey), spacing=1e-6)
    assert caught.value.options == ("height-unit", "spacing")
    with pytest.raises(InputError, match="positive length"):
        read_surface(path=tmp_path / "b.tif", height_unit="-1 nm", spacing=1e-6)
    (tmp_path / "c.tif").write_bytes((tmp_path / "b.tif").read_bytes()[:20])
    with pytest.raises(InputError, match="TIFF"):
        read_surface(path=tmp_path / "c.tif", height_unit="nm", spacing=1e-6)
    content = (tmp_path / "b.tif").read_bytes()
    (tmp_path / "d.tif").write_bytes(content[:8] + bytes(len(content) - 8))
    with pytest.raises(InputError, match="TIFF"):
        read_surface(path=tmp_path / "d.tif", height_unit="nm", spacing=1e-6)
    entries = int.from_bytes(content[8:10], "little")  # the header points to the directory of the image at 8
    end = 10 + 12 * entries  # where it points to that of a second image
    (tmp_path / "e.tif").write_bytes(content[:end] + (4).to_bytes(4, "little") + content[end + 4 :])
    with pytest.raises(InputError, match=r"e.tif \(TIFF\) cannot be opened"):
        read_surface(path=tmp_path / "e.tif", height_unit="nm", spacing=1e-6)
