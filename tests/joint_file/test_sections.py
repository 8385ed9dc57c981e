"""What the sections of a joint file let through, and how they refuse."""

import tomllib

import pytest
from pydantic import ValidationError

from asperity.errors import InputError
from asperity.joint_file.case_types import DefaultCase
from asperity.joint_file.material_entries import SurfaceEntry

SURFACE = {"fractal_dimension": 1.4, "fractal_roughness": "1e-8 mm", "frequency_ratio": 1.5}
CONTACTS = ("sp", "pwr", "pwl", "wro", "wlo")


@pytest.fixture
def tables(example_text):
    return tomllib.loads(example_text)


def test_units_are_converted_once_and_here(tables):
    case = DefaultCase.model_validate(tables)
    assert case.drive.sun_radius.value == pytest.approx(4e-3, rel=1e-15)
    assert case.load.sun_speed.value == pytest.approx(6000.0 * 3.141592653589793 / 30.0, rel=1e-12)
    assert case.load.preload.text == "1000 N"


def test_one_surface_for_all_contacts_or_one_for_each(tables):
    one = DefaultCase.model_validate({**tables, "surface": SURFACE}).surface
    assert isinstance(one, SurfaceEntry)
    five = {name: {**SURFACE, "fractal_dimension": 1.3 + 0.1 * index} for index, name in enumerate(CONTACTS)}
    each = DefaultCase.model_validate({**tables, "surface": five}).surface
    assert [each[name].fractal_dimension.value for name in CONTACTS] == pytest.approx(
        [1.3, 1.4, 1.5, 1.6, 1.7]
    )
    with pytest.raises(ValidationError, match="wlo"):
        DefaultCase.model_validate({**tables, "surface": dict.fromkeys(CONTACTS[:4], SURFACE)})


def test_a_body_of_an_unknown_material_is_told_the_nearest(tables):
    tables["bodies"]["sun"] = "stel"
    with pytest.raises(
        (InputError, ValidationError), match=r"bodies\.sun: there is no material 'stel'.*steel"
    ):
        DefaultCase.model_validate(tables)
