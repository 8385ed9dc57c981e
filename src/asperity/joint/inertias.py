"""Moments of inertia of a joint, at its input and at its output."""

from __future__ import annotations

import jax.numpy as jnp

from asperity.drive.layout.drive import CARRIER, speeds
from asperity.drive.structure.dynamics import roller_inertia
from asperity.joint.description import Joint, body_masses, cylinders
from asperity.types import Real


def joint_inertias(joint: Joint) -> tuple[Real, Real]:
    r"""Inertia of the input roller, and that of all other bodies as the output moves them.

    .. math::
        J_{in} = I_{in} + \sum_b n_b I_b \left(\frac{\omega_b}{\omega_{in}}\right)^2, \qquad
        J_{out} = \sum_b n_b m_b r_b^2 \left(\frac{\omega_c}{\omega_{out}}\right)^2
        + \sum_a I_a \left(\frac{\omega_a}{\omega_{out}}\right)^2

    over the bodies b off the axis, whose spin the input drives and whose orbit is that of the carrier, and the bodies a
    on the axis.

    Parameters
    ----------
    joint : Joint
        One joint.

    Returns
    -------
    tuple of Real
        About the axis of the input, and at the output [kg·m^2]; without the carrier, whose shape a joint file does not
        state.

    Notes
    -----
    A vibration of the input against the load turns the rollers between them with the input: the free frequency of the
    planetary example is within 1 % of that of all its bodies on the springs of all contacts.

    References
    ----------
    Twice the kinetic energy of rolling without slip; equation (D1) of :doc:`/equations`.
    """
    drive = joint.drive
    speed = speeds(drive)
    carrier, out = speed[drive.members.index(CARRIER)], speed[drive.members.index(drive.output)]
    at_input: Real = 0.0
    moved: Real = 0.0
    for number, (body, mass) in enumerate(zip(drive.bodies, body_masses(joint), strict=True)):
        spin = sum(
            roller_inertia(mass=part, radius=radius, bore_diameter=bore)
            for part, radius, bore in cylinders(joint, number)
        )
        if body.name == drive.input:
            at_input = at_input + spin
            continue
        if body.on_axis:
            moved = moved + spin * (speed[number] / out) ** 2
            continue
        at_input = at_input + drive.sectors * spin * speed[number] ** 2  # the input has the speed 1
        moved = moved + drive.sectors * mass * jnp.sum(drive.centres[number] ** 2) * (carrier / out) ** 2
    return at_input, moved
