r"""A roller drive as data: discs and rings, their contacts, and the supports of their centres.

One sector of an n-fold symmetric drive is described. Bodies on the axis (sun, ring) touch n copies of the others; a
contact between neighbouring sectors names the sector of its second body. Everything else follows from the centres:
the directions of the contacts, the approaches and slips that displacements and rotations make, and by virtual work
the balance of forces.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import Any, Literal, NamedTuple

import numpy as np

from asperity.engine.arrays import xp
from asperity.engine.control import traced_once
from asperity.engine.module import Module, static
from asperity.linear import least_squares, product
from asperity.types import Array, ArrayLike, Real

#: The member that carries the pins; it has no contacts of its own.
CARRIER = "carrier"


@dataclasses.dataclass(frozen=True)
class Body:
    """One disc or ring.

    Parameters
    ----------
    name : str
        Its name.
    place : {"axis", "free", "pin", "held"}
        ``axis``: its centre is the drive's axis; ``free``: supported by its contacts only; ``pin``: a pin of the
        carrier supports its centre along the push direction; it is free across; ``held``: bearings hold it, on the
        drive's axis if its sectors are not equal, or on an axis of its own in the frame, which is a grounded carrier.
    central : bool, optional
        Whether its centre lies on the axis of a drive whose sectors are not equal, where bearings hold it or it moves.
    """

    name: str
    place: Literal["axis", "free", "pin", "held"]
    central: bool = False

    @property
    def on_axis(self) -> bool:
        """Whether it turns about the drive's axis, or one of its own in the frame; all sectors share it."""
        return self.central or self.place in ("axis", "held")


@dataclasses.dataclass(frozen=True)
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


@dataclasses.dataclass(frozen=True)
class Closure:
    """What is assumed of a loaded drive in place of its compatibility, as published closures do; nothing by default.

    Parameters
    ----------
    equal_coefficients : tuple of tuple of str, optional
        Pairs of contacts that have the same traction coefficient T/N while the drive stands, instead of the slip that
        their springs determine (A3); the equation of the second one's slip gives way.
    constant_pins : tuple of str, optional
        Bodies whose pin forces stay those without torque, because a soft spring moves their pins.
    """

    equal_coefficients: tuple[tuple[str, str], ...] = ()
    constant_pins: tuple[str, ...] = ()


class Track(NamedTuple):
    """A track of a body: the contacts that roll on it, by number, and on which side of the first of them it is."""

    contacts: tuple[int, ...]
    side: int


class Layout(NamedTuple):
    """Which member is which, of all drives with the same bodies and contacts; constant arrays of NumPy.

    ``members``: names of all rotating members, the bodies and then the carrier; ``input``, ``output``, ``grounded`` and
    ``carrier``: their numbers; ``turning``: numbers of those whose rotation is unknown, all but the input and the
    grounded one. ``first`` and ``second``: numbers of the bodies of each contact, shape (contacts,); ``outward``: -1
    where the first lies inside the second, else 1; ``sector``: that of the second one. ``floating`` and ``pinned``:
    numbers of the bodies whose centres can move, and of those on pins. ``in_frame``: whether bearings hold bodies on
    axes of their own. ``unit``: a row for each member, shape (members,
    members), and ``relative``, the same less the carrier's. ``on_axis``: members on the axis. ``tracks``: of each body.
    """

    members: tuple[str, ...]
    input: int
    output: int
    grounded: int
    carrier: int
    turning: np.ndarray
    first: np.ndarray
    second: np.ndarray
    outward: Any
    sector: np.ndarray
    floating: tuple[int, ...]
    pinned: tuple[int, ...]
    in_frame: bool
    unit: np.ndarray
    relative: np.ndarray
    on_axis: np.ndarray
    tracks: tuple[tuple[Track, ...], ...]


@functools.lru_cache(maxsize=256)
def _layout(
    bodies: tuple[Body, ...], contacts: tuple[Contact, ...], entry: str, output: str, grounded: str
) -> Layout:
    members = (*(body.name for body in bodies), CARRIER)
    number = {name: place for place, name in enumerate(members)}
    unit = np.eye(len(members))
    return Layout(
        members=members,
        input=number.get(entry, -1),
        output=number.get(output, -1),
        grounded=number.get(grounded, -1),
        carrier=number[CARRIER],
        turning=np.array([i for i, name in enumerate(members) if name not in (entry, grounded)], dtype=int),
        first=np.array([number[contact.first] for contact in contacts], dtype=int),
        second=np.array([number[contact.second] for contact in contacts], dtype=int),
        outward=np.array([-1.0 if contact.internal else 1.0 for contact in contacts]),
        sector=np.array([contact.sector for contact in contacts]),
        floating=tuple(i for i, body in enumerate(bodies) if body.place in ("free", "pin")),
        pinned=tuple(i for i, body in enumerate(bodies) if body.place == "pin"),
        in_frame=any(body.place == "held" and not body.central for body in bodies),
        unit=unit,
        relative=unit - unit[number[CARRIER]],
        on_axis=np.array([*(body.place == "axis" for body in bodies), True]),
        tracks=tuple(_tracks(body.name, contacts) for body in bodies),
    )


def _tracks(body: str, contacts: tuple[Contact, ...]) -> tuple[Track, ...]:
    """The tracks of a body, in the order of their first contacts."""
    tracks: dict[str, Track] = {}
    for number, contact in enumerate(contacts):
        for side, name in enumerate((contact.first, contact.second)):
            if name == body:
                known = tracks.get(contact.tracks[side], Track((), side))
                tracks[contact.tracks[side]] = known._replace(contacts=(*known.contacts, number))
    return tuple(tracks.values())


class Incidence(Module):
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


class Drive(Module):
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
    closure : Closure, optional
        What is assumed in place of compatibility; nothing by default.
    motion : tuple or None, optional
        What :func:`incidence`, :func:`speeds` and :func:`contact_angles` say; None where it is not known. It must not
        be taken over to a drive of another layout.
    """

    bodies: tuple[Body, ...] = static()
    contacts: tuple[Contact, ...] = static()
    centres: Array
    first_radius: Array
    second_radius: Array
    push_angles: Array
    sectors: Real
    input: str = static()
    output: str = static()
    grounded: str = static()
    sense: int = static(default=1)
    closure: Closure = static(default=Closure())
    motion: tuple[Incidence, Array, tuple[Array, Array]] | None = None

    @functools.cached_property
    def layout(self) -> Layout:
        """Which member is which."""
        return _layout(self.bodies, self.contacts, self.input, self.output, self.grounded)

    @property
    def ground(self) -> str:
        """What stands: the grounded member, or the frame where its bearings hold the wheels."""
        return "frame" if self.layout.in_frame and self.grounded == CARRIER else self.grounded

    @property
    def members(self) -> tuple[str, ...]:
        """All rotating members: the bodies, then the carrier."""
        return self.layout.members

    @property
    def turning_alike(self) -> tuple[tuple[str, str], ...]:
        """Bodies that turn by one angle where springs act in series: those whose contacts have one coefficient (A3).

        Equations (25) to (29) of Zou et al. 2025 add both loading rollers of a planet.
        """
        bodies = {contact.name: {contact.first, contact.second} for contact in self.contacts}
        pairs = [(bodies[one], bodies[other]) for one, other in self.closure.equal_coefficients]
        return tuple((min(one - other), min(other - one)) for one, other in pairs if len(one - other) == 1)

    @property
    def floating(self) -> tuple[int, ...]:
        """Indices of the bodies whose centres can move."""
        return self.layout.floating

    @property
    def pinned(self) -> tuple[int, ...]:
        """Indices of the bodies on pins."""
        return self.layout.pinned


def sectors_of_members(drive: Drive) -> Array:
    """In how many sectors the contacts of each member lie, shape (members,): all for those on the axis, else one."""
    return xp.where(drive.layout.on_axis, xp.asarray(drive.sectors, dtype=float), 1.0)


def sector_rotation(drive: Drive, sector: ArrayLike) -> Array:
    """Rotation from the first sector of a drive to others by number, counter-clockwise, shape (..., 2, 2) [-]."""
    angle = 2.0 * math.pi * xp.asarray(sector, dtype=float) / xp.asarray(drive.sectors, dtype=float)
    cosine, sine = xp.cos(angle), xp.sin(angle)
    return xp.stack([xp.stack([cosine, -sine], axis=-1), xp.stack([sine, cosine], axis=-1)], axis=-2)


def _between(drive: Drive) -> tuple[Array, Array]:
    """Vector from the first to the second centre of each contact, and the rotation of the second one's sector."""
    sides = drive.layout
    copies = sector_rotation(drive, sides.sector)
    return product(copies, drive.centres[sides.second]) - drive.centres[sides.first], copies


def _normals(drive: Drive) -> tuple[Array, Array]:
    """Direction from the first body to each contact, and the rotation of its second body's sector."""
    between, copies = _between(drive)
    return (drive.layout.outward / _length(between))[:, None] * between, copies


def _length(vectors: Array) -> Array:
    return xp.sqrt((vectors**2).sum(axis=1))


def contact_angles(drive: Drive) -> tuple[Array, Array]:
    """Polar angles of the contacts about the centres of their bodies, each body in its own sector.

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    tuple of Array
        About the first and about the second body, counter-clockwise from the x axis, shape (contacts,) [rad].
    """
    if drive.motion is not None:
        return drive.motion[2]
    normals, copies = _normals(drive)
    towards = -drive.layout.outward[:, None] * product(copies.swapaxes(1, 2), normals)
    return xp.arctan2(normals[:, 1], normals[:, 0]), xp.arctan2(towards[:, 1], towards[:, 0])


def incidence(drive: Drive) -> Incidence:
    """Directions, levers and surface speeds of a drive.

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    Incidence
        Its matrices.

    References
    ----------
    Plane kinematics of rigid bodies; equation (M1) of :doc:`/equations`.
    """
    if drive.motion is not None:
        return drive.motion[0]
    with np.errstate(all="ignore"):  # of a layout that cannot exist they are nan
        return _incidence(drive)


@traced_once
def _incidence(drive: Drive) -> Incidence:
    sides, (normals, copies) = drive.layout, _normals(drive)
    tangents = xp.stack([-normals[:, 1], normals[:, 0]], axis=1)
    moves = _movable(drive)
    between = moves[sides.first] - (copies[..., None] * moves[sides.second][:, None]).sum(axis=2)
    pinned = np.array(drive.pinned, dtype=int)
    centres = drive.centres[pinned]
    radial = centres / _length(centres)[:, None]
    clockwise = xp.stack([radial[:, 1], -radial[:, 0]], axis=1)
    angles = xp.asarray(drive.push_angles).reshape(-1, 1)
    push = xp.cos(angles) * clockwise + xp.sin(angles) * radial
    return Incidence(
        approach=(normals[:, :, None] * between).sum(axis=1),
        sliding=(tangents[:, :, None] * between).sum(axis=1),
        turning=turning_levers(sides, drive.first_radius, drive.second_radius),
        pins=(push[:, :, None] * moves[pinned]).sum(axis=1),
        levers=centres[:, 0] * push[:, 1] - centres[:, 1] * push[:, 0],
    )


def turning_levers(layout: Layout, first_radius: Array, second_radius: Array) -> Array:
    """W of :class:`Incidence`, of the radii of both tracks of each contact, shape (contacts,) [m]."""
    # speed of a member relative to the carrier
    relative = layout.relative
    return first_radius[:, None] * relative[layout.first] + (
        (layout.outward * second_radius)[:, None] * relative[layout.second]
    )


def _movable(drive: Drive) -> np.ndarray:
    """Where the displacements of each body stand among those of the floating ones, shape (bodies, 2, 2 floating)."""
    floats = np.eye(len(drive.bodies))[:, list(drive.floating)]
    return np.einsum("bf,ij->bifj", floats, np.eye(2)).reshape(len(drive.bodies), 2, -1)


def gaps(drive: Drive) -> Array:
    """Clearance between the two bodies of each contact, shape (contacts,) [m].

    0 where they just touch, negative where they overlap.
    """
    between, _ = _between(drive)
    return drive.layout.outward * (_length(between) - drive.second_radius) - drive.first_radius


def speeds(drive: Drive) -> Array:
    r"""Angular velocities of all members without slip, per angular velocity of the input.

    .. math:: W \omega = 0, \qquad \omega_{in} = \pm 1, \quad \omega_{grounded} = 0

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    Array
        Speeds, shape (members,) [-].

    References
    ----------
    Rolling without slip at every contact, relative to the carrier; equation (M2) of :doc:`/equations`.
    """
    if drive.motion is not None:
        return drive.motion[1]
    turning = incidence(drive).turning
    members = drive.members
    known = [members.index(drive.input), members.index(drive.grounded)]
    free = [i for i in range(len(members)) if i not in known]
    matrix, right = turning[:, np.array(free)], -drive.sense * turning[:, known[0]]
    scale = abs(turning).max()
    speed_ratio = least_squares(matrix / scale, right / scale)
    unit = np.eye(len(members))
    return drive.sense * unit[known[0]] + product(unit[free].T, speed_ratio)


def speed_ratio(drive: Drive) -> Real:
    """Speed of the input over that of the output.

    Parameters
    ----------
    drive : Drive
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


def driving_sense(drive: Drive) -> Array:
    """Sign that makes tangential forces and creepages positive where the first body of a contact drives the second.

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    Array
        +1 or −1, shape (contacts,): the sense in which the first surface moves, seen from the carrier.

    References
    ----------
    Equation (M2) of :doc:`/equations`.
    """
    speed, layout = speeds(drive), drive.layout
    return xp.sign(speed[layout.first] - speed[layout.carrier])


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
    rolled = xp.zeros_like(turning)
    for body, radius in ((first, drive.first_radius), (second, drive.second_radius)):
        half = 0.5 * radius * xp.sign(ideal[body] - ideal[carrier])
        rolled = rolled + half[:, None] * (unit[body] - unit[carrier])
    known = [members.index(drive.input), members.index(drive.grounded)]
    free = np.array([i for i in range(len(members)) if i not in known])
    matrix = turning - creepage[:, None] * rolled
    scale = xp.max(xp.abs(turning))
    speed_ratio = least_squares(matrix[:, free] / scale, -drive.sense * matrix[:, known[0]] / scale)
    speed = drive.sense * unit[known[0]] + product(unit[free].T, speed_ratio)
    return speed, product(rolled, speed)
