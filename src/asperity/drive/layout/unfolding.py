r"""A drive with every sector by itself, so that its sectors may differ, and what its forces do to the centre."""

from __future__ import annotations

import dataclasses

from asperity.drive.layout.drive import Body, Closure, Contact, Drive, incidence, sector_rotation
from asperity.engine.arrays import xp
from asperity.types import Array


def unfolded(drive: Drive, *, sectors: int, floating: tuple[str, ...] = ()) -> Drive:
    """The same drive as one sector that contains all bodies.

    Parameters
    ----------
    drive : Drive
        A drive of equal sectors.
    sectors : int
        Their number, that of the drive.
    floating : tuple of str, optional
        Names of the bodies on the axis whose centres can move; bearings hold the others there.

    Returns
    -------
    Drive
        Bodies on the axis once, with their names; then the others and their contacts sector by sector, with the number
        of the sector behind their names, counter-clockwise from 1. Pins likewise.

    References
    ----------
    Elementary.
    """
    central = {body.name for body in drive.bodies if body.place == "axis"}

    def named(name: str, sector: int) -> str:
        return name if name in central else f"{name}_{sector % sectors + 1}"

    bodies = [
        Body(body.name, "free" if body.name in floating else "held", central=True)
        for body in drive.bodies
        if body.name in central
    ]
    centres = [
        centre for body, centre in zip(drive.bodies, drive.centres, strict=True) if body.name in central
    ]
    contacts = []
    for sector in range(sectors):
        turned = sector_rotation(drive, sector)
        for body, centre in zip(drive.bodies, drive.centres, strict=True):
            if body.name not in central:
                bodies.append(Body(named(body.name, sector), body.place))
                centres.append(turned @ centre)
        contacts += [
            Contact(
                f"{contact.name}_{sector + 1}",
                named(contact.first, sector),
                named(contact.second, sector + contact.sector),
                internal=contact.internal,
                tracks=contact.tracks,
            )
            for contact in drive.contacts
        ]
    return dataclasses.replace(
        drive,
        bodies=tuple(bodies),
        contacts=tuple(contacts),
        centres=xp.stack(centres),
        first_radius=xp.tile(drive.first_radius, sectors),
        second_radius=xp.tile(drive.second_radius, sectors),
        push_angles=xp.tile(drive.push_angles, sectors),
        sectors=1.0,
        closure=_closure_of_sectors(drive.closure, sectors),
        motion=None,
    )


def _closure_of_sectors(closure: Closure, sectors: int) -> Closure:
    """The closure of every sector, with the number of the sector behind the names."""
    numbers = range(1, sectors + 1)
    return Closure(
        equal_coefficients=tuple(
            (f"{first}_{number}", f"{second}_{number}")
            for number in numbers
            for first, second in closure.equal_coefficients
        ),
        constant_pins=tuple(f"{body}_{number}" for number in numbers for body in closure.constant_pins),
    )


def forces_on_centre(
    *, drive: Drive, bodies: tuple[str, ...], normal: Array, tangential: Array, pin_force: Array
) -> Array:
    r"""Resultant forces of contacts and pins on the members in the middle of an unfolded drive.

    .. math:: F_b = -\left(A^\mathsf{T} N + S^\mathsf{T} T\right)_b, \qquad F_c = \sum_p F_p\,e_p

    Parameters
    ----------
    drive : Drive
        The drive, of :func:`unfolded`.
    bodies : tuple of str
        Names of those of its bodies that are on the axis.
    normal, tangential : Array
        Forces of the contacts, counter-clockwise as in :class:`asperity.drive.state.state.DriveState`, shape
        (contacts,) [N].
    pin_force : Array
        Force of each roller on its pin along the push, shape (pins,) [N].

    Returns
    -------
    Array
        Forces on these bodies and then on the carrier, which their bearings carry, shape (bodies + 1, 2) [N]; zero for
        equal sectors.

    References
    ----------
    Balance of each body; equations (I4) and (M1) of :doc:`/equations`.
    """
    loose = tuple(Body(body.name, "free" if body.place == "held" else body.place) for body in drive.bodies)
    matrices = incidence(dataclasses.replace(drive, bodies=loose, motion=None))
    on_bodies = -(matrices.approach.T @ normal + matrices.sliding.T @ tangential).reshape(-1, 2)
    on_carrier = (matrices.pins.T @ pin_force).reshape(-1, 2).sum(axis=0)
    numbers = xp.array([drive.members.index(name) for name in bodies])
    return xp.concatenate([on_bodies[numbers], on_carrier[None]])
