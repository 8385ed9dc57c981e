"""Unequal branches over the size of one planet."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.branches import size_errors as module
from asperity.branches.branches import SectorDeviations
from asperity.branches.results import BranchState
from asperity.branches.size_errors import size_error_curves
from asperity.errors import InputError


def state(torque, force):
    return BranchState(torque, "sun", np.zeros(2), np.array(force), {}, {}, 1.0)


def loaded(joint, sizes):
    """Springs that share by the preload, 1 N for 1 nm of planet, and slip at a thousandth of it; all under 6 N·m."""
    preload = 1000.0 + 1e9 * sizes.deviations["planet"]
    if preload.min() < joint.least:
        raise InputError("loose")
    weakest = 3e-3 * preload.min()
    under = state(6.0 * preload / preload.sum(), [3.0, 4.0])
    branches = SimpleNamespace(standing=None if weakest < 2.0 else under, rolling=under)
    limits = {"first_slip": weakest, "standing": 1e-3 * preload.sum()}
    limits = {name: SimpleNamespace(output_torque=torque) for name, torque in limits.items()}
    return SimpleNamespace(branches=branches, limits=SimpleNamespace(**limits))


@pytest.fixture
def curves(monkeypatch):
    """Over half a micrometre more or less of the first, of 1.25 um of interference."""
    monkeypatch.setattr(module, "loaded_branches", loaded)

    def of(planets, least=0.0):
        sizes = SectorDeviations({"planet": np.array(planets)}, np.zeros((3, 1)), np.ones(1), 0.0)
        joint = SimpleNamespace(least=least)
        return size_error_curves(
            SimpleNamespace(equal=joint, sizes=sizes, sectors=3, noun="planet", equal_interference=1.25e-6)
        )

    return of


def test_only_the_first_planet_changes(curves):
    found = curves([0.0, 100e-9, 200e-9])
    np.testing.assert_allclose(found.deviation, np.linspace(-500e-9, 500e-9, 17), atol=1e-20)
    first = 1000.0 + found.deviation * 1e9
    total = first + 2300.0
    np.testing.assert_allclose(found.rolling_share[:, 0], first / total, rtol=1e-12)
    np.testing.assert_allclose(found.rolling_share.sum(axis=1), 1.0, rtol=1e-12)
    np.testing.assert_allclose(found.first_slip, 3e-3 * np.minimum(first, 1100.0), rtol=1e-12)
    np.testing.assert_allclose(found.all_slip, 1e-3 * total, rtol=1e-12)
    # where all slip there is neither a share nor a force on the sun under the torque
    assert np.all(np.isnan(found.standing_share[0]))
    np.testing.assert_allclose(found.central_force[[0, 8, 16]], [np.nan, 5.0, 5.0], rtol=1e-12)


def test_a_refused_joint_leaves_a_gap(curves):
    found = curves([0.0, 0.0, 0.0], least=800.0)
    for curve in (found.first_slip, found.all_slip, found.central_force, found.standing_share[:, 0]):
        np.testing.assert_array_equal(np.isnan(curve), found.deviation < -200e-9)
    assert (found.noun, found.track) == ("planet", "planet")
