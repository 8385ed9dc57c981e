"""The creep law of the contacts of a joint: Carter's, with the asperities as a layer, with skew, and with oil."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

from asperity.contact import carter
from asperity.contact.creep_law import LayerFactor
from asperity.contact.creep_layer import LayerLaw, factor_on_creepage, layer_law, layer_ratio
from asperity.contact.roller_pairs import RollerPairs
from asperity.contact.skew import (
    axial_force,
    lateral_compliance_ratio,
    longitudinal_capacity_ratio,
    skewed_contact,
    skewed_slip_ratios,
)
from asperity.contact.strip_theory import strip_creepage
from asperity.drive.state.creep import CreepLaw, creepages
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import once, scan
from asperity.engine.module import Partial
from asperity.joint.contacts import JointContacts, rough_joint_contacts
from asperity.joint.crowned_contacts import rough_slices, slice_friction
from asperity.joint.fit import per_contact
from asperity.rolling.film import OiledCreep, OiledSurfaces, oiled_contacts, oiled_creep
from asperity.types import Array, Real

#: How well the largest traction of oiled contacts is to be known: exactly, where the forces come near it, or roughly.
CapacityOf = Literal["exact", "near", "rough"]

# slip ratios between which the factors on Carter's creepage are taken
_LEAST_SLIP, _MOST_SLIP = 1e-6, 0.999
#: Repetitions with the factors at the combined slip of the time before: 4e-4 of friction remain at nine tenths of it.
_COMBINED_PASSES = 3


class ContactCreep(NamedTuple):
    """The creep law of the contacts with what went into it, shape (contacts, ...) [-].

    Parameters
    ----------
    law : CreepLaw
        For :func:`asperity.drive.state.states.rolling_state`.
    layer_ratio, layer_factor, skew_factor : Array
        Yield of the asperities over that of the bodies, in the middle of crowned contacts; factors of the asperities
        and of skew on Carter's creepage.
    crown_factor : Array or None
        Factor of the crowns on Carter's creepage; None where no roller is crowned.
    layer : LayerFactor or None
        Factor of the asperities on Carter's creepage over the slip ratio, of slices where contacts are crowned.
    oiled : OiledCreep or None
        The law with oil, which holds where the contacts roll; None without one whose traction is known.
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
    layer: LayerFactor | None = None
    oiled: OiledCreep | None = None

    def creepage(self, normal_force: Array, tangential_force: Array) -> Array:
        """Creepages under the forces [N] for which the law was made [-]."""
        dry = creepages(law=self.law, normal=normal_force, tangential=tangential_force)
        if self.oiled is None:
            return dry
        return xp.where(self.oiled.turns, self.oiled.creepage(tangential_force), dry)


def contact_creep(
    *,
    contacts: JointContacts,
    skew: tuple[Real, ...] | None,
    normal_force: Array,
    tangential_force: Array,
    surfaces: OiledSurfaces | None = None,
    capacity: CapacityOf = "exact",
) -> ContactCreep:
    r"""Carter's creep of the contacts with their asperities as a layer between the bodies, and with skew.

    .. math::
        \kappa = \frac{\mu a}{R\sqrt N}\, f_{layer}(s, q)\, f_{skew}(q, \gamma), \qquad
        s = \frac{\pi E^* B}{4 N/u_0}

    ``skew``: angles by which the axes are out of parallel [rad], None for parallel ones; the law under these forces of
    the contacts [N]. Equations (A6), (A13), (B1), (B3) and (B4) of :doc:`/equations`;
    :mod:`asperity.contact.creep_layer`.

    Notes
    -----
    The asperities' tangential over their normal stiffness is :math:`4G^*/E^*`, and that of (A13) in each direction on a
    surface with grooves. Their yield per e-fold of pressure is
    :math:`u_0` of the contact law in use; the published law has no local form: its :math:`N/K_n` acts at every
    place. Across the rolling direction the same asperities lie on bodies that are softer in the ratio of the creepages
    at gross slip. The slices of a crowned contact share one creepage; their widths give one more factor, and the
    layer's is that on all. In a skewed contact the factors are those at the slip ratio of both forces together. With
    ``surfaces`` that meet oil the law is that of :mod:`asperity.rolling.film` where the contacts roll; ``capacity``:
    how well their largest traction is to be known.
    """
    stiffness = rough_joint_contacts(
        contacts=contacts, normal_force=normal_force, tangential_force=xp.zeros_like(tangential_force)
    ).layer_stiffness
    friction = xp.asarray(contacts.pairs.friction_coefficient)
    limit = friction * xp.where(normal_force > 0.0, normal_force, 1.0)
    q = xp.clip(xp.abs(tangential_force) / limit, _LEAST_SLIP, _MOST_SLIP)
    creep = _creep_at(contacts, skew, normal_force, q, stiffness)
    # without the barrier XLA evaluates the layer's polynomial anew for every use of the law
    scale = once(creep.law.gross_slip_scale)
    creep = creep._replace(law=CreepLaw(xp.broadcast_to(friction, scale.shape), scale))
    if surfaces is None or creep.layer is None:
        return creep
    lateral = None if creep.parallel else (creep.skew / creep.lateral_ratio, creep.lateral_ratio)
    oiled = oiled_contacts(surfaces=surfaces, contacts=contacts, normal_force=normal_force, lateral=lateral)
    law = oiled_creep(
        oiled=oiled,
        layer=creep.layer,
        surfaces=surfaces,
        sought=None if capacity == "exact" else tangential_force,
        roughly=capacity == "rough",
    )
    return creep._replace(oiled=law)


def _layer_factor(law: LayerLaw, known: Array | bool, slip_ratio: Array) -> Array:
    """Factor of the asperities on Carter's creepage; none where every spot is plastic, as they have no stiffness."""
    used = xp.clip(slip_ratio, _LEAST_SLIP, _MOST_SLIP)
    return xp.where(known, factor_on_creepage(law=law, slip_ratio=used), 1.0)


def _creep_at(
    contacts: JointContacts,
    skew: tuple[Real, ...] | None,
    normal_force: Array,
    q: Array,
    layer_stiffness: Array,
) -> ContactCreep:
    """The law at slip ratios."""
    pairs = contacts.pairs
    normal = xp.where(normal_force > 0.0, normal_force, 1.0)
    friction = pairs.friction_coefficient
    kappa = pairs.surface.stiffness_ratio(pairs.moduli)
    smooth = carter.gross_slip_creepage(
        friction_coefficient=friction,
        half_width=pairs.half_width(normal),
        effective_radius=pairs.effective_radius,
    )
    elastic: Real = 1.0
    if skew is not None:
        elastic = lateral_compliance_ratio(
            youngs_modulus_1=contacts.driving.youngs_modulus,
            youngs_modulus_2=contacts.driven.youngs_modulus,
            poisson_ratio_1=contacts.driving.poisson_ratio,
            poisson_ratio_2=contacts.driven.poisson_ratio,
        )

    sliced = None if contacts.crown_curvature is None else _slices(contacts, normal, kappa)
    ratio = _layer_ratio(contacts, layer_stiffness)
    along = layer_law(layer_ratio=ratio, stiffness_ratio=kappa)
    sideways = along
    if skew is not None:
        across_rolling = pairs.surface.stiffness_ratio(pairs.moduli, along_axis=True)
        sideways = layer_law(layer_ratio=ratio, stiffness_ratio=across_rolling * elastic)

    def factors(slip_ratio: Array) -> tuple[Array, Array, Real, Array | None]:
        """Layer ratio, layer factor, creepage across over along at gross slip, crown factor."""
        layer = factor_on_creepage(law=along, slip_ratio=slip_ratio)
        softer = layer if skew is None else factor_on_creepage(law=sideways, slip_ratio=slip_ratio)
        lateral_ratio = elastic * softer / layer
        if sliced is None:
            return ratio, layer, lateral_ratio, None
        even = carter.creepage(slip_ratio=slip_ratio, gross_slip_creepage=smooth)
        crown, layer = _sliced(sliced, slip_ratio, even)
        return sliced.ratio[0], layer, lateral_ratio, crown

    if skew is None:
        ratio, layer, lateral_ratio, crown = factors(q)
        across, skew_factor = xp.zeros_like(layer), xp.ones_like(layer)
    else:
        q = xp.broadcast_to(q, normal_force.shape)
        across = xp.broadcast_to(per_contact(skew), q.shape)

        def combined(slip_ratio: Array, _: None) -> tuple[Array, tuple[Any, ...]]:
            """How far a contact slips by both forces together, and what this follows from."""
            ratio, layer, lateral_ratio, crown = factors(slip_ratio)
            limit = smooth * layer if crown is None else smooth * crown * layer
            skewed = skewed_contact(
                longitudinal_slip_ratio=q,
                lateral_creepage=across,
                gross_slip_creepage=limit,
                lateral_gross_slip_creepage=limit * lateral_ratio,
            )
            both = xp.clip(xp.where(skewed.solved, skewed.slip_ratio, q), _LEAST_SLIP, _MOST_SLIP)
            return both, (ratio, layer, lateral_ratio, crown, limit, skewed)

        _, passes = scan(combined, q, length=1 + _COMBINED_PASSES)
        ratio, layer, lateral_ratio, crown, limit, skewed = trees.map(lambda leaf: leaf[-1], passes)
        alone = carter.creepage(slip_ratio=q, gross_slip_creepage=limit)
        skew_factor = xp.where(skewed.solved, skewed.longitudinal_creepage / alone, xp.nan)
    smooth = smooth if crown is None else smooth * crown
    scale = xp.broadcast_to(smooth / xp.sqrt(normal) * layer * skew_factor, normal_force.shape)
    return ContactCreep(
        CreepLaw(friction, scale),
        ratio,
        layer,
        skew_factor,
        lateral_ratio,
        across,
        skew is None,
        crown,
        Partial(_layer_factor, (along, True) if sliced is None else (sliced.law, sliced.known)),
    )


def _layer_ratio(contacts: JointContacts, layer_stiffness: Array) -> Array:
    """Yield of the asperities over that of the bodies; nan where no asperity is elastic."""
    stiff = layer_stiffness > 0.0
    ratio = layer_ratio(
        contact_modulus=contacts.pairs.moduli.contact_modulus,
        contact_length=contacts.pairs.contact_length,
        normal_stiffness=xp.where(stiff, layer_stiffness, 1.0),
    )
    return xp.where(stiff, ratio, xp.nan)


class _Slices(NamedTuple):
    """Of crowned contacts: layer ratio and whether it is known; share of the friction and creepage at gross slip."""

    ratio: Array
    known: Array
    law: LayerLaw
    capacity: Array
    limits: Array


def _slices(contacts: JointContacts, normal: Array, stiffness_ratio: Real) -> _Slices:
    """What the slices of the contacts are under normal forces."""
    pairs, lines = contacts.pairs, contacts.loads_along(normal)
    assert lines is not None
    rough = rough_slices(
        pairs=pairs,
        model=contacts.contact_factor_model,
        lines=lines,
        normal_force=normal,
        tangential_force=xp.zeros_like(normal),
    )
    ratio = _layer_ratio(contacts, rough.layer_stiffness)
    known = xp.isfinite(ratio)
    law = layer_law(layer_ratio=xp.where(known, ratio, 0.0), stiffness_ratio=stiffness_ratio)
    return _Slices(ratio, known, law, *slice_friction(pairs=pairs, lines=lines))


def _sliced(slices: _Slices, slip_ratio: Array, even: Real) -> tuple[Array, Array]:
    """Factors of the crowns and of the asperities on the creepage that all slices share."""
    factor = factor_on_creepage(law=slices.law, slip_ratio=slip_ratio)
    # slices so lightly loaded that every spot is plastic have no stiffness to count
    factor = xp.where(slices.known, factor, 1.0)
    smooth, rough = (
        strip_creepage(slip_ratio=slip_ratio, capacity=slices.capacity, gross_slip_creepage=limit)
        for limit in (slices.limits, slices.limits * factor)
    )
    return xp.asarray(smooth / even), xp.asarray(rough / smooth)


class ContactFriction(NamedTuple):
    """What skew does to the friction of contacts, shape (contacts, ...).

    Lateral slip over its limit [-], share of the friction that skew takes [-], axial force [N], and the largest
    tangential over the normal force with parallel axes [-].
    """

    lateral: Array
    lost: Array
    axial: Array
    most: Array


def contact_friction(
    *, pairs: RollerPairs, creep: ContactCreep, normal_force: Array, creepage: Array
) -> ContactFriction:
    """What skew does to the friction of contacts under their normal forces [N] and creepages [-]; (B3) and (B6)."""
    friction, width = pairs.friction_coefficient, pairs.half_width(normal_force) / pairs.effective_radius
    lateral = lateral_slip_ratio(
        creep=creep, friction_coefficient=friction, width_over_radius=width, creepage=creepage
    )
    lost = capacity_loss(creep=creep, friction_coefficient=friction, width_over_radius=width)
    axial = axial_force(friction_coefficient=friction, normal_force=normal_force, lateral_slip_ratio=lateral)
    dry = ContactFriction(lateral, lost, xp.asarray(axial), friction + 0.0 * lost)
    if creep.oiled is None:
        return dry
    capacity, most, pushes = creep.oiled.capacity.traction, creep.oiled.capacity.traction, dry.axial
    if not creep.parallel:
        most, pushes = creep.oiled.without_skew().traction, creep.oiled.axial_force(creepage)
    oiled = ContactFriction(pushes / most, 1.0 - capacity / most, pushes, most / normal_force)
    turns = creep.oiled.turns
    found: ContactFriction = trees.map(
        lambda with_oil, without: xp.where(turns, with_oil, without), oiled, dry
    )
    return found


def axial_drag(*, pairs: RollerPairs, creep: ContactCreep, normal_force: Array, creepage: Array) -> Array:
    """Half of the work of the axial forces of skewed contacts over the way rolled, on each surface [N]; (B3)."""
    friction, width = pairs.friction_coefficient, pairs.half_width(normal_force) / pairs.effective_radius
    lateral = lateral_slip_ratio(
        creep=creep, friction_coefficient=friction, width_over_radius=width, creepage=creepage
    )
    axial = axial_force(friction_coefficient=friction, normal_force=normal_force, lateral_slip_ratio=lateral)
    if creep.oiled is not None and not creep.parallel:
        axial = xp.where(creep.oiled.turns, creep.oiled.axial_force(creepage), axial)
    return xp.asarray(0.5 * axial * creep.skew)


def traction_limit(*, pairs: RollerPairs, creep: ContactCreep, normal_force: Array) -> Array:
    """Largest tangential forces of contacts that roll over their normal forces [N], shape (contacts, ...) [-].

    What friction and skew leave, or film and asperities with oil.
    """
    width = pairs.half_width(normal_force) / pairs.effective_radius
    lost = capacity_loss(
        creep=creep, friction_coefficient=pairs.friction_coefficient, width_over_radius=width
    )
    dry = xp.asarray(pairs.friction_coefficient * (1.0 - lost))
    if creep.oiled is None:
        return dry
    return xp.where(creep.oiled.turns, creep.oiled.capacity.traction / normal_force, dry)


def lateral_slip_ratio(
    *, creep: ContactCreep, friction_coefficient: Real, width_over_radius: Real, creepage: Array
) -> Array:
    """Axial force of the contacts over their friction; 0 for parallel axes, shape (contacts, ...) [-]."""
    if creep.parallel:
        return xp.zeros_like(creepage)
    limits = _gross_slip_creepages(creep, friction_coefficient, width_over_radius)
    _, lateral = skewed_slip_ratios(longitudinal_creepage=creepage, lateral_creepage=creep.skew, **limits)
    return xp.asarray(lateral)


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
        return xp.zeros_like(creep.skew)
    limits = _gross_slip_creepages(creep, friction_coefficient, width_over_radius)
    return xp.asarray(1.0 - longitudinal_capacity_ratio(lateral_creepage=creep.skew, **limits))


def _gross_slip_creepages(
    creep: ContactCreep, friction_coefficient: Real, width_over_radius: Real
) -> dict[str, Real]:
    limit = xp.broadcast_to(friction_coefficient * width_over_radius * creep.layer_factor, creep.skew.shape)
    if creep.crown_factor is not None:
        limit = limit * creep.crown_factor
    return {"gross_slip_creepage": limit, "lateral_gross_slip_creepage": limit * creep.lateral_ratio}
