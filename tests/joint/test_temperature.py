"""Joints of drives at their working temperature: by hand, by the paper's drive, and by equivalent joints."""

import dataclasses

import numpy as np
import pytest

from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.errors import InputError
from asperity.joint.evaluation import evaluate
from asperity.joint.fit import refuse_loose
from asperity.joint.solve import solution_of, solve_joint
from asperity.joint.status import STATUS_NAMES, joint_status
from asperity.joint.temperature import at_temperature, contact_expansion, temperature_curves
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import parse_case
from asperity.results.document import joint_document
from asperity.results.solved import solved_with_capacities

SPRINGS = {'bodies = "exact"': 'bodies = "springs"'}


def warm(working, assembly="20 degC", more=""):
    return f'[temperature]\nassembly = "{assembly}"\nworking = "{working}"\n{more}\n\n[model]'


@pytest.fixture(scope="module")
def planetary_at(planar_case):
    """The planetary example in a ring of aluminium, as springs; library: 52100 12.6, 6061-T6 23.6 um/m/K."""

    def case(working, *, ring="6061-T6", more="", **replaced):
        pieces = {
            **SPRINGS,
            'ring = "52100"': f'ring = "{ring}"',
            'ring_support = "free" ': 'ring_support = "rigid_housing" ',
            "[model]": warm(working, more=more),
            **replaced,
        }
        return planar_case("planetary", replaced=pieces)

    return case


def test_an_aluminium_ring_outgrows_steel_rollers(planetary_at):
    """11e-6 1/K of difference, 50 mm, 30 K: 16.5 of the 30 um."""
    joint = joint_from_case(planetary_at("50 degC"))
    assert float(joint.fit.interference) == pytest.approx(30e-6, rel=1e-12)
    assert float(joint.fit.thermal_change) == pytest.approx(-16.5e-6, rel=1e-9)
    assert np.asarray(joint.working_pattern) == pytest.approx([0.0, 13.5 / 30.0], rel=1e-9, abs=1e-15)
    cold = joint_from_case(planetary_at("-10 degC"))
    assert float(cold.fit.thermal_change) == pytest.approx(16.5e-6, rel=1e-9)


def test_one_material_keeps_its_interference(planetary_at):
    joint = joint_from_case(planetary_at("80 degC", ring="52100"))
    assert float(joint.fit.thermal_change) == 0.0
    assert np.asarray(joint.working_pattern) == pytest.approx([0.0, 1.0], abs=0.0)


def test_an_aluminium_housing_moves_a_steel_ring(planetary_at):
    """A ring of 8 mm around 50 mm in plane strain; the last factor is Lame's for a pulled ring with a free bore."""
    joint = joint_from_case(planetary_at("50 degC", ring="52100", more='housing_expansion = "23.6e-6 1/K"'))
    poisson = float(joint.materials[2].poisson_ratio)
    nu = poisson / (1.0 - poisson)
    factor = 2.0 / (1.0 - nu + (1.0 + nu) * (50.0 / 58.0) ** 2)
    assert float(joint.fit.thermal_change) == pytest.approx(-11e-6 * factor * 50e-3 * 30.0, rel=1e-6)


def test_a_free_ring_does_not_follow_a_housing(planetary_at):
    joint = joint_from_case(planetary_at("50 degC"))
    free = dataclasses.replace(
        joint, shapes=tuple(dataclasses.replace(shape, support="free") for shape in joint.shapes)
    )
    alone = contact_expansion(free, housing_expansion=None)
    assert contact_expansion(free, housing_expansion=50e-6) == pytest.approx(np.asarray(alone), rel=0.0)
    assert not np.allclose(contact_expansion(joint, housing_expansion=50e-6), alone)


def test_a_preload_by_force_does_not_move(planetary_at):
    case = planetary_at("50 degC", **{'interference = "30 um"': 'preload = "1000 N"'})
    joint = joint_from_case(case)
    assert joint.fit is None
    assert joint.preload == 1000.0


def test_a_loose_joint_is_refused_with_its_temperature(planetary_at):
    joint = joint_from_case(planetary_at("120 degC"))
    with pytest.raises(InputError, match=r"loose .* 120 degC.*30 um.*100 K take 55 um.*above 74\.55 degC"):
        refuse_loose(joint.fit)


def solved(joint):
    numbers = as_numbers(joint)
    return at_once(evaluate, numbers)


@pytest.mark.long
def test_it_is_the_joint_with_the_interference_that_is_left(planetary_at):
    """With 13.5 um and no temperature everything is the same; status, document and curve agree with it."""
    joint = joint_from_case(planetary_at("50 degC"))
    plain = dataclasses.replace(joint, fit=None, interference=13.5e-6)
    solution, expected = solve_joint(joint), solved(plain)
    found = solution.result
    assert float(found.interference) == pytest.approx(13.5e-6, rel=1e-9)
    for of in (
        lambda each: each.preload,
        lambda each: each.forces.normal,
        lambda each: each.assembly.stiffness.output,
        lambda each: each.rolling.speed_loss,
    ):
        np.testing.assert_allclose(of(found), of(expected), rtol=1e-8)
    told = joint_document(solved_with_capacities(joint, solution), inputs={}, assumptions=())["preload"]
    assembled = solved(dataclasses.replace(plain, interference=30e-6))
    assert told["force_N"] == pytest.approx(float(expected.preload), rel=1e-8)
    assert told["at_assembly"]["force_N"] == pytest.approx(float(assembled.preload), rel=1e-8)
    assert told["at_assembly"]["thermal_change_m"] == pytest.approx(-16.5e-6, rel=1e-9)
    assert told["at_assembly"]["loose_temperature_degC"] == pytest.approx(20.0 + 30.0 / 0.55)
    curves = temperature_curves(joint, lambda temperature: solution_of(at_temperature(joint, temperature)))
    at = np.asarray(curves.temperature)
    assert float(np.interp(20.0, at, curves.preload)) == pytest.approx(float(assembled.preload), rel=1e-3)
    assert float(np.interp(50.0, at, curves.stiffness)) == pytest.approx(
        float(found.assembly.stiffness.output), rel=2e-3
    )
    assert float(np.interp(50.0, at, curves.standing_torque_capacity)) == pytest.approx(
        float(solution.standing_capacity.output_torque), rel=1e-2
    )
    # over 74.5 degC nothing is left; the axis ends at 70 degC
    assert np.all(np.asarray(curves.preload) > 0.0)
    hot = joint_from_case(planetary_at("120 degC"))
    assert STATUS_NAMES[int(joint_status(hot, solved(hot)))] == "no_interference_left"


@pytest.mark.long
def test_the_papers_drive_as_rollers_and_contacts(planar_case, joint_text):
    """Rollers of steel in a ring of aluminium with 12.6 and 23.6 um/m/K: both types of file make one joint."""
    text = joint_text.replace('preload = "1000 N"', 'interference = "13 um"').replace('"steel"', '"52100"')
    text = text.replace('ring = "52100"', 'ring = "6061-T6"').replace(
        'ring_wall_thickness = "60 mm"', 'ring_wall_thickness = "20 mm"'
    )
    text = text.replace("[model]", warm("35 degC")).replace('"printed"', '"unity"')
    own = joint_from_case(parse_case(text, source="x"))
    joint = joint_from_case(
        planar_case(
            "planar",
            replaced={
                'preload = "1000 N" ': 'interference = "13 um" ',
                'ring = "52100"': 'ring = "6061-T6"',
                "[model]": warm("35 degC"),
            },
        )
    )
    assert float(joint.fit.thermal_change) == pytest.approx(float(own.fit.thermal_change), rel=1e-9)
    found, same = solved(joint), solved(own)
    assert float(found.interference) == pytest.approx(13e-6 - 11e-6 * 40e-3 * 15.0, rel=1e-9)
    assert float(found.preload) == pytest.approx(float(same.preload), rel=1e-9)
    assembled = solved(dataclasses.replace(joint, fit=None))
    assert float(found.preload) < 0.6 * float(assembled.preload)


@pytest.mark.long
def test_two_rings_of_unlike_metals_by_the_interference_of_each(planar_case):
    """Each ring keeps its own interference, 12.6e-6 1/K of planets, and the sun's contact its displacement of them."""
    joint = joint_from_case(
        planar_case(
            "stepped_planet",
            replaced={
                'driven_ring = "52100"': 'driven_ring = "6061-T6"',
                "[model]": warm("30 degC"),
            },
        )
    )
    drive = joint.drive
    lost = 11e-6 * 10.0 * float(drive.second_radius[2])
    size = float(joint.interference)
    plain = dataclasses.replace(joint, fit=None, pattern=(0.0, 1.0, 1.0 - lost / size))
    # the bodies are linearised around forces for equal interferences, and for the given ones
    np.testing.assert_allclose(solved(joint).forces.normal, solved(plain).forces.normal, rtol=1e-4)
