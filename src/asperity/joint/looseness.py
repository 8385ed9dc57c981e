"""A joint at its working temperature: what temperature does to its interference, and where it comes loose."""

from __future__ import annotations

import math
from typing import Any

import jax.numpy as jnp
from jax import Array

from asperity.drive.layout.thermal_expansion import loosening_rise
from asperity.errors import InputError
from asperity.joint.fit import Fit
from asperity.types import Real
from asperity.units import format_quantity

#: Above this temperature no material of a roller is solid [degC].
HOTTEST = 3000.0


def loose_temperature(fit: Fit) -> Array:
    """Temperature from which a joint has no interference [degC]."""
    rise = loosening_rise(interference=fit.interference, change_per_kelvin=fit.change_per_kelvin)
    found = jnp.asarray(fit.assembly_temperature + rise)
    return jnp.where((found >= -273.15) & (found <= HOTTEST), found, math.inf)


def refuse_loose(fit: Fit | None) -> None:
    """Refuse a joint whose working temperature has left no interference."""
    if fit is None or float(fit.interference) + float(fit.thermal_change) > 0.0:
        return
    loose = float(loose_temperature(fit))
    side = "above" if loose > float(fit.assembly_temperature) else "below"
    raise InputError(
        f"the joint is loose at its working temperature {format_quantity(float(fit.working_temperature), 'degC')}: of "
        f"{format_quantity(float(fit.interference), 'um')} of interference at the assembly, "
        f"{format_quantity(abs(float(fit.temperature_rise)), 'K')} take "
        f"{format_quantity(-float(fit.thermal_change), 'um')}; nothing is left {side} "
        f"{format_quantity(loose, 'degC')}. Choose more interference, materials of more equal expansion, or a preload "
        "by spring (load.preload)"
    )


def fit_document(fit: Fit, preload: Real) -> dict[str, Any]:
    """How a drive was assembled, for a JSON document."""
    loose = float(loose_temperature(fit))
    return {
        "force_N": float(preload),
        "interference_m": float(fit.interference),
        "temperature_degC": float(fit.assembly_temperature),
        "working_temperature_degC": float(fit.working_temperature),
        "thermal_change_m": float(fit.thermal_change),
        "loose_temperature_degC": loose if math.isfinite(loose) else None,
    }
