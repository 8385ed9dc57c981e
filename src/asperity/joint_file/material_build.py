"""Materials and surfaces from the tables of a joint file in SI units."""

from __future__ import annotations

from asperity.contact.asperity import AsperityBase
from asperity.contact.exponential import RandomRoughness
from asperity.contact.fractal import Surface
from asperity.contact.roller_pairs import Roughness
from asperity.joint_file.si_tables import Values
from asperity.materials import Material, hardness
from asperity.surface.roughness_average import (
    fractal_roughness_from_average,
    pair_average,
    standard_cut_off,
)
from asperity.types import Real


def surface_of(entry: Values, *, asperity_base: AsperityBase) -> Roughness:
    """The equivalent surface of both bodies of a contact."""
    if "rms_height" in entry:
        return RandomRoughness(entry["rms_height"])
    dimension, roughness = entry["fractal_dimension"], entry.get("fractal_roughness")
    if roughness is None:
        average = entry["roughness_average"]
        roughness = fractal_roughness_from_average(
            roughness_average=pair_average(
                first=average, second=entry.get("partner_roughness_average", average)
            ),
            cut_off=entry["cut_off"] if "cut_off" in entry else standard_cut_off(roughness_average=average),
            fractal_dimension=dimension,
        )
    return Surface(dimension, roughness, entry["frequency_ratio"], asperity_base)


def material_of(entry: Values) -> Material:
    """A material from its table."""
    elastic = {name: entry[name] for name in ("youngs_modulus", "poisson_ratio", "density", "yield_strength")}
    return Material(
        **elastic,
        hardness=_hardness(entry),
        thermal_conductivity=entry.get("thermal_conductivity"),
        specific_heat_capacity=entry.get("specific_heat_capacity"),
        thermal_expansion=entry.get("thermal_expansion"),
        fatigue_strength=entry.get("fatigue_strength"),
        tensile_strength=entry.get("tensile_strength"),
    )


def _hardness(entry: Values) -> Real:
    if "hardness" in entry:
        stated: Real = entry["hardness"]
        return stated
    return hardness(hardness_factor=entry["hardness_factor"], yield_strength=entry["yield_strength"])
