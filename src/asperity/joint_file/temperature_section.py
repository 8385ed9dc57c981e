"""Temperatures in a joint file, and what has to be known for them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

from asperity.errors import InputError
from asperity.joint_file import limits
from asperity.joint_file.material_entries import MaterialEntry
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import Section


class TemperatureEntry(Section):
    """Temperature of the whole drive: where the preload is made by interference, it changes with it."""

    assembly: Annotated[Quantity, limits.TEMPERATURE]
    """Temperature at which load.interference is measured."""
    working: Annotated[Quantity, limits.TEMPERATURE]
    """Temperature for which all results hold; the same in all bodies."""
    housing_expansion: Annotated[Quantity, limits.THERMAL_EXPANSION] | None = None
    """Coefficient of linear thermal expansion of the housing that holds the ring's outer rim; that of the ring if
    absent."""


def refuse_temperature(
    temperature: TemperatureEntry | None,
    *,
    by_interference: bool,
    bodies: Mapping[str, str],
    materials: Mapping[str, MaterialEntry],
    without_housing: str,
) -> None:
    """Refuse temperatures for which something is not known, or is known of nothing."""
    if temperature is None:
        return
    unknown = without_expansion(bodies, materials)
    if by_interference and unknown:
        raise InputError(
            f"[temperature] with load.interference needs the thermal_expansion of every material: give it for "
            f'{", ".join(unknown)}, e.g. thermal_expansion = "11.5e-6 1/K", or take a material of the library'
        )
    if temperature.housing_expansion is not None and without_housing:
        raise InputError(f"{without_housing} has no housing: leave out temperature.housing_expansion")


def without_expansion(bodies: Mapping[str, str], materials: Mapping[str, MaterialEntry]) -> list[str]:
    """Materials of bodies whose thermal expansion is not known.

    Parameters
    ----------
    bodies : mapping
        Body → name of its material.
    materials : mapping
        Materials by name.

    Returns
    -------
    list of str
        Their names.
    """
    used = dict.fromkeys(bodies.values())
    return [name for name in used if name in materials and materials[name].thermal_expansion is None]
