"""How a drive whose preload is made by interference is assembled, and where temperature makes it loose."""

from __future__ import annotations

import math
from typing import Any, Literal

from asperity.drive.layout.expansion import loosening_rise
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.errors import InputError
from asperity.types import Array, Document, Real
from asperity.units import format_quantity

ClosureSprings = Literal["bulk", "bulk_and_asperities"]
#: Bodies of the assembly: discs and annuli by plane elasticity, or one spring for each contact.
BodyModel = Literal["exact", "springs"]


class Fit(Module):
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
    """Numbers or modules of numbers, one for all contacts or one for each, stacked along a first axis."""
    return trees.map(lambda *leaves: xp.stack(xp.broadcast_arrays(*map(xp.asarray, leaves))), *values)


#: Above this temperature no material of a roller is solid [degC].
HOTTEST = 3000.0


def loose_temperature(fit: Fit) -> Array:
    """Temperature from which a joint has no interference [degC]."""
    rise = loosening_rise(interference=fit.interference, change_per_kelvin=fit.change_per_kelvin)
    temperature = xp.asarray(fit.assembly_temperature + rise)
    return xp.where((temperature >= -273.15) & (temperature <= HOTTEST), temperature, math.inf)


def refuse_loose(fit: Fit | None) -> None:
    """Refuse a joint whose working temperature has left no interference."""
    if fit is None or float(fit.interference) + float(fit.thermal_change) > 0.0:
        return
    loose, assembly = float(loose_temperature(fit)), float(fit.assembly_temperature)
    left = ""
    if math.isfinite(loose):
        side = "above" if loose > assembly else "below"
        left = f"; nothing is left {side} {format_quantity(loose, 'degC')}"
    raise InputError(
        f"the joint is loose at its working temperature {format_quantity(float(fit.working_temperature), 'degC')}: of "
        f"{format_quantity(float(fit.interference), 'um')} of interference at the assembly, "
        f"{format_quantity(abs(float(fit.temperature_rise)), 'K')} take "
        f"{format_quantity(-float(fit.thermal_change), 'um')}{left}. Choose more interference, materials of more equal "
        "expansion, or a preload by spring (load.preload)"
    )


def fit_document(fit: Fit, preload: Real, loose: float | None) -> Document:
    """How a drive was assembled, for a JSON document; ``loose``: temperature without force at a contact [degC]."""
    return {
        "force_N": float(preload),
        "interference_m": float(fit.interference),
        "temperature_degC": float(fit.assembly_temperature),
        "working_temperature_degC": float(fit.working_temperature),
        "thermal_change_m": float(fit.thermal_change),
        "loose_temperature_degC": loose,
    }
