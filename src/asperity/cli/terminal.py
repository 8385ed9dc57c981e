"""Where commands print: plain text when piped, at most 100 columns, legible without Unicode; shared options.

What users wrote in files and on the command line appears in output. :func:`checked_output` lets none of it reach a
terminal as a control sequence, and turns a full disk behind standard output into one sentence.
"""

from __future__ import annotations

import codecs
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from asperity.errors import InputError, NoSolutionError, printable
from asperity.views.terminal import WIDEST, console_on, show

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console

    from asperity.joint_file.si_tables import AnyCase
    from asperity.unit_table import Dimension
    from asperity.views.blocks import Block

_IN_ASCII = {
    "·": "*",
    "²": "^2",
    "³": "^3",
    "µ": "u",
    "°": " deg",
    "–": "-",
    "→": "->",
    "±": "+-",
    "≥": ">=",
    "…": "...",
}
#: Options of a title block.
_TITLE = {
    "project": "Project for the title block; nothing is filled in without it, as for the next three.",
    "part": "Number or name of the part for the title block.",
    "revision": "Revision for the title block.",
    "date": "Date for the title block.",
}


def _spell_out(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    unknown = error.object[error.start : error.end]
    return "".join(_IN_ASCII.get(letter, "?") for letter in unknown), error.end


def prepare_output() -> None:
    """Let standard output and error spell out what their encoding cannot write, instead of failing."""
    codecs.register_error("asperity_spell_out", _spell_out)
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="asperity_spell_out")


class CheckedStream:
    """A text stream, None where it is closed, whose failures are errors of ours that call it by its name.

    ``escape`` writes control characters as :func:`asperity.errors.printable` does; line ends and tabs stay.
    ``required`` makes it an error that it cannot be written.
    """

    def __init__(self, stream: Any, name: str, *, escape: bool, required: bool) -> None:
        self.stream, self._name, self._escape, self._required = stream, name, escape, required

    def __getattr__(self, attribute: str) -> Any:
        """Anything else is the stream's."""
        return getattr(self.stream, attribute)

    def unescaped(self) -> CheckedStream:
        """The same stream for text whose control characters are our own."""
        return CheckedStream(self.stream, self._name, escape=False, required=self._required)

    def write(self, text: str) -> int:
        """Write text; the number of characters. An ``InputError`` if the output is closed or cannot take more."""
        if not isinstance(text, str):
            raise TypeError("only text can be written here")
        if not text:
            return 0
        if self.stream is None:
            raise InputError(f"{self._name} is closed; redirect it to a file or to /dev/null")
        safe = text
        if self._escape and not text.isprintable():
            lines = [
                [printable(cell.replace("\n", "")) for cell in line.split("\t")] for line in text.split("\n")
            ]
            safe = "\n".join("\t".join(cells) for cells in lines)
        with self._refusals():
            self.stream.write(safe)
        return len(text)

    def flush(self) -> None:
        """Hand everything written to the system; an ``InputError`` if it does not take it."""
        if self.stream is not None:
            with self._refusals():
                self.stream.flush()

    @contextmanager
    def _refusals(self) -> Iterator[None]:
        try:
            yield
        except BrokenPipeError:  # the reader has seen enough
            raise
        except OSError as error:
            silence(self.stream)
            if self._required:
                raise InputError(f"{self._name} cannot be written: {error.strerror or error}") from None


def silence(stream: Any) -> None:
    """Send what is still waiting in a stream nowhere, so that Python does not try to write it at its end."""
    with suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)


@contextmanager
def checked_output() -> Iterator[None]:
    """Standard output and error as :class:`CheckedStream` for the time of a command."""
    for number in (0, 1, 2):  # the number of a closed stream would go to the next file that is opened
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w")  # noqa: SIM115 (it stays open until the process ends)
    prepare_output()
    out, error = sys.stdout, sys.stderr
    sys.stdout = CheckedStream(out, "standard output", escape=True, required=True)
    sys.stderr = CheckedStream(error, "standard error", escape=True, required=False)
    try:
        yield
    finally:
        sys.stdout, sys.stderr = out, error


def rich_console(*, stderr: bool = False) -> Console:
    """A console of rich whose styles reach the terminal and whose texts cannot style it themselves."""
    stream = sys.stderr if stderr else sys.stdout
    if isinstance(stream, CheckedStream):
        stream = stream.unescaped()
    return console_on(stream)  # type: ignore[arg-type]


def console() -> Console:
    """A console on standard output, with colours on a terminal only, and no wider than :data:`WIDEST`."""
    prepare_output()
    made = rich_console()
    made.width = min(made.width, WIDEST) if made.is_terminal else WIDEST
    return made


def show_blocks(*blocks: Block) -> None:
    """Print blocks on standard output."""
    show(console(), blocks)


def say(sentence: str) -> None:
    """Write a message to standard error."""
    click.echo(sentence, err=True)


def say_written(path: str | Path) -> None:
    """Report on standard error that a file has been written."""
    say(f"wrote {path}")


def save_image(figure: Figure, path: str | Path) -> None:
    """Write a figure to a file, and say so."""
    from asperity.writing import write_image

    write_image(figure, path)
    say_written(path)


@contextmanager
def rows_progress(unit: str) -> Iterator[Callable[[int], None]]:
    """A counter on standard error for work of unknown length; nothing is shown if that is not a terminal."""
    target = rich_console(stderr=True)
    if not target.is_terminal:
        yield lambda done: None
        return
    from asperity.writing import if_abandoned

    with target.status(f"0 {unit}") as status, if_abandoned(status.stop):
        yield lambda done: status.update(f"{done} {unit}")


@contextmanager
def progress_bar(what: str) -> Iterator[Callable[[int, int], Any]]:
    """A bar that shows how much of the work is done; yields what takes the number done and the total."""
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    from asperity.writing import if_abandoned

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    shown = Progress(*columns, console=rich_console(stderr=True), transient=True)
    with shown as progress, if_abandoned(progress.stop):
        task = progress.add_task(f"compiling, then {what}", total=None)

        def report(done: int, total: int) -> None:
            progress.update(task, completed=done, total=total, description=what if done else None)

        yield report


@contextmanager
def about(file: str, *others: str | None) -> Iterator[None]:
    """While the joint of a file is solved: refusals begin with the name of the file.

    ``others`` are further files of the command: a refusal that begins with the name of one of them is about that file.
    Raises what is raised within, after the name.
    """
    try:
        yield
    except (InputError, NoSolutionError) as error:
        if any(str(error).startswith((f"{name}: ", f"{name}, ")) for name in (file, *others)):
            raise
        raise type(error)(f"{file}: {error}", options=error.options) from None


@contextmanager
def about_torque(stated: str | None) -> Iterator[None]:
    """Refusals of a torque begin with the option ``--torque``, or with the key of the file where it is not stated."""
    try:
        yield
    except InputError as error:
        place = "load.output_torque" if stated is None else "--torque"
        raise InputError(f"{place}: {error}" if "torque" in str(error) else str(error)) from None


def read_option(name: str, text: str, dimension: Dimension) -> float:
    """The SI value of an option's text with its unit; a refusal begins with the option."""
    from asperity.units import parse_quantity

    try:
        return parse_quantity(text, dimension)
    except InputError as error:
        raise InputError(f"--{name}: {error}") from None


#: When what contacts feel of a measured surface is computed.
FELT_UNDER_TORQUE = (
    "what the contacts feel of the measured surface is that under the torque of the file, and stays at other torques, "
    "in calibrations and drawn branches; sweeps, charts, designs, sensitivities and samples compute it at every point"
)


def read_case_of_branches(file: str) -> AnyCase:
    """A joint file; notes say that the results are those of its sections ``[[branch]]``, and of a measured surface."""
    from asperity.joint_file.reader import read_case

    case = read_case(file)
    if case.branch is not None:
        click.echo(
            "asperity: note: the results are those of the branches of the file, [[branch]]; contacts and rollers have "
            "the number of theirs",
            err=True,
        )
    if case.measured is not None and case.measured.heights is not None:
        click.echo(f"asperity: note: {FELT_UNDER_TORQUE}", err=True)
    return case


def prepare_computation() -> None:
    """Compute in double precision, and keep compiled programs between commands."""
    from asperity.precision import use_compilation_cache, use_double_precision

    use_double_precision()
    use_compilation_cache()


def print_json(document: dict[str, Any]) -> None:
    """Print one JSON document, which has no number that JSON does not know."""
    import json

    click.echo(json.dumps(in_unicode(document), indent=2, allow_nan=False))


def in_unicode(document: Any) -> Any:
    """A JSON document in which lone surrogates, which names of files that are not UTF-8 have, are escape sequences."""
    if isinstance(document, str):
        return document.encode("utf-8", "backslashreplace").decode("utf-8")
    if isinstance(document, dict):
        return {in_unicode(name): in_unicode(value) for name, value in document.items()}
    return [in_unicode(value) for value in document] if isinstance(document, list | tuple) else document


def json_option(text: str = "Print one JSON document in SI units instead of tables.") -> Callable[..., Any]:
    """The option ``--json`` of a command, its argument ``as_json``."""
    return click.option("--json", "as_json", is_flag=True, help=text)


def plot_option(text: str) -> Callable[..., Any]:
    """The option ``--plot`` of a command that draws, its argument ``plot_file``."""
    return click.option("--plot", "plot_file", type=click.Path(dir_okay=False), help=text)


def plot_option_of(image: str, text: str) -> Callable[..., Any]:
    """The option ``--plot`` of a study, which draws to ``image`` where no name is given, its argument ``plot``."""
    return click.option(
        "--plot", is_flag=False, flag_value=image, type=click.Path(), metavar="[IMAGE]", help=text
    )


def surface_option(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the options ``--surface``, as the argument ``surfaces``, and ``--measurement-of``."""
    from asperity.surface.measurement_of import WORDS

    text = (
        "Measured surface of all contacts, from 'asperity surface measure --json', that both bodies of a contact have; "
        "twice: one for each body."
    )
    option = click.option(
        "--surface", "surfaces", multiple=True, type=click.Path(), metavar="MEASUREMENT", help=text
    )
    of = click.option(
        "--measurement-of",
        type=click.Choice(WORDS),
        help="What one --surface is of: one body, as both then are, or the pair of both together.  [default: what its "
        "document says: a pair where 'asperity surface combine' made it]",
    )
    return option(of(command))


def refuse_lonely_measurement_of(surfaces: tuple[str, ...], measurement_of: str | None) -> None:
    """Raise an ``InputError`` if it is said of what a measurement is where none is given."""
    from asperity.errors import InputError

    if measurement_of is not None and not surfaces:
        raise InputError(
            "--measurement-of belongs to --surface; in the joint file it is surface.measurement_of"
        )


def title_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the options of a title block, as keyword arguments of the same names."""
    for name, text in reversed(_TITLE.items()):
        command = click.option(f"--{name}", default="", help=text)(command)
    return command


def check_title(stated: dict[str, str]) -> None:
    """Refuse an option of the title block that is too long."""
    from asperity.show.title_block import stated_title

    stated_title(stated, option="--")
