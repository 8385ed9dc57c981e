"""Laws of one branch between their tables."""

import numpy as np
import pytest

from asperity.joint.branch_law import _law

PRELOADS = np.geomspace(50.0, 3000.0, 12)
STEPS = np.linspace(0.0, 1.0, 24)
USED = np.append((1.0 - (1.0 - STEPS) ** 3)[:-1], 1.0 - 1e-9)


@pytest.fixture(scope="module")
def partial_slip():
    """A contact in partial slip: angle 1 − (1 − q)^(2/3) at the share q of its capacity, as Mindlin's."""
    capacity = 0.013 * PRELOADS
    end = 1e-4 * (PRELOADS / 1000.0) ** 0.9
    compliance = (2.0 / 3.0) * (1.0 - USED) ** (-1.0 / 3.0) * (end / capacity)[:, None]
    compliance[:, -1] = np.inf
    forces = {
        "normal": np.repeat(PRELOADS[:, None], 24, 1)[None] * (1.0 + 0.01 * USED),
        "tangential": (0.1 * PRELOADS[:, None] * USED)[None],
    }
    found = forces | {"compliance": compliance}
    return _law(PRELOADS, capacity, PRELOADS > 0.0, STEPS, USED, found, False), end


def test_the_table_gives_the_law_that_it_was_made_of(partial_slip):
    law, end = partial_slip
    assert law.demand_at_slip(PRELOADS) == pytest.approx(end, rel=2e-4)
    for share in (0.05, 0.5, 0.9, 0.99):
        preload = np.array([77.0, 1000.0, 2500.0])
        angle = 1e-4 * (preload / 1000.0) ** 0.9 * (1.0 - (1.0 - share) ** (2.0 / 3.0))
        assert law.share(preload, angle) == pytest.approx(np.full(3, share), abs=1e-3)
        assert law.share(preload, -angle) == pytest.approx(np.full(3, -share), abs=1e-3)
        assert law.torque(preload, np.full(3, share)) == pytest.approx(0.013 * preload * share, rel=1e-9)
        normal, tangential = law.sun_forces(preload, np.full(3, share))
        assert normal == pytest.approx(preload * (1.0 + 0.01 * share), rel=1e-9)
        assert tangential == pytest.approx(0.1 * preload * share, rel=1e-6)


def test_beyond_slip_and_without_preload(partial_slip):
    law, _ = partial_slip
    preload = np.array([0.0, 1000.0, 10.0])
    assert law.share(preload, np.full(3, 1.0)).tolist() == [0.0, 1.0, 1.0]
    assert law.torque(preload, np.ones(3)) == pytest.approx([0.0, 13.0, 0.13], rel=1e-9)
    assert law.sun_forces(preload, np.zeros(3))[0] == pytest.approx(preload, rel=1e-9)


def test_friction_of_bearings_keeps_its_sense_where_a_branch_is_wound_back():
    """T = P (0.004 + 0.1 s): the torque that the bearings take is that of the drive's motion, for every branch."""
    forces = {
        "normal": np.repeat(PRELOADS[:, None], 24, 1)[None],
        "tangential": (PRELOADS[:, None] * (0.004 + 0.1 * USED))[None],
        "compliance": np.tile(1e-5 / PRELOADS[:, None], 24),
    }
    law = _law(PRELOADS, 0.013 * PRELOADS, PRELOADS > 0.0, STEPS, USED, forces, False)
    preload = np.full(4, 800.0)
    _, tangential = law.sun_forces(preload, np.array([-0.5, -1e-9, 1e-9, 0.5]))
    assert tangential == pytest.approx(800.0 * np.array([-0.046, 0.004, 0.004, 0.054]), rel=1e-6)
