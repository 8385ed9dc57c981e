"""What the structure of a joint carries, and how it vibrates between motor and load, in a script."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, displayed, frame
from asperity.joint.pin_bound import bound_document, bounded
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.section_build import inertias_from_case
from asperity.joint_file.solved_document import solved_case
from asperity.results.dynamics_document import dynamics_document, response_columns
from asperity.results.loads_document import bearing_entries, loads_document, shown_rows
from asperity.show.dynamics_figure import dynamics_figure
from asperity.show.style import plain_title
from asperity.standing.dynamics import Dynamics
from asperity.standing.dynamics import dynamics as solved_dynamics
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.views.blocks import Block, Heading
from asperity.views.dynamics import dynamics as dynamics_shown
from asperity.views.loads import case_title
from asperity.views.loads import loads as loads_shown

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure


def loads(joint: DescribedJoint, *, mounting_gap: str | NamedQuantity = "0 um") -> JointLoads:
    """Forces and torques on pins, bearings, shafts and housing, for their supplier, and what mounts the rings.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.
    mounting_gap : str or NamedQuantity, optional
        Radial gap between a ring and its rollers while it is slipped on, with its unit.

    Returns
    -------
    JointLoads
        Without torque, under the working torque, and under every load of the duty.

    Raises
    ------
    InputError
        If the rollers do not fit, or the output torque is beyond the standing torque capacity.
    NoSolutionError
        If the force balance does not close.
    """
    require_joint(joint)
    gap = si_number(mounting_gap, Dimension.LENGTH, name="mounting_gap")
    solved = solved_case(joint.case)
    return JointLoads(joint.source, loads_document(solved, bearing_entries(solved), gap))


class JointLoads(Shown):
    """What a joint's structure carries.

    Parameters
    ----------
    source : str
        Where the joint comes from.
    document : dict
        What ``asperity loads --json`` prints, in SI units.
    """

    def __init__(self, source: str, document: Document) -> None:
        self.source, self.document = source, document

    def columns(self) -> dict[str, list[object]]:
        """One row a load: part, position, load, unit of the row, and its value in each case."""
        titles = ["part", "position", "load", "unit"]
        titles += [case_title(case, ", ") for case in self.document["cases"]]
        rows = (
            (*words, *(np.nan if value is None else value for value in values))
            for *words, values in shown_rows(self.document)
        )
        return dict(zip(titles, map(list, zip(*rows, strict=True)), strict=True))

    def to_frame(self) -> pandas.DataFrame:
        """The same as a pandas data frame."""
        return frame(self.columns())

    def blocks(self) -> list[Block]:
        """What ``asperity loads`` prints."""
        return [Heading(self.source), *loads_shown(self.document)]


def dynamics(joint: DescribedJoint) -> JointDynamics:
    """Natural frequencies and frequency response between motor and load, linear about the output torque.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`; its file has the inertias of ``[dynamics]``.

    Returns
    -------
    JointDynamics
        Frequencies, response, and both over the torque.

    Raises
    ------
    InputError
        If the file has no section ``[dynamics]``, or the joint cannot carry its torque.
    NoSolutionError
        If the force balance does not close.
    """
    require_joint(joint)
    case = joint.case
    inertias, described = inertias_from_case(case), with_own_branches(case)
    solved = solved_dynamics(described, inertias)
    document = dynamics_document(solved, inertias) | bound_document(described)
    document |= {"of_own_branches": described.unlike is not None}
    damped = case.dynamics is not None and case.dynamics.loss_factor is not None
    return JointDynamics(joint.source, document, solved, damped=damped)


class JointDynamics(Shown):
    """Vibrations of a joint between motor and load.

    Parameters
    ----------
    source : str
        Where the joint comes from.
    document : dict
        What ``asperity dynamics --json`` prints, in SI units.
    solved : Dynamics
        Frequencies and responses as arrays.
    damped : bool
        Whether the file states how much work the spring loses.
    """

    def __init__(self, source: str, document: Document, solved: Dynamics, *, damped: bool) -> None:
        self.source, self.document, self.solved, self._damped = source, document, solved, damped

    def response(self) -> Mapping[str, np.ndarray]:
        """The frequency response as columns, units in their names."""
        return response_columns(self.solved)

    def to_frame(self) -> pandas.DataFrame:
        """The same as a pandas data frame."""
        return frame(dict(self.response()))

    def plot(self) -> Figure:
        """Draw the frequency response, and the natural frequencies over torque.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        words = f"{plain_title(self.source)} between motor and load"
        title = bounded(words, self.document["stiffness_bound"])
        return displayed(dynamics_figure(self.solved, title=title))

    def blocks(self) -> list[Block]:
        """What ``asperity dynamics`` prints."""
        own = ": of its own branches" if self.document["of_own_branches"] else ""
        return [Heading(f"{self.source}{own}"), *dynamics_shown(self.document, damped=self._damped)]
