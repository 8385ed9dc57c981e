"""Sectors of their own sizes: equal ones are the joint, and the paper's drive as computed independently."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.branches.branches import (
    SectorDeviations,
    _floating,
    _refuse_unsettled,
    assembled_branches,
    refuse_wide,
)
from asperity.branches.results import unequal_branches
from asperity.branches.size_errors import loaded_branches
from asperity.errors import InputError, NoSolutionError
from asperity.joint.solve import solve_joint
from asperity.joint.unfolding import SectorSizes, SettledSectors
from asperity.joint_file.build import deviations_of, joint_from_case
from asperity.joint_file.si_tables import si_values

SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'ring_support = "free" ': 'ring_support = "rigid_housing" ',
}


def sized(name, per_size, errors, support=math.inf):
    errors = np.asarray(errors, dtype=float)
    return SectorDeviations({name: errors}, np.outer(errors, per_size), np.asarray(per_size), support)


def planets(errors, support=math.inf):
    return sized("planet", [1.0, 1.0], errors, support)


@pytest.fixture(scope="module")
def planetary_of_springs(planar_joint):
    return planar_joint("planetary", SPRINGS)


@pytest.fixture(scope="module")
def settled_by_hand(planetary_of_springs):
    """Equal planets pressed with 1000 and 1100 N, and what is found without torque of planets of other sizes."""

    def of(sizes, residual=1e-13, change=1e-12, equal=1000.0):
        rest = SimpleNamespace(residual=residual)
        return SettledSectors(
            SectorSizes(sizes.added, np.ones_like(sizes.added), np.asarray(0.0)),
            SimpleNamespace(rest=rest),
            SimpleNamespace(normal=np.array([equal, 1.1 * equal]), worst=0.0),
            change,
        )

    return planetary_of_springs, of


@pytest.mark.parametrize(
    ("errors", "given", "said"),
    [
        ([0.0, 0.0, -16e-6], {}, r"planet 3 is loose: its sizes leave an interference of -0\.5455 um"),
        ([-16e-6] * 3, {}, "leave no branch with an interference: the drive is loose"),
        ([0.0, 40e-6, 0.0], {}, r"the interference of branch 2, 106.4 um, is more than 3 times .* 30 um"),
        ([0.0, 0.0, 0.0], {"residual": 1.0}, r"their interferences are 30 um, 30 um, 30 um"),
        ([0.0, 0.0, 0.0], {"change": 1e-3}, "the forces of the branches do not settle"),
        ([0.0, 0.0, 0.0], {"equal": 0.0}, "no state was found in which every contact"),
    ],
)
def test_sectors_are_refused_by_the_interference_of_their_rings(settled_by_hand, errors, given, said):
    """A planet larger by e grows into the sun with 1000 N and into the ring with 1100 N: 2100/1100 e at the ring."""
    joint, settled = settled_by_hand
    sizes = planets(errors)
    with pytest.raises((InputError, NoSolutionError), match=said):
        _refuse_unsettled(joint, sizes, settled(sizes, **given), ())


def test_what_floats_is_the_input(settled_by_hand):
    joint, _ = settled_by_hand
    assert _floating(joint, planets(np.zeros(3))) == ()
    assert _floating(joint, planets(np.zeros(3), 0.0)) == ("sun",)
    two = dataclasses.replace(joint, drive=dataclasses.replace(joint.drive, sectors=2.0))
    assert _floating(two, planets(np.zeros(2), 1e6)) == ("sun",)
    with pytest.raises(InputError, match="nothing holds a floating sun between two sectors"):
        _floating(two, planets(np.zeros(2), 0.0))
    carrier = dataclasses.replace(
        joint, drive=dataclasses.replace(joint.drive, input="carrier", output="sun")
    )
    with pytest.raises(InputError, match="the input of this drive is the carrier"):
        _floating(carrier, planets(np.zeros(3), 0.0))


def assert_are_the_joint(branches, equal, rtol=1e-9):
    """Everything contact by contact is that of the joint with equal sectors."""
    own, count = solve_joint(branches.joint), branches.sectors
    for of in (
        lambda found: found.rest.normal,
        lambda found: found.forces.normal,
        lambda found: found.forces.tangential,
        lambda found: found.diagnostics.slip_ratio,
        lambda found: found.diagnostics.pressure_over_first_yield,
        lambda found: found.rolling.normal,
        lambda found: found.rolling.creepage,
        lambda found: found.rolling.slip_ratio,
        lambda found: found.rolling.shakedown_ratio,
    ):
        np.testing.assert_allclose(of(own.result), np.tile(of(equal.result), count), rtol=rtol)
    for of in (
        lambda found: found.assembly.stiffness.output,
        lambda found: found.rolling.drift_per_output_turn,
        lambda found: found.rolling.power.loss,
        lambda found: found.rolling.life_hours.drive,
        lambda found: found.forces.input_torque,
    ):
        np.testing.assert_allclose(of(own.result), of(equal.result), rtol=rtol)
    for name in ("standing_capacity", "rolling_capacity", "first_slip", "reverse_standing_capacity"):
        one, other = (getattr(each, name).output_torque for each in (own, equal))
        np.testing.assert_allclose(one, other, rtol=max(rtol, 1e-8))
    found = unequal_branches(branches, own.states)
    np.testing.assert_allclose(found.preload, float(equal.result.preload), rtol=rtol)
    for state in (found.standing, found.rolling):
        np.testing.assert_allclose(state.share, 1.0 / count, rtol=rtol)
        scale = float(equal.result.preload)
        for force in (state.central_force, *state.centre_forces.values()):
            np.testing.assert_allclose(force, 0.0, atol=1e-9 * scale)


@pytest.mark.slow
def test_equal_sectors_are_the_joint(planetary_of_springs):
    branches = assembled_branches(planetary_of_springs, planets(np.zeros(3)))
    assert_are_the_joint(branches, solve_joint(planetary_of_springs))


@pytest.mark.slow
def test_what_unequal_planets_do(planetary_of_springs):
    sizes = planets([2e-6, 0.0, -2e-6])
    found, limits = loaded_branches(planetary_of_springs, sizes)
    # a planet grows into the sun and into the ring
    np.testing.assert_allclose(found.interference, 30e-6 + 2.0 * np.array([2e-6, 0.0, -2e-6]), rtol=1e-9)
    assert found.preload[0] > found.preload[1] > found.preload[2]
    assert int(limits.first_slip.limiting_contact) == 4  # sun and third planet
    assert float(limits.first_slip.output_torque) < float(limits.standing.output_torque)
    for state in (found.rest, found.standing, found.rolling):
        # nothing acts from outside: what the bearings of sun, ring and carrier bear adds up to nothing
        total = state.central_force + sum(state.centre_forces.values())
        np.testing.assert_allclose(total, 0.0, atol=1e-8)
        assert np.hypot(*state.central_force) > 10.0
    assert found.standing.torque.sum() == pytest.approx(10.0, rel=1e-12)
    # the torques on sun, ring and carrier add up to nothing
    for state in (found.standing, found.rolling):
        assert sum(state.torques.values()) == pytest.approx(0.0, abs=1e-8)
    assert abs(found.standing.torques["sun"]) == pytest.approx(10.0 / 6.0, rel=2e-3)
    assert 1.02 < abs(found.rolling.torques["sun"]) / (10.0 / 6.0) < 1.04  # the oil drags
    # the sun is pushed away from the largest planet
    assert found.rest.central_force[0] < 0.0
    changed = assembled_branches(planetary_of_springs, sizes.with_first(-2e-6)).sizes
    np.testing.assert_allclose(changed.deviations["planet"], [0.0, 0.0, -2e-6], atol=1e-20)
    # and backwards the same with the other sign
    other, _ = loaded_branches(dataclasses.replace(planetary_of_springs, output_torque=-10.0), sizes)
    assert other.standing.torque == pytest.approx(found.standing.torque, rel=1e-9)
    assert other.standing.torques["sun"] == pytest.approx(-found.standing.torques["sun"], rel=1e-9)


@pytest.mark.slow
def test_sizes_that_cannot_be_compared_are_refused(planetary_of_springs, planar_joint):
    def refused(sizes, match, joint=planetary_of_springs):
        with pytest.raises(InputError, match=match):
            assembled_branches(joint, sizes)

    refused(planets([0.0, 0.0]), "3 planets, got the sizes of 2")
    refused(planets([0.0, 0.0, -16e-6]), r"planet 3 is loose: its sizes leave an interference of -2 .m")
    refused(planets([-16e-6, -16e-6, -16e-6]), "the drive is loose")
    refused(planets([0.0, 0.0, 31e-6]), "more than 3 times that of equal branches")
    by_force = planar_joint("planetary", {'interference = "30 um"  ': 'preload = "1000 N"  '})
    refused(planets(np.zeros(3)), r"give load\.interference", by_force)


@pytest.mark.long
def test_unlike_planets_of_the_papers_drive(paper_joint):
    """One planet 5 um too large and one too small: 1854, 1000 and 218 N with the sun held, computed independently."""
    joint = paper_joint(ring_wall_thickness=60e-3, body_model="springs", interference=12.904e-6)
    found, _ = loaded_branches(joint, sized("planet", [1.0, 1.0, 1.0, 0.0, 0.0], [5e-6, 0.0, -5e-6]))
    np.testing.assert_allclose(found.preload, [1854.0, 1000.0, 218.0], atol=1.0)
    # a planet counts 1.9413 times, computed independently
    np.testing.assert_allclose(
        found.interference - 12.904e-6, [9.7065e-6, 0.0, -9.7065e-6], rtol=5e-5, atol=1e-15
    )


@pytest.mark.long
@pytest.mark.parametrize("name", ["multiroller", "stepped_planet"])
def test_equal_sectors_of_other_drives(planar_joint, planar_case, name):
    joint = planar_joint(name)
    branches = assembled_branches(joint, deviations_of(si_values(planar_case(name))))
    assert_are_the_joint(branches, solve_joint(joint))


@pytest.mark.long
def test_equal_sectors_with_crowned_and_skewed_rollers_are_the_joint(planar_case):
    case = planar_case(
        "planetary",
        replaced=SPRINGS
        | {
            "[load]": 'planet_crown_radius = "4 m"\n\n[load]',
            "[model]": '[rolling]\nskew = { sp = "0.1 mrad", pr = "0.2 mrad" }\n\n[model]',
        },
    )
    joint = joint_from_case(case)
    branches = assembled_branches(joint, deviations_of(si_values(case)))
    assert_are_the_joint(branches, solve_joint(joint), rtol=1e-6)


def test_up_to_three_times_the_nominal_interference():
    refuse_wide(np.array([-5e-6, 10e-6, 30e-6]), 10e-6)
    with pytest.raises(
        InputError, match=r"of branch 2, 30\.01 um, is more than 3 times that of equal .* 10 um"
    ):
        refuse_wide(np.array([10e-6, 30.01e-6]), 10e-6)


def test_a_further_deviation_is_that_of_the_first_track_of_the_first_sector():
    sizes = SectorDeviations(
        {"planet": np.array([1e-6, 2e-6]), "roller": np.zeros(2)},
        np.array([[3e-6, 1e-6], [0.0, 2e-6]]),
        np.array([1.0, -0.5]),
        0.0,
    ).with_first(4e-6)
    np.testing.assert_allclose(sizes.deviations["planet"], [5e-6, 2e-6], rtol=1e-12)
    np.testing.assert_array_equal(sizes.deviations["roller"], 0.0)
    np.testing.assert_allclose(sizes.added, [[7e-6, -1e-6], [0.0, 2e-6]], rtol=1e-12)
