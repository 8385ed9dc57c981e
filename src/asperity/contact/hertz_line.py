"""Smooth line contact of two elastic cylinders: width, pressure, first yield, stiffness, and partial slip at rest."""

from __future__ import annotations

import math

from asperity.engine.arrays import xp
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
    total: Real = xp.abs(radius_1 + sign * radius_2)
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
    return xp.sqrt(4.0 * normal_force * effective_radius / (math.pi * contact_length * contact_modulus))


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

    Every line-contact compression is this times a logarithm of the load. It is also the difference between the secant
    and the incremental compliance of one body, because the half-width grows with :math:`\sqrt N`.

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
    return scale * (2.0 * (xp.log(4.0 * radius) - xp.log(half_width)) - 1.0)


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
    C. Weber and K. Banaschek, Formänderung und Profilrücknahme bei gerad- und schrägverzahnten Rädern, Vieweg 1953.
    """
    scale = logarithmic_compliance(
        contact_length=contact_length, youngs_modulus=youngs_modulus, poisson_ratio=poisson_ratio
    )
    return scale * (
        2.0 * (xp.log(2.0 * wall_thickness) - xp.log(half_width)) - poisson_ratio / (1.0 - poisson_ratio)
    )


def stick_half_width(
    *, half_width: Real, normal_force: Real, tangential_force: Real, friction_coefficient: Real
) -> Real:
    r"""Half-width of the stick zone, :math:`c = b\sqrt{1 - T/(\mu N)}`.

    Parameters
    ----------
    half_width : Real
        Half-width b of the contact [m].
    normal_force, tangential_force : Real
        N and T >= 0 [N].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Real
        Half-width of the stick zone [m]; 0 from gross slip on.

    Notes
    -----
    Half-plane, like materials, slip against the force at both edges.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equation (7.28).
    """
    remaining = 1.0 - tangential_force / (friction_coefficient * normal_force)
    sticks = remaining > 0.0
    return xp.where(sticks, half_width * xp.sqrt(xp.where(sticks, remaining, 1.0)), 0.0)


def partial_slip_compliance(
    *, logarithmic_compliance: Real, normal_force: Real, tangential_force: Real, friction_coefficient: Real
) -> Real:
    r"""Tangential compliance that partial slip adds to a line contact, for a small further tangential force.

    .. math::
        \frac{d\delta_t}{dT} = C_0 + \Delta C, \qquad
        \Delta C = \sum_{i=1,2} \frac{1-\nu_i^2}{\pi E_i B} \, \ln\frac{1}{1 - T/(\mu N)}

    with the compliance :math:`C_0` of the contact that sticks everywhere.

    Parameters
    ----------
    logarithmic_compliance : Real
        Sum of :func:`logarithmic_compliance` over both bodies [m/N].
    normal_force, tangential_force : Real
        N and T >= 0 [N].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Real
        Additional compliance [m/N], infinite from gross slip on and where N is not positive.

    Notes
    -----
    The incremental (tangent) compliance on first loading at constant N. The secant compliance :math:`\delta_t/T`, its
    mean from 0 to T, adds the smaller :math:`1 + (1-x)\ln(1-x)/x` with :math:`x = T/(\mu N)` in place of the logarithm.
    A further force is carried by the stick zone, like the force on a rigid punch of the stick half-width c, whose
    compliance contains the logarithm of c: :math:`2\ln(b/c) = \ln[1/(1-x)]` by :func:`stick_half_width`. The derivative
    by T is infinite at gross slip and set to zero there and beyond. Half-plane, like materials.

    References
    ----------
    R. D. Mindlin, J. Appl. Mech. 16 (1949) 259, on the strip that sticks; K. L. Johnson, Contact Mechanics, 1985,
    equations (7.25), (7.28) and, for the punch, section 2.8.
    """
    limit = friction_coefficient * normal_force
    sticks = (tangential_force < limit) & (normal_force > 0.0)
    share = xp.where(sticks, tangential_force, 0.0) / xp.where(sticks, limit, 1.0)
    return xp.where(sticks, -logarithmic_compliance * xp.log1p(-share), xp.inf)
