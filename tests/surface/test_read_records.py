"""Profiles in records, written here by the layout of the standard and that of NPL."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.measure_files import read_surface

X = 0.25e-6 * np.arange(400)
HEIGHTS = 1e-6 * np.sin(2.0 * np.pi * X / 20e-6) + 1e-7 * np.cos(2.0 * np.pi * X / 3e-6)


def smd(*, axis="CX\0 I\0 400 mm\0 1.0e0 D\0 2.5e-4", scale="um\0 1.0e0 D", values=None):
    """ISO 5436-2:2012: header, notes, heights, checksum, each record with the character 3 at its end."""
    lines = [
        "ISO 5436-2:2012\0sine\0",
        "PRF\0 1 ISO5436\0",
        axis,
        f"CZ\0 A\0 400 {scale}\0",
        "\x03",
        "DATE: 26-November-2026\0",
        "COMMENT /* a sine */\0",
        "\x03",
        *(values or [f"{1e6 * height:.6f}" for height in HEIGHTS]),
        "\x03",
        "12345",
        "\x03",
    ]
    return "\r\n".join(lines) + "\r\n\x1a"


def npl(*, spacing="SPACING CX 2.500000e-004", count="4.000000e+002"):
    """Counts of a picometre, positions in mm."""
    lines = [
        "1 2",
        "SG2004 0.000000e+000 PRF",
        f"CX M {count} MM 1.000000e+000 D",
        f"CZ M {count} MM 1.000000e-009 L",
        "EOR",
        "STYLUS_RADIUS 0.000000e+000 MM",
        spacing,
        "COMMENT a sine",
        "EOR",
        *(f"{1e12 * height:.0f}" for height in HEIGHTS),
        "EOR",
        "EOF",
    ]
    return "\r\n".join(lines) + "\r\n"


def sdf(*, scale="1E-06", values=None, compression=0):
    """ISO 25178-71 as NPL and NIST write their reference profiles: with names of their own for the version."""
    lines = [
        "aNPL-V1.0",
        "ManuFacID = Softgauges",
        "CreateDate = 210520051200",
        "ModDate = 210520051200",
        "NumPoints = 400",
        "NumProfiles = 1",
        "Xscale = 2.5E-07",
        "Yscale = 0",
        f"Zscale = {scale}",
        "Zresolution = -1",
        f"Compression = {compression}",
        "DataType = 7",
        "CheckType = 0",
        "*",
        *(values or [f"{1e6 * height:.6f}" for height in HEIGHTS]),
        "*",
        "*",
    ]
    return "\r\n".join(lines) + "\r\n"


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("npl.sdf", sdf()),
        (
            "nist.sdf",
            sdf(scale="1.0e-13", values=[f"{1e13 * height:.0f}" for height in HEIGHTS]).replace(
                "aNPL-V", "aBC-"
            ),
        ),
        ("a.smd", smd()),
        ("scaled.smd", smd(axis="CX\0 I\0 400 um\0 0.25 D\0 1.0", scale="nm\0 1.0e3 D")),
        (
            "positions.smd",
            smd(
                axis="CX\0 A\0 400 mm\0 1.0e0 D\0",
                values=[f"{1e3 * x:.8f} {1e6 * z:.6f}" for x, z in zip(X, HEIGHTS, strict=True)],
            ),
        ),
        ("a.prf", npl()),
    ],
)
def test_a_profile_comes_back(tmp_path, name, text):
    (tmp_path / name).write_bytes(text.encode("ascii"))
    got = read_surface(path=tmp_path / name)
    assert got.position[1] == pytest.approx(0.25e-6, rel=1e-9)
    np.testing.assert_allclose(got.heights, HEIGHTS, atol=1e-12)
    assert not got.is_map
    with pytest.raises(InputError, match="has its units, not um"):
        read_surface(path=tmp_path / name, height_unit="um")


@pytest.mark.parametrize(
    ("text", "says"),
    [
        (npl(count="4.000000e+003"), "speaks of 4000 points and has 400"),
        (npl(count="inf"), "cannot be read"),
        (npl().replace("MM 1.000000e-009 L", "MM nan L"), "the scale of CZ is nan"),
        (npl().replace("EOR\r\nEOF", "1 2 3\r\nEOR\r\nEOF"), "speaks of 400 points"),
        (npl(spacing="COMMENT no spacing"), "states no spacing of its points"),
        (npl().replace("CZ M", "CW M"), "has no axes CX and CZ"),
        (npl().replace("MM 1.000000e-009 L", "furlongs 1.0 L"), "unknown unit 'furlongs'"),
        (npl().replace("CZ M", "CY M 2 MM 1.0 D\r\nCZ M"), "is a map in records"),
        (npl().replace("EOR\r\nEOF", "seven\r\nEOR\r\nEOF"), "cannot be read"),
        (sdf(scale="0"), "the scale of zscale is 0"),
        (sdf(values=["1.0"] * 399), "speaks of 400 points and has 399"),
        (sdf(values=["1.0"] * 399 + ["one"]), "cannot be read"),
        (sdf(compression=1), "compressed"),
        (sdf().replace("*", ""), "speaks of 400 points and has 0"),
        (sdf().replace("Xscale", "Step"), "cannot be read"),
        (smd(values=[f"{k * k} 1.0" for k in range(400)], axis="CX A 400 mm 1 D"), "not evenly spaced"),
    ],
)
def test_damaged_files(tmp_path, text, says):
    (tmp_path / "a.smd").write_bytes(text.encode("ascii"))
    with pytest.raises(InputError, match=says):
        read_surface(path=tmp_path / "a.smd")


def test_bad_points_of_an_sdf_profile_are_missing(tmp_path):
    values = [f"{1e6 * height:.6f}" for height in HEIGHTS]
    values[7] = "BAD"
    (tmp_path / "a.sdf").write_text(sdf(values=values))
    got = read_surface(path=tmp_path / "a.sdf").heights
    assert np.flatnonzero(np.isnan(got)).tolist() == [7]
