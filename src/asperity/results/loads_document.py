"""Loads of pins, bearings, shafts and housing of a joint, as entries of JSON documents and rows for their supplier."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

import asperity
from asperity.drive.layout.drive import CARRIER
from asperity.drive.state.loads import MemberLoads, pin_components
from asperity.engine.arrays import as_numbers, xp
from asperity.joint.description import Joint, tracks_of
from asperity.joint.evaluation import JointResult
from asperity.joint.housing import ring_fit, seated
from asperity.joint.rim_safety import RIM_NAMES, BodyRims
from asperity.joint.rims import bends
from asperity.joint.temperature_limits import limit_words, limits_document
from asperity.joint.working_loads import (
    forces_on_axis,
    loads_without_torque,
    member_speeds,
    pin_bending,
    pin_speeds,
    working_forces,
    working_loads,
)
from asperity.results.solved import SolvedJoint
from asperity.results.tilt_document import tilt_document
from asperity.rolling.document import unknown_because
from asperity.types import Document
from asperity.units import format_quantity, from_si

_DIRECTIONS = (
    "Radial: away from the drive's axis. Tangential and torques: positive in the sense of rotation of the input. "
    "Forces act on the named part: on each pin and roller, and on members on the axis from all sectors together. "
    "Speeds are without sign."
)
_SENSES = (
    "Torques: positive in the sense of rotation of the input. Forces act on the named part. "
    "Speeds are without sign."
)
_EQUAL = (
    "All sectors are equal: the roller forces on the carrier and on each body on the axis balance and leave a torque, "
    "so that their bearings carry no force. Weights, unequal sectors and external forces are not included; only the "
    "loads of rated bearings include the outside_force of their section."
)
_STATES = "The forces are those of steady rolling where the input turns, otherwise those at standstill."
_FREE = "Rollers without a pin are held by their contacts alone."
_IN_ONE_PLANE = (
    "The tracks of stepped rollers are taken in one plane: unless they are arranged symmetrically, their bearings also "
    "carry a tilting moment."
)

_MOUNTING = (
    "Mounting, at the assembly temperature: the force slides a ring along its axis over all its rollers, with the "
    "friction coefficients mu of the file; a chamfer of angle a multiplies it by up to (mu + tan a)/(mu - mu^2 tan a). "
    "Heating the ring (with its housing) or cooling everything inside it by these temperatures gives the stated radial "
    "gap; both need the thermal_expansion of the materials. Mounting never strains a ring more than its seat does."
)
_SEATED = (
    "Seat in the housing: Lamé's thick cylinders in plane stress as in DIN 7190, elastic and as long as the ring; "
    "force, temperatures and bore at the assembly temperature, all else at the working temperature. The interference "
    "in the housing is the effective one, after the seats have been smoothed by pressing; load.interference is that "
    "of the seated ring."
)
_AXIAL = (
    "Axial forces come from skewed contacts in rolling; those of rollers on pins also act on the carrier. Rollers "
    "without a pin need flanges or a cage, which the file does not describe."
)
_FRAME = (
    "The bearings of each wheel in the frame carry its resultant force, that of the contact with its friction and the "
    "drag of the oil. Weights and external forces are not included; only the loads of rated bearings include the "
    "outside_force of their section."
)
_BEARINGS = "Torques are those of rollers and pins, without the friction torques of the bearings."


def loads_document(solved: SolvedJoint, bearings: list[Document], mounting_gap: float = 0.0) -> Document:
    """Loads of the structure without torque, under the working torque, and under every load of the duty, for JSON.

    With :func:`bearing_entries`, and what mounts the rings with a radial gap [m]; None where a value is not known.
    ``tilt``, :func:`~asperity.results.tilt_document.tilt_document`, where the joint has tilted axes.
    """
    joint, result = solved.joint, solved.result
    cases = [case_entry("without torque", 0.0, 0.0, None, None)]
    loads, at_rest = [loads_without_torque(joint, result)], result.rest
    held = [forces_on_axis(joint, at_rest.normal, at_rest.tangential, at_rest.pin_force)]
    numbers: Joint = as_numbers(joint)
    loaded: list[tuple[str, float | None, Joint, JointResult]] = [("working torque", None, numbers, result)]
    for index, state in enumerate(solved.duty_states):
        loaded.append((f"duty {index + 1}", float(numbers.rolling.duty[index].share), *state))
    drive = joint.drive
    speeds = [np.zeros(len(drive.members))]
    for name, share, at_load, under in loaded:
        loads.append(working_loads(at_load, under))
        held.append(forces_on_axis(at_load, *working_forces(at_load, under), loads[-1].pin))
        speeds.append(np.asarray(member_speeds(at_load, under)))
        unknown = bool(np.any(np.isnan(np.asarray(loads[-1].moments))))
        why = unknown_because(at_load, under)[0] if unknown else None
        cases.append(case_entry(name, float(at_load.output_torque), float(at_load.input_speed), share, why))
    stepped = any(len(tracks_of(joint, number)) > 1 for number in drive.floating)
    sectors = _EQUAL if joint.unlike is None else UNEQUAL
    notes = [_SENSES, _FRAME] if drive.layout.in_frame else [_DIRECTIONS, sectors]
    notes.append(_STATES)
    if any(shape.kind == "ring" for shape in joint.shapes):
        notes.append(_MOUNTING)
    if len(drive.pinned) < len(drive.floating):
        notes.append(_FREE)
    if stepped:
        notes.append(_IN_ONE_PLANE)
    if joint.bearings is not None:
        notes.append(_BEARINGS)
    if bearings:
        notes.append(RATED)
    thrust: np.ndarray | None = None
    if joint.rolling.skew is not None:
        notes.append(_AXIAL)
        none = np.zeros(len(drive.bodies))
        turning = [
            under.rolling.axial_thrust if at_load.input_speed > 0.0 else none for *_, at_load, under in loaded
        ]
        thrust = np.stack([none, *turning], axis=-1)
    limits = limits_document(solved.temperature_limits)
    if limits:
        notes.append(f"As its temperature changes: {', '.join(limit_words(limits))}; nothing is lost before.")
    rows = _rows(joint, loads, np.stack(held, axis=-1), speeds, thrust)
    mounted = _mounting_rows(solved, mounting_gap, len(cases))
    if any(seated(joint)):
        notes.append(_SEATED)
        mounted = itertools.chain(mounted, _seat_rows(solved, len(cases)))
    document = document_of_rows(
        cases, itertools.chain(rows, mounted), bearings=bearings, notes=notes, temperature_limits=limits
    )
    tilt = tilt_document(solved)
    return document if tilt is None else document | {"tilt": tilt}


def _rows(
    joint: Joint,
    loads: list[MemberLoads],
    held: np.ndarray,
    speeds: list[np.ndarray],
    thrust: np.ndarray | None,
) -> Iterator[Row]:
    """Part, position, quantity, SI unit, and a value for each case."""
    drive, members = joint.drive, joint.drive.members
    turned = np.abs(np.stack(speeds, axis=-1))
    relative = np.stack([np.asarray(pin_speeds(drive, xp.asarray(speed))) for speed in speeds], axis=-1)
    pins = [pin_components(drive=drive, force=load.pin) for load in loads]
    radial, tangential = np.moveaxis(np.asarray(pins), 0, -1)
    moment, stress = map(np.asarray, pin_bending(joint, xp.hypot(radial, tangential)))
    for k, body in enumerate(drive.pinned):
        part = ("carrier pin", drive.bodies[body].name.replace("_", " "))
        yield *part, "radial force", "N", radial[k]
        yield *part, "tangential force", "N", tangential[k]
        yield *part, "resultant force", "N", np.hypot(radial[k], tangential[k])
        if thrust is not None:
            yield *part, "axial force", "N", thrust[body]
        if joint.pin is not None:
            yield *part, "bending moment", "N*m", moment[k]
            if float(joint.pin.diameter) > 0.0:
                yield *part, "bending stress", "Pa", stress[k]
        yield *part, "speed, roller on pin", "rad/s", relative[k]
    for number, name in enumerate(members):
        if name != CARRIER and not drive.bodies[number].on_axis:
            if thrust is not None and number not in drive.pinned:
                yield name.replace("_", " "), "roller without a pin", "axial force", "N", thrust[number]
            continue
        if name == CARRIER and not drive.pinned and not drive.layout.in_frame:
            continue
        role = {drive.input: "input", drive.output: "output", drive.grounded: "grounded"}.get(name, "idle")
        part = (name.replace("_", " "), f"on the axis, {role}")
        moment = drive.sense * np.array([load.moments[number] for load in loads])
        if drive.layout.in_frame:
            if name == CARRIER:
                yield drive.ground, role, "torque of the bearings' forces", "N*m", moment
                continue
            part = (part[0], f"in its bearings, {role}")
        yield *part, "torque of the rollers" if name != CARRIER else "torque of all pins", "N*m", moment
        yield *part, "resultant force", "N", held[number]
        if thrust is not None:
            pushed = (
                drive.sectors * np.sum(thrust[list(drive.pinned)], axis=0)
                if name == CARRIER
                else thrust[number]
            )
            yield *part, "axial force", "N", pushed
        yield *part, "speed in the housing", "rad/s", turned[number]


def _mounting_rows(solved: SolvedJoint, gap: float, cases: int) -> Iterator[Row]:
    """What mounts each ring, with a value for the first case alone."""
    joint, mounted, bent = solved.joint, solved.mounting(gap), bends(solved.joint)
    with_gap = f", for a gap of {format_quantity(gap, 'um')}"
    for number, shape in enumerate(joint.shapes):
        if shape.kind != "ring":
            continue
        stated: list[tuple[str, str, Any]] = [
            ("axial mounting force", "N", mounted.force[number]),
            (f"heating of the ring{with_gap}", "K", mounted.heating[number]),
            (f"or cooling of everything inside it{with_gap}", "K", mounted.cooling),
        ]
        if bent[number]:
            stated += [
                ("largest hoop stress, mounted", "Pa", np.max(solved.rims.stress_at_rest[:, number])),
                ("yield strength", "Pa", joint.materials[number].yield_strength),
            ]
        for quantity, unit, value in stated:
            name = joint.drive.bodies[number].name.replace("_", " ")
            yield name, "mounted over its rollers", quantity, unit, [value, *[math.nan] * (cases - 1)]


def _seat_rows(solved: SolvedJoint, cases: int) -> Iterator[Row]:
    """How each ring sits in its housing, with a value for the first case alone."""
    seats = solved.seats
    for number, holds in enumerate(seated(solved.joint)):
        if not holds:
            continue
        fit = ring_fit(solved.joint, number)
        stated: tuple[tuple[str, str, Any], ...] = (
            ("axial press-in force", "N", seats.force[number]),
            ("or heating of the housing, without a gap", "K", seats.heating[number]),
            ("or cooling of the ring, without a gap", "K", seats.cooling[number]),
            ("narrowing of its bore, on the diameter", "m", seats.bore_change[number]),
            ("fit pressure", "Pa", fit.pressure),
            ("smallest seat pressure, with the rollers", "Pa", solved.rims.seat_pressure[number]),
            ("hoop stress of its bore from the fit", "Pa", fit.ring_hoop[0]),
            ("hoop stress of the housing's bore", "Pa", seats.housing_stress[number]),
            ("holding torque of the seat", "N*m", seats.torque[number]),
        )
        name = solved.joint.drive.bodies[number].name.replace("_", " ")
        for quantity, unit, value in stated:
            yield name, "seated in its housing", quantity, unit, [value, *[math.nan] * (cases - 1)]


#: Units of tables for those of the document.
_SHOWN = {"N": "N", "N*m": "N*m", "Pa": "MPa", "rad/s": "rpm", "K": "K", "m": "µm"}
#: A load below this share of the largest one of its unit is what the sums of larger ones leave.
_ROUNDING = 1e-12
Row = tuple[str, str, str, str, Any]

#: What the lives of rolling bearings are.
RATED = (
    "Bearings: basic rating life L10 of ISO 281, from radial load and relative speed, without a_ISO (lubrication and "
    "cleanliness), axial load and misalignment; valid up to C/2."
)

#: What a table of loads says of branches that differ.
UNEQUAL = (
    "Branches of unequal sizes, [[branch]]: the bearings of the members on the axis carry the unbalance of the "
    "branches; rated ones carry all of it plus the outside_force of their section, as if both acted in one direction. "
    "Weights and external forces are not included."
)


def case_entry(
    name: str, output_torque: float, input_speed: float, share: float | None, unknown_because: str | None
) -> Document:
    """One load of the joint as an entry of the document."""
    return {
        "name": name,
        "output_torque_Nm": output_torque,
        "sun_speed_rad_per_s": input_speed,
        "share": share,
        "unknown_because": unknown_because,
    }


def state_of_case(case: Document) -> str:
    """The name of a load, and whether its forces are those of the joint that rolls or that stands, in words."""
    if case["name"] == "without torque":
        return str(case["name"])
    return f"{case['name']}, {'in rolling' if case['sun_speed_rad_per_s'] else 'standing'}"


def document_of_rows(
    cases: list[Document],
    rows: Iterable[Row],
    *,
    bearings: list[Document],
    notes: list[str],
    temperature_limits: list[Document],
) -> Document:
    """The document of loads, whatever the drive."""
    unknown = np.array([case["unknown_because"] is not None for case in cases])
    table = [
        (*words, unit, np.where(unknown & (unit != "rad/s"), math.nan, np.asarray(values, dtype=float)))
        for *words, unit, values in rows
    ]
    largest = {
        unit: max(
            (abs(x) for *_, other, numbers in table if other == unit for x in numbers if np.isfinite(x)),
            default=0.0,
        )
        for unit in {row[-2] for row in table}
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
            for part, position, quantity, unit, values in table
        ],
        "bearings": bearings,
        "temperature_limits": temperature_limits,
        "notes": notes,
    }


def shown_rows(document: Document) -> Iterator[tuple[str, str, str, str, list[float | None]]]:
    """Part, position, quantity, unit and values of each row of a document of loads, in units of tables."""
    for row in document["loads"]:
        unit = _SHOWN[row["unit"]]
        values = [None if value is None else float(from_si(value, unit)) for value in row["values"]]
        yield row["part"], row["position"], row["quantity"], unit, values


def _plain(value: Any, rounding: float = 0.0) -> float | None:
    number = float(value)
    if not math.isfinite(number):
        return None
    return number if abs(number) > rounding else 0.0


def bearing_entries(solved: SolvedJoint) -> list[Document]:
    """Loads, lives and safeties of the rolling bearings of a joint, ready for :func:`json.dumps`.

    One entry for each bearing with ratings; a number that is not known or infinite is None, and ``absent_because`` says
    why.
    """
    joint, entries = solved.joint, []
    for index, (name, rated) in enumerate(zip(joint.bearing_names, joint.rated_bearings, strict=True)):
        if rated is None:
            continue
        bearing = {key: float(np.asarray(value)[index]) for key, value in vars(solved.bearings).items()}
        entries.append(
            {
                "bearing": name,
                "type": rated.kind,
                "dynamic_rating_N": float(rated.dynamic_rating),
                "static_rating_N": float(rated.static_rating),
                "load_N": _plain(bearing["load"]),
                "life_hours": _plain(bearing["life"] / 3600.0),
                "duty_life_hours": _plain(bearing["duty_life"] / 3600.0) if joint.rolling.duty else None,
                "static_safety": _plain(bearing["static_safety"]),
                "load_over_dynamic_rating": _plain(bearing["load_ratio"]),
                "absent_because": _absent_because(joint, bearing),
            }
        )
    return entries


def _absent_because(joint: Joint, bearing: dict[str, float]) -> list[str]:
    """Why lives of a bearing are absent."""
    why = []
    duty = bearing["duty_life"] if joint.rolling.duty else 1.0
    if math.isnan(bearing["load"]):
        why.append("load not known: the joint slips or does not roll")
    elif math.isnan(bearing["life"]):
        why.append("at standstill: no life in hours, only the static safety applies")
    elif math.isinf(bearing["life"]):
        why.append("no load: the life is not limited by fatigue")
    if math.isnan(duty):
        why.append(
            "no life, largest P/C or static safety under the duty: the joint slips or does not roll under one of the "
            "loads"
        )
    if math.isinf(duty) and not math.isinf(bearing["life"]):
        why.append("no load of the duty turns it")
    return why


def rim_entry(rims: BodyRims) -> Document:
    """Stresses and safeties of one body, ready for :func:`json.dumps`."""
    return {
        **{
            f"{name}_Pa": dict(zip(RIM_NAMES, map(_plain, np.asarray(getattr(rims, name))), strict=True))
            for name in ("stress", "stress_at_rest", "mean", "amplitude")
        },
        "yield_safety": _plain(rims.yield_safety),
        "fatigue_safety": _plain(rims.fatigue_safety),
    }
