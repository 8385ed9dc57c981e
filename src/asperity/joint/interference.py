"""Interference and preload of a joint, with the bodies of its assembly."""

from __future__ import annotations

import jax.numpy as jnp
from jax import Array

from asperity.body.shapes import PlaneState, kolosov_constant
from asperity.contact.hertz_line import logarithmic_compliance
from asperity.joint.contacts import JointContacts
from asperity.joint.fit import BodyModel
from asperity.materials import Material
from asperity.types import Real


def logarithmic_decrease(*, contacts: JointContacts, body_model: BodyModel, plane_state: PlaneState) -> Array:
    """Decrease of the contacts' secant compliance with the logarithm of their force.

    Shape (contacts, ...) [m/N].
    """

    def of_body(body: Material) -> Real:
        numbers = {"youngs_modulus": body.youngs_modulus, "poisson_ratio": body.poisson_ratio}
        strain = logarithmic_compliance(contact_length=contacts.pairs.contact_length, **numbers)
        if body_model == "springs" or plane_state == "plane_strain":
            return strain
        stress, plane = (
            kolosov_constant(poisson_ratio=body.poisson_ratio, plane_state=state) + 1.0
            for state in ("plane_stress", "plane_strain")
        )
        return strain * (stress / plane)

    return jnp.asarray(of_body(contacts.driving) + of_body(contacts.driven))
