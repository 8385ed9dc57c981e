"""Each command finds what it does, with the arguments that its options have; what is loaded on the way."""

import importlib
import inspect
import os
import subprocess
import sys
from pathlib import Path

import click
import pytest

from asperity.cli.commands import COMMANDS, asperity
from asperity.cli.run_by_name import run_by_name
from asperity.cli.runs.surface import ARGUMENTS
from asperity.show.title_block import stated_title
from asperity.surface.measure_files import measured_files

EXAMPLE = Path(__file__).parents[2] / "examples" / "planetary.toml"
HEAVY = ("jax", "numpy", "scipy", "matplotlib", "pandas", "xarray", "pydantic", "tomlkit", "starlette")
OF_STUDIES = ("jax", "matplotlib", "pandas", "xarray", "asperity.study.batch")

#: What a title block states.
TITLE = {"project", "part", "revision", "date"}
#: Options that a command passes on as they are, by its name.
GOES_ON = {
    "draw": TITLE,
    "report": TITLE,
    "surface measure": {
        *("position_unit", "height_unit", "spacing", "decimal", "column", "no_data", "any_size"),
        *("start", "stop", "form", "degree", "missing", "outliers", "short_cut_off", "cut_off", "direction"),
        *("lay", "estimator", "gamma", "shortest", "longest"),
    },
    "verify-contact": {
        *("position_unit", "height_unit", "spacing", "decimal", "column", "no_data", "any_size"),
        *("missing", "form", "degree", "outliers", "direction"),
    },
}


def commands():
    """Every command that does something: its name, and itself."""
    for name in COMMANDS:
        command = asperity.get_command(click.Context(asperity), name)
        below = command.commands if isinstance(command, click.Group) else {}
        yield from ((f"{name} {child}", below[child]) for child in below)
        if not below:
            yield name, command


@pytest.mark.parametrize(("name", "command"), [pytest.param(*pair, id=pair[0]) for pair in commands()])
def test_a_command_does_what_its_options_ask_for(name, command):
    described = inspect.unwrap(command.callback)
    room = described.__module__.replace("asperity.cli.", "asperity.cli.runs.")
    parameters = inspect.signature(
        getattr(importlib.import_module(room), described.__name__)
    ).parameters.values()
    options = {option.name for option in command.params if option.expose_value}
    named = {one.name for one in parameters if one.kind is not one.VAR_KEYWORD}
    goes_on = any(one.kind is one.VAR_KEYWORD for one in parameters)
    assert goes_on == (name in GOES_ON)
    assert options == named | GOES_ON.get(name, set())
    assert not named & GOES_ON.get(name, set())


def test_options_that_go_on_are_all_taken():
    """A map is read with the options of `surface measure` that --surface leaves open."""
    receives = {one.name for one in inspect.signature(measured_files).parameters.values()} - {"files"}
    assert {ARGUMENTS.get(option, option) for option in GOES_ON["surface measure"]} == receives
    assert GOES_ON["verify-contact"] <= GOES_ON["surface measure"]
    assert stated_title(dict.fromkeys(GOES_ON["draw"], "said")).part == "said"


def test_the_callback_keeps_what_describes_the_command_and_returns_what_is_done(monkeypatch):
    def measured() -> None:
        """What the help says."""

    measured.__module__ = "asperity.cli.measured"
    done = type(sys)("asperity.cli.runs.measured")
    done.measured = lambda **options: ("done", options)
    monkeypatch.setitem(sys.modules, "asperity.cli.runs.measured", done)
    callback = run_by_name(measured)
    assert (callback.__name__, callback.__doc__) == ("measured", "What the help says.")
    assert callback(file="a", plot=None) == ("done", {"file": "a", "plot": None})


@pytest.mark.slow
@pytest.mark.parametrize("arguments", [("--help",), *((*name.split(), "--help") for name, _ in commands())])
def test_help_loads_nothing_heavy(arguments):
    """But for the commands whose help lists the types of drives: the file of a type has its formulas, on arrays."""
    needed = {"numpy"} if arguments[0] in ("init", "schema") else set()
    assert modules_after(*arguments) & set(HEAVY) == needed


@pytest.mark.slow
@pytest.mark.parametrize("command", ["joint", "roll", "windup", "loads", "crown --tilt 1mrad"])
def test_a_command_about_one_joint_loads_no_studies_and_no_plotting(command):
    name, *options = command.split()
    assert modules_after(name, EXAMPLE, *options) & set(OF_STUDIES) == set()


@pytest.mark.slow
@pytest.mark.parametrize(
    "command", ["sweep --over a=1:2:3", "sensitivity", "uncertainty", "tolerances --keep a>=1"]
)
def test_a_missing_file_is_refused_before_a_study_is_loaded(command):
    name, *options = command.split()
    assert "jax" not in modules_after(name, "none.toml", *options, code=2)


def modules_after(*arguments, code=0):
    """The modules that a command has loaded at its end."""
    script = (
        "import sys, atexit; from asperity.cli import main; "
        "atexit.register(lambda: print('|', *sys.modules)); main()"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, *map(str, arguments)],
        capture_output=True,
        text=True,
        env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)},
        check=False,
    )
    assert done.returncode == code, done.stderr
    return set(done.stdout.rpartition("|")[2].split())
