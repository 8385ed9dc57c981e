"""Wear of a joint in a script: depths, preload, capacity and drift over its life, and where it ends."""

from __future__ import annotations

from typing import TYPE_CHECKING

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, displayed, frame
from asperity.joint_file.wear import wear_of_case
from asperity.results.wear_document import WearOverLife, wear_columns, wear_document
from asperity.show.style import plain_title
from asperity.show.wear_figure import wear_figure
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.views.blocks import Block, Heading
from asperity.views.wear import wear as wear_shown

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure


def wear(joint: DescribedJoint, *, life: str | NamedQuantity | None = None) -> WornJoint:
    """Wear of a joint over its life: depths of its tracks, preload, capacity, drift, and where it ends.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`; its file states ``load.interference``, or a cam. With a section ``[wear]`` times
        are in hours, without one they are products with the wear coefficient.
    life : str or NamedQuantity, optional
        That the joint is to reach, such as ``"10000 h"``; by default ``rolling.required_life`` of the file.

    Returns
    -------
    WornJoint
        Numbers over time, both ends, and the wear coefficient that the life allows.

    Raises
    ------
    InputError
        If the preload is a force, nothing slips or a contact slips as a whole at the start, the life has no unit or is
        out of range, or the bodies do not fit.
    NoSolutionError
        If no balance was found.
    """
    require_joint(joint)
    seconds = None if life is None else si_number(life, Dimension.TIME, name="life")
    return WornJoint(joint, wear_of_case(joint.case, life=seconds))


class WornJoint(Shown):
    """Wear of a joint over its life: what ``asperity wear`` prints and draws.

    Parameters
    ----------
    joint : DescribedJoint
        The joint.
    wear : WearOverLife
        Numbers over time, as arrays in SI units.
    """

    def __init__(self, joint: DescribedJoint, wear: WearOverLife) -> None:
        self.joint, self.wear = joint, wear
        self.document: Document = wear_document(wear)

    def to_frame(self) -> pandas.DataFrame:
        """The course of wear as a pandas data frame, units in the column names."""
        return frame(wear_columns(self.wear))

    def plot(self) -> Figure:
        """Draw preload, torque capacity and drift over time, with both ends.

        A notebook shows the figure; elsewhere call its ``savefig``. An ``InputError`` where a cam or a spring keeps the
        force: nothing changes over time.
        """
        return displayed(wear_figure(self.wear, title=plain_title(self.joint.source)))

    def blocks(self) -> list[Block]:
        """What ``asperity wear`` prints."""
        return [Heading(self.joint.source), *wear_shown(self.document)]
