"""What a joint file leaves out, in words."""

import re

import pytest

from asperity.joint.temperature import thermal_interference
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case
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
    held = "without compliance.sun_support_stiffness: the sun is held rigidly"
    assert any(held in each for each in assumptions(parse_case(text, source="x")))
    stated = text + '\n[compliance]\nsun_support_stiffness = "50 N/um"\n'
    assert not any(held in each for each in assumptions(parse_case(stated, source="x")))
    assert not any("branch" in each for each in assumptions(parse_case(joint_text, source="x")))


def test_a_free_ring_between_unequal_branches_is_told(joint_text):
    text = joint_text.replace('preload = "1000 N"', 'interference = "13 um"') + 3 * "\n[[branch]]\n"
    free = text.replace('ring_support = "rigid_housing"', 'ring_support = "free"')
    for each, told in ((text, False), (free, True)):
        found = assumptions(parse_case(each, source="x"))
        assert any("overstates the differences between their preloads" in line for line in found) is told


def test_what_the_temperature_would_add_to_a_stated_preload_is_told_in_micrometres(joint_text):
    section = '[temperature]\nassembly = "20 °C"\nworking = "60 °C"\nhousing_expansion = "23.6e-6 1/K"\n\n'
    text = re.sub(r'= "steel"', '= "52100"', joint_text).replace("[model]", section + "[model]")
    case = parse_case(text, source="x")
    (note,) = (each for each in assumptions(case) if "by temperature" in each)
    change = thermal_interference(joint_from_case(case), temperature_rise=40.0, housing_expansion=23.6e-6)
    assert change < -1e-6  # aluminium around steel becomes loose
    told = float(re.search(r"(\S+) µm of interference by temperature", note)[1])
    assert told == pytest.approx(1e6 * float(change), rel=5e-3)
