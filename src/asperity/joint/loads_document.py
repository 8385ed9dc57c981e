"""Loads of a joint's pins, bearings, shafts and housing under every load of its file, as rows for their supplier."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import jax
import numpy as np

import asperity
from asperity.drive.structure_loads import PIN_NAMES, StructureLoads, pin_bending_moment, pin_bending_stress
from asperity.joint.branch_limits import pressed
from asperity.joint.branch_loads import BranchLoads
from asperity.joint.branch_results import UnequalBranches
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.joint.results import SolvedJoint
from asperity.joint.rolling_document import unknown_because
from asperity.joint.working_loads import BearingSpeeds, bearing_speeds, loads_at_rest, working_loads

#: A load below this share of the largest one of its unit is what the sums of larger ones leave.
_ROUNDING = 1e-12
Document = dict[str, Any]
Row = tuple[str, str, str, str, Any]

#: What the lives of rolling bearings are.
RATED = (
    "Bearings: ISO 281 basic rating life, which nine in ten reach, by radial load and relative speed. Lubrication and "
    "cleanliness (a_ISO), axial loads and misalignment are yours to judge; the life holds for loads up to C/2."
)

_NOTES = (
    "Radial is away from the drive's axis, tangential along the carrier's circle in the sense in which a positive "
    "output torque is driven. Forces act on the part that is named.",
    "All branches are equal: the forces of the planets on sun, carrier and ring balance, and a torque remains, so that "
    "their bearings carry no force. Weights, unequal branches and forces from outside are not counted; "
    "only the loads of rated bearings contain the outside_force of their section.",
    "Where the sun turns the forces are those of steady rolling, otherwise those of the joint standing under the "
    "torque.",
)
#: What a table of loads says of branches that differ.
UNEQUAL = (
    "Branches of unequal sizes, [[branch]]: the bearings of the members on the axis carry what the branches leave "
    "unbalanced, rated ones the whole of it and the outside_force of their section as if both acted in one direction. "
    "Forces of the pins and lives of their bearings are those of the branch that loads them most; {pressed}. Weights "
    "and forces from outside are not counted."
)
_SUPPORTED = (
    "The planets have supports: the balance of the forces takes them as floating, so that the share that the supports "
    "carry is not known."
)


@dataclass(frozen=True, slots=True)
class LoadCase:
    """One load of the joint.

    Parameters
    ----------
    name : str
        What it is called.
    output_torque, sun_speed : float
        Torque at the carrier [N·m] and speed of the sun [rad/s].
    share : float or None
        Share of the time; None outside the duty.
    result : JointResult or None
        What the joint does under it; None without torque.
    loads : StructureLoads
        Loads of the structure.
    speeds : BearingSpeeds or None
        Speeds of the bearings; None without torque.
    unknown_because : str or None
        Why there are no loads; None where there are.
    """

    name: str
    output_torque: float
    sun_speed: float
    share: float | None
    result: JointResult | None
    loads: StructureLoads
    speeds: BearingSpeeds | None
    unknown_because: str | None


def load_cases(solved: SolvedJoint) -> tuple[LoadCase, ...]:
    """The joint without torque, under its working torque, and under every load of its duty.

    Parameters
    ----------
    solved : SolvedJoint
        One joint with the paper's drive.

    Returns
    -------
    tuple of LoadCase
        In this order.
    """
    numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), solved.joint)
    cases = [LoadCase("without torque", 0.0, 0.0, None, None, loads_at_rest(numbers), None, None)]
    cases.append(_case("working torque", numbers, solved.result, None))
    for index, (there, result) in enumerate(solved.duty_states):
        cases.append(_case(f"duty {index + 1}", there, result, float(numbers.rolling.duty[index].share)))
    return tuple(cases)


def _case(name: str, joint: Joint, result: JointResult, share: float | None) -> LoadCase:
    loads = working_loads(joint, result)
    why = None
    if bool(np.any(np.isnan(np.asarray(loads.pin_tangential)))):
        why = unknown_because(joint, result)[0]
    speed = float(joint.sun_speed)
    return LoadCase(
        name, float(joint.output_torque), speed, share, result, loads, bearing_speeds(joint, result), why
    )


def loads_document(
    joint: Joint,
    cases: tuple[LoadCase, ...],
    bearings: list[Document],
    branches: UnequalBranches | None = None,
) -> Document:
    """Loads of the structure as a document, ready for :func:`json.dumps`.

    Parameters
    ----------
    joint : Joint
        The joint.
    cases : tuple of LoadCase
        Its loads.
    bearings : list of dict
        Its :func:`asperity.joint.strength_document.bearing_entries`.
    branches : UnequalBranches, optional
        Its branches, if their sizes differ.

    Returns
    -------
    dict
        The cases, and rows of one value for each of them in SI units; None where a value is not known or infinite.
    """
    supported = float(joint.structure.planet_support_stiffness) > 0.0
    sense, balanced, rolling = _NOTES
    middle = balanced if branches is None else UNEQUAL.format(pressed=pressed(branches))
    notes = [sense, middle, rolling, *([_SUPPORTED] if supported else []), *([RATED] if bearings else [])]
    heads = [
        case_entry(case.name, case.output_torque, case.sun_speed, case.share, case.unknown_because)
        for case in cases
    ]
    unlike = BranchLoads(branches, turns=cases[1].sun_speed != 0.0, cases=len(cases))
    heads, said = unlike.entries(heads, skewed=joint.rolling.skew is not None)
    rows = _rows(joint, cases, supported, unlike)
    return document_of_rows(heads, rows, bearings=bearings, notes=[*notes, *said])


def case_entry(
    name: str, output_torque: float, sun_speed: float, share: float | None, unknown_because: str | None
) -> Document:
    """One load of the joint as an entry of the document.

    Parameters
    ----------
    name : str
        What it is called.
    output_torque, sun_speed : float
        Torque at the output [N·m] and speed of the input [rad/s].
    share : float or None
        Share of the time; None outside a duty.
    unknown_because : str or None
        Why there are no loads; None where there are.

    Returns
    -------
    dict
        With units at the end of its keys.
    """
    return {
        "name": name,
        "output_torque_Nm": output_torque,
        "sun_speed_rad_per_s": sun_speed,
        "share": share,
        "unknown_because": unknown_because,
    }


def document_of_rows(
    cases: list[Document], rows: Iterable[Row], *, bearings: list[Document], notes: list[str]
) -> Document:
    """The document of loads, whatever the drive.

    Parameters
    ----------
    cases : list of dict
        From :func:`case_entry`.
    rows : iterable of tuple
        Part, position, quantity, SI unit, and one value for each case or one for all.
    bearings : list of dict
        Rolling bearings.
    notes : list of str
        What the numbers mean.

    Returns
    -------
    dict
        None where a value is not known or infinite, as every load of an unknown case; 0 where it is the rounding of
        larger ones of its unit.
    """
    unknown = np.array([case["unknown_because"] is not None for case in cases])
    whole = [
        (*words, unit, np.where(unknown & (unit != "rad/s"), math.nan, np.asarray(values, dtype=float)))
        for *words, unit, values in rows
    ]
    largest = {
        unit: max(
            (abs(x) for *_, other, each in whole if other == unit for x in each if np.isfinite(x)),
            default=0.0,
        )
        for unit in {row[-2] for row in whole}
    }
    return {
        "asperity_version": asperity.__version__,
        "cases": cases,
        "loads": [
            {
                "part": part,
                "position": position,
                "quantity": quantity,
                "unit": unit,
                "values": [_plain(value, _ROUNDING * largest[unit]) for value in values],
            }
            for part, position, quantity, unit, values in whole
        ],
        "bearings": bearings,
        "notes": notes,
    }


def _plain(value: Any, rounding: float) -> float | None:
    number = float(value)
    if not math.isfinite(number):
        return None
    return number if abs(number) > rounding else 0.0


def _rows(joint: Joint, cases: tuple[LoadCase, ...], supported: bool, unlike: BranchLoads) -> Iterator[Row]:
    """Part, position, quantity, SI unit, and a value for each case."""
    stacked = jax.tree.map(
        lambda *leaves: np.stack([np.asarray(leaf) for leaf in leaves], axis=-1),
        *(case.loads for case in cases),
    )
    speeds = {
        name: np.array([0.0 if case.speeds is None else _of(case.speeds, name) for case in cases])
        for name in (*PIN_NAMES, "sun", "carrier")
    }
    pins = unlike.speed_on_pins([speeds[name] for name in PIN_NAMES])
    speeds = dict(zip(PIN_NAMES, pins, strict=True)) | {
        name: unlike.speed_of(name, speeds[name]) for name in ("sun", "carrier")
    }
    radial, tangential = unlike.pins([stacked.pin_radial, stacked.pin_tangential])
    forces = np.hypot(radial, tangential)
    for index, side in enumerate(PIN_NAMES):
        part = ("carrier pin", f"{side} roller")
        yield *part, "radial force", "N", radial[index]
        yield *part, "tangential force", "N", tangential[index]
        yield *part, "resultant force", "N", forces[index]
        if joint.rolling.skew is not None:
            yield *part, "axial force", "N", _thrust(cases, 2 + index)
        if joint.pin is not None:
            moment = pin_bending_moment(
                force=forces[index],
                free_length=joint.pin.free_length,
                roller_length=joint.loading_roller_length,
                support=joint.pin.support,
            )
            yield *part, "bending moment", "N*m", moment
            if float(joint.bearings.pin_diameter) > 0.0:
                stress = pin_bending_stress(moment=moment, diameter=joint.bearings.pin_diameter)
                yield *part, "bending stress", "Pa", stress
        yield *part, "speed, roller on pin", "rad/s", speeds[side]
    centre = ("on the axis",)
    yield "planet", "its own axis", "resultant force", "N", math.nan if supported else 0.0
    yield "sun bearing", *centre, "resultant force", "N", unlike.force_on("sun")
    if joint.rolling.skew is not None:
        yield "sun bearing", *centre, "axial force", "N", _thrust(cases, 0)
    yield "sun bearing", *centre, "speed in the housing", "rad/s", speeds["sun"]
    yield "sun", *centre, "torque of its shaft", "N*m", unlike.torque_on("sun", stacked.sun_torque)
    yield "carrier bearing", *centre, "resultant force", "N", unlike.force_on("carrier")
    yield "carrier bearing", *centre, "speed in the housing", "rad/s", speeds["carrier"]
    on_carrier = unlike.torque_on("carrier", stacked.carrier_torque)
    yield "carrier", *centre, "torque of all pins", "N*m", on_carrier
    yield "ring in its housing", *centre, "resultant force", "N", unlike.force_on("ring")
    if joint.rolling.skew is not None:
        yield "ring in its housing", *centre, "axial force", "N", _thrust(cases, 4)
    yield "ring in its housing", *centre, "torque", "N*m", unlike.torque_on("ring", stacked.housing_torque)


def _of(speeds: BearingSpeeds, name: str) -> float:
    if name in PIN_NAMES:
        return float(np.asarray(speeds.pin)[PIN_NAMES.index(name)])
    return float(np.asarray(getattr(speeds, name)))


def _thrust(cases: tuple[LoadCase, ...], body: int) -> np.ndarray:
    """Axial forces of skewed contacts on a body; they exist in rolling only."""
    return np.array(
        [
            0.0
            if case.result is None or case.sun_speed == 0.0
            else float(case.result.rolling.axial_thrust[body])
            for case in cases
        ]
    )
