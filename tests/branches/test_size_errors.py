"""Unequal branches over the size of one planet."""

from types import SimpleNamespace

import numpy as np

from asperity.branches.results import BranchCapacity, BranchState
from asperity.branches.size_errors import size_error_curves
from asperity.branches.sizes import SectorDeviations
from asperity.errors import InputError


def deviations(planet):
    return SectorDeviations({"planet": np.array(planet)}, np.zeros((3, 1)), np.ones(1), 0.0)


class ThreeBranches:
    """Springs that share by the preload, 1 N for 1 nm of planet, and slip at a thousandth of it; all under 6 N·m."""

    count = 3

    def branches(self, sizes):
        preload = 1000.0 + 1e9 * sizes.deviations["planet"]
        weakest = 3e-3 * preload.min()
        state = BranchState(
            preload, 6.0 * preload / preload.sum(), np.zeros(3), np.zeros(2), np.array([3.0, 4.0])
        )
        still = BranchState(preload, np.zeros(3), np.zeros(3), np.zeros(2), np.array([0.0, 1.0]))
        capacity = BranchCapacity(weakest, int(preload.argmin()), None, 1e-3 * preload.sum(), 3.0)
        return SimpleNamespace(
            standing=None if weakest < 2.0 else state,
            rolling=state,
            rest=still,
            capacity=capacity,
            noun="planet",
        )


def test_only_the_first_planet_changes():
    sizes = deviations([0.0, 100e-9, 200e-9])
    deviation = np.array([-500e-9, 0.0, 500e-9])
    found = size_error_curves(ThreeBranches(), sizes, deviation)
    np.testing.assert_array_equal(found.deviation, deviation)
    first = 1000.0 + deviation * 1e9
    total = first + 2300.0
    np.testing.assert_allclose(found.rolling_share[:, 0], first / total, rtol=1e-12)
    np.testing.assert_allclose(found.rolling_share.sum(axis=1), 1.0, rtol=1e-12)
    np.testing.assert_allclose(found.first_slip, [1.5, 3.0, 3.3], rtol=1e-12)
    np.testing.assert_allclose(found.all_slip, 1e-3 * total, rtol=1e-12)
    # where all slip there is neither a share nor a force on the sun under the torque
    assert np.all(np.isnan(found.standing_share[0]))
    np.testing.assert_allclose(found.sun_force, [np.nan, 5.0, 5.0], rtol=1e-12)


class LoosePlanets(ThreeBranches):
    """The same, refused where a planet is loose."""

    def branches(self, sizes):
        if sizes.deviations["planet"].min() < -200e-9:
            raise InputError("loose")
        return super().branches(sizes)


def test_a_refused_joint_leaves_a_gap():
    sizes = deviations([0.0, 0.0, 0.0])
    found = size_error_curves(LoosePlanets(), sizes, np.array([-500e-9, 0.0]))
    for curve in (found.first_slip, found.all_slip, found.sun_force, found.standing_share[:, 0]):
        np.testing.assert_array_equal(np.isnan(curve), [True, False])
    assert (found.noun, found.track) == ("planet", "planet")
