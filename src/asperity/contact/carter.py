"""Creep of a rolling line contact under traction: steady, dry, bodies of equal elasticity (Carter's solution)."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.types import Real


def gross_slip_creepage(*, friction_coefficient: Real, half_width: Real, effective_radius: Real) -> Real:
    r"""Creepage at which gross slip of a rolling line contact begins.

    .. math:: \xi_{max} = \frac{\mu a}{R}

    Parameters
    ----------
    friction_coefficient : Real
        mu [-].
    half_width : Real
        Half-width a of the contact [m].
    effective_radius : Real
        Effective radius R of the pair [m].

    Returns
    -------
    Real
        Creepage [-], difference of the surface speeds over the rolling speed.

    Notes
    -----
    Half-plane (a much smaller than R), contact much longer than wide, Coulomb friction, bodies of like elasticity.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; K. L. Johnson, Contact Mechanics, 1985, section 8.3.
    Equation (B1) of :doc:`/equations`.

    Examples
    --------
    >>> ours = gross_slip_creepage(friction_coefficient=0.1, half_width=1.2247e-4, effective_radius=6.6667e-3)
    >>> f"{float(ours):.3e}"
    '1.837e-03'
    """
    return friction_coefficient * half_width / effective_radius


def creepage(*, slip_ratio: Real, gross_slip_creepage: Real) -> Real:
    r"""Creepage of a rolling line contact under a tangential force.

    .. math:: \xi = \xi_{max}\,\mathrm{sgn}(q)\left[1 - \sqrt{1 - |q|}\right], \quad q = \frac{Q}{\mu N}

    Parameters
    ----------
    slip_ratio : Real
        Tangential force over friction q = Q/(mu N), of either sign [-].
    gross_slip_creepage : Real
        xi_max [-], :func:`gross_slip_creepage`.

    Returns
    -------
    Real
        Creepage [-], odd in q; infinite where :math:`|q| > 1`, because no steady creepage carries that force.

    Notes
    -----
    Steady rolling: reached after about one contact width. The slope is finite through q = 0 and grows without
    bound towards :math:`|q| = 1`.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; K. L. Johnson, Contact Mechanics, 1985, section 8.3.
    Equation (B1) of :doc:`/equations`.
    """
    magnitude = xp.abs(slip_ratio)
    carried = magnitude <= 1.0
    safe = xp.where(carried, magnitude, 0.0)
    steady = slip_ratio / (1.0 + xp.sqrt(1.0 - safe))  # (B1), accurate also at small q
    return gross_slip_creepage * xp.where(carried, steady, xp.sign(slip_ratio) * xp.inf)


def slip_ratio_at_creepage(*, creepage: Real, gross_slip_creepage: Real) -> Real:
    r"""Tangential force over friction of a line contact that rolls with a creepage.

    .. math:: q = \mathrm{sgn}(\xi)\left[1 - \left(1 - \frac{|\xi|}{\xi_{max}}\right)^2\right],
              \quad |q| = 1 \text{ for } |\xi| \ge \xi_{max}

    Parameters
    ----------
    creepage : Real
        Creepage xi, of either sign [-].
    gross_slip_creepage : Real
        xi_max [-], :func:`gross_slip_creepage`; 0 where there is no contact.

    Returns
    -------
    Real
        Q/(mu N) [-].

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; equation (B1) of :doc:`/equations`, inverted.
    """
    sticks = xp.abs(creepage) < gross_slip_creepage
    share = xp.where(sticks, creepage, 0.0) / xp.where(sticks, gross_slip_creepage, 1.0)
    return xp.where(sticks, share * (2.0 - xp.abs(share)), xp.sign(creepage))


def stick_half_width(*, slip_ratio: Real, half_width: Real) -> Real:
    r"""Half-width of the stick zone of a rolling line contact, :math:`c = a\sqrt{1 - |q|}`.

    Parameters
    ----------
    slip_ratio : Real
        Q/(mu N), of either sign [-].
    half_width : Real
        Half-width a of the contact [m].

    Returns
    -------
    Real
        Half-width of the stick zone [m]; 0 from gross slip on.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 8.3; equation (B2) of :doc:`/equations`.
    """
    remaining = 1.0 - xp.abs(slip_ratio)
    sticks = remaining > 0.0
    return xp.where(sticks, half_width * xp.sqrt(xp.where(sticks, remaining, 1.0)), 0.0)


def stick_centre(*, slip_ratio: Real, half_width: Real) -> Real:
    r"""Middle of the stick zone, which begins at the leading edge: :math:`d = a - c`.

    Parameters
    ----------
    slip_ratio : Real
        Q/(mu N), of either sign [-].
    half_width : Real
        Half-width a of the contact [m].

    Returns
    -------
    Real
        Distance from the middle of the contact towards the leading edge [m].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 8.3; equation (B2) of :doc:`/equations`.
    """
    return half_width - stick_half_width(slip_ratio=slip_ratio, half_width=half_width)


def rolling_traction(
    *, position: Real, slip_ratio: Real, half_width: Real, peak_pressure: Real, friction_coefficient: Real
) -> Real:
    r"""Shear traction across a rolling line contact.

    .. math::
        q(x) = \mathrm{sgn}(q)\,\mu p_0 \left[\sqrt{1 - \frac{x^2}{a^2}}
               - \frac ca \sqrt{1 - \frac{(x-d)^2}{c^2}}\right]

    with the second term inside the stick zone only, and 0 outside the contact.

    Parameters
    ----------
    position : Real
        Distance x from the middle of the contact, positive towards the leading edge [m].
    slip_ratio : Real
        Q/(mu N), of either sign [-].
    half_width : Real
        Half-width a of the contact [m].
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
    K. L. Johnson, Contact Mechanics, 1985, section 8.3; equation (B2) of :doc:`/equations`.
    """
    stick = stick_half_width(slip_ratio=slip_ratio, half_width=half_width)

    def ellipse(place: Real, width: Real) -> Real:
        inside = xp.abs(place) < width
        height = xp.where(inside, 1.0 - (place / xp.where(inside, width, 1.0)) ** 2, 1.0)
        return xp.where(inside, xp.sqrt(height), 0.0)

    shape = ellipse(position, half_width) - stick / half_width * ellipse(
        position - (half_width - stick), stick
    )  # (B2)
    return xp.sign(slip_ratio) * friction_coefficient * peak_pressure * shape
