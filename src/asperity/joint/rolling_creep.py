"""The creep law of the contacts of a joint: Carter's, with the asperities as an elastic layer and with skew."""

from __future__ import annotations

from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import Array

from asperity.contact import carter
from asperity.contact.creep_layer import layer_ratio, uniform_layer_creepage_factor
from asperity.contact.skew import (
    lateral_compliance_ratio,
    longitudinal_capacity_ratio,
    skewed_contact,
    skewed_slip_ratios,
)
from asperity.contact.strip_theory import strip_creepage
from asperity.drive.rolling_state import CreepLaw
from asperity.joint.contacts import JointContacts
from asperity.joint.crowned_contacts import rough_slices, slice_friction
from asperity.joint.description import per_contact
from asperity.types import Real

# slip ratios between which the factors on Carter's creepage are taken
_LEAST_SLIP, _MOST_SLIP = 1e-6, 0.999


class ContactCreep(NamedTuple):
    """The creep law of the contacts with what went into it, shape (contacts, ...) [-].

    Parameters
    ----------
    law : CreepLaw
        For :func:`asperity.drive.rolling_state.rolling_state`.
    layer_ratio, layer_factor, skew_factor : Array
        Compliance of the asperities over that of the bodies; factors of the asperities and of skew on Carter's
        creepage.
    crown_factor : Array or None
        Factor of the crowns on Carter's creepage; None where no roller is crowned.
    lateral_ratio : Array
        Creepage across over creepage along, both at gross slip.
    skew : Array
        Creepage across.
    parallel : bool
        Whether no skew is given.
    """

    law: CreepLaw
    layer_ratio: Array
    layer_factor: Array
    skew_factor: Array
    lateral_ratio: Real
    skew: Array
    parallel: bool
    crown_factor: Array | None = None


def contact_creep(
    *,
    contacts: JointContacts,
    skew: tuple[Real, ...] | None,
    normal_force: Array,
    tangential_force: Array,
    asperity_normal_stiffness: Array,
) -> ContactCreep:
    r"""Carter's creep of the contacts with their asperities as an elastic layer, and with skew.

    .. math::
        \kappa = \frac{\mu a}{R\sqrt N}\, f_{layer}(\chi, q)\, f_{skew}(q, \gamma), \qquad
        \chi = \frac{E^* B}{K_t}

    Parameters
    ----------
    contacts : JointContacts
        The contacts of a joint.
    skew : tuple of Real or None
        Angles by which the axes are out of parallel, one or one for each contact [rad]; None for parallel axes.
    normal_force, tangential_force : Array
        Their forces at rest, shape (contacts, ...) [N].
    asperity_normal_stiffness : Array
        Normal stiffness of the asperities under them, shape (contacts, ...) [N/m].

    Returns
    -------
    ContactCreep
        The law.

    Notes
    -----
    Both factors are taken at the slip ratio q of the drive at rest and then kept. In rolling q differs by up to 6 %.
    For the paper's joint the layer's factor then differs by at most 0.0002 at q = 0.39 (relative), 0.005 at 0.6, 0.03
    at 0.85 and 0.07 at 0.95: near gross slip the creepage is that much less certain. K_t is the tangential
    stiffness of the asperities without traction, :math:`4G^*/E^*` times their normal stiffness. Across the rolling
    direction the same layer lies on bodies that are softer in the ratio of the creepages at gross slip. The slices of
    a crowned contact share one creepage; their widths give one more factor, and the layer's is then that on all.

    References
    ----------
    Equations (A6), (B1), (B3) and (B4) of :doc:`/equations`; :mod:`asperity.contact.creep_layer`.
    """
    pairs = contacts.pairs
    modulus = pairs.moduli.contact_modulus
    touching = normal_force > 0.0
    normal = jnp.where(touching, normal_force, 1.0)
    friction = pairs.friction_coefficient
    q = jnp.clip(jnp.abs(tangential_force) / (friction * normal), _LEAST_SLIP, _MOST_SLIP)
    stiff = asperity_normal_stiffness > 0.0
    tangential = (
        4.0
        * pairs.moduli.tangential_contact_modulus
        / modulus
        * jnp.where(stiff, asperity_normal_stiffness, 1.0)
    )
    chi = layer_ratio(
        contact_modulus=modulus, contact_length=pairs.contact_length, tangential_stiffness=tangential
    )
    chi = jnp.where(stiff, chi, jnp.nan)
    layer = jnp.asarray(uniform_layer_creepage_factor(layer_ratio=chi, slip_ratio=q))
    smooth = carter.gross_slip_creepage(
        friction_coefficient=friction,
        half_width=pairs.half_width(normal),
        effective_radius=pairs.effective_radius,
    )
    crown: Array | None = None
    if contacts.crown_curvature is not None:
        crown, layer = _sliced(contacts, normal, q, smooth)
        smooth = smooth * crown
    across, skew_factor = jnp.zeros_like(layer), jnp.ones_like(layer)
    ratio: Real = jnp.ones_like(layer)
    if skew is not None:
        across = jnp.broadcast_to(per_contact(skew), layer.shape)
        elastic = lateral_compliance_ratio(
            youngs_modulus_1=contacts.driving.youngs_modulus,
            youngs_modulus_2=contacts.driven.youngs_modulus,
            poisson_ratio_1=contacts.driving.poisson_ratio,
            poisson_ratio_2=contacts.driven.poisson_ratio,
        )
        ratio = elastic * uniform_layer_creepage_factor(layer_ratio=chi / elastic, slip_ratio=q) / layer
        skewed = skewed_contact(
            longitudinal_slip_ratio=q,
            lateral_creepage=across,
            gross_slip_creepage=smooth * layer,
            lateral_gross_slip_creepage=smooth * layer * ratio,
        )
        alone = carter.creepage(slip_ratio=q, gross_slip_creepage=smooth * layer)
        skew_factor = jnp.where(skewed.solved, skewed.longitudinal_creepage / alone, jnp.nan)
    scale = jnp.broadcast_to(smooth / jnp.sqrt(normal) * layer * skew_factor, normal_force.shape)
    return ContactCreep(
        # without the barrier XLA evaluates the layer's polynomial anew for every use of the law
        CreepLaw(friction, jax.lax.optimization_barrier(scale)),
        chi,
        layer,
        skew_factor,
        ratio,
        across,
        skew is None,
        crown,
    )


def _sliced(
    contacts: JointContacts, normal: Array, slip_ratio: Array, even_limit: Real
) -> tuple[Array, Array]:
    """Factors of the crowns and of the asperities on the creepage that all slices share."""
    pairs = contacts.pairs
    lines = contacts.loads_along(normal)
    assert lines is not None
    rough = rough_slices(
        pairs=pairs,
        model=contacts.contact_factor_model,
        lines=lines,
        normal_force=normal,
        tangential_force=jnp.zeros_like(normal),
    )
    stiff = rough.normal_stiffness > 0.0
    moduli = pairs.moduli
    chi = layer_ratio(
        contact_modulus=moduli.contact_modulus,
        contact_length=pairs.contact_length,
        tangential_stiffness=4.0
        * moduli.tangential_contact_modulus
        / moduli.contact_modulus
        * jnp.where(stiff, rough.normal_stiffness, 1.0),
    )
    # slices so lightly loaded that every spot is plastic have no stiffness to count
    factor = jnp.where(stiff, uniform_layer_creepage_factor(layer_ratio=chi, slip_ratio=slip_ratio), 1.0)
    capacity, limits = slice_friction(pairs=pairs, lines=lines)
    smooth, rough_creepage = (
        strip_creepage(slip_ratio=slip_ratio, capacity=capacity, gross_slip_creepage=limit)
        for limit in (limits, limits * factor)
    )
    even = carter.creepage(slip_ratio=slip_ratio, gross_slip_creepage=even_limit)
    return jnp.asarray(smooth / even), jnp.asarray(rough_creepage / smooth)


def lateral_slip_ratio(
    *, creep: ContactCreep, friction_coefficient: Real, width_over_radius: Real, creepage: Array
) -> Array:
    """Axial force of the contacts over their friction; 0 for parallel axes.

    Parameters
    ----------
    creep : ContactCreep
        The law of the contacts.
    friction_coefficient, width_over_radius : Real
        mu and half-width over effective radius [-].
    creepage : Array
        Creepages along the rolling direction, shape (contacts, ...) [-].

    Returns
    -------
    Array
        Ratios, shape (contacts, ...) [-].

    References
    ----------
    Equation (B6) of :doc:`/equations`.
    """
    if creep.parallel:
        return jnp.zeros_like(creepage)
    limits = _gross_slip_creepages(creep, friction_coefficient, width_over_radius)
    _, lateral = skewed_slip_ratios(longitudinal_creepage=creepage, lateral_creepage=creep.skew, **limits)
    return jnp.asarray(lateral)


def capacity_loss(*, creep: ContactCreep, friction_coefficient: Real, width_over_radius: Real) -> Array:
    """Share of the friction of the contacts that skew takes from the tangential force at gross slip.

    Parameters
    ----------
    creep : ContactCreep
        The law of the contacts.
    friction_coefficient, width_over_radius : Real
        mu and half-width over effective radius [-].

    Returns
    -------
    Array
        Shares, shape (contacts, ...) [-]; 0 for parallel axes, 1 where skew alone causes gross slip.

    References
    ----------
    Equation (B6) of :doc:`/equations`.
    """
    if creep.parallel:
        return jnp.zeros_like(creep.skew)
    limits = _gross_slip_creepages(creep, friction_coefficient, width_over_radius)
    return jnp.asarray(1.0 - longitudinal_capacity_ratio(lateral_creepage=creep.skew, **limits))


def _gross_slip_creepages(
    creep: ContactCreep, friction_coefficient: Real, width_over_radius: Real
) -> dict[str, Real]:
    limit = jnp.broadcast_to(friction_coefficient * width_over_radius * creep.layer_factor, creep.skew.shape)
    if creep.crown_factor is not None:
        limit = limit * creep.crown_factor
    return {"gross_slip_creepage": limit, "lateral_gross_slip_creepage": limit * creep.lateral_ratio}
