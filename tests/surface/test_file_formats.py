"""The table of formats: complete, without ambiguity, and with a way out of every refusal."""

import os
from pathlib import Path

import pytest

from asperity.errors import InputError
from asperity.surface.file_formats import (
    FORMATS,
    checked_file,
    file_bytes,
    file_format,
    metres_per_unit,
    signed_format,
)
from asperity.surface.measure_files import read_surface

# formats of the package that other readers take, or that are no measured surfaces
ELSEWHERE = {"x3p", "nms", "npy", "asc", "xyz", "hgt"}


def test_every_format_of_the_package_is_in_the_table():
    readers = pytest.importorskip("SurfaceTopography.IO").readers
    named = {name for known in FORMATS for name in known.package.split()}
    assert named | ELSEWHERE == {reader.format() for reader in readers}


def test_a_format_is_read_or_says_what_to_do():
    for known in FORMATS:
        assert bool(known.reader) != bool(known.export), known.name
        assert (known.reader == "package") <= bool(known.package), known.name


def test_no_two_formats_have_one_signature():
    signatures = [signature for known in FORMATS for signature in known.signatures]
    assert len(signatures) == len(set(signatures))
    for known in FORMATS:
        for signature in known.signatures:
            assert signed_format(b"\n" + signature) is known


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("a.prf", "Form Talysurf, Mahr.*export the profile as text"),
        ("a.FTS", "Taylor Hobson .*export the profile as text"),
        ("a.pcd", "Mahr .*menu Profiles, profile format TXT"),
        ("a.hwp", "Hommel .*export the profile as text"),
        ("a.mat", "it holds no sizes; save the heights as .npy"),
    ],
)
def test_binaries_of_stylus_instruments_are_refused_with_the_way_out(tmp_path, name, says):
    (tmp_path / name).write_bytes(bytes(range(256)) * 4)
    with pytest.raises(InputError, match=says):
        read_surface(path=tmp_path / name)


def test_a_signature_counts_more_than_a_name(tmp_path):
    (tmp_path / "a.pcd").write_bytes(b"DIGITAL SURF\0")
    assert file_format(tmp_path / "a.pcd", b"DIGITAL SURF\0").name == "SUR"


def test_the_page_has_the_table():
    page = (Path(__file__).parents[2] / "docs" / "surface.md").read_text(encoding="utf-8")
    for known in FORMATS:
        mark = " *" if known.reader == "package" else ""
        row = f"| {known.name}{mark} | {known.file_names} | {known.instruments} | {known.stated} |"
        assert (row in page) == bool(known.reader), known.name


def test_content_and_beginning(tmp_path):
    file = tmp_path / "a.bin"
    file.write_bytes(b"12345")
    assert file_bytes(path=file, largest=5) == b"12345"
    assert file_bytes(path=str(file), largest=5, first=2) == b"12"


def test_what_is_not_a_file(tmp_path):
    for path, says in (
        (tmp_path, "is a directory"),
        (tmp_path / "no", "no such file"),
        ("/dev/zero", "device"),
    ):
        with pytest.raises(InputError, match=says):
            checked_file(path=path, largest=10)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(InputError, match="pipe"):
        file_bytes(path=tmp_path / "pipe", largest=10)
    with pytest.raises(InputError, match=r"not a valid file name"):
        checked_file(path="a\0b", largest=10)
    (tmp_path / "empty").touch()
    with pytest.raises(InputError, match="is empty"):
        checked_file(path=tmp_path / "empty", largest=10)
    (tmp_path / "large").write_bytes(b"0" * 11)
    with pytest.raises(InputError, match="MiB"):
        checked_file(path=tmp_path / "large", largest=10)


def test_units_are_those_of_the_package():
    assert metres_per_unit("um") == metres_per_unit("µm") == metres_per_unit("\u03bcm") == 1e-6
    assert metres_per_unit(" 2.5 nm") == 2.5e-9
    assert metres_per_unit("Mm") == 1e6  # not a millimetre
    assert metres_per_unit("Å") == metres_per_unit("angstrom") == 1e-10
    for unit in ("NM", "parsec", "", "kg", "0 mm", "-3 mm", "3"):
        with pytest.raises(InputError):
            metres_per_unit(unit)
