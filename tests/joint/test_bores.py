"""Pins that press in bores: planetaries by hand, wind-up against the assembly, stepped rollers, refusals."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.body.bore import bore_compliance
from asperity.body.shapes import Annulus
from asperity.errors import InputError
from asperity.joint.bores import bore_stiffness, pins_in_bores, refuse_pins
from asperity.joint.evaluation import laws_and_states
from asperity.joint.solve import solve_joint

ARCMIN = math.pi / 180.0 / 60.0
#: Hollow planet of 20 and 13 mm radius, 10 mm long, dragged by a newton at both contacts and held by its pin, by plane
#: finite elements: how far it gives way beyond a force on its rim (208 GPa), and how far each contact parts (206 GPa).
GIVES, PARTS = 5.35e-9 * 208e9 / 0.91, 3.953e-9 * 206e9 / 0.91


@pytest.fixture(scope="module")
def hollow(planar_joint):
    """The hollow planetary example as it is, and on pins that fit its bores, with their solutions."""
    pins = {"[model]": '[bearings]\npin_diameter = "26 mm"\n\n[model]'}
    joints = planar_joint("planetary_hollow"), planar_joint("planetary_hollow", pins)
    return [(joint, solve_joint(joint)) for joint in joints]


def stiffness(solution):
    return float(solution.result.assembly.stiffness.output)


@pytest.mark.long
def test_a_hollow_planet_on_its_pin_by_hand(hollow):
    """525 N·m/arcmin become 274 under constant normal forces, and 298 where a squeezed planet gives way to its pin.

    Of a newton metre at the output each of three planets bears T = 50/9 N at either contact, its pin twice that. The
    loop of sun, planet and ring gives way by C to a normal force; its interference stays, dN = -dT parts/C.
    """
    (bare, without), (joint, found) = hollow
    steel = joint.materials[1]
    modulus = steel.youngs_modulus / (1.0 - steel.poisson_ratio**2)
    gives, parts = GIVES / modulus, PARTS / modulus
    tighter = solve_joint(dataclasses.replace(bare, interference=1.01 * bare.interference))
    loop = 0.01 * bare.interference / float(tighter.result.preload - without.result.preload)

    def with_planets(added):
        return ARCMIN / (1.0 / stiffness(without) + 3.0 * (50.0 / 9.0) ** 2 * added)

    assert stiffness(without) * ARCMIN == pytest.approx(525.4, rel=1e-3)
    assert with_planets(gives) == pytest.approx(274.0, rel=0.01)
    assert stiffness(found) * ARCMIN == pytest.approx(with_planets(gives - parts**2 / loop), rel=0.01)
    fallen = np.asarray(found.result.forces.normal - without.result.forces.normal)
    assert fallen == pytest.approx(-500.0 / 9.0 * parts / loop, rel=0.03)
    # without torque nothing presses in the bores
    assert np.asarray(found.result.rest.normal) == pytest.approx(
        np.asarray(without.result.rest.normal), rel=1e-9
    )


@pytest.mark.long
def test_the_drive_winds_up_as_its_assembly_gives_way(hollow):
    """What pins add to the wind-up of the standing drive and to the compliance of the assembly, without torque."""

    def turned(joint):
        _, states = laws_and_states(dataclasses.replace(joint, output_torque=0.5))
        return float(np.abs(np.asarray(states.standing.rotation)).max())

    (bare, _), (joint, _) = hollow
    at_rest = [stiffness(solve_joint(dataclasses.replace(each, output_torque=0.0))) for each in (bare, joint)]
    added = 1.0 / at_rest[1] - 1.0 / at_rest[0]
    assert (turned(joint) - turned(bare)) / 0.5 == pytest.approx(added, rel=0.05)


@pytest.mark.long
def test_both_senses_are_alike(hollow):
    _, (joint, found) = hollow
    back = solve_joint(dataclasses.replace(joint, output_torque=-joint.output_torque))
    assert stiffness(back) == pytest.approx(stiffness(found), rel=1e-4)
    assert float(found.result.assembly.pin_share) > 0.3


@pytest.mark.long
def test_a_solid_planet_with_a_pin_of_12_mm(planar_joint, planetary):
    _, solution, _ = planetary
    pins = {"[model]": '[bearings]\npin_diameter = "12 mm"\n\n[model]'}
    changed = stiffness(solve_joint(planar_joint("planetary", pins))) / stiffness(solution)
    assert changed == pytest.approx(0.83, abs=0.01)


@pytest.mark.long
def test_the_bore_of_a_loading_roller_counts_more_than_its_pin(planar_joint):
    """4 mm in 10 mm: the bore makes the squeezed roller 15 % softer, the pressure of its pin changes that by 0.2 %."""
    pins = (
        '[bearings]\nsun_torque = "0 N*m"\nloading_roller_torque = "0 N*m"\ncarrier_torque = "0 N*m"\n'
        'pin_friction_coefficient = 0\npin_diameter = "4 mm"\n\n[model]'
    )
    bored = {"[drive]": '[drive]\nloading_roller_bore_diameter = "4 mm"'}
    solid, hollow, pinned = (
        stiffness(solve_joint(planar_joint("zou2025", replaced)))
        for replaced in ({}, bored, {"[model]": pins})
    )
    assert hollow / solid == pytest.approx(0.845, abs=0.01)
    assert pinned / hollow == pytest.approx(1.0, abs=0.006)


def test_tracks_of_a_stepped_planet_give_way_beside_each_other(planar_joint):
    joint = planar_joint("stepped_planet", {"[model]": '[bearings]\npin_diameter = "8 mm"\n\n[model]'})
    steel, lengths = joint.materials[1], {float(length) for length in joint.contact_lengths}
    assert len(lengths) == 1
    each = [
        Annulus(
            4e-3, radius, lengths.copy().pop(), steel.youngs_modulus, steel.poisson_ratio, 0.0, 0.0, "outer",
            joint.plane_state,
        )
        for radius in sorted({float(radius) for radius in np.asarray(joint.drive.second_radius)[:1]}
                             | {float(radius) for radius in np.asarray(joint.drive.first_radius)[1:]})
    ]  # fmt: skip
    alone = [
        bore_compliance(body=body, contact_angles=np.zeros(1), push_angle=0.0).push_compliance
        for body in each
    ]
    bores = pins_in_bores(joint)
    assert float(bore_stiffness(joint)[0]) == pytest.approx(sum(1.0 / float(own) for own in alone), rel=1e-12)
    assert not np.any(np.asarray(bores.along_normal))


def test_pins_that_do_not_fit_their_bores_are_refused(planar_joint):
    wide = {"[model]": '[bearings]\npin_diameter = "27 mm"\n\n[model]'}
    with pytest.raises(InputError, match="27 mm do not fit into the bores of planet"):
        refuse_pins(planar_joint("planetary_hollow", wide))
    thick = {"[model]": '[bearings]\npin_diameter = "41 mm"\n\n[model]'}
    with pytest.raises(InputError, match="must be below the diameter of planet"):
        refuse_pins(planar_joint("planetary", thick))
