"""NanoFocus files and TIFF images written here with known heights."""

import struct

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.measure_files import read_surface

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
