"""Partial slip of smooth cylinders under constant normal force and increasing tangential force."""

from __future__ import annotations

import jax.numpy as jnp

from asperity.types import Real


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
    return jnp.where(sticks, half_width * jnp.sqrt(jnp.where(sticks, remaining, 1.0)), 0.0)


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
        Sum of :func:`asperity.contact.hertz_line.logarithmic_compliance` over both bodies [m/N].
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
    The incremental (tangent) compliance on first loading at constant N. The secant compliance
    :math:`\delta_t/T`, its mean from 0 to T, adds the smaller :math:`1 + (1-x)\ln(1-x)/x` with
    :math:`x = T/(\mu N)` in place of the logarithm. A further force is carried by the stick zone, like the
    force on a rigid punch of the stick half-width c, whose compliance contains the logarithm of c:
    :math:`2\ln(b/c) = \ln[1/(1-x)]` by :func:`stick_half_width`. The derivative by T is infinite at gross slip and
    set to zero there and beyond. Half-plane, like materials.

    References
    ----------
    R. D. Mindlin, J. Appl. Mech. 16 (1949) 259, on the strip that sticks; K. L. Johnson, Contact Mechanics, 1985,
    equations (7.25), (7.28) and, for the punch, section 2.8.
    """
    limit = friction_coefficient * normal_force
    sticks = (tangential_force < limit) & (normal_force > 0.0)
    share = jnp.where(sticks, tangential_force, 0.0) / jnp.where(sticks, limit, 1.0)
    return jnp.where(sticks, -logarithmic_compliance * jnp.log1p(-share), jnp.inf)
