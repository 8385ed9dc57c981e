"""Shear stress of asperities and oil film in a contact that slips evenly, and the heat that softens the film."""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

from asperity.contact.creep_bounds import elliptic_stress, width_mean
from asperity.contact.fluid import Film, FilmTraction, Fluid
from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.implicit import elementwise_root
from asperity.types import Array, Real

#: Warming of a film up to which its temperature is sought; beyond, nothing is known of it [K].
MOST_WARMING = 1000.0
#: Relative change of it after which Newton's next one, its square, is not taken [-].
_SMALL_WARMING = 1e-5

#: Share of the sources' mean rise in the largest, and of the film's own in its middle, in the mean temperature.
_SURFACE_SHARE, _FILM_SHARE = 2.0 / 3.0, 1.0 / 12.0


class BoundaryFriction(Module):
    r"""Friction coefficient of the asperities over the speed at which they slip.

    .. math:: \mu_b(v) = \mu_0 + \sum_i \frac{\mu_i - \mu_{i-1}}{\ln v_i - \ln v_{i-1}}
              \operatorname{clip}(\ln v - \ln v_{i-1};\, 0,\, \ln v_i - \ln v_{i-1})

    Parameters
    ----------
    coefficient : Real
        mu_0 at the first speed and below, shape (contacts, ...) or () [-].
    speeds, coefficients : tuple of Real, optional
        Speeds v_0, v_1, ... in rising order [m/s] and coefficients there [-], the first one ``coefficient``; between
        them the coefficient goes with the logarithm of the speed, and beyond them it stays. Empty for a constant.
    """

    coefficient: Real
    speeds: tuple[Real, ...] = ()
    coefficients: tuple[Real, ...] = ()

    def at(self, slip_speed: Real) -> tuple[Array, Array]:
        """Coefficient at slip speeds [m/s], and its slope over their logarithm [-]."""
        speed = xp.log(xp.asarray(slip_speed))
        coefficient: Array = xp.asarray(self.coefficient) + 0.0 * speed
        slope = 0.0 * coefficient
        ends = [xp.log(xp.asarray(end)) for end in self.speeds]
        for (low, high), (first, last) in zip(
            itertools.pairwise(ends), itertools.pairwise(self.coefficients), strict=True
        ):
            steep = (last - first) / (high - low)
            coefficient = coefficient + steep * xp.clip(speed - low, 0.0, high - low)
            slope = slope + xp.where((speed >= low) & (speed < high), steep, 0.0)
        return coefficient, slope


class MixedContact(Module):
    r"""A rolling line contact with asperities and film under its load. SI units, shape (contacts, ...).

    Parameters
    ----------
    fluid : Fluid
        The oil.
    friction : BoundaryFriction
        Of the asperities.
    asperity_share, film_share : Array
        Shares of the load [-].
    film_thickness : Array
        Central thickness of the film [m].
    half_width, peak_pressure, contact_length, contact_modulus : Real
        a [m], p_0 [Pa], B [m] and E* [Pa].
    rolling_speed : Real
        Mean speed V > 0 of the surfaces relative to the contact [m/s].
    oil_temperature : Real
        At the inlet [K].
    effusivity : Real
        :math:`\sqrt{k \rho c}` of the bodies, their mean [W s^0.5/(m^2 K)]; infinite to leave out the heat of the
        surfaces.
    lateral_creepage : Real or None, optional
        Creepage across the rolling direction over how much further the bodies give way that way [-]; None for parallel
        axes.
    lateral_ratio : Real, optional
        How much further they give way across [-].
    sliced : bool, optional
        Whether the first axis of all arrays belongs to slices of the contacts, which share their creepages.
    """

    fluid: Fluid
    friction: BoundaryFriction
    asperity_share: Array
    film_share: Array
    film_thickness: Array
    half_width: Real
    peak_pressure: Real
    contact_length: Real
    contact_modulus: Real
    rolling_speed: Real
    oil_temperature: Real
    effusivity: Real
    lateral_creepage: Real | None = None
    lateral_ratio: Real = 1.0
    sliced: bool = static(default=False)

    def total(self, of_slices: Array) -> Array:
        """Forces of whole contacts from those of their slices."""
        return of_slices.sum(axis=0) if self.sliced else of_slices

    @property
    def traction(self) -> FilmTraction:
        """What the film does when it is sheared, which is known of the oil of such a contact."""
        assert self.fluid.traction is not None
        return self.fluid.traction


class EvenSlip(NamedTuple):
    """Traction of a contact whose bodies were rigid: slip is the same everywhere.

    ``stress``: at the places of half of the width, shape (places, contacts, ...), and ``mean`` [Pa]; ``force`` [N];
    ``exponent``, slope of its logarithm over that of the slip at one temperature [-]; ``heated``: warming of the film
    by it [K]; ``creepage``, at which it slips [-].
    """

    stress: Array
    mean: Array
    force: Array
    exponent: Array
    heated: Array
    creepage: Array


def even_slip(*, contact: MixedContact, creepage: Array, guess: Array | float = 0.0) -> EvenSlip:
    r"""Traction of a contact between rigid bodies at a creepage.

    .. math::
        \tau(x) = \mu_b(\xi V)\,A\,p(x) + \tau_f(x), \qquad T_0 = B \int_{-a}^{a} \tau\,dx, \qquad
        \Delta T = \frac{\xi V T_0}{2 a B}\left[\frac23 \frac{\sqrt{2a/\pi V}}{\sqrt{k\rho c}}
        + \frac{h}{12 k_f}\right]

    Parameters
    ----------
    contact : MixedContact
        The contact.
    creepage : Array
        xi, positive, shape (contacts, ...) [-].
    guess : Array or float, optional
        Warming of the film from which its own is sought [K].

    Returns
    -------
    EvenSlip
        At the temperature of the film that its heat makes: the heat falls with the temperature, so that there is one.
        nan where it would warm by more than 1000 K.

    References
    ----------
    Equation (F4) of :doc:`/equations`.
    """
    nothing = xp.zeros_like(creepage * contact.film_thickness)
    ends = nothing, nothing + MOST_WARMING
    warming = elementwise_root(
        _warmer_than_heated, (contact, creepage), *ends, nothing + guess, small_step=_SMALL_WARMING
    )
    warming = xp.where(warming < MOST_WARMING, warming, xp.nan)
    return slip_at_warming(contact=contact, creepage=creepage, warming=warming)


def _warmer_than_heated(given: tuple[MixedContact, Array], warming: Array) -> Array:
    """By how much a warming of the film exceeds that of its heat [K]."""
    contact, creepage = given
    return warming - slip_at_warming(contact=contact, creepage=creepage, warming=warming).heated


def slip_at_warming(*, contact: MixedContact, creepage: Array, warming: Array) -> EvenSlip:
    """Traction of a contact between rigid bodies at a creepage and a given warming of its film.

    Parameters
    ----------
    contact : MixedContact
        The contact.
    creepage : Array
        xi, positive, shape (contacts, ...) [-].
    warming : Array
        Of the film, of the same shape [K].

    Returns
    -------
    EvenSlip
        As of :func:`even_slip`; ``heated`` is what its heat would warm the film by.

    References
    ----------
    Equation (F4) of :doc:`/equations`.
    """
    slip = creepage * contact.rolling_speed
    stress, rise = local_stress(
        contact=contact,
        pressure_shape=elliptic_stress(xp.ones_like(contact.film_share * contact.peak_pressure)),
        slip_speed=slip,
        warming=warming,
    )
    mean = width_mean(stress)
    force = 2.0 * contact.half_width * contact.contact_length * mean
    heated = _resistance_to_heat(contact) * slip * mean
    return EvenSlip(stress, mean, force, width_mean(rise) / mean, heated, creepage)


def local_stress(
    *, contact: MixedContact, pressure_shape: Array, slip_speed: Array, warming: Array
) -> tuple[Array, Array]:
    r"""Shear stress at places of a contact that slip each at a speed of its own.

    .. math:: \tau(x) = \mu_b(v)\,A\,p(x) + \tau_f(x; v)

    Parameters
    ----------
    contact : MixedContact
        The contact.
    pressure_shape : Array
        Pressure over its peak, shape (places, contacts, ...) [-].
    slip_speed : Array
        v, positive, of the same shape, or shape (contacts, ...) for places that slip alike [m/s].
    warming : Array
        Of the film, shape (contacts, ...) [K].

    Returns
    -------
    tuple of Array
        Stress [Pa], and its slope over the logarithm of the slip speed [Pa].

    References
    ----------
    Equation (F4) of :doc:`/equations`.
    """
    carries = contact.film_share > 0.0
    peak = xp.asarray(xp.where(carries, contact.film_share, 1.0) * contact.peak_pressure)
    film = Film(
        pressure=xp.asarray(pressure_shape * peak),
        peak_pressure=peak,
        thickness=contact.film_thickness,
        slip_speed=slip_speed,
        temperature=contact.oil_temperature + warming,
        oil_temperature=contact.oil_temperature,
        rolling_speed=contact.rolling_speed,
    )
    film_stress, film_slope = contact.traction.stress(contact.fluid.viscosity, film)
    film_stress = xp.where(carries, film_stress, 0.0)
    coefficient, friction_slope = contact.friction.at(slip_speed)
    pressure = pressure_shape * (contact.asperity_share * contact.peak_pressure)
    return coefficient * pressure + film_stress, friction_slope * pressure + film_slope * film_stress


def _resistance_to_heat(contact: MixedContact) -> Array:
    """Mean warming of the film over the heat per area [m^2 K/W]."""
    surface = xp.sqrt(2.0 * contact.half_width / (math.pi * contact.rolling_speed)) / contact.effusivity
    return _SURFACE_SHARE * surface + _FILM_SHARE * contact.film_thickness / contact.fluid.conductivity
