"""Profiles of tracks in joint files: by hand, what is refused, every type of drive, and who shows them."""

import math
import re

import numpy as np
import pytest
from worn import changed

from asperity.drive.types import TYPES
from asperity.errors import InputError
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import replace_values, si_values
from asperity.joint_file.solved_document import solved_case
from asperity.joint_file.stated_parts import stated_parts
from asperity.joint_file.template import names_of_templates, template
from asperity.joint_file.wear import wear_of_case
from asperity.results.crown_document import crown_document
from asperity.show.drive_notes import crown_lines


def case_of(lines, name="planetary", changes=None):
    return parse_case(
        changed(template(name), changes or {}).replace("[drive]\n", f"[drive]\n{lines}\n", 1),
        source="profiled.toml",
    )


def steel(joint):
    """E* of two bodies of the first material [Pa]."""
    material = joint.materials[0]
    return float(material.youngs_modulus) / (2.0 * (1.0 - float(material.poisson_ratio) ** 2))


def test_coefficients_by_hand():
    """A = 0.00035 D of the planet, F/(B pi E*) of the sun: in the middle 8 A/B^2, and both add."""
    joint = joint_from_case(
        case_of('planet_profile = "iso_16281"\nsun_profile = "logarithmic"\nsun_profile_load = "800 N"')
    )
    length = float(joint.contact_lengths[0])
    planet = 0.00035 * 2.0 * float(joint.drive.second_radius[0])
    sun = 800.0 / length / (math.pi * steel(joint))
    assert [float(value) for value in joint.crown_curvatures] == pytest.approx(
        [8.0 * (planet + sun) / length**2, 8.0 * planet / length**2], rel=1e-9
    )
    assert joint.logarithmic_crowns == (True, True)


def test_a_crown_in_one_contact_and_a_profile_in_the_other():
    joint = joint_from_case(
        case_of('ring_profile = "logarithmic"\nring_profile_load = "800 N"\nsun_crown_radius = "2 m"')
    )
    assert joint.logarithmic_crowns == (False, True)
    assert float(joint.crown_curvatures[0]) == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        ('sun_profile = "logarithmic"', "drive.sun_profile = 'logarithmic': drive.sun_profile_load is missing"),
        ('sun_profile_load = "800 N"', "drive.sun_profile_load = '800 N': only for drive.sun_profile = "),
        ('sun_profile = "iso_16281"\nsun_profile_load = "800 N"', "drive.sun_profile_load = '800 N': only for"),
        ('sun_profile = "iso_16281"\nsun_crown_radius = "1 m"', "drive.sun_crown_radius is stated too"),
        ('sun_profile = "iso_16281"\nplanet_crown_radius = "1 m"', "drive.sun_profile, drive.planet_crown_radius: a "
         "circle meets a logarithmic profile in contact sp, which is not computed"),
        ('ring_profile = "iso_16281"', "drive.ring_profile"),
        ('sun_profile = "lundberg"', "drive.sun_profile"),
        ('sun_profile = "logarithmic"\nsun_profile_load = "0 N"', "drive.sun_profile_load: 0 N is not allowed"),
    ],
)  # fmt: skip
def test_what_is_no_profile_is_refused(lines, message):
    with pytest.raises(InputError, match=re.escape(message)):
        case_of(lines)


def test_the_standard_holds_up_to_two_and_a_half_diameters():
    long = {'contact_length = "10 mm"': 'contact_length = "60 mm"'}
    with pytest.raises(
        InputError, match=r"contact sp is 60 mm long, more than 2\.5 times the diameter of the roller, 50 mm"
    ):
        case_of('sun_profile = "iso_16281"', changes=long)
    case_of('sun_profile = "iso_16281"', changes={'contact_length = "10 mm"': 'contact_length = "50 mm"'})


def test_listed_contacts_of_a_track_have_one_profile_and_rings_none_of_the_standard():
    def listed(which, line):
        text = template("planar")
        places = [match.end() for match in re.finditer(r"\[\[contact\]\]\n", text)]
        for place in sorted((places[number] for number in which), reverse=True):
            text = text[:place] + line + "\n" + text[place:]
        return parse_case(text, source="profiled.toml")

    kinds = [(entry.first, entry.second, entry.internal) for entry in listed([], "").contact]
    sun = [number for number, (first, *_) in enumerate(kinds) if first == "sun"]
    joint = joint_from_case(listed(sun, 'first_profile = "iso_16281"'))
    assert [number for number, profiled in enumerate(joint.logarithmic_crowns) if profiled] == sun
    ring = next(number for number, (*_, internal) in enumerate(kinds) if internal)
    with pytest.raises(InputError, match="ISO/TS 16281 has a profile for rollers, none for rings"):
        listed([ring], 'second_profile = "iso_16281"')
    with pytest.raises(InputError, match="a track has one profile: give it in every contact"):
        listed([ring], 'second_profile = "logarithmic"\nsecond_profile_load = "1000 N"')


def _outer_tracks(name):
    kind = TYPES[name if name in TYPES else "planetary"]
    return dict.fromkeys(track for contact in kind.contacts for track in kind.tracks(contact))


@pytest.mark.parametrize("name", [name for name in names_of_templates() if name != "planar"])
def test_every_type_of_drive_takes_profiles_on_every_track(name):
    """No end is loaded, whatever the load, and the peak is above the mean."""
    lines = "\n".join(
        f'{track}_profile = "logarithmic"\n{track}_profile_load = "300 N"' for track in _outer_tracks(name)
    )
    solved = solved_case(case_of(lines, name))
    assert all(solved.joint.logarithmic_crowns)
    found = solved.result.diagnostics
    assert np.all(np.asarray(found.end_line_load_ratio) == 0.0)
    assert np.all(np.asarray(found.peak_line_load_ratio) > 1.0)
    assert np.all(np.asarray(found.loaded_length_share) <= 1.0)


def test_a_profile_for_more_load_costs_interference_and_the_crown_document_knows_it():
    one, more = (
        solved_case(case_of(f'sun_profile = "logarithmic"\nsun_profile_load = "{load} N"'))
        for load in (400, 4000)
    )
    assert float(one.result.rest.normal[0]) > float(more.result.rest.normal[0])  # of one interference
    stated = crown_document(more, 0.2e-3)["contacts"]["sp"]["profiles"][0]
    length = float(more.joint.contact_lengths[0])
    assert stated["coefficient_m"] == pytest.approx(4000.0 / length / (math.pi * steel(more.joint)), rel=1e-9)
    assert not stated["edge"]


def test_studies_vary_the_load_of_a_profile():
    case = case_of('sun_profile = "logarithmic"\nsun_profile_load = "400 N"')
    twice = joint_from_values(replace_values(si_values(case), {"drive.sun_profile_load": 800.0}))
    once = joint_from_case(case)
    assert float(twice.crown_curvatures[0]) == pytest.approx(2.0 * float(once.crown_curvatures[0]), rel=1e-12)


def test_drawings_and_assumptions_name_it_and_wear_refuses_it():
    case = case_of('sun_profile = "logarithmic"\nsun_profile_load = "400 N"\nplanet_profile = "iso_16281"')
    joint = joint_from_case(case)
    stated = stated_parts(case, joint)
    assert crown_lines(stated, 0) == [
        "profile of track sp along the axis: logarithmic (Lundberg) for 400 N of normal force"
    ]
    assert crown_lines(stated, 1) == ["profile of track sp, pr along the axis: ISO/TS 16281"]
    assert "logarithmic profiles: for each contact" in " ".join(assumptions(case, joint))
    with pytest.raises(InputError, match="how they wear is not computed; state crowns"):
        wear_of_case(case)
