"""Numbers kept between processes: found again, never trusted where others can have written them, and cleared away."""

import json
import os
import time

import pytest

from asperity import kept_numbers as module
from asperity.kept_numbers import keep_numbers, kept_numbers


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", str(tmp_path))
    return tmp_path


def test_what_is_kept_is_found_by_what_was_asked(folder):
    keep_numbers(b"one", {"force": [1.5, None]})
    assert kept_numbers(b"one") == {"force": [1.5, None]}
    assert kept_numbers(b"other") is None
    (file,) = folder.iterdir()
    assert file.stat().st_mode & 0o077 == 0


def test_without_a_folder_nothing_is_kept(monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    keep_numbers(b"one", [1.0])
    assert kept_numbers(b"one") is None


@pytest.mark.parametrize(
    "damage", [lambda content: b"", lambda content: content[:-1], lambda content: b"x" + content]
)
def test_a_damaged_file_is_as_good_as_none(folder, damage):
    keep_numbers(b"one", [1.0])
    (file,) = folder.iterdir()
    file.write_bytes(damage(file.read_bytes()))
    assert kept_numbers(b"one") is None


def test_text_that_is_no_json_is_as_good_as_none(folder, monkeypatch):
    monkeypatch.setattr(json, "dumps", lambda document: "{" * 3)
    keep_numbers(b"one", [1.0])
    assert kept_numbers(b"one") is None


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="users are known by number on POSIX systems only")
def test_what_others_can_write_is_not_read(folder):
    keep_numbers(b"one", [1.0])
    (file,) = folder.iterdir()
    file.chmod(0o666)
    assert kept_numbers(b"one") is None


def test_a_change_of_the_package_is_another_question(folder, monkeypatch):
    keep_numbers(b"one", [1.0])
    monkeypatch.setattr(module, "_surroundings", lambda: b"another release")
    assert kept_numbers(b"one") is None


def test_old_numbers_and_halves_of_files_are_removed(folder):
    old, half, recent = (
        folder / f"asperity-{name}" for name in ("a.numbers", "b.numbers.1.part", "c.numbers")
    )
    for file, age in ((old, 91 * 24 * 3600.0), (half, 2 * 3600.0), (recent, 3600.0)):
        file.write_bytes(b"")
        os.utime(file, (time.time() - age,) * 2)
    keep_numbers(b"one", [1.0])
    assert not old.exists()
    assert not half.exists()
    assert recent.exists()


def test_a_full_disk_leaves_nothing_behind(folder, monkeypatch):
    def full(file, content):
        file.write_bytes(content[:5])
        raise OSError("no space left on device")

    monkeypatch.setattr(module, "write_own", full)
    keep_numbers(b"one", [1.0])
    assert not list(folder.iterdir())
