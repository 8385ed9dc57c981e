"""Strength of the rings and hollow rollers of a drive that bend: stresses along their rims."""

from __future__ import annotations

import numpy as np

from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import put
from asperity.joint.bodies import exact_bodies
from asperity.joint.bores import pin_forces, pins_in_bores, push_angles
from asperity.joint.description import Joint, places, tracks_of
from asperity.joint.evaluation import JointResult
from asperity.joint.housing import ring_fit, seated
from asperity.joint.rim_safety import BodyRims, PinLoad, body_rims
from asperity.joint.working_loads import working_forces
from asperity.types import Array


def bends(joint: Joint) -> tuple[bool, ...]:
    """Which bodies, in the order of the drive's, have one track and a rim that nothing rigid holds, or a known seat.

    The tracks of a stepped roller lie in different planes: what bends it is not part of plane elasticity.
    """
    return tuple(
        (shape.kind == "hollow" or (shape.kind == "ring" and (shape.support != "rigid_housing" or seat)))
        and len(tracks_of(joint, number)) == 1
        for number, (shape, seat) in enumerate(zip(joint.shapes, seated(joint), strict=True))
    )


def joint_rims(joint: Joint, result: JointResult) -> BodyRims:
    """Strength of the bodies that bend, their axis last, nan for the others; equation (L3) of :doc:`/equations`; pure.

    Away from the contacts, whose own stresses are judged by yield, shakedown and rolling fatigue. Exact plane
    elasticity. Where the input turns, the forces under the torque are those of rolling. Pins of a stated diameter press
    in their bores with the forces that balance those of the contacts, and a described housing on its rings; the stress
    of rotation is not included.
    """
    states = (working_forces(joint, result), (result.rest.normal, result.rest.tangential))
    width = xp.asarray(result.diagnostics.hertz_half_width)
    sectors = 1 if joint.unlike is None else joint.unlike.sectors
    return _in_order(_bending_bodies(joint, states, width, sectors), bends(joint))


def _bending_bodies(
    joint: Joint, states: tuple[tuple[Array, Array], ...], width: Array, sectors: int = 1
) -> list[BodyRims]:
    """Those that bend, under normal and tangential forces, the latter counter-clockwise."""
    drive = joint.drive
    first, _ = places(drive)
    exact = [number for number in range(len(drive.bodies)) if len(tracks_of(joint, number)) == 1]
    members = dict(zip(exact, exact_bodies(joint), strict=True))
    rims = []
    for number, acts in enumerate(bends(joint)):
        if not acts:
            continue
        member = members[number]
        signs = tuple(
            1.0 if first[k] != number and drive.contacts[k].internal else -1.0 for k in member.contacts
        )
        finer = sectors if drive.bodies[number].place == "held" else 1
        pin = _pin_load(joint, number, states)
        seat = ring_fit(joint, number) if seated(joint)[number] else None
        rims.append(body_rims(member, joint.materials[number], states, width, signs, finer, pin, seat))
    return rims


def _pin_load(joint: Joint, number: int, states: tuple[tuple[Array, Array], ...]) -> PinLoad | None:
    """Forces of the pin in the bore of a body in all states; None where no pin is known to press there."""
    drive, bores = joint.drive, pins_in_bores(joint)
    if bores is None or number not in drive.pinned:
        return None
    at = drive.pinned.index(number)
    forces = xp.stack([pin_forces(drive, *state) for state in states])
    angles = [bores.contact.angle(xp.where(force == 0.0, 1.0, xp.abs(force)))[at] for force in forces]
    force = xp.where(bores.contact.scale[at] > 0.0, forces[:, at], 0.0)
    # the pin pushes back
    return PinLoad(
        xp.abs(force), push_angles(drive)[at] + xp.where(force > 0.0, xp.pi, 0.0), xp.stack(angles)
    )


def _in_order(rims: list[BodyRims], bending: tuple[bool, ...]) -> BodyRims:
    """The bodies that bend in the order of all bodies; nan for the others."""
    at = [number for number, acts in enumerate(bending) if acts]
    pair = xp.full((2, len(bending)), xp.nan)
    one = xp.full(len(bending), xp.nan)
    empty = BodyRims(pair, pair, pair, pair, one, one, one)

    def placed(base: Array, *values: Array) -> Array:
        return put(base, (..., np.array(at)), xp.stack(values, axis=-1)) if values else base

    return trees.map(placed, empty, *rims)
