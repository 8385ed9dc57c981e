"""Whether a point of a study has a result, and if not, why: one small code a point."""

from __future__ import annotations

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.existence import overlaps, pin_lock, smaller_body, some_contact_slips, too_wide
from asperity.drive.geometry import DriveGeometry, clearances
from asperity.joint.evaluation import Joint, JointResult

#: What must hold for the rollers to fit; the names are known without computing anything.
_FIT = tuple(gap.name for gap in jax.eval_shape(clearances, DriveGeometry(*([1.0] * 7))))

#: Meaning of each status code; 0 is a result, everything else is a failed point.
STATUS_MEANINGS: tuple[str, ...] = (
    "solved",
    *(f"the rollers do not fit: {name}" for name in _FIT),
    "a loading roller's pin is as thick as the roller, or locks by friction",
    "a contact strip is too wide for line-contact theory",
    "the output torque is beyond the torque capacity: a contact slips",
    "the force balance did not close",
    "a number is outside its allowed range",
)

LOCKED = 1 + len(_FIT)
TOO_WIDE, SLIPS, UNBALANCED, OUT_OF_RANGE = range(LOCKED + 1, LOCKED + 5)

#: Short names for tables and netCDF flags, in the order of the codes.
STATUS_NAMES: tuple[str, ...] = (
    "solved",
    "roller_larger_than_ring",
    "roller_does_not_reach_ring",
    "planet_touches_ring",
    "planets_overlap",
    "rollers_of_planet_overlap",
    "rollers_of_neighbours_overlap",
    "roller_touches_next_planet",
    "rollers_inside_planet_orbit",
    "pin_too_thick_or_locked",
    "contact_too_wide",
    "beyond_torque_capacity",
    "unbalanced",
    "out_of_range",
)


def joint_status(joint: Joint, result: JointResult) -> Array:
    """Status code of every joint of a batch.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.
    result : JointResult
        What :func:`asperity.joint.evaluation.evaluate` says about it.

    Returns
    -------
    Array
        Codes of :data:`STATUS_MEANINGS`, shape (...), 8-bit; the first reason that applies, except that an
        unbalanced joint is not said to slip.
    """
    geometry, bearings = joint.geometry, joint.bearings
    shape = result.solved.shape

    def mark(code: Array, condition: object, value: int) -> Array:
        hit = jnp.broadcast_to(jnp.asarray(condition), shape)
        return jnp.where((code == 0) & hit, jnp.asarray(value, dtype=jnp.int8), code)

    code = jnp.zeros(shape, dtype=jnp.int8)
    for index, clearance in enumerate(clearances(geometry)):
        code = mark(code, overlaps(gap=clearance.gap), 1 + index)
    pins = pin_lock(geometry=geometry, bearings=bearings)
    code = mark(code, pins.too_thick | pins.locks, LOCKED)
    code = mark(code, ~result.solved, UNBALANCED)
    wide = too_wide(
        half_width=result.diagnostics.hertz_half_width,
        smaller_body=smaller_body(
            geometry=geometry, ring_wall_thickness=jnp.broadcast_to(joint.ring_wall_thickness, shape)
        ),
        bulk_normal_stiffness=result.interfaces.bulk_normal,
    )
    code = mark(code, jnp.any(wide, axis=0), TOO_WIDE)
    return mark(code, some_contact_slips(slip_ratio=result.diagnostics.gross_slip), SLIPS)


def flag_attributes() -> dict[str, object]:
    """Attributes that explain a status variable, after the CF conventions.

    Returns
    -------
    dict
        ``long_name``, ``units``, ``flag_values``, ``flag_meanings``, and the sentences as ``reasons``.
    """
    return {
        "long_name": "status of the point; 0 is solved, the results of other points are nan",
        "units": "1",
        "flag_values": np.arange(len(STATUS_NAMES), dtype=np.int8).tolist(),
        "flag_meanings": " ".join(STATUS_NAMES),
        "reasons": list(STATUS_MEANINGS),
    }
