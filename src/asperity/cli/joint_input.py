"""The joint file of a command: read with the notes that are due, and what is refused of the options that go with it."""

from __future__ import annotations

import click

from asperity.errors import InputError
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import AnyCase
from asperity.show.title_block import stated_title

#: When what contacts feel of a measured surface is computed.
FELT_UNDER_TORQUE = (
    "what the contacts feel of the measured surface is that under the torque of the file, and stays at other torques, "
    "in calibrations and drawn branches; sweeps, charts, designs, sensitivities and samples compute it at every point"
)


def read_case_of_branches(file: str) -> AnyCase:
    """A joint file; notes say that the results are those of its sections ``[[branch]]``, and of a measured surface."""
    case = read_case(file)
    if case.branch is not None:
        click.echo(
            "asperity: note: the results are those of the branches of the file, [[branch]]; contacts and rollers have "
            "the number of theirs",
            err=True,
        )
    if case.measured is not None and case.measured.heights is not None:
        click.echo(f"asperity: note: {FELT_UNDER_TORQUE}", err=True)
    return case


def refuse_lonely_measurement_of(surfaces: tuple[str, ...], measurement_of: str | None) -> None:
    """Raise an ``InputError`` if it is said of what a measurement is where none is given."""
    if measurement_of is not None and not surfaces:
        raise InputError(
            "--measurement-of belongs to --surface; in the joint file it is surface.measurement_of"
        )


def check_title(stated: dict[str, str]) -> None:
    """Refuse an option of the title block that is too long."""
    stated_title(stated, option="--")
