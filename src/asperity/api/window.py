"""The window of a joint in a script: the torques that it may pass over temperature or preload."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, displayed, frame
from asperity.errors import InputError, quoted
from asperity.joint_file.si_tables import key_at, si_values
from asperity.joint_file.window import OVERS, POINTS, Over, joint_window, window_key
from asperity.results.window import Window
from asperity.results.window_document import window_columns, window_document
from asperity.show.style import plain_title
from asperity.show.window_figure import window_figure
from asperity.types import Document
from asperity.views.blocks import Block, Heading
from asperity.views.window import window as window_shown

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure


def window(
    joint: DescribedJoint,
    *,
    over: Over | None = None,
    start: str | NamedQuantity | None = None,
    stop: str | NamedQuantity | None = None,
    points: int = POINTS,
    report: Callable[[int, int], None] | None = None,
) -> JointWindow:
    """Output torques that a joint may pass over its working temperature or its preload, and what limits them where.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.
    over : {"temperature", "preload"}, optional
        The axis: the working temperature, or the preload or interference that the file states. By default the
        temperature where the preload or a seat in a housing depends on it.
    start, stop : str or NamedQuantity, optional
        Ends of the axis with their unit, such as ``"-20 degC"``, ``"400 N"`` or ``"20 um"``.
        By default they lie around the file.
    points : int, optional
        Number of places on the axis; those at which another limit governs come in addition.
    report : callable, optional
        Takes the number of steps done, and of all.

    Returns
    -------
    JointWindow
        Limits over the axis, and whether every load of the file lies below them.

    Raises
    ------
    InputError
        If an end has no unit or is out of range, the ends do not rise, there are fewer than 2 points, temperature
        changes nothing, or the bodies do not fit.
    """
    require_joint(joint)
    if over is not None and over not in OVERS:
        raise InputError(f"expected over='temperature' or 'preload', got {quoted(over)}")
    key = window_key(si_values(joint.case), over)
    dimension = key_at(key).dimension
    ends = {
        name: None if end is None else si_number(end, dimension, name=f"{name} of the window")
        for name, end in (("start", start), ("stop", stop))
    }
    return JointWindow(joint, joint_window(joint.case, over=over, points=points, report=report, **ends))


class JointWindow(Shown):
    """The torques that a joint may pass: what ``asperity window`` prints and draws.

    Parameters
    ----------
    joint : DescribedJoint
        The joint.
    window : Window
        Limits over the axis, as arrays in SI units.
    """

    def __init__(self, joint: DescribedJoint, window: Window) -> None:
        self.joint, self.window = joint, window
        self.document: Document = window_document(window)

    @property
    def inside(self) -> bool:
        """Whether every load of the file lies inside the window where the joint works."""
        return bool(self.document["verdict"]["inside"])

    def to_frame(self) -> pandas.DataFrame:
        """Torque capacity and every limit over the axis as a pandas data frame, units in the column names."""
        return frame({name: np.asarray(column) for name, column in window_columns(self.window).items()})

    def plot(self) -> Figure:
        """Draw the window with the loads in it.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        return displayed(window_figure(self.window, title=plain_title(self.joint.source)))

    def blocks(self) -> list[Block]:
        """What ``asperity window`` prints."""
        return [Heading(self.joint.source), *window_shown(self.document)]
