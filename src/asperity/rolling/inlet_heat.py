"""By how much shear at the inlet thins the oil films of a joint that rolls, and where that is no longer known."""

from __future__ import annotations

import numpy as np

from asperity.contact.film_thickness import inlet_heat_factor
from asperity.contact.hertz_line import peak_pressure
from asperity.engine.arrays import xp
from asperity.joint.contacts import JointContacts
from asperity.rolling.conditions import Lubricant
from asperity.types import Array, Real

#: What helps where no film can be computed.
FILM_REMEDY = "lower the speed, the preload or the interference, or choose a thinner or a warmer oil"


def inlet_heat(
    *, lubricant: Lubricant, peak_pressure: Real, contact_modulus: Real, rolling_speed: Real
) -> Array:
    """Factors on the thickness of films by heat at their inlets [-]; not above 0 beyond the range of the fit.

    Of contacts under peak pressures [Pa], of moduli E* [Pa], that roll at speeds [m/s]; equation (F2).
    """
    oil, temperature = lubricant.fluid.viscosity, lubricant.temperature
    return inlet_heat_factor(
        peak_pressure=peak_pressure,
        contact_modulus=contact_modulus,
        viscosity=oil.base(temperature),
        viscosity_fall=oil.without_pressure.logarithmic_fall(temperature),
        conductivity=lubricant.fluid.conductivity,
        rolling_speed=rolling_speed,
    )


def joint_inlet_heat(
    *, lubricant: Lubricant, contacts: JointContacts, rolling_speed: Array, normal_force: Array
) -> Array:
    """The same of the contacts of a joint under normal forces [N], shape (contacts, ...) [-].

    Of crowned contacts in the middle of the line, where the pressure is highest; nan where nothing turns.
    """
    pairs = contacts.pairs
    pressed = xp.where(normal_force > 0.0, normal_force, 1.0)
    lines = contacts.loads_along(pressed)
    load, width = pressed / pairs.contact_length, xp.asarray(pairs.half_width(pressed))
    if lines is not None:
        load, width = lines.line_load[0], lines.half_width[0]
    turns = rolling_speed > 0.0
    heat = inlet_heat(
        lubricant=lubricant,
        peak_pressure=peak_pressure(normal_force=load, contact_length=1.0, half_width=width),
        contact_modulus=pairs.moduli.contact_modulus,
        rolling_speed=xp.where(turns, rolling_speed, 1.0),
    )
    return xp.where(turns, heat, xp.nan)


def film_unknown_because(contact_names: tuple[str, ...], factors: Array | np.ndarray | None) -> str | None:
    """Why no oil film of a joint can be computed: the contact where the factor by heat at the inlet is lowest.

    ``factors`` of the contacts [-], None without an oil whose traction is known. None where every factor is above 0.
    """
    if factors is None:
        return None
    values = np.asarray(factors, dtype=float)
    if not np.any(values <= 0.0):
        return None
    worst = int(np.nanargmin(values))
    return (
        f"no oil film at {contact_names[worst]}: heat at its inlet is beyond the range of the fit, whose factor on the "
        f"thickness, {values[worst]:.3g}, must be above 0"
    )
