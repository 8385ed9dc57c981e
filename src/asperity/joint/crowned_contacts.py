"""Contacts of a joint with crowned rollers: the even contact in slices along its line."""

from __future__ import annotations

from typing import NamedTuple

from asperity.contact.carter import gross_slip_creepage, slip_ratio_at_creepage
from asperity.contact.crowned_line import CrownedLine, CrownedLines, crown_compliance, crowned_line
from asperity.contact.crowned_shear import crown_shear_compliance
from asperity.contact.interface import RoughContact
from asperity.contact.population import ContactFactorModel
from asperity.contact.roller_pairs import RollerPairs, contact_factors, rough_contacts
from asperity.contact.strip_theory import strip_creepage
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.materials import Material
from asperity.types import Array


class CrownCompliance(NamedTuple):
    """What crowns add to the incremental compliance of the bodies of contacts, shape (contacts, ...) [m/N].

    0 where open.
    """

    normal: Array
    tangential: Array


def crowned_lines(
    *, pairs: RollerPairs, crown_curvature: Array, logarithmic: Array | None = None
) -> CrownedLines:
    """What the approach of crowned contacts depends on, in one shape.

    ``logarithmic``: 1 where the crown is a logarithmic profile, 0 where it is a circle; None where all are circles.
    """
    length, radius, modulus = pairs.contact_length, pairs.effective_radius, pairs.moduli.contact_modulus
    shapes = () if logarithmic is None else (logarithmic,)
    return CrownedLines(*xp.broadcast_arrays(crown_curvature, length, radius, modulus, *shapes))


def loads_along(
    *, pairs: RollerPairs, crown_curvature: Array, normal_force: Array, logarithmic: Array | None = None
) -> CrownedLine:
    """How the loads of crowned contacts spread over their lines, each under one newton where it is open."""
    lines = crowned_lines(pairs=pairs, crown_curvature=crown_curvature, logarithmic=logarithmic)
    return crowned_line(normal_force=_pressed(normal_force), **vars(lines))


def _pressed(normal_force: Array) -> Array:
    return xp.where(normal_force > 0.0, normal_force, 1.0)


def lateral_strain_compliance(driving: Material, driven: Material) -> Array:
    r"""What the sideways strain of two bodies adds to their compliance in shear, :math:`\sum \nu_i (1+\nu_i)/E_i`.

    [1/Pa].
    """
    one, two = (
        xp.asarray(body.poisson_ratio * (1.0 + body.poisson_ratio) / body.youngs_modulus)
        for body in (driving, driven)
    )
    return one + two


def crown_compliances(
    *,
    pairs: RollerPairs,
    crown_curvature: Array,
    driving: Material,
    driven: Material,
    normal_force: Array,
    tangential_force: Array,
    logarithmic: Array | None = None,
) -> CrownCompliance:
    """Compliance that the crowns add to the bodies of the contacts."""
    lines = crowned_lines(pairs=pairs, crown_curvature=crown_curvature, logarithmic=logarithmic)
    touching = normal_force > 0.0
    stick = normal_force - xp.abs(tangential_force) / pairs.friction_coefficient
    strain = lateral_strain_compliance(driving, driven)
    normal = crown_compliance(normal_force=_pressed(normal_force), **vars(lines))
    tangential = crown_shear_compliance(
        stick_force=_pressed(stick), lateral_strain_compliance=strain, **vars(lines)
    )
    return CrownCompliance(
        xp.where(touching, normal, 0.0), xp.where(touching & (stick > 0.0), tangential, 0.0)
    )


def rough_slices(
    *,
    pairs: RollerPairs,
    model: ContactFactorModel,
    lines: CrownedLine,
    normal_force: Array,
    tangential_force: Array,
) -> RoughContact:
    """The fractal contact law at the line load of each slice, as if it acted on the whole line.

    Of forces of shape (contacts, ...) [N] to shape (slices, contacts, ...); all slices have the same traction. The
    length share of a slice is its share in the contact.
    """
    share = lines.line_load * pairs.contact_length / _pressed(normal_force)
    normal = share * xp.where(normal_force > 0.0, normal_force, 0.0)
    return rough_contacts(
        pairs=pairs,
        contact_factor=contact_factors(pairs=pairs, model=model, normal_force=normal),
        normal_force=normal,
        tangential_force=share * tangential_force,
    )


def contact_of_slices(*, slices: RoughContact, lines: CrownedLine) -> RoughContact:
    """Spots and stiffnesses of contacts from those of their slices."""
    added: RoughContact = trees.map(lambda value: xp.sum(lines.length_share * value, axis=0), slices)
    middle = trees.map(lambda value: value[0], slices)
    return RoughContact(
        largest_area=middle.largest_area,
        critical_area=middle.critical_area,
        real_contact_area=added.real_contact_area,
        elastic_load=added.elastic_load,
        plastic_load=added.plastic_load,
        tangential_stiffness=added.tangential_stiffness,
        normal_stiffness=added.normal_stiffness,
        layer_stiffness=added.layer_stiffness,
        domain_extension_factor=middle.domain_extension_factor,
        contact_factor=middle.contact_factor,
    )


def slice_friction(*, pairs: RollerPairs, lines: CrownedLine) -> tuple[Array, Array]:
    """Friction of each slice per contact length, and the creepage at which it slips altogether."""
    limit = gross_slip_creepage(
        friction_coefficient=pairs.friction_coefficient,
        half_width=lines.half_width,
        effective_radius=pairs.effective_radius,
    )
    capacity = pairs.friction_coefficient * lines.line_load * lines.length_share
    return xp.asarray(capacity), xp.asarray(limit)


def slice_slip_ratios(*, pairs: RollerPairs, lines: CrownedLine, slip_ratio: Array) -> Array:
    """Tangential force over friction of each slice, with one creepage for all; without asperities [-]."""
    capacity, limits = slice_friction(pairs=pairs, lines=lines)
    creepage = strip_creepage(slip_ratio=slip_ratio, capacity=capacity, gross_slip_creepage=limits)
    return xp.asarray(slip_ratio_at_creepage(creepage=creepage, gross_slip_creepage=limits))
