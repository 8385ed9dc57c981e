"""Sizes drawn branch by branch, with branches that need no program."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.drive.geometry import triangle
from asperity.drive.mechanism import rest_state
from asperity.errors import InputError
from asperity.joint_file.reader import parse_case
from asperity.study.tolerances import branch_scatter as module
from asperity.study.tolerances.branch_scatter import branch_scatter


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


def test_the_document_states_quantiles(scattered):
    document = scattered(LOOSE).document()
    low, middle, high = document["first_slip_Nm"]
    assert low < middle < high < 17.0
    assert document["equal_branches_Nm"] == 13.0
    assert document["share_with_a_loose_branch"] == 0.0
    assert document["share_that_slips_under_the_torque"] == 0.0


def test_equal_branches_have_nothing_to_draw(scattered):
    with pytest.raises(InputError, match="the branches are equal"):
        scattered(('sun_radius = "4 mm"', 'sun_radius = "4 mm +- 1 um, uniform"'))
    with pytest.raises(InputError, match="at least 1, got 0"):
        scattered(LOOSE, draws=0)
