"""Commands to start with: an example joint file, the schema of joint files, completion in the shell."""

from __future__ import annotations

import click

from asperity.cli.run_by_name import run_by_name

#: Packaged examples, the paper's first.
EXAMPLES = ("zou2025", "planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar")

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
@run_by_name
def init() -> None:
    """Write a commented joint file to FILE (joint.toml; '-' prints it): that of Zou et al. 2025, or another drive."""


@click.command()
@click.option(
    "--type", "kind", type=click.Choice(TYPES), default=TYPES[0], show_default=True, help="Type of the drive."
)
@run_by_name
def schema() -> None:
    """Print the JSON schema of joint files, which lets editors check and complete them.

    Save it next to the joint file and refer to it in the first line of that file: '#:schema ./joint.schema.json'.
    """


@click.command()
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@run_by_name
def completion() -> None:
    """Print a script that completes asperity's commands in SHELL.

    For bash, add  eval "$(asperity completion bash)"  to ~/.bashrc; for zsh likewise to ~/.zshrc. For fish:
    asperity completion fish > ~/.config/fish/completions/asperity.fish
    """
