"""Names of bodies, contacts and tracks from the tables of a joint file, as it states them and in SI units."""

import pytest
import tomlkit

from asperity.drive.types.listed import track_of
from asperity.joint_file.part_names import (
    body_key,
    contacts_of,
    paths_of_track,
    type_of,
    with_structure,
)
from asperity.joint_file.si_tables import replace_values, si_values


def test_names_are_the_same_in_the_file_and_in_si_units(planar_case):
    for name in ("planar", "planetary"):
        case = planar_case(name)
        for tables in (tomlkit.parse(case.text), si_values(case)):
            assert type_of(tables) == name
    assert contacts_of(si_values(planar_case("planar"))) == ("sp", "pwr", "pwl", "wro", "wlo")
    assert contacts_of({}) == ("sp", "pwr", "pwl", "wro", "wlo")  # no type: the paper's drive


def test_one_track_is_one_number(planar_case):
    values = si_values(planar_case("planar"))
    # the planet's track of 13.5 mm touches the sun and both loading rollers
    expected = ["contact.1.second_radius", "contact.2.first_radius", "contact.3.first_radius"]
    assert paths_of_track(values, "contact.2.first_radius") == expected
    assert paths_of_track(values, "load.preload") == ["load.preload"]
    crowns = [path.replace("_radius", "_crown_radius") for path in expected]
    assert paths_of_track(values, "contact.1.second_crown_radius") == crowns
    named = with_structure(values)
    changed = replace_values(named, {"contact.2.first_radius": 0.014})
    for index, side in (("1", "second"), ("2", "first"), ("3", "first")):
        assert changed["contact"][index][f"{side}_radius"] == 0.014
        # its only track, whatever its size
        assert track_of(changed["contact"].values(), changed["contact"][index], side) == "0"
    assert changed["contact"]["1"]["first_radius"] == 0.004
    assert values["contact"]["1"]["second_radius"] == 0.0135
    assert with_structure({"drive": {}}) == {"drive": {}}


@pytest.mark.parametrize(
    ("kind", "body", "key"),
    [
        ("wedge", "left_loading_roller", "loading_roller"),
        ("wedge", "right_loading_roller_2", "loading_roller"),  # of the second branch
        ("planetary", "planet_3", "planet"),
        ("planetary", "ring", "ring"),
        ("planar", "wheel_2", "wheel_2"),  # so called in the file
    ],
)
def test_the_material_of_a_body_of_a_branch_is_that_of_all_branches(kind, body, key):
    assert body_key(kind, body, ("loading_roller", "planet", "ring", "wheel", "wheel_2")) == key
