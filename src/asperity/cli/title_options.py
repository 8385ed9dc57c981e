"""The options of a title block, which drawing and report have in common."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import click

from asperity.errors import InputError

if TYPE_CHECKING:
    from asperity.show.title_block import Title

_LONGEST = 60
_HELP = {
    "project": "Project for the title block; nothing is filled in without it, as for the next three.",
    "part": "Number or name of the part for the title block.",
    "revision": "Revision for the title block.",
    "date": "Date for the title block.",
}


def title_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """Give a command the options of a title block, as keyword arguments of the same names."""
    for name, text in reversed(_HELP.items()):
        command = click.option(f"--{name}", default="", help=text)(command)
    return command


def title_of(stated: dict[str, str]) -> Title:
    """The title block of these options, or a refusal of one that is too long."""
    from asperity.show.title_block import Title

    for name, text in stated.items():
        if len(text) > _LONGEST:
            raise InputError(f"--{name}: at most {_LONGEST} characters, got {len(text)}")
    return Title(**stated)
