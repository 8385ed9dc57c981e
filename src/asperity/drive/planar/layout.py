r"""A planar roller drive as data: discs and rings, their contacts, and the supports of their centres.

One sector of an n-fold symmetric drive is described. Bodies on the axis (sun, ring) touch n copies of the others; a
contact between neighbouring sectors names the sector of its second body. Everything else follows from the centres:
the directions of the contacts, the approaches and slips that displacements and rotations make, and by virtual work
the balance of forces.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.compilation import call_compiled
from asperity.drive.planar.linear import least_squares
from asperity.types import Real

#: The member that carries the pins; it has no contacts of its own.
CARRIER = "carrier"


@dataclass(frozen=True)
class Body:
    """One disc or ring.

    Parameters
    ----------
    name : str
        Its name.
    place : {"axis", "free", "pin"}
        ``axis``: its centre is the drive's axis; ``free``: supported by its contacts only; ``pin``: a pin of the
        carrier supports its centre along the push direction; it is free across.
    """

    name: str
    place: Literal["axis", "free", "pin"]


@dataclass(frozen=True)
class Contact:
    """Where two bodies touch.

    Parameters
    ----------
    name : str
        Its name.
    first, second : str
        Names of the bodies; of an internal contact the first lies inside the second.
    internal : bool
        Whether the first body lies inside the second.
    sector : int
        Sector of the second body, counted counter-clockwise from that of the first.
    tracks : tuple of str
        Names of the tracks of the two bodies on which they roll; a stepped roller has several.
    """

    name: str
    first: str
    second: str
    internal: bool = False
    sector: int = 0
    tracks: tuple[str, str] = ("", "")


class PlanarDrive(eqx.Module):
    """A drive of discs and rings in one plane. SI units; arrays have the body or contact axis first.

    Parameters
    ----------
    bodies : tuple of Body
        Bodies of one sector.
    contacts : tuple of Contact
        Contacts of one sector.
    centres : Array
        Centres of the bodies, shape (bodies, 2) [m].
    first_radius, second_radius : Array
        Radii of the two tracks of each contact, shape (contacts,) [m]; a stepped roller has one for each track.
    push_angles : Array
        Direction of each pin's push from the clockwise tangent, outward, one for each body on a pin, shape (pins,)
        [rad].
    sectors : Real
        Number of sectors of the drive, whole; formulas take it as continuous.
    input, output, grounded : str
        Names of members: bodies on the axis, or :data:`CARRIER`.
    sense : int
        Sense of rotation of the input, +1 counter-clockwise, −1 clockwise.
    """

    bodies: tuple[Body, ...] = eqx.field(static=True)
    contacts: tuple[Contact, ...] = eqx.field(static=True)
    centres: Array
    first_radius: Array
    second_radius: Array
    push_angles: Array
    sectors: Real
    input: str = eqx.field(static=True)
    output: str = eqx.field(static=True)
    grounded: str = eqx.field(static=True)
    sense: int = eqx.field(static=True, default=1)

    @property
    def members(self) -> tuple[str, ...]:
        """All rotating members: the bodies, then the carrier."""
        return (*(body.name for body in self.bodies), CARRIER)

    @property
    def floating(self) -> tuple[int, ...]:
        """Indices of the bodies whose centres can move."""
        return tuple(i for i, body in enumerate(self.bodies) if body.place != "axis")

    @property
    def pinned(self) -> tuple[int, ...]:
        """Indices of the bodies on pins."""
        return tuple(i for i, body in enumerate(self.bodies) if body.place == "pin")


class Incidence(eqx.Module):
    r"""How displacements and rotations move the contacts; its transpose balances the forces.

    Approach :math:`e = A u`, slip at rest :math:`s = S u + W \psi`, elongation of the pins :math:`P u`, where u holds
    the displacements of the floating centres and psi the rotations of the members, the carrier's included.

    Parameters
    ----------
    approach, sliding : Array
        A and S, shape (contacts, 2 floating) [-].
    turning : Array
        W, surface speed of the first body minus that of the second, relative to the carrier, per angular velocity of
        each member, shape (contacts, members) [m].
    pins : Array
        P, shape (pins, 2 floating) [-].
    levers : Array
        Lever of each pin's push about the axis, counter-clockwise positive, shape (pins,) [m].
    """

    approach: Array
    sliding: Array
    turning: Array
    pins: Array
    levers: Array


def sectors_of_members(drive: PlanarDrive) -> Array:
    """In how many sectors the contacts of each member lie: all for those on the axis, one for the others.

    Parameters
    ----------
    drive : PlanarDrive
        The drive.

    Returns
    -------
    Array
        Numbers, shape (members,) [-].

    References
    ----------
    Elementary.
    """
    on_axis = jnp.array([*(body.place == "axis" for body in drive.bodies), True])
    return jnp.where(on_axis, jnp.asarray(drive.sectors, dtype=float), 1.0)


def sector_rotation(drive: PlanarDrive, sector: int) -> Array:
    r"""Rotation from the first sector of a drive to another.

    Parameters
    ----------
    drive : PlanarDrive
        The drive.
    sector : int
        Number of the other sector, counter-clockwise.

    Returns
    -------
    Array
        Matrix of :math:`2\pi k/n`, shape (2, 2) [-].

    References
    ----------
    Elementary.
    """
    angle = 2.0 * math.pi * sector / jnp.asarray(drive.sectors, dtype=float)
    cosine, sine = jnp.cos(angle), jnp.sin(angle)
    return jnp.stack([jnp.stack([cosine, -sine]), jnp.stack([sine, cosine])])


def _normals(drive: PlanarDrive) -> list[tuple[Array, Array]]:
    """Direction from the first body to each contact, and the rotation of its second body's sector."""
    index = {name: i for i, name in enumerate(drive.members)}
    found = []
    for contact in drive.contacts:
        copy = sector_rotation(drive, contact.sector)
        outward = -1.0 if contact.internal else 1.0
        between = outward * (
            copy @ drive.centres[index[contact.second]] - drive.centres[index[contact.first]]
        )
        found.append((between / jnp.sqrt(jnp.sum(between**2)), copy))
    return found


def contact_angles(drive: PlanarDrive) -> tuple[Array, Array]:
    """Polar angles of the contacts about the centres of their bodies, each body in its own sector.

    Parameters
    ----------
    drive : PlanarDrive
        The drive.

    Returns
    -------
    tuple of Array
        About the first and about the second body, counter-clockwise from the x axis, shape (contacts,) [rad].
    """
    first, second = [], []
    for contact, (normal, copy) in zip(drive.contacts, _normals(drive), strict=True):
        towards = copy.T @ (normal if contact.internal else -normal)
        first.append(jnp.arctan2(normal[1], normal[0]))
        second.append(jnp.arctan2(towards[1], towards[0]))
    return jnp.stack(first), jnp.stack(second)


def incidence(drive: PlanarDrive) -> Incidence:
    """Directions, levers and surface speeds of a drive.

    Parameters
    ----------
    drive : PlanarDrive
        The drive.

    Returns
    -------
    Incidence
        Its matrices.

    References
    ----------
    Plane kinematics of rigid bodies; equation (M1) of :doc:`/equations`.
    """
    index = {name: i for i, name in enumerate(drive.members)}
    column = {i: 2 * k for k, i in enumerate(drive.floating)}
    width, carrier = 2 * len(drive.floating), index[CARRIER]
    approach, sliding, turning = [], [], []
    for k, (contact, (normal, copy)) in enumerate(zip(drive.contacts, _normals(drive), strict=True)):
        one, two = index[contact.first], index[contact.second]
        outward = -1.0 if contact.internal else 1.0
        tangent = jnp.stack([-normal[1], normal[0]])
        rows = [jnp.zeros(width), jnp.zeros(width)]
        for body, share in ((one, jnp.eye(2)), (two, -copy)):
            if body in column:
                at = slice(column[body], column[body] + 2)
                rows = [
                    row.at[at].add(direction @ share)
                    for row, direction in zip(rows, (normal, tangent), strict=True)
                ]
        approach.append(rows[0])
        sliding.append(rows[1])
        first, second = drive.first_radius[k], outward * drive.second_radius[k]
        turning.append(
            jnp.zeros(len(index)).at[one].add(first).at[two].add(second).at[carrier].add(-first - second)
        )
    pins, levers = [], []
    for angle, body in zip(drive.push_angles, drive.pinned, strict=True):
        centre = drive.centres[body]
        radial = centre / jnp.sqrt(jnp.sum(centre**2))
        clockwise = jnp.stack([radial[1], -radial[0]])
        push = jnp.cos(angle) * clockwise + jnp.sin(angle) * radial
        pins.append(jnp.zeros(width).at[column[body] : column[body] + 2].set(push))
        levers.append(centre[0] * push[1] - centre[1] * push[0])
    return Incidence(
        approach=jnp.stack(approach),
        sliding=jnp.stack(sliding),
        turning=jnp.stack(turning),
        pins=jnp.stack(pins) if pins else jnp.zeros((0, width)),
        levers=jnp.stack(levers) if levers else jnp.zeros(0),
    )


def gaps(drive: PlanarDrive) -> Array:
    """Clearance between the two bodies of each contact; 0 where they just touch, negative where they overlap.

    Parameters
    ----------
    drive : PlanarDrive
        The drive.

    Returns
    -------
    Array
        Distances, shape (contacts,) [m].
    """
    index = {body.name: i for i, body in enumerate(drive.bodies)}
    found = []
    for k, contact in enumerate(drive.contacts):
        copy = sector_rotation(drive, contact.sector)
        between = copy @ drive.centres[index[contact.second]] - drive.centres[index[contact.first]]
        distance = jnp.sqrt(jnp.sum(between**2))
        one, two = drive.first_radius[k], drive.second_radius[k]
        found.append(two - one - distance if contact.internal else distance - one - two)
    return jnp.stack(found)


def speeds(drive: PlanarDrive) -> Array:
    r"""Angular velocities of all members without slip, per angular velocity of the input.

    .. math:: W \omega = 0, \qquad \omega_{in} = \pm 1, \quad \omega_{grounded} = 0

    Parameters
    ----------
    drive : PlanarDrive
        The drive.

    Returns
    -------
    Array
        Speeds, shape (members,) [-].

    References
    ----------
    Rolling without slip at every contact, relative to the carrier; equation (M2) of :doc:`/equations`.
    """
    return jnp.asarray(call_compiled(_speeds, drive))


def _speeds(drive: PlanarDrive) -> Array:
    turning = incidence(drive).turning
    members = drive.members
    known = [members.index(drive.input), members.index(drive.grounded)]
    free = [i for i in range(len(members)) if i not in known]
    matrix, right = turning[:, jnp.array(free)], -drive.sense * turning[:, known[0]]
    scale = jnp.max(jnp.abs(turning))
    found = least_squares(matrix / scale, right / scale)
    return jnp.zeros(len(members)).at[known[0]].set(float(drive.sense)).at[jnp.array(free)].set(found)


def speed_ratio(drive: PlanarDrive) -> Real:
    """Speed of the input over that of the output.

    Parameters
    ----------
    drive : PlanarDrive
        The drive.

    Returns
    -------
    Real
        Ratio [-]; negative where they rotate in opposite directions.

    References
    ----------
    Equation (M2) of :doc:`/equations`.
    """
    return drive.sense / speeds(drive)[drive.members.index(drive.output)]
