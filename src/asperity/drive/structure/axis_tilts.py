"""Axes out of parallel: by which angles a tilt of some axes opens the contacts of a drive, and skews them."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from asperity.drive.layout.drive import CARRIER, Body, Drive, incidence
from asperity.drive.layout.unfolding import unfolded
from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.types import Array, Real

#: Singular values and skews below this share of the largest ones are zero but for rounding.
_ROUNDING = 1e-9


class AxisTilts(Module):
    """Tilts of axes that something holds: of bodies on the axis or in bearings, of pins, of the carrier.

    Parameters
    ----------
    bodies : tuple of str
        Names of the bodies of a drive of equal sectors, or of the carrier with all its pins; a body on a pin has its
        tilt in every sector.
    out, across : tuple of Real
        Slope of each axis over its length in two directions [rad]: away from the axis of the drive towards its first
        body off it, a pin's towards that pin; and a right angle counter-clockwise from there.
    """

    bodies: tuple[str, ...] = static()
    out: tuple[Real, ...]
    across: tuple[Real, ...]


class ContactAngles(NamedTuple):
    """Angles between the axes of the two bodies of each contact, shape (contacts,) [rad].

    ``slope``, in the plane through both axes: opens the line at one end; ``skew``, across it, nan where nothing but
    friction holds a body against it. ``largest_slope``, ``largest_skew``: of the same tilts in the worst of all
    directions, without sign.
    """

    slope: NDArray[np.float64]
    skew: NDArray[np.float64]
    largest_slope: NDArray[np.float64]
    largest_skew: NDArray[np.float64]


def contact_angles_of_tilts(
    *, drive: Drive, stiffness: Array | NDArray[np.float64], tilts: AxisTilts
) -> ContactAngles:
    r"""Slopes and skews of the contacts of a drive some of whose axes are tilted.

    .. math:: A_f^T K (A_f w_f + A_h w_h) = 0, \qquad \varphi = A w, \qquad \gamma = S w

    Parameters
    ----------
    drive : Drive
        A drive of equal sectors, or one whose sectors :func:`~asperity.drive.layout.unfolding.unfolded` has unfolded.
    stiffness : Array
        Tilt stiffness K of its contacts, shape (contacts,) [N·m/rad].
    tilts : AxisTilts
        Slopes :math:`w_h` of the axes that are held; others that are held are straight.

    Returns
    -------
    ContactAngles
        Of the contacts of the drive, those of its first sector.

    Notes
    -----
    An axis of slope w moves at height z by wz, so that A and S of (M1) give approach and slip there: slope and skew.
    Bodies that no axis holds go where the springs put them; a direction in which none of their contacts opens is held
    by nothing, and the skew in it is not known. Springs are those of small slopes; weights, pins and bearings that give
    way, and forces of the skew along the axes are left out.

    References
    ----------
    Virtual work, as for the approach; equation (M5) of :doc:`/equations`.
    """
    count = len(drive.contacts)
    whole, springs = drive, np.asarray(stiffness, dtype=float)
    in_sectors = any(body.place == "axis" for body in drive.bodies)
    if in_sectors:
        sectors = round(float(drive.sectors))
        whole, springs = unfolded(drive, sectors=sectors), np.tile(springs, sectors)
    approach, sliding = _incidence_of_all(whole)
    free = np.repeat([body.place == "free" for body in whole.bodies], 2)
    held = _held_slopes(whole, tilts)
    turned = np.stack([-held[:, 1], held[:, 0]], axis=1)
    root = np.sqrt(springs)[:, None]
    left, values, right = np.linalg.svd(root * approach[:, free], full_matrices=True)
    kept = values > _ROUNDING * np.max(values, initial=0.0)
    rank = int(np.sum(kept))
    loose = sliding[:, free] @ right[rank:].T  # skews that nothing resists
    unknown = np.any(np.abs(loose) > _ROUNDING, axis=1)
    slopes, skews = [], []
    for given in (held.ravel(), turned.ravel()):
        pushed = -(root[:, 0] * (approach @ given))
        slope = given.copy()
        slope[free] = right[:rank].T @ ((left[:, :rank].T @ pushed) / values[:rank])  # (M5)
        slopes.append((approach @ slope)[:count])
        skews.append(np.where(unknown, np.nan, sliding @ slope)[:count])
    return ContactAngles(slopes[0], skews[0], np.hypot(*slopes), np.hypot(*skews))


def _incidence_of_all(drive: Drive) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """A and S of a drive none of whose bodies is held, shape (contacts, 2 bodies) [-]."""
    loose = dataclasses.replace(
        drive,
        bodies=tuple(Body(body.name, "free", central=body.central) for body in drive.bodies),
        push_angles=xp.zeros(0),
        motion=None,
    )
    found = incidence(loose)
    return np.asarray(found.approach, dtype=float), np.asarray(found.sliding, dtype=float)


def _held_slopes(drive: Drive, tilts: AxisTilts) -> NDArray[np.float64]:
    """Slope of the axis of each body, 0 of those that are straight or free, shape (bodies, 2) [rad]."""
    centres = np.asarray(drive.centres, dtype=float)
    away = np.hypot(*centres.T)
    first = int(np.argmax(away > _ROUNDING * np.max(away)))
    in_sectors = any(body.central for body in drive.bodies)
    slopes = np.zeros_like(centres)
    for name, out, across in zip(tilts.bodies, tilts.out, tilts.across, strict=True):
        for number, body in enumerate(drive.bodies):
            if name == CARRIER:
                tilted, at = body.place == "pin", first
            elif body.place == "pin":
                own = (
                    body.name.rpartition("_")[0] if in_sectors else body.name
                )  # without the number of its sector
                tilted, at = name == own, number
            else:
                tilted, at = name == body.name, first
            if tilted:
                radial = centres[at] / away[at]
                slopes[number] += float(out) * radial + float(across) * np.array([-radial[1], radial[0]])
    return slopes
