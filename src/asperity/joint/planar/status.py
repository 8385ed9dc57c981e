"""Status of a joint with a planar drive in a study: whether it has results, and if not, why."""

from __future__ import annotations

import jax.numpy as jnp
from jax import Array

from asperity.drive.planar.existence import LEAST_OUTPUT_SHARE, has_room, output_share
from asperity.drive.planar.state import STATE_TOLERANCE
from asperity.joint.planar.capacity import smaller_sizes
from asperity.joint.planar.description import PlanarJoint
from asperity.joint.planar.evaluation import PlanarResult
from asperity.joint.planar.pins import pin_room
from asperity.joint.status import ALL_PLASTIC, IDLE, LOCKED, LOOSE, NO_ROOM, SLIPS, TOO_WIDE, UNBALANCED


def planar_status(joint: PlanarJoint, result: PlanarResult) -> Array:
    """Status code of one joint.

    Parameters
    ----------
    joint : PlanarJoint
        One joint.
    result : PlanarResult
        What :func:`asperity.joint.planar.evaluation.evaluate_planar` says about it.

    Returns
    -------
    Array
        Code, an index into :data:`asperity.joint.status.STATUSES`, 8-bit; the first reason that applies.
    """
    drive, residual = joint.drive, result.forces.balance_residual
    at_rest = jnp.all(result.rest.normal > 0.0) & (result.rest.residual < STATE_TOLERANCE)
    if result.cam is not None:
        at_rest = at_rest & (result.pressed.residual < STATE_TOLERANCE)
    wide = result.diagnostics.hertz_half_width >= smaller_sizes(joint)
    loose = jnp.asarray(False)
    if joint.interference is not None:  # a force is always above 0
        left = jnp.max(jnp.asarray(joint.pattern)) * joint.interference
        if joint.fit is not None:
            left = jnp.asarray(joint.fit.interference + joint.fit.thermal_change)
        loose = left <= 0.0
    carried = jnp.isfinite(residual) | ~jnp.all(jnp.isfinite(result.forces.normal))
    locked = jnp.any(jnp.concatenate(pin_room(joint)) >= 1.0)
    code = jnp.zeros((), dtype=jnp.int8)
    for condition, value in (
        (~has_room(drive), NO_ROOM),
        (output_share(drive) < LEAST_OUTPUT_SHARE, IDLE),
        (locked, LOCKED),
        (loose, LOOSE),
        (~at_rest, UNBALANCED),
        (jnp.any(wide) | ~result.walls_hold, TOO_WIDE),
        (~carried, SLIPS),
        (~(residual < STATE_TOLERANCE), UNBALANCED),
        (~result.contact_law_holds, ALL_PLASTIC),
    ):
        code = jnp.where((code == 0) & condition, jnp.asarray(value, dtype=jnp.int8), code)
    return code
