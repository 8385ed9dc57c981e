"""``asperity materials``: the library of materials and finishes with their sources."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from asperity.cli.terminal import json_option, print_json

if TYPE_CHECKING:
    from asperity.library import LibraryMaterial


@click.command()
@click.argument("name", required=False)
@click.option("--file", type=click.Path(), help="Your own library file; its materials are added.")
@click.option("--finishes-file", type=click.Path(), help="Your own library file; its finishes are added.")
@json_option("Print one JSON document; finishes in SI units.")
def materials(name: str | None, file: str | None, finishes_file: str | None, as_json: bool) -> None:
    """List the library, or the entry NAME with its source.

    A joint file refers to a material by its name: [bodies] sun = "52100", or [materials.sun] library = "52100"
    to change some of its values. A finish limits the roughness of a design: { finish = "ground" }.
    """
    from dataclasses import asdict

    from asperity.errors import InputError, nearest
    from asperity.library import Finish, library_name, read_finishes, read_materials

    materials, finishes = read_materials(file), read_finishes(finishes_file)
    if file is not None:
        _check_numbers(file, materials)
    if name is not None:
        name = library_name(name, materials) or name
        if name not in materials and name not in finishes:
            known = [*materials, *finishes]
            hint = nearest(name, known) or f"; it contains {', '.join(known)}"
            raise InputError(f"the library has no entry '{name}'{hint}")
        materials = {name: materials[name]} if name in materials else {}
        finishes = {name: finishes[name]} if name in finishes else {}
    if as_json:
        print_json(
            {
                "materials": {key: asdict(material) for key, material in materials.items()},
                "finishes": {key: asdict(finish) for key, finish in finishes.items()},
            }
        )
        return
    from asperity.cli.terminal import console, show_table, table
    from asperity.units import format_quantity

    target = console()
    if materials:
        shown = table(target, "Materials", "name", "E", "nu", "density", "yield strength", "hardness")
        for material in materials.values():
            numbers = material.numbers
            hard = numbers.get("hardness") or f"{numbers['hardness_factor']} x yield"
            row = [str(numbers[k]) for k in ("youngs_modulus", "poisson_ratio", "density", "yield_strength")]
            shown.add_row(material.name, *row, str(hard))
        target.print(shown)
    if finishes:
        rows = (
            (
                finish.name,
                " to ".join(format_quantity(v, "um") for v in finish.roughness_average),
                " to ".join(f"{D:g}" for D in dict.fromkeys(finish.fractal_dimension)),
                *(format_quantity(v, "mm", 3) for v in finish.fractal_roughness),
            )
            for finish in finishes.values()
        )
        show_table(target, "Finishes (G from Ra at this D)", ("name", "Ra", "D", "G from", "G to"), rows)
    entries: list[LibraryMaterial | Finish] = [*materials.values(), *finishes.values()]
    for entry in entries:
        also = ", ".join(getattr(entry, "also", ()))
        names = f"{entry.name} ({also})" if also else entry.name
        target.print(
            f"{names}: {entry.description}. Source: {entry.reference}. {entry.note}".rstrip(), markup=False
        )


def _check_numbers(file: str, materials: dict[str, LibraryMaterial]) -> None:
    """Check that the values of a library are within the ranges that a joint file allows for materials."""
    from asperity.errors import InputError
    from asperity.joint_file.si_tables import check_values, key_at
    from asperity.units import parse_quantity

    for name, entry in materials.items():
        for key, number in entry.numbers.items():
            path = f"materials.{name.replace('.', '_')}.{key}"
            try:
                check_values({path: parse_quantity(number, key_at(path).dimension)})
            except InputError as error:
                raise InputError(f"{file}: library entry {name}: {error}") from None
