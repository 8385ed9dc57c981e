"""The five contacts of a joint: which materials, radii and surfaces meet where, handed to the contact formulas."""

from __future__ import annotations

import jax.numpy as jnp

from asperity.contact.fractal import FractalContact, fractal_contact
from asperity.contact.hertz_line import (
    effective_radius,
    half_width,
    logarithmic_compliance,
    ring_secant_compliance,
    roller_secant_compliance,
)
from asperity.contact.interface import Interface, bulk_tangential_stiffness
from asperity.contact.population import contact_factor
from asperity.drive.force_balance import DriveForces
from asperity.drive.geometry import contact_radii
from asperity.drive.mechanism import NormalSprings
from asperity.joint.description import Joint, contact_bodies, contact_pairs, per_contact
from asperity.types import Real


def bulk_springs(*, joint: Joint, normal_force: Real) -> NormalSprings:
    """Secant and incremental normal compliance of the bodies of the five contacts under load.

    Parameters
    ----------
    joint : Joint
        The joint.
    normal_force : Real
        Normal forces > 0, shape (5, ...) [N].

    Returns
    -------
    NormalSprings
        Compliances, shape (5, ...) [m/N]: two solid rollers in series, or a roller and the ring's wall.
    """
    driving, driven, sign = contact_radii(joint.geometry)
    length = per_contact(joint.contact_lengths)
    width = half_width(
        normal_force=normal_force,
        contact_length=length,
        effective_radius=effective_radius(radius_1=driving, radius_2=driven, sign=sign),
        contact_modulus=contact_pairs(joint.bodies).contact_modulus,
    )
    body_1, body_2 = (
        {"contact_length": length, "youngs_modulus": body.youngs_modulus, "poisson_ratio": body.poisson_ratio}
        for body in contact_bodies(joint.bodies)
    )
    as_roller = roller_secant_compliance(radius=driven, half_width=width, **body_2)
    as_ring = ring_secant_compliance(wall_thickness=joint.ring_wall_thickness, half_width=width, **body_2)
    secant = roller_secant_compliance(radius=driving, half_width=width, **body_1) + jnp.where(
        sign > 0.0, as_roller, as_ring
    )
    bend = logarithmic_compliance(**body_1) + logarithmic_compliance(**body_2)
    return NormalSprings(secant_compliance=secant, incremental_compliance=secant - bend)


def closure_springs(*, joint: Joint, rest_force: Real) -> NormalSprings:
    """Normal springs of the elastic closure around the state at rest, as the joint asks for them.

    Parameters
    ----------
    joint : Joint
        The joint; its ``closure_springs`` decides whether the asperities' normal compliance is added.
    rest_force : Real
        Normal forces at rest, shape (5, ...) [N].

    Returns
    -------
    NormalSprings
        Compliances, shape (5, ...) [m/N]; infinite, and the balance without solution, where the asperities are asked
        for and every spot is plastic at rest.
    """
    bulk = bulk_springs(joint=joint, normal_force=rest_force)
    if joint.closure_springs == "bulk":
        return bulk
    asperities = (
        1.0
        / rough_contacts(
            joint=joint, normal_force=rest_force, tangential_force=jnp.zeros_like(rest_force)
        ).normal_stiffness
    )
    return NormalSprings(
        secant_compliance=bulk.secant_compliance + asperities,
        incremental_compliance=bulk.incremental_compliance + asperities,
    )


def rough_contacts(*, joint: Joint, normal_force: Real, tangential_force: Real) -> FractalContact:
    """The fractal contact law at the five contacts under given forces.

    Parameters
    ----------
    joint : Joint
        The joint.
    normal_force, tangential_force : Real
        Forces, shape (5, ...) [N].

    Returns
    -------
    FractalContact
        Spots and stiffnesses, shape (5, ...).
    """
    pairs = contact_pairs(joint.bodies)
    driving, driven, sign = contact_radii(joint.geometry)
    return fractal_contact(
        surface=per_contact(joint.surfaces),
        normal_force=normal_force,
        tangential_force=jnp.abs(tangential_force),
        friction_coefficient=per_contact(joint.friction_coefficients),
        contact_factor=contact_factor(
            model=joint.contact_factor_model,
            radius_1=driving,
            radius_2=driven,
            sign=sign,
            contact_length=per_contact(joint.contact_lengths),
            contact_modulus=pairs.contact_modulus,
            normal_force=jnp.where(normal_force > 0.0, normal_force, 1.0),
        ),
        contact_modulus=pairs.contact_modulus,
        tangential_contact_modulus=pairs.tangential_contact_modulus,
        hardness=pairs.hardness,
    )


def rough_interfaces(*, joint: Joint, forces: DriveForces, contacts: FractalContact) -> Interface:
    """Asperities and bulk of the five contacts side by side, at the operating point.

    Parameters
    ----------
    joint : Joint
        The joint.
    forces : DriveForces
        Its forces.
    contacts : FractalContact
        Its rough contacts.

    Returns
    -------
    Interface
        Stiffnesses, shape (5, ...) [N/m]; all 0 at a lifted contact.
    """
    touching = forces.normal > 0.0
    springs = bulk_springs(joint=joint, normal_force=jnp.where(touching, forces.normal, 1.0))
    bulk_normal = jnp.where(touching, 1.0 / springs.incremental_compliance, 0.0)
    pairs = contact_pairs(joint.bodies)
    return Interface(
        asperity_normal=contacts.normal_stiffness,
        asperity_tangential=contacts.tangential_stiffness,
        bulk_normal=bulk_normal,
        bulk_tangential=bulk_tangential_stiffness(
            bulk_normal_stiffness=bulk_normal,
            contact_modulus=pairs.contact_modulus,
            tangential_contact_modulus=pairs.tangential_contact_modulus,
            normal_force=forces.normal,
            tangential_force=jnp.abs(forces.tangential),
            friction_coefficient=per_contact(joint.friction_coefficients),
        ),
    )
