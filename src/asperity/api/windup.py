"""The wind-up of a joint in a script: figures with units, curves as a data frame, a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, Table, displayed, frame
from asperity.joint.results import LEVELS, known_result
from asperity.joint.solve import Solution
from asperity.joint.windup import StiffnessLevel, Windup
from asperity.joint.windup_document import examined_windup, windup_columns, windup_document
from asperity.joint_file.build import joint_from_case
from asperity.unit_table import Dimension

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Figures of a wind-up: name, what it is, what it measures, unit of display.
_FIGURES = (
    ("torque_capacity", "torque capacity", Dimension.TORQUE, "N*m"),
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


def windup(
    joint: DescribedJoint,
    *,
    torque: str | NamedQuantity | None = None,
    level: StiffnessLevel = "assembly",
    stages: tuple[float, float] = (1.0 / 3.0, 2.0 / 3.0),
) -> JointWindup:
    """Torque–angle curve at the output against the locked sun, with hysteresis and catalogue stiffness.

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
    curve, solutions = examined_windup(
        joint_from_case(joint.case), largest_torque=largest, level=level, stage_shares=stages
    )
    return JointWindup(joint, curve, solutions, level)


class JointWindup(Shown):
    """Wind-up of a joint: ``windup["lost_motion"]`` is a number with its unit.

    Parameters
    ----------
    joint : DescribedJoint
        The joint.
    curve : Windup
        Curves, as arrays in SI units.
    solutions : tuple of Solution
        The joint at the largest torque in the positive and in the negative direction.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness was integrated.
    """

    def __init__(
        self,
        joint: DescribedJoint,
        curve: Windup,
        solutions: tuple[Solution, Solution],
        level: StiffnessLevel,
    ) -> None:
        self.joint, self.curve, self.level = joint, curve, level
        #: What ``asperity windup --json`` prints, in SI units.
        self.document = windup_document(curve, solutions, level=level)
        stages = {f"K{n}": curve.stage_stiffness[n - 1] for n in (1, 2, 3)}
        values = {
            **vars(curve),
            **stages,
            "torque_capacity": solutions[0].capacity.output_torque,
            "largest_torque": curve.torque[-1],
            "windup": curve.angle[-1],
        }
        self._figures = {
            name: NamedQuantity(name, label, float(np.asarray(values[name])), dimension, unit, level=level)
            for name, label, dimension, unit in _FIGURES
        }

    def __getitem__(self, name: str) -> NamedQuantity:
        """One figure of :meth:`keys`, such as ``lost_motion`` or ``K1``."""
        return self._figures[known_result(name, among=tuple(self._figures), what="figure of a wind-up")]

    def keys(self) -> list[str]:
        """Names of the figures."""
        return list(self._figures)

    def to_frame(self) -> Any:
        """The loading curve and both branches of the loop as a pandas data frame, units in the column names."""
        return frame({name: np.asarray(column) for name, column in windup_columns(self.curve).items()})

    def plot(self) -> Figure:
        """Draw the torque–angle loop and the incremental stiffness.

        Returns
        -------
        matplotlib.figure.Figure
            A notebook shows it; elsewhere call its ``savefig``.
        """
        from asperity.show.windup_figure import windup_figure

        return displayed(
            windup_figure(self.curve, title=f"Wind-up of {self.joint.source}, {self.level} stiffness")
        )

    def _parts(self) -> list[str | Table]:
        rows = []
        for each in self._figures.values():
            limited = np.isfinite(each.si)
            rows.append((each.label, str(each) if limited else "not limited by friction"))
        title = f"{self.joint.source}: wind-up at the output, sun locked, {self.level} stiffness"
        return [title, Table(("figure", "value"), rows)]
