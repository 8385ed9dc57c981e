"""Ctrl-C and SIGTERM end any command with one line, wherever they come: in imports, in callbacks from C or later.

The signal is sent by the process to itself at a known place, by an audit hook or a callback, so that no test waits.
"""

import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest

from asperity.cli import main

EXAMPLES = Path(__file__).parents[2] / "examples"
SOURCES = Path(__file__).parents[2] / "src"
#: ``strike()`` sends the signal once; ``when(event, word)`` does at an audit event whose first argument has a word.
PROGRAM = """
import gc, os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
left = [signal.{number}]
def strike(*_):
    if left:
        os.kill(os.getpid(), left.pop())
def when(event, word):
    sys.addaudithook(lambda name, args: name == event and word in str(args[0]) and strike())
if {collecting}:
    gc.set_threshold = lambda *_: None
    gc.callbacks.append(lambda *_: "asperity.joint_file.model" in sys.modules and strike())
else:
    when({event!r}, {word!r})
{patch}
from asperity.cli import main
main()
"""
#: XLA compiles for longer than any test waits, and the signal comes meanwhile.
COMPILING = """
import time
from asperity import compilation
compilation._compiled = lambda *_: strike() or compilation._compilers().submit(time.sleep, 1000.0).result()
print("before")
"""


def interrupted(folder, *command, number="SIGINT", event="", word="", collecting=False, patch=""):
    """The ended process of a command to which the signal is sent; its folder of temporary files is in the folder."""
    program = PROGRAM.format(number=number, event=event, word=word, collecting=collecting, patch=patch)
    temporary = folder / "temporary"
    temporary.mkdir()
    ended = subprocess.run(
        [sys.executable, "-c", program, *map(str, command)],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(SOURCES), "TMPDIR": str(temporary), "ASPERITY_CACHE_DIR": ""},
        capture_output=True,
        text=True,
        timeout=100,
        check=False,
    )
    assert not list(temporary.iterdir())
    temporary.rmdir()
    return ended


def answer(ended):
    """Exit code, standard output and what is said; a line begins anew behind the ^C of a terminal."""
    return ended.returncode, ended.stdout, ended.stderr.strip()


@pytest.mark.parametrize(
    "word",
    [
        "click",  # before there is a command
        pytest.param("numpy.linalg", marks=pytest.mark.slow),  # by the C code of NumPy
        pytest.param("asperity.joint_file.model", marks=pytest.mark.slow),
    ],
)
def test_an_interrupted_import_ends_with_one_line(tmp_path, word):
    command = ("loads", EXAMPLES / "planetary.toml", "--csv", "loads.csv")
    ended = interrupted(tmp_path, *command, event="import", word=word)
    assert answer(ended) == (130, "", "asperity: interrupted")
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_an_interruption_that_a_callback_drops_comes_again(tmp_path):
    ended = interrupted(tmp_path, "joint", EXAMPLES / "planetary.toml", collecting=True)
    assert answer(ended) == (130, "", "asperity: interrupted")


@pytest.mark.parametrize(
    ("number", "code", "says"),
    [("SIGINT", 130, "interrupted"), pytest.param("SIGTERM", 143, "terminated", marks=pytest.mark.slow)],
)
def test_an_interrupted_command_leaves_no_folder(tmp_path, number, code, says):
    ended = interrupted(
        tmp_path, "reproduce", "--out", "a/folder", number=number, event="os.mkdir", word="folder"
    )
    assert answer(ended) == (code, "", f"asperity: {says}")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("number", "code", "says"),
    [("SIGINT", 130, "interrupted"), pytest.param("SIGTERM", 143, "terminated", marks=pytest.mark.slow)],
)
def test_the_end_does_not_wait_for_what_is_compiled(tmp_path, number, code, says):
    """What has been printed before still comes out."""
    command = ("sensitivity", EXAMPLES / "planetary.toml")
    ended = interrupted(tmp_path, *command, number=number, patch=COMPILING)
    assert answer(ended) == (code, "before\n", f"asperity: {says}")


@pytest.mark.slow
def test_a_sweep_of_many_points_ends_while_its_program_is_compiled(tmp_path):
    over = ("--over", "load.preload=500 N:900 N:30000", "--results", "published_stiffness_output")
    command = ("sweep", EXAMPLES / "planetary.toml", *over, "--out", "sweep.csv")
    ended = interrupted(tmp_path, *command, patch=COMPILING)
    assert answer(ended) == (130, "before\n", "asperity: interrupted")
    assert not list(tmp_path.iterdir())


#: A step that no signal interrupts and that never ends, as a file is being written; the signal comes meanwhile.
STUCK = """
import ctypes, threading, time
import numpy
def save(file, *_, **__):
    open(file, "w").write("half of it")
    print("before")
    threading.Timer(0.5, strike).start()
    mutex = ctypes.create_string_buffer(256)
    for _ in "12":
        ctypes.CDLL(None).pthread_mutex_lock(mutex)
numpy.save = save
"""


@pytest.mark.skipif(sys.platform != "linux", reason="a lock of the system is made by hand")
@pytest.mark.parametrize(
    ("number", "code", "says"), [("SIGINT", 130, "interrupted"), ("SIGTERM", 143, "terminated")]
)
def test_a_step_that_python_cannot_interrupt_is_not_waited_for(tmp_path, number, code, says):
    made = (
        "--kind",
        "weierstrass",
        "-D",
        "1.5",
        "-G",
        "1e-9 m",
        "--points",
        "64",
        "--spacing",
        "1 um",
        "--seed",
        1,
    )
    command = ("surface", "synthesize", "out.npy", *made)
    ended = interrupted(tmp_path, *command, number=number, patch=STUCK)
    assert answer(ended) == (code, "before\n", f"asperity: {says}")
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(not Path("/proc/self/fd").exists(), reason="the system does not list open files")
def test_a_command_leaves_no_file_open(monkeypatch, capsys):
    """Where several run in one process."""

    def run():
        monkeypatch.setattr(sys, "argv", ["asperity", "materials"])
        before = set(threading.enumerate())
        with pytest.raises(SystemExit):
            main()
        for thread in set(threading.enumerate()) - before:
            thread.join(60.0)  # the one that has waited for signals closes what it has read from
        return len(os.listdir("/proc/self/fd"))

    first = run()
    assert run() == first
    assert "52100" in capsys.readouterr().out
