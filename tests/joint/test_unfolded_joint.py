"""A joint with every sector by itself against the joint with equal ones, and against sectors side by side by hand."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.branches.branches import SectorDeviations, assembled_branches
from asperity.joint.solve import solve_joint
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solve_case
from asperity.standing.dynamics import Inertias, dynamics
from asperity.standing.windup import windup

SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'ring_support = "free"': 'ring_support = "rigid_housing"',
}
SAME = 1e-9
LARGEST = 9.0


def unfolded(joint, errors):
    """The joint with planets that are too large by these errors, each in both of its contacts."""
    per_size = np.ones(2)
    sizes = SectorDeviations({"planet": errors}, np.outer(errors, per_size), per_size, math.inf)
    return assembled_branches(joint, sizes).joint


@pytest.fixture(scope="module")
def planetary(planar_joint):
    return planar_joint("planetary", SPRINGS)


@pytest.fixture(scope="module")
def whole(planetary):
    return unfolded(planetary, np.zeros(3))


@pytest.mark.long
@pytest.mark.parametrize("level", ["assembly", "published"])
def test_equal_sectors_wind_up_as_the_joint(planetary, whole, level):
    found, expected = (
        windup(each, largest_torque=LARGEST, level=level, steps=10) for each in (whole, planetary)
    )
    for name in ("angle", "stiffness", "slip_angle", "unloading_angle", "hysteresis", "lost_motion"):
        one, other = (np.asarray(getattr(each, name)) for each in (found, expected))
        np.testing.assert_allclose(one, other, rtol=SAME, atol=SAME * np.max(np.abs(other)), err_msg=name)


@pytest.mark.slow
def test_equal_sectors_turn_and_live_as_the_joint(planetary, whole):
    """Also the tracks of sun and ring, over which the rollers of all sectors pass."""
    found, expected = solve_joint(whole), solve_joint(planetary)
    for name in ("speed_loss", "drift_per_output_turn", "output_speed"):
        one, other = (float(getattr(each.result.rolling, name)) for each in (found, expected))
        assert one == pytest.approx(other, rel=SAME)
    one, other = (each.result.rolling.power for each in (found, expected))
    for name in ("loss", "input", "efficiency"):
        assert float(getattr(one, name)) == pytest.approx(float(getattr(other, name)), rel=SAME)
    one, other = (each.result.rolling.life_hours for each in (found, expected))
    assert float(one.drive) == pytest.approx(float(other.drive), rel=1e-8)
    sun, planet, ring = np.asarray(other.body)
    np.testing.assert_allclose(one.body, [sun, ring, planet, planet, planet], rtol=1e-8)
    np.testing.assert_allclose(one.contact, np.tile(other.contact, 3), rtol=1e-8)
    assert float(found.standing_capacity.output_torque) == pytest.approx(
        float(expected.standing_capacity.output_torque), rel=SAME
    )


@pytest.mark.long
def test_equal_sectors_ring_as_the_joint(planetary, whole):
    inertias = Inertias(2e-5, 0.05, 0.0)
    found, expected = (dynamics(each, inertias) for each in (whole, planetary))
    for name in ("stiffness", "input_inertia", "output_inertia", "free_frequency", "corner_frequency"):
        one, other = (np.asarray(getattr(each.over_torque, name)) for each in (found, expected))
        np.testing.assert_allclose(one, other, rtol=1e-8, err_msg=name)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["planetary", pytest.param("stepped_planet", marks=pytest.mark.long)])
def test_equal_sections_of_branches_change_no_number_of_a_contact(zou_file, name):
    """Three sections [[branch]] without a deviation: all that the document states of each contact, its lives too.

    Only powers add up: those of a contact that stands for three are three times as large.
    """
    text = zou_file.with_name(f"{name}.toml").read_text(encoding="utf-8")
    _, alone = solve_case(parse_case(text, source="x"))
    _, listed = solve_case(parse_case(text + "\n[[branch]]\n" * 3, source="x"))
    assert not alone["of_own_branches"]
    for section in ("standing", "rolling"):
        for contact, numbers in alone[section]["contacts"].items():
            for branch in (1, 2, 3):
                found = flat(listed[section]["contacts"][f"{contact}_{branch}"])
                expected = flat(numbers)
                assert found.keys() == expected.keys()
                for key, value in expected.items():
                    if isinstance(value, float):
                        value = value / 3.0 if "losses_W" in key else value
                        assert found[key] == pytest.approx(value, rel=1e-6, abs=1e-9), (contact, key)


def flat(numbers, before=""):
    """All numbers of a part of a document, by their keys one behind the other."""
    known = {}
    for key, value in numbers.items():
        known |= flat(value, f"{before}{key}.") if isinstance(value, dict) else {before + key: value}
    return known


@pytest.fixture(scope="module")
def opposed(planar_joint):
    """Two planets, one 3 um too large and one too small; and two equal ones pressed like each of them."""
    joint = planar_joint("planetary", SPRINGS | {"planets = 3": "planets = 2"})
    own = unfolded(joint, np.array([3e-6, -3e-6]))
    alike = [dataclasses.replace(joint, interference=36e-6), dataclasses.replace(joint, interference=24e-6)]
    return own, alike


@pytest.mark.long
def test_two_opposed_planets_are_two_springs_side_by_side(opposed):
    """Between a sun, a ring and a carrier that are held both turn by one angle, and their torques add.

    So do those of the hysteresis: each follows its own loop between the two ends of the angle. By Masing's rule a loop
    of the sum is the sum of the loops; the part of the angle without slip is in proportion to the torque.
    """
    own, alike = opposed
    found = windup(own, largest_torque=36.0, level="assembly")
    curves = [
        windup(each, largest_torque=torque, level="assembly")
        for each, torque in zip(alike, (42.0, 36.0), strict=True)
    ]
    angle, torque = np.asarray(found.angle), np.asarray(found.torque)
    assert torque[-1] == 36.0
    each = [0.5 * np.interp(angle, np.asarray(curve.angle), np.asarray(curve.torque)) for curve in curves]
    assert each[0][-1] > 1.05 * each[1][-1]
    # between points 1 N·m apart the curves are nearly straight
    np.testing.assert_allclose(sum(each), torque, atol=1e-4 * 36.0)
    ends = [
        windup(joint, largest_torque=2.0 * float(one[-1]), level="assembly")
        for joint, one in zip(alike, each, strict=True)
    ]
    for end in ends:
        assert float(end.angle[-1]) == pytest.approx(float(angle[-1]), rel=1e-4)
    assert 0.5 * sum(float(end.dissipated_energy) for end in ends) == pytest.approx(
        float(found.dissipated_energy), rel=1e-3
    )
    assert float(found.dissipated_energy) > 0.0
    # mirrored sectors change places, and nothing else
    np.testing.assert_allclose(found.angle[::-1], -angle, rtol=SAME, atol=SAME * angle[-1])
    assert math.isclose(
        float(found.stage_stiffness[0]), float(found.reverse_stage_stiffness[0]), rel_tol=SAME
    )


@pytest.mark.long
def test_beyond_the_slip_of_one_planet_the_other_bears_the_rest(opposed):
    """The one that slips keeps what its friction holds, half of 43.0 N·m; the step in which it slips errs most."""
    own, alike = opposed
    held = 0.5 * float(solve_joint(alike[1]).standing_capacity.output_torque)
    assert held == pytest.approx(21.49, abs=0.01)
    found = windup(own, largest_torque=47.0, level="assembly")
    other = windup(alike[0], largest_torque=2.0 * (47.0 - held), level="assembly")
    assert float(found.angle[-1]) == pytest.approx(float(other.angle[-1]), rel=2e-3)
    assert float(found.stiffness[-1]) == pytest.approx(0.5 * float(other.stiffness[-1]), rel=1e-6)


@pytest.mark.long
def test_the_loop_of_unlike_sectors_is_divided_where_contacts_begin_to_slide(planetary):
    """Halfway from the first slip to the most that they carry: few steps have the loop of many."""
    joint = unfolded(planetary, np.array([1e-6, 0.0, -1e-6]))
    solution = solve_joint(joint)
    first, last = (float(each.output_torque) for each in (solution.first_slip, solution.standing_capacity))
    assert first < 0.99 * last
    few, many = (
        windup(joint, largest_torque=0.5 * (first + last), level="assembly", steps=steps)
        for steps in (20, 80)
    )
    for name in ("hysteresis", "dissipated_energy", "lost_motion"):
        assert float(getattr(few, name)) == pytest.approx(float(getattr(many, name)), rel=1e-6), name
