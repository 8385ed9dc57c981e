"""Regular files of bounded size only; units of the package's one parser."""

import os

import pytest

from asperity.errors import InputError
from asperity.surface.input_file import checked_file, file_bytes, metres_per_unit


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
