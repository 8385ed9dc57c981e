"""Whether a point of a study has results, and if not, why: one small code per point."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from asperity.drive.layout.existence import LEAST_OUTPUT_SHARE, has_room, output_share
from asperity.drive.state.state import STATE_TOLERANCE
from asperity.engine.arrays import xp
from asperity.joint.bores import overhang, pin_room
from asperity.joint.capacity import smaller_sizes
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.joint.housing import housing_room
from asperity.types import Array, ArrayLike

#: What must hold for a result to mean anything: the rollers fit; in addition the forces balance; in addition no
#: contact slips.
Needs = Literal["geometry", "balance", "operation"]

#: Each status: its short name in tables and netCDF flags, and its meaning. 0 is solved.
STATUSES: dict[str, str] = {
    "solved": "solved",
    "pin_too_thick_or_locked": "a loading roller's pin is as thick as the roller, or locks by friction",
    "contact_too_wide": "a contact strip is too wide for line-contact theory or for the wall of its body",
    "beyond_standing_capacity": "the output torque is beyond the standing torque capacity: a contact slips",
    "unbalanced": "the force balance did not close",
    "out_of_range": "a number is outside its allowed range",
    "all_spots_plastic": "every spot of a loaded contact is plastic, where the contact law gives it no stiffness",
    "no_interference_left": "sizes or temperature leave no interference: the drive is loose and carries no torque",
    "no_place_for_rollers": "the rollers do not fit: they overlap, or have no place where they touch",
    "output_stands_still": "the output stands still whatever the input does: the ratio is infinite",
    "pin_too_short": "a roller is longer than the free length of its pin",
    "housing_inside_ring": "the housing lies inside a ring that it holds",
    "thermal_runaway": "no temperature of the drive up to the limit of its oil is steady: thermal runaway, or too hot",
    "no_oil_film": "heat at the inlet of a contact is beyond the range in which its oil film is known",
}

#: Short names and meanings in the order of the codes.
STATUS_NAMES, STATUS_MEANINGS = tuple(STATUSES), tuple(STATUSES.values())

LOCKED = STATUS_NAMES.index("pin_too_thick_or_locked")
(
    TOO_WIDE,
    SLIPS,
    UNBALANCED,
    OUT_OF_RANGE,
    ALL_PLASTIC,
    LOOSE,
    NO_ROOM,
    IDLE,
    SHORT,
    INSIDE,
    RUNAWAY,
    NO_FILM,
) = range(LOCKED + 1, LOCKED + 13)


def has_value(status: ArrayLike, needs: Needs) -> Any:
    """Where the results of a kind have a value, in the shape of the ``status`` codes, indices into :data:`STATUSES`.

    ``needs`` is what a result needs to have one, :attr:`asperity.results.Result.needs`. Where every spot of a contact
    is plastic, forces, pressures and capacity have their values; the stiffness and what follows from it are nan by
    themselves. Where no oil film is known everything but what rolls has its value.
    """
    code = xp.asarray(status)
    operates = (code == 0) | (code == ALL_PLASTIC) | (code == NO_FILM)
    if needs == "geometry":
        return operates | ((code >= LOCKED) & (code < NO_ROOM)) | (code == SHORT) | (code == RUNAWAY)
    return operates | (code == SLIPS) if needs == "balance" else operates


def flag_attributes() -> dict[str, object]:
    """Attributes that explain a status variable, after the CF conventions.

    Returns
    -------
    dict
        ``long_name``, ``units``, ``flag_values``, ``flag_meanings``, and the sentences as ``reasons``.
    """
    return {
        "long_name": "status of the point; 0 is solved, results without a value are nan",
        "units": "1",
        "flag_values": np.arange(len(STATUS_NAMES), dtype=np.int8).tolist(),
        "flag_meanings": " ".join(STATUS_NAMES),
        "reasons": list(STATUS_MEANINGS),
    }


def joint_status(joint: Joint, result: JointResult) -> Array:
    """Status code of one joint."""
    drive, residual = joint.drive, result.forces.balance_residual
    at_rest = xp.all(result.rest.normal > 0.0) & (result.rest.residual < STATE_TOLERANCE)
    if result.cam is not None:
        at_rest = at_rest & (result.pressed.residual < STATE_TOLERANCE)
    wide = result.diagnostics.hertz_half_width >= smaller_sizes(joint)
    loose = xp.asarray(False)
    if joint.interference is not None:  # a force is always above 0
        left = xp.max(xp.asarray(joint.pattern)) * joint.interference
        if joint.fit is not None:
            left = xp.asarray(joint.fit.interference + joint.fit.thermal_change)
        loose = left <= 0.0
    carried = xp.isfinite(residual) | ~xp.all(xp.isfinite(result.forces.normal))
    locked = xp.any(xp.concatenate(pin_room(joint)) >= 1.0)
    heat = result.inlet_heat_factor
    no_film = xp.asarray(False) if heat is None else xp.any(heat <= 0.0)
    code = xp.zeros((), dtype=xp.int8)
    for condition, value in (
        (~has_room(drive), NO_ROOM),
        (output_share(drive) < LEAST_OUTPUT_SHARE, IDLE),
        (locked, LOCKED),
        (xp.any(overhang(joint) > 1.0), SHORT),
        (xp.any(housing_room(joint) <= 0.0), INSIDE),
        (loose, LOOSE),
        (~at_rest, UNBALANCED),
        (xp.any(wide) | ~result.walls_hold, TOO_WIDE),
        (~carried, SLIPS),
        (~(residual < STATE_TOLERANCE), UNBALANCED),
        (~result.contact_law_holds, ALL_PLASTIC),
        (xp.asarray(False) if joint.heat is None else ~joint.heat.is_steady, RUNAWAY),
        (no_film, NO_FILM),
    ):
        code = xp.where((code == 0) & condition, xp.asarray(value, dtype=xp.int8), code)
    return code
