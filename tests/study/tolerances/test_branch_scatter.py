"""Sizes drawn branch by branch, with branches that need no program."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.drive.geometry import triangle
from asperity.drive.mechanism import rest_state
from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.reader import parse_case
from asperity.study.tolerances import branch_scatter as module
from asperity.study.tolerances.branch_scatter import branch_scatter, sector_scatter


@dataclasses.dataclass
class Drive:
    """The capacity is the smallest interference: the weakest branch decides."""

    joint: object
    interference: float
    own_preload: float = 1000.0
    count: int = 3

    def __post_init__(self):
        geometry = self.joint.geometry
        self.rest = rest_state(geometry=geometry, sides=triangle(geometry), preload=1.0)
        self.laws = SimpleNamespace(standing=SimpleNamespace(capacity=lambda preload: 13.0))
        self.seen = []

    def branches(self, sizes, *, slip):
        assert not slip
        self.seen.append(sizes)
        length = self.interference + 1.9413 * sizes.planet
        state = SimpleNamespace(share=length / length.sum(), sun_force=np.array([3.0, 4.0]))
        slips = SimpleNamespace(first_slip=1e6 * length.min(), all_slip=1e6 * length.mean())
        return SimpleNamespace(
            capacity=slips, rolling_capacity=slips, standing=state, rolling=state, rest=state, preload=length
        )


@pytest.fixture
def scattered(joint_text, monkeypatch):
    monkeypatch.setattr(module, "BranchedJoint", Drive)

    def of(*changes, draws=400):
        text = joint_text.replace('preload = "1000 N"', 'interference = "13 um"')
        for old, new in changes:
            text = text.replace(old, new)
        return branch_scatter(parse_case(text, source="x"), distribution=None, draws=draws, seed=1)

    return of


LOOSE = ('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 2 um, uniform"')


def test_each_planet_is_drawn_by_itself(scattered):
    """The smallest of three even draws lies a quarter up the range on average, their mean in the middle."""
    found = scattered(LOOSE, draws=4000)
    spread = 2.0 * 1.9413 * 2.0  # whole range of the interference in um
    low = 13.0 - 0.5 * spread
    assert found.first_slip.mean() == pytest.approx(low + 0.25 * spread, rel=0.01)
    assert found.all_slip.mean() == pytest.approx(13.0, rel=0.01)
    assert found.all_slip.std() == pytest.approx(spread / math.sqrt(12.0) / math.sqrt(3.0), rel=0.05)
    assert np.all(found.sun_force == 5.0)
    assert found.first_slip.tolist() == scattered(LOOSE, draws=4000).first_slip.tolist()


def test_the_ring_is_common_to_all(scattered):
    """A ring of ±2 um moves every branch alike, once as much; a planet without a tolerance stays."""
    found = scattered(
        ('ring_radius = "40 mm"', 'ring_radius = "40 mm +- 2 um, uniform"'),
        ('loading_roller_radius = "5 mm"', 'loading_roller_radius = "5 mm +- 1e-6 um, uniform"'),
    )
    assert found.first_slip == pytest.approx(found.all_slip, rel=1e-12)
    assert found.first_slip.min() == pytest.approx(11.0, abs=0.05)
    assert found.first_slip.max() == pytest.approx(15.0, abs=0.05)
    assert found.largest_share == pytest.approx(np.full(400, 1.0 / 3.0))


def test_a_larger_ring_takes_interference_from_all_and_its_own_deviation_adds(scattered, monkeypatch):
    """All at the upper ends of their tolerances: 13 + 1 um of interference, less the 2 um of the ring's radius."""
    monkeypatch.setattr(
        module, "quantiles", lambda entry, _, shares: np.full(shares.shape, entry.value + entry.tolerance)
    )
    found = scattered(
        ('interference = "13 um"', 'interference = "13 um +- 1 um, uniform"'),
        ('ring_radius = "40 mm"', 'ring_radius = "40 mm +- 2 um, uniform"'),
        ('loading_roller_radius = "5 mm"', 'loading_roller_radius = "5 mm +- 1e-6 um, uniform"'),
        draws=2,
    )
    assert found.first_slip == pytest.approx([12.0, 12.0], rel=1e-4)
    assert found.all_slip == pytest.approx([12.0, 12.0], rel=1e-4)


def test_sizes_of_the_upper_ends_are_larger(scattered, monkeypatch):
    """A planet of +1 um, rollers of +2 um, and the common 1 um of interference as 1/1.9413 um of a planet."""
    monkeypatch.setattr(
        module, "quantiles", lambda entry, _, shares: np.full(shares.shape, entry.value + entry.tolerance)
    )
    seen, plain = [], Drive.branches
    monkeypatch.setattr(
        Drive, "branches", lambda *given, **slip: seen.append(given[1]) or plain(*given, **slip)
    )
    scattered(
        ('interference = "13 um"', 'interference = "13 um +- 1 um, uniform"'),
        ('planet_radius = "13.5 mm"', 'planet_radius = "13.5 mm +- 1 um, uniform"'),
        ('loading_roller_radius = "5 mm"', 'loading_roller_radius = "5 mm +- 2 um, uniform"'),
        draws=1,
    )
    (sizes,) = seen
    np.testing.assert_allclose(sizes.planet, 1e-6 + 1e-6 / 1.9413, rtol=1e-4)
    np.testing.assert_allclose(sizes.right_roller, 2e-6, rtol=1e-9)
    np.testing.assert_allclose(sizes.left_roller, 2e-6, rtol=1e-9)


def test_draws_without_a_balance_and_with_loose_branches_are_told_apart(scattered, monkeypatch):
    """Of four draws one finds no balance, and in one every branch is loose, which holds nothing."""
    raised, plain = (
        iter([NoSolutionError("none"), None, InputError("every branch is loose"), None]),
        Drive.branches,
    )

    def branches(drive, sizes, *, slip):
        error = next(raised)
        if error is not None:
            raise error
        return plain(drive, sizes, slip=slip)

    monkeypatch.setattr(Drive, "branches", branches)
    found = scattered(LOOSE, draws=4)
    assert np.isnan(found.first_slip).tolist() == [True, False, False, False]
    assert np.isnan(found.sun_force).tolist() == [True, False, False, False]
    assert found.loose.tolist() == [False, False, True, False]
    assert (found.first_slip[2], found.all_slip[2]) == (0.0, 0.0)
    told = found.document()
    assert (told["share_with_a_loose_branch"], told["share_without_a_balance"]) == (0.25, 0.25)


def test_the_document_states_quantiles(scattered):
    document = scattered(LOOSE).document()
    low, middle, high = document["first_slip_Nm"]
    assert low < middle < high < 17.0
    assert document["equal_branches_Nm"] == 13.0
    even = dataclasses.replace(scattered(LOOSE, draws=1), first_slip=np.linspace(0.0, 1.0, 1001)).document()
    assert even["quantiles"] == even["first_slip_Nm"] == pytest.approx([0.025, 0.5, 0.975], rel=1e-9)
    assert document["share_with_a_loose_branch"] == 0.0
    assert document["share_that_slips_under_the_torque"] == 0.0


def test_equal_branches_have_nothing_to_draw(scattered):
    with pytest.raises(InputError, match="the branches are equal"):
        scattered(('sun_radius = "4 mm"', 'sun_radius = "4 mm +- 1 um, uniform"'))
    with pytest.raises(InputError, match="at least 1, got 0"):
        scattered(LOOSE, draws=0)


class Sectors:
    """Planets whose capacity is their smallest interference; refused where one is loose."""

    def __init__(self, joint, solution):
        self.joint, self.solution, self.seen = joint, solution, []
        found.append(self)

    def branches(self, sizes, *, slip):
        assert not slip
        self.seen.append(sizes.added)
        length = 30e-6 + sizes.added.sum(axis=1)
        if length.min() <= 0.0:
            raise InputError("planet 1 is loose")
        state = SimpleNamespace(share=length / length.sum(), sun_force=np.array([3.0, 4.0]))
        slips = SimpleNamespace(first_slip=1e6 * length.min(), all_slip=1e6 * length.mean())
        return SimpleNamespace(
            capacity=slips, rolling_capacity=slips, standing=state, rolling=state, rest=state, preload=length
        )


found = []


@pytest.fixture
def sectors(planar_case, monkeypatch):
    capacity = SimpleNamespace(output_torque=12.0)
    solution = SimpleNamespace(capacity=capacity, reverse_capacity=capacity)
    monkeypatch.setattr(module, "BranchedPlanarJoint", Sectors)
    monkeypatch.setattr(module, "solve_planar", lambda joint: solution)

    def of(name, changes, draws=400):
        scatter = sector_scatter(planar_case(name, replaced=changes), distribution=None, draws=draws, seed=1)
        return scatter, np.array(found[-1].seen)

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
