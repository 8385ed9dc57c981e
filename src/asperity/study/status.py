"""Whether a point of a study has a result, and if not, why: one small code a point."""

from __future__ import annotations

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.geometry import DriveGeometry, clearances
from asperity.joint import Joint, JointResult

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
        What :func:`asperity.joint.evaluate` says about it.

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
        code = mark(code, ~(jnp.asarray(clearance.gap) > 0.0), 1 + index)
    roller = geometry.loading_roller_radius
    grip = bearings.pin_friction_coefficient * bearings.pin_diameter / roller
    push = jnp.maximum(jnp.abs(geometry.left_push_angle), jnp.abs(geometry.right_push_angle))
    code = mark(code, (bearings.pin_diameter >= 2.0 * roller) | (grip >= jnp.cos(push)), LOCKED)
    code = mark(code, ~result.solved, UNBALANCED)
    wide = _widest_allowed(joint, shape)
    width, bulk = result.diagnostics.hertz_half_width, result.interfaces.bulk_normal
    too_wide = (width >= wide) | ((width > 0.0) & ~(bulk > 0.0))
    code = mark(code, jnp.any(too_wide, axis=0), TOO_WIDE)
    return mark(code, ~jnp.all(result.diagnostics.gross_slip < 1.0, axis=0), SLIPS)


def _widest_allowed(joint: Joint, shape: tuple[int, ...]) -> Array:
    """Radius or wall of the smaller body at each contact [m], shape (5, ...)."""
    geometry = joint.geometry
    sun, planet, roller, wall = (
        jnp.broadcast_to(jnp.asarray(value), shape)
        for value in (
            geometry.sun_radius,
            geometry.planet_radius,
            geometry.loading_roller_radius,
            joint.ring_wall_thickness,
        )
    )
    inner, outer = jnp.minimum(planet, roller), jnp.minimum(roller, wall)
    return jnp.stack([jnp.minimum(sun, planet), inner, inner, outer, outer])


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
