r"""Loads that the contacts of a drive put on its pins, shafts and housing.

Sectors are equal: the forces on bodies on the axis and on the carrier balance, a torque remains.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from jax import Array

from asperity.arrays import namespace
from asperity.drive.layout.drive import CARRIER, Drive, Incidence, incidence, sectors_of_members
from asperity.drive.state.oil import drag_levers, drag_pairs
from asperity.linear import product


class MemberLoads(NamedTuple):
    """Loads of the structure of a drive in one state. SI units.

    Parameters
    ----------
    pin : Array
        Force of each roller on its pin along the push, shape (pins,) [N].
    unbalanced : Array
        Force that no pin takes up, shape (floating, 2) [N]; 0 in a balanced state but for its residual.
    moments : Array
        Moments of contacts, oil and pins on the members, all sectors together, counter-clockwise, shape (members,)
        [N·m].
    """

    pin: Array
    unbalanced: Array
    moments: Array


def member_loads(
    *, drive: Drive, normal: Array, tangential: Array, body_force: Array, drag: Array | None = None
) -> MemberLoads:
    r"""Loads of the structure from the forces of the contacts.

    .. math:: F = P\,(Z - A^\mathsf{T} N - S^\mathsf{T} T)

    Parameters
    ----------
    drive : Drive
        The drive.
    normal, tangential : Array
        Forces of the contacts, counter-clockwise as in :class:`asperity.drive.state.state.DriveState`, shape
        (contacts,) [N].
    body_force : Array
        Forces Z on the floating bodies, shape (floating, 2) [N].
    drag : Array or None, optional
        Drag of the oil, as in :class:`asperity.drive.state.state.DriveState`, shape (contacts,) [N]; None for none.

    Returns
    -------
    MemberLoads
        A pin takes the force along its push.

    References
    ----------
    Balance of each body; equation (M1) of :doc:`/equations`.
    """
    matrices = incidence(drive)
    between = tangential if drag is None else tangential + drag_pairs(drive, drag)
    left = body_force.ravel() - product(matrices.approach.T, normal) - product(matrices.sliding.T, between)
    pin = product(matrices.pins, left)
    moments = member_moments(drive, matrices, tangential, pin)
    return MemberLoads(
        pin=pin,
        unbalanced=(left - product(matrices.pins.T, pin)).reshape(-1, 2),
        moments=moments if drag is None else moments + product(drag_levers(drive), drag),
    )


def pin_components(*, drive: Drive, force: Array) -> tuple[Array, Array]:
    """Components of the forces on the pins, with the signs of every table of loads.

    Parameters
    ----------
    drive : Drive
        The drive.
    force : Array
        Force of each roller on its pin along the push, shape (pins,) [N].

    Returns
    -------
    tuple of Array
        Radial, positive away from the axis, and tangential, positive in the sense in which the input turns, shape
        (pins,) [N].

    References
    ----------
    The push angle is counted from the clockwise tangent, outward.
    """
    xp, push = namespace(drive.push_angles, force), drive.push_angles
    return force * xp.sin(push), -drive.sense * force * xp.cos(push)


def member_moments(drive: Drive, matrices: Incidence, tangential: Array, pin: Array) -> Array:
    """Moments of contacts and pins on the members, those on the axis from all sectors.

    Parameters
    ----------
    drive : Drive
        The drive.
    matrices : Incidence
        Its matrices.
    tangential, pin : Array
        Tangential forces of the contacts, shape (contacts,), and forces of the pins, shape (pins,) [N].

    Returns
    -------
    Array
        Counter-clockwise, shape (members,) [N·m].

    References
    ----------
    Equation (M1) of :doc:`/equations`.
    """
    members = drive.members
    carrier = members.index(CARRIER)
    moments = namespace(matrices, tangential, pin).where(
        np.arange(len(members)) == carrier,
        (matrices.levers * pin).sum(),
        -product(matrices.turning.T, tangential),
    )
    return moments * sectors_of_members(drive)
