"""Masses of the bodies of a drive, for its motions."""

from __future__ import annotations

import numpy as np

from asperity.drive.layout.drive import CARRIER, Drive, sectors_of_members
from asperity.types import Real


def roller_inertia(*, mass: Real, radius: Real, bore_diameter: Real) -> Real:
    r"""Moment of inertia of a roller about its own axis, :math:`I = \tfrac12 m (R^2 + d^2/4)`.

    Parameters
    ----------
    mass : Real
        Mass m [kg].
    radius : Real
        Outer radius R [m].
    bore_diameter : Real
        Diameter d of its bore, 0 for a solid roller [m].

    Returns
    -------
    Real
        Moment of inertia [kg·m^2].

    References
    ----------
    Closed form of a hollow cylinder; equation (D1) of :doc:`/equations`.
    """
    return 0.5 * mass * (radius**2 + 0.25 * bore_diameter**2)


def mass_matrix(*, drive: Drive, masses: np.ndarray, spins: np.ndarray) -> np.ndarray:
    r"""Masses of all bodies of a drive for its motions.

    .. math::
        \tfrac12\, \dot q^\mathsf{T} M\, \dot q = \sum_b n_b \left[\tfrac12 m_b
        \left|\dot u_b + \dot\psi_c\, \hat z \times c_b\right|^2 + \tfrac12 I_b\, \dot\psi_b^2\right]

    The motions q are the displacements u of the floating centres, seen from the carrier, which takes the centres c
    along, then the rotations psi of all members.

    Parameters
    ----------
    drive : Drive
        The drive.
    masses, spins : ndarray
        Mass [kg] and moment of inertia about its own axis [kg·m^2] of one of each body, shape (bodies,).

    Returns
    -------
    ndarray
        Shape (motions, motions) [kg], [kg·m] and [kg·m^2]; without the carrier, whose shape is not known.

    Notes
    -----
    Coriolis forces of a carrier that turns are left out: its speed is far below the frequencies.

    References
    ----------
    Kinetic energy of rigid bodies; equation (D1) of :doc:`/equations`.
    """
    moves, carrier = 2 * len(drive.floating), 2 * len(drive.floating) + drive.members.index(CARRIER)
    copies = np.asarray(drive.sectors, dtype=float) / np.asarray(sectors_of_members(drive))
    matrix = np.zeros((moves + len(drive.members),) * 2)
    for body, (mass, spin) in enumerate(zip(masses, spins, strict=True)):
        matrix[moves + body, moves + body] += copies[body] * spin
        if drive.bodies[body].on_axis and body not in drive.floating:
            continue
        x, y = np.asarray(drive.centres[body], dtype=float)
        velocity = np.zeros((2, len(matrix)))
        velocity[:, carrier] = -y, x
        if body in drive.floating:
            at = 2 * drive.floating.index(body)
            velocity[:, at : at + 2] = np.eye(2)
        matrix += copies[body] * mass * velocity.T @ velocity
    return matrix
