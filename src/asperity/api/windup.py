"""The wind-up of a joint in a script: figures with units, curves as a data frame, a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, displayed, frame
from asperity.errors import InputError
from asperity.joint.pin_bound import bounded
from asperity.joint_file.own_branches import with_own_branches
from asperity.results import LEVELS, known_result
from asperity.results.stiffness_rows import LEVEL_NAMES
from asperity.results.windup_document import (
    examined_windup,
    rolling_columns,
    windup_capacities,
    windup_columns,
    windup_document,
    windup_onsets,
)
from asperity.rolling.onset import RollingOnset
from asperity.show.style import plain_title
from asperity.show.windup_figure import windup_figure
from asperity.standing import STAGE_SHARES
from asperity.standing.windup import StiffnessLevel, Windup
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.views.blocks import Block, Heading
from asperity.views.windup import windup as windup_shown

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure

#: Figures of a wind-up: name, what it is, what it measures, unit of display.
_FIGURES = (
    ("standing_torque_capacity", "standing torque capacity", Dimension.TORQUE, "N*m"),
    ("largest_torque", "largest torque of the curve", Dimension.TORQUE, "N*m"),
    ("windup", "wind-up at the largest torque", Dimension.ANGLE, "arcmin"),
    ("hysteresis", "width of the loop at zero torque", Dimension.ANGLE, "arcmin"),
    ("lost_motion", "lost motion (middle line, ±3 % of the torque)", Dimension.ANGLE, "arcmin"),
    ("dissipated_energy", "energy lost per cycle", Dimension.TORQUE, "J"),
    *(
        (f"K{n}", f"secant stiffness of stage {n}", Dimension.TORSIONAL_STIFFNESS, "N*m/arcmin")
        for n in (1, 2, 3)
    ),
)

#: Figures of the same joint when it turns under the largest torque.
_ROLLING_FIGURES = (
    ("static_input_angle", "static curve holds up to, input", Dimension.ANGLE, "deg"),
    ("static_output_angle", "static curve holds up to, output", Dimension.ANGLE, "deg"),
    ("steady_input_angle", "steady creep from, input", Dimension.ANGLE, "deg"),
    ("steady_output_angle", "steady creep from, output", Dimension.ANGLE, "deg"),
    ("drift_per_output_turn", "drift per output turn", Dimension.ANGLE, "arcmin"),
    ("swing_without_drift_input_angle", "swing without drift, input", Dimension.ANGLE, "deg"),
)


def windup(
    joint: DescribedJoint,
    *,
    torque: str | NamedQuantity | None = None,
    level: StiffnessLevel = "assembly",
    stages: tuple[float, float] = STAGE_SHARES,
    creep_share: float = 0.05,
) -> JointWindup:
    """Torque–angle curve at the output against the locked input, and the angle behind once the input turns.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.
    torque : str or NamedQuantity, optional
        Largest torque with its unit, such as ``"5 N*m"``; by default the output torque of the file.
    level : {"assembly", "series_with_bulk", "published"}, optional
        Which stiffness is integrated.
    stages : tuple of float, optional
        Bounds of the stages K1, K2, K3 as shares of the largest torque.
    creep_share : float, optional
        Creep over wind-up up to which the static curve is said to hold for an input that turns.

    Returns
    -------
    JointWindup
        Figures and curves.

    Raises
    ------
    InputError
        If the torque has no unit, or torque or stages are out of range.
    NoSolutionError
        If the force balance does not close.
    """
    require_joint(joint)
    known_result(level, among=LEVELS, what="level of the stiffness")
    largest = None if torque is None else si_number(torque, Dimension.TORQUE, name="torque")
    described = with_own_branches(joint.case)
    curve, solutions = examined_windup(described, largest_torque=largest, level=level, stage_shares=stages)
    onsets = windup_onsets(described, curve, solutions, creep_share=creep_share)
    document = windup_document(described, curve, solutions, onsets, level=level)
    return JointWindup(joint, curve, onsets[0], document)


class JointWindup(Shown):
    """Wind-up of a joint: ``windup["lost_motion"]`` is a number with its unit.

    Parameters
    ----------
    joint : DescribedJoint
        The joint.
    curve : Windup
        Curves, as arrays in SI units.
    onset : RollingOnset or None
        The same joint when it turns under the largest positive torque; None where there is no steady rolling.
    document : dict
        What ``asperity windup --json`` prints, in SI units.
    """

    def __init__(
        self, joint: DescribedJoint, curve: Windup, onset: RollingOnset | None, document: Document
    ) -> None:
        self.joint, self.curve, self.onset, self.document = joint, curve, onset, document
        self.level: StiffnessLevel = document["level"]
        capacity = document["standing_torque_capacity"]["output_torque_Nm"]
        values = {
            **vars(curve),
            **{f"K{n}": curve.stage_stiffness[n - 1] for n in (1, 2, 3)},
            "standing_torque_capacity": np.inf if capacity is None else capacity,
            "largest_torque": curve.torque[-1],
            "windup": curve.angle[-1],
        }
        figures, bound = _FIGURES, document["stiffness_bound"] or ""
        if onset is not None:
            rolling = document["rolling"]
            figures = (*_FIGURES, *_ROLLING_FIGURES)
            values |= {
                "static_input_angle": rolling["static_curve_up_to"]["input_rad"],
                "static_output_angle": rolling["static_curve_up_to"]["output_rad"],
                "steady_input_angle": rolling["steady_creep_from"]["input_rad"],
                "steady_output_angle": rolling["steady_creep_from"]["output_rad"],
                "drift_per_output_turn": rolling["drift_rad_per_output_turn"],
                "swing_without_drift_input_angle": rolling["swing_without_drift"]["input_rad"],
            }
        self._figures = {
            name: NamedQuantity(
                name,
                label,
                float(np.asarray(values[name])),
                dimension,
                unit,
                level=self.level,
                bound=bound if dimension is Dimension.TORSIONAL_STIFFNESS else "",
            )
            for name, label, dimension, unit in figures
        }

    def __getitem__(self, name: str) -> NamedQuantity:
        """One figure of :meth:`keys`, such as ``lost_motion`` or ``K1``."""
        return self._figures[known_result(name, among=tuple(self._figures), what="figure of a wind-up")]

    def keys(self) -> list[str]:
        """Names of the figures."""
        return list(self._figures)

    def to_frame(self) -> pandas.DataFrame:
        """The loading curve and both branches of the loop as a pandas data frame, units in the column names."""
        return frame({name: np.asarray(column) for name, column in windup_columns(self.curve).items()})

    def rolling_frame(self) -> pandas.DataFrame:
        """Angle behind over the angle turned, and the drift of swings of that angle, as a pandas data frame.

        Raises
        ------
        InputError
            If the joint has no steady rolling at the largest torque.
        """
        if self.onset is None:
            raise InputError(self.document["rolling"]["unknown_because"][0])
        return frame({name: np.asarray(column) for name, column in rolling_columns(self.onset).items()})

    def plot(self) -> Figure:
        """Draw the torque–angle loop, the incremental stiffness, and the angle behind when the input turns.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        return displayed(
            windup_figure(
                self.curve,
                self.onset,
                title=f"Wind-up of {plain_title(self.joint.source)}, "
                + bounded(LEVEL_NAMES[self.level], self.document["stiffness_bound"]),
                capacities=windup_capacities(self.document),
            )
        )

    def blocks(self) -> list[Block]:
        """What ``asperity windup`` prints."""
        return [Heading(self.joint.source), *windup_shown(self.document)]
