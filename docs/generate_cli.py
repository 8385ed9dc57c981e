"""Write docs/cli.md from the help texts of the commands: `python docs/generate_cli.py` (`--check` only compares)."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import click

from asperity.cli.commands import asperity

PAGE = Path(__file__).with_name("cli.md")

HEAD = """\
# Command line

<!-- Written by docs/generate_cli.py from the help texts; edit those, then run it. -->

Quantities in a joint file are text with a unit; results are written with theirs, and `--json` gives SI. Exit codes:
0 fine, 2 bad input (one sentence with the value, the allowed range and what to do), 3 no solution, 130 interrupted.
"""


def _help_texts(command: click.Command, context: click.Context) -> Iterator[tuple[str, str]]:
    """Full name and help text of a command and of all below it."""
    yield context.command_path, command.get_help(context)
    if isinstance(command, click.Group):
        for name in command.list_commands(context):
            child = command.get_command(context, name)
            if child is not None and not child.hidden:
                yield from _help_texts(child, _context(child, name, context))


def _context(command: click.Command, name: str, parent: click.Context | None = None) -> click.Context:
    settings = {"help_option_names": ["-h", "--help"], "terminal_width": 100, "max_content_width": 100}
    return click.Context(command, info_name=name, parent=parent, **settings)


def page() -> str:
    """The page as it must be."""
    parts = [HEAD]
    for path, text in _help_texts(asperity, _context(asperity, "asperity")):
        parts.append(f"## {path}\n\n```text\n{text.rstrip()}\n```\n")
    return "\n".join(parts)


def main() -> int:
    """Write the page, or with --check say whether it is current."""
    if "--check" in sys.argv[1:]:
        if PAGE.read_text(encoding="utf-8") == page():
            return 0
        print("docs/cli.md is out of date: run `python docs/generate_cli.py`", file=sys.stderr)
        return 1
    PAGE.write_text(page(), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
