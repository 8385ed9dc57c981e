"""Viscosity of an oil over pressure and temperature, and the pressure coefficient that a film feels."""

from __future__ import annotations

import math

import numpy as np

from asperity.engine.arrays import xp
from asperity.engine.control import once
from asperity.engine.module import Module
from asperity.types import Array, Real

#: Roelands's pressure [1/Pa] and the logarithm of his viscosity of 6.315e-5 Pa s, with the sign changed.
_ROELANDS_COMPRESSION, _ROELANDS_LOGARITHM = 5.1e-9, 9.67

#: What Walther's equation adds to a kinematic viscosity above 2 mm^2/s [mm^2/s].
_WALTHER_OFFSET = 0.7

#: Nodes between no pressure and the peak, at which the reciprocal viscosity is integrated.
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(48)


class ExponentialViscosity(Module):
    r"""Viscosity without pressure over temperature, :math:`\eta_0 = K e^{C/(T + D)}`.

    Parameters
    ----------
    scale, rise, shift : Real
        K [Pa·s], C [K] and D [K].
    """

    scale: Real
    rise: Real
    shift: Real

    def at(self, temperature: Real) -> Array:
        """Viscosity at a temperature [K], in Pa·s."""
        return xp.asarray(self.scale * xp.exp(self.rise / (temperature + self.shift)))

    def logarithmic_fall(self, temperature: Real) -> Array:
        r"""Share by which it falls per kelvin, :math:`-d \ln \eta_0/dT` [1/K]."""
        return xp.asarray(self.rise / (temperature + self.shift) ** 2)


class WaltherViscosity(Module):
    r"""Viscosity without pressure over temperature, :math:`\eta_0 = \rho(T)\,(10^{10^{A - B \lg T}} - c)`.

    Parameters
    ----------
    intercept, slope, offset : Real
        A and B [-], and c [mm^2/s].
    density, density_fall : Real
        Density at the reference temperature [kg/m^3], and its fall per kelvin [kg/(m^3 K)].
    reference_temperature : Real
        Temperature of that density [K].
    """

    intercept: Real
    slope: Real
    offset: Real
    density: Real
    density_fall: Real
    reference_temperature: Real

    def at(self, temperature: Real) -> Array:
        """Viscosity at a temperature [K], in Pa·s."""
        kinematic = self._shifted(temperature) - self.offset
        return 1e-6 * self._density(temperature) * kinematic

    def logarithmic_fall(self, temperature: Real) -> Array:
        r"""Share by which it falls per kelvin, :math:`-d \ln \eta_0/dT` [1/K]."""
        shifted = self._shifted(temperature)
        steep = shifted * xp.log(shifted) * self.slope / temperature
        return steep / (shifted - self.offset) + self.density_fall / self._density(temperature)

    def _density(self, temperature: Real) -> Array:
        """Density at a temperature [kg/m^3]."""
        return xp.asarray(self.density - self.density_fall * (temperature - self.reference_temperature))

    def _shifted(self, temperature: Real) -> Array:
        """Kinematic viscosity and the offset [mm^2/s]."""
        doubly: Array = 10.0 ** (10.0 ** (self.intercept - self.slope * xp.log(temperature) / math.log(10.0)))
        return doubly


def walther_viscosity(*, viscosity_40: Real, viscosity_100: Real, density: Real) -> WaltherViscosity:
    r"""Walther's equation through the viscosities at 40 and 100 degrees Celsius.

    .. math:: B = \frac{\lg\lg Z_{40} - \lg\lg Z_{100}}{\lg T_{100} - \lg T_{40}}, \qquad
              A = \lg\lg Z_{40} + B \lg T_{40}, \qquad Z = \nu/(1\,\mathrm{mm^2/s}) + 0.7

    Parameters
    ----------
    viscosity_40, viscosity_100 : Real
        Kinematic viscosities at 313.15 K and 373.15 K, the first one above the second [m^2/s].
    density : Real
        Density, taken to be the same at all temperatures [kg/m^3].

    Returns
    -------
    WaltherViscosity
        Of the oil; 0.7 holds for viscosities above 2 mm^2/s.

    References
    ----------
    ASTM D341; equation (F1) of :doc:`/equations`.

    Examples
    --------
    >>> oil = walther_viscosity(viscosity_40=100e-6, viscosity_100=11e-6, density=880.0)
    >>> round(float(oil.at(313.15)), 9), round(float(oil.at(373.15)), 9)
    (0.088, 0.00968)
    """
    cold, warm = 313.15, 373.15
    first, second = (_twice(1e6 * viscosity + _WALTHER_OFFSET) for viscosity in (viscosity_40, viscosity_100))
    slope = (first - second) / (math.log10(warm) - math.log10(cold))
    intercept = first + slope * math.log10(cold)
    return WaltherViscosity(intercept, slope, _WALTHER_OFFSET, density, 0.0, cold)


def _twice(value: Real) -> Array:
    """The common logarithm of the common logarithm."""
    return xp.log(xp.log(xp.asarray(value)) / math.log(10.0)) / math.log(10.0)


class RationalPressureRise(Module):
    r"""Rise with pressure, :math:`\ln(\eta/\eta_0) = p/(A + B p)`, :math:`A = a_1 + a_2 T`, :math:`B = b_1 + b_2 T`.

    Parameters
    ----------
    stiffness, stiffness_rise : Real
        a_1 [Pa] and a_2 [Pa/K].
    share, share_rise : Real
        b_1 [-] and b_2 [1/K].
    """

    stiffness: Real
    stiffness_rise: Real
    share: Real
    share_rise: Real

    def logarithm(self, pressure: Real, temperature: Real, viscosity: Real) -> Array:
        """ln(eta/eta_0) at a pressure [Pa] and a temperature [K]; the viscosity without pressure does not count."""
        scale = once(self.stiffness + self.stiffness_rise * temperature)
        return xp.asarray(pressure / (scale + once(self.share + self.share_rise * temperature) * pressure))


class RoelandsPressureRise(Module):
    r"""Rise with pressure after Roelands, for a pressure coefficient that falls with temperature.

    .. math::
        \ln\frac{\eta}{\eta_0} = (\ln\eta_0 + 9.67)\left[(1 + 5.1\cdot10^{-9} p)^Z - 1\right], \qquad
        Z = \frac{\alpha}{5.1\cdot10^{-9}(\ln\eta_0 + 9.67)}, \qquad
        \alpha = \alpha_{ref}\, e^{-k (T - T_{ref})}

    Parameters
    ----------
    coefficient : Real
        Pressure coefficient alpha without pressure at the reference temperature [1/Pa].
    fall : Real
        k [1/K]; 0 for a coefficient that is the same at all temperatures.
    reference_temperature : Real
        T_ref [K].
    """

    coefficient: Real
    fall: Real
    reference_temperature: Real

    def logarithm(self, pressure: Real, temperature: Real, viscosity: Real) -> Array:
        """ln(eta/eta_0) at a pressure [Pa] and a temperature [K], of a viscosity eta_0 without pressure [Pa·s]."""
        alpha = self.coefficient * xp.exp(-self.fall * (temperature - self.reference_temperature))
        return _roelands(pressure, alpha, viscosity)


class EstimatedPressureRise(Module):
    r"""Rise with pressure after Roelands, for a pressure coefficient that follows from the viscosity without pressure.

    .. math:: \alpha = k\,\left(\eta_0 / 1\,\mathrm{Pa\,s}\right)^s

    Parameters
    ----------
    scale, exponent : Real
        k [1/Pa] and s [-].

    Notes
    -----
    ANSI/AGMA 925-A03 gives 10.471e-9 1/Pa and 0.1348 for the viscosity of mineral oils in mPa·s.
    """

    scale: Real
    exponent: Real

    def logarithm(self, pressure: Real, temperature: Real, viscosity: Real) -> Array:
        """ln(eta/eta_0) at a pressure [Pa] of a viscosity eta_0 without pressure [Pa·s]."""
        return _roelands(pressure, self.scale * xp.asarray(viscosity) ** self.exponent, viscosity)


#: Pressure coefficient of paraffinic mineral oils by their viscosity, ANSI/AGMA 925-A03.
MINERAL_OIL_RISE = EstimatedPressureRise(10.471e-9 * 1000.0**0.1348, 0.1348)


def _roelands(pressure: Real, coefficient: Real, viscosity: Real) -> Array:
    """ln(eta/eta_0) by Roelands's law of a pressure coefficient [1/Pa]."""
    height = once(xp.log(viscosity) + _ROELANDS_LOGARITHM)
    exponent = once(coefficient / (_ROELANDS_COMPRESSION * height))
    return height * xp.expm1(exponent * xp.log1p(_ROELANDS_COMPRESSION * pressure))


class Viscosity(Module):
    r"""Viscosity of an oil, :math:`\eta(p, T) = \eta_0(T)\, e^{\ln(\eta/\eta_0)(p, T)}`.

    Parameters
    ----------
    without_pressure : ExponentialViscosity or WaltherViscosity
        eta_0 over the temperature.
    pressure_rise : RationalPressureRise or RoelandsPressureRise
        ln(eta/eta_0) over pressure and temperature.

    References
    ----------
    C. J. A. Roelands, dissertation, TU Delft 1966; A. Arana et al., Proc. IMechE J 233 (2019) 303 (the rational rise);
    ASTM D341 (Walther's equation). Equation (F1) of :doc:`/equations`.
    """

    without_pressure: ExponentialViscosity | WaltherViscosity
    pressure_rise: RationalPressureRise | RoelandsPressureRise | EstimatedPressureRise

    def base(self, temperature: Real) -> Array:
        """Viscosity eta_0 without pressure at a temperature [K], in Pa·s."""
        return self.without_pressure.at(temperature)

    def logarithmic_rise(self, pressure: Real, temperature: Real) -> Array:
        """ln(eta/eta_0) at a pressure [Pa] and a temperature [K]."""
        return self.pressure_rise.logarithm(pressure, temperature, self.base(temperature))

    def at(self, pressure: Real, temperature: Real) -> Array:
        """Viscosity at a pressure [Pa] and a temperature [K], in Pa·s."""
        return self.base(temperature) * xp.exp(self.logarithmic_rise(pressure, temperature))


def reciprocal_asymptotic_coefficient(
    *, viscosity: Viscosity, peak_pressure: Array, temperature: Real
) -> Array:
    r"""Pressure coefficient of the viscosity by which a film is dragged into the contact.

    .. math:: \frac1{\alpha^*} = \int_0^{p_0} \frac{\eta_0}{\eta(p)}\,dp

    Parameters
    ----------
    viscosity : Viscosity
        The law of the oil.
    peak_pressure : Array
        Peak pressure p_0 of the contact, positive, shape (...) [Pa].
    temperature : Real
        Temperature at the inlet [K].

    Returns
    -------
    Array
        Coefficient, shape (...) [1/Pa].

    Notes
    -----
    The integral by 48 Gauss points; the local slope of the law without pressure is larger by up to a third.

    References
    ----------
    H. Blok, 1963; I. Bair, High-Pressure Rheology for Quantitative Elastohydrodynamics, 2007. Equation (F1) of
    :doc:`/equations`.
    """
    pressure = xp.asarray(peak_pressure)
    shares, weights = (
        xp.asarray(column).reshape(-1, *(1 for _ in pressure.shape))
        for column in (0.5 * (1.0 + _NODES), _WEIGHTS)
    )
    thickened = weights * xp.exp(-viscosity.logarithmic_rise(shares * pressure, temperature))
    return 2.0 / (pressure * thickened.sum(axis=0))
