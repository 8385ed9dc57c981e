"""Options that several commands have, and the numbers with units that options state."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

import click

from asperity.errors import InputError
from asperity.surface.measurement_of import WORDS
from asperity.unit_table import Dimension
from asperity.units import parse_quantity

#: A command, or the function that becomes one.
_Command = TypeVar("_Command", bound=Callable[..., object] | click.Command)

#: Options of a title block.
_TITLE = {
    "project": "Project for the title block; nothing is filled in without it, as for the next three.",
    "part": "Number or name of the part for the title block.",
    "revision": "Revision for the title block.",
    "date": "Date for the title block.",
}


def read_option(name: str, text: str, dimension: Dimension) -> float:
    """The SI value of an option's text with its unit; a refusal begins with the option."""
    try:
        return parse_quantity(text, dimension)
    except InputError as error:
        raise InputError(f"--{name}: {error}") from None


def json_option(
    text: str = "Print one JSON document in SI units instead of tables.",
) -> Callable[[_Command], _Command]:
    """The option ``--json`` of a command, its argument ``as_json``."""
    return click.option("--json", "as_json", is_flag=True, help=text)


def plot_option(text: str) -> Callable[[_Command], _Command]:
    """The option ``--plot`` of a command that draws, its argument ``plot_file``."""
    return click.option("--plot", "plot_file", type=click.Path(dir_okay=False), help=text)


def plot_option_of(image: str, text: str) -> Callable[[_Command], _Command]:
    """The option ``--plot`` of a study, which draws to ``image`` where no name is given, its argument ``plot``."""
    return click.option(
        "--plot", is_flag=False, flag_value=image, type=click.Path(), metavar="[IMAGE]", help=text
    )


def surface_option(command: _Command) -> _Command:
    """Give a command the options ``--surface``, as the argument ``surfaces``, and ``--measurement-of``."""
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


def title_options(command: _Command) -> _Command:
    """Give a command the options of a title block, as keyword arguments of the same names."""
    for name, text in reversed(_TITLE.items()):
        command = click.option(f"--{name}", default="", help=text)(command)
    return command
