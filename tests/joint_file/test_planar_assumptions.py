"""What files of other drives leave out, and what is taken instead."""

import pytest

from asperity.joint_file.planar_assumptions import planar_assumptions

NAMES = ("planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar")


@pytest.mark.parametrize("name", NAMES)
def test_assumptions_name_what_is_left_out(name, planar_case):
    told = "\n".join(planar_assumptions(planar_case(name)))
    assert "no section [compliance]: pins and shafts are rigid" in told
    assert ("in one plane" in told) == (planar_case(name).type != "planetary")
    assert "no rolling.hysteresis_factor" in told


def test_what_is_stated_is_no_assumption(planar_case):
    bare = planar_assumptions(
        planar_case(
            "planetary",
            ('bodies = "exact" ', "# "),
            ('plane_state = "plane_strain" ', "# "),
            ('ring_support = "free" ', "# "),
        )
    )
    stated = planar_assumptions(
        planar_case("planetary", ("# [compliance]", "[compliance]"), ("# pin_stiffness", "pin_stiffness"))
    )
    for start in ("no model.bodies", "no model.plane_state", "no drive.ring_support"):
        assert any(told.startswith(start) for told in bare)
        assert not any(told.startswith(start) for told in stated)
    assert "[compliance] without input_shaft_stiffness, output_shaft_stiffness: rigid" in stated


@pytest.mark.parametrize(
    ("dimension", "told"),
    [("1.5", "those of the value in the file"), ('"1.4 +- 0.1"', "those of the middle of its range")],
)
def test_a_surface_by_its_ra_leaves_d_open(planar_case, dimension, told):
    average = planar_case(
        "planetary",
        ("fractal_dimension = 1.5", f"fractal_dimension = {dimension}"),
        ('fractal_roughness = "1.3e-7 mm"', 'roughness_average = "0.1 um"'),
    )
    (said,) = [each for each in planar_assumptions(average) if "Ra leaves D open" in each]
    assert told in said
    assert not any("Ra leaves D open" in each for each in planar_assumptions(planar_case("planetary")))
