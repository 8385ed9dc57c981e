"""``asperity init``: an example joint file."""

from __future__ import annotations

import click

#: Types of drives, the paper's first; each has an example of its name.
TYPES = ("zou2025", "planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar")

_OF_THE_PAPER = "# the paper's closure"  # lines of its example that a designer's file must not inherit


@click.command()
@click.argument("file", type=click.Path(), default="joint.toml")
@click.option(
    "--type",
    "kind",
    type=click.Choice(TYPES),
    default=TYPES[0],
    show_default=True,
    help="Type of the drive.",
)
@click.option("--force", is_flag=True, help="Overwrite FILE if it exists.")
def init(file: str, kind: str, force: bool) -> None:
    """Write a commented joint file to FILE (joint.toml; '-' prints it): that of Zou et al. 2025, or another drive."""
    from importlib.resources import files
    from pathlib import Path

    from asperity.cli.terminal import prepare_output, say
    from asperity.errors import InputError
    from asperity.writing import write_text

    example = files("asperity.joint_file").joinpath(f"{kind}.toml").read_text(encoding="utf-8")
    text = "".join(line for line in example.splitlines(keepends=True) if _OF_THE_PAPER not in line)
    if file == "-":
        prepare_output()
        click.echo(text, nl=False)
        return
    if Path(file).exists() and not force:
        raise InputError(f"{file} already exists; choose another name, or overwrite it with --force")
    write_text(text, file)
    say(f"wrote {file}; next: asperity joint {file}")
