"""What the structure of a joint carries, and how it vibrates between motor and load, in a script."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown, Table, displayed, frame
from asperity.joint.pin_bound import bound_document, bounded
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.section_build import inertias_from_case
from asperity.joint_file.solved_document import solved_case
from asperity.results.dynamics_document import dynamics_document, response_columns
from asperity.results.loads_document import bearing_entries, loads_document, shown_rows, state_of_case
from asperity.standing.dynamics import Dynamics
from asperity.standing.dynamics import dynamics as solved_dynamics
from asperity.unit_table import Dimension
from asperity.units import format_quantity

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Document = dict[str, Any]

_BEARING_COLUMNS = {
    "C\nN": "dynamic_rating_N",
    "C_0\nN": "static_rating_N",
    "load\nN": "load_N",
    "largest P/C\n-": "load_over_dynamic_rating",
    "life L10\nh": "life_hours",
    "under the duty\nh": "duty_life_hours",
    "static safety\n-": "static_safety",
}


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

    def columns(self) -> dict[str, list[Any]]:
        """One row a load: part, position, load, unit of the row, and its value in each case."""
        titles = ["part", "position", "load", "unit"]
        titles += [_case_title(case, ", ") for case in self.document["cases"]]
        rows = (
            (*words, *(np.nan if value is None else value for value in values))
            for *words, values in shown_rows(self.document)
        )
        return dict(zip(titles, map(list, zip(*rows, strict=True)), strict=True))

    def to_frame(self) -> Any:
        """The same as a pandas data frame."""
        return frame(self.columns())

    def tables(self) -> list[str | Table]:
        """What ``asperity loads`` prints."""
        head = ("load", *(_case_title(case, "\n") for case in self.document["cases"]), "unit")
        rows: list[tuple[str, ...]] = []
        part = ""
        for place, position, quantity, unit, *values in zip(*self.columns().values(), strict=True):
            if part != (part := f"{place}, {position}"):
                rows.append((part, *[""] * (len(head) - 1)))
            rows.append((f"  {quantity}", *map(_number, values), unit.replace("*", "·")))
        parts: list[str | Table] = [Table(head, rows, "Loads of the structure")]
        bearings = self.document["bearings"]
        if bearings:
            head = ("bearing", "type", *_BEARING_COLUMNS)
            rows = [
                (
                    _words(entry["bearing"]),
                    entry["type"],
                    *(_number(entry[key]) for key in _BEARING_COLUMNS.values()),
                )
                for entry in bearings
            ]
            parts.append(Table(head, rows, "Rolling bearings, each one alone"))
        parts += [
            f"{_words(entry['bearing'])}: {reason}"
            for entry in bearings
            for reason in entry["absent_because"]
        ]
        parts += [
            f"{case['name']}: {case['unknown_because']}"
            for case in self.document["cases"]
            if case["unknown_because"]
        ]
        return [*parts, *self.document["notes"]]

    def _parts(self) -> list[str | Table]:
        return [self.source, *self.tables()]


def _case_title(case: Document, line: str) -> str:
    """Title of a column: the load, whether it rolls or stands, its torque and the speed of the input."""
    if case["name"] == "without torque":
        return state_of_case(case)
    torque, speed = case["output_torque_Nm"], case["sun_speed_rad_per_s"]
    return f"{state_of_case(case)}{line}{format_quantity(torque, 'N*m')}{line}{format_quantity(speed, 'rpm')}"


def _words(name: str) -> str:
    return name.replace("_", " ")


def _number(value: float | None) -> str:
    """A number with four digits; a dash where there is none."""
    return "-" if value is None or np.isnan(value) else format_quantity(value, "1", 4)


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

    def to_frame(self) -> Any:
        """The same as a pandas data frame."""
        return frame(dict(self.response()))

    def plot(self) -> Figure:
        """Draw the frequency response, and the natural frequencies over torque.

        A notebook shows the figure; elsewhere call its ``savefig``.
        """
        from asperity.show.dynamics_figure import dynamics_figure
        from asperity.show.style import plain_title

        words = f"{plain_title(self.source)} between motor and load"
        title = bounded(words, self.document["stiffness_bound"])
        return displayed(dynamics_figure(self.solved, title=title))

    def tables(self) -> list[str | Table]:
        """What ``asperity dynamics`` prints."""
        at, over = self.document["at_torque"], self.document["over_torque"]
        quantities = [
            ("torsional stiffness at the output, assembled", "stiffness_output_Nm_per_rad", "N·m/rad"),
            ("inertia of motor and input, at the output", "input_inertia_at_output_kg_m2", "kg·m²"),
            ("inertia of the rollers' spin, at the output", "spin_inertia_at_output_kg_m2", "kg·m²"),
            ("inertia of load and all other motions", "output_inertia_kg_m2", "kg·m²"),
            ("natural frequency, motor locked (antiresonance)", "locked_frequency_Hz", "Hz"),
            ("natural frequency, both sides free (resonance)", "free_frequency_Hz", "Hz"),
        ]
        bound = self.document["stiffness_bound"]
        if at["creep_damping_Nms_per_rad"] is not None:
            quantities += [
                ("creep: torque per speed lost", "creep_damping_Nms_per_rad", "N·m·s/rad"),
                ("creep: corner frequency", "corner_frequency_Hz", "Hz"),
            ]
        columns = {
            "torque N·m": "output_torque_Nm",
            "stiffness N·m/rad": "stiffness_output_Nm_per_rad",
            "motor locked Hz": "locked_frequency_Hz",
            "both free Hz": "free_frequency_Hz",
            "creep corner Hz": "corner_frequency_Hz",
        }
        return [
            Table(
                ("quantity", "value"),
                [
                    (bounded(words, bound) if _of_spring(key) else words, f"{_number(at[key])} {unit}")
                    for words, key, unit in quantities
                ],
                f"At an output torque of {_number(at['output_torque_Nm'])} N·m",
            ),
            Table(
                tuple(columns),
                list(zip(*(map(_number, over[key][::4]) for key in columns.values()), strict=True)),
                bounded("Over torque", bound),
            ),
            self._about_damping(),
        ]

    def _about_damping(self) -> str:
        at = self.document["at_torque"]
        if at["creep_damping_Nms_per_rad"] is not None:
            said = "Below the creep corner frequency a joint that turns yields like a damper, above it like its spring."
        elif at["corner_frequency_Hz"] == 0.0:
            said = "The input stands: creep does not act."
        else:
            said = "Creep is left out: under this torque the joint does not roll steadily, or a branch of it slips."
        spring = "the spring loses no work, and nothing but creep limits the resonance."
        undamped = "" if self._damped else f" No dynamics.loss_factor: {spring}"
        return f"{said}{undamped} Play is not part of it."

    def _parts(self) -> list[str | Table]:
        return [self.source, *self.tables()]


def _of_spring(key: str) -> bool:
    """Whether a number of the document is a stiffness, or a frequency, which grows with it."""
    return "stiffness" in key or key.endswith("_Hz")
