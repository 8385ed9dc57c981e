"""A process that can be ended at any time, in a folder that is gone afterwards."""

import tempfile
import threading
import time
from pathlib import Path

import pytest

from asperity.errors import InputError
from asperity.page.child import LONGEST_FILE_NAME, Child, StoppedError, file_name


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("profile.csv", "profile.csv"),
        ("../../etc/passwd", "passwd"),
        ("C:\\\\folder\\\\surface.x3p", "surface.x3p"),
        ("..", "surface"),
        ("", "surface"),
        ("-rf", "rf"),
        (".bashrc", "bashrc"),
        ("a\0b\n\x1b[31m.csv", "a_b___31m.csv"),
        ("höhe μm.txt", "h_he__m.txt"),
        ("x" * 300 + ".csv", "x" * (LONGEST_FILE_NAME - 4) + ".csv"),
    ],
)
def test_names_are_harmless(name, expected):
    assert file_name(name, otherwise="surface") == expected


def folders():
    return set(Path(tempfile.gettempdir()).glob("asperity-page-*"))


def test_a_stopped_child_is_gone_and_so_is_its_folder():
    before = folders()
    child = Child("measure", {"surface.csv": b"1,2\n"}, {})
    said = []

    def run():
        try:
            child.run()
        except StoppedError as error:
            said.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    while child._process is None:
        time.sleep(0.01)
    child.stop()
    thread.join(timeout=60)
    assert len(said) == 1
    assert child._process.poll() is not None
    assert folders() <= before


def test_a_child_that_was_stopped_before_never_starts():
    child = Child("measure", {"surface.csv": b""}, {})
    child.stop()
    with pytest.raises(StoppedError):
        child.run()
    assert child._process is None


def test_a_child_that_takes_too_long_is_ended():
    child = Child("measure", {"surface.csv": b"1,2\n"}, {})
    with pytest.raises(InputError, match=r"longer than 0.05 s"):
        child.run(longest=0.05)
    assert child._process.poll() is not None


def test_a_child_ends_when_its_parent_does(tmp_path):
    """The end of the parent closes the pipe, in whatever way it ends."""
    child = Child("measure", {"surface.csv": b"1,2\n"}, {})
    process = child._start(str(tmp_path))
    process.stdin.close()
    assert process.wait(timeout=120) != 0
    process.stdout.close()
