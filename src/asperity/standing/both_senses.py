"""A joint over its output torque in both directions: stiffness at rest, and drift in either sense of rotation."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.joint.description import Joint
from asperity.standing.over_torque import over_torque
from asperity.standing.standing import LEVELS, NO_SLIP_FRICTION


class BothSenses(eqx.Module):
    """One joint over torques of either sign. SI units; shape (n,).

    Parameters
    ----------
    torque : Array
        Output torques [N·m].
    published, series_with_bulk, assembly : Array
        Incremental stiffness on the three levels at rest, play left out [N·m/rad]; nan where a contact slips.
    slip_ratio : Array
        The largest T/(mu N) of all contacts at rest [-].
    driving_drift, braking_drift : Array
        Angle by which the output gives way to the torque in one turn of its own, with the sign of the torque [rad]:
        in steady rolling with the torque (the output falls behind), and against it (it runs ahead). nan where there is
        no steady rolling.
    """

    torque: Array
    published: Array
    series_with_bulk: Array
    assembly: Array
    slip_ratio: Array
    driving_drift: Array
    braking_drift: Array


def both_senses(*, joint: Joint, torque: Array | np.ndarray) -> BothSenses:
    """Stiffness and drift of a joint at given torques."""
    found = over_torque(joint, np.asarray(torque), no_slip_friction=NO_SLIP_FRICTION)
    slip = np.max(np.asarray(found.slip_ratio), axis=1)
    solved = np.asarray(found.solved)
    levels = {
        name: jnp.asarray(np.where(solved, np.asarray(getattr(found, name))[:, 0], np.nan)) for name in LEVELS
    }
    driving, braking = jnp.asarray(found.drift).T
    return BothSenses(
        torque=jnp.asarray(torque),
        **levels,
        slip_ratio=jnp.asarray(np.where(solved, slip, np.nan)),
        driving_drift=driving,
        braking_drift=braking,
    )
