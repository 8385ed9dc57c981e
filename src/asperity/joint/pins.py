"""Pins that leave their rollers no room, or hold them fast by friction."""

from __future__ import annotations

import numpy as np
from jax import Array

from asperity.arrays import namespace
from asperity.errors import InputError
from asperity.joint.description import Joint, pin_names, track_lengths, tracks_of
from asperity.units import format_quantity


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
        nothing: Array = xp.zeros(len(joint.drive.pinned))
        return nothing
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
