"""Interference with which the parts of a drive are made."""

import math
from types import SimpleNamespace

import pytest

from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_values, thermal_change_of
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values
from asperity.joint_file.stated_parts import made_interference

FORCE = ('interference = "30 um"', 'preload = "1000 N"')
WARM = ("\n[model]", '\n[temperature]\nassembly = "20 degC"\nworking = "60 degC"\n\n[model]')
FOUND = SimpleNamespace(interference=28e-6)


def test_that_of_the_file_or_of_the_result(planar_case, joint_text):
    assert made_interference(planar_case("planetary"), FOUND).size == pytest.approx(30e-6)
    assert made_interference(planar_case("planetary", FORCE), FOUND).size == 28e-6
    paper = parse_case(joint_text, source="x")
    assert made_interference(paper, FOUND).size == 28e-6
    stated = parse_case(joint_text.replace('preload = "1000 N"', 'interference = "13 um"'), source="x")
    assert made_interference(stated).size == pytest.approx(13e-6)


@pytest.mark.long
@pytest.mark.parametrize("cam", ["", '\ncam_force_per_torque = "100 N/Nm"'])
@pytest.mark.parametrize("known", [None, SimpleNamespace(interference=math.nan)])
def test_without_a_result_it_is_that_which_makes_the_force_at_rest(planar_case, joint_text, cam, known):
    """Of both kinds of drive, under a cam too, at a torque that is not carried: it gives the force back."""
    for case_of in (
        lambda line: planar_case("planetary", (FORCE[0], line), ('"10 N*m"', '"1e5 N*m"')),
        lambda line: parse_case(
            joint_text.replace('preload = "1000 N"', line).replace('"5 N*m"', '"1e5 N*m"'), source="x"
        ),
    ):
        found = made_interference(case_of(FORCE[1] + cam), known).size
        stated = si_values(case_of(f'interference = "{1e6 * found!r} um"'))
        stated["load"]["output_torque"] = 0.0
        joint = joint_from_values(stated)
        force = float(solve_joint(joint).result.preload)
        assert force == pytest.approx(1000.0, rel=1e-5)


def test_what_temperature_adds_is_left_out_of_that_of_the_papers_drive_too(joint_text):
    """One material keeps its interference; without its expansion it is not known."""
    warm = joint_text.replace(*WARM)
    found = made_interference(parse_case(warm, source="x"), FOUND)
    assert found.size is None
    assert "thermal_expansion of steel" in found.unknown_because
    known = warm.replace("[materials.steel]", '[materials.steel]\nthermal_expansion = "11.5e-6 1/K"')
    assert made_interference(parse_case(known, source="x"), FOUND).size == pytest.approx(28e-6, abs=1e-15)


def test_what_temperature_adds_is_left_out(planar_case):
    """Ceramic planets grow less than their steel ring."""
    case = planar_case("planetary", FORCE, WARM)
    assert made_interference(case, FOUND).size == pytest.approx(28e-6, abs=1e-15)  # one material
    ceramic = planar_case("planetary", FORCE, WARM, ('planet = "52100"', 'planet = "Si3N4"'))
    change = thermal_change_of(si_values(ceramic))
    assert abs(change) > 1e-7
    assert made_interference(ceramic, FOUND).size == pytest.approx(28e-6 - change, rel=1e-12)
