r"""The fractal contact law: normal force to spots to stiffness. Zou et al. 2025, equations (20), (22)–(24).

The law is one universal function. With :math:`y = \ln(a_l/a_c)` and the load :math:`F_c` at which the largest
spot is just critical, equation (20) reads (A5)

.. math::
    \ln\frac{F_n}{F_c} = \begin{cases}
      y & y < 0 \quad\text{(every spot plastic)}\\
      \dfrac D2 y + \ln\!\left[1 + \kappa \dfrac{2-D}{2} \dfrac{e^{py}-1}{p}\right] & y \ge 0
    \end{cases}
    \qquad p = \frac{3-2D}{2}, \quad \kappa = \frac{2\sqrt\pi}{3}\sqrt{\ln\gamma}

which is almost straight: two Householder steps of third order (exponential and logarithm of each step are shared
by all three derivatives) solve it to rounding. Areas span more than a hundred decades, so
everything is kept in logarithms until the end.
"""

from __future__ import annotations

import math

from asperity.contact.asperity import AsperityBase, base_factor, slip_factor
from asperity.contact.interface import RoughContact
from asperity.contact.population import log_critical_area, log_domain_extension_factor
from asperity.engine.arrays import xp
from asperity.engine.control import once
from asperity.engine.derivatives import value_and_slope, with_rule
from asperity.engine.module import Module, static
from asperity.types import Array, Real

#: Range of fractal dimensions in which the contact law is verified to rounding, narrower than what it accepts.
VERIFIED_FRACTAL_DIMENSIONS = (1.02, 1.99)

_HOUSEHOLDER_STEPS = 2
_SERIES_LIMIT = 0.25
_SERIES_TERMS = 11


class Surface(Module):
    """Fractal roughness of a contact: one equivalent surface with the roughness of both bodies.

    Parameters
    ----------
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2.
    fractal_roughness : Real
        Fractal roughness G [m].
    frequency_ratio : Real
        Ratio gamma of successive Weierstrass–Mandelbrot frequencies [-], > 1.
    asperity_base : {"majumdar_bhushan_1991", "circular_spot"}
        Variant of the base length of an asperity, see :mod:`asperity.contact.asperity`.
    """

    fractal_dimension: Real
    fractal_roughness: Real
    frequency_ratio: Real
    asperity_base: AsperityBase = static()


def _relative_expm1(x: Array) -> Array:
    """(e^x − 1)/x with all digits, and all digits of its derivative, through x = 0."""
    near = xp.abs(x) < _SERIES_LIMIT
    far_x = xp.where(near, 1.0, x)
    near_x = xp.where(near, x, 0.0)
    series = xp.ones_like(x)
    for n in range(_SERIES_TERMS, 1, -1):
        series = 1.0 + near_x / n * series
    return xp.where(near, series, xp.expm1(far_x) / far_x)


def elastic_load_coefficient(
    *, fractal_dimension: Real, frequency_ratio: Real, asperity_base: AsperityBase
) -> Real:
    r"""Coefficient of the elastic share of the load, :math:`\kappa = \frac{2\sqrt\pi}{3}\sqrt{\ln\gamma}`.

    Parameters
    ----------
    fractal_dimension : Real
        Profile fractal dimension D [-]; enters the circular-spot variant only.
    frequency_ratio : Real
        Frequency ratio gamma [-].
    asperity_base : {"majumdar_bhushan_1991", "circular_spot"}
        Variant, see :mod:`asperity.contact.asperity`.

    Returns
    -------
    Real
        kappa [-], the pressure on a spot of critical area over the hardness; 0.7524 for gamma = 1.5.

    References
    ----------
    From equations (17) and (19) of Zou et al. 2025; equation (A5) of :doc:`/equations`.
    """
    factor = base_factor(fractal_dimension=fractal_dimension, asperity_base=asperity_base)
    return (2.0 * math.sqrt(math.pi) / 3.0) * factor * xp.sqrt(xp.log(frequency_ratio))


def _log_load_ratio(log_area_ratio: Array, dimension: Array, coefficient: Array) -> Array:
    """The branch y >= 0 of (A5): ln(F_n/F_c) as a function of y = ln(a_l/a_c)."""
    power = 1.5 - dimension
    rise = log_area_ratio * _relative_expm1(power * log_area_ratio)
    return 0.5 * dimension * log_area_ratio + xp.log1p(coefficient * (1.0 - 0.5 * dimension) * rise)


@with_rule
def _solve_log_area_ratio(log_load_ratio: Array, dimension: Array, coefficient: Array) -> Array:
    power = 1.5 - dimension
    weight = coefficient * (1.0 - 0.5 * dimension)
    y = log_load_ratio / xp.maximum(0.5 * dimension, 1.5 - 0.5 * dimension)
    singular = power == 0.0
    inverse = xp.where(singular, 0.0, 1.0 / xp.where(singular, 1.0, power))
    for _ in range(_HOUSEHOLDER_STEPS):
        rise = xp.where(singular, y, xp.expm1(power * y) * inverse)
        total = 1.0 + weight * rise
        growth = weight * (1.0 + power * rise) / total
        slope = 0.5 * dimension + growth
        second = growth * (power - growth)
        third = second * (power - 2.0 * growth)
        newton = (0.5 * dimension * y + xp.log(total) - log_load_ratio) / slope
        first_order = newton * second / slope
        y = y - newton * (1.0 - 0.5 * first_order) / (1.0 - first_order + newton**2 * third / (6.0 * slope))
    return once(y)  # prevents XLA from solving again for every use


@_solve_log_area_ratio.defjvp
def _solve_log_area_ratio_jvp(
    primals: tuple[Array, Array, Array], tangents: tuple[Array, Array, Array]
) -> tuple[Array, Array]:
    """Implicit differentiation of (A5) at its root; applies to itself, so any order is exact."""
    load_ratio, dimension, coefficient = primals
    load_dot, dimension_dot, coefficient_dot = tangents
    y = _solve_log_area_ratio(load_ratio, dimension, coefficient)
    _, slope = value_and_slope(lambda v: _log_load_ratio(v, dimension, coefficient), (y,), (xp.ones_like(y),))
    _, drift = value_and_slope(
        lambda d, k: _log_load_ratio(y, d, k), (dimension, coefficient), (dimension_dot, coefficient_dot)
    )
    return y, (load_dot - drift) / slope


def log_area_ratio(*, log_load_ratio: Real, fractal_dimension: Real, elastic_load_coefficient: Real) -> Real:
    r"""Solve the universal load law (A5) for :math:`y = \ln(a_l/a_c)`.

    Parameters
    ----------
    log_load_ratio : Real
        ln(F_n/F_c) [-].
    fractal_dimension : Real
        Profile fractal dimension D [-], 1 < D < 2; D = 1.5 is a removable singularity.
    elastic_load_coefficient : Real
        kappa [-], :func:`elastic_load_coefficient`.

    Returns
    -------
    Real
        ln(a_l/a_c) [-]; negative where every spot is plastic.

    Notes
    -----
    Two Householder steps of third order on ln F: within 1e-14 of the root for 1.02 <= D <= 1.99 and loads up to e^200
    F_c; each costs one exponential and one logarithm. Derivatives are implicit. At F_n = F_c the law has a kink.

    References
    ----------
    Zou et al. 2025, equation (20), in the form (A5) of :doc:`/equations`.
    """
    ratio, dimension, coefficient = xp.broadcast_arrays(
        *(xp.asarray(v, dtype=float) for v in (log_load_ratio, fractal_dimension, elastic_load_coefficient))
    )
    elastic = ratio > 0.0
    solved = _solve_log_area_ratio(xp.where(elastic, ratio, 1.0), dimension, coefficient)
    return xp.where(elastic, solved, ratio)


def fractal_contact(
    *,
    surface: Surface,
    normal_force: Real,
    tangential_force: Real,
    friction_coefficient: Real,
    contact_factor: Real,
    contact_modulus: Real,
    tangential_contact_modulus: Real,
    hardness: Real,
) -> RoughContact:
    r"""Spots, load shares and stiffnesses of a rough contact under load.

    .. math::
        K_t = \frac{8G^*}{\sqrt\pi}\Bigl(1-\frac{T}{\mu F_n}\Bigr)^{1/3} \lambda \frac{D}{D-1}
              \psi^{(2-D)/2} a_l^{D/2} \left(a_c^{(1-D)/2} - a_l^{(1-D)/2}\right), \qquad
        A_r = \lambda \psi^{(2-D)/2} \frac{D}{2-D} a_l

    and :math:`K_n` is the same with :math:`2E` for :math:`8G^*` and no slip factor.

    Parameters
    ----------
    surface : Surface
        Fractal parameters of the equivalent surface.
    normal_force : Real
        Normal force F_n [N]; where it is not positive there is no contact and every output load, area and
        stiffness is 0.
    tangential_force : Real
        Tangential force T >= 0 [N].
    friction_coefficient : Real
        Friction coefficient mu [-].
    contact_factor : Real
        Contact factor lambda [-], :func:`asperity.contact.population.contact_factor`.
    contact_modulus, tangential_contact_modulus : Real
        E and G* [Pa], :mod:`asperity.materials`.
    hardness : Real
        Hardness H [Pa].

    Returns
    -------
    RoughContact
        All results of the law, in the broadcast shape of the inputs.

    Notes
    -----
    Valid for 1 < D < 2. K_t and K_n vanish where every spot is plastic (a_l <= a_c), K_t also from gross
    slip on (T >= mu F_n). Nothing limits a_l or A_r to the nominal area: compare them with the Hertzian area.

    References
    ----------
    Zou et al. 2025, equations (20), (22)–(24); (A5), (A6) of :doc:`/equations`.
    """
    dimension = surface.fractal_dimension
    half = 0.5 * dimension
    log_psi = log_domain_extension_factor(fractal_dimension=dimension)
    population = contact_factor * xp.exp((1.0 - half) * log_psi)  # lambda psi^((2-D)/2)
    kappa = elastic_load_coefficient(
        fractal_dimension=dimension,
        frequency_ratio=surface.frequency_ratio,
        asperity_base=surface.asperity_base,
    )
    log_critical = log_critical_area(
        fractal_dimension=dimension,
        fractal_roughness=surface.fractal_roughness,
        contact_modulus=contact_modulus,
        hardness=hardness,
    )
    pressure_scale = population * hardness * (half / (1.0 - half))  # F_c = this times a_c

    touching = normal_force > 0.0
    safe_force = xp.where(touching, normal_force, 1.0)
    y = log_area_ratio(
        log_load_ratio=xp.log(safe_force / pressure_scale) - log_critical,
        fractal_dimension=dimension,
        elastic_load_coefficient=kappa,
    )
    some_elastic = touching & (y > 0.0)
    y_elastic = xp.where(some_elastic, y, 0.0)

    rise = y_elastic * _relative_expm1((1.5 - dimension) * y_elastic)
    elastic_weight = kappa * (1.0 - half) * rise
    elastic_share = elastic_weight / (1.0 + elastic_weight)  # F_e / F_n, from the two terms of (A5)
    plastic_share = 1.0 / (1.0 + elastic_weight)

    largest = xp.where(touching, xp.exp(log_critical + y), 0.0)
    real_area = population * (half / (1.0 - half)) * largest  # (A6)
    # (24), the integral of sqrt(a/pi) n(a) from a_c to a_l, with a_l = a_c e^y; exponents joined before exp
    log_front = xp.where(some_elastic, 0.5 * log_critical + half * y_elastic, 0.0)
    radius_sum = (
        population
        * (dimension / (dimension - 1.0))
        * xp.exp(log_front)
        * -xp.expm1(-(half - 0.5) * y_elastic)
        / math.sqrt(math.pi)
    )
    slip = slip_factor(
        tangential_force=tangential_force,
        normal_force=normal_force,
        friction_coefficient=friction_coefficient,
    )
    force = xp.where(touching, normal_force, 0.0)
    values = xp.broadcast_arrays(
        largest,
        xp.exp(log_critical),
        real_area,
        force * elastic_share,
        force * plastic_share,
        8.0 * tangential_contact_modulus * radius_sum * slip,  # (24)
        *[2.0 * contact_modulus * radius_sum] * 2,  # (A6)
        xp.exp(log_psi),
        contact_factor,
    )
    return RoughContact(*values)
