"""The population of contact spots: how many there are of each size. Zou et al. 2025, equations (10)–(12), (19)."""

from __future__ import annotations

import math
from typing import Literal

from asperity.contact.hertz_line import effective_radius, half_width
from asperity.engine.arrays import xp
from asperity.engine.control import once
from asperity.engine.derivatives import value_and_slope, with_rule
from asperity.types import Array, Real

ContactFactorModel = Literal["printed", "hertz_area", "unity"]

# ln psi within 2e-6 on 1 < D < 2, in powers of D - 1.5: least squares through the roots. Start of the iteration only.
_START = (0.693504, -0.389088, 0.216115, -0.118178, 0.0641424, -0.0394134, 0.0212984)


def _extension_residual(log_psi: Array, dimension: Array) -> Array:
    """Equation (10)'s condition on psi divided by 2 − D, which stays accurate as D approaches 2."""
    distance = 2.0 - dimension
    inside = xp.expm1(0.5 * distance * log_psi)
    outside = xp.expm1(-distance / dimension * xp.log1p(xp.exp(-0.5 * dimension * log_psi)))
    return (inside - outside) / distance - 1.0 / dimension


@with_rule
def _log_extension_factor(dimension: Array) -> Array:
    centred = dimension - 1.5
    log_psi = xp.full_like(dimension, _START[-1])
    for coefficient in reversed(_START[:-1]):
        log_psi = log_psi * centred + coefficient
    # one step of Halley's method, whose error is cubed: below rounding
    distance = 2.0 - dimension
    weight = xp.exp(-0.5 * dimension * log_psi)
    share = weight / (1.0 + weight)
    growth = xp.expm1(0.5 * distance * log_psi)
    shrink = xp.expm1(-distance / dimension * xp.log1p(weight))
    residual = (growth - shrink) / distance - 1.0 / dimension
    slope = 0.5 * ((1.0 + growth) - (1.0 + shrink) * share)
    bend = 0.25 * (
        distance * (1.0 + growth) + (1.0 + shrink) * share * (dimension * (1.0 - share) - distance * share)
    )
    step = residual / slope
    log_psi = log_psi - step / (1.0 - 0.5 * step * bend / slope)
    return once(log_psi)  # prevents XLA from recomputing it for every use


@_log_extension_factor.defjvp
def _log_extension_factor_jvp(primals: tuple[Array], tangents: tuple[Array]) -> tuple[Array, Array]:
    """Implicit differentiation of the residual at its root."""
    (dimension,), (dimension_dot,) = primals, tangents
    log_psi = _log_extension_factor(dimension)
    ones = xp.ones_like(log_psi)
    _, slope = value_and_slope(lambda s: _extension_residual(s, dimension), (log_psi,), (ones,))
    _, drift = value_and_slope(lambda d: _extension_residual(log_psi, d), (dimension,), (dimension_dot,))
    return log_psi, -drift / slope


def log_domain_extension_factor(*, fractal_dimension: Real) -> Real:
    """Natural logarithm of :func:`domain_extension_factor`.

    Parameters
    ----------
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2.

    Returns
    -------
    Real
        ln psi [-].
    """
    return _log_extension_factor(xp.asarray(fractal_dimension, dtype=float))


def domain_extension_factor(*, fractal_dimension: Real) -> Real:
    r"""Domain extension factor of the spot population.

    It is the root psi > 1 of

    .. math:: \psi^{(2-D)/2} - \left(1 + \psi^{-D/2}\right)^{-(2-D)/D} = \frac{2-D}{D}

    Parameters
    ----------
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2.

    Returns
    -------
    Real
        psi [-], between e − 1 (D → 2) and 2.618 (D → 1).

    Notes
    -----
    One Halley step in ln psi from a polynomial within 2e-6 of it: within 1e-15 for all D.
    Derivatives are implicit, hence exact.

    References
    ----------
    Zou et al. 2025, text below equation (10); S. Wang and K. Komvopoulos, J. Tribol. 116 (1994) 812.

    Examples
    --------
    >>> float(domain_extension_factor(fractal_dimension=1.4))  # doctest: +ELLIPSIS
    2.08485078067...
    """
    return xp.exp(log_domain_extension_factor(fractal_dimension=fractal_dimension))


def printed_contact_factor(
    *, radius_1: Real, radius_2: Real, sign: Real, contact_length: Real, contact_modulus: Real
) -> Real:
    r"""Contact factor lambda exactly as the paper prints it.

    .. math::
        \lambda = \left[\frac{1}{\pi (R_1 \pm R_2)}
        \sqrt{\frac{4B}{\pi E}\,\frac{R_1 R_2}{R_1 \pm R_2}}\right]^{1/R_1 \pm 1/R_2}

    with the lengths in mm and the modulus in MPa: the expression is dimensionally inconsistent, so these units are part
    of it. For an internal contact the magnitudes of :math:`R_1 - R_2` and :math:`1/R_1 - 1/R_2` enter.

    Parameters
    ----------
    radius_1, radius_2 : Real
        Radii of the two cylinders [m].
    sign : Real
        +1 for an external contact, −1 for an internal one [-].
    contact_length : Real
        Contact line length B [m].
    contact_modulus : Real
        Contact modulus E [Pa].

    Returns
    -------
    Real
        Contact factor [-].

    Notes
    -----
    Only this variant gives the paper's rise of stiffness with contact length (Fig. 4f). Its use outside the
    paper's range of sizes (millimetres to some centimetres) has no physical basis.

    References
    ----------
    Zou et al. 2025, equation (11).
    """
    length, modulus = 1e3 * contact_length, 1e-6 * contact_modulus  # mm, MPa
    span = 1e3 * xp.abs(radius_1 + sign * radius_2)
    radius = 1e3 * effective_radius(radius_1=radius_1, radius_2=radius_2, sign=sign)
    base = xp.sqrt(4.0 * length / (math.pi * modulus) * radius) / (math.pi * span)
    return xp.exp(xp.log(base) / radius)  # (11)


def hertz_area_contact_factor(
    *,
    radius_1: Real,
    radius_2: Real,
    sign: Real,
    contact_length: Real,
    contact_modulus: Real,
    normal_force: Real,
) -> Real:
    r"""Contact factor whose base is the Hertzian area over the area of both cylinders.

    .. math:: \lambda = \left[\frac{b}{\pi (R_1 \pm R_2)}\right]^{1/R_1 \pm 1/R_2}, \quad
        b = \sqrt{\frac{4 F R}{\pi B E}}

    The base is dimensionless; the exponent is the printed one, taken in 1/mm.

    Parameters
    ----------
    radius_1, radius_2 : Real
        Radii of the two cylinders [m].
    sign : Real
        +1 for an external contact, −1 for an internal one [-].
    contact_length : Real
        Contact line length B [m].
    contact_modulus : Real
        Contact modulus E [Pa].
    normal_force : Real
        Normal force F [N].

    Returns
    -------
    Real
        Contact factor [-].

    References
    ----------
    The likely source form of equation (11) of Zou et al. 2025; see :doc:`/assumptions`.
    """
    radius = effective_radius(radius_1=radius_1, radius_2=radius_2, sign=sign)
    width = half_width(
        normal_force=normal_force,
        contact_length=contact_length,
        effective_radius=radius,
        contact_modulus=contact_modulus,
    )
    return (width / (math.pi * xp.abs(radius_1 + sign * radius_2))) ** (1e-3 / radius)


def contact_factor(
    *,
    model: ContactFactorModel,
    radius_1: Real,
    radius_2: Real,
    sign: Real,
    contact_length: Real,
    contact_modulus: Real,
    normal_force: Real,
) -> Real:
    """Contact factor lambda by the named model; see the function of each model for its formula.

    Parameters
    ----------
    model : {"printed", "hertz_area", "unity"}
        Variant; ``unity`` is lambda = 1, the flat surface of equation (10).
    radius_1, radius_2 : Real
        Radii of the two cylinders [m].
    sign : Real
        +1 for an external contact, −1 for an internal one [-].
    contact_length : Real
        Contact line length B [m].
    contact_modulus : Real
        Contact modulus E [Pa].
    normal_force : Real
        Normal force F [N]; enters ``hertz_area`` only.

    Returns
    -------
    Real
        Contact factor [-].
    """
    cylinders = {
        "radius_1": radius_1,
        "radius_2": radius_2,
        "sign": sign,
        "contact_length": contact_length,
        "contact_modulus": contact_modulus,
    }
    if model == "printed":
        return printed_contact_factor(**cylinders)
    if model == "hertz_area":
        return hertz_area_contact_factor(**cylinders, normal_force=normal_force)
    return xp.ones_like(printed_contact_factor(**cylinders))


def log_critical_area(
    *, fractal_dimension: Real, fractal_roughness: Real, contact_modulus: Real, hardness: Real
) -> Real:
    """Natural logarithm of :func:`critical_area` in m^2, which covers more decades than a floating-point area.

    Parameters
    ----------
    fractal_dimension, fractal_roughness, contact_modulus, hardness : Real
        As for :func:`critical_area`.

    Returns
    -------
    Real
        ln(a_c / 1 m^2) [-].
    """
    return 2.0 * xp.log(fractal_roughness) + 2.0 / (fractal_dimension - 1.0) * xp.log(
        2.0 * contact_modulus / hardness
    )  # (19)


def critical_area(
    *, fractal_dimension: Real, fractal_roughness: Real, contact_modulus: Real, hardness: Real
) -> Real:
    r"""Spot area at which an asperity passes from plastic (smaller) to elastic (larger).

    .. math:: a_c = G^2 \left(\frac{2E}{H}\right)^{2/(D-1)}

    Parameters
    ----------
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2.
    fractal_roughness : Real
        Fractal roughness G [m].
    contact_modulus : Real
        Contact modulus E [Pa].
    hardness : Real
        Hardness H [Pa].

    Returns
    -------
    Real
        Critical area [m^2].

    References
    ----------
    Zou et al. 2025, equation (19); A. Majumdar and B. Bhushan, J. Tribol. 113 (1991) 1.

    Examples
    --------
    >>> area = critical_area(fractal_dimension=1.4, fractal_roughness=1e-11,
    ...                      contact_modulus=113.187e9, hardness=1260e6)
    >>> round(float(area) * 1e6, 9)  # mm^2
    1.8719e-05
    """
    return xp.exp(
        log_critical_area(
            fractal_dimension=fractal_dimension,
            fractal_roughness=fractal_roughness,
            contact_modulus=contact_modulus,
            hardness=hardness,
        )
    )


def spot_density(
    *, spot_area: Real, largest_area: Real, contact_factor: Real, fractal_dimension: Real
) -> Real:
    r"""Number of spots per unit of spot area.

    .. math:: n(a) = \lambda \frac D2 \psi^{(2-D)/2} a_l^{D/2} a^{-(D+2)/2}, \quad 0 < a \le a_l

    Parameters
    ----------
    spot_area : Real
        Spot area a [m^2].
    largest_area : Real
        Area a_l of the largest spot [m^2].
    contact_factor : Real
        Contact factor lambda [-].
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2.

    Returns
    -------
    Real
        Density [1/m^2]; 0 above the largest area.

    References
    ----------
    Zou et al. 2025, equations (10) and (12).
    """
    half = fractal_dimension / 2.0
    log_psi = log_domain_extension_factor(fractal_dimension=fractal_dimension)
    density = (
        contact_factor
        * half
        * xp.exp((1.0 - half) * log_psi)
        * largest_area**half
        * spot_area ** (-half - 1.0)
    )  # (12)
    return xp.where(spot_area <= largest_area, density, 0.0)
