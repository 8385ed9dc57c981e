"""What a joint file says of its parts: tolerances, crowns and surfaces at the right body."""

import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.stated_parts import stated_parts

CHANGES = {
    "zou2025": {
        'sun_radius = "4 mm"': 'sun_radius = "4 mm +- 1 um"',
        'loading_roller_radius = "5 mm"': 'loading_roller_radius = "5 mm +- 2 um"\nloading_roller_crown_radius = "3 m"',
        'ring_radius = "40 mm"': 'ring_radius = "40 mm +- 4 um"',
        'preload = "1000 N"': 'interference = "13 um +- 1 um"',
        'ring_wall_thickness = "60 mm"': 'ring_wall_thickness = "60 mm +- 0.1 mm"',
    },
    "stepped_planet": {
        'planet_second_radius = "18 mm"': 'planet_second_radius = "18 mm +- 3 um"',
        'interference = "30 um"': 'interference = "30 um +- 2 um"',
        'driven_ring_wall_thickness = "10 mm"': 'driven_ring_wall_thickness = "10 mm +- 0.1 mm"',
    },
}


def of(planar_case, name):
    case = planar_case(name, *CHANGES[name].items())
    joint = joint_from_case(case)
    stated = stated_parts(case, joint)
    return {body.name: part for body, part in zip(joint.drive.bodies, stated.bodies, strict=True)}, stated


def test_both_loading_rollers_have_one_tolerance_and_the_ring_that_of_the_interference_too(planar_case):
    parts, _ = of(planar_case, "zou2025")
    assert parts["sun"].tolerance(4e-3) == pytest.approx(1e-6)
    assert parts["planet"].tolerance(13.5e-3) == 0.0
    for name in ("left_loading_roller", "right_loading_roller"):
        (track,) = parts[name].tracks
        assert (track.tolerance, track.crown) == pytest.approx((2e-6, 3.0))
    assert parts["ring"].tolerance(40e-3) == pytest.approx(
        5e-6
    )  # 4 µm of the radius, 1 µm of the interference
    assert parts["ring"].wall == pytest.approx(1e-4)
    assert {part.material for part in parts.values()} == {"steel"}


def test_tracks_of_a_stepped_planet_are_told_apart_and_so_are_the_rings(planar_case):
    parts, stated = of(planar_case, "stepped_planet")
    assert parts["planet"].tolerance(18e-3) == pytest.approx(3e-6)
    assert parts["planet"].tolerance(20e-3) == 0.0
    assert (parts["held_ring"].wall, parts["driven_ring"].wall) == pytest.approx((0.0, 1e-4))
    for ring in ("held_ring", "driven_ring"):  # sized by the others: the interference is their only tolerance
        assert [track.tolerance for track in parts[ring].tracks] == pytest.approx([2e-6])
    assert len(stated.surfaces) == 3


@pytest.mark.parametrize(
    ("written", "words"),
    [
        ('roughness_average = "0.2 um +- 0.05 um"', "Ra 0.2 ±0.05 µm"),
        (
            'roughness_average = "0.2 um"\npartner_roughness_average = "0.1 um"',
            "Ra 0.2 µm, its partner Ra 0.1 µm",
        ),
        ('mean_roughness_depth = "1 um"', "Rz 1 um"),
        ('fractal_roughness = "1e-8 mm"', "D 1.5, G 1e-11 m of both bodies together; no Ra stated"),
    ],
)
def test_surfaces_in_words(planar_case, written, words):
    case = planar_case("planetary", ('fractal_roughness = "1.3e-7 mm"', written))
    assert stated_parts(case, joint_from_case(case)).surfaces == (words, words)


def test_listed_drives_state_tolerances_at_their_contacts(planar_case):
    case = planar_case("planar", ('first_radius = "4 mm"', 'first_radius = "4 mm +- 2 um"'))
    joint = joint_from_case(case)
    sun = next(n for n, body in enumerate(joint.drive.bodies) if body.name == "sun")
    assert stated_parts(case, joint).bodies[sun].tolerance(4e-3) == pytest.approx(2e-6)


def test_the_drawing_has_the_largest_form_error_of_all_sectors(planar_case):
    form = (
        '[[form]]\npart = "planet_second"\nsector = 1\nrunout = "2 um"\n\n'
        '[[form]]\npart = "planet_second"\nsector = 2\nrunout = "3 um"\n\n[surface]'
    )
    case = planar_case("stepped_planet", ("[surface]", form))
    joint = joint_from_case(case)
    found = {
        body.name: part.form
        for body, part in zip(joint.drive.bodies, stated_parts(case, joint).bodies, strict=True)
    }
    assert found["planet"] == ("runout 3 µm of track planet second (full readings)",)
    assert found["sun"] == ()
