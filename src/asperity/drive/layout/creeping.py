"""Speeds of a drive whose contacts creep."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.layout.drive import CARRIER, Drive, incidence, speeds
from asperity.linear import least_squares, product


def creeping_speeds(*, drive: Drive, creepage: Array) -> tuple[Array, Array]:
    r"""Angular velocities of all members with given creepages, per angular velocity of the input.

    .. math:: W \omega = \xi \, V\omega, \qquad \omega_{in} = \pm 1, \quad \omega_{grounded} = 0

    Parameters
    ----------
    drive : Drive
        The drive.
    creepage : Array
        Creepages of the contacts, counter-clockwise as in :class:`asperity.drive.state.state.DriveState`, shape
        (contacts,) [-].

    Returns
    -------
    tuple of Array
        Speeds of the members, shape (members,) [-], and the rolling speeds of the contacts relative to the carrier,
        shape (contacts,) [m].

    Notes
    -----
    Creepages of a rolling state satisfy all equations; others in the sense of least squares.

    References
    ----------
    The definition of creepage: difference of the surface speeds over their mean. Equations (B1) and (M2) of
    :doc:`/equations`.
    """
    turning, members = incidence(drive).turning, drive.members
    ideal, carrier = speeds(drive), members.index(CARRIER)
    first = np.array([members.index(contact.first) for contact in drive.contacts])
    second = np.array([members.index(contact.second) for contact in drive.contacts])
    unit = np.eye(len(members))
    rolled = jnp.zeros_like(turning)
    for body, radius in ((first, drive.first_radius), (second, drive.second_radius)):
        half = 0.5 * radius * jnp.sign(ideal[body] - ideal[carrier])
        rolled = rolled + half[:, None] * (unit[body] - unit[carrier])
    known = [members.index(drive.input), members.index(drive.grounded)]
    free = np.array([i for i in range(len(members)) if i not in known])
    matrix = turning - creepage[:, None] * rolled
    scale = jnp.max(jnp.abs(turning))
    speed_ratio = least_squares(matrix[:, free] / scale, -drive.sense * matrix[:, known[0]] / scale)
    speed = drive.sense * unit[known[0]] + product(unit[free].T, speed_ratio)
    return speed, product(rolled, speed)
