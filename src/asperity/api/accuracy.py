"""The accuracy of a joint over a turn in a script: transmission error, forces and input torque."""

from __future__ import annotations

from typing import TYPE_CHECKING

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, displayed, frame
from asperity.joint_file.accuracy import joint_accuracy
from asperity.results.accuracy_document import AccuracyOfJoint, accuracy_document, turn_columns
from asperity.show.accuracy_figure import accuracy_figure
from asperity.show.style import plain_title
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.views.accuracy import accuracy as accuracy_shown
from asperity.views.blocks import Block, Heading

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure


def accuracy(
    joint: DescribedJoint,
    *,
    reverse: bool = False,
    allowed: str | NamedQuantity | None = None,
    uncertainty: str | float | NamedQuantity | None = None,
) -> JointAccuracy:
    """Transmission error, forces and input torque over a turn of a joint whose parts have form errors.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`; its file states form errors in sections ``[[form]]``.
    reverse : bool, optional
        Whether the other direction of rotation under the same torque is computed too.
    allowed : str or NamedQuantity, optional
        Error of the position that is allowed, such as ``"5 arcmin"``, for the turns between two findings of the
        reference; by default none.
    uncertainty : str, float or NamedQuantity, optional
        Uncertainty of the drift by which a controller corrects the position, such as ``"20 %"``; by default nothing
        corrects it.

    Returns
    -------
    JointAccuracy
        Components, worst and root mean square, and one turn.

    Raises
    ------
    InputError
        If the file states no form errors or such that no part can have, an angle or a share has no unit or is out of
        range, or the bodies do not fit.
    NoSolutionError
        If the joint does not roll steadily under its torque.
    """
    require_joint(joint)
    angle = None if allowed is None else si_number(allowed, Dimension.ANGLE, name="allowed error")
    share = (
        None if uncertainty is None else si_number(uncertainty, Dimension.DIMENSIONLESS, name="uncertainty")
    )
    found = joint_accuracy(joint.case, reverse=reverse)
    return JointAccuracy(joint, found, accuracy_document(found, allowed=angle, uncertainty=share))


class JointAccuracy(Shown):
    """A joint with form errors over a turn: what ``asperity accuracy`` prints and draws.

    Parameters
    ----------
    joint : DescribedJoint
        The joint.
    accuracy : AccuracyOfJoint
        Numbers as arrays in SI units.
    document : dict
        The document of the command.
    """

    def __init__(self, joint: DescribedJoint, accuracy: AccuracyOfJoint, document: Document) -> None:
        self.joint, self.accuracy = joint, accuracy
        self.document: Document = document

    def to_frame(self) -> pandas.DataFrame:
        """One turn of the output as a pandas data frame, units in the column names."""
        return frame(turn_columns(self.accuracy.over_turn, self.accuracy.forward.contact_names))

    def plot(self) -> Figure:
        """Draw the orders, and one turn of the output as a curve and as a polar picture.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        return displayed(accuracy_figure(self.accuracy, title=plain_title(self.joint.source)))

    def blocks(self) -> list[Block]:
        """What ``asperity accuracy`` prints."""
        return [Heading(self.joint.source), *accuracy_shown(self.document)]
