"""X3P written here by the standard: heights as text or binary data, missing points, scales; and what is refused."""

import zipfile

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.file_formats import MEBIBYTE
from asperity.surface.measure_files import read_surface

HEIGHTS = 1e-7 * np.arange(48.0)
DATA = "bindata/data.bin"


def container(path, main, entries=None, folder=""):
    """An X3P container of a main.xml and further entries."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(f"{folder}main.xml", main)
        for name, content in (entries or {}).items():
            archive.writestr(f"{folder}{name}", content)
    return path


def description(
    kind="SUR", counts=("8", "6", "1"), increment="1e-6", z="", number="D", axis="I", data=None, flags=""
):
    """A main.xml as in ISO 5436-2:2012; the heights are linked, or ``data``."""
    link = f"<DataLink><PointDataLink>{DATA}</PointDataLink>{flags}</DataLink>"
    return (
        "<?xml version='1.0' encoding='UTF-8'?><p:ISO5436_2 xmlns:p='http://www.opengps.eu/2008/ISO5436_2'><Record1>"
        f"<Revision>ISO5436 - 2000</Revision><FeatureType>{kind}</FeatureType><Axes><CX><AxisType>I</AxisType>"
        f"<DataType>D</DataType><Increment>{increment}</Increment></CX><CY><AxisType>{axis}</AxisType>"
        "<DataType>D</DataType><Increment>2e-6</Increment></CY><CZ><AxisType>A</AxisType>"
        f"<DataType>{number}</DataType>{z}</CZ></Axes></Record1><Record3><MatrixDimension><SizeX>{counts[0]}</SizeX>"
        f"<SizeY>{counts[1]}</SizeY><SizeZ>{counts[2]}</SizeZ></MatrixDimension>{link if data is None else data}"
        "</Record3></p:ISO5436_2>"
    )


def listed(values):
    return "<DataList>" + "".join(f"<Datum>{value}</Datum>" for value in values) + "</DataList>"


def binary(path, content=None, **arguments):
    return container(
        path, description(**arguments), {DATA: HEIGHTS.tobytes() if content is None else content}
    )


def test_binary_heights_are_rows_along_y(tmp_path):
    got = read_surface(path=binary(tmp_path / "a.x3p"))
    assert got.heights.shape == (6, 8)
    assert got.size == pytest.approx((8e-6, 12e-6))
    np.testing.assert_allclose(got.heights.ravel(), HEIGHTS)


def test_heights_as_text_as_in_the_first_sample_of_the_standard(tmp_path):
    """Sixteen heights, an empty Datum at the eighth: a missing point; no increment of z, which is then 1."""
    values = [str(1e-7 * i) for i in range(16)]
    values[7] = ""
    main = description(counts=("4", "4", "1"), data=listed(values))
    got = read_surface(path=container(tmp_path / "a.x3p", main))
    assert got.heights.shape == (4, 4)
    assert got.missing_points == 1
    assert np.isnan(got.heights[1, 3])
    assert got.heights[2, 1] == pytest.approx(9e-7)


def test_integers_as_text_as_in_the_fourth_sample_of_the_standard(tmp_path):
    """Increment 0.001 and offset -0.5, in um here: 986 is 0.486; of positions and height the last counts."""
    counts = [986, 503, -308, -80, 1358, 1548, 1519, 0, 1324]
    scale = "<Increment>1e-9</Increment><Offset>-0.5e-6</Offset>"
    main = description(counts=("3", "3", "1"), z=scale, number="I", data=listed([f"0;0;{n}" for n in counts]))
    got = read_surface(path=container(tmp_path / "a.x3p", main))
    np.testing.assert_allclose(got.heights.ravel(), 1e-6 * (1e-3 * np.array(counts) - 0.5), atol=1e-18)


def test_integers_as_binary_data_with_flags(tmp_path):
    """Flags are bits, the lowest first: point 9 is missing."""
    bits = np.ones(48, dtype=np.uint8)
    bits[9] = 0
    main = description(
        z="<Increment>1e-7</Increment><Offset/>",
        number="I",
        flags="<ValidPointsLink>./bindata/valid.bin</ValidPointsLink>",
    )
    entries = {
        DATA: np.arange(48, dtype="<i2").tobytes(),
        "bindata/valid.bin": np.packbits(bits, bitorder="little").tobytes(),
    }
    got = read_surface(path=container(tmp_path / "a.x3p", main, entries, folder="sub/"))
    assert np.flatnonzero(np.isnan(got.heights)).tolist() == [9]
    np.testing.assert_allclose(np.delete(got.heights.ravel(), 9), np.delete(HEIGHTS, 9), atol=1e-20)


def test_a_profile(tmp_path):
    got = read_surface(path=binary(tmp_path / "a.x3p", kind="PRF", counts=("48", "1", "1")))
    assert got.heights.shape == (48,)
    assert got.spacing == pytest.approx(1e-6)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"data": listed(["1", "2"])}, "holds 2 heights; its main.xml speaks of 48 points"),
        ({"data": listed(["1", "wide"])}, "'wide' in its list of heights is not a number"),
        ({"kind": "PCL"}, "feature type 'PCL'"),
        ({"axis": "A"}, "only equally spaced maps"),
        ({"counts": ("0", "6", "1")}, "0 points along x"),
        ({"counts": ("8", "6", "2")}, "8 x 6 x 2 points; only one layer"),
        ({"counts": ("99999", "99999", "1")}, "9999800001 points; 4096 MiB"),
        ({"counts": ("9", "6", "1")}, r"data\.bin holds 384 bytes; by its main\.xml it has 432"),
        ({"increment": "-1e-6"}, "increment of -1e-06 m along x"),
        ({"increment": "wide"}, "Increment in its main.xml is 'wide'"),
        ({"increment": "1e300"}, r"its size is 8e\+300 m"),
        ({"number": "Q"}, "type 'Q'; known are I, L, F, D"),
        ({"data": "<DataLink><PointDataLink>b</PointDataLink></DataLink>"}, "names the data 'b'"),
        ({"data": "<open>"}, "not valid XML"),
        ({"data": "<a/>" * 100_001}, "more than 100000 elements"),
    ],
)
def test_what_is_not_read_says_why(tmp_path, arguments, says):
    with pytest.raises(InputError, match=says):
        read_surface(path=binary(tmp_path / "a.x3p", **arguments))


def test_a_stated_unit_is_refused(tmp_path):
    with pytest.raises(InputError, match="has its units, not um"):
        read_surface(path=binary(tmp_path / "a.x3p"), height_unit="um")


def test_more_heights_than_the_description_says_are_not_unpacked(tmp_path):
    """A small container of zeros would fill the memory; entries that the description does not name are not read."""
    file = binary(tmp_path / "a.x3p")
    with zipfile.ZipFile(file, "a", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("more/clutter.bin", bytes(8 * MEBIBYTE))
    assert read_surface(path=file).heights.shape == (6, 8)
    with pytest.raises(InputError, match=r"holds 8388608 bytes; by its main\.xml it has 384"):
        read_surface(path=binary(tmp_path / "b.x3p", content=bytes(8 * MEBIBYTE)))


def test_a_damaged_container_is_refused(tmp_path):
    file = binary(tmp_path / "a.x3p", content=bytes(384))
    content = bytearray(file.read_bytes())
    content[60:70] = b"\xff" * 10
    file.write_bytes(bytes(content))
    with pytest.raises(InputError, match=r"the container is damaged|not valid XML"):
        read_surface(path=file)


def test_x3p_in_a_subfolder_with_clutter(shared_data):
    got = read_surface(path=shared_data / "csafe_bullet_land_x3p" / "sample-land.x3p")
    assert got.heights.shape == (256, 918)
    assert got.spacing == pytest.approx(2.58e-6)
    assert got.missing_points == 25292


def test_the_package_reads_the_same(shared_data):
    package = pytest.importorskip("SurfaceTopography")
    file = shared_data / "surfacetopography_examples" / "x3p-2.x3p"
    other = package.open_topography(str(file)).topography()
    got = read_surface(path=file)
    np.testing.assert_array_equal(got.heights, other.heights().T)
    assert got.size == pytest.approx(other.physical_sizes, rel=1e-12)
