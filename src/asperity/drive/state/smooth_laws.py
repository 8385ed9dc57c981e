"""Contacts of a drive between smooth elastic bodies: Hertz, compression of the bodies, Carter's creep."""

from __future__ import annotations

from asperity.contact.hertz_line import (
    effective_radius,
    half_width,
    logarithmic_compliance,
    ring_secant_compliance,
    roller_secant_compliance,
)
from asperity.drive.layout.drive import Drive
from asperity.drive.normal_springs import NormalSprings
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.state import ContactLaws
from asperity.engine.arrays import xp
from asperity.types import Real


def smooth_contact_laws(
    *,
    drive: Drive,
    youngs_modulus: Real,
    poisson_ratio: Real,
    friction_coefficient: Real,
    contact_length: Real,
    ring_wall_thickness: Real,
    reference_force: Real,
) -> ContactLaws:
    """Springs and creep of contacts of bodies of one material, with solid rollers and rings in a rigid housing.

    E [Pa], nu [-], mu [-], length of all contacts and walls of all rings [m]; the reference force of the logarithmic
    compliances [N] may be any positive value, the law is the same.

    References ---------- K. L. Johnson, Contact Mechanics, 1985, sections 4.2, 5.6 and 8.3; C. Weber and K. Banaschek
    1953.
    """
    one, two = drive.first_radius, drive.second_radius
    internal = xp.array([contact.internal for contact in drive.contacts])
    radius = effective_radius(radius_1=one, radius_2=two, sign=xp.where(internal, -1.0, 1.0))
    contact_modulus = youngs_modulus / (2.0 * (1.0 - poisson_ratio**2))
    force = xp.broadcast_to(xp.asarray(reference_force, dtype=float), one.shape)
    width = half_width(
        normal_force=force,
        contact_length=contact_length,
        effective_radius=radius,
        contact_modulus=contact_modulus,
    )
    body = {
        "contact_length": contact_length,
        "youngs_modulus": youngs_modulus,
        "poisson_ratio": poisson_ratio,
    }
    secant = roller_secant_compliance(radius=one, half_width=width, **body) + xp.where(
        internal,
        ring_secant_compliance(wall_thickness=ring_wall_thickness, half_width=width, **body),
        roller_secant_compliance(radius=two, half_width=width, **body),
    )
    return ContactLaws(
        springs=NormalSprings(
            secant_compliance=secant, incremental_compliance=secant - 2.0 * logarithmic_compliance(**body)
        ),
        reference_force=force,
        creep=CreepLaw(
            friction_coefficient=xp.broadcast_to(friction_coefficient, one.shape),
            gross_slip_scale=friction_coefficient * width / (radius * xp.sqrt(force)),
        ),
    )
