"""What the command of :mod:`asperity.cli.materials` does."""

from __future__ import annotations

from dataclasses import asdict
from typing import TYPE_CHECKING

from asperity.cli.terminal import print_json, show_blocks
from asperity.errors import InputError, nearest
from asperity.joint_file.lubricant import fluid_document
from asperity.joint_file.si_tables import check_values, key_at
from asperity.library import library_name, read_finishes, read_materials
from asperity.library.fluids import library_fluid, read_fluids
from asperity.units import parse_quantity
from asperity.views.library import library

if TYPE_CHECKING:
    from asperity.library import LibraryMaterial


def materials(name: str | None, file: str | None, finishes_file: str | None, as_json: bool) -> None:
    """What ``asperity materials`` does; its options stand in :mod:`asperity.cli.materials`."""
    materials, finishes, fluids = read_materials(file), read_finishes(finishes_file), read_fluids()
    if file is not None:
        _check_numbers(file, materials)
    if name is not None:
        oil = library_fluid(name)
        name = library_name(name, materials) or (oil.name if oil else name)
        if name not in materials and name not in finishes and name not in fluids:
            known = [*materials, *finishes, *fluids]
            hint = nearest(name, known) or f"; it contains {', '.join(known)}"
            raise InputError(f"the library has no entry '{name}'{hint}")
        materials = {name: materials[name]} if name in materials else {}
        finishes = {name: finishes[name]} if name in finishes else {}
        fluids = {name: fluids[name]} if name in fluids else {}
    if as_json:
        print_json(
            {
                "materials": {key: asdict(material) for key, material in materials.items()},
                "finishes": {key: asdict(finish) for key, finish in finishes.items()},
                "fluids": {key: fluid_document(fluid) for key, fluid in fluids.items()},
            }
        )
        return
    show_blocks(*library(materials.values(), finishes.values(), fluids.values()))


def _check_numbers(file: str, materials: dict[str, LibraryMaterial]) -> None:
    """Check that the values of a library are within the ranges that a joint file allows for materials."""
    for name, entry in materials.items():
        for key, number in entry.numbers.items():
            path = f"materials.{name.replace('.', '_')}.{key}"
            try:
                check_values({path: parse_quantity(number, key_at(path).dimension)})
            except InputError as error:
                raise InputError(f"{file}: library entry {name}: {error}") from None
