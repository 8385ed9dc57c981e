"""Sizes drawn branch by branch, with branches that need no program."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.study.tolerances import branch_scatter as module
from asperity.study.tolerances.branch_scatter import branch_scatter


class Sectors:
    """Planets whose capacity is their smallest interference; refused where one is loose."""

    def __init__(self):
        self.seen = []

    def loaded(self, joint, sizes):
        self.seen.append(sizes.added)
        length = 30e-6 + sizes.added.sum(axis=1)
        if length.min() <= 0.0:
            raise InputError("planet 1 is loose")
        state = SimpleNamespace(share=length / length.sum(), central_force=np.array([3.0, 4.0]))
        branches = SimpleNamespace(standing=state, rolling=state, rest=state, preload=length)
        first, last = (SimpleNamespace(output_torque=1e6 * each) for each in (length.min(), length.mean()))
        return branches, SimpleNamespace(first_slip=first, standing=last, rolling=first)


@pytest.fixture
def sectors(planar_case, monkeypatch):
    capacity = SimpleNamespace(output_torque=12.0)
    solution = SimpleNamespace(standing_capacity=capacity, reverse_standing_capacity=capacity)
    monkeypatch.setattr(module, "solve_joint", lambda joint: solution)

    def of(name, changes, draws=400, loaded=None):
        made = Sectors()
        monkeypatch.setattr(module, "loaded_branches", loaded or made.loaded)
        scatter = branch_scatter(planar_case(name, replaced=changes), distribution=None, draws=draws, seed=1)
        return scatter, np.array(made.seen)

    return of


PLANET = ('planet_radius = "20 mm"', 'planet_radius = "20 mm +- 2 um, uniform"')
SUN = ('sun_radius = "10 mm"', 'sun_radius = "10 mm +- 1 um, uniform"')


def test_every_planet_of_another_drive_is_drawn_by_itself(sectors):
    scatter, added = sectors("planetary", dict([PLANET]))
    assert added.shape == (400, 3, 2)
    np.testing.assert_allclose(added[..., 0], added[..., 1])  # a planet grows into sun and ring
    assert np.ptp(added) == pytest.approx(4e-6, rel=0.02)
    np.testing.assert_allclose(np.corrcoef(added[..., 0].T), np.eye(3), atol=0.15)
    assert scatter.equal == 12.0
    told = scatter.document()
    assert told["share_with_a_loose_branch"] == told["share_without_a_balance"] == 0.0
    assert told["sun_force_N"] == pytest.approx([5.0, 5.0, 5.0])


def test_sun_and_interference_are_drawn_once_for_all_planets(sectors):
    wide = ('interference = "30 um"', 'interference = "30 um +- 40 um, uniform"')
    scatter, added = sectors("planetary", dict([PLANET, SUN, wide]))
    # at the ring planet and interference, at the sun planet and sun
    common = added[:, :, 1] - added[:, :, 0]
    np.testing.assert_allclose(common, np.tile(common[:, :1], 3), atol=1e-18)
    assert np.ptp(common) > 30e-6
    loose = np.mean([(30e-6 + each.sum(axis=1)).min() <= 0.0 for each in added])
    assert 0.05 < loose < 0.3  # about an eighth lies below zero
    assert scatter.document()["share_with_a_loose_branch"] == pytest.approx(loose)
    assert np.isnan(scatter.first_slip).mean() == pytest.approx(loose)


def test_equal_planets_of_another_drive_are_refused(sectors):
    with pytest.raises(InputError, match="no roller off the axis has a tolerance"):
        sectors("planetary", dict([SUN]))
    by_force = ('interference = "30 um"  ', 'preload = "1000 N"  ')
    with pytest.raises(InputError, match=r"give load\.interference"):
        sectors("planetary", dict([PLANET, by_force]))
    with pytest.raises(InputError, match="at least 1, got 0"):
        sectors("planetary", dict([PLANET]), draws=0)


def test_tracks_of_a_listed_drive(sectors):
    """Radii of one track are drawn once, wherever they are stated; a larger ring presses less."""
    _, added = sectors(
        "planar",
        {
            'preload = "1000 N"  ': 'interference = "13 um"  ',
            'second_radius = "13.5 mm"': 'second_radius = "13.5 mm +- 2 um, uniform"',
            'second_radius = "40 mm"': 'second_radius = "40 mm +- 3 um, uniform"',
        },
    )
    planet, ring = added[..., 0], added[..., 3]
    for contact in (1, 2):
        np.testing.assert_allclose(added[..., contact], planet)
    np.testing.assert_allclose(added[..., 4], ring)
    np.testing.assert_allclose(ring, np.tile(ring[:, :1], 3))
    assert np.ptp(planet) == pytest.approx(4e-6, rel=0.02)
    assert np.ptp(ring) == pytest.approx(6e-6, rel=0.02)


def test_draws_without_a_balance_and_with_loose_branches_are_told_apart(sectors):
    """Of four draws one finds no balance, and in one a branch is loose: nothing else is known of it."""
    raised = iter([NoSolutionError("none"), None, InputError("planet 2 is loose"), None])

    def loaded(joint, sizes):
        error = next(raised)
        if error is not None:
            raise error
        return Sectors().loaded(joint, sizes)

    scatter, _ = sectors("planetary", dict([PLANET]), draws=4, loaded=loaded)
    assert np.isnan(scatter.first_slip).tolist() == [True, False, True, False]
    assert np.isnan(scatter.sun_force).tolist() == [True, False, True, False]
    assert scatter.loose.tolist() == [False, False, True, False]
    told = scatter.document()
    assert (told["share_with_a_loose_branch"], told["share_without_a_balance"]) == (0.25, 0.25)


def test_the_document_states_quantiles(sectors):
    scatter, _ = sectors("planetary", dict([PLANET]))
    document = scatter.document()
    low, middle, high = document["first_slip_Nm"]
    assert 26.0 < low < middle < high < 34.0
    assert document["equal_branches_Nm"] == 12.0
    even = dataclasses.replace(scatter, first_slip=np.linspace(0.0, 1.0, 400)).document()
    assert even["quantiles"] == [0.025, 0.5, 0.975]
    assert even["first_slip_Nm"] == pytest.approx([0.025, 0.5, 0.975], rel=1e-9)
    assert document["share_that_slips_under_the_torque"] == 0.0


def test_both_loading_rollers_of_a_planet_are_drawn_by_themselves(sectors):
    """The smallest of six even draws lies a seventh up the range on average; one ring is common to all."""
    _, added = sectors(
        "zou2025",
        {
            'preload = "1000 N"': 'interference = "13 um"',
            'loading_roller_radius = "5 mm"': 'loading_roller_radius = "5 mm +- 2 um, uniform"',
            'ring_radius = "40 mm"': 'ring_radius = "40 mm +- 1 um, uniform"',
        },
        draws=4000,
    )
    right, left = added[..., 1], added[..., 2]  # at pwr and pwl, where the ring adds nothing
    rollers = np.concatenate([right, left], axis=1)
    np.testing.assert_allclose(np.corrcoef(rollers.T), np.eye(6), atol=0.1)
    assert rollers.min(axis=1).mean() == pytest.approx(4e-6 * (1.0 / 7.0 - 0.5), rel=0.05)
    ring = added[..., 3] - right
    np.testing.assert_allclose(added[..., 4] - left, ring, atol=1e-15)
    np.testing.assert_allclose(ring, np.tile(ring[:, :1], 3), atol=1e-15)
    assert np.ptp(ring) == pytest.approx(2e-6, rel=0.01)
    assert not added[..., 0].any()
