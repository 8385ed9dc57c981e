"""What a joint file leaves out, in words."""

import re

import pytest
from assumed import assumptions

from asperity.joint_file.reader import parse_case


def test_what_the_file_leaves_out_is_told(joint_text):
    sentences = assumptions(parse_case(joint_text, source="x"))
    for section in ("bearings", "compliance", "play"):
        assert any(sentence.startswith(f"no section [{section}]") for sentence in sentences)
    partly = parse_case(joint_text + '[compliance]\npin_stiffness = "100 N/um"\n', source="x")
    assert any("input_shaft_stiffness" in sentence for sentence in assumptions(partly))
    unstated = parse_case(joint_text.replace("ring_support =", "# ring_support ="), source="x")
    assert any("a rigid housing holds the outer rim" in sentence for sentence in assumptions(unstated))
    assert not any("rigid housing" in sentence for sentence in assumptions(partly))
    assert not any("plane strain" in sentence for sentence in assumptions(partly))
    of_before = parse_case(re.sub(r"\n(bodies|plane_state) = .*", "", joint_text), source="x")
    assert any("plane elasticity" in sentence for sentence in assumptions(of_before))
    assert any("plane strain" in sentence for sentence in assumptions(of_before))


def test_a_tolerance_that_does_not_move_the_preload_is_named(joint_text):
    loose = joint_text.replace('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 5 um"')
    (note,) = (
        each for each in assumptions(parse_case(loose, source="x")) if "load.preload is a force" in each
    )
    assert "drive.planet_radius, up to 5 µm" in note
    assert not any(
        "load.preload is a force" in each for each in assumptions(parse_case(joint_text, source="x"))
    )
    free = parse_case(loose.replace('preload = "1000 N"', 'interference = "13 um"'), source="x")
    assert not any("load.preload is a force" in each for each in assumptions(free))


def test_what_holds_the_sun_between_unequal_branches_is_told(joint_text):
    text = joint_text.replace('preload = "1000 N"', 'interference = "13 um"') + 3 * "\n[[branch]]\n"
    held = "without compliance.sun_support_stiffness: the input is held rigidly"
    assert any(held in each for each in assumptions(parse_case(text, source="x")))
    stated = text + '\n[compliance]\nsun_support_stiffness = "50 N/um"\n'
    assert not any(held in each for each in assumptions(parse_case(stated, source="x")))
    assert not any("branch" in each for each in assumptions(parse_case(joint_text, source="x")))


def test_what_the_temperature_would_add_to_a_stated_preload_is_told_in_micrometres(joint_text):
    section = '[temperature]\nassembly = "20 °C"\nworking = "60 °C"\nhousing_expansion = "23.6e-6 1/K"\n\n'
    text = re.sub(r'= "steel"', '= "52100"', joint_text).replace("[model]", section + "[model]")
    case = parse_case(text, source="x")
    (note,) = (each for each in assumptions(case) if "by temperature" in each)
    # aluminium around steel becomes loose: Lamé's ring in plane strain, free inside, pulled at its rim of 100 mm
    inside, outside = 40.0 * (2.0 - 2.0 * 0.29), 100.0 * (1.0 - 2.0 * 0.29) + 40.0**2 / 100.0
    change = -40.0 * (23.6 - 12.6) * 100e-3 * inside / outside
    told = float(re.search(r"(\S+) µm of interference by temperature", note)[1])
    assert told == pytest.approx(change, rel=5e-3)


NAMES = ("planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar")


@pytest.mark.parametrize("name", NAMES)
def test_assumptions_name_what_is_left_out(name, planar_case):
    told = "\n".join(assumptions(planar_case(name)))
    assert "no section [compliance]: shafts are rigid" in told
    assert (
        "no compliance.pin_stiffness: pins are rigid, and stiffness, natural frequencies and K1 to K3" in told
    )
    assert ("in one plane" in told) == (planar_case(name).type != "planetary")
    assert "no rolling.hysteresis_factor" in told
    assert "no section [bearings]: the bearings have no friction" in told
    assert "no section [play]" in told


def test_what_is_stated_is_no_assumption(planar_case):
    bare = assumptions(
        planar_case(
            "planetary",
            ('bodies = "exact" ', "# "),
            ('plane_state = "plane_strain" ', "# "),
            ('ring_support = "free" ', "# "),
        )
    )
    stated = assumptions(
        planar_case("planetary", ("# [compliance]", "[compliance]"), ("# pin_stiffness", "pin_stiffness"))
    )
    for start in ("no model.bodies", "no model.plane_state", "no drive.ring_support"):
        assert any(told.startswith(start) for told in bare)
        assert not any(told.startswith(start) for told in stated)
    assert any(
        told.startswith("[compliance] without") and "input_shaft_stiffness, output_shaft_stiffness" in told
        for told in stated
    )


def test_how_pins_load_their_rollers(planar_case):
    """Without a diameter their force is spread over the rims; drives without pins say neither."""
    pins = ("[model]", '[bearings]\npin_diameter = "12 mm"\n\n[model]')
    in_bore = "bearings.pin_diameter: a pin of its roller's material presses over an arc"
    for replaced, said, not_said in (
        ((), "no bearings.pin_diameter", in_bore),
        ((pins,), in_bore, "no bearings.pin_diameter"),
    ):
        told = assumptions(planar_case("planetary", *replaced))
        assert any(each.startswith(said) for each in told)
        assert not any(each.startswith(not_said) for each in told)


def test_how_pins_give_way(planar_case):
    """Rigid, stated, or as beams of a stated diameter and length; with a stated clearance, or with none."""
    pins = '[bearings]\npin_diameter = "12 mm"\n{}\n[model]'

    def told(more, *others):
        return "\n".join(assumptions(planar_case("planetary", ("[model]", pins.format(more)), *others)))

    rigid = "no compliance.pin_stiffness: pins are rigid"
    bent = "pins bend and shear as beams"
    assert rigid in told("")
    assert bent not in told("")
    long = 'pin_length = "20 mm"\n'
    assert rigid not in told(long)
    assert bent in told(long)
    stated = (("# [compliance]", "[compliance]"), ("# pin_stiffness", "pin_stiffness"))
    assert rigid not in told(long, *stated)
    assert bent not in told(long, *stated)
    assert "none, since the file states no bearings.pin_radial_clearance" in told("")
    assert "is play, which [play] states" in told('pin_radial_clearance = "5 um"\n')


@pytest.mark.parametrize(
    ("name", "bent"),
    [
        ("planetary", ["ring"]),  # free
        ("planetary_hollow", ["planet"]),  # its ring is held
        ("stepped_planet", ["held ring", "driven ring"]),
        ("planar", []),
    ],
)
def test_bodies_that_bend_without_a_fatigue_strength_are_named(planar_case, name, bent):
    case = planar_case(name, ('"52100"', '"440C"'))
    told = [each for each in assumptions(case) if "fatigue_strength" in each]
    assert told == [
        f"no fatigue_strength of material 440C: the fatigue safety of the {body}, which bends, is not computed"
        for body in bent
    ]


@pytest.mark.parametrize(("name", "said"), [("planetary", 1), ("stepped_planet", 1), ("planar", 0)])
def test_a_fatigue_strength_of_the_library_is_that_of_specimens(planar_case, name, said):
    """Once for both rings of one material; not where nothing bends."""
    told = [each for each in assumptions(planar_case(name)) if "fatigue_strength" in each]
    assert (
        told
        == [
            "fatigue_strength of material 52100: 588 MPa of specimens, from the library; the surface and the size of "
            "the finished part may lower it"
        ]
        * said
    )


def test_a_body_with_a_fatigue_strength_is_not_named(planar_case):
    stated = '[materials."52100"]\nlibrary = "52100"\nfatigue_strength = "400 MPa"\n\n[bodies]'
    told = assumptions(planar_case("planetary", ("[bodies]", stated)))
    assert not any("fatigue_strength" in each for each in told)


@pytest.mark.parametrize(
    ("dimension", "told"),
    [("1.5", "those of the value in the file"), ('"1.4 +- 0.1"', "those of the middle of its range")],
)
def test_a_surface_by_its_ra_leaves_d_open(planar_case, dimension, told):
    average = planar_case(
        "planetary",
        ("fractal_dimension = 1.5", f"fractal_dimension = {dimension}"),
        ('fractal_roughness = "1.3e-7 mm"', 'roughness_average = "0.1 um"'),
        ("[model]", '[model]\ncontact_law = "zou_2025"'),
    )
    (said,) = [each for each in assumptions(average) if "Ra leaves D open" in each]
    assert not any("mean_roughness_depth" in each for each in assumptions(average))
    assert told in said
    assert not any("Ra leaves D open" in each for each in assumptions(planar_case("planetary")))


def test_a_surface_by_its_rz_is_taken_of_normal_heights(planar_case):
    """D = 1.5 as the file states it: 0.8 um over 5.8, twice 8 % to both sides."""
    rz = planar_case("planetary", ('fractal_roughness = "1.3e-7 mm"', 'mean_roughness_depth = "0.8 um"'))
    said = [each for each in assumptions(rz) if each.startswith("surface.mean_roughness_depth")]
    assert len(said) == 2
    assert "Rz 0.8 um taken of normally distributed heights, Ra 0.12 um to 0.16 um" in said[0]


def test_temperatures_and_what_they_would_do_to_a_preload_by_force(planar_case):
    """11 um/m/K of difference, 50 mm, 30 K."""
    section = '[temperature]\nassembly = "20 degC"\nworking = "50 degC"\n\n[model]'
    ring = ('ring = "52100"', 'ring = "6061-T6"')
    by_interference = assumptions(planar_case("planetary", ("[model]", section), ring))
    assert any(told.startswith("temperature: the same in all bodies") for told in by_interference)
    assert not any("housing_expansion" in told for told in by_interference)  # the ring is free
    held = ('ring_support = "free" ', 'ring_support = "rigid_housing" ')
    housed = assumptions(planar_case("planetary", ("[model]", section), ring, held))
    assert "no temperature.housing_expansion: the housing expands as the ring does" in housed
    force = ('interference = "30 um"', 'preload = "1000 N"')
    told = "\n".join(assumptions(planar_case("planetary", ("[model]", section), ring, force)))
    assert "load.preload is a force: -16.5 µm of interference by temperature does not move it" in told


def test_form_errors_are_of_first_order_and_have_phases_or_not(joint_text):
    form = '\n[[form]]\npart = "ring"\nharmonics = { 3 = "1 um" }\n'
    for stated, unknown in ((form, True), (form + 'phase = "40 deg"\n', False)):
        case = parse_case(joint_text + stated, source="a")
        told = " ".join(assumptions(case))
        assert "form errors: to first order" in told
        assert ("no form.phase" in told) is unknown


def test_form_errors_are_quasi_static_as_far_as_a_third_of_the_first_frequency(joint_text):
    form = '\n[[form]]\npart = "ring"\nharmonics = { 3 = "1 um" }\n'
    said = [each for each in assumptions(parse_case(joint_text + form, source="a")) if "quasi-static" in each]
    assert said == [
        "form errors: to first order; quasi-static, so that the shortest wave must come below a third of the first "
        "natural frequency (asperity dynamics); in the plane: no tilt and no axial runout; of the drive's own parts "
        "alone"
    ]
    assert not any("quasi-static" in each for each in assumptions(parse_case(joint_text, source="a")))


def test_wear_has_one_coefficient_and_is_even_but_for_crowns(joint_text):
    wear = '\n[wear]\ncoefficient = "1e-17 1/Pa"\n'
    said = [each for each in assumptions(parse_case(joint_text + wear, source="a")) if "Archard" in each]
    assert said == [
        "wear: Archard's law with a constant coefficient, without running-in; tracks wear alike all round, whatever "
        "their runout, and evenly along the axis, but for crowns, which become flatter"
    ]
    assert not any("Archard" in each for each in assumptions(parse_case(joint_text, source="a")))
