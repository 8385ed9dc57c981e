"""Rolling contacts with oil of the validation, and the same without any."""

import numpy as np

from asperity.contact.film_traction import MixedContact
from asperity.engine.module import Partial
from asperity.validation.oiled_rollers import (
    EFFUSIVITY,
    HALF_WIDTH,
    LENGTH,
    LOAD,
    MODULUS,
    OILS,
    PEAK,
    RADIUS,
    OiledContact,
    oiled_contact,
)

__all__ = [
    "EFFUSIVITY",
    "HALF_WIDTH",
    "LENGTH",
    "LOAD",
    "MODULUS",
    "OILS",
    "PEAK",
    "RADIUS",
    "OiledContact",
    "dry_contact",
    "oiled_contact",
    "same_layer",
]


def dry_contact(*, friction=0.12, rms_height=0.1e-6) -> OiledContact:
    """The same rollers without oil: the asperities carry all."""
    oiled = oiled_contact("M100", 60.0, 1.0, rms_height, friction=friction)
    values = vars(oiled.contact) | {"asperity_share": np.ones(1), "film_share": np.zeros(1)}
    return oiled._replace(contact=MixedContact(**values))


def same_layer(factor):
    """A layer whose factor of creepage is the same at any traction."""
    return Partial(_always, (factor,))


def _always(factor, used):
    return factor + 0.0 * used
