"""Partial slip of smooth cylinders under a constant normal and a growing tangential force."""

from __future__ import annotations

import jax.numpy as jnp

from asperity.types import Real


def stick_half_width(
    *, half_width: Real, normal_force: Real, tangential_force: Real, friction_coefficient: Real
) -> Real:
    r"""Half-width of the strip that still sticks, :math:`c = b\sqrt{1 - T/(\mu N)}`.

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


def shear_traction(
    *,
    position: Real,
    half_width: Real,
    stick_half_width: Real,
    peak_pressure: Real,
    friction_coefficient: Real,
) -> Real:
    r"""Shear traction across a line contact in partial slip.

    .. math::
        q(x) = \mu p_0 \left[\sqrt{1 - x^2/b^2} - \frac cb \sqrt{1 - x^2/c^2}\right]

    with the second term inside the stick zone only, and 0 outside the contact.

    Parameters
    ----------
    position : Real
        Distance x from the middle of the contact [m].
    half_width, stick_half_width : Real
        b and c [m].
    peak_pressure : Real
        Peak pressure p_0 [Pa].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Real
        Traction [Pa].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equations (7.22)–(7.26).
    """

    def ellipse(width: Real) -> Real:
        inside = jnp.abs(position) < width
        safe_width = jnp.where(width > 0.0, width, 1.0)
        height = jnp.where(inside, 1.0 - (position / safe_width) ** 2, 1.0)
        return jnp.where(inside, jnp.sqrt(height), 0.0)

    stuck = stick_half_width / half_width * ellipse(stick_half_width)
    return friction_coefficient * peak_pressure * (ellipse(half_width) - stuck)
