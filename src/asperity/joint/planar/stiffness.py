"""Torsional stiffness of a joint with a planar drive on the three levels of the model."""

from __future__ import annotations

import jax.numpy as jnp
from jax import Array

from asperity.drive.assembly import Assembly
from asperity.drive.planar.layout import speed_ratio
from asperity.drive.planar.stiffness import planar_stiffness, with_shafts
from asperity.drive.torsional_stiffness import TorsionalStiffness
from asperity.joint.contacts import JointContacts, LoadedContacts
from asperity.joint.elastic_bodies import springs_of_compliance, widths_of_bodies
from asperity.joint.planar.bodies import body_compliance
from asperity.joint.planar.description import PlanarJoint
from asperity.types import Real


def stiffness_levels(
    joint: PlanarJoint, contacts: JointContacts, loaded: LoadedContacts
) -> tuple[TorsionalStiffness, TorsionalStiffness, Assembly]:
    """Torsional stiffness on three levels: asperities, asperities and bodies, the whole assembly.

    Parameters
    ----------
    joint : PlanarJoint
        The joint.
    contacts : JointContacts
        Its contacts.
    loaded : LoadedContacts
        Its contacts under their forces.

    Returns
    -------
    TorsionalStiffness, TorsionalStiffness, Assembly
        The first two with the centres of all rollers held.

    References
    ----------
    Equations (A8) and (M4) of :doc:`/equations`.
    """
    drive, ratio = joint.drive, jnp.asarray(speed_ratio(joint.drive))
    interfaces = loaded.interfaces

    def compliance(stiffness: Real) -> Array:
        acts = jnp.asarray(stiffness) > 0.0
        return jnp.where(acts, 1.0 / jnp.where(acts, stiffness, 1.0), jnp.nan)

    def at_both_ends(output: Array) -> TorsionalStiffness:
        return TorsionalStiffness(sun=output / ratio**2, output=output)

    held = [
        planar_stiffness(
            drive=drive, normal_compliance=None, tangential_compliance=compliance(tangential)
        ).output
        for tangential in (interfaces.asperity_tangential, interfaces.tangential)
    ]
    normal, tangential, coupling = interfaces.normal, interfaces.tangential, None
    if joint.body_model == "exact":
        width, stick = widths_of_bodies(contacts=contacts, loaded=loaded)
        springs = springs_of_compliance(
            compliance=body_compliance(
                joint=joint, contacts=contacts, half_width=width, stick_half_width=stick
            ),
            half_width=width,
            loaded=loaded,
        )
        normal, tangential = springs.normal_stiffness, springs.tangential_stiffness
        coupling = springs.coupling
    whole = planar_stiffness(
        drive=drive,
        normal_compliance=compliance(normal),
        tangential_compliance=compliance(tangential),
        coupling=coupling,
        pin_compliance=1.0 / jnp.asarray(joint.pin_stiffness, dtype=float),
    )
    output, input_share, output_share = with_shafts(
        stiffness=whole.output,
        ratio=ratio,
        input_shaft_stiffness=joint.input_shaft_stiffness,
        output_shaft_stiffness=joint.output_shaft_stiffness,
    )
    rest = output / whole.output
    nothing = jnp.zeros_like(rest)
    return (
        at_both_ends(held[0]),
        at_both_ends(held[1]),
        Assembly(
            stiffness=at_both_ends(output),
            tangential_share=whole.tangential_share * rest,
            normal_share=whole.normal_share * rest,
            ring_bending_share=nothing,
            pin_share=whole.pin_share * rest,
            planet_support_share=nothing,
            input_shaft_share=input_share,
            output_shaft_share=output_share,
        ),
    )
