"""Interference with which the parts of a drive are made."""

import math
from types import SimpleNamespace

import pytest

from asperity.joint_file.made_interference import made_interference
from asperity.joint_file.planar_build import thermal_change_of
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values

FORCE = ('interference = "30 um"', 'preload = "1000 N"')
WARM = ("\n[model]", '\n[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n\n[model]')
FOUND = SimpleNamespace(interference=28e-6)


def test_that_of_the_file_or_of_the_result(planar_case, joint_text):
    assert made_interference(planar_case("planetary"), FOUND) == pytest.approx(30e-6)
    pressed = planar_case("planetary", FORCE)
    assert made_interference(pressed, FOUND) == 28e-6
    assert made_interference(pressed) is None
    assert made_interference(pressed, SimpleNamespace(interference=math.nan)) is None
    paper = parse_case(joint_text, source="x")
    assert (made_interference(paper), made_interference(paper, FOUND)) == (None, 28e-6)
    stated = parse_case(joint_text.replace('preload = "1000 N"', 'interference = "13 um"'), source="x")
    assert made_interference(stated) == pytest.approx(13e-6)


def test_under_a_cam_it_is_not_that_of_the_assembly(planar_case):
    cam = ('interference = "30 um"', 'preload = "1000 N"\ncam_force_per_torque = "10 N/Nm"')
    assert made_interference(planar_case("planetary", cam), FOUND) is None


def test_what_temperature_adds_is_left_out(planar_case):
    """Ceramic planets grow less than their steel ring."""
    case = planar_case("planetary", FORCE, WARM)
    assert made_interference(case, FOUND) == pytest.approx(28e-6, abs=1e-15)  # one material
    ceramic = planar_case("planetary", FORCE, WARM, ('planet = "52100"', 'planet = "Si3N4"'))
    change = thermal_change_of(si_values(ceramic))
    assert abs(change) > 1e-7
    assert made_interference(ceramic, FOUND) == pytest.approx(28e-6 - change, rel=1e-12)
