"""Where commands print: plain text when piped, at most 100 columns, legible without Unicode; shared options.

What users wrote in files and on the command line appears in output. :func:`checked_output` lets none of it reach a
terminal as a control sequence, and turns a full disk behind standard output into one sentence.
"""

from __future__ import annotations

import codecs
import json
import os
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

import click

from asperity.errors import InputError, NoSolutionError, printable
from asperity.views.terminal import WIDEST, console_on, show

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from rich.console import Console

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

    def __init__(self, stream: TextIO | None, name: str, *, escape: bool, required: bool) -> None:
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
            if self.stream is not None:
                silence(self.stream)
            if self._required:
                raise InputError(f"{self._name} cannot be written: {error.strerror or error}") from None


def silence(stream: TextIO) -> None:
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


def print_json(document: Mapping[str, object]) -> None:
    """Print one JSON document, which has no number that JSON does not know."""
    click.echo(json.dumps(in_unicode(document), indent=2, allow_nan=False))


def in_unicode(document: object) -> object:
    """A JSON document in which lone surrogates, which names of files that are not UTF-8 have, are escape sequences."""
    if isinstance(document, str):
        return document.encode("utf-8", "backslashreplace").decode("utf-8")
    if isinstance(document, dict):
        return {in_unicode(name): in_unicode(value) for name, value in document.items()}
    return [in_unicode(value) for value in document] if isinstance(document, list | tuple) else document
