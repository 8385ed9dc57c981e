"""Temperatures in a joint file, and what has to be known for them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

from asperity.joint_file import limits
from asperity.joint_file.material_entries import BodyMaterials, MaterialEntry
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


def without_expansion(bodies: BodyMaterials, materials: Mapping[str, MaterialEntry]) -> list[str]:
    """Materials of bodies whose thermal expansion is not known.

    Parameters
    ----------
    bodies : BodyMaterials
        Which material each body is made of.
    materials : mapping
        Materials by name.

    Returns
    -------
    list of str
        Their names.
    """
    used = dict.fromkeys(name for _, name in bodies)
    return [name for name in used if name in materials and materials[name].thermal_expansion is None]
