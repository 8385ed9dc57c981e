"""Skewed rollers: longitudinal and lateral creep of one line contact, and the resulting axial force."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.engine.control import fori_loop, is_rounding
from asperity.engine.derivatives import without_slopes
from asperity.engine.module import Module
from asperity.implicit import implicit_root
from asperity.types import Array, Real

#: Iterations of the solver for the longitudinal creepage, and the residual of the force that it must reach.
_STEPS = 30
_RESIDUAL = 1e-12


class SkewedContact(Module):
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
        return xp.where(some, xp.sqrt(xp.where(some, square, 1.0)), 0.0)


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
    return xp.where(some, xp.sqrt(xp.where(some, square, 1.0)), 0.0)


def stick_fraction(*, longitudinal_slip_ratio: Real, lateral_slip_ratio: Real) -> Real:
    r"""Share of the contact width that sticks, :math:`\sqrt{1 - |\mathbf q|}`.

    Parameters
    ----------
    longitudinal_slip_ratio, lateral_slip_ratio : Real
        Tangential and axial force over friction [-].

    Returns
    -------
    Real
        Share [-]; 0 where the traction is all of friction. Its slope is unbounded there.

    References
    ----------
    Carter's stick zone under the length of the traction, as the combined creepage has it; equation (B3) of
    :doc:`/equations`.
    """
    left = 1.0 - _length(longitudinal_slip_ratio, lateral_slip_ratio)
    sticks = left > 1e-12  # rounding of a traction that is all of friction
    return xp.where(sticks, xp.sqrt(xp.where(sticks, left, 1.0)), 0.0)


def _force_over_share(share: Real) -> Real:
    """Traction ratio over the share of creepage r: 2 − r up to gross slip at r = 1, and 1/r beyond."""
    sticks = share < 1.0
    return xp.where(sticks, 2.0 - share, 1.0 / xp.where(sticks, 1.0, share))


def turn_exponent(share: Real) -> Real:
    r"""Exponent w that turns the traction from the scaled creepage towards the creepage itself.

    .. math:: w = \frac{z}{4 - 2z} \;(z < 1), \qquad 1 - \frac1{2z^2} \;(z \ge 1)

    Parameters
    ----------
    share : Real
        Size z of the creepages over that at which all slips, shape (contacts, ...) [-].

    Returns
    -------
    Real
        Exponent, of the same shape [-].

    References
    ----------
    Fitted to boundary elements, :func:`skewed_slip_ratios`.
    """
    sticks = share < 1.0
    inside = xp.where(sticks, share, 0.0)
    beyond = xp.where(sticks, 1.0, share)
    return xp.where(sticks, inside / (4.0 - 2.0 * inside), 1.0 - 0.5 / beyond**2)


def _scaled_forces(along: Real, across: Real, ratio: Real) -> tuple[Real, Real]:
    """Q_x/(mu N) and Q_y/(mu N) from the scaled creepages; ratio is xi_y,max over xi_x,max."""
    share = _length(along, across)
    turned = across * ratio ** turn_exponent(share)
    length = _length(along, turned)
    some = length > 0.0
    stretch = xp.where(some, share / xp.where(some, length, 1.0), 1.0)
    factor = _force_over_share(share) * stretch  # (B3)
    return factor * along, factor * turned


def _force_and_slope(along: Real, across: Real, ratio: Real) -> tuple[Real, Real]:
    """Q_x/(mu N) of :func:`_scaled_forces`, and its slope by the scaled creepage along, which has a length."""
    share = xp.sqrt(along * along + across * across)
    size, sticks = _force_over_share(share), share < 1.0
    growing = xp.where(sticks, -1.0, -size * size)
    turning = xp.where(sticks, 1.0, size * size * size) / xp.where(sticks, 2.0 - share, 1.0) ** 2
    turned = across * ratio ** turn_exponent(share)
    length = xp.sqrt(along * along + turned * turned)
    force = size * share * along / length
    by_share = along / share
    lengthening = (along + turned * turned * xp.log(ratio) * turning * by_share) / length
    slope = (growing * share + size) * by_share * along / length + (
        size * share - force * lengthening
    ) / length
    return force, slope


def skewed_slip_ratios(
    *,
    longitudinal_creepage: Real,
    lateral_creepage: Real,
    gross_slip_creepage: Real,
    lateral_gross_slip_creepage: Real,
) -> tuple[Real, Real]:
    r"""Tangential forces over friction from the creepages in both directions.

    .. math::
        \frac{\mathbf Q}{\mu N} = \left[1 - (1 - |\zeta|)^2\right]\frac{\mathbf d}{|\mathbf d|}, \qquad
        \zeta = \left(\frac{\xi_x}{\xi_{x,max}}, \frac{\xi_y}{\xi_{y,max}}\right), \qquad
        \mathbf d = \left(\zeta_x, \zeta_y \left[\frac{\xi_{y,max}}{\xi_{x,max}}\right]^w\right), \qquad
        w = \frac{|\zeta|}{4 - 2|\zeta|}

    and :math:`\mathbf d/|\mathbf d|` with :math:`w = 1 - 1/(2|\zeta|^2)` from :math:`|\zeta| = 1` on.

    Parameters
    ----------
    longitudinal_creepage, lateral_creepage : Real
        xi_x and xi_y, of either sign [-]; the skew angle of a roller is its xi_y.
    gross_slip_creepage, lateral_gross_slip_creepage : Real
        xi_x,max and xi_y,max, positive [-]: :func:`asperity.contact.carter.gross_slip_creepage` and that times
        :func:`lateral_compliance_ratio`.

    Returns
    -------
    tuple of Real
        Q_x/(mu N) and Q_y/(mu N) [-].

    Notes
    -----
    Exact in one direction alone (Carter), for little creepage, and far beyond gross slip, where the traction is
    opposite to the slip. Between these it is an approximation: against boundary elements (nu = 0.3) the vector of the
    force is within 0.006 mu N; with :math:`\mathbf d = \zeta` it would be up to 0.15 mu N off.

    References
    ----------
    The rule of P. J. Vermeulen and K. L. Johnson, J. Appl. Mech. 31 (1964) 338, for both creepages together, with
    Carter's curve; the direction is fitted to :mod:`asperity.bem.steady_rolling`. Equation (B3) of :doc:`/equations`.
    """
    along = longitudinal_creepage / gross_slip_creepage
    across = lateral_creepage / lateral_gross_slip_creepage
    return _scaled_forces(along, across, lateral_gross_slip_creepage / gross_slip_creepage)


def _share_at(magnitude: Real, across: Real, ratio: Real) -> Real:
    """Scaled longitudinal creepage x >= 0 that carries a force; bracketed Newton's method."""
    partial, skewed = 1.0 - xp.sqrt(1.0 - magnitude), across > 0.0
    across = xp.where(skewed, across, 1.0)
    sliding = across * ratio * magnitude / xp.sqrt(1.0 - magnitude**2)

    def improve(step: int, state: tuple[Real, ...]) -> tuple[Real, ...]:
        x, low, high, _ = state
        force, slope = _force_and_slope(x, across, ratio)
        low, high = xp.where(force < magnitude, x, low), xp.where(force < magnitude, high, x)
        newton = x + (magnitude - force) / xp.where(slope > 0.0, slope, 1.0)
        inside = (slope > 0.0) & (newton >= low) & (newton <= high)
        return xp.where(inside, newton, 0.5 * (low + high)), low, high, xp.abs(force - magnitude)

    # the force at this bound is at least the given one: partial slip without skew, or sliding the whole way
    high = xp.maximum(1.0, sliding)
    start = xp.clip(partial + 0.5 * across * magnitude, 0.0, high)
    start = xp.where(magnitude**2 + across**2 < 1.0, start, xp.maximum(start, sliding))
    begin = start, xp.zeros_like(start), high, xp.ones_like(start)
    creepage, *_ = fori_loop(0, _STEPS, improve, begin, settled=lambda _, after: is_rounding(after[3]))
    return xp.where(skewed, creepage, partial)


def skewed_contact(
    *,
    longitudinal_slip_ratio: Real,
    lateral_creepage: Real,
    gross_slip_creepage: Real,
    lateral_gross_slip_creepage: Real,
) -> SkewedContact:
    r"""Longitudinal creepage and lateral force of a skewed contact that carries a longitudinal force.

    Solves :func:`skewed_slip_ratios` for :math:`\xi_x`. In gross slip the direction of slip
    alone determines the longitudinal force.

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
    given, lateral, along_max, across_max = xp.broadcast_arrays(
        *(
            xp.asarray(v, dtype=float)
            for v in (
                longitudinal_slip_ratio,
                lateral_creepage,
                gross_slip_creepage,
                lateral_gross_slip_creepage,
            )
        )
    )
    ratio = across_max / along_max
    across = xp.abs(lateral) / across_max
    magnitude = xp.abs(given)
    carried = xp.where(across > 0.0, magnitude < 1.0, magnitude <= 1.0)
    safe = xp.where(carried, given, 0.0)
    share = implicit_root(
        lambda x: _scaled_forces(x, across, ratio)[0] - safe,
        xp.zeros_like(safe),
        lambda _, __: xp.sign(safe) * _share_at(*without_slopes((xp.abs(safe), across, ratio))),
        lambda linear, y: y / linear(xp.ones_like(y)),
    )
    longitudinal, sideways = _scaled_forces(share, lateral / across_max, ratio)
    return SkewedContact(
        longitudinal_creepage=xp.where(carried, share, xp.sign(given) * xp.inf) * along_max,
        lateral_creepage=lateral,
        longitudinal_slip_ratio=given,
        lateral_slip_ratio=xp.where(carried, sideways, 0.0),
        solved=carried & (xp.abs(longitudinal - safe) <= _RESIDUAL),
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


def longitudinal_capacity_ratio(
    *, lateral_creepage: Real, gross_slip_creepage: Real, lateral_gross_slip_creepage: Real
) -> Real:
    r"""Longitudinal force of a skewed contact at gross slip, relative to that without skew.

    .. math::
        \frac{Q_{x,max}}{\mu N} = \sqrt{\frac{1 - \zeta_y^2}{1 - \zeta_y^2 + \rho\,\zeta_y^2}}, \qquad
        \zeta_y = \frac{\xi_y}{\xi_{y,max}}, \quad \rho = \frac{\xi_{y,max}}{\xi_{x,max}}

    Parameters
    ----------
    lateral_creepage : Real
        xi_y, the skew angle, of either sign [-].
    gross_slip_creepage, lateral_gross_slip_creepage : Real
        xi_x,max and xi_y,max, positive [-].

    Returns
    -------
    Real
        Ratio [-]; 0 where the skew alone causes gross slip. The loss of capacity is 1 minus this ratio.

    References
    ----------
    :math:`|\zeta| = 1` in equation (B3) of :doc:`/equations`.
    """
    taken = (lateral_creepage / lateral_gross_slip_creepage) ** 2
    some = taken < 1.0
    left = xp.where(some, 1.0 - taken, 1.0)
    turned = taken * lateral_gross_slip_creepage / gross_slip_creepage  # w = 1/2 at |zeta| = 1
    return xp.where(some, xp.sqrt(left / (left + xp.where(some, turned, 0.0))), 0.0)
