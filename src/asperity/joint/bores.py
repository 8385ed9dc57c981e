"""Pins of the carrier: how they press in the bores of their rollers, and what room and hold they leave them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.body.bore import bore_modes
from asperity.body.conforming_pin import SHARED
from asperity.body.pin_contact import pin_contact
from asperity.body.shapes import Annulus
from asperity.drive.layout.drive import Drive, contact_angles, incidence
from asperity.drive.state.bores import TURNOVER, Bores, PressedBores, by_amplitude
from asperity.drive.state.state import DriveState
from asperity.drive.structure.pin_beam import pin_beam_compliance
from asperity.engine import trees
from asperity.engine.arrays import is_of_jax, xp
from asperity.engine.control import put
from asperity.errors import InputError
from asperity.joint.description import Joint, pin_names, places, track_lengths, tracks_of
from asperity.linear import product
from asperity.types import Array
from asperity.units import format_quantity

#: Largest radial clearance over the diameter of a pin at which its contact in the bore is that of nearly equal radii.
MOST_CLEARANCE = 0.02


def push_angles(drive: Drive) -> Array:
    """Polar angles in which rollers push their pins, counter-clockwise from the x axis, shape (pins,) [rad]."""
    rows = incidence(drive).pins
    at = np.array([2 * drive.floating.index(body) for body in drive.pinned], dtype=int)
    pins = np.arange(at.size)
    return xp.arctan2(rows[pins, at + 1], rows[pins, at])


def pins_in_bores(joint: Joint) -> Bores | None:
    """What the pins of a joint and the contacts of their rollers do to each other; (E5) and (E7) of :doc:`/equations`.

    None where no pin is known to press in a bore. Rollers that are springs have the compliance of their bores alone,
    each track by itself beside the others.
    """
    drive, count = joint.drive, len(joint.drive.contacts)
    if all(joint.shapes[body].pin_diameter is None for body in drive.pinned):
        return None
    first, _ = places(drive)
    at_first, at_second = contact_angles(drive)
    most = max(len(tracks_of(joint, body)) for body in drive.pinned)
    along, rim, laws, pressed = [], [], [], []
    for body, angle in zip(drive.pinned, push_angles(drive), strict=True):
        tracks = tracks_of(joint, body)
        presses = xp.asarray(joint.shapes[body].pin_diameter) > 0.0
        modes = []
        for (_, contacts), annulus in zip(tracks, _annuli(joint, body), strict=True):
            at = xp.stack([at_first[k] if first[k] == body else at_second[k] for k in contacts])
            modes.append(bore_modes(body=annulus, contact_angles=at, push_angle=angle))
        coupled = xp.where(presses & (joint.body_model == "exact") & (len(tracks) == 1), 1.0, 0.0)
        rows = np.array(tracks[0][1])
        rows = np.concatenate([rows, rows + count])
        along.append(put(xp.zeros(2 * count), rows, coupled * modes[0].along))
        rim.append(put(xp.zeros((2 * count, SHARED.size)), rows, coupled * modes[0].rim))
        modes += modes[:1] * (most - len(modes))
        laws.append(trees.map(lambda *tracks: xp.stack(tracks), *((m.shift, m.scale, m.wall) for m in modes)))
        pressed.append(presses & (np.arange(most) < len(tracks)))
    shift, scale, wall = (xp.stack(parts) for parts in zip(*laws, strict=True))
    along_normal, along_tangential = xp.split(xp.stack(along, axis=1), 2)
    rim_normal, rim_tangential = xp.split(xp.stack(rim, axis=1), 2)
    return Bores(
        along_normal=along_normal,
        along_tangential=along_tangential,
        rim_normal=by_amplitude(rim_normal),
        rim_tangential=by_amplitude(rim_tangential),
        contact=pin_contact(
            shift=shift,
            scale=scale,
            wall=wall,
            pressed=xp.stack(pressed),
            clearance=xp.broadcast_to(xp.asarray(joint.pin_clearance, dtype=float), (len(pressed),)),
        ),
    )


def _annuli(joint: Joint, body: int) -> list[Annulus]:
    """A roller on a pin, track by track."""
    shape, material = joint.shapes[body], joint.materials[body]
    assert shape.size is not None
    elastic = (material.youngs_modulus, material.poisson_ratio)
    return [
        Annulus(0.5 * shape.size, radius, length, *elastic, 0.0, 0.0, "outer", joint.plane_state)
        for (radius, _), length in zip(tracks_of(joint, body), track_lengths(joint, body), strict=True)
    ]


def pins_bend(joint: Joint) -> bool:
    """Whether the bending of pins is computed: of a known diameter and length, without a stated stiffness."""
    sized = joint.pin is not None and (is_of_jax(joint.pin.diameter) or bool(joint.pin.diameter > 0.0))
    return joint.pin_stiffness is None and sized and bool(joint.drive.pinned)


def pin_compliances(joint: Joint) -> Array:
    """Compliance of each pin along its push between roller and carrier, shape (pins,) [m/N].

    The stated one, or that of the pin as a beam where its diameter and its length are known; 0 of rigid pins. Its
    contact in the bore is not part of it, :func:`pins_in_bores`. Equation (L4) of :doc:`/equations`.
    """
    drive = joint.drive
    if not pins_bend(joint):
        stiffness = math.inf if joint.pin_stiffness is None else joint.pin_stiffness
        return xp.broadcast_to(1.0 / xp.asarray(stiffness, dtype=float), (len(drive.pinned),))
    assert joint.pin is not None
    diameter = xp.asarray(joint.pin.diameter)
    compliances = [
        pin_beam_compliance(
            free_length=joint.pin.free_length,
            roller_length=sum(track_lengths(joint, body)),
            diameter=xp.where(diameter > 0.0, diameter, 1.0),
            youngs_modulus=joint.materials[body].youngs_modulus,
            poisson_ratio=joint.materials[body].poisson_ratio,
            support=joint.pin.support,
        )
        for body in drive.pinned
    ]
    return xp.stack([xp.where(diameter > 0.0, compliance, 0.0) for compliance in compliances])


class PinLoads(NamedTuple):
    """Forces that decide how pins press in their bores.

    ``force``, of each roller on its pin along the push, shape (pins,); ``added``, what the torque has added to the
    normal forces of the contacts, and ``tangential``, counter-clockwise as in
    :class:`asperity.drive.state.state.DriveState`, shape (contacts,); ``largest``, the largest force of a contact [N].
    """

    force: Array
    added: Array
    tangential: Array
    largest: Array


def pin_loads(state: DriveState, rest: DriveState) -> PinLoads:
    """What presses the pins in a state of a drive that was assembled so."""
    return PinLoads(state.pin_force, state.normal - rest.normal, state.tangential, xp.max(state.normal))


def pressed_bores(bores: Bores, loads: PinLoads, by_torque: Array) -> PressedBores:
    """Pins in their bores around their forces; without force on the side that a torque presses.

    ``by_torque`` are their forces under a small torque, of which the signs count, shape (pins,). At least a small share
    of the largest force of a contact is taken: the stiffness of a pin with clearance vanishes with its force.
    """
    side = xp.where(xp.where(loads.force == 0.0, by_torque, loads.force) < 0.0, -1.0, 1.0)
    return bores.beyond_turnover(side * xp.maximum(xp.abs(loads.force), TURNOVER * loads.largest))


def bore_stiffness(joint: Joint, pin_force: Array, normal_force: Array) -> Array:
    """Stiffness of each pin's contact in its bore around its force, shape (pins,) [N/m]; infinite where none presses.

    Under forces of pins and contacts, shape (pins,) and (contacts,) [N], those of the contacts unchanged.
    """
    bores = pins_in_bores(joint)
    if bores is None:
        return xp.full(len(joint.drive.pinned), np.inf)
    unchanged = xp.zeros_like(normal_force)
    loads = PinLoads(pin_force, unchanged, unchanged, xp.max(normal_force))
    compliance = pressed_bores(bores, loads, pin_force).compliance
    gives = compliance > 0.0
    return xp.where(gives, 1.0 / xp.where(gives, compliance, 1.0), xp.inf)


def pin_contact_angles(joint: Joint, pin_force: Array) -> Array:
    """Half-angles of the arcs over which pins touch their bores under forces, shape (pins,) [rad]; nan where none does.

    Forces of either sign, shape (pins,) [N].
    """
    bores = pins_in_bores(joint)
    if bores is None:
        return xp.full(len(joint.drive.pinned), np.nan)
    presses = (bores.contact.scale > 0.0) & (pin_force != 0.0)
    angles = bores.contact.angle(xp.where(presses, xp.abs(pin_force), 1.0))
    return xp.where(presses, angles, xp.nan)


def pin_forces(drive: Drive, normal: Array, tangential: Array) -> Array:
    """Forces of the rollers on their pins, along the push, that balance those of their contacts, shape (pins,) [N].

    Contact forces as of :class:`asperity.drive.state.state.DriveState`, shape (contacts,) [N].
    """
    matrices = incidence(drive)
    return -product(
        matrices.pins, product(matrices.approach.T, normal) + product(matrices.sliding.T, tangential)
    )


def pin_room(joint: Joint) -> tuple[Array, Array]:
    r"""How thick pins are for their rollers, and how firmly their friction holds them, shape (pins,) [-].

    .. math:: \frac{d}{2R}, \qquad \frac{\mu_b d_b}{2R \cos\gamma}

    Both must be below 1: the diameter of the pin over that of the roller's smallest track, infinite where its bore is
    smaller, or too wide for a contact of a pin that nearly fits; and the moment that the pin's friction takes at its
    diameter over the largest that the traction at both sides of the roller makes around the push at an angle gamma to
    the tangent. Moment balance of a roller between two contacts, equations (3) and (4) of Zou et al. 2025 without the
    wedge.
    """
    drive, bearings = joint.drive, joint.bearings
    if not drive.pinned:
        return xp.zeros(0), xp.zeros(0)
    radius = xp.stack(
        [xp.min(xp.stack([track for track, _ in tracks_of(joint, body)])) for body in drive.pinned]
    )
    thick, held = xp.zeros_like(radius), xp.zeros_like(radius)
    shapes = [joint.shapes[body] for body in drive.pinned]
    if all(shape.pin_diameter is not None for shape in shapes):
        pins, bores = (
            xp.stack([xp.asarray(getattr(shape, name)) for shape in shapes])
            for name in ("pin_diameter", "bore_diameter")
        )
        unfit = (pins > bores) | (joint.pin_clearance > MOST_CLEARANCE * pins)
        thick = xp.where(unfit & (pins > 0.0), xp.inf, pins / (2.0 * radius))
    if bearings is not None:
        slim = xp.asarray(bearings.pin_friction_diameter) / (2.0 * radius)
        held = slim * xp.asarray(bearings.pin_friction_coefficient) / xp.cos(xp.asarray(drive.push_angles))
    return thick, held


def overhang(joint: Joint) -> Array:
    """Length of each roller on a pin over the free length of its pin, shape (pins,) [-]; 0 where it is not known."""
    if joint.pin is None or not joint.drive.pinned:
        return xp.zeros(len(joint.drive.pinned))
    lengths: Array = xp.stack([xp.asarray(sum(track_lengths(joint, body))) for body in joint.drive.pinned])
    return lengths / joint.pin.free_length


def refuse_pins(joint: Joint) -> None:
    """Refuse pins as thick as their rollers, pins that do not fit their bores nearly, and pins that lock."""
    thick, held = map(np.asarray, pin_room(joint))
    for body, name, room, grip in zip(joint.drive.pinned, pin_names(joint.drive), thick, held, strict=True):
        if room >= 1.0:
            shape = joint.shapes[body]
            diameter, bore = (float(np.asarray(size)) for size in (shape.pin_diameter, shape.bore_diameter))
            if diameter > bore:
                raise InputError(
                    f"the pins of {format_quantity(diameter, 'mm')} do not fit into the bores of {name}: make "
                    "bearings.pin_diameter smaller, or the bores wider"
                )
            if np.isinf(room):
                clearance, most = float(np.asarray(joint.pin_clearance)), MOST_CLEARANCE * diameter
                raise InputError(
                    f"bearings.pin_radial_clearance {format_quantity(clearance, 'um')}: the contact of a pin is "
                    f"computed up to a clearance of {MOST_CLEARANCE:g} of its diameter, {format_quantity(most, 'um')}; "
                    "choose a smaller one"
                )
            raise InputError(
                f"the pin diameter {format_quantity(diameter, 'mm')} must be below the diameter of {name}, "
                f"{format_quantity(diameter / float(room), 'mm')}"
            )
        if grip >= 1.0:
            raise InputError(
                f"the pins lock: the friction of {name} on its pin is {grip:.3g} times what its traction can overcome; "
                "choose thinner pins or less pin_friction_coefficient"
            )
