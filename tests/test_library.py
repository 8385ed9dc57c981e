"""The library of materials and finishes."""

import pytest
from bronze import BRONZE

from asperity.errors import InputError
from asperity.library import (
    fill_in_materials,
    read_finishes,
    read_materials,
)
from asperity.surface.roughness_average import roughness_average
from asperity.unit_table import Dimension
from asperity.units import parse_quantity


def test_every_entry_has_a_source_and_sensible_numbers():
    materials = read_materials()
    assert {"52100", "440C", "17-4PH", "Si3N4", "6061-T6"} <= set(materials)
    for each in materials.values():
        assert len(each.reference) > 20
    for finish in read_finishes().values():
        assert len(finish.reference) > 20
        assert 0.0 < finish.fractal_roughness[0] < finish.fractal_roughness[1] < 1e-6


def test_thermal_expansion_of_steel_ceramic_and_aluminium():
    """Steel 10 to 13, silicon nitride a quarter of it, aluminium twice as much, in 1e-6 1/K."""
    found = {
        name: 1e6 * parse_quantity(each.numbers["thermal_expansion"], Dimension.THERMAL_EXPANSION)
        for name, each in read_materials().items()
    }
    assert all(10.0 < found[name] < 13.0 for name in ("52100", "440C", "17-4PH"))
    assert found["Si3N4"] == pytest.approx(0.25 * found["440C"], rel=0.1)
    assert found["6061-T6"] == pytest.approx(2.0 * found["52100"], rel=0.1)


def test_smoother_process_smaller_roughness():
    finishes = read_finishes()
    assert finishes["superfinished"].fractal_roughness[1] < finishes["ground"].fractal_roughness[1]


def test_g_of_a_finish_has_its_ra():
    for finish in read_finishes().values():
        for average, g in zip(finish.roughness_average, finish.fractal_roughness, strict=True):
            back = roughness_average(
                fractal_dimension=finish.fractal_dimension[0],
                fractal_roughness=g,
                cut_off=finish.sampling_length,
            )
            assert back == pytest.approx(average, rel=1e-9)
        assert finish.published_dimension[0] < finish.published_dimension[1] < 2.0


def test_own_file_adds_and_replaces(tmp_path):
    path = tmp_path / "own.toml"
    path.write_text(BRONZE + BRONZE.replace("[bronze]", "[52100]"))
    found = read_materials(path)
    assert found["bronze"].numbers["poisson_ratio"] == 0.34
    assert found["52100"].numbers["youngs_modulus"] == "110 GPa"
    assert "440C" in found


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("reference", "note", "'reference' is missing or is not text; every entry must state its source"),
        ('"110 GPa"', '"110 N"', "expected a pressure"),
        ("hardness_factor = 2.8", "", "exactly one of"),
        ("poisson_ratio = 0.34", "", "'poisson_ratio' is missing"),
        ("poisson_ratio", "poison_ratio", "unknown key 'poison_ratio'"),
        ("poisson_ratio", "also = 'CuSn12'\npoisson_ratio", "also: expected a list of names, got 'CuSn12'"),
    ],
)
def test_bad_entries(tmp_path, old, new, message):
    path = tmp_path / "own.toml"
    path.write_text(BRONZE.replace(old, new))
    with pytest.raises(InputError, match=rf"own\.toml: library entry bronze: .*{message}"):
        read_materials(path)


def test_joint_files_take_materials_by_name(tmp_path):
    (tmp_path / "own.toml").write_text(BRONZE)
    tables = {
        "materials": {
            "soft": {"library": "bronze", "file": "own.toml"},
            "hard": {"library": "440C", "yield_strength": "1500 MPa"},
            "tabor": {"library": "440C", "hardness_factor": 2.8},
        },
        "bodies": {"sun": "52100", "planet": "soft", "loading_roller": "hard", "ring": "tabor"},
    }
    filled, refused = fill_in_materials(tables, folder=tmp_path)
    found = filled["materials"]
    assert refused == {}
    assert found["52100"]["youngs_modulus"] == "203 GPa"
    assert found["soft"]["youngs_modulus"] == "110 GPa"
    assert (found["hard"]["yield_strength"], found["hard"]["hardness"]) == ("1500 MPa", "6.61 GPa")
    assert "hardness" not in found["tabor"]
    missing = {"materials": {"a": {"library": "x9"}, "b": {"library": "x8"}}, "bodies": {}}
    same, refused = fill_in_materials(missing, folder=tmp_path)
    assert same == missing
    assert list(refused) == ["materials.a", "materials.b"]
    assert refused["materials.a"].startswith("materials.a.library: there is no material 'x9'; known are ")


def test_a_designation_of_another_standard_names_the_material(tmp_path):
    tables = {"bodies": {"sun": "1.3505", "planet": "100cr6", "ring": "SUS 440C"}, "materials": {}}
    filled, refused = fill_in_materials(tables, folder=tmp_path)
    assert (filled["bodies"], refused) == ({"sun": "52100", "planet": "52100", "ring": "440C"}, {})
    assert list(filled["materials"]) == ["52100", "440C"]
    entry = {"library": "X105CrMo17", "yield_strength": "1500 MPa"}
    filled, _ = fill_in_materials({"materials": {"hard": entry}, "bodies": {"sun": "hard"}}, folder=tmp_path)
    assert filled["materials"]["hard"] == dict(read_materials()["440C"].numbers) | {
        "yield_strength": "1500 MPa"
    }
    # the file's own 52100 is not that of the standards
    own = {"materials": {"52100": {"youngs_modulus": "1 GPa"}}, "bodies": {"sun": "100Cr6"}}
    assert fill_in_materials(own, folder=tmp_path)[0] == own


def test_no_designation_names_two_materials():
    names = [name for material in read_materials().values() for name in (material.name, *material.also)]
    assert len(set(map(str.lower, names))) == len(names)


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ({"library": ["440C"]}, "materials.a.library: expected a name as text, got ['440C']"),
        ({"library": "440C", "file": 3}, "materials.a.file: expected a name as text, got 3"),
    ],
)
def test_names_that_are_no_text_are_refused(tmp_path, entry, message):
    _, refused = fill_in_materials({"materials": {"a": entry}, "bodies": {}}, folder=tmp_path)
    assert refused == {"materials.a": message}


def test_filled_tables_are_a_valid_joint_file(tmp_path):
    from importlib.resources import files
    from tomllib import loads

    tables = loads(files("asperity.joint_file").joinpath("zou2025.toml").read_text())
    tables["bodies"]["planet"] = "Si3N4"
    filled, _ = fill_in_materials(tables, folder=tmp_path)
    from asperity.joint_file.reader import case_from_tables

    case = case_from_tables(filled, source="test")
    assert case.materials["Si3N4"].youngs_modulus.value == pytest.approx(307e9)


def test_a_fatigue_strength_is_a_measured_one_of_its_reference():
    """52100 endured 588 MPa for 10^9 cycles in axial loading: Li et al. 2011; no other steel has a traced value."""
    stated = {
        name: each
        for name, each in read_materials().items()
        if each.numbers.get("fatigue_strength") is not None
    }
    assert {name: each.numbers["fatigue_strength"] for name, each in stated.items()} == {"52100": "588 MPa"}
    for each in stated.values():
        assert "fatigue strength: amplitude without failure in 10^9 cycles of axial loading" in each.reference
        assert "doi 10.1016/j.msea.2011.03.020" in each.reference
        assert "specimens under fully reversed" in each.note
