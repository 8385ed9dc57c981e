"""Wedges of a drive: rollers on pins between a roller that only its contacts support and a ring."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive
from asperity.engine.arrays import xp
from asperity.types import Array, Real


class WedgeAngles(NamedTuple):
    """Angles of a wedge (A1) [rad].

    alpha at the axis between the floating roller and the one in the wedge; theta from the radial line through the
    floating roller to the direction of the one in the wedge; beta between the two contacts of the roller in the wedge:
    half of it is the self-locking angle.
    """

    polar: Real
    direction: Real
    wedge: Real


def wedges(drive: Drive) -> tuple[tuple[int, int], ...]:
    """The contacts of each roller in a wedge: with the floating roller, and with the ring.

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    tuple of tuple of int
        Numbers of contacts in one sector; empty for a drive without wedges.
    """
    place = {body.name: body.place for body in drive.bodies}
    wedge_contacts = []
    for body in drive.bodies:
        touching = [
            k for k, contact in enumerate(drive.contacts) if body.name in (contact.first, contact.second)
        ]
        if body.place != "pin" or len(touching) != 2:
            continue
        inner = [k for k in touching if not drive.contacts[k].internal and drive.contacts[k].sector == 0]
        outer = [k for k in touching if drive.contacts[k].internal and drive.contacts[k].first == body.name]
        others = [{drive.contacts[k].first, drive.contacts[k].second} - {body.name} for k in inner]
        if inner and outer and all(place[name] == "free" for name in others[0]):
            wedge_contacts.append((inner[0], outer[0]))
    return tuple(wedge_contacts)


def wedge_angles(drive: Drive) -> WedgeAngles:
    r"""Angles of the first wedge of a drive.

    .. math:: \beta = \theta - \alpha

    Parameters
    ----------
    drive : Drive
        A drive with wedges.

    Returns
    -------
    WedgeAngles
        Without signs [rad].

    References
    ----------
    Equation (A1) of :doc:`/equations`.
    """
    contact = drive.contacts[wedges(drive)[0][0]]
    number = {body.name: i for i, body in enumerate(drive.bodies)}
    first, second = number[contact.first], number[contact.second]
    inner, roller = (first, second) if drive.bodies[second].place == "pin" else (second, first)
    centres = drive.centres
    polar = _angle_between(centres[inner], centres[roller])
    direction = _angle_between(centres[inner], centres[roller] - centres[inner])
    return WedgeAngles(polar, direction, direction - polar)


def _angle_between(one: Array, other: Array) -> Real:
    """Angle between two vectors, without sign [rad]."""
    cross = one[0] * other[1] - one[1] * other[0]
    return xp.arctan2(abs(cross), (one * other).sum())


def self_locking_ratio(drive: Drive, friction_coefficient: Array) -> Real:
    r"""Friction that wedges need to hold themselves over the friction they have, :math:`\tan(\beta/2)/\mu`.

    [-].
    """
    inner = np.array([pair[0] for pair in wedges(drive)])
    return xp.tan(0.5 * wedge_angles(drive).wedge) / friction_coefficient[inner].min()
