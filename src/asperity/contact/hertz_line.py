"""Smooth line contact of two elastic cylinders: width, pressure, first yield, compression and stiffness."""

from __future__ import annotations

import math

import jax.numpy as jnp

from asperity.arrays import namespace
from asperity.types import Real

#: Peak pressure at first yield over the yield strength, Tresca (Johnson 1985, section 6.2, p0 = 1.67 Y).
FIRST_YIELD_RATIO = 1.67


def effective_radius(*, radius_1: Real, radius_2: Real, sign: Real) -> Real:
    r"""Effective radius of two parallel cylinders, :math:`R = R_1 R_2 / |R_1 \pm R_2|`.

    Parameters
    ----------
    radius_1, radius_2 : Real
        Radii [m].
    sign : Real
        +1 for an external contact, −1 where one cylinder lies inside the other [-].

    Returns
    -------
    Real
        Effective radius [m].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 4.2.

    Examples
    --------
    >>> round(float(effective_radius(radius_1=10e-3, radius_2=20e-3, sign=1.0)) * 1e3, 4)
    6.6667
    """
    total: Real = namespace(radius_1, radius_2, sign).abs(radius_1 + sign * radius_2)
    return radius_1 * radius_2 / total


def half_width(
    *, normal_force: Real, contact_length: Real, effective_radius: Real, contact_modulus: Real
) -> Real:
    r"""Half-width of the Hertzian contact strip.

    .. math:: b = \sqrt{\frac{4 N R}{\pi B E}}

    Parameters
    ----------
    normal_force : Real
        Normal force N [N].
    contact_length : Real
        Contact line length B [m].
    effective_radius : Real
        Effective radius R [m].
    contact_modulus : Real
        Contact modulus E [Pa].

    Returns
    -------
    Real
        Half-width [m].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equation (4.43).
    """
    return jnp.sqrt(4.0 * normal_force * effective_radius / (math.pi * contact_length * contact_modulus))


def peak_pressure(*, normal_force: Real, contact_length: Real, half_width: Real) -> Real:
    r"""Peak Hertzian pressure, :math:`p_0 = 2N/(\pi b B)`; the mean pressure is :math:`\pi p_0/4`.

    Parameters
    ----------
    normal_force : Real
        Normal force N [N].
    contact_length : Real
        Contact line length B [m].
    half_width : Real
        Half-width b [m].

    Returns
    -------
    Real
        Peak pressure [Pa].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equation (4.44).
    """
    return 2.0 * normal_force / (math.pi * half_width * contact_length)


def first_yield_pressure(*, yield_strength: Real) -> Real:
    r"""Peak pressure at which a line contact first yields below the surface, :math:`p_0 = 1.67\,\sigma_y`.

    Parameters
    ----------
    yield_strength : Real
        Yield strength of the weaker body [Pa].

    Returns
    -------
    Real
        Peak pressure [Pa].

    Notes
    -----
    Tresca, without friction; von Mises in plane strain with nu = 0.3 would give 1.79.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 6.2.
    """
    return FIRST_YIELD_RATIO * yield_strength


def logarithmic_compliance(*, contact_length: Real, youngs_modulus: Real, poisson_ratio: Real) -> Real:
    r"""Compliance scale of one body under a line load, :math:`(1-\nu^2)/(\pi E B)`.

    Every line-contact compression is this times a logarithm of the load. It is also the difference between the
    secant and the incremental compliance of one body, because the half-width grows with
    :math:`\sqrt N`.

    Parameters
    ----------
    contact_length : Real
        Contact line length B [m].
    youngs_modulus : Real
        Young's modulus of the body [Pa].
    poisson_ratio : Real
        Poisson's ratio of the body [-].

    Returns
    -------
    Real
        Compliance [m/N].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 5.6.
    """
    return (1.0 - poisson_ratio**2) / (math.pi * youngs_modulus * contact_length)


def roller_secant_compliance(
    *, radius: Real, half_width: Real, contact_length: Real, youngs_modulus: Real, poisson_ratio: Real
) -> Real:
    r"""Compression of a solid roller between contact and centre, per load.

    .. math:: \frac{\delta}{N} = \frac{1-\nu^2}{\pi E B}\left(2 \ln\frac{4R}{b} - 1\right)

    Parameters
    ----------
    radius : Real
        Radius R of the roller [m].
    half_width : Real
        Half-width b of the contact at this load [m].
    contact_length : Real
        Contact line length B [m].
    youngs_modulus : Real
        Young's modulus of the roller [Pa].
    poisson_ratio : Real
        Poisson's ratio of the roller [-].

    Returns
    -------
    Real
        Secant compliance [m/N].

    Notes
    -----
    Plane strain; valid for b << R.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 5.6, equation (5.57).
    """
    scale = logarithmic_compliance(
        contact_length=contact_length, youngs_modulus=youngs_modulus, poisson_ratio=poisson_ratio
    )
    return scale * (2.0 * (jnp.log(4.0 * radius) - jnp.log(half_width)) - 1.0)


def ring_secant_compliance(
    *, wall_thickness: Real, half_width: Real, contact_length: Real, youngs_modulus: Real, poisson_ratio: Real
) -> Real:
    r"""Compression of the wall of a ring between contact and depth h, per load.

    .. math::
        \frac{\delta}{N} = \frac{2(1-\nu^2)}{\pi E B}
        \left[\ln\frac{2h}{b} - \frac{\nu}{2(1-\nu)}\right]

    Parameters
    ----------
    wall_thickness : Real
        Wall h of the ring [m].
    half_width : Real
        Half-width b of the contact at this load [m].
    contact_length : Real
        Contact line length B [m].
    youngs_modulus : Real
        Young's modulus of the ring [Pa].
    poisson_ratio : Real
        Poisson's ratio of the ring [-].

    Returns
    -------
    Real
        Secant compliance [m/N].

    Notes
    -----
    Plane strain; valid for b << h. Bending of the ring as a whole is not included.

    References
    ----------
    C. Weber and K. Banaschek, Formänderung und Profilrücknahme bei gerad- und schrägverzahnten Rädern,
    Vieweg 1953.
    """
    scale = logarithmic_compliance(
        contact_length=contact_length, youngs_modulus=youngs_modulus, poisson_ratio=poisson_ratio
    )
    return scale * (
        2.0 * (jnp.log(2.0 * wall_thickness) - jnp.log(half_width)) - poisson_ratio / (1.0 - poisson_ratio)
    )
