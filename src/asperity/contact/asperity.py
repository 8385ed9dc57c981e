"""One asperity: its shape, its load and its stiffness. Zou et al. 2025, equations (7)–(9), (13)–(19), (21).

`asperity_base` names the variant of the base length l of an asperity whose contact spot has area a:

- ``"majumdar_bhushan_1991"``: l = sqrt(a). The published total load, equation (20), uses it; the default elsewhere.
- ``"circular_spot"``: l = 2 sqrt(a/pi), the diameter of the spot, as equations (8) and (17) suggest.
"""

from __future__ import annotations

import math
from typing import Literal

from asperity.engine.arrays import xp
from asperity.types import Real

AsperityBase = Literal["majumdar_bhushan_1991", "circular_spot"]


def base_length(*, spot_area: Real, asperity_base: AsperityBase) -> Real:
    r"""Base length of the asperity under a spot: :math:`l = \sqrt a` or :math:`l = 2\sqrt{a/\pi}`.

    Parameters
    ----------
    spot_area : Real
        Contact spot area a [m^2].
    asperity_base : {"majumdar_bhushan_1991", "circular_spot"}
        Variant, see the module's page.

    Returns
    -------
    Real
        Base length l [m].

    References
    ----------
    A. Majumdar and B. Bhushan, J. Tribol. 113 (1991) 1; Zou et al. 2025, equation (8) (l = 2r).
    """
    if asperity_base == "majumdar_bhushan_1991":
        return xp.sqrt(spot_area)
    return 2.0 * xp.sqrt(spot_area / math.pi)  # (8)


def asperity_height(
    *,
    position: Real,
    base_length: Real,
    fractal_dimension: Real,
    fractal_roughness: Real,
    frequency_ratio: Real,
) -> Real:
    r"""Profile of one asperity before deformation.

    .. math:: z_0(x) = G^{D-1} \sqrt{\ln\gamma}\; l^{2-D} \cos(\pi x/l), \quad |x| < l/2

    Parameters
    ----------
    position : Real
        Distance x from the summit [m]; outside \|x\| < l/2 the profile is not defined and nan is returned.
    base_length : Real
        Base length l [m]; l = 2r gives equation (8).
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2.
    fractal_roughness : Real
        Fractal roughness G [m].
    frequency_ratio : Real
        Ratio gamma of successive frequencies [-], > 1.

    Returns
    -------
    Real
        Height [m].

    References
    ----------
    Zou et al. 2025, equations (7) and (8).
    """
    height = (
        fractal_roughness ** (fractal_dimension - 1.0)
        * xp.sqrt(xp.log(frequency_ratio))
        * base_length ** (2.0 - fractal_dimension)
        * xp.cos(math.pi * position / base_length)
    )  # (7)
    return xp.where(xp.abs(position) < base_length / 2.0, height, xp.nan)


def summit_radius(
    *, base_length: Real, fractal_dimension: Real, fractal_roughness: Real, frequency_ratio: Real
) -> Real:
    r"""Radius of curvature at the summit of an asperity.

    .. math:: R = \frac{1}{|z_0''(0)|} = \frac{l^D}{\pi^2 G^{D-1} \sqrt{\ln\gamma}}

    Parameters
    ----------
    base_length : Real
        Base length l [m].
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2.
    fractal_roughness : Real
        Fractal roughness G [m].
    frequency_ratio : Real
        Ratio gamma of successive frequencies [-], > 1.

    Returns
    -------
    Real
        Radius of curvature [m].

    References
    ----------
    Zou et al. 2025, equation (9).
    """
    return base_length**fractal_dimension / (
        math.pi**2 * fractal_roughness ** (fractal_dimension - 1.0) * xp.sqrt(xp.log(frequency_ratio))
    )  # (9)


def elastic_spot_area(*, summit_radius: Real, deformation: Real) -> Real:
    r"""Contact area of an elastic asperity, :math:`a_e = \pi R w`.

    Parameters
    ----------
    summit_radius : Real
        Radius of curvature R [m].
    deformation : Real
        Deformation w [m].

    Returns
    -------
    Real
        Spot area [m^2].

    References
    ----------
    Zou et al. 2025, equation (13); Hertz.
    """
    return math.pi * summit_radius * deformation  # (13)


def hertz_load(*, contact_modulus: Real, summit_radius: Real, deformation: Real) -> Real:
    r"""Load on an elastic asperity pressed by a deformation w.

    .. math:: F_e = \tfrac43 E R^{1/2} w^{3/2}

    Parameters
    ----------
    contact_modulus : Real
        Contact modulus E [Pa].
    summit_radius : Real
        Radius of curvature R [m].
    deformation : Real
        Deformation w [m].

    Returns
    -------
    Real
        Load [N].

    References
    ----------
    Zou et al. 2025, equation (14); K. L. Johnson, Contact Mechanics, 1985, equation (4.23).
    """
    return 4.0 / 3.0 * contact_modulus * xp.sqrt(summit_radius) * deformation**1.5  # (14)


def plastic_spot_area(*, summit_radius: Real, deformation: Real) -> Real:
    r"""Contact area of a fully plastic asperity, :math:`a_p = 2\pi R w`.

    Parameters
    ----------
    summit_radius : Real
        Radius of curvature R [m].
    deformation : Real
        Deformation w [m].

    Returns
    -------
    Real
        Spot area [m^2].

    References
    ----------
    Zou et al. 2025, equation (15).
    """
    return 2.0 * math.pi * summit_radius * deformation  # (15)


def plastic_spot_load(*, hardness: Real, spot_area: Real) -> Real:
    r"""Load on a fully plastic spot, :math:`F_p = H a`.

    Parameters
    ----------
    hardness : Real
        Hardness H of the softer body [Pa].
    spot_area : Real
        Spot area a [m^2].

    Returns
    -------
    Real
        Load [N].

    References
    ----------
    Zou et al. 2025, equations (16) and (18).
    """
    return hardness * spot_area  # (16), (18)


def base_factor(*, fractal_dimension: Real, asperity_base: AsperityBase) -> Real:
    r"""Factor on the elastic spot load due to the base length: 1 or :math:`(\pi/4)^{D/2}`.

    Parameters
    ----------
    fractal_dimension : Real
        Profile fractal dimension D [-].
    asperity_base : {"majumdar_bhushan_1991", "circular_spot"}
        Variant, see the module's page.

    Returns
    -------
    Real
        Factor [-] relative to l = sqrt(a).

    References
    ----------
    From equations (9), (13), (14) of Zou et al. 2025 with l = 2 sqrt(a/pi).
    """
    if asperity_base == "majumdar_bhushan_1991":
        return xp.ones_like(fractal_dimension)
    return (math.pi / 4.0) ** (fractal_dimension / 2.0)


def elastic_spot_load(
    *,
    spot_area: Real,
    contact_modulus: Real,
    fractal_dimension: Real,
    fractal_roughness: Real,
    frequency_ratio: Real,
    asperity_base: AsperityBase,
) -> Real:
    r"""Load on an elastic spot of given area.

    .. math:: F_e(a) = \frac{4\sqrt\pi}{3} E \sqrt{\ln\gamma}\, G^{D-1} a^{(3-D)/2}

    for :math:`l = \sqrt a`; times :math:`(\pi/4)^{D/2}` for the circular-spot base.

    Parameters
    ----------
    spot_area : Real
        Spot area a [m^2].
    contact_modulus : Real
        Contact modulus E [Pa].
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2.
    fractal_roughness : Real
        Fractal roughness G [m].
    frequency_ratio : Real
        Ratio gamma of successive frequencies [-], > 1.
    asperity_base : {"majumdar_bhushan_1991", "circular_spot"}
        Variant, see the module's page.

    Returns
    -------
    Real
        Load [N].

    Notes
    -----
    Valid for areas above the critical area :func:`asperity.contact.population.critical_area`. The load per area
    jumps there from H to about 0.75 H, as in the published law.

    References
    ----------
    Zou et al. 2025, equation (17), in the form that equation (20) uses.
    """
    factor = base_factor(fractal_dimension=fractal_dimension, asperity_base=asperity_base)
    return (
        (4.0 * math.sqrt(math.pi) / 3.0)
        * factor
        * contact_modulus
        * xp.sqrt(xp.log(frequency_ratio))
        * fractal_roughness ** (fractal_dimension - 1.0)
        * spot_area ** ((3.0 - fractal_dimension) / 2.0)
    )  # (17)


def slip_factor(*, tangential_force: Real, normal_force: Real, friction_coefficient: Real) -> Real:
    r"""Loss of tangential stiffness due to partial slip.

    .. math:: \left(1 - \frac{T}{\mu F_n}\right)^{1/3}, \quad 0 \text{ from } T = \mu F_n \text{ on}

    Parameters
    ----------
    tangential_force : Real
        Tangential force T >= 0 [N].
    normal_force : Real
        Normal force F_n [N]; where it is not positive there is no contact and the factor is 0.
    friction_coefficient : Real
        Friction coefficient mu [-].

    Returns
    -------
    Real
        Factor between 0 and 1 [-].

    Notes
    -----
    Every spot is assumed to carry the same ratio Q/(mu P) = T/(mu F_n), equation (22). The derivative with
    respect to T is infinite at gross slip and set to zero there and beyond.

    References
    ----------
    Zou et al. 2025, equations (21)–(23); R. D. Mindlin, J. Appl. Mech. 16 (1949) 259.

    Examples
    --------
    >>> round(float(slip_factor(tangential_force=60.0, normal_force=1000.0, friction_coefficient=0.12)), 4)
    0.7937
    """
    limit = friction_coefficient * normal_force
    sticks = (tangential_force < limit) & (normal_force > 0.0)
    safe_limit = xp.where(sticks, limit, 1.0)
    safe_force = xp.where(sticks, tangential_force, 0.0)
    return xp.where(sticks, xp.exp(xp.log(1.0 - safe_force / safe_limit) / 3.0), 0.0)  # (22)


def tangential_spot_stiffness(
    *, spot_area: Real, tangential_contact_modulus: Real, slip_factor: Real
) -> Real:
    r"""Tangential stiffness of one elastic spot.

    .. math:: k_t = 8 G^* \sqrt{a/\pi}\,\left(1 - \frac{Q}{\mu P}\right)^{1/3}

    Parameters
    ----------
    spot_area : Real
        Spot area a [m^2].
    tangential_contact_modulus : Real
        Equivalent shear modulus G* [Pa].
    slip_factor : Real
        :func:`slip_factor` [-].

    Returns
    -------
    Real
        Tangential stiffness [N/m].

    References
    ----------
    Zou et al. 2025, equations (21) and (23).
    """
    return 8.0 * tangential_contact_modulus * xp.sqrt(spot_area / math.pi) * slip_factor  # (21)


def normal_spot_stiffness(*, spot_area: Real, contact_modulus: Real) -> Real:
    r"""Normal stiffness of one elastic spot.

    .. math:: k_n = 2 E \sqrt{a/\pi}

    Parameters
    ----------
    spot_area : Real
        Spot area a [m^2].
    contact_modulus : Real
        Contact modulus E [Pa].

    Returns
    -------
    Real
        Normal stiffness [N/m].

    References
    ----------
    Hertz (K. L. Johnson, Contact Mechanics, 1985, section 4.2); equation (A4) of :doc:`/equations`.
    """
    return 2.0 * contact_modulus * xp.sqrt(spot_area / math.pi)  # (A4)
