"""Rough contacts of many independent roller pairs at once, each with its own model of the contact factor."""

from __future__ import annotations

from typing import get_args

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.contact.fractal import FractalContact, Surface, fractal_contact
from asperity.contact.population import ContactFactorModel, contact_factor
from asperity.materials import contact_modulus, tangential_contact_modulus

#: Models of the contact factor; :attr:`RollerPairs.contact_factor_model` is an index into them.
CONTACT_FACTOR_MODELS: tuple[ContactFactorModel, ...] = get_args(ContactFactorModel)


class RollerPairs(eqx.Module):
    """Roller pairs under load, arrays of one shape. SI units.

    Parameters
    ----------
    surface : Surface
        Fractal roughness.
    normal_force, tangential_force : Array
        F_n > 0 and T >= 0 [N].
    friction_coefficient : Array
        mu [-].
    radius_1, radius_2 : Array
        Radii [m].
    sign : Array
        +1 for an outer, −1 for an inner contact [-].
    contact_length : Array
        B [m].
    youngs_modulus_1, youngs_modulus_2 : Array
        Young's moduli [Pa].
    poisson_ratio_1, poisson_ratio_2 : Array
        Poisson's ratios [-].
    hardness : Array
        Hardness of the softer body [Pa].
    contact_factor_model : Array
        Index in :data:`CONTACT_FACTOR_MODELS`, whole numbers [-].
    """

    surface: Surface
    normal_force: Array
    tangential_force: Array
    friction_coefficient: Array
    radius_1: Array
    radius_2: Array
    sign: Array
    contact_length: Array
    youngs_modulus_1: Array
    youngs_modulus_2: Array
    poisson_ratio_1: Array
    poisson_ratio_2: Array
    hardness: Array
    contact_factor_model: Array


def roller_pair_contacts(pairs: RollerPairs) -> FractalContact:
    """Spots, load shares and stiffnesses of roller pairs.

    Parameters
    ----------
    pairs : RollerPairs
        The pairs.

    Returns
    -------
    FractalContact
        As :func:`asperity.contact.fractal.fractal_contact` gives it.

    References
    ----------
    Zou et al. 2025, equations (10)–(12), (20), (22)–(24).
    """
    elastic = {
        "youngs_modulus_1": pairs.youngs_modulus_1,
        "youngs_modulus_2": pairs.youngs_modulus_2,
        "poisson_ratio_1": pairs.poisson_ratio_1,
        "poisson_ratio_2": pairs.poisson_ratio_2,
    }
    modulus = contact_modulus(**elastic)
    factors = [
        contact_factor(
            model=model,
            radius_1=pairs.radius_1,
            radius_2=pairs.radius_2,
            sign=pairs.sign,
            contact_length=pairs.contact_length,
            contact_modulus=modulus,
            normal_force=pairs.normal_force,
        )
        for model in CONTACT_FACTOR_MODELS
    ]
    chosen = [pairs.contact_factor_model == index for index in range(len(factors))]
    return fractal_contact(
        surface=pairs.surface,
        normal_force=pairs.normal_force,
        tangential_force=pairs.tangential_force,
        friction_coefficient=pairs.friction_coefficient,
        contact_factor=jnp.select(chosen, jnp.broadcast_arrays(*factors), jnp.nan),
        contact_modulus=modulus,
        tangential_contact_modulus=tangential_contact_modulus(**elastic),
        hardness=pairs.hardness,
    )
