"""What a joint is: the input of the chain, as frozen modules. SI units."""

from __future__ import annotations

from typing import Any, Literal

import equinox as eqx
import jax

from asperity.arrays import namespace
from asperity.types import Real

ClosureSprings = Literal["bulk", "bulk_and_asperities"]
#: Bodies of the assembly: discs and annuli by plane elasticity, or one spring for each contact.
BodyModel = Literal["exact", "springs"]


class Fit(eqx.Module):
    """How a drive whose preload is made by interference was assembled, and what temperature does to it.

    Parameters
    ----------
    interference : Real
        Interference at the assembly [m].
    change_per_kelvin : Real
        What a kelvin more adds to it [m/K].
    assembly_temperature, working_temperature : Real
        Temperatures of the whole drive [degC].
    """

    interference: Real
    change_per_kelvin: Real
    assembly_temperature: Real
    working_temperature: Real

    @property
    def temperature_rise(self) -> Real:
        """Working temperature above that of the assembly [K]."""
        return self.working_temperature - self.assembly_temperature

    @property
    def thermal_change(self) -> Real:
        """What the working temperature adds to the interference [m]."""
        return self.change_per_kelvin * self.temperature_rise


def per_contact(values: tuple[Any, ...]) -> Any:
    """Stack a tuple of one or five like things along a first contact axis of length 1 or 5.

    Parameters
    ----------
    values : tuple
        Numbers or modules of numbers, one for all contacts or one for each.

    Returns
    -------
    The same kind of thing with leaves of shape (1, ...) or (5, ...).
    """
    xp = namespace(*values)
    return jax.tree.map(lambda *leaves: xp.stack(xp.broadcast_arrays(*map(xp.asarray, leaves))), *values)
