"""Elastic materials and the moduli of a pair of bodies in contact."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Real


class Material(Module):
    """An isotropic elastic–plastic material, SI units.

    Parameters
    ----------
    youngs_modulus : Real
        Young's modulus E [Pa].
    poisson_ratio : Real
        Poisson's ratio [-].
    density : Real
        Mass density [kg/m^3]; enters the centrifugal loads and the flash temperature only.
    yield_strength : Real
        Yield strength [Pa].
    hardness : Real
        Indentation hardness H [Pa], the mean pressure of a fully plastic spot; see :func:`hardness`.
    thermal_conductivity : Real or None
        Thermal conductivity k [W/(m K)]; None if it is not known.
    specific_heat_capacity : Real or None
        Specific heat capacity c [J/(kg K)]; None if it is not known.
    thermal_expansion : Real or None
        Coefficient of linear thermal expansion alpha [1/K]; None if it is not known.
    fatigue_strength : Real or None
        Amplitude of a stress of mean zero that a part of it endures [Pa]; None if it is not known.
    tensile_strength : Real or None
        Tensile strength [Pa]; None if it is not known.
    """

    youngs_modulus: Real
    poisson_ratio: Real
    density: Real
    yield_strength: Real
    hardness: Real
    thermal_conductivity: Real | None = None
    specific_heat_capacity: Real | None = None
    thermal_expansion: Real | None = None
    fatigue_strength: Real | None = None
    tensile_strength: Real | None = None


def hardness(*, hardness_factor: Real, yield_strength: Real) -> Real:
    r"""Indentation hardness from the yield strength.

    .. math:: H = k_H\, \sigma_y

    Parameters
    ----------
    hardness_factor : Real
        Hardness factor k_H [-]; 2.8 for a blunt indenter in a ductile metal.
    yield_strength : Real
        Yield strength [Pa].

    Returns
    -------
    Real
        Hardness [Pa].

    References
    ----------
    D. Tabor, The Hardness of Metals, Oxford 1951; Zou et al. 2025, text below equation (16).

    Examples
    --------
    >>> round(hardness(hardness_factor=2.8, yield_strength=450e6) / 1e6)
    1260
    """
    return hardness_factor * yield_strength


def contact_modulus(
    *, youngs_modulus_1: Real, youngs_modulus_2: Real, poisson_ratio_1: Real, poisson_ratio_2: Real
) -> Real:
    r"""Contact modulus of two bodies pressed together.

    .. math:: \frac1E = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}

    Parameters
    ----------
    youngs_modulus_1, youngs_modulus_2 : Real
        Young's moduli [Pa].
    poisson_ratio_1, poisson_ratio_2 : Real
        Poisson's ratios [-].

    Returns
    -------
    Real
        Contact modulus [Pa].

    References
    ----------
    Zou et al. 2025, text below equation (12); K. L. Johnson, Contact Mechanics, 1985, equation (4.20).

    Examples
    --------
    >>> like = contact_modulus(youngs_modulus_1=206e9, youngs_modulus_2=206e9,
    ...                        poisson_ratio_1=0.3, poisson_ratio_2=0.3)
    >>> round(like / 1e9, 3)
    113.187
    """
    return 1.0 / (
        (1.0 - poisson_ratio_1**2) / youngs_modulus_1 + (1.0 - poisson_ratio_2**2) / youngs_modulus_2
    )


def shear_modulus(*, youngs_modulus: Real, poisson_ratio: Real) -> Real:
    r"""Shear modulus of an isotropic material.

    .. math:: G = \frac{E}{2(1+\nu)}

    Parameters
    ----------
    youngs_modulus : Real
        Young's modulus [Pa].
    poisson_ratio : Real
        Poisson's ratio [-].

    Returns
    -------
    Real
        Shear modulus [Pa].

    References
    ----------
    Zou et al. 2025, text below equation (23).
    """
    return youngs_modulus / (2.0 * (1.0 + poisson_ratio))


def tangential_contact_modulus(
    *, youngs_modulus_1: Real, youngs_modulus_2: Real, poisson_ratio_1: Real, poisson_ratio_2: Real
) -> Real:
    r"""Equivalent shear modulus of two bodies sheared across a contact spot.

    .. math:: \frac1{G^*} = \frac{2-\nu_1}{G_1} + \frac{2-\nu_2}{G_2}

    Parameters
    ----------
    youngs_modulus_1, youngs_modulus_2 : Real
        Young's moduli [Pa].
    poisson_ratio_1, poisson_ratio_2 : Real
        Poisson's ratios [-].

    Returns
    -------
    Real
        Equivalent shear modulus [Pa]; the tangential stiffness of a circular spot of radius r is 8 G* r.

    References
    ----------
    Zou et al. 2025, text below equation (23); R. D. Mindlin, J. Appl. Mech. 16 (1949) 259.

    Examples
    --------
    >>> like = tangential_contact_modulus(youngs_modulus_1=206e9, youngs_modulus_2=206e9,
    ...                                   poisson_ratio_1=0.3, poisson_ratio_2=0.3)
    >>> round(like / 1e9, 3)
    23.303
    """
    shear_1 = shear_modulus(youngs_modulus=youngs_modulus_1, poisson_ratio=poisson_ratio_1)
    shear_2 = shear_modulus(youngs_modulus=youngs_modulus_2, poisson_ratio=poisson_ratio_2)
    return 1.0 / ((2.0 - poisson_ratio_1) / shear_1 + (2.0 - poisson_ratio_2) / shear_2)


class ContactPair(Module):
    """Material properties of a pair of bodies in contact, SI units.

    Parameters
    ----------
    contact_modulus : Real
        Contact modulus E [Pa], :func:`contact_modulus`.
    tangential_contact_modulus : Real
        Equivalent shear modulus G* [Pa], :func:`tangential_contact_modulus`.
    hardness : Real
        Hardness of the softer body [Pa], which decides when a spot flows.
    yield_strength : Real
        Yield strength of the weaker body [Pa].
    """

    contact_modulus: Real
    tangential_contact_modulus: Real
    hardness: Real
    yield_strength: Real


def pair(body_1: Material, body_2: Material) -> ContactPair:
    """Moduli and limits of two materials in contact; the order does not matter.

    Parameters
    ----------
    body_1, body_2 : Material
        The two bodies.

    Returns
    -------
    ContactPair
        Their :func:`contact_modulus` and :func:`tangential_contact_modulus`, the lower hardness and yield strength.
    """
    elastic = {
        "youngs_modulus_1": body_1.youngs_modulus,
        "youngs_modulus_2": body_2.youngs_modulus,
        "poisson_ratio_1": body_1.poisson_ratio,
        "poisson_ratio_2": body_2.poisson_ratio,
    }
    return ContactPair(
        contact_modulus=contact_modulus(**elastic),
        tangential_contact_modulus=tangential_contact_modulus(**elastic),
        hardness=xp.minimum(body_1.hardness, body_2.hardness),
        yield_strength=xp.minimum(body_1.yield_strength, body_2.yield_strength),
    )
