"""A joint that turns, in a script: drift, losses and life."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.shown import displayed
from asperity.api.solution import JointSolution
from asperity.joint.solve import refuse_no_rolling
from asperity.joint_file.solved_document import solved_case
from asperity.rolling.curves import rolling_curves
from asperity.show.rolling_figure import rolling_figure
from asperity.show.style import plain_title
from asperity.views.blocks import Block
from asperity.views.screens import rolling_screen

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_WIDTH = 10.0  # of the picture [in]


def roll(joint: DescribedJoint) -> JointRolling:
    """Drift, losses, axial thrust and life of a joint that turns.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.

    Returns
    -------
    JointRolling
        All results with names and units, as :class:`asperity.api.solution.JointSolution` has them.

    Raises
    ------
    InputError
        If the rollers do not fit, or the output torque is beyond the standing torque capacity.
    NoSolutionError
        If the force balance does not close, or the joint does not roll steadily.
    """
    require_joint(joint)
    solved = solved_case(joint.case)
    refuse_no_rolling(solved.joint, solved.solution)
    return JointRolling(joint.case, solved, source=joint.source, summary=joint.summary)


class JointRolling(JointSolution):
    """A solved joint, printed and drawn as one that turns."""

    def plot(self) -> Figure:
        """Draw creep curves, efficiency, drift and life.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        joint, result = self._solved.joint, self._solved.result
        capacity = self.document["rolling"]["torque_capacity_Nm"]  # None where friction does not limit it
        curves = rolling_curves(
            joint=joint,
            result=result,
            laws=self.solution.laws,
            torque_capacity=math.copysign(
                math.inf if capacity is None else capacity, float(joint.output_torque)
            ),
        )
        title = f"{plain_title(self._source)} in rolling"
        return displayed(rolling_figure(curves, result.rolling, joint=joint, title=title, width=_WIDTH))

    def blocks(self) -> list[Block]:
        """What ``asperity roll`` prints, without the assumptions."""
        return list(rolling_screen(self.view, self._source))
