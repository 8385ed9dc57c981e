"""The command as a program of its own: what it loads, how it ends."""

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from asperity import cli

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "zou2025.toml"
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


@pytest.mark.slow
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
        "there is not enough memory (Unable to allocate 3.64 TiB); ask for fewer" in capsys.readouterr().err
    )


START = f"{sys.executable} -c 'from asperity.cli import main; main()'"


def shell(line: str):
    return subprocess.run(
        line.replace("asperity", START, 1),
        shell=True,
        capture_output=True,
        text=True,
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT / "src"), "ASPERITY_CACHE_DIR": ""},
        timeout=120,
        check=False,
    )


@pytest.mark.parametrize("command", ["init -", "materials", "--version"])
@pytest.mark.parametrize(
    ("redirection", "reason"),
    [
        (">/dev/full", "standard output cannot be written: No space left on device"),
        (">&-", "standard output is closed; redirect it to a file or to /dev/null"),
    ],
)
def test_an_output_that_takes_nothing_is_one_message(command, redirection, reason):
    done = shell(f"asperity {command} {redirection}")
    assert (done.returncode, done.stderr) == (2, f"asperity: error: {reason}\n")


def test_messages_that_cannot_be_written_do_not_change_the_exit_code():
    for redirection in ("2>/dev/full", "2>&-"):
        done = shell(f"asperity materials absent {redirection}")
        assert (done.returncode, done.stdout, done.stderr) == (2, "", "")
        assert shell(f"asperity --version {redirection}").stdout.startswith("asperity ")


def test_a_closed_standard_output_is_not_mistaken_for_the_next_file(tmp_path):
    file = tmp_path / "joint.toml"
    done = shell(f"asperity init {file} >&-")
    assert done.returncode == 0, done.stderr
    assert file.read_text().startswith("# The joint of")


HOSTILE = "\x1b[31mred\x9b2J\u202e\u2066"


def test_nothing_on_the_command_line_reaches_the_terminal_as_a_control_sequence(call, tmp_path):
    for arguments in (
        [HOSTILE],
        ["joint", HOSTILE],
        ["joint", "x", f"--{HOSTILE}"],
        ["joint", "x", "y" + HOSTILE],
        ["materials", HOSTILE],
        ["init", tmp_path / HOSTILE],
        ["sweep", EXAMPLE, "--over", HOSTILE],
        ["contact", "--table", "t", "--out", "o", "--asperity-base", HOSTILE],
    ):
        outcome = call(*arguments)
        assert (outcome.out + outcome.err).replace("\n", "").isprintable(), arguments
        assert r"red\x9b2J\u202e\u2066" in outcome.err, arguments
    assert (tmp_path / HOSTILE).is_file()


def test_names_in_a_users_library_are_listed_without_control_sequences(call, tmp_path):
    entry = (
        '["{}"]\ndescription = "{}"\nreference = "{}"\nyoungs_modulus = "110 GPa"\npoisson_ratio = 0.34\n'
        'density = "8800 kg/m^3"\nyield_strength = "200 MPa"\nhardness_factor = 2.8\n'
    )
    (tmp_path / "own.toml").write_text(entry.replace("{}", r"\u001b[31m\u009b\u202e"))
    outcome = call("materials", "--file", tmp_path / "own.toml")
    assert outcome.code == 0
    assert outcome.out.replace("\n", "").isprintable()
    assert outcome.out.count(r"\x1b[31m\x9b\u202e") == 4


@pytest.mark.parametrize(
    ("number", "code", "word"), [("TERM", 143, "terminated"), ("INT", 130, "interrupted")]
)
def test_signals_end_the_command_with_one_word(number, code, word):
    script = (
        "import os, signal, sys\nfrom asperity import cli\nfrom asperity.cli import schema\n"
        "sys.argv = ['asperity', 'schema']\n"
        # a process started in the background ignores the signal of Ctrl+C
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        f"schema.schema.callback = lambda **options: os.kill(os.getpid(), signal.SIG{number})\ncli.main()\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT / "src")},
        timeout=60,
        check=False,
    )
    assert (done.returncode, done.stderr.strip()) == (code, f"asperity: {word}")


def test_the_command_line_names_the_options_that_a_message_asks_for(call, tmp_path):
    """Also where another message has quoted it with the name of the file in front."""
    np.save(tmp_path / "bare.npy", np.zeros(100))
    outcome = call("surface", "measure", tmp_path / "bare.npy")
    assert outcome.code == 2
    assert outcome.err.rstrip().endswith("such as '0.5 um' (options --height-unit --spacing)")
    outcome = call("contact", "--table", tmp_path / "absent.csv", "--out", tmp_path / "out.csv")
    assert "option" not in outcome.err
