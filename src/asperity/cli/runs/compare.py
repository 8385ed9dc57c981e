"""What the command of :mod:`asperity.cli.compare` does."""

from __future__ import annotations

from asperity.api.comparison import compare as compared
from asperity.cli.terminal import print_json, show_blocks


def compare(one: str, other: str, as_json: bool, in_full: bool) -> None:
    """What ``asperity compare`` does; its options stand in :mod:`asperity.cli.compare`."""
    comparison = compared(one, other)
    if as_json:
        print_json(comparison.document())
        return
    show_blocks(*comparison.blocks(in_full=in_full))
