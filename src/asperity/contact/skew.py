"""Skewed rollers: longitudinal and lateral creep of one line contact, and the axial force that comes with it."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
from jax import Array, lax

from asperity.types import Real

#: Iterations of the solver for the longitudinal creepage, and the residual of the force that it must reach.
_STEPS = 4
_RESIDUAL = 1e-12


class SkewedContact(eqx.Module):
    """State of a line contact that rolls with creepage in both directions; arrays of one shape.

    Parameters
    ----------
    longitudinal_creepage, lateral_creepage : Array
        xi_x and xi_y [-].
    longitudinal_slip_ratio, lateral_slip_ratio : Array
        Q_x/(mu N) and Q_y/(mu N) [-].
    solved : Array
        True where the longitudinal creepage carries the longitudinal force; false also where no creepage can [-].
    """

    longitudinal_creepage: Array
    lateral_creepage: Array
    longitudinal_slip_ratio: Array
    lateral_slip_ratio: Array
    solved: Array

    @property
    def slip_ratio(self) -> Array:
        """Traction in both directions over friction [-]; 1 where the whole contact slips."""
        square = self.longitudinal_slip_ratio**2 + self.lateral_slip_ratio**2
        some = square > 0.0
        return jnp.where(some, jnp.sqrt(jnp.where(some, square, 1.0)), 0.0)


def lateral_compliance_ratio(
    *, youngs_modulus_1: Real, youngs_modulus_2: Real, poisson_ratio_1: Real, poisson_ratio_2: Real
) -> Real:
    r"""Lateral over longitudinal creepage at gross slip.

    .. math::
        \frac{\xi_{y,max}}{\xi_{x,max}} =
        \frac{\sum_i (1+\nu_i)/E_i}{\sum_i (1-\nu_i^2)/E_i} \;\left(= \frac{1}{1-\nu} \text{ for like bodies}\right)

    Parameters
    ----------
    youngs_modulus_1, youngs_modulus_2 : Real
        Young's moduli [Pa].
    poisson_ratio_1, poisson_ratio_2 : Real
        Poisson's ratios [-].

    Returns
    -------
    Real
        Ratio [-].

    Notes
    -----
    Along the roller axis a long contact is in anti-plane shear: the compliance of the surface is that of the shear
    modulus instead of the plane-strain modulus. Kalker's coefficients of a long contact have the same ratio.

    References
    ----------
    J. J. Kalker, Proc. Kon. Ned. Akad. Wetensch. B 70 (1967) 10: line limits C11 = pi^2/(4(1 − nu)),
    C22 = pi^2/4. Equation (B3) of :doc:`/equations`.
    """
    antiplane = (1.0 + poisson_ratio_1) / youngs_modulus_1 + (1.0 + poisson_ratio_2) / youngs_modulus_2
    plane = (1.0 - poisson_ratio_1**2) / youngs_modulus_1 + (1.0 - poisson_ratio_2**2) / youngs_modulus_2
    return antiplane / plane  # (B3)


def _length(x: Real, y: Real) -> Real:
    """Length of a vector, with derivative 0 at 0."""
    square = x**2 + y**2
    some = square > 0.0
    return jnp.where(some, jnp.sqrt(jnp.where(some, square, 1.0)), 0.0)


def _traction_over_share(share: Real) -> Real:
    """(1 − (1 − r)^2)/r up to gross slip at r = 1 and 1/r beyond: the traction ratio over the share of creepage."""
    sticks = share < 1.0
    return jnp.where(sticks, 2.0 - share, 1.0 / jnp.where(sticks, 1.0, share))


def skewed_slip_ratios(
    *,
    longitudinal_creepage: Real,
    lateral_creepage: Real,
    gross_slip_creepage: Real,
    lateral_gross_slip_creepage: Real,
) -> tuple[Real, Real]:
    r"""Tangential forces over friction from the creepages in both directions.

    .. math::
        \frac{\mathbf Q}{\mu N} = \left[1 - (1 - |\zeta|)^2\right]\frac{\zeta}{|\zeta|}, \qquad
        \zeta = \left(\frac{\xi_x}{\xi_{x,max}}, \frac{\xi_y}{\xi_{y,max}}\right)

    and :math:`\zeta/|\zeta|` from :math:`|\zeta| = 1` on.

    Parameters
    ----------
    longitudinal_creepage, lateral_creepage : Real
        xi_x and xi_y, of either sign [-]; a roller that is out of parallel by an angle has that angle as xi_y.
    gross_slip_creepage, lateral_gross_slip_creepage : Real
        xi_x,max and xi_y,max, positive [-]: :func:`asperity.contact.carter.gross_slip_creepage` and that times
        :func:`lateral_compliance_ratio`.

    Returns
    -------
    tuple of Real
        Q_x/(mu N) and Q_y/(mu N) [-].

    Notes
    -----
    Exact in one direction alone (Carter) and in gross slip of bodies with nu = 0; the combination of both is an
    approximation.

    References
    ----------
    The rule of P. J. Vermeulen and K. L. Johnson, J. Appl. Mech. 31 (1964) 338, for both creepages together, with
    Carter's curve. Equation (B3) of :doc:`/equations`.
    """
    along = longitudinal_creepage / gross_slip_creepage
    across = lateral_creepage / lateral_gross_slip_creepage
    factor = _traction_over_share(_length(along, across))  # (B3)
    return factor * along, factor * across


def _partial_slip_share(slip_ratio: Real, across: Real) -> Real:
    """Root of (2 − r) x = q, r = |(x, across)|, by steps that fit a parabola; exact at once for across = 0."""
    magnitude = jnp.abs(slip_ratio)

    def force(x: Real) -> Real:
        return (2.0 - _length(x, across)) * x

    x = 1.0 - jnp.sqrt(1.0 - magnitude)
    for _ in range(_STEPS):
        share = _length(x, across)
        safe = jnp.where(share > 0.0, share, 1.0)
        missing = magnitude - force(x)
        slope = 2.0 - share - x**2 / safe
        bend = -(x / safe) * (3.0 - (x / safe) ** 2)
        root = slope**2 + 2.0 * bend * missing
        step_slope = slope + jnp.sqrt(jnp.where(root > 0.0, root, 0.0))
        x = x + 2.0 * missing / jnp.where(step_slope > 0.0, step_slope, 1.0)
    return jnp.sign(slip_ratio) * x


def skewed_contact(
    *,
    longitudinal_slip_ratio: Real,
    lateral_creepage: Real,
    gross_slip_creepage: Real,
    lateral_gross_slip_creepage: Real,
) -> SkewedContact:
    r"""Longitudinal creepage and lateral force of a skewed contact that carries a longitudinal force.

    Solves :func:`skewed_slip_ratios` for :math:`\xi_x`. Once the contact slips as a whole, the direction of slip
    alone gives the longitudinal force: :math:`\zeta_x = |\zeta_y|\,q_x/\sqrt{1-q_x^2}`.

    Parameters
    ----------
    longitudinal_slip_ratio : Real
        Q_x/(mu N), of either sign [-].
    lateral_creepage : Real
        xi_y, the skew angle, of either sign [-].
    gross_slip_creepage, lateral_gross_slip_creepage : Real
        xi_x,max and xi_y,max, positive [-].

    Returns
    -------
    SkewedContact
        Creepages and forces; the creepage is infinite and not solved where no creepage carries the force, which is
        for :math:`|q_x| \ge 1` (without skew :math:`|q_x| > 1`).

    Notes
    -----
    Derivatives are those of the equation at its root. As for :func:`skewed_slip_ratios`.

    References
    ----------
    Equation (B3) of :doc:`/equations`.
    """
    given, lateral, along_max, across_max = jnp.broadcast_arrays(
        *(
            jnp.asarray(v, dtype=float)
            for v in (
                longitudinal_slip_ratio,
                lateral_creepage,
                gross_slip_creepage,
                lateral_gross_slip_creepage,
            )
        )
    )
    magnitude = jnp.abs(given)
    across = jnp.abs(lateral) / across_max
    partial = (across < 1.0) & (magnitude**2 + across**2 <= 1.0)
    slides = ~partial & (magnitude < 1.0) & (across > 0.0)

    safe_q = jnp.where(partial, given, 0.0)
    safe_across = jnp.where(partial, across, 0.0)
    root = lax.custom_root(
        lambda x: (2.0 - _length(x, safe_across)) * x - safe_q,
        jnp.zeros_like(safe_q),
        lambda _, __: _partial_slip_share(safe_q, safe_across),
        lambda linear, y: y / linear(jnp.ones_like(y)),
    )
    slide_q = jnp.where(slides, given, 0.0)
    sliding = across * slide_q / jnp.sqrt(1.0 - slide_q**2)
    share = jnp.where(partial, root, jnp.where(slides, sliding, jnp.sign(given) * jnp.inf))

    finite = partial | slides
    factor = _traction_over_share(_length(jnp.where(finite, share, 0.0), across))
    carried = factor * jnp.where(finite, share, 0.0)
    return SkewedContact(
        longitudinal_creepage=share * along_max,
        lateral_creepage=lateral,
        longitudinal_slip_ratio=given,
        lateral_slip_ratio=jnp.where(finite, factor, 0.0) * lateral / across_max,
        solved=finite & (jnp.abs(carried - given) <= _RESIDUAL),
    )


def axial_force(*, friction_coefficient: Real, normal_force: Real, lateral_slip_ratio: Real) -> Real:
    r"""Axial force of a skewed contact, :math:`Q_y = q_y\,\mu N`.

    Parameters
    ----------
    friction_coefficient : Real
        mu [-].
    normal_force : Real
        N [N].
    lateral_slip_ratio : Real
        Q_y/(mu N), of :func:`skewed_slip_ratios` or :func:`skewed_contact` [-].

    Returns
    -------
    Real
        Force on the bearing of the roller [N].

    References
    ----------
    Equation (B3) of :doc:`/equations`.
    """
    return friction_coefficient * normal_force * lateral_slip_ratio


def longitudinal_capacity_ratio(*, lateral_creepage: Real, lateral_gross_slip_creepage: Real) -> Real:
    r"""Longitudinal force that a skewed contact carries before it slips as a whole, over that without skew.

    .. math:: \frac{Q_{x,max}}{\mu N} = \sqrt{1 - \left(\frac{\xi_y}{\xi_{y,max}}\right)^2}

    Parameters
    ----------
    lateral_creepage : Real
        xi_y, the skew angle, of either sign [-].
    lateral_gross_slip_creepage : Real
        xi_y,max, positive [-].

    Returns
    -------
    Real
        Ratio [-]; 0 where the skew alone makes the contact slip. The loss of capacity is 1 less this.

    References
    ----------
    :math:`|\zeta| = 1` in equation (B3) of :doc:`/equations`.
    """
    remaining = 1.0 - (lateral_creepage / lateral_gross_slip_creepage) ** 2
    some = remaining > 0.0
    return jnp.where(some, jnp.sqrt(jnp.where(some, remaining, 1.0)), 0.0)
