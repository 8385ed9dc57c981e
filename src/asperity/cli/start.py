"""Commands to start with: an example joint file, the schema of joint files, completion in the shell."""

from __future__ import annotations

import click

#: Packaged examples, the paper's first.
EXAMPLES = ("zou2025", "planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar")

_OF_THE_PAPER = "# the paper's closure"  # lines of its example that a designer's file must not inherit
#: Types of drives; the hollow planetary is an example of one.
TYPES = tuple(name for name in EXAMPLES if name != "planetary_hollow")


@click.command()
@click.argument("file", type=click.Path(), default="joint.toml")
@click.option(
    "--type",
    "kind",
    type=click.Choice(EXAMPLES),
    default=EXAMPLES[0],
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
    if Path(file).is_symlink():
        raise InputError(f"{file}: this is a link; give the name of the file itself")
    write_text(text, file)
    say(f"wrote {file}; next: asperity joint {file}")


@click.command()
@click.option(
    "--type", "kind", type=click.Choice(TYPES), default=TYPES[0], show_default=True, help="Type of the drive."
)
def schema(kind: str) -> None:
    """Print the JSON schema of joint files, which lets editors check and complete them.

    Save it next to the joint file and refer to it in the first line of that file: '#:schema ./joint.schema.json'.
    """
    import json

    from asperity.joint_file.schema import joint_schema

    click.echo(json.dumps(joint_schema(kind), indent=2))


@click.command()
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
def completion(shell: str) -> None:
    """Print a script that completes asperity's commands in SHELL.

    For bash, add  eval "$(asperity completion bash)"  to ~/.bashrc; for zsh likewise to ~/.zshrc. For fish:
    asperity completion fish > ~/.config/fish/completions/asperity.fish
    """
    from click.shell_completion import get_completion_class

    from asperity.cli.commands import asperity

    completer = get_completion_class(shell)
    if completer is None:
        raise click.UsageError(f"click does not support completion for {shell}")
    click.echo(completer(asperity, {}, "asperity", "_ASPERITY_COMPLETE").source())
