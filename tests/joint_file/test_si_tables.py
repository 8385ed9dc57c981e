import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import check_values, key_at, numeric_keys, replace_values, si_values


def test_the_tables_of_the_file_in_si(example_case):
    values = si_values(example_case)
    assert values["drive"]["planet_radius"] == 0.0135
    assert values["load"]["preload"] == 1000.0
    assert values["surface"] == {"fractal_dimension": 1.4, "fractal_roughness": 1e-11, "frequency_ratio": 1.5}
    assert values["bodies"]["sun"] == "steel"
    assert "bearings" not in values
    assert "planet_length" not in values["drive"]


def test_every_stated_number_is_listed_with_its_tolerance(example_text):
    case = parse_case(example_text.replace('"13.5 mm"', '"13.5 mm +- 5 um"'), source="x")
    keys = numeric_keys(case)
    radius = keys["drive.planet_radius"]
    assert (radius.value, radius.tolerance, radius.key.unit) == (0.0135, 5e-6, "mm")
    assert keys["materials.steel.hardness_factor"].value == 2.8
    assert "materials.steel.hardness" not in keys
    assert "bodies.sun" not in keys
    assert len(keys) == 21  # lines with a number in the example


def test_a_path_to_one_contact_splits_the_entry_for_all(example_case):
    values = si_values(example_case)
    changed = replace_values(values, {"surface.sp.fractal_dimension": 1.6, "drive.contact_length.wlo": 0.007})
    assert changed["surface"]["sp"]["fractal_dimension"] == 1.6
    assert changed["surface"]["pwl"] == values["surface"]
    assert changed["drive"]["contact_length"] == {
        "sp": 5e-3,
        "pwr": 5e-3,
        "pwl": 5e-3,
        "wro": 5e-3,
        "wlo": 7e-3,
    }
    assert values == si_values(example_case)  # the original is left alone


def test_a_path_without_a_contact_sets_all_five(example_case):
    split = replace_values(si_values(example_case), {"load.friction_coefficient.sp": 0.2})
    changed = replace_values(split, {"load.friction_coefficient": 0.3})
    assert changed["load"]["friction_coefficient"] == dict.fromkeys(("sp", "pwr", "pwl", "wro", "wlo"), 0.3)


def test_what_the_file_leaves_out_can_be_set(example_case):
    changed = replace_values(
        si_values(example_case),
        {"bearings.sun_torque": 0.1, "drive.planet_length": 0.02, "compliance.pin_stiffness": 1e8},
    )
    assert changed["bearings"] == {"sun_torque": 0.1}
    assert changed["drive"]["planet_length"] == 0.02
    assert changed["compliance"] == {"pin_stiffness": 1e8}


def test_hardness_and_its_factor_replace_each_other(example_case):
    changed = replace_values(si_values(example_case), {"materials.steel.hardness": 2e9})
    assert changed["materials"]["steel"]["hardness"] == 2e9
    assert "hardness_factor" not in changed["materials"]["steel"]


@pytest.mark.parametrize(
    ("path", "said"),
    [
        ("load.output_torqe", "no number 'load.output_torqe'; did you mean 'load.output_torque'?"),
        ("model.closure", "no number 'model.closure'"),
        ("surface", "no number 'surface'"),
        ("", "no number ''"),
        ("materials.steel.poisson", "did you mean 'materials.*.poisson_ratio'?"),
    ],
)
def test_paths_that_do_not_exist(path, said):
    with pytest.raises(InputError) as refused:
        key_at(path)
    assert said in str(refused.value)


def test_a_material_that_is_not_in_the_file(example_case):
    with pytest.raises(InputError, match="no material 'stel'; did you mean 'steel'"):
        replace_values(si_values(example_case), {"materials.stel.density": 1.0})


@pytest.mark.parametrize(
    ("path", "values", "said"),
    [
        ("load.preload", [100.0, -1.0], "load.preload: -1 N is not allowed"),
        ("load.preload", [100.0, np.nan], "load.preload: nan N is not allowed"),
        ("surface.fractal_dimension", [1.2, 2.0], "surface.fractal_dimension: 2 is not allowed"),
        ("drive.planets", [2.0, 2.5, 4.0], "drive.planets: 2.5 is not allowed"),
        ("drive.sun_radius", 4.0e9, "4e12 mm is not allowed"),
        ("drive.sun_radius", [], "empty"),
    ],
)
def test_values_outside_their_range_are_refused(path, values, said):
    with pytest.raises(InputError) as refused:
        check_values({path: values})
    assert said in str(refused.value)


def test_values_inside_their_range_pass():
    check_values(
        {"load.preload": np.linspace(1.0, 1e4, 5), "drive.planets": [2.0, 3.0], "drive.sun_radius": 0.004}
    )
