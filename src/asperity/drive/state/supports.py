r"""Supports of the centres of a drive besides its contacts and pins: bearings on the carrier as springs."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive, Incidence
from asperity.engine.arrays import xp
from asperity.types import Array, Real


class Supports(NamedTuple):
    """Springs between floating centres and the carrier, each along one direction.

    Parameters
    ----------
    direction : Array
        Elongation of each spring under the displacements of the floating centres, shape (springs, 2 floating) [-].
    lever : Array
        Lever of each about the axis, counter-clockwise positive, shape (springs,) [m].
    compliance : Array
        Of each, shape (springs,) [m/N].
    """

    direction: Array
    lever: Array
    compliance: Array


def carrier_supports(
    *,
    drive: Drive,
    pin_transverse_stiffness: Real | None,
    planet_support_stiffness: Real | None,
    planets: tuple[int, ...],
) -> Supports | None:
    """Pins across their push, and bearings of planets on the carrier."""
    bodies: list[int] = []
    units: list[Array] = []
    compliances: list[Array] = []
    if pin_transverse_stiffness is not None:
        pinned = np.array(drive.pinned, dtype=int)
        x, y = (drive.centres[pinned] / xp.hypot(*drive.centres[pinned].T)[:, None]).T
        cosine, sine = xp.cos(drive.push_angles), xp.sin(drive.push_angles)
        # radial times cosine less the clockwise tangent times sine
        bodies += drive.pinned
        units += list(xp.stack([x * cosine - y * sine, y * cosine + x * sine], axis=1))
        compliances += [1.0 / xp.asarray(pin_transverse_stiffness, dtype=float)] * len(drive.pinned)
    if planet_support_stiffness is not None:
        bodies += [body for body in planets for _ in range(2)]
        units += list(xp.asarray(np.tile(np.eye(2), (len(planets), 1))))
        compliances += [1.0 / xp.asarray(planet_support_stiffness, dtype=float)] * (2 * len(planets))
    if not bodies:
        return None
    places = xp.asarray(np.eye(len(drive.bodies))[bodies][:, list(drive.floating)])
    along, centres = xp.stack(units), drive.centres[np.array(bodies)]
    return Supports(
        direction=(places[:, :, None] * along[:, None, :]).reshape(len(bodies), -1),
        lever=centres[:, 0] * along[:, 1] - centres[:, 1] * along[:, 0],
        compliance=xp.stack(compliances),
    )


def with_supports(matrices: Incidence, supports: Supports | None) -> Incidence:
    """Matrices of a drive whose pins are followed by its supports; unchanged without supports."""
    if supports is None:
        return matrices
    return dataclasses.replace(
        matrices,
        pins=xp.concatenate([matrices.pins, supports.direction]),
        levers=xp.concatenate([matrices.levers, supports.lever]),
    )
