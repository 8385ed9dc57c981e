"""Commands run in this process, with errors as they are raised."""

from click.testing import CliRunner

from asperity.cli.commands import asperity


def run(*arguments):
    """What a command prints, and its exit code."""
    return CliRunner().invoke(asperity, list(arguments), catch_exceptions=False)
