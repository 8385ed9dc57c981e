r"""Friction of the bearings of a drive: moments on shafts and rollers on pins."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.layout.drive import CARRIER, Drive, sectors_of_members
from asperity.drive.mechanism import Bearings, bearing_torque


def friction_moments(
    *, drive: Drive, bearings: Bearings, pin_force: Array, ideal: Array, on_carrier: bool = True
) -> Array:
    r"""Moments of the bearings on the members of a drive, those of all sectors together.

    .. math::
        M_b = -2\,T_B(F)\,\operatorname{sgn}(\omega_b - \omega_c), \qquad M_c = -n \sum_b M_b, \qquad
        M_{in,out} = -2\,T_{in,out}\,\operatorname{sgn}\,\omega_{in,out}

    Parameters
    ----------
    drive : Drive
        The drive.
    bearings : Bearings
        Friction of the bearings: ``sun_torque`` of the input, ``carrier_torque`` of the output, and of every roller on
        a pin.
    pin_force : Array
        Forces of the pins, shape (pins,) [N].
    ideal : Array
        Angular velocities of the members without creep, of which only the signs count, shape (members,) [-].
    on_carrier : bool, optional
        Whether the bearings of rollers act on the carrier too.

    Returns
    -------
    Array
        Counter-clockwise, shape (members,) [N·m]; those of bodies off the axis of one sector.

    Notes
    -----
    Every bearing acts on both of its parts: the bearings of a roller also act on the carrier that holds its pin, which
    equation (5) of Zou et al. 2025 leaves out (``on_carrier = False``).

    References
    ----------
    Zou et al. 2025, equations (1) and (3)–(5): two bearings on each body.
    """
    carrier = drive.members.index(CARRIER)
    unit, sectors = np.eye(len(drive.members)), sectors_of_members(drive)
    moments = jnp.zeros(len(drive.members))
    for member, torque in ((drive.input, bearings.sun_torque), (drive.output, bearings.carrier_torque)):
        number = drive.members.index(member)
        moments = moments - 2.0 * torque * jnp.sign(ideal[number]) * unit[number]
    for pin, body in enumerate(drive.pinned):
        torque = 2.0 * bearing_torque(bearings=bearings, pin_force=pin_force[pin])
        braking = -torque * jnp.sign(ideal[body] - ideal[carrier])
        moments = moments + braking * unit[body]
        if on_carrier:
            moments = moments - sectors[carrier] * braking * unit[carrier]
    return moments


def friction_power(*, drive: Drive, moments: Array, speed: Array) -> Array:
    r"""Power that the bearings take, :math:`-\sum M \omega` over all members of all sectors [W]."""
    copies = jnp.asarray(drive.sectors, dtype=float) / sectors_of_members(drive)
    return -jnp.sum(copies * moments * speed)
