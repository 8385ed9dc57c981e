"""What a joint's rolling needs beyond its stiffness: skew, oil, hysteresis, reliability and the duty."""

from __future__ import annotations

import dataclasses
from typing import Self

from asperity.contact.creep_law import CREEP_LIMIT
from asperity.contact.film_thickness import FilmLaw
from asperity.contact.fluid import Fluid
from asperity.contact.load_sharing import SharingLaw
from asperity.engine.module import Module, static
from asperity.types import Real

#: Temperature of 0 degC [K].
ZERO_CELSIUS = 273.15


class DutyPoint(Module):
    """One load of a duty.

    Parameters
    ----------
    output_torque : Real
        Torque at the output, of either sign [N·m].
    input_speed : Real
        Angular velocity of the input, not negative [rad/s].
    share : Real
        Share of the time [-].
    """

    output_torque: Real
    input_speed: Real
    share: Real


class Lubricant(Module):
    """The oil in the contacts of a joint. SI units.

    Parameters
    ----------
    fluid : Fluid
        What its film does.
    temperature : Real
        At the inlet of the contacts [K].
    supply : Real
        Share of the thickness of a flooded film that the supply of oil leaves [-].
    creep_limit : Real
        Largest creepage at which a traction counts as one that a contact carries [-].
    friction_speeds, friction_coefficients : tuple of Real
        Slip speeds in rising order [m/s] and friction coefficients of the asperities there [-]; empty where friction
        is that of the joint at every speed.
    lowest_temperature : Real or None
        Lowest one of the fluid's data [K]; None where none is known.
    film_law, load_sharing : FilmLaw, SharingLaw
        Laws of the central film, and of the shares of film and asperities in the load.
    """

    fluid: Fluid
    temperature: Real
    supply: Real = 1.0
    creep_limit: Real = CREEP_LIMIT
    friction_speeds: tuple[Real, ...] = ()
    friction_coefficients: tuple[Real, ...] = ()
    lowest_temperature: Real | None = None
    film_law: FilmLaw = static(default="moes")
    load_sharing: SharingLaw = static(default="persson")


class RollingConditions(Module):
    """Conditions under which a joint rolls. SI units.

    Parameters
    ----------
    skew : tuple of Real or None
        Angle by which the axes of a contact are out of parallel [rad], for all contacts or for each; None for
        parallel axes.
    hysteresis_loss_factor : Real or None
        Share of the elastic work that is lost [-]; None if this loss is left out.
    viscosity : Real or None
        Viscosity of the oil at the inlet of the contacts [Pa·s], with a lubricant that of its fluid at its
        temperature; None if its rolling loss is left out.
    pressure_viscosity_coefficient : Real or None
        Pressure coefficient of the viscosity [1/Pa]; None with a lubricant, whose fluid has one for every pressure, and
        if the thickness of the film is left out.
    reliability : Real
        Survival for which lives are stated [-].
    duty : tuple of DutyPoint
        Loads and their shares of the time, which add up to 1; empty for none.
    roughness : tuple of Real or None
        Root mean square of the heights of both surfaces of a contact together, one for all contacts, or one each [m];
        None if the ratio of the film to it is left out.
    lubricant : Lubricant or None
        The oil in the contacts, by what it does; None where its viscosity alone is stated, or nothing. Friction is as
        stated without one, and with one whose fluid has no traction.
    cleanliness : Real or None
        Contamination factor e_C of the oil, by which lives have a factor for its film [-]; None for lives without one.
    """

    skew: tuple[Real, ...] | None
    hysteresis_loss_factor: Real | None
    viscosity: Real | None
    pressure_viscosity_coefficient: Real | None
    reliability: Real
    duty: tuple[DutyPoint, ...]
    roughness: tuple[Real, ...] | None = None
    lubricant: Lubricant | None = None
    cleanliness: Real | None = None

    def with_oil_at(self, temperature: Real) -> Self:
        """The same conditions with the oil at another temperature [K]; without a lubricant nothing changes."""
        if self.lubricant is None:
            return self
        return dataclasses.replace(
            self,
            lubricant=dataclasses.replace(self.lubricant, temperature=temperature),
            viscosity=self.lubricant.fluid.viscosity.base(temperature),
        )


#: Parallel axes, no hysteresis, no oil, 90 % survival, no duty: a joint whose description says nothing about rolling.
PLAIN_ROLLING = RollingConditions(
    skew=None,
    hysteresis_loss_factor=None,
    viscosity=None,
    pressure_viscosity_coefficient=None,
    reliability=0.9,
    duty=(),
)
