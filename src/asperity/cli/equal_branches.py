"""Commands say whose results theirs are where a joint file states branches of unlike sizes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from asperity.joint_file.si_tables import AnyCase


def read_for_equal_branches(file: str) -> AnyCase:
    """Read a joint file for a command that leaves its sections ``[[branch]]`` out, and say so.

    Parameters
    ----------
    file : str
        The joint file.

    Returns
    -------
    PlanarCase
        As read.
    """
    from asperity.joint_file.reader import read_case

    case = read_case(file)
    if case.branch is not None:
        say_whose_branches(own=False)
    return case


def read_for_own_branches(file: str) -> AnyCase:
    """Read a joint file for a command whose results are those of its own branches, and say so.

    Parameters
    ----------
    file : str
        The joint file.

    Returns
    -------
    PlanarCase
        As read, for :func:`asperity.joint_file.own_branches.with_own_branches`.
    """
    from asperity.joint_file.reader import read_case

    case = read_case(file)
    if case.branch is not None:
        say_whose_branches(own=True)
    return case


def say_whose_branches(*, own: bool) -> None:
    """Say whose results follow."""
    said = (
        "the results are those of the branches of the file, [[branch]]; contacts and rollers have the number of theirs"
        if own
        else "the results are those of equal branches; [[branch]] counts in 'asperity joint', 'loads', 'roll', "
        "'windup', 'dynamics', 'export' and 'report'"
    )
    click.echo(f"asperity: note: {said}", err=True)
