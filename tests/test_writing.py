"""Names of files are checked before anything is computed; a file is there whole or not at all."""

import csv
import math
import os
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from asperity.errors import InputError
from asperity.writing import (
    cannot_write,
    check_file,
    check_folder,
    check_image,
    replacing,
    write_columns,
    write_image,
    write_text,
)


def test_names_that_will_do(tmp_path):
    for check in (check_folder, check_file, check_image):
        check(None)
    for name in ("a.png", "a.SVG", "a.pdf"):
        check_image(tmp_path / name)
    (tmp_path / "there.csv").write_text("old")
    check_file(str(tmp_path / "there.csv"))
    assert os.listdir(tmp_path) == ["there.csv"]


def test_names_that_will_not(tmp_path):
    with pytest.raises(InputError, match=r"a\.jpg: the name of an image must end in \.png, \.svg or \.pdf"):
        check_image("a.jpg")
    for check in (check_folder, check_file, check_image):
        with pytest.raises(InputError, match=r"there is no folder '.*nowhere' to write to; create it first"):
            check(str(tmp_path / "nowhere" / "a.png"))
    (tmp_path / "folder.png").mkdir()
    for path in (tmp_path / "folder.png", Path(os.devnull).with_suffix("")):
        with pytest.raises(InputError, match="is not a regular file; give another name"):
            check_file(path)
        with pytest.raises(InputError, match="is not a regular file"), replacing(path):
            pass
    with pytest.raises(InputError, match="is not a regular file"):
        check_image(tmp_path / "folder.png")


def test_a_folder_that_may_not_be_written_to(tmp_path, monkeypatch):
    def refuse(*_, **__):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("tempfile.NamedTemporaryFile", refuse)
    with pytest.raises(InputError, match=r"a\.csv: cannot be written: Permission denied"):
        check_file(tmp_path / "a.csv")


def test_files_are_written_whole(tmp_path):
    write_image(Figure(figsize=(1.0, 1.0)), tmp_path / "a.svg")
    write_text("µ = 0.12\r\n", str(tmp_path / "a.toml"))
    assert (tmp_path / "a.svg").read_text().startswith("<?xml")
    assert (tmp_path / "a.toml").read_bytes().decode() == "µ = 0.12\r\n"
    write_text("new", tmp_path / "a.toml")
    assert (tmp_path / "a.toml").read_text() == "new"
    assert sorted(os.listdir(tmp_path)) == ["a.svg", "a.toml"]


def test_what_breaks_off_leaves_the_old_file_and_nothing_else(tmp_path):
    file = tmp_path / "a.csv"
    file.write_text("old")

    def break_off(error):
        with replacing(file) as part:
            assert part.suffix == ".csv"
            part.write_text("half")
            raise error

    with pytest.raises(KeyboardInterrupt):
        break_off(KeyboardInterrupt())
    with pytest.raises(InputError, match=r"a\.csv: cannot be written: No space left"):
        break_off(OSError(28, "No space left on device"))
    assert file.read_text() == "old"
    assert os.listdir(tmp_path) == ["a.csv"]


def test_a_link_is_followed(tmp_path):
    (tmp_path / "far").mkdir()
    target, link = tmp_path / "far" / "a.txt", tmp_path / "a.txt"
    target.write_text("old")
    link.symlink_to(target)
    write_text("new", link)
    assert link.is_symlink()
    assert target.read_text() == "new"


def test_the_reason_of_the_system_is_told():
    assert str(cannot_write("x.csv", OSError(28, "No space left on device"))) == (
        "x.csv: cannot be written: No space left on device"
    )
    assert str(cannot_write("x.csv", OSError("odd"))) == "x.csv: cannot be written: odd"


def test_what_is_read_is_not_written_over(tmp_path):
    (tmp_path / "joint.toml").write_text("read")
    (tmp_path / "link.csv").symlink_to(tmp_path / "joint.toml")
    for path in ("joint.toml", "link.csv"):
        with pytest.raises(InputError, match="this is the file that is read; give another name"):
            check_file(tmp_path / path, str(tmp_path / "joint.toml"))
    check_file(tmp_path / "other.csv", str(tmp_path / "joint.toml"), tmp_path / "absent.csv")


def test_no_digit_is_lost(tmp_path):
    file = tmp_path / "columns.csv"
    torque, stiffness = np.array([0.0, 0.1, 1.0 / 3.0]), [1e-300, math.pi, 5.04e6]
    write_columns({"torque [N*m]": torque, "stiffness, mean [N*m/rad]": stiffness}, str(file))
    with file.open(newline="") as source:
        head, *rows = csv.reader(source)
    assert head == ["torque [N*m]", "stiffness, mean [N*m/rad]"]
    assert [[float(cell) for cell in row] for row in rows] == list(
        map(list, zip(torque, stiffness, strict=True))
    )


def test_columns_of_unlike_length_write_nothing(tmp_path):
    with pytest.raises(ValueError, match="dimension"):
        write_columns({"a": [1.0, 2.0], "b": [1.0]}, str(tmp_path / "columns.csv"))
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_does_not_exist_is_told(tmp_path):
    with pytest.raises((InputError, OSError), match="nowhere"):
        write_columns({"a": [1.0]}, str(tmp_path / "nowhere" / "columns.csv"))
