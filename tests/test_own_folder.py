"""Which folders and files only this user can have written."""

import os

import pytest

from asperity.own_folder import NotOwnError, foreign_files, own_folder, read_own, write_own


def test_what_is_written_is_read_and_seen_by_nobody_else(tmp_path):
    file = tmp_path / "a"
    write_own(file, b"content")
    assert file.stat().st_mode & 0o777 == 0o600
    os.utime(file, (0, 0))
    assert read_own(file) == b"content"
    assert file.stat().st_mtime > 0
    with pytest.raises(FileExistsError):
        write_own(file, b"other")


def test_a_link_a_pipe_and_a_device_are_not_read(tmp_path):
    write_own(tmp_path / "a", b"content")
    (tmp_path / "link").symlink_to("a")
    os.mkfifo(tmp_path / "pipe")
    for name in ("link", "pipe", ".", "none"):
        with pytest.raises(OSError, match=r"."):
            read_own(tmp_path / name)
    with pytest.raises(NotOwnError):
        read_own(tmp_path / "pipe")
    assert foreign_files(tmp_path, "pipe") == ["pipe"]
    assert foreign_files(tmp_path, "a") == []


@pytest.mark.parametrize(
    ("mode", "allowed"), [(0o700, True), (0o755, True), (0o775, False), (0o757, False), (0o1777, False)]
)
def test_a_folder_is_writable_by_its_user_alone(tmp_path, mode, allowed):
    folder = tmp_path / "cache"
    folder.mkdir()
    folder.chmod(mode)
    if allowed:
        assert own_folder(folder) == folder
    else:
        with pytest.raises(NotOwnError, match="chmod 700"):
            own_folder(folder)
