"""Commands whose results are those of equal branches say so where a joint file states others."""

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
    Case or PlanarCase
        As read.
    """
    from asperity.joint_file.reader import read_any_case

    case = read_any_case(file)
    if case.branch is not None:
        click.echo(
            "asperity: note: the results are those of equal branches; [[branch]] counts in 'asperity joint', 'loads' "
            "and 'report'",
            err=True,
        )
    return case
