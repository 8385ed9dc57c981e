"""Materials and surfaces of a joint file: what they need, and what excludes what."""

import pytest
from pydantic import ValidationError

from asperity.errors import InputError
from asperity.joint_file.material_entries import MaterialEntry, SurfaceEntry, one_kind_of_roughness

STEEL = {
    "youngs_modulus": "206 GPa",
    "poisson_ratio": 0.3,
    "density": "7850 kg/m^3",
    "yield_strength": "450 MPa",
}
GROUND = {"fractal_dimension": 1.4, "frequency_ratio": 1.5}


@pytest.mark.parametrize(
    ("hardnesses", "found"),
    [({}, "neither"), ({"hardness": "1 GPa", "hardness_factor": 2.8}, "both")],
)
def test_a_material_has_one_hardness(hardnesses, found):
    with pytest.raises(
        ValidationError, match=f"exactly one of 'hardness' and 'hardness_factor'.*got {found}"
    ):
        MaterialEntry.model_validate({**STEEL, **hardnesses})


def test_numbers_are_in_si():
    entry = MaterialEntry.model_validate({**STEEL, "hardness": "1.26 GPa", "thermal_expansion": "12 um/m/K"})
    assert entry.youngs_modulus.value == pytest.approx(206e9, rel=1e-15)
    assert entry.hardness.value == pytest.approx(1.26e9, rel=1e-15)
    assert entry.thermal_expansion.value == pytest.approx(12e-6, rel=1e-15)
    assert entry.fatigue_strength is None


@pytest.mark.parametrize(
    ("given", "found"),
    [({}, "neither"), ({"fractal_roughness": "1e-8 mm", "roughness_average": "0.1 um"}, "both")],
)
def test_a_surface_has_one_roughness(given, found):
    with pytest.raises(
        ValidationError, match=f"exactly one of 'fractal_roughness' and 'roughness_average'.*got {found}"
    ):
        SurfaceEntry.model_validate(GROUND | given)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (GROUND, "leave fractal_dimension, frequency_ratio out"),
        ({"roughness_average": "0.1 um"}, "leave roughness_average out"),
        ({"rms_height": "0.2 um +- 0.2 um"}, "its tolerance has to be smaller"),
    ],
)
def test_the_heights_alone_are_all_that_their_law_knows(given, said):
    alone = SurfaceEntry.model_validate({"rms_height": "0.2 um"})
    assert alone.rms_height.value == pytest.approx(2e-7)
    with pytest.raises(ValidationError, match=said):
        SurfaceEntry.model_validate({"rms_height": "0.2 um"} | given)


def test_a_fractal_surface_has_both_its_numbers():
    with pytest.raises(ValidationError, match=r"\.frequency_ratio: this key is missing"):
        SurfaceEntry.model_validate({"fractal_dimension": 1.4, "fractal_roughness": "1e-8 mm"})


def test_all_contacts_have_one_contact_law():
    fractal = SurfaceEntry.model_validate(GROUND | {"fractal_roughness": "1e-8 mm"})
    by_heights = SurfaceEntry.model_validate({"rms_height": "0.2 um"})
    assert one_kind_of_roughness({"sp": fractal, "pr": fractal})["sp"] is fractal
    with pytest.raises(InputError, match=r"one contact law for all contacts: pr by rms_height, sp fractal"):
        one_kind_of_roughness({"sp": fractal, "pr": by_heights})


@pytest.mark.parametrize(
    ("given", "names"),
    [
        ({"cut_off": "0.8 mm"}, "cut_off"),
        ({"partner_roughness_average": "0.2 um"}, "partner_roughness_average"),
        (
            {"cut_off": "0.8 mm", "partner_roughness_average": "0.2 um"},
            "partner_roughness_average and cut_off",
        ),
    ],
)
def test_what_belongs_to_an_average_is_refused_without_it(given, names):
    with pytest.raises(ValidationError, match=f"{names}: only with roughness_average"):
        SurfaceEntry.model_validate(GROUND | {"fractal_roughness": "1e-8 mm"} | given)
    stated = SurfaceEntry.model_validate(GROUND | {"roughness_average": "0.1 um"} | given)
    assert stated.roughness_average.value == pytest.approx(1e-7)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (
            {"lay_ratio": 3},
            "lay: this key is missing, without which lay_ratio says nothing: give .rolling. or .axis.",
        ),
        ({"lay": "axis"}, "lay_ratio: this key is missing, without which lay says nothing: give e.g. 10"),
        (
            {"lay_ratio": 0.5, "lay": "axis"},
            "0.5 is not allowed; it must be at least 1 and at most 1e6: heights are correlated further along the "
            "grooves than across them: give the reciprocal with the other lay",
        ),
        ({"lay_ratio": 3, "lay": "across"}, "Input should be 'rolling' or 'axis'"),
    ],
)
def test_grooves_have_a_ratio_and_a_direction(given, said):
    stated = SurfaceEntry.model_validate({"rms_height": "0.2 um", "lay_ratio": 3, "lay": "rolling"})
    assert (stated.lay_ratio.value, stated.lay) == (3.0, "rolling")
    with pytest.raises(ValidationError, match=said):
        SurfaceEntry.model_validate({"rms_height": "0.2 um"} | given)


def test_contacts_with_and_without_grooves_have_one_law():
    """A lay is no kind of roughness."""
    average = GROUND | {"roughness_average": "0.1 um"}
    plain, grooved = (
        SurfaceEntry.model_validate(average | lay) for lay in ({}, {"lay_ratio": 3, "lay": "axis"})
    )
    surfaces = {"sp": plain, "pr": grooved}
    assert one_kind_of_roughness(surfaces) is surfaces
