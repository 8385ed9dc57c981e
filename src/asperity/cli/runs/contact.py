"""What the command of :mod:`asperity.cli.contact` does."""

from __future__ import annotations

from asperity.cli.progress import rows_progress
from asperity.cli.terminal import say
from asperity.contact.asperity import AsperityBase
from asperity.errors import InputError
from asperity.joint_file.contact_table import convert_contact_table
from asperity.joint_file.limits import FREQUENCY_RATIO


def contact(table: str, out: str, gamma: float, asperity_base: AsperityBase) -> None:
    """What ``asperity contact`` does; its options stand in :mod:`asperity.cli.contact`."""
    try:
        FREQUENCY_RATIO.check(gamma)
    except InputError as error:
        raise InputError(f"--gamma: {error}") from None
    with rows_progress("rows") as progress:
        summary = convert_contact_table(
            table,
            out,
            frequency_ratio=gamma,
            asperity_base=asperity_base,
            progress=progress,
        )
    if summary.replaced_columns:
        say(f"replaced the columns {', '.join(summary.replaced_columns)} of {table}")
    say(f"wrote {out}: {summary.rows} roller pair{'s' * (summary.rows != 1)}")
    if summary.plastic_rows:
        say(
            f"Kt and Kn are nan in {summary.plastic_rows} of them: every spot is plastic (a_l <= a_c), where the "
            "contact law has no stiffness; real surfaces keep one, which needs boundary elements"
        )
