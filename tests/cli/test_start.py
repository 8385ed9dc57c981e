"""The command as a program of its own: what it loads, how it ends."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from asperity import cli

ROOT = Path(__file__).parents[2]
HEAVY = ("jax", "numpy", "pydantic", "rich", "scipy", "matplotlib")
PROGRAM = """
import sys
from asperity.cli import main
try:
    main()
finally:
    print("LOADED", *sorted(set(sys.modules) & set(sys.argv[-1].split(","))), file=sys.stderr)
"""


def run(*arguments, **environment):
    return subprocess.run(
        [sys.executable, "-c", PROGRAM, *arguments],
        capture_output=True,
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT / "src"), "ASPERITY_CACHE_DIR": "", **environment},
        timeout=120,
        check=False,
    )


@pytest.mark.parametrize("option", ["--help", "--version"])
def test_help_and_version_load_nothing_heavy(option):
    done = run(option, ",".join(HEAVY))
    assert done.returncode == 0
    assert done.stderr.decode().split() == ["LOADED"]
    assert b"asperity" in done.stdout


def test_the_joint_command_loads_no_plotting_and_no_optimiser():
    unwanted = "scipy.optimize,matplotlib,pint,pandas,xarray"
    script = PROGRAM.replace("sys.argv[-1]", repr(unwanted))
    done = subprocess.run(
        [sys.executable, "-c", script, "joint", "examples/zou2025.toml"],
        capture_output=True,
        cwd=ROOT,
        env={
            **os.environ,
            "PYTHONPATH": str(ROOT / "src"),
            "ASPERITY_CACHE_DIR": "",
            "PYTHONIOENCODING": "ascii",
        },
        timeout=120,
        check=False,
    )
    assert done.returncode == 0, done.stderr.decode()
    assert done.stderr.decode().split() == ["LOADED"]
    assert "N*m/rad" in done.stdout.decode("ascii")


def test_a_reader_that_closes_early_is_no_error():
    arguments = f"{sys.executable} -c 'from asperity.cli import main; main()' init - | head -n 1"
    done = subprocess.run(
        arguments,
        shell=True,
        capture_output=True,
        env={**os.environ, "PYTHONPATH": str(ROOT / "src")},
        timeout=60,
        check=False,
    )
    assert done.stdout.startswith(b"# The joint of")
    assert done.stderr == b""


def test_a_mistyped_command_is_answered_with_the_nearest():
    done = run("jiont")
    assert done.returncode == 2
    assert "did you mean 'joint'?" in done.stderr.decode()
    assert "Traceback" not in done.stderr.decode()


def test_what_does_not_fit_into_memory_is_said(monkeypatch, capsys):
    def exhausted(**_):
        raise MemoryError("Unable to allocate 3.64 TiB")

    monkeypatch.setattr("asperity.cli.asperity.main", exhausted)
    with pytest.raises(SystemExit) as ended:
        cli.main()
    assert ended.value.code == 2
    assert (
        "the memory does not suffice (Unable to allocate 3.64 TiB); ask for fewer" in capsys.readouterr().err
    )
