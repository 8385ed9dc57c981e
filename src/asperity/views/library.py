"""The library of materials and finishes, with their sources."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from asperity.library import Finish, LibraryMaterial
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import quantity


def library(materials: Collection[LibraryMaterial], finishes: Collection[Finish]) -> Iterator[Block]:
    """Tables of materials and of finishes, and where each entry comes from."""
    if materials:
        keys = ("youngs_modulus", "poisson_ratio", "density", "yield_strength")
        rows = [
            (
                material.name,
                *(str(material.numbers[key]) for key in keys),
                str(material.numbers.get("hardness") or f"{material.numbers['hardness_factor']} x yield"),
            )
            for material in materials
        ]
        yield Table("Materials", ("name", "E", "nu", "density", "yield strength", "hardness"), rows)
    if finishes:
        rows = [
            (
                finish.name,
                " to ".join(quantity(value, "um") for value in finish.roughness_average),
                " to ".join(f"{value:g}" for value in dict.fromkeys(finish.fractal_dimension)),
                *(quantity(value, "mm", 3) for value in finish.fractal_roughness),
            )
            for finish in finishes
        ]
        yield Table("Finishes (G from Ra at this D)", ("name", "Ra", "D", "G from", "G to"), rows)
    entries: list[LibraryMaterial | Finish] = [*materials, *finishes]
    for entry in entries:
        also = ", ".join(getattr(entry, "also", ()))
        names = f"{entry.name} ({also})" if also else entry.name
        yield Paragraph(f"{names}: {entry.description}. Source: {entry.reference}. {entry.note}".rstrip())
