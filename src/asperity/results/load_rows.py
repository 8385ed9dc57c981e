"""Rows of the table of results: loads of pins and grounded member; rolling bearings; rings and hollow rollers."""

from __future__ import annotations

import functools
from typing import Any

from asperity.drive.structure.bearing_life import LARGEST_LOAD_RATIO
from asperity.engine.arrays import xp
from asperity.joint.bores import bore_stiffness, pin_contact_angles
from asperity.joint.housing import seated
from asperity.joint.rims import bends
from asperity.joint.working_loads import pin_bending
from asperity.results.result import Limit, Result
from asperity.results.solved import SolvedJoint
from asperity.unit_table import Dimension

_load = functools.partial(Result, group="loads")
_pin = functools.partial(_load, axis="pin")
_STATE = "in rolling where the input turns, standing under the torque where it stands"
_HOUSED = "nan without a section [housing]"
_NEEDS = "nan without a section for its ratings, such as [pin_bearing]"
_bearing = functools.partial(
    Result,
    group="bearings",
    axis="bearing",
    present=lambda solved: solved.has_bearings,
    only=f"the joint file gives no ratings of a bearing: {_NEEDS.removeprefix('nan without ')}",
)
_BENDS = "only free rings and hollow rollers, of one track each, have it, and rings in an elastic or described housing"
_bearing_life = functools.partial(_bearing, dimension=Dimension.TIME, display_unit="h")
_bearing_ratio = functools.partial(_bearing, dimension=Dimension.DIMENSIONLESS, display_unit="1")
_stress = functools.partial(
    Result,
    group="stresses",
    dimension=Dimension.PRESSURE,
    display_unit="MPa",
    axis="body",
    positive=False,
    present=lambda solved: bends(solved.joint),
    only=_BENDS,
    note="tension positive, the larger of both rims, away from the contacts; nan for bodies that do not bend",
)
_mounting = functools.partial(
    _load,
    axis="body",
    needs="geometry",
    present=lambda solved: tuple(shape.kind == "ring" for shape in solved.joint.shapes),
    only="only rings have it",
)
_seat = functools.partial(
    Result,
    group="seats",
    axis="body",
    present=lambda solved: seated(solved.joint),
    only="only rings in a housing that a section [housing] of the joint file describes have it",
)
_seat_pressure = functools.partial(_seat, dimension=Dimension.PRESSURE, display_unit="MPa")
_safety = functools.partial(
    Result, group="stresses", dimension=Dimension.DIMENSIONLESS, display_unit="1", axis="body"
)
_NO_UNIT, _KELVIN = (Dimension.DIMENSIONLESS, "1"), (Dimension.TEMPERATURE_RISE, "K")
_NO_BEARING_LOAD = "no value: the joint slips or does not roll under the torque or under a load of the duty"
_REMEDY = "choose a thicker wall, a stronger material or less preload"


def _larger(name: str) -> Any:
    return lambda solved: xp.max(getattr(solved.rims, name), axis=0)


def _pressed(solved: SolvedJoint) -> tuple[bool, ...]:
    shapes = solved.joint.shapes
    return tuple(
        acts and shape.pin_diameter is not None
        for acts, shape in zip(bends(solved.joint), shapes, strict=True)
    )


def _tires(solved: SolvedJoint) -> tuple[bool, ...]:
    materials = solved.joint.materials
    return tuple(
        acts and material.fatigue_strength is not None
        for acts, material in zip(bends(solved.joint), materials, strict=True)
    )


ROWS = (
    _pin(
        "pin_load",
        "force of a roller on its pin",
        Dimension.FORCE,
        "N",
        lambda solved: abs(solved.loads.pin),
        note=_STATE,
        place="",
    ),
    _pin(
        "pin_bending_moment",
        "bending moment of a pin",
        Dimension.TORQUE,
        "N*m",
        lambda solved: pin_bending(solved.joint, solved.loads.pin)[0],
        note="nan without bearings.pin_length",
        place="",
    ),
    _pin(
        "pin_bending_stress",
        "bending stress of a pin",
        Dimension.PRESSURE,
        "MPa",
        lambda solved: pin_bending(solved.joint, solved.loads.pin)[1],
        note="nan without bearings.pin_length and pin_diameter",
        place="",
    ),
    _pin(
        "bore_stiffness",
        "stiffness of a roller's bore under its pin",
        Dimension.STIFFNESS,
        "N/um",
        lambda solved: bore_stiffness(solved.joint, solved.result.forces.pins, solved.result.forces.normal),
        note="between the pin, standing under the torque, and forces spread over the rim; the pin's bending not "
        "counted; infinite without bearings.pin_diameter",
        place="",
    ),
    _pin(
        "pin_contact_angle",
        "half-angle of the arc over which a pin touches its bore",
        Dimension.ANGLE,
        "deg",
        lambda solved: pin_contact_angles(solved.joint, solved.result.forces.pins),
        note="standing under the torque; nan without a force, and without bearings.pin_diameter",
        place="",
    ),
    _load(
        "grounded_torque",
        "torque of the rollers on the grounded member",
        Dimension.TORQUE,
        "N*m",
        lambda solved: (
            solved.joint.drive.sense
            * solved.loads.moments[solved.joint.drive.members.index(solved.joint.drive.grounded)]
        ),
        positive=False,
        note=f"positive in the sense in which the input turns; {_STATE}",
        place="",
    ),
    _mounting(
        "mounting_force",
        "axial mounting force",
        Dimension.FORCE,
        "N",
        lambda solved: solved.mounting().force,
        note="of a ring over its rollers: friction coefficient times normal force of all its contacts at the assembly",
        place="",
    ),
    _mounting(
        "mounting_heating",
        "heating for mounting",
        Dimension.TEMPERATURE_RISE,
        "K",
        lambda solved: solved.mounting().heating,
        note="of a ring with its housing above the rest of the drive, which removes the interference without a gap; "
        "nan without thermal_expansion",
        place="",
    ),
    _load(
        "mounting_cooling",
        "cooling of the rollers for mounting",
        Dimension.TEMPERATURE_RISE,
        "K",
        lambda solved: solved.mounting().cooling,
        needs="geometry",
        note="of everything but the rings below the rings, which removes the interference without a gap; nan without "
        "thermal_expansion",
        place="",
    ),
    _seat_pressure(
        "seat_pressure",
        "smallest pressure on the housing",
        value="rims.seat_pressure",
        group="stresses",
        positive=False,
        note=f"between it and a ring, of fit and rollers together, without torque and under it; {_HOUSED}",
        limit=Limit(
            "accuracy",
            "the ring is in contact with its housing all round",
            "the ring lifts off its housing between the rollers: it is softer than computed, and creeps in its seat",
            "choose more interference in the housing, a stiffer housing or a thicker wall of the ring",
            lowest=0.0,
        ),
    ),
    _seat(
        "seat_torque_safety",
        "ring seat: holding torque / applied torque",
        *_NO_UNIT,
        "seats.torque_safety",
        note=f"of a ring under the torque of the file, by friction and the pressure of the fit alone; {_HOUSED}",
        limit=Limit(
            "function",
            "the seat holds the torque on the ring",
            "the ring turns in its housing under the torque",
            "choose more interference in the housing, a wider seat, or a key",
            lowest=1.0,
            inclusive=True,  # without a torque it holds infinitely often
            beyond="turns in its housing",
        ),
    ),
    _seat(
        "seat_force",
        "axial force for pressing into the housing",
        Dimension.FORCE,
        "N",
        "seats.force",
        note=f"a ring, at the assembly, at the end of the way; {_HOUSED}",
        place="",
    ),
    _seat(
        "seat_heating",
        "heating of the housing for mounting",
        *_KELVIN,
        "seats.heating",
        note=f"above a ring, which removes the interference without a gap; nan without thermal_expansion; {_HOUSED}",
        place="",
    ),
    _seat(
        "seat_cooling",
        "cooling for mounting in the housing",
        *_KELVIN,
        "seats.cooling",
        note=f"of a ring, which removes the interference without a gap; nan without thermal_expansion; {_HOUSED}",
        place="",
    ),
    _seat(
        "seat_bore_change",
        "narrowing of the bore by the seat in the housing",
        Dimension.LENGTH,
        "um",
        "seats.bore_change",
        note=f"of a ring, on the diameter, at the assembly; {_HOUSED}",
        place="",
    ),
    _seat_pressure(
        "housing_stress",
        "largest hoop stress of the housing",
        value="seats.housing_stress",
        note=f"at its bore around a ring, by the fit alone; {_HOUSED}",
        place="",
    ),
    _seat(
        "housing_yield_safety",
        "yield safety of the housing",
        *_NO_UNIT,
        "seats.yield_safety",
        note=f"around a ring, by the fit alone, at the assembly and at the working temperature; {_HOUSED}",
        limit=Limit(
            "damage",
            "the housing stays elastic",
            "the housing yields at its bore and loses part of the fit",
            "choose less interference in the housing, or a thicker or stronger housing",
            lowest=1.0,
            beyond="makes its housing yield",
        ),
    ),
    _bearing(
        "bearing_load",
        "radial load of one bearing",
        Dimension.FORCE,
        "N",
        "bearings.load",
        note=_NEEDS,
        place="",
    ),
    _bearing_life(
        "bearing_life",
        "bearing basic rating life L10",
        value="bearings.life",
        note=f"ISO 281, without a_ISO, axial load and misalignment; nan where it stands; {_NEEDS}",
        place="",
    ),
    _bearing_life(
        "bearing_duty_life",
        "bearing basic rating life L10 under the duty",
        value="bearings.duty_life",
        note=f"by Miner's sum; nan without a duty; {_NEEDS}",
        place="",
    ),
    _bearing_ratio(
        "bearing_static_safety",
        "bearing static safety",
        value="bearings.static_safety",
        lowest_limit=0.0,
        note=f"C_0 over the largest load without torque, under the torque and under the duty; {_NEEDS}",
        limit=Limit(
            "damage",
            "the load is within the static rating C_0 of the bearing",
            "the largest load exceeds the static rating C_0 of the bearing: permanent dents in its raceways",
            "choose a larger bearing or more of them, or lower preload or torque",
            lowest=1.0,
            inclusive=True,
            beyond="beyond its static rating",
            unknown=_NO_BEARING_LOAD,
        ),
    ),
    _bearing_ratio(
        "bearing_load_ratio",
        "bearing load over dynamic rating",
        value="bearings.load_ratio",
        note=f"largest P/C under the torque and under the duty; {_NEEDS}",
        limit=Limit(
            "accuracy",
            "the load of the bearing is within the range of its rating life",
            "the load exceeds half the dynamic rating C of the bearing: its rating life is not valid",
            "choose a larger bearing or more of them, or lower preload or torque",
            highest=LARGEST_LOAD_RATIO,
            inclusive=True,
            unknown=_NO_BEARING_LOAD,
        ),
    ),
    _stress(
        "rim_stress",
        "largest hoop stress of a ring or hollow roller",
        value=_larger("stress"),
        place="",
    ),
    _stress(
        "rim_stress_at_rest",
        "largest hoop stress of a ring or hollow roller by the preload alone",
        value=_larger("stress_at_rest"),
        place="",
    ),
    _stress(
        "rim_stress_amplitude",
        "largest amplitude of the hoop stress at a point of a ring or hollow roller",
        value=_larger("amplitude"),
        place="",
    ),
    _stress(
        "bore_stress",
        "largest hoop stress of the bore of a roller on a pin",
        value=lambda solved: solved.rims.stress[0],
        note="tension positive, under the pressure of the pin too; nan without bearings.pin_diameter",
        present=_pressed,
        only="only hollow rollers of one track on pins of a stated diameter, bearings.pin_diameter, have it",
        place="",
    ),
    _safety(
        "rim_yield_safety",
        "rim yield safety",
        value="rims.yield_safety",
        note="yield strength over the largest Mises stress of both rims of a ring or hollow roller, without torque and "
        "under it, in plane strain up to 12 % above that at the faces of a short body; nan for bodies that do not bend",
        present=lambda solved: bends(solved.joint),
        only=_BENDS,
        limit=Limit(
            "damage",
            "the rims of rings and hollow rollers stay elastic",
            "a ring or hollow roller yields at a rim, away from the contacts",
            _REMEDY,
            lowest=1.0,
            beyond="yields at a rim",
        ),
    ),
    _safety(
        "rim_fatigue_safety",
        "rim fatigue safety",
        value="rims.fatigue_safety",
        note="of a ring or hollow roller; nan for bodies that do not bend, and without fatigue_strength of the "
        "material",
        present=_tires,
        only=f"{_BENDS}, where their material states fatigue_strength",
        limit=Limit(
            "damage",
            "the rims of rings and hollow rollers survive the stress cycles of the passing contacts",
            "a ring or hollow roller fails by fatigue at a rim, away from the contacts",
            _REMEDY,
            lowest=1.0,
            beyond="breaks by fatigue at a rim",
        ),
    ),
)
