"""Pressure, life and traction of the contacts of a joint that rolls: of whole lines, or of slices where crowned."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
from jax import Array

from asperity.contact.crowned_line import CrownedLine
from asperity.contact.hertz_line import peak_pressure
from asperity.contact.roller_pairs import RollerPairs
from asperity.contact.shakedown import shakedown_limit, shear_yield_strength
from asperity.joint.contacts import JointContacts
from asperity.joint.crowned_contacts import slice_slip_ratios
from asperity.rolling.life import sliced_track_lives, track_lives
from asperity.types import Real


class RollingStrips(NamedTuple):
    """The strips of the contacts under their forces in rolling, shape (5, ...).

    Half-widths [m]: under even loads, the mean by load, and in the middle of the line. In the middle also
    ``largest_load``, normal forces as if the line load there acted on the whole line [N]; T/N [-]; and friction power
    per length over the mean [-], None where the loads are even. ``tracks``: lives at 90 % survival, shape (2, 5, ...)
    [stress cycles]. ``shakedown_ratio``: peak pressure over the shakedown limit, the largest of the line [-].
    ``lines``: loads along crowned contacts; None where they are even.
    """

    even_half_width: Array
    mean_half_width: Array
    largest_half_width: Array
    largest_load: Array
    middle_traction: Array
    middle_power_ratio: Array | None
    tracks: Array
    shakedown_ratio: Array
    lines: CrownedLine | None


def rolling_strips(*, contacts: JointContacts, normal_force: Array, traction: Array) -> RollingStrips:
    """What the contacts' strips experience in rolling."""
    pairs = contacts.pairs
    width = jnp.asarray(pairs.half_width(normal_force))
    lines = contacts.loads_along(normal_force)
    if lines is None:
        pressure = peak_pressure(
            normal_force=normal_force, contact_length=pairs.contact_length, half_width=width
        )
        return RollingStrips(
            even_half_width=width,
            mean_half_width=width,
            largest_half_width=width,
            largest_load=normal_force,
            middle_traction=traction,
            middle_power_ratio=None,
            tracks=track_lives(pairs=pairs, half_width=width, peak_pressure=pressure),
            shakedown_ratio=_shakedown_ratio(pairs, pressure, traction),
            lines=None,
        )
    friction = pairs.friction_coefficient
    ratios = slice_slip_ratios(pairs=pairs, lines=lines, slip_ratio=traction / friction)
    pressures = peak_pressure(normal_force=lines.line_load, contact_length=1.0, half_width=lines.half_width)
    loads = lines.line_load * pairs.contact_length
    slips = traction != 0.0
    share = ratios[0] * friction / jnp.where(slips, traction, 1.0)
    return RollingStrips(
        even_half_width=width,
        mean_half_width=jnp.sum(loads * lines.length_share * lines.half_width, axis=0) / normal_force,
        largest_half_width=lines.half_width[0],
        largest_load=loads[0],
        middle_traction=friction * ratios[0],
        middle_power_ratio=jnp.where(slips, share, 1.0) * loads[0] / normal_force,
        tracks=sliced_track_lives(pairs=pairs, lines=lines, peak_pressure=jnp.asarray(pressures)),
        shakedown_ratio=jnp.max(_shakedown_ratio(pairs, pressures, friction * ratios), axis=0),
        lines=lines,
    )


def _shakedown_ratio(pairs: RollerPairs, pressure: Real, traction: Array) -> Array:
    return jnp.asarray(
        pressure
        / (
            shear_yield_strength(yield_strength=pairs.moduli.yield_strength)
            * shakedown_limit(friction_coefficient=jnp.abs(traction))
        )
    )
