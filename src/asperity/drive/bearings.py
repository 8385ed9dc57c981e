"""Friction of the bearings of a drive, and the sense that it opposes."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Array, Real


class Bearings(Module):
    r"""Friction torques of the bearings; a pin's is :math:`T_B + \tfrac14 \mu_b F_c d`.

    Each roller has two bearings, which share the force F_c of its pin.

    Parameters
    ----------
    input_torque, roller_torque, output_torque : Real
        Constant friction torque of one bearing of the input, of a roller on a pin, of the output [N·m]; each has two.
    pin_friction_coefficient : Real
        Friction coefficient mu_b of the pins [-]: friction force mu_b F_c at the diameter below.
    pin_friction_diameter : Real
        Diameter d at which that friction acts [m].
    """

    input_torque: Real
    roller_torque: Real
    output_torque: Real
    pin_friction_coefficient: Real
    pin_friction_diameter: Real


def bearing_torque(*, bearings: Bearings, pin_force: Array) -> Array:
    r"""Friction torque of one of a roller's two bearings on its pin, :math:`T_B + \tfrac14 \mu_b |F| d`.

    Parameters
    ----------
    bearings : Bearings
        Friction of the bearings.
    pin_force : Array
        Force of the roller on its pin [N].

    Returns
    -------
    Array
        Torque [N·m].

    References
    ----------
    Coulomb friction at the radius d/2 under half the pin force, for the T_B that equations (3) and (4) of Zou et al.
    2025 leave open.
    """
    pin = 0.25 * bearings.pin_friction_coefficient * bearings.pin_friction_diameter
    return xp.asarray(bearings.roller_torque + pin * xp.abs(pin_force))


def leading_sense(*, rotation: Real, output_torque: Real) -> Array:
    r"""Sense that the friction of bearings opposes, :math:`\operatorname{sgn}\omega`, or that of the torque at rest.

    Parameters
    ----------
    rotation : Real
        Speed of the input, of either sign [any]; 0 where it stands.
    output_torque : Real
        Torque at the output, positive where it resists a positive rotation [N·m].

    Returns
    -------
    Array
        +1 or −1 [-]: that of the rotation; without one that of the torque, because a drive that begins to move follows
        it. A torque against the sense of rotation brakes.

    References
    ----------
    Coulomb friction opposes the motion.
    """
    speed = xp.asarray(rotation)
    leading = xp.where(speed == 0.0, xp.asarray(output_torque), speed)
    return xp.where(leading < 0.0, -1.0, 1.0)
