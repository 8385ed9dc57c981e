"""X3P containers: variants that are refused by name, sizes against the header, clutter beside the data."""

import zipfile

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface import read_instrument
from asperity.surface.read import read_surface


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


def test_x3p_in_a_subfolder_with_clutter(shared_data):
    pytest.importorskip("SurfaceTopography")
    got = read_surface(path=shared_data / "csafe_bullet_land_x3p" / "sample-land.x3p")
    assert got.heights.shape == (256, 918)
    assert got.spacing == pytest.approx(2.58e-6)
    assert got.missing_points == 25292
