"""The commands by name.

The options of each command stand in a module of their own, which is imported only when the command is asked for, and
what it does in one of :mod:`asperity.cli.runs`, imported only when it runs: ``asperity --help`` stays fast. Errors of
:mod:`asperity.errors` become one line on standard error and an exit code: 0 fine, 2 bad input, 3 no solution.
"""

from __future__ import annotations

import importlib
import sys
import warnings

import click

from asperity.cli.terminal import checked_output, silence
from asperity.errors import RUNNING, AsperityError, printable

#: Command name → one-line help, shown without importing the module of the command, which has its name.
COMMANDS: dict[str, str] = {
    "init": "Write a commented joint file to start from.",
    "joint": "Verdict, stiffness, forces and warnings of a joint file.",
    "serve": "The joint as a page in the browser, with sliders and curves.",
    "roll": "Drift, losses, thrust and life of a joint that turns.",
    "accuracy": "Transmission error and forces over a turn, from runout and roundness.",
    "film": "Oil in the contacts over speed: film, asperities and traction.",
    "wear": "How tracks wear, and how long the joint then carries its load.",
    "window": "Torques that a joint may pass over temperature or preload, and what limits them.",
    "windup": "Torque-angle curve, hysteresis and capacity of a joint file.",
    "loads": "Forces on pins, bearings, shafts and housing.",
    "dynamics": "Natural frequencies and frequency response with motor and load.",
    "crown": "Crown radius and logarithmic profile for tilted rollers.",
    "compare": "Two joint files side by side: what differs, and what comes of it.",
    "sweep": "Evaluate a joint file on a grid of any of its numbers.",
    "sensitivity": "Influence of every number of a joint file, by exact derivatives.",
    "uncertainty": "Intervals of the results from the tolerances of a joint file.",
    "tolerances": "Deviations and IT grades that keep nearly all drives above stated results.",
    "design": "The best joint within limits, or a Pareto front.",
    "calibrate": "Unknowns of a joint from a measured curve.",
    "draw": "Draw the drive of a joint file to scale.",
    "report": "One document about a joint for a design review.",
    "export": "A joint for MATLAB, MuJoCo and system simulations.",
    "surface": "Measure roughness, spectrum, D and G of surfaces, make and combine them.",
    "materials": "Library of materials and finishes, with sources.",
    "contact": "Stiffness of any number of roller pairs from a table.",
    "validate": "Evidence that this installation computes correctly.",
    "verify-contact": "Compare contact laws with boundary elements, also on a measured map.",
    "reproduce": "Recompute the figures of Zou et al. (2025) and check their claims.",
    "schema": "Print the JSON schema of joint files, for editors.",
    "completion": "Print a shell completion script.",
}
#: Where a section of the list begins → its heading.
_SECTIONS = {
    "init": "Begin",
    "roll": "One joint in detail",
    "sweep": "What if, and what is best",
    "draw": "Show it, and pass it on",
    "surface": "Surfaces, materials and single contacts",
    "validate": "Check the numbers",
    "schema": "For editors and shells",
}
#: Commands that share a module.
_MODULES = dict.fromkeys(("init", "schema", "completion"), "start")


class LazyGroup(click.Group):
    """A click group that imports a command's module only when that command is used."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Names of all commands, in the order of the table."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """The command of this name, imported now; None if there is none."""
        if cmd_name not in COMMANDS:
            return None
        RUNNING.set(f"'asperity {cmd_name}'")
        function = cmd_name.replace("-", "_")
        return getattr(importlib.import_module(f"asperity.cli.{_MODULES.get(cmd_name, function)}"), function)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands from the table, without importing any of them."""
        names = list(COMMANDS)
        starts = [place for place, name in enumerate(names) if name in _SECTIONS]
        widest = max(map(len, names))
        for start, end in zip(starts, [*starts[1:], len(names)], strict=True):
            with formatter.section(_SECTIONS[names[start]]):
                formatter.write_dl([(name.ljust(widest), COMMANDS[name]) for name in names[start:end]])

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command; a mistyped name is answered with the nearest known one."""
        name = args[0]
        if name not in COMMANDS and not name.startswith("-"):
            import difflib

            near = difflib.get_close_matches(name, COMMANDS, n=1)
            hint = f"; did you mean '{near[0]}'?" if near else ""
            raise click.UsageError(f"there is no command '{name}'{hint} (known: {', '.join(COMMANDS)})", ctx)
        return super().resolve_command(ctx, args)


def _show_version(context: click.Context, option: click.Parameter, asked: bool) -> None:
    if asked:
        from asperity import __version__

        click.echo(f"asperity {__version__}")
        context.exit()


@click.group(
    cls=LazyGroup, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100}
)
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_show_version,
    help="Show the version.",
)
def asperity() -> None:
    """From a measured rough surface to a traction-drive joint that an engineer can decide on.

    Begin with 'asperity init', then 'asperity joint joint.toml'. 'asperity COMMAND --help' explains a command.
    """


def _note(message: Warning | str, *_: object, **__: object) -> None:
    """Say what a package warns of in a line, without the place in its source."""
    click.echo(f"asperity: note: {printable(str(message))}", err=True)


def run() -> int:
    """Run the command of ``sys.argv``; an exit code, after one message if it failed."""
    with checked_output(), warnings.catch_warnings():
        warnings.showwarning = _note
        return _run()


def _options(error: BaseException) -> str:
    """The options that do what a message asks for, also where another message has quoted it; empty if it names none."""
    quoted: BaseException | None = error
    while quoted is not None and str(quoted) in str(error):
        if isinstance(quoted, AsperityError) and quoted.options:
            names = " ".join(f"--{name}" for name in quoted.options)
            return f" (option{'s' * (len(quoted.options) > 1)} {names})"
        quoted = quoted.__context__
    return ""


def _run() -> int:
    try:
        code = asperity.main(prog_name="asperity", standalone_mode=False)
        sys.stdout.flush()
    except AsperityError as error:
        click.echo(f"asperity: error: {error}{_options(error)}", err=True)
        return error.exit_code
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except MemoryError as error:
        reason = f" ({error})" if str(error) else ""
        click.echo(
            f"asperity: error: there is not enough memory{reason}; ask for fewer points, samples or results",
            err=True,
        )
        return 2
    except click.Abort as aborted:
        raise (aborted.__cause__ or KeyboardInterrupt()) from None
    except BrokenPipeError:  # the reader of the output has seen enough; nothing is left to be flushed at exit
        silence(sys.stdout)
        return 1
    return code if isinstance(code, int) else 0
