"""An oil as contacts see it: viscosity, the shear stress that its film bears, how the film yields and conducts heat."""

from __future__ import annotations

import math
from typing import Literal

from asperity.contact.measured_traction import MeasuredTraction, TractionTable
from asperity.contact.viscosity import Viscosity
from asperity.engine.arrays import xp
from asperity.engine.control import once
from asperity.engine.derivatives import with_rule
from asperity.engine.module import Module, static
from asperity.types import Array, Real

#: How the film yields below its limit: thinning by Eyring's law, or Newton's flow up to the limit.
ShearLaw = Literal["eyring", "limit"]


class Film(Module):
    """The film of a rolling contact that slips, of which its oil tells what shear stress it bears. SI units.

    Parameters
    ----------
    pressure : Real
        Pressure on the film at places across the contact, shape (places, contacts, ...) [Pa].
    peak_pressure : Real
        Largest pressure on the film, shape (contacts, ...) [Pa].
    thickness : Real
        Central thickness [m].
    slip_speed : Real
        Difference of the surface speeds, positive [m/s].
    temperature, oil_temperature : Real
        Of the film, and of the oil before its slip has warmed it [K].
    rolling_speed : Real
        Mean speed of the surfaces [m/s].
    """

    pressure: Real
    peak_pressure: Real
    thickness: Real
    slip_speed: Real
    temperature: Real
    oil_temperature: Real
    rolling_speed: Real


class FilmBody(Module):
    """What makes a film yield elastically: its thickness between the bodies of a contact. SI units.

    Parameters
    ----------
    thickness : Real
        Central thickness of the film [m].
    half_width, peak_pressure, contact_modulus : Real
        Of the contact under its whole load: a [m], p_0 and E* [Pa], all of shape (contacts, ...).
    oil_temperature, rolling_speed : Real
        Of the oil [K], and mean speed of the surfaces [m/s].
    """

    thickness: Real
    half_width: Real
    peak_pressure: Real
    contact_modulus: Real
    oil_temperature: Real
    rolling_speed: Real


class LimitingTraction(Module):
    r"""Largest shear stress of a film, :math:`\tau_L = \left(\Lambda + \Lambda_T\,t\right) p + \tau_0 + \tau_T\,t`.

    With :math:`t = T - T_{ref}`, not below 0.

    Parameters
    ----------
    share : Real
        Lambda, of the pressure [-].
    share_rise, stress, stress_rise, reference_temperature : Real, optional
        Lambda_T [1/K], tau_0 [Pa], tau_T [Pa/K] and T_ref [K]; by default a share of the pressure alone.
    """

    share: Real
    share_rise: Real = 0.0
    stress: Real = 0.0
    stress_rise: Real = 0.0
    reference_temperature: Real = 273.15

    def at(self, pressure: Real, temperature: Real) -> Array:
        """Shear stress at a pressure [Pa] and a temperature [K], in Pa."""
        warm = temperature - self.reference_temperature
        limit = (self.share + self.share_rise * warm) * pressure + self.stress + self.stress_rise * warm
        return xp.maximum(limit, 0.0)


class RheologicalTraction(Module):
    r"""Traction of a film by the rheology of its oil.

    .. math::
        \tau_f = \left(\tau_v^{-8} + \tau_L^{-8}\right)^{-1/8}, \qquad
        \tau_v = \tau_E \operatorname{asinh}\frac{\eta\,v}{h \tau_E} \;\text{or}\; \frac{\eta\,v}{h}

    with Eyring's stress :math:`\tau_E = 2\tau_L/(\alpha_s p)`, :math:`\alpha_s = \ln(\eta/\eta_0)/p` at the peak.

    Parameters
    ----------
    limiting_traction : LimitingTraction
        Largest shear stress tau_L.
    shear_modulus : Real
        Of the film under pressure, G [Pa].
    shear_law : ShearLaw
        How the film yields below its limit.

    References
    ----------
    K. L. Johnson and J. L. Tevaarwerk, Proc. R. Soc. A 356 (1977) 215; A. Arana et al., Proc. IMechE J 233 (2019) 303.
    Equation (F4) of :doc:`/equations`.
    """

    limiting_traction: LimitingTraction
    shear_modulus: Real
    shear_law: ShearLaw = static(default="eyring")

    def stress(self, viscosity: Viscosity, film: Film) -> tuple[Array, Array]:
        """Shear stress at the places [Pa], and the slope of its logarithm over that of the slip [-]."""
        temperature, peak = film.temperature, film.peak_pressure
        limit = self.limiting_traction.at(film.pressure, temperature)
        rise = viscosity.logarithmic_rise(film.pressure, temperature)
        newton = once(viscosity.base(temperature) * film.slip_speed / film.thickness) * xp.exp(rise)
        if self.shear_law == "limit":
            viscous, slope = newton, xp.ones_like(newton)
        else:
            thickening = viscosity.logarithmic_rise(peak, temperature)
            eyring = 2.0 * self.limiting_traction.at(peak, temperature) / thickening
            ratio = newton / eyring
            viscous = eyring * xp.arcsinh(ratio)
            slope = newton / (xp.sqrt(1.0 + ratio**2) * viscous)
        stress, share = smooth_minimum(viscous, limit)
        return stress, share * slope

    def elastic_yield(self, body: FilmBody) -> Array:
        r"""Creepage that the elastic film adds over that of the bodies, :math:`\frac\pi4\frac{E^* h}{a G}` [-]."""
        thickness = body.contact_modulus * body.thickness
        return xp.asarray(0.25 * math.pi * thickness / (body.half_width * self.shear_modulus))


class DataSheetTraction(Module):
    r"""Traction of a film by maximum and first slope of a measured curve: elastic up to a share of the pressure.

    .. math:: \tau_f = \Lambda p, \qquad f_F - 1 = \frac{E^*}{p_0 m_F}

    Parameters
    ----------
    maximum_traction : Real or TractionTable
        Lambda, the largest traction coefficient [-].
    film_slope : Real or TractionTable
        m_F, slope of the traction coefficient over the creepage of the film alone, its bodies' part taken off [-].

    References
    ----------
    K. L. Johnson and J. L. Tevaarwerk, Proc. R. Soc. A 356 (1977) 215, their elastic-plastic film; equation (F4) of
    :doc:`/equations`.
    """

    maximum_traction: Real | TractionTable
    film_slope: Real | TractionTable

    def stress(self, viscosity: Viscosity, film: Film) -> tuple[Array, Array]:
        """Shear stress at the places [Pa], and the slope of its logarithm over that of the slip [-], which is 0."""
        largest = _sheet_value(self.maximum_traction, film)
        stress = xp.asarray(largest * film.pressure) + 0.0 * film.slip_speed
        return stress, 0.0 * stress

    def elastic_yield(self, body: FilmBody) -> Array:
        r"""Creepage that the elastic film adds over that of the bodies [-]."""
        return xp.asarray(body.contact_modulus / (body.peak_pressure * _sheet_value(self.film_slope, body)))


def _sheet_value(stated: Real | TractionTable, contact: Film | FilmBody) -> Real:
    """A number of a data sheet under the conditions of a contact [-]."""
    if isinstance(stated, TractionTable):
        return stated.at(contact.peak_pressure, contact.oil_temperature, contact.rolling_speed)
    return stated


#: What a film does when it is sheared.
FilmTraction = RheologicalTraction | DataSheetTraction | MeasuredTraction


class Fluid(Module):
    """What the film of an oil does in a contact. SI units.

    Parameters
    ----------
    viscosity : Viscosity
        Over pressure and temperature.
    traction : FilmTraction or None
        Shear stress of the film, and how it yields elastically; None where nothing is known of it.
    conductivity : Real
        Thermal conductivity of the film [W/(m K)].
    """

    viscosity: Viscosity
    traction: FilmTraction | None
    conductivity: Real


def film_slope(*, slope: Real, rig_modulus: Real, rig_peak_pressure: Real) -> Real:
    r"""Slope of the traction curve of a film alone, without what the discs of the rig give way.

    .. math:: \frac1{m_F} = \frac1m - \frac{p_{0,rig}}{E^*_{rig}}

    Parameters
    ----------
    slope : Real
        Measured slope m of the traction coefficient over the slide-roll ratio, which counts the discs [-].
    rig_modulus, rig_peak_pressure : Real
        E* of the discs and their peak pressure [Pa].

    Returns
    -------
    Real
        m_F [-]; not positive where the measured slope is steeper than that of the discs alone.

    References
    ----------
    Carter's slope of the discs, :math:`E^*/p_0`; equation (F4) of :doc:`/equations`.

    Examples
    --------
    >>> round(film_slope(slope=55.0, rig_modulus=113.19e9, rig_peak_pressure=1.5e9))
    203
    """
    return 1.0 / (1.0 / slope - rig_peak_pressure / rig_modulus)


@with_rule
def smooth_minimum(one: Array, other: Array) -> tuple[Array, Array]:
    r"""The lower one of two stresses, smoothly, :math:`(a^{-8} + b^{-8})^{-1/8}`.

    Parameters
    ----------
    one, other : Array
        a, positive, and b, not negative, of one shape [Pa].

    Returns
    -------
    tuple of Array
        Stress [Pa], and the slope of its logarithm over that of a [-].

    References
    ----------
    Equation (F4) of :doc:`/equations`.
    """
    positive = other > 0.0
    ratio = one / xp.where(positive, other, 1.0)
    below = ratio < 1.0
    # the larger of both in the denominator
    square = xp.where(below, ratio, 1.0 / xp.where(below, 1.0, ratio)) ** 2
    small = square * square
    small = small * small
    lower = xp.where(below, one, other)
    stress = lower / xp.sqrt(xp.sqrt(xp.sqrt(1.0 + small)))
    return xp.where(positive, stress, 0.0), xp.where(below, 1.0, small) / (1.0 + small)


@smooth_minimum.defjvp
def _smooth_minimum_jvp(
    primals: tuple[Array, Array], tangents: tuple[Array, Array]
) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """By the logarithms a and b of both: the share of a, 1 less it of b; it is a logistic function of 8 (b - a)."""
    (one, other), (moved, shifted) = primals, tangents
    stress, share = smooth_minimum(one, other)
    positive = other > 0.0
    rest, by_one = 1.0 - share, moved / one
    by_other = xp.where(positive, shifted / xp.where(positive, other, 1.0), 0.0)
    slope = stress * (share * by_one + rest * by_other)
    return (stress, share), (slope, 8.0 * share * rest * (by_other - by_one))
