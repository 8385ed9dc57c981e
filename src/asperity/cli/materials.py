"""``asperity materials``: the library of materials and finishes with their sources."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from asperity.cli.terminal import json_option, print_json, show_blocks

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
    from asperity.library import library_name, read_finishes, read_materials

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
    from asperity.views.library import library

    show_blocks(*library(materials.values(), finishes.values()))


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
