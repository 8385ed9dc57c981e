"""Moments of inertia of a joint with a planar drive, at its input and at its output."""

from __future__ import annotations

import jax.numpy as jnp

from asperity.drive.dynamics import roller_inertia
from asperity.drive.planar.layout import CARRIER, speeds
from asperity.joint.planar.description import PlanarJoint, body_masses, cylinders
from asperity.types import Real


def planar_inertias(joint: PlanarJoint) -> tuple[Real, Real]:
    r"""Inertia of the input roller, and that of all other bodies as the output moves them.

    .. math:: J = \sum_b n_b \left[m_b\,(r_b\,\omega_c)^2 + I_b\,\omega_b^2\right] / \omega_{out}^2

    Parameters
    ----------
    joint : PlanarJoint
        One joint.

    Returns
    -------
    tuple of Real
        About the axis of the input, and at the output [kg·m^2]; without the carrier, whose shape a joint file does not
        state.

    Notes
    -----
    All rollers between input and output count at the output, as if the joint were stiff between them: in a drive of
    several rows the locked frequency comes out a little low.

    References
    ----------
    Twice the kinetic energy of rolling without slip; equation (D1) of :doc:`/equations`.
    """
    drive = joint.drive
    speed = speeds(drive)
    carrier, out = speed[drive.members.index(CARRIER)], speed[drive.members.index(drive.output)]
    own: Real = 0.0
    moved: Real = 0.0
    for number, (body, mass) in enumerate(zip(drive.bodies, body_masses(joint), strict=True)):
        spin = sum(
            roller_inertia(mass=part, radius=radius, bore_diameter=bore)
            for part, radius, bore in cylinders(joint, number)
        )
        if body.name == drive.input:
            own = spin
            continue
        copies = 1 if body.place == "axis" else drive.sectors
        orbit = jnp.sum(drive.centres[number] ** 2) if body.place != "axis" else 0.0
        moved = moved + copies * (mass * orbit * carrier**2 + spin * speed[number] ** 2) / out**2
    return own, moved
