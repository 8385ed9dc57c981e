"""Pins in the bores of hollow steel rollers, which do to the contacts whatever random numbers say."""

import jax.numpy as jnp
import numpy as np

from asperity.body.bore import bore_modes
from asperity.body.conforming_pin import SHARED
from asperity.body.pin_contact import PinContact, pin_contact
from asperity.body.shapes import Annulus
from asperity.drive.state.bores import Bores, by_amplitude

ROLLER = Annulus(13e-3, 20e-3, 10e-3, 206e9, 0.3, 0.0, 0.0, "outer", "plane_strain")


def pins(count: int, clearance: float) -> PinContact:
    """As many pins of 26 mm in rollers of 40 mm, with a radial clearance [m]."""
    modes = bore_modes(body=ROLLER, contact_angles=jnp.zeros(1), push_angle=0.0)
    shift, scale, wall = (
        jnp.broadcast_to(jnp.asarray(part), (count, 1, *jnp.shape(part)))
        for part in (modes.shift, modes.scale, modes.wall)
    )
    return pin_contact(
        shift=shift,
        scale=scale,
        wall=wall,
        pressed=jnp.ones((count, 1), dtype=bool),
        clearance=jnp.full(count, clearance),
    )


def random_bores(
    random: np.random.Generator, *, contacts: int, count: int, clearance: float, size: float
) -> Bores:
    """What pins and contacts do to each other, of a size [m/N]; higher modes less, as walls let them through less."""
    along = [jnp.asarray(size * random.uniform(-1.0, 1.0, (contacts, count))) for _ in range(2)]
    fading = size * 0.65**SHARED
    rim = [
        by_amplitude(jnp.asarray(fading * random.uniform(-1.0, 1.0, (contacts, count, SHARED.size))))
        for _ in range(2)
    ]
    return Bores(*along, *rim, pins(count, clearance))
