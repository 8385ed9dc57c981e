"""The Ra that belongs to the D and G of a joint's surfaces."""

from __future__ import annotations

from typing import Any

from asperity.joint.description import Joint
from asperity.surface.roughness_average import corresponding_average, standard_cut_off


def surface_averages(joint: Joint, stated: dict[str, Any]) -> list[dict[str, Any]]:
    """What an instrument would show on the surfaces of a joint [m]."""
    contacts = joint.contact_names
    shared = [contacts] if len(joint.surfaces) == 1 else [(name,) for name in contacts]
    found: dict[tuple[float, float, float | None], list[str]] = {}
    for names, surface in zip(shared, joint.surfaces, strict=True):
        entry = stated.get(names[0], stated)
        values = (float(surface.fractal_dimension), float(surface.fractal_roughness), _cut_off(entry))
        found.setdefault(values, []).extend(names)
    return [_entry(names, *values) for values, names in found.items()]


def _cut_off(entry: dict[str, Any]) -> float | None:
    """The cut-off of a surface that is stated by its Ra."""
    if "roughness_average" not in entry:
        return None
    return float(entry.get("cut_off", standard_cut_off(roughness_average=float(entry["roughness_average"]))))


def _entry(names: list[str], dimension: float, roughness: float, cut_off: float | None) -> dict[str, Any]:
    average = corresponding_average(fractal_dimension=dimension, fractal_roughness=roughness, cut_off=cut_off)
    return {
        "contacts": names,
        "fractal_dimension": dimension,
        "fractal_roughness_m": roughness,
        "roughness_average_m": average.each,
        "roughness_average_low_m": average.low,
        "roughness_average_high_m": average.high,
        "cut_off_m": average.cut_off,
    }
