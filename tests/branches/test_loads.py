"""Loads of unlike branches in each case of a table, from states made by hand."""

import dataclasses

import numpy as np
import pytest

from asperity.branches.loads import BranchLoads

EQUAL = [{"name": name, "unknown_because": None} for name in ("without torque", "working torque", "duty 1")]


@pytest.fixture
def states(unequal_branches):
    """Without torque as it is, a rolling state with all numbers, and a load that is not carried."""
    rest = dataclasses.replace(unequal_branches().standing, pins=np.zeros((2, 2, 3)))
    rolling = dataclasses.replace(
        rest,
        sun_force=np.array([3.0, 4.0]),
        torques={"sun": 1.5},
        speeds={"sun": 5.0},
        bearing_speed=np.array([7.0, 8.0, 5.0, 0.8]),
        pins=np.array([[[0.0, 30.0, 0.0], [5.0, 0.0, 0.0]], [[20.0, 40.0, 0.0], [-12.0, 12.9, 0.0]]]),
    )
    return unequal_branches(rest=rest, rolling=rolling, duty=(None,))


def test_equal_branches_are_left_as_they_are():
    loads = BranchLoads(None, turns=True)
    assert loads.entries(EQUAL, skewed=True) == (EQUAL, [])
    for of in (loads.force_on, loads.torque_on, loads.speed_of):
        found = of("sun", [1.0, 2.0])
        np.testing.assert_array_equal(found, [1.0, 2.0])
    for found in (loads.speed_on_pins([[1.0]]), loads.pins([[1.0]])):
        np.testing.assert_array_equal(found, [[1.0]])


def test_each_case_is_that_of_its_own_state(states):
    loads = BranchLoads(states, turns=True)
    cases, notes = loads.entries(EQUAL, skewed=False)
    assert [case["unknown_because"] is None for case in cases] == [True, True, False]
    assert notes == []
    # hand: 3 and 4 N are 5 N; the sun is named in the state that rolls alone, so that at rest it is as of equal ones
    assert loads.force_on("sun", np.zeros(3))[1] == pytest.approx(5.0)
    np.testing.assert_array_equal(loads.torque_on("sun", [0.1, 9.0, 9.0]), [0.1, 1.5, np.nan])
    np.testing.assert_array_equal(loads.speed_of("sun", [0.0, 9.0, 9.0]), [0.0, 5.0, np.nan])
    np.testing.assert_array_equal(
        loads.speed_on_pins(np.full((2, 3), 9.0)), [[np.nan, 7.0, np.nan], [np.nan, 8.0, np.nan]]
    )
    # the branch that loads each pin most: 50 N of the second and 13 N of the first
    largest = loads.pins(np.zeros((2, 2, 3)))
    np.testing.assert_array_equal(np.hypot(*largest[..., 1]), [50.0, 13.0])
    assert np.isnan(largest[..., 2]).all()


def test_axial_forces_are_said_to_be_those_of_equal_branches(states):
    (note,) = BranchLoads(states, turns=True).entries(EQUAL, skewed=True)[1]
    assert note.startswith("Axial forces are those of equal branches, not of those of the file")
