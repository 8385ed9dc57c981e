"""Commands to start with: an example joint file, the schema of joint files, completion in the shell."""

from __future__ import annotations

import click
from click.shell_completion import CompletionItem

from asperity.cli.run_by_name import run_by_name
from asperity.precision import note_once

#: The type of a file that states none, which the options need not look for.
_DEFAULT = "wedge"
#: The type to begin with: a plain planetary, whose example works.
_FIRST = "planetary"


class TypeName(click.ParamType):
    """The name of a type of drive or, with ``variants``, of a joint file to start with; a former name is told.

    The types are looked for when somebody asks for one.
    """

    name = "choice"

    def __init__(self, *, variants: bool = False) -> None:
        self._variants = variants

    def _choice(self) -> click.Choice[str]:
        """The names as they are now."""
        from asperity.drive.types import TYPES
        from asperity.joint_file.template import names_of_templates

        return click.Choice(names_of_templates() if self._variants else tuple(TYPES))

    def convert(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The name that a type has now."""
        from asperity.drive.types import FORMER_NAMES

        if value in FORMER_NAMES:
            note_once(f'the type "{value}" is called "{FORMER_NAMES[value]}" now')
        return self._choice().convert(FORMER_NAMES.get(value, value), param, ctx)

    def get_metavar(self, param: click.Parameter, ctx: click.Context) -> str | None:
        """All names, for the help."""
        return self._choice().get_metavar(param, ctx)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        """The names that begin so."""
        return self._choice().shell_complete(ctx, param, incomplete)


@click.command()
@click.argument("file", type=click.Path(), default="joint.toml")
@click.option(
    "--type",
    "kind",
    type=TypeName(variants=True),
    default=_FIRST,
    show_default=True,
    help="Type of the drive; wedge is the joint of Zou et al. 2025.",
)
@click.option("--force", is_flag=True, help="Overwrite FILE if it exists.")
@run_by_name
def init() -> None:
    """Write a commented joint file to FILE (joint.toml if not stated; '-' prints it).

    Edit its numbers, then run 'asperity joint FILE'.
    """


@click.command()
@click.option(
    "--type", "kind", type=TypeName(), default=_DEFAULT, show_default=True, help="Type of the drive."
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
