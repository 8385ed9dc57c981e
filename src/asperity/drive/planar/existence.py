"""Layouts of planar drives that cannot exist: gaps, overlaps, and a wrong number of degrees of freedom."""

from __future__ import annotations

import itertools
import math

import numpy as np

from asperity.drive.planar.layout import CARRIER, PlanarDrive, gaps, incidence, sector_rotation
from asperity.errors import InputError

#: Largest distance between the bodies of a contact, relative to their radii, that is accepted.
TOUCH_TOLERANCE = 1e-9


def refuse_impossible(drive: PlanarDrive) -> None:
    """Raise unless the bodies of every contact touch, no others overlap, and one input speed fixes all others.

    Parameters
    ----------
    drive : PlanarDrive
        The drive, with concrete (not traced) values.

    Raises
    ------
    InputError
        The message gives the members and the clearance, or the number of degrees of freedom.
    """
    for body, centre in zip(drive.bodies, np.asarray(drive.centres), strict=True):
        if not np.all(np.isfinite(centre)):
            raise InputError(
                f"there is no place for {body.name} where it touches all the rollers that it has to touch: they are "
                "too far apart; make it or them larger, or increase the number of sectors"
            )
    for contact, gap, size in zip(
        drive.contacts, np.asarray(gaps(drive)), np.asarray(drive.second_radius), strict=True
    ):
        if not abs(gap) <= TOUCH_TOLERANCE * size:
            state = "do not touch (gap" if gap > 0.0 else "overlap (by"
            raise InputError(
                f"contact {contact.name}: {contact.first} and {contact.second} {state} {abs(gap) * 1e3:.6g} mm); "
                "change a radius or a centre so that they just touch"
            )
    _refuse_overlap(drive)
    for name in (drive.input, drive.output, drive.grounded):
        if name not in drive.members:
            raise InputError(
                f"there is no member '{name}'; input, output and grounded must each be one of "
                f"{', '.join(drive.members)}"
            )
    freedom = len(drive.members) - 1 - int(np.linalg.matrix_rank(_driven(drive), tol=1e-9))
    if freedom != 1:
        raise InputError(
            f"with {drive.grounded} grounded the drive has {freedom} degrees of freedom; it must have 1: "
            + ("ground another member" if freedom > 1 else "the contacts block each other")
        )


def _driven(drive: PlanarDrive) -> np.ndarray:
    """Surface speeds per angular velocity of every member that can turn, relative to the largest radius."""
    turning = np.asarray(incidence(drive).turning)
    grounded = drive.members.index(drive.grounded)
    free: np.ndarray = np.delete(turning, grounded, axis=1) / np.max(np.abs(turning))
    if drive.pinned or drive.grounded == CARRIER:
        return free
    return np.vstack([free, np.eye(free.shape[1])[-1]])  # the carrier supports nothing: it is taken as fixed


def _refuse_overlap(drive: PlanarDrive) -> None:
    """Raise if discs without a common contact overlap.

    Neighbours of one kind are taken with their largest track, others, whose tracks may lie in different planes, with
    their smallest.
    """
    smallest: dict[str, float] = {}
    largest: dict[str, float] = {}
    for k, contact in enumerate(drive.contacts):
        for name, radius in (
            (contact.first, drive.first_radius[k]),
            (contact.second, drive.second_radius[k]),
        ):
            smallest[name] = min(smallest.get(name, math.inf), float(radius))
            largest[name] = max(largest.get(name, 0.0), float(radius))
    inside = {contact.second for contact in drive.contacts if contact.internal}
    touching = {frozenset((contact.first, contact.second)) for contact in drive.contacts}
    discs = [(i, b) for i, b in enumerate(drive.bodies) if b.name in smallest and b.name not in inside]
    for (i, one), (j, two), sector in itertools.product(discs, discs, range(drive.sectors)):
        same = i == j and (sector == 0 or one.place == "axis")
        if same or frozenset((one.name, two.name)) in touching:
            continue
        copy = sector_rotation(drive, sector)
        between = copy @ np.asarray(drive.centres[j]) - np.asarray(drive.centres[i])
        size = largest if i == j else smallest
        gap = float(np.hypot(*between)) - size[one.name] - size[two.name]
        if gap < 0.0:
            raise InputError(
                f"{one.name} and {two.name} overlap by {-gap * 1e3:.6g} mm; reduce their radii or the number of sectors"
            )
