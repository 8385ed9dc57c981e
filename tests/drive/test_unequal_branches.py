"""Branches of unlike sizes: what counts as interference, and what the planets do to the sun."""

import numpy as np
import pytest

from asperity.drive.geometry import DriveGeometry, triangle
from asperity.drive.interference import interference_of_sizes
from asperity.drive.mechanism import rest_state
from asperity.drive.unequal_branches import (
    added_interference,
    branch_directions,
    force_on_carrier,
    force_on_ring,
    force_on_sun,
    roller_directions,
)

GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
REST = rest_state(geometry=GEOMETRY, sides=triangle(GEOMETRY), preload=1.0)


@pytest.mark.parametrize("count", [2, 3, 5])
def test_equal_branches_leave_the_sun_alone_but_for_their_torque(count):
    radial, along = branch_directions(count)
    assert np.sum(radial * along, axis=1) == pytest.approx(np.zeros(count), abs=1e-15)
    # the planet above the sun is pushed to the right, as in equation (2)
    turned = np.array([[0.0, 1.0], [-1.0, 0.0]])
    assert radial @ turned.T == pytest.approx(along, rel=1e-9, abs=1e-14)
    force = force_on_sun(normal=np.full(count, 1000.0), tangential=np.full(count, 46.0))
    assert force == pytest.approx(np.zeros(2), abs=1e-12)


def test_the_sun_is_pushed_away_from_the_strongest_planet_and_against_its_traction():
    force = force_on_sun(normal=np.array([1200.0, 1000.0, 1000.0]), tangential=np.array([50.0, 46.0, 46.0]))
    assert force == pytest.approx([-200.0, 4.0])


def test_a_sun_nearer_to_a_planet_is_a_larger_sun():
    none = {"planet": 0.0, "right_roller": 0.0, "left_roller": 0.0}
    one = added_interference(rest=REST, approach=1e-6, **none)
    assert float(one) == float(interference_of_sizes(rest=REST, sun=1e-6, ring=0.0, **none))
    # cos(theta)/cos(beta)
    assert float(one) == pytest.approx(
        1e-6 * np.cos(np.radians(27.0831)) / np.cos(np.radians(13.1582)), rel=1e-5
    )


def test_a_planet_counts_twice_nearly():
    """1.9413, computed independently; all rollers of a branch with the sun make up for a ring that grows as they do."""
    even = {"approach": 0.0, "right_roller": 0.0, "left_roller": 0.0}
    assert float(added_interference(rest=REST, planet=1.0, **even)) == pytest.approx(1.9413, abs=5e-5)
    grown = added_interference(rest=REST, approach=4e-3, planet=13.5e-3, right_roller=5e-3, left_roller=5e-3)
    assert float(grown) == pytest.approx(40e-3, rel=1e-12)


@pytest.mark.parametrize("count", [2, 3, 5])
def test_equal_branches_leave_carrier_and_ring_alone(count):
    even = {"tangential": np.outer([-130.0, 150.0], np.ones(count)), "polar": 0.24}
    other = np.outer([20.0, -10.0], np.ones(count))
    assert force_on_carrier(radial=other, **even) == pytest.approx(np.zeros(2), abs=1e-12)
    assert force_on_ring(normal=other, **even) == pytest.approx(np.zeros(2), abs=1e-12)


def test_forces_on_carrier_and_ring_by_hand():
    """The first planet on the first axis, its left roller 90° ahead: that is as far as a quarter of the circle."""
    right_angle = 0.5 * np.pi
    none, left = np.zeros((2, 3)), np.zeros((2, 3))
    left[1, 0] = 7.0
    hand = {"polar": right_angle}
    assert force_on_carrier(radial=left, tangential=none, **hand) == pytest.approx([0.0, 7.0])
    assert force_on_carrier(radial=none, tangential=left, **hand) == pytest.approx([-7.0, 0.0])
    assert force_on_ring(normal=left, tangential=none, **hand) == pytest.approx([0.0, 7.0])
    # the ring holds back what turns with the sun, so that its traction is clockwise
    assert force_on_ring(normal=none, tangential=left, **hand) == pytest.approx([7.0, 0.0])
    right = left[::-1]
    assert force_on_carrier(radial=right, tangential=none, **hand) == pytest.approx([0.0, -7.0])
    radial, tangential = roller_directions(3, 0.24)
    assert np.sum(radial * tangential, axis=-1) == pytest.approx(np.zeros((2, 3)), abs=1e-15)
