"""``asperity init``: an example joint file."""

from __future__ import annotations

import click


@click.command()
@click.argument("file", type=click.Path(), default="joint.toml")
@click.option("--force", is_flag=True, help="Overwrite FILE if it exists.")
def init(file: str, force: bool) -> None:
    """Write a commented joint file, the joint of Zou et al. 2025, to FILE (joint.toml; '-' prints it)."""
    from importlib.resources import files
    from pathlib import Path

    from asperity.cli.terminal import prepare_output, say
    from asperity.errors import InputError
    from asperity.writing import write_text

    text = files("asperity.joint_file").joinpath("zou2025.toml").read_text(encoding="utf-8")
    if file == "-":
        prepare_output()
        click.echo(text, nl=False)
        return
    if Path(file).exists() and not force:
        raise InputError(f"{file} already exists; choose another name, or overwrite it with --force")
    write_text(text, file)
    say(f"wrote {file}; next: asperity joint {file}")
