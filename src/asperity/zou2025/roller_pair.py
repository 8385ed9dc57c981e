"""One pair of rollers on its own: the subject of the paper's section 5.1 and Fig. 4."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp

from asperity.contact.fractal import FractalContact, Surface, fractal_contact
from asperity.contact.population import ContactFactorModel, contact_factor
from asperity.materials import Material, pair
from asperity.types import Real


class RollerPair(eqx.Module):
    """Two cylinders pressed together. Every number may be an array; all broadcast. SI units.

    Parameters
    ----------
    bodies : tuple of Material
        Materials of the two rollers.
    surface : Surface
        Fractal roughness of the equivalent surface.
    radii : tuple of Real
        Radii R_1, R_2 [m].
    sign : Real
        +1 for an external contact, −1 for an internal one [-].
    contact_length : Real
        Contact line length B [m].
    friction_coefficient : Real
        Friction coefficient mu [-].
    normal_force, tangential_force : Real
        F_n and T [N].
    contact_factor_model : {"printed", "hertz_area", "unity"}
        Model of lambda, :func:`asperity.contact.population.contact_factor`.
    """

    bodies: tuple[Material, Material]
    surface: Surface
    radii: tuple[Real, Real]
    sign: Real
    contact_length: Real
    friction_coefficient: Real
    normal_force: Real
    tangential_force: Real
    contact_factor_model: ContactFactorModel = eqx.field(static=True)


def pair_contact(rollers: RollerPair) -> FractalContact:
    """Spots and stiffnesses of a single roller pair.

    Parameters
    ----------
    rollers : RollerPair
        The pair and its load.

    Returns
    -------
    FractalContact
        In the broadcast shape of the pair's numbers.

    References
    ----------
    Zou et al. 2025, equations (10)–(24).
    """
    moduli = pair(*rollers.bodies)
    radius_1, radius_2 = rollers.radii
    factor = contact_factor(
        model=rollers.contact_factor_model,
        radius_1=radius_1,
        radius_2=radius_2,
        sign=rollers.sign,
        contact_length=rollers.contact_length,
        contact_modulus=moduli.contact_modulus,
        normal_force=jnp.where(jnp.asarray(rollers.normal_force) > 0.0, rollers.normal_force, 1.0),
    )
    return fractal_contact(
        surface=rollers.surface,
        normal_force=rollers.normal_force,
        tangential_force=rollers.tangential_force,
        friction_coefficient=rollers.friction_coefficient,
        contact_factor=factor,
        contact_modulus=moduli.contact_modulus,
        tangential_contact_modulus=moduli.tangential_contact_modulus,
        hardness=moduli.hardness,
    )
