"""Losses of a rolling line contact: creep, elastic hysteresis, oil at the inlet."""

from __future__ import annotations

import math

from asperity.engine.arrays import xp
from asperity.types import Real


def creep_power(*, tangential_force: Real, creepage: Real, rolling_speed: Real) -> Real:
    r"""Power lost by creep, :math:`P = Q\,\xi\,V`, all of it heat.

    Parameters
    ----------
    tangential_force : Real
        Q [N].
    creepage : Real
        xi of the same sign [-].
    rolling_speed : Real
        Rolling speed V >= 0 [m/s].

    Returns
    -------
    Real
        Power [W].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 8.3; equation (B9) of :doc:`/equations`.
    """
    return tangential_force * creepage * rolling_speed


def hysteresis_moment(*, loss_factor: Real, normal_force: Real, half_width: Real) -> Real:
    r"""Moment by which elastic hysteresis resists the rolling of both bodies.

    .. math:: h = \alpha\,\frac{2a}{3\pi}\,N

    The pressure is shifted towards the inlet by h/N: it turns the two bodies with h in opposite senses, and the power
    :math:`P = h\,(V_1/R_1 \pm V_2/R_2)` is lost, which is :math:`\alpha\,\frac{2a}{3\pi R}\,N V` without creep.

    Parameters
    ----------
    loss_factor : Real
        Hysteresis loss factor alpha, share of the elastic work that is lost [-]; 0.005 to 0.05 for hardened steel.
    normal_force : Real
        N [N].
    half_width : Real
        Half-width a of the contact [m].

    Returns
    -------
    Real
        Moment [N·m].

    Notes
    -----
    The pressure on the front half does the work :math:`2aN/(3\pi R)` per length rolled.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 9.6; equation (B9) of :doc:`/equations`.
    """
    return loss_factor * 2.0 * half_width / (3.0 * math.pi) * normal_force


def inlet_rolling_force(
    *,
    viscosity: Real,
    entrainment_speed: Real,
    line_load: Real,
    effective_radius: Real,
    contact_modulus: Real,
) -> Real:
    r"""Rolling force of the oil at the inlet on each surface, per length, fully flooded and isothermal.

    .. math::
        \frac{f}{E'R} = \frac{1.42\sqrt{UW}}{\left[1 + \left(\frac{1.4}{1.45}\sqrt M\right)^{10}\right]^{1/10}},
        \qquad U = \frac{2\eta_0\bar u}{E'R}, \; W = \frac{P'}{E'R}, \; M = \frac{W}{\sqrt U}, \; E' = 2E^*

    Parameters
    ----------
    viscosity : Real
        Viscosity eta_0 of the oil at the inlet [Pa s].
    entrainment_speed : Real
        Mean surface speed u > 0 [m/s].
    line_load : Real
        Normal force per length P' [N/m].
    effective_radius : Real
        Effective radius R [m].
    contact_modulus : Real
        Contact modulus E* [Pa].

    Returns
    -------
    Real
        Force per length [N/m]; :math:`1.47\,U^{3/4}E'R`, independent of the load, where the bodies deform.

    Notes
    -----
    Fitted for M from 0.2 to 200 and :math:`(\alpha E')U^{1/4}` from 4 to 16; starved or hot inlets give less.

    References
    ----------
    N. Biboulet and L. Houpert, Proc. IMechE J 224 (2010) 765, equations (14), (40)–(42); equation (B9) of
    :doc:`/equations`.
    """
    scale = 2.0 * contact_modulus * effective_radius
    speed = 2.0 * viscosity * entrainment_speed / scale
    load = line_load / scale
    stiffness = (1.4 / 1.45) * xp.sqrt(load / xp.sqrt(speed))
    return 1.42 * xp.sqrt(speed * load) / (1.0 + stiffness**10) ** 0.1 * scale  # (B9)


def inlet_rolling_power(*, rolling_force: Real, contact_length: Real, entrainment_speed: Real) -> Real:
    r"""Power lost by the oil at the inlet, :math:`P = 2 f B \bar u`.

    Parameters
    ----------
    rolling_force : Real
        Force per length f on each surface [N/m], :func:`inlet_rolling_force`.
    contact_length : Real
        Contact line length B [m].
    entrainment_speed : Real
        Mean surface speed u [m/s].

    Returns
    -------
    Real
        Power [W].

    References
    ----------
    N. Biboulet and L. Houpert, Proc. IMechE J 224 (2010) 765, section 3.6; equation (B9) of :doc:`/equations`.
    """
    return 2.0 * rolling_force * contact_length * entrainment_speed
