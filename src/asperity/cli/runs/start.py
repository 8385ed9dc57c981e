"""What the command of :mod:`asperity.cli.start` does."""

from __future__ import annotations

import json
from pathlib import Path

import click
from click.shell_completion import get_completion_class

from asperity.cli.commands import asperity
from asperity.cli.terminal import prepare_output, say
from asperity.errors import InputError
from asperity.joint_file.schema import joint_schema
from asperity.joint_file.template import template
from asperity.writing import write_text

#: Marks lines of the paper's example that a designer's file must not inherit.
_OF_THE_PAPER = "# the paper's closure"


def init(file: str, kind: str, force: bool) -> None:
    """What ``asperity init`` does; its options stand in :mod:`asperity.cli.start`."""
    text = "".join(line for line in template(kind).splitlines(keepends=True) if _OF_THE_PAPER not in line)
    if file == "-":
        prepare_output()
        click.echo(text, nl=False)
        return
    if Path(file).exists() and not force:
        raise InputError(f"{file} already exists; choose another name, or overwrite it with --force")
    if Path(file).is_symlink():
        raise InputError(f"{file}: this is a link; give the name of the file itself")
    write_text(text, file)
    say(f"wrote {file}; next: asperity joint {file}")


def schema(kind: str) -> None:
    """What ``asperity schema`` does; its options stand in :mod:`asperity.cli.start`."""
    click.echo(json.dumps(joint_schema(kind), indent=2))


def completion(shell: str) -> None:
    """What ``asperity completion`` does; its options stand in :mod:`asperity.cli.start`."""
    completer = get_completion_class(shell)
    if completer is None:
        raise click.UsageError(f"click does not support completion for {shell}")
    click.echo(completer(asperity, {}, "asperity", "_ASPERITY_COMPLETE").source())
