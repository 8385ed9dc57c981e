"""The library of materials and finishes, with their sources."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from asperity.joint_file.lubricant import fluid_properties
from asperity.library import Finish, LibraryMaterial
from asperity.library.fluids import LibraryFluid
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import quantity


def library(
    materials: Collection[LibraryMaterial],
    finishes: Collection[Finish],
    fluids: Collection[LibraryFluid] = (),
) -> Iterator[Block]:
    """Tables of materials, finishes and oils, and where each entry comes from."""
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
    if fluids:
        yield Table(
            "Oils (traction and rise with pressure at 40 °C and 1 GPa)",
            (
                "name",
                "at 40 °C\nmPa·s",
                "at 100 °C\nmPa·s",
                "pressure coefficient\n1/GPa",
                "limiting traction\n-",
            ),
            [_oil(fluid) for fluid in fluids],
        )
    entries: list[LibraryMaterial | Finish | LibraryFluid] = [*materials, *finishes, *fluids]
    for entry in entries:
        also = ", ".join(getattr(entry, "also", ()))
        names = f"{entry.name} ({also})" if also else entry.name
        yield Paragraph(f"{names}: {entry.description}. Source: {entry.reference}. {entry.note}".rstrip())


def _oil(fluid: LibraryFluid) -> tuple[str, ...]:
    """A row of the table of oils; a dash where nothing is known."""
    known = fluid_properties(fluid)
    units = {"viscosity_40_Pa_s": 1e3, "viscosity_100_Pa_s": 1e3, "pressure_coefficient_per_Pa": 1e9}
    cells = (f"{scale * known[name]:.4g}" if name in known else "–" for name, scale in units.items())
    return (fluid.name, *cells, f"{known['limiting_traction']:.3g}")
