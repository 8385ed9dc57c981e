"""What can be set on the page: every number and choice of the model, in the units of its range."""

import pytest

from asperity.joint_file import limits
from asperity.joint_file.case_types import DefaultCase
from asperity.joint_file.reader import read_case
from asperity.library import read_finishes
from asperity.page.description import HEADINGS, description, form_of
from asperity.units import from_si, parse_quantity


@pytest.fixture(scope="module")
def described():
    return description()


@pytest.fixture(scope="module")
def keys(described):
    return {each["key"]: each for group in described["groups"] for each in group["parameters"]}


def test_groups_are_in_the_order_of_the_page(described):
    assert [group["name"] for group in described["groups"]] == [
        name for name in HEADINGS if name in DefaultCase.model_fields
    ]
    assert all(group["parameters"] for group in described["groups"])


def test_ranges_are_those_of_the_file(keys):
    friction, push = keys["load.friction_coefficient"], keys["drive.right_push_angle"]
    assert (friction["lowest"], friction["highest"]) == (
        limits.FRICTION_COEFFICIENT.lower,
        limits.FRICTION_COEFFICIENT.upper,
    )
    assert (friction["lowest_included"], friction["highest_included"]) == (False, True)
    assert (push["lowest"], push["highest"], push["unit"]) == (-60.0, 60.0, "deg")
    assert keys["drive.planets"]["whole"]
    assert not keys["drive.sun_radius"]["whole"]


def test_examples_are_in_the_unit_of_the_range_and_inside_it(keys):
    for path, each in keys.items():
        assert each["lowest"] <= each["example_value"] <= each["highest"], path
        assert each["meaning"], path
    key = limits.SPRING
    spring = keys["compliance.pin_stiffness"]
    assert spring["example_value"] == pytest.approx(
        from_si(parse_quantity(key.typical, key.dimension), key.unit), rel=1e-12
    )


def test_what_is_taken_for_a_key_that_is_absent(keys):
    assert keys["compliance.pin_stiffness"]["default"] == (
        "rigid if absent, or that of a beam where [bearings] states pin_diameter and pin_length"
    )
    assert keys["compliance.output_shaft_stiffness"]["default"] == "rigid if absent"
    assert keys["bearings.pin_radial_clearance"]["default"] == "none if absent"
    assert keys["rolling.reliability"]["default"] == "0.9 if absent"
    assert keys["drive.sun_radius"]["default"] is None
    said = {each["default"] for each in keys.values() if each["default"]}
    assert len(said) > 10
    assert all(words[0].islower() or words[0].isdigit() for words in said), "in one case beside each other"
    assert "if absent" not in said


def test_an_rz_and_a_share_have_meaning_unit_and_range_of_the_file(keys):
    depth, share = keys["surface.mean_roughness_depth"], keys["duty.*.share"]
    assert (depth["unit"], depth["lowest"], depth["highest"]) == ("um", 1e-3, 100.0)
    assert depth["meaning"].startswith("Rz of one body in place of its Ra")
    assert set(depth["replaces"]) == {"fractal_roughness", "roughness_average", "rms_height", "decay_length"}
    assert (share["lowest"], share["highest"], share["lowest_included"]) == (0.0, 1.0, False)
    assert share["meaning"].startswith("Share of the time")
    assert keys["load.interference"]["replaces"] == ["preload"]


def test_the_library_is_listed(described):
    steels = {each["name"]: each for each in described["materials"]}
    assert "62 HRC" in steels["52100"]["description"]
    for finish in described["finishes"]:
        low, high = finish["fractal_dimension"]
        assert 1.0 < low <= high < 2.0
        library = read_finishes()[finish["name"]]
        assert finish["fractal_roughness_mm"] == pytest.approx([g / 1e-3 for g in library.fractal_roughness])
        assert finish["roughness_average_um"] == pytest.approx(
            [ra / 1e-6 for ra in library.roughness_average]
        )
        assert finish["roughness_average_um"][0] <= finish["roughness_average_um"][-1] < 100.0
        assert finish["frequency_ratio"] == 1.5


def test_the_form_of_another_drive_has_its_own_keys(zou_file):
    form = form_of(read_case(zou_file.with_name("planar.toml")))
    names = [group["name"] for group in form["groups"]]
    assert names == [
        "drive", "branch", "load", "temperature", "heat", "surface", "materials", "roller", "contact", "compliance",
        "housing", "play", "bearings", "pin_bearing", "input_bearing", "output_bearing", "rolling", "wear",
        "tilt", "form", "lubrication", "fluids", "life", "duty", "dynamics",
    ]  # fmt: skip
    keys = {each["key"]: each for group in form["groups"] for each in group["parameters"]}
    assert keys["contact.*.first_radius"]["meaning"].startswith("Radius of the track of the first roller")
    assert "drive.loading_roller_radius" not in keys
    assert form["contacts"] == ["sp", "pwr", "pwl", "wro", "wlo"]
    assert {"bodies.left", "model.bodies"} <= {each["key"] for each in form["choices"]}
