"""Pairs of rollers in line contact: input of the contact formulas, and the rough contact."""

from __future__ import annotations

from typing import get_args

from asperity.contact import hertz_line
from asperity.contact.interface import RoughContact
from asperity.contact.laws.law import ContactLaw, PressedRollers
from asperity.contact.population import ContactFactorModel, contact_factor
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.materials import ContactPair
from asperity.types import Array, Real

#: Models of the contact factor, in the order of the numbers of :func:`numbered_contact_factors`.
CONTACT_FACTOR_MODELS: tuple[ContactFactorModel, ...] = get_args(ContactFactorModel)


class RollerPairs(Module):
    """One or many roller pairs without load; numbers and arrays that broadcast. SI units.

    Parameters
    ----------
    radius_1, radius_2 : Real
        Radii of the two cylinders [m].
    sign : Real
        +1 for an external contact, −1 where the first lies inside the second [-].
    effective_radius : Real
        :func:`asperity.contact.hertz_line.effective_radius` [m].
    contact_length : Real
        Contact line length B [m].
    friction_coefficient : Real
        Friction coefficient mu [-].
    moduli : ContactPair
        Moduli and limits of the two materials.
    surface : ContactLaw
        The law of the asperities, with the numbers of the equivalent surface.
    """

    radius_1: Real
    radius_2: Real
    sign: Real
    effective_radius: Real
    contact_length: Real
    friction_coefficient: Real
    moduli: ContactPair
    surface: ContactLaw

    def half_width(self, normal_force: Real) -> Real:
        """Half-width of the Hertzian strips [m], for one newton where the contact is open.

        Parameters
        ----------
        normal_force : Real
            Normal forces [N].

        Returns
        -------
        Real
            :func:`asperity.contact.hertz_line.half_width` [m].
        """
        return hertz_line.half_width(
            normal_force=_pressed(normal_force),
            contact_length=self.contact_length,
            effective_radius=self.effective_radius,
            contact_modulus=self.moduli.contact_modulus,
        )


def roller_pairs(
    *,
    radius_1: Real,
    radius_2: Real,
    sign: Real,
    contact_length: Real,
    friction_coefficient: Real,
    moduli: ContactPair,
    surface: ContactLaw,
) -> RollerPairs:
    """Roller pairs from radii, length, friction, materials and surface.

    Parameters
    ----------
    radius_1, radius_2 : Real
        Radii [m].
    sign : Real
        +1 for an external, −1 for an internal contact [-].
    contact_length : Real
        Contact line length B [m].
    friction_coefficient : Real
        mu [-].
    moduli : ContactPair
        Moduli and limits of the materials.
    surface : ContactLaw
        The law of the asperities, with the numbers of the equivalent surface.

    Returns
    -------
    RollerPairs
        With their effective radius, :func:`asperity.contact.hertz_line.effective_radius`.
    """
    return RollerPairs(
        radius_1=radius_1,
        radius_2=radius_2,
        sign=sign,
        effective_radius=hertz_line.effective_radius(radius_1=radius_1, radius_2=radius_2, sign=sign),
        contact_length=contact_length,
        friction_coefficient=friction_coefficient,
        moduli=moduli,
        surface=surface,
    )


def _pressed(normal_force: Real) -> Array:
    """The normal force, or one newton for an open contact, for which every formula is defined."""
    return xp.where(xp.asarray(normal_force) > 0.0, normal_force, 1.0)


def contact_factors(*, pairs: RollerPairs, model: ContactFactorModel, normal_force: Real) -> Real:
    """Contact factor lambda of roller pairs, all by one model.

    Parameters
    ----------
    pairs : RollerPairs
        The pairs.
    model : {"printed", "hertz_area", "unity"}
        Model, :func:`asperity.contact.population.contact_factor`.
    normal_force : Real
        Normal forces [N].

    Returns
    -------
    Real
        Contact factors [-].
    """
    return contact_factor(
        model=model,
        radius_1=pairs.radius_1,
        radius_2=pairs.radius_2,
        sign=pairs.sign,
        contact_length=pairs.contact_length,
        contact_modulus=pairs.moduli.contact_modulus,
        normal_force=_pressed(normal_force),
    )


def numbered_contact_factors(*, pairs: RollerPairs, model_number: Array, normal_force: Array) -> Array:
    """Contact factor lambda of roller pairs, each by its own model.

    Parameters
    ----------
    pairs : RollerPairs
        The pairs, shape (...).
    model_number : Array
        Places in :data:`CONTACT_FACTOR_MODELS`, shape (...) [-].
    normal_force : Array
        Normal forces, shape (...) [N].

    Returns
    -------
    Array
        :func:`contact_factors` [-]; nan for a number without a model.
    """
    factors = [
        contact_factors(pairs=pairs, model=model, normal_force=normal_force)
        for model in CONTACT_FACTOR_MODELS
    ]
    chosen = [model_number == number for number in range(len(factors))]
    return xp.select(chosen, xp.broadcast_arrays(*factors), xp.nan)


def rough_contacts(
    *, pairs: RollerPairs, contact_factor: Real, normal_force: Real, tangential_force: Real
) -> RoughContact:
    """Spots, load shares and stiffnesses of roller pairs under load.

    Parameters
    ----------
    pairs : RollerPairs
        The pairs.
    contact_factor : Real
        Contact factor lambda [-], :func:`contact_factors`.
    normal_force, tangential_force : Real
        F_n and T of either sense [N].

    Returns
    -------
    RoughContact
        As :meth:`asperity.contact.laws.law.ContactLaw.rough_contact` of the surface gives it.

    References
    ----------
    Zou et al. 2025, equations (10)–(12), (20), (22)–(24); (A10) of :doc:`/equations`.
    """
    return pairs.surface.rough_contact(
        PressedRollers(
            normal_force=normal_force,
            tangential_force=xp.abs(tangential_force),
            friction_coefficient=pairs.friction_coefficient,
            moduli=pairs.moduli,
            contact_length=pairs.contact_length,
            effective_radius=pairs.effective_radius,
            contact_factor=contact_factor,
        )
    )
