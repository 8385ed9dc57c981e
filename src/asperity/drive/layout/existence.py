"""Layouts of drives that cannot exist: gaps, overlaps, and a wrong number of degrees of freedom."""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import CARRIER, Drive, Incidence, gaps, incidence, speeds
from asperity.engine.arrays import as_numbers, xp
from asperity.errors import InputError
from asperity.types import Array

#: Largest distance between the bodies of a contact, relative to their radii, that is accepted.
TOUCH_TOLERANCE = 1e-9

#: Smallest speed of the output, relative to the fastest member, that is more than rounding.
LEAST_OUTPUT_SHARE = 1e-9


class _Measures(NamedTuple):
    """What decides whether a drive can exist, computed at once."""

    gaps: Array
    neighbours: dict[tuple[str, str], Array]
    incidence: Incidence
    output_share: Array


def _measured(drive: Drive) -> _Measures:
    drive = as_numbers(drive)
    with np.errstate(all="ignore"):  # what cannot exist is judged by the nan that it makes
        return _Measures(gaps(drive), neighbour_gaps(drive), incidence(drive), output_share(drive))


def refuse_impossible(drive: Drive) -> None:
    """Raise unless the bodies of every contact touch, no others overlap, and one input speed fixes all others.

    Parameters
    ----------
    drive : Drive
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
                "too far apart; make it or them larger, or arrange more of them around the axis"
            )
    for name in (drive.input, drive.output, drive.grounded):
        if name not in drive.members:
            raise InputError(
                f"there is no member '{name}'; input, output and grounded must each be one of "
                f"{', '.join(drive.members)}"
            )
    measures = _measured(drive)
    for contact, gap, size in zip(
        drive.contacts, measures.gaps, np.asarray(drive.second_radius), strict=True
    ):
        if not abs(gap) <= TOUCH_TOLERANCE * size:
            state = "do not touch (gap" if gap > 0.0 else "overlap (by"
            raise InputError(
                f"contact {contact.name}: {contact.first} and {contact.second} {state} {abs(gap) * 1e3:.6g} mm); "
                "change a radius or a centre so that they just touch"
            )
    _refuse_overlap(measures.neighbours)
    freedom = len(drive.members) - 1 - int(np.linalg.matrix_rank(_driven(drive, measures), tol=1e-9))
    if freedom != 1:
        raise InputError(
            f"with {drive.grounded} grounded the drive has {freedom} degrees of freedom; it must have 1: "
            + ("ground another member" if freedom > 1 else "the contacts block each other")
        )
    if float(measures.output_share) < LEAST_OUTPUT_SHARE:
        raise InputError(
            f"{drive.output}, the output, stands still whatever {drive.input} does: the ratio is infinite; change a "
            "radius, or choose another output"
        )
    pulling = pulling_contacts(drive)
    if pulling:
        raise InputError(
            f"no interference presses all contacts of this drive: {' and '.join(pulling)} would have to pull, because "
            "the other contacts push a roller away there; change the radii so that each roller is held between others"
        )


def has_room(drive: Drive) -> Array:
    """Whether the bodies of every contact touch, and no others overlap; for programs, where nothing can be raised."""
    touch = abs(gaps(drive)) <= TOUCH_TOLERANCE * xp.asarray(drive.second_radius)
    return xp.all(xp.stack([*touch, *(gap >= 0.0 for gap in neighbour_gaps(drive).values())]))


def output_share(drive: Drive) -> Array:
    """Speed of the output over that of the fastest member [-]."""
    speed = abs(speeds(drive))
    return speed[drive.members.index(drive.output)] / speed.max()


def pulling_contacts(drive: Drive) -> tuple[str, ...]:
    r"""Names of the contacts that would have to pull for the normal forces of the assembled drive to balance.

    .. math:: A^\mathsf{T} N + P^\mathsf{T} Q = 0

    None where the forces N of all contacts can press, or where the balance leaves several ratios of forces. N are the
    normal forces of the contacts of every floating body and Q the push of its pin; friction does not act before the
    drive carries a torque. Equation (M1) of :doc:`/equations`. The drive has concrete (not traced) values.
    """
    matrices = incidence(as_numbers(drive))
    balance = np.concatenate([matrices.approach, matrices.pins]).T
    _, values, rows = np.linalg.svd(balance)
    unknown = balance.shape[1] - int(np.sum(values > 1e-9 * values.max(initial=0.0)))
    if unknown != 1:
        return ()
    normal = rows[-1, : len(drive.contacts)]
    normal = normal * np.sign(np.sum(np.sign(normal)) or 1.0) / np.max(np.abs(normal))
    return tuple(contact.name for contact, force in zip(drive.contacts, normal, strict=True) if force < 1e-9)


def _driven(drive: Drive, measures: _Measures) -> np.ndarray:
    """Surface speeds per angular velocity of every member that can turn, relative to the largest radius."""
    turning = np.asarray(measures.incidence.turning)
    grounded = drive.members.index(drive.grounded)
    free: np.ndarray = np.delete(turning, grounded, axis=1) / np.max(np.abs(turning))
    if drive.pinned or drive.grounded == CARRIER:
        return free
    return np.vstack([free, np.eye(free.shape[1])[-1]])  # the carrier supports nothing: it is taken as fixed


def neighbour_gaps(drive: Drive) -> dict[tuple[str, str], Array]:
    r"""Clearances between bodies without a contact with each other: their two names → gap [m], negative in overlap.

    .. math:: \sqrt{(r_i - r_j)^2 + 4 r_i r_j \sin^2(\varphi/2)} - R_i - R_j, \qquad R_j - r_i - R_i

    with the orbits r of their centres and the smallest angle φ between any two of their copies; the second in a ring.
    Neighbours of one kind are taken with their largest track, others, whose tracks may lie in different planes, with
    their smallest. Law of cosines.
    """
    radii: dict[str, list[Array]] = {}
    for k, contact in enumerate(drive.contacts):
        radii.setdefault(contact.first, []).append(drive.first_radius[k])
        radii.setdefault(contact.second, []).append(drive.second_radius[k])
    step = 2.0 * math.pi / xp.asarray(drive.sectors, dtype=float)
    x, y = drive.centres[:, 0], drive.centres[:, 1]
    squares = x**2 + y**2
    orbit = xp.where(squares > 0.0, xp.sqrt(xp.where(squares > 0.0, squares, 1.0)), 0.0)
    clearances, rings = {}, _rings(drive)
    for one, two in neighbours(drive):
        i, j = (drive.members.index(name) for name in (one, two))
        if two in rings:
            clearances[one, two] = xp.max(xp.stack(radii[two])) - orbit[i] - xp.min(xp.stack(radii[one]))
            continue
        if i == j:
            turned, size = step, 2.0 * xp.max(xp.stack(radii[one]))
        else:
            angle = xp.mod(_polar(x[j], y[j]) - _polar(x[i], y[i]), step)
            turned = xp.minimum(angle, step - angle)
            size = xp.min(xp.stack(radii[one])) + xp.min(xp.stack(radii[two]))
        alone = (i == j) & (xp.asarray(drive.sectors) < 2.0)
        squared = (orbit[i] - orbit[j]) ** 2 + 4.0 * orbit[i] * orbit[j] * xp.sin(0.5 * turned) ** 2
        clearances[one, two] = xp.where(alone, xp.inf, xp.sqrt(xp.where(alone, 1.0, squared)) - size)
    return clearances


def _polar(x: Array, y: Array) -> Array:
    """Polar angle; 0 for the axis itself."""
    off_axis = (x != 0.0) | (y != 0.0)
    return xp.where(off_axis, xp.arctan2(y, xp.where(off_axis, x, 1.0)), 0.0)


def neighbours(drive: Drive) -> tuple[tuple[str, str], ...]:
    """Pairs of bodies that have no contact with each other and must not overlap: discs, and rollers in a ring.

    Parameters
    ----------
    drive : Drive
        The drive; its numbers do not matter.

    Returns
    -------
    tuple of tuple of str
        Names of two bodies; twice the same for the copies of one in different sectors.

    References
    ----------
    Elementary.
    """
    joined = {frozenset((contact.first, contact.second)) for contact in drive.contacts}
    touched = frozenset().union(*joined)
    rings = _rings(drive)
    discs = [body for body in drive.bodies if body.name in touched and body.name not in rings]
    pairs = [
        (one.name, two.name)
        for one, two in itertools.combinations_with_replacement(discs, 2)
        if not (one is two and one.on_axis)
    ]
    pairs += [(body.name, ring) for body in discs if not body.on_axis for ring in rings]
    return tuple(pair for pair in pairs if frozenset(pair) not in joined)


def _rings(drive: Drive) -> tuple[str, ...]:
    """Names of the rings on the axis, in which others roll."""
    inside = {contact.second for contact in drive.contacts if contact.internal}
    return tuple(body.name for body in drive.bodies if body.name in inside and body.on_axis)


def _refuse_overlap(clearances: dict[tuple[str, str], Array]) -> None:
    """Raise if discs without a common contact overlap."""
    for (one, two), gap in clearances.items():
        if float(gap) < 0.0:
            pair = f"neighbours of {one}" if one == two else f"{one} and {two}"
            raise InputError(
                f"the rollers do not fit: {pair} overlap by {-float(gap) * 1e3:.6g} mm; reduce their radii, or how "
                "many there are around the axis"
            )
