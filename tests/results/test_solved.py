"""Sizes, clearances and capacities of a solved planetary drive against its radii and Coulomb's law."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.joint_file.solved_document import solved_case
from asperity.results.all_limits import further_checks
from asperity.results.solved import solved_with_capacities

SUN, PLANET, RING, WALL, LENGTH = 10e-3, 20e-3, 50e-3, 8e-3, 10e-3


@pytest.fixture(scope="module")
def solved(planetary):
    joint, solution, _ = planetary
    return solved_with_capacities(joint, solution)


@pytest.mark.slow
def test_diameter_and_mass_of_discs_and_an_annulus(solved):
    (density,) = {float(material.density) for material in solved.joint.materials}
    discs = SUN**2 + 3.0 * PLANET**2 + (RING + WALL) ** 2 - RING**2
    assert float(solved.size.envelope_diameter) == pytest.approx(2.0 * (RING + WALL), rel=1e-12)
    assert float(solved.size.mass) == pytest.approx(density * math.pi * discs * LENGTH, rel=1e-12)


def test_neighbouring_planets_are_the_clearance(solved):
    assert solved.row_names("clearance") == ("planet_to_planet",)
    assert solved.row_names("contact") == ("sp", "pr")
    (gap,) = solved.clearances
    assert float(gap) == pytest.approx(
        2.0 * (SUN + PLANET) * math.sin(math.pi / 3.0) - 2.0 * PLANET, rel=1e-12
    )


def test_each_direction_has_its_capacity(solved, planetary):
    """n mu N R_s at the sun, times its speed over the carrier's, 2 (R_s + R_p)/R_s; N changes little by the torque."""
    joint, solution, _ = planetary
    normal = float(np.asarray(solution.result.forces.normal)[0])
    slip = 3.0 * 0.08 * normal * SUN * 2.0 * (SUN + PLANET) / SUN
    assert float(solved.standing_capacity.output_torque) == pytest.approx(slip, rel=0.01)
    assert float(solved.standing_capacity_of_direction.output_torque) == float(
        solved.standing_capacity.output_torque
    )
    apart = dataclasses.replace(  # capacities that differ, to tell the directions apart
        solution,
        **{
            name: dataclasses.replace(getattr(solution, name), output_torque=np.asarray(torque))
            for name, torque in (
                ("standing_capacity", 1.0),
                ("reverse_standing_capacity", 2.0),
                ("rolling_capacity", 3.0),
                ("reverse_rolling_capacity", 4.0),
            )
        },
    )
    for torque, of_direction in ((5.0, 1.0), (-5.0, 2.0)):
        found = solved_with_capacities(dataclasses.replace(joint, output_torque=torque), apart)
        assert float(found.standing_capacity_of_direction.output_torque) == of_direction
        assert [
            float(each.output_torque) for each in (found.standing_capacity, found.reverse_standing_capacity)
        ] == [1.0, 2.0]
        assert [float(found.rolling_capacity), float(found.reverse_rolling_capacity)] == [3.0, 4.0]
    assert float(found.preload) == pytest.approx(float(np.asarray(solution.result.rest.normal)[0]), rel=1e-9)


def test_only_the_ring_bends(solved):
    """Sun and planets are solid; the ring is held by nothing."""
    assert np.isnan(np.asarray(solved.rims.yield_safety)).tolist() == [True, True, False]


@pytest.mark.long
@pytest.mark.parametrize(
    "branches", ["", pytest.param(3 * '[[branch]]\nplanet_deviation = "0.5 um"\n\n', marks=pytest.mark.long)]
)
def test_rims_under_a_duty_are_those_of_the_same_load_as_working_torque(planar_case, branches):
    """Hollow planets that stand under the largest load, and turn under another."""

    def of(torque, speed, duty=""):
        replaced = {
            "[model]": duty + branches + "[model]",
            'output_torque = "10 N*m"': f'output_torque = "{torque} N*m"',
            'sun_speed = "1500 rpm"': f'sun_speed = "{speed} rpm"',
        }
        return solved_case(planar_case("planetary_hollow", replaced=replaced))

    loads = ((8.0, 0.0, 0.25), (-3.0, 600.0, 0.75))
    duty = "".join(
        f'[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "{speed} rpm"\nshare = {share}\n\n'
        for torque, speed, share in loads
    )
    found = of(5.0, 1500.0, duty)
    alone = [of(torque, speed).rims for torque, speed, _ in loads]
    for here, there in zip(found.duty_rims, alone, strict=True):
        np.testing.assert_allclose(here.stress, there.stress, rtol=1e-7)
        np.testing.assert_allclose(here.yield_safety, there.yield_safety, rtol=1e-7)
    checks = {(each.result.name, each.contact): each.value for each in further_checks(found)}
    names = [body.name for body in found.joint.drive.bodies]
    name = "planet_1" if branches else "planet"
    planet = [float(np.asarray(each.yield_safety)[names.index(name)]) for each in alone]
    worst = int(np.argmin(planet))
    assert checks["duty_rim_yield_safety", f"{name}, load {worst + 1}"] == pytest.approx(
        planet[worst], rel=1e-7
    )


@pytest.mark.long
def test_unlike_branches_at_another_temperature_are_the_file_that_works_there(planar_case):
    """Laws of the contacts are taken around the forces of that temperature."""

    def solved_at(working):
        return solved_case(
            planar_case(
                "planetary",
                replaced={
                    'bodies = "exact"': 'bodies = "springs"',
                    'ring_support = "free" ': 'ring_support = "rigid_housing" ',
                    'ring = "52100"': 'ring = "6061-T6"',
                    "[model]": f'[temperature]\nassembly = "20 degC"\nworking = "{working} degC"\n\n'
                    '[[branch]]\nplanet_deviation = "1 um"\n\n[[branch]]\n\n[[branch]]\n\n[model]',
                },
            )
        )

    warm, cold = solved_at(35), solved_at(20)
    there = warm.at_temperature(20.0)
    np.testing.assert_allclose(there.result.rest.normal, cold.result.rest.normal, rtol=1e-12)
    assert float(there.result.preload) > 1.1 * float(warm.result.preload)
    assert warm.at_temperature(2000.0) is None  # the ring has grown away from the planets
