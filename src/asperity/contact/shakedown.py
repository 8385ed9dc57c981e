"""Shakedown and first yield of a rolling line contact under traction: interpolated, differentiable, for batches."""

from __future__ import annotations

import math

from asperity.contact.shakedown_table import MISES, SHEAR
from asperity.contact.stress_peaks import POISSON_RANGE, SHEAR_FRICTION, mises_friction
from asperity.engine.arrays import xp
from asperity.types import Array, Real


def shear_yield_strength(*, yield_strength: Real) -> Real:
    r"""Yield strength in shear by Mises' criterion, :math:`k = \sigma_Y/\sqrt3`.

    Parameters
    ----------
    yield_strength : Real
        Yield strength in tension sigma_Y [Pa].

    Returns
    -------
    Real
        k [Pa].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 6.2.
    """
    return yield_strength / math.sqrt(3.0)


def _chebyshev(coefficients: tuple[Real, ...], x: Real) -> Real:
    """Sum of Chebyshev polynomials by Clenshaw's recurrence, -1 <= x <= 1."""
    after: Real = 0.0
    current: Real = 0.0
    for coefficient in reversed(coefficients[1:]):
        after, current = current, 2.0 * x * current - after + coefficient
    return x * current - after + coefficients[0]


def _reciprocal(value: Real) -> Array:
    """1/value, infinite where value is not positive."""
    some = xp.asarray(value) > 0.0
    return xp.where(some, 1.0 / xp.where(some, value, 1.0), xp.inf)


def shakedown_limit(*, friction_coefficient: Real) -> Array:
    r"""Largest Hertzian pressure of a rolling line contact without yielding in every cycle.

    .. math:: \frac{p_0}{k} = \min_{x,z} \frac{p_0}{|\tau_{xz}(x, z)|}

    below the surface and at it, where it is :math:`1/\mu`. Residual stresses that rolling leaves in the body can cancel
    every stress but :math:`\tau_{xz}` (Melan).

    Parameters
    ----------
    friction_coefficient : Real
        Traction coefficient mu >= 0 of a contact in full slip [-].

    Returns
    -------
    Array
        Peak pressure over the yield strength in shear [-]: 4.00 without friction, the surface governs from 0.367 on.

    Notes
    -----
    Elastic, perfectly plastic material, half-plane, steady rolling in one direction. Full slip is on the safe side:
    with Q < mu N the limit lies between this one and 4. Exact for Tresca's criterion with shear yield strength k, and
    for Mises' with nu = 0.3 up to mu = 0.31; above it, Mises' limit at the surface is up to 9 % lower.
    The interpolation is within 1e-10 of the field.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 9.2; equation (B6) of :doc:`/equations`.
    """
    friction = xp.asarray(friction_coefficient, dtype=float)
    tabulated = friction <= SHEAR_FRICTION
    safe = xp.where(tabulated, friction, 0.0)
    below = _chebyshev(SHEAR, 2.0 * safe / SHEAR_FRICTION - 1.0)
    return xp.minimum(xp.where(tabulated, below, xp.inf), _reciprocal(friction))  # (B6)


def _peak_limit(friction: Array, poisson: Array) -> Array:
    """Return p_0/sqrt(J_2) at the largest J_2 below the surface; infinite where the surface governs."""
    low, high = POISSON_RANGE
    bound = mises_friction(poisson)
    tabulated = (poisson >= low) & (friction <= bound)
    share = xp.where(tabulated, friction, 0.0) / xp.where(tabulated, bound, 1.0)
    place = xp.where(tabulated, 2.0 * (poisson - low) / (high - low) - 1.0, 0.0)
    rows = tuple(_chebyshev(row, place) for row in MISES)
    return xp.where(tabulated, _chebyshev(rows, 2.0 * share**2 - 1.0), xp.inf)


def mises_elastic_limit(*, friction_coefficient: Real, poisson_ratio: Real) -> Array:
    r"""Hertzian pressure at which a line contact in full slip first yields, by Mises' criterion.

    .. math::
        \frac{p_0}{k} = \min_{x,z} \frac{p_0}{\sqrt{J_2}}, \qquad
        \left.\frac{J_2}{p_0^2}\right|_{surface} = \mu^2 + \frac{(1-2\nu)^2}{3}(1+\mu^2)

    Parameters
    ----------
    friction_coefficient : Real
        Traction coefficient mu >= 0 [-].
    poisson_ratio : Real
        nu [-], 0 to 0.5.

    Returns
    -------
    Array
        Peak pressure over the yield strength in shear k = sigma_Y/sqrt(3) [-].

    Notes
    -----
    The interpolation of the peak below the surface is within 4e-6 of the field.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, sections 6.2 and 7.1; equation (B6) of :doc:`/equations`.
    """
    friction, poisson = xp.broadcast_arrays(
        xp.asarray(friction_coefficient, dtype=float), xp.asarray(poisson_ratio, dtype=float)
    )
    surface = friction**2 + (1.0 - 2.0 * poisson) ** 2 / 3.0 * (1.0 + friction**2)
    some = surface > 0.0
    at_surface = xp.where(some, 1.0 / xp.sqrt(xp.where(some, surface, 1.0)), xp.inf)
    return xp.minimum(_peak_limit(friction, poisson), at_surface)  # (B6)


def tresca_elastic_limit(*, friction_coefficient: Real, poisson_ratio: Real) -> Array:
    r"""Hertzian pressure at which a line contact in full slip first yields, by Tresca's criterion.

    .. math::
        \frac{p_0}{k} = \min_{x,z} \frac{p_0}{\tau_{max}}, \qquad
        \left.\frac{\tau_{max}}{p_0}\right|_{surface} =
        \max\left[\mu, \tfrac12\left(\mu + (1-2\nu)\sqrt{1+\mu^2}\right)\right]

    Parameters
    ----------
    friction_coefficient : Real
        Traction coefficient mu >= 0 [-].
    poisson_ratio : Real
        nu [-], 0 to 0.5.

    Returns
    -------
    Array
        Peak pressure over the yield strength in shear k = sigma_Y/2 [-].

    Notes
    -----
    The interpolation of the peak below the surface is within 4e-6 of the field.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, sections 6.2 and 7.1; equation (B6) of :doc:`/equations`.
    """
    friction, poisson = xp.broadcast_arrays(
        xp.asarray(friction_coefficient, dtype=float), xp.asarray(poisson_ratio, dtype=float)
    )
    axial = 0.5 * (friction + (1.0 - 2.0 * poisson) * xp.sqrt(1.0 + friction**2))
    # without the axial stress J_2 is tau_1 squared
    in_plane = _peak_limit(friction, xp.full_like(friction, 0.5))
    return xp.minimum(in_plane, _reciprocal(xp.maximum(friction, axial)))  # (B6)
