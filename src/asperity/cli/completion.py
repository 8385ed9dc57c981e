"""``asperity completion``: shell scripts that complete commands and options."""

from __future__ import annotations

import click


@click.command()
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
def completion(shell: str) -> None:
    """Print a script that completes asperity's commands in SHELL.

    For bash, add  eval "$(asperity completion bash)"  to ~/.bashrc; for zsh likewise to ~/.zshrc. For fish:
    asperity completion fish > ~/.config/fish/completions/asperity.fish
    """
    from click.shell_completion import get_completion_class

    from asperity.cli import asperity

    completer = get_completion_class(shell)
    if completer is None:
        raise click.UsageError(f"click does not support completion for {shell}")
    click.echo(completer(asperity, {}, "asperity", "_ASPERITY_COMPLETE").source())
