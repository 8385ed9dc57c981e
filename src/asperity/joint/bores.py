"""Pins of the carrier: how they press in the bores of their rollers, and what room and hold they leave them."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.body.bore import BoreCompliance, bore_compliance
from asperity.body.shapes import Annulus
from asperity.drive.layout.drive import Drive, contact_angles, incidence
from asperity.drive.state.bores import Bores
from asperity.errors import InputError
from asperity.joint.description import Joint, pin_names, places, track_lengths, tracks_of
from asperity.linear import product
from asperity.types import namespace
from asperity.units import format_quantity


def push_angles(drive: Drive) -> Array:
    """Polar angles in which rollers push their pins, counter-clockwise from the x axis, shape (pins,) [rad]."""
    rows = incidence(drive).pins
    at = np.array([2 * drive.floating.index(body) for body in drive.pinned], dtype=int)
    pins = np.arange(at.size)
    return jnp.arctan2(rows[pins, at + 1], rows[pins, at])


def pins_in_bores(joint: Joint) -> Bores | None:
    """What the pins of a joint and the contacts of their rollers do to each other; (E5) of :doc:`/equations`.

    None where no pin is known to press in a bore. Rollers that are springs have the compliance of their bores alone,
    each track by itself beside the others.
    """
    drive, count = joint.drive, len(joint.drive.contacts)
    if all(joint.shapes[body].pin_diameter is None for body in drive.pinned):
        return None
    first, _ = places(drive)
    at_first, at_second = contact_angles(drive)
    push_compliance, normals = [], [[], []]  # type: tuple[list[Array], list[list[Array]]]
    tangentials: list[list[Array]] = [[], []]
    for body, angle in zip(drive.pinned, push_angles(drive), strict=True):
        diameter, tracks = joint.shapes[body].pin_diameter, tracks_of(joint, body)
        parts, none = [], jnp.zeros(count)
        if diameter is not None:
            for (_, contacts), annulus in zip(tracks, _annuli(joint, body), strict=True):
                at = jnp.stack([at_first[k] if first[k] == body else at_second[k] for k in contacts])
                bore = bore_compliance(body=annulus, contact_angles=at, push_angle=angle)
                pressed = jnp.asarray(diameter) > 0.0
                parts.append(
                    BoreCompliance(*(jnp.where(pressed, displacement, 0.0) for displacement in bore))
                )
        exact = joint.body_model == "exact" and len(parts) == 1
        push_compliance.append(
            _parallel_compliance([part.push_compliance for part in parts]) if parts else jnp.zeros(())
        )
        for k, name in enumerate(("along", "around")):
            at_contacts = np.array(tracks[0][1])
            displacements = (
                jnp.split(getattr(parts[0], name), 2) if exact else (jnp.zeros(at_contacts.size),) * 2
            )
            normals[k].append(none.at[at_contacts].set(displacements[0]))
            tangentials[k].append(none.at[at_contacts].set(displacements[1]))
    along, around = (
        (jnp.stack(normal, axis=1), jnp.stack(tangential, axis=1))
        for normal, tangential in zip(normals, tangentials, strict=True)
    )
    return Bores(along[0], along[1], around[0], around[1], jnp.stack(push_compliance))


def _annuli(joint: Joint, body: int) -> list[Annulus]:
    """A roller on a pin, track by track."""
    shape, material = joint.shapes[body], joint.materials[body]
    assert shape.size is not None
    elastic = (material.youngs_modulus, material.poisson_ratio)
    return [
        Annulus(0.5 * shape.size, radius, length, *elastic, 0.0, 0.0, "outer", joint.plane_state)
        for (radius, _), length in zip(tracks_of(joint, body), track_lengths(joint, body), strict=True)
    ]


def _parallel_compliance(compliances: list[Array]) -> Array:
    """Springs that move alike; none gives way where one is rigid."""
    compliance = compliances[0]
    for other in compliances[1:]:
        both = compliance + other
        compliance = jnp.where(both > 0.0, compliance * other / jnp.where(both > 0.0, both, 1.0), 0.0)
    return compliance


def pin_compliances(joint: Joint) -> Array:
    """Compliance of each pin along its push, with that of its bore, shape () or (pins,) [m/N]."""
    pins, bores = 1.0 / jnp.asarray(joint.pin_stiffness, dtype=float), pins_in_bores(joint)
    return pins if bores is None else pins + bores.push_compliance


def bore_stiffness(joint: Joint) -> Array:
    """Stiffness of each roller's bore under its pin, shape (pins,) [N/m]; infinite where no pin presses there."""
    bores = pins_in_bores(joint)
    if bores is None:
        return namespace(joint).full(len(joint.drive.pinned), np.inf)
    gives = bores.push_compliance > 0.0
    return jnp.where(gives, 1.0 / jnp.where(gives, bores.push_compliance, 1.0), jnp.inf)


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

    .. math:: \frac{d}{2R}, \qquad \frac{\mu_b d}{2R \cos\gamma}

    Both must be below 1: the diameter of the pin over that of the roller's smallest track, infinite where its bore is
    smaller; and the moment that the pin's friction takes over the largest that the traction at both sides of the roller
    makes around the push at an angle gamma to the tangent. Moment balance of a roller between two contacts, equations
    (3) and (4) of Zou et al. 2025 without the wedge.
    """
    xp, drive, bearings = namespace(joint), joint.drive, joint.bearings
    if bearings is None or not drive.pinned:
        return xp.zeros(len(drive.pinned)), xp.zeros(len(drive.pinned))
    radius = xp.stack(
        [xp.min(xp.stack([track for track, _ in tracks_of(joint, body)])) for body in drive.pinned]
    )
    thick = xp.asarray(bearings.pin_diameter) / (2.0 * radius)
    bores = [joint.shapes[body].bore_diameter for body in drive.pinned]
    narrow = xp.stack([xp.asarray(False if bore is None else bearings.pin_diameter > bore) for bore in bores])
    thick, slim = xp.where(narrow, xp.inf, thick), thick
    held = slim * xp.asarray(bearings.pin_friction_coefficient) / xp.cos(xp.asarray(drive.push_angles))
    return thick, held


def overhang(joint: Joint) -> Array:
    """Length of each roller on a pin over the free length of its pin, shape (pins,) [-]; 0 where it is not known."""
    xp = namespace(joint)
    if joint.pin is None or not joint.drive.pinned:
        return xp.zeros(len(joint.drive.pinned))
    lengths: Array = xp.stack([xp.asarray(sum(track_lengths(joint, body))) for body in joint.drive.pinned])
    return lengths / joint.pin.free_length


def refuse_pins(joint: Joint) -> None:
    """Refuse pins as thick as their rollers, and pins that lock."""
    thick, held = map(np.asarray, pin_room(joint))
    for name, room, grip in zip(pin_names(joint.drive), thick, held, strict=True):
        assert joint.bearings is not None or not (room or grip)
        if room >= 1.0:
            diameter = float(np.asarray(joint.bearings.pin_diameter))  # type: ignore[union-attr]
            if np.isinf(room):
                raise InputError(
                    f"the pins of {format_quantity(diameter, 'mm')} do not fit into the bores of {name}: make "
                    "bearings.pin_diameter smaller, or the bores wider"
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
