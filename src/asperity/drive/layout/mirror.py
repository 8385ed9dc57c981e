"""Drives that are their own mirror images: what they do under a torque, they do mirrored under the opposite one."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Contact, Drive

_ALIKE = 1e-9  # relative difference up to which lengths, and of a sector up to which angles are the same


class MirrorImage(NamedTuple):
    """Numbers of the images of the bodies and of the contacts of a sector."""

    bodies: tuple[int, ...]
    contacts: tuple[int, ...]


def mirror_image(drive: Drive) -> MirrorImage | None:
    """The mirror image of a drive in a line through its axis and a roller."""
    if np.any(np.asarray(drive.push_angles)):
        return None
    x, y = np.asarray(drive.centres, dtype=float).T
    orbits, angles = np.hypot(x, y), np.arctan2(y, x)
    step = 2.0 * math.pi / round(float(drive.sectors))
    for axis in angles[orbits > 0.0]:
        turned = _bodies(drive, orbits, (angles - axis) / step)
        contacts = None if turned is None else _contacts(drive, *turned)
        if turned is not None and contacts is not None:
            image = MirrorImage(turned[0], contacts)
            return image if _assumes_alike(drive, image) else None
    return None


def _assumes_alike(drive: Drive, image: MirrorImage) -> bool:
    """Whether what is assumed in place of compatibility is its own mirror image."""
    body = {
        member.name: drive.bodies[other].name
        for member, other in zip(drive.bodies, image.bodies, strict=True)
    }
    contact = {
        pair.name: drive.contacts[other].name
        for pair, other in zip(drive.contacts, image.contacts, strict=True)
    }
    pins, pairs = drive.closure.constant_pins, drive.closure.equal_coefficients
    return {body[name] for name in pins} == set(pins) and (
        {frozenset(contact[name] for name in pair) for pair in pairs} == {frozenset(pair) for pair in pairs}
    )


def _bodies(
    drive: Drive, orbits: np.ndarray, sectors: np.ndarray
) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """The image of each body and its sector, from polar angles about the line in sectors."""
    images, shifts = [], []
    for body, orbit, sector in zip(drive.bodies, orbits, sectors, strict=True):
        for number, other in enumerate(drive.bodies):
            shift = 0.0 if orbit == 0.0 else -sector - sectors[number]
            alike = abs(orbits[number] - orbit) <= _ALIKE * orbit and abs(shift - round(shift)) <= _ALIKE
            if alike and other.place == body.place and (orbit > 0.0 or other is body):
                images.append(number)
                shifts.append(round(shift))
                break
        else:
            return None
    return tuple(images), tuple(shifts)


def _contacts(drive: Drive, images: tuple[int, ...], shifts: tuple[int, ...]) -> tuple[int, ...] | None:
    """The image of each contact."""
    number = {body.name: i for i, body in enumerate(drive.bodies)}
    count, radii = round(float(drive.sectors)), np.array([drive.first_radius, drive.second_radius])

    def sector(contact: Contact, value: int) -> int:
        central = "axis" in (drive.bodies[number[name]].place for name in (contact.first, contact.second))
        return 0 if central else value % count

    def is_image(contact: Contact, size: np.ndarray, other: Contact, other_size: np.ndarray) -> bool:
        one, two = number[contact.first], number[contact.second]
        shift = shifts[two] - contact.sector - shifts[one]
        ways = [((other.first, other.second), other.sector, other.tracks, other_size)]
        ways.append(((other.second, other.first), -other.sector, other.tracks[::-1], other_size[::-1]))
        return contact.internal == other.internal and any(
            (number[names[0]], number[names[1]]) == (images[one], images[two])
            and sector(contact, shift) == sector(contact, beyond)
            and tracks == contact.tracks
            and bool(np.all(np.abs(sizes - size) <= _ALIKE * size))
            for names, beyond, tracks, sizes in (ways[:1] if contact.internal else ways)
        )

    contact_images = []
    for contact, size in zip(drive.contacts, radii.T, strict=True):
        for k, other in enumerate(drive.contacts):
            if is_image(contact, size, other, radii[:, k]):
                contact_images.append(k)
                break
        else:
            return None
    return tuple(contact_images)
