"""Materials and finishes of the library, as they are shown."""

from dataclasses import replace

import pytest
from shown_blocks import cells, sentences, tables

from asperity.library import read_finishes, read_materials
from asperity.library.fluids import read_fluids
from asperity.views.library import library


def test_a_row_and_a_source_for_each_entry():
    materials, finishes = read_materials(), read_finishes()
    blocks = list(library(materials.values(), finishes.values()))
    shown = tables(blocks)
    assert list(cells(shown["Materials"])) == list(materials)
    assert cells(shown["Materials"])["52100"][:3] == ("203 GPa", "0.29", "7833 kg/m^3")
    assert [row[0] for row in shown["Finishes (G from Ra at this D)"].rows] == list(finishes)
    said = sentences(blocks)
    assert len(said) == len(materials) + len(finishes)
    for text, entry in zip(said, (*materials.values(), *finishes.values()), strict=True):
        assert text.startswith(entry.name)
        assert f"Source: {entry.reference}. {entry.note}" in f"{text} "


def test_ranges_of_a_finish():
    ground = read_finishes()["ground"]
    (table,) = tables(library([], [ground])).values()
    low, high = ground.roughness_average
    (row,) = table.rows
    assert row[:2] == ("ground", f"{1e6 * low:g} µm to {1e6 * high:g} µm")
    assert [float(cell.removesuffix(" mm")) for cell in row[3:]] == [
        float(f"{1e3 * roughness:.3g}") for roughness in ground.fractal_roughness
    ]


def test_a_hardness_by_its_factor():
    steel = next(iter(read_materials().values()))
    numbers = {name: value for name, value in steel.numbers.items() if name != "hardness"}
    soft = replace(steel, name="soft", also=(), numbers=numbers | {"hardness_factor": 2.8})
    blocks = list(library([soft], []))
    assert tables(blocks)["Materials"].rows[0][-1] == "2.8 x yield"
    assert sentences(blocks)[0].startswith("soft: ")


def test_an_oil_with_and_one_without_a_viscosity():
    """Of 5P4E the limiting traction alone is known."""
    fluids = read_fluids()
    table, *sources = library([], [], [fluids["M100"], fluids["5P4E"]])
    assert table.rows[0][0] == "M100"
    assert float(table.rows[0][1]) == pytest.approx(76.91, rel=2e-3)
    assert list(table.rows[1]) == ["5P4E", "–", "–", "–", "0.088"]
    assert len(sources) == 2
