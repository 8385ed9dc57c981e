"""Laws of one branch between their tables."""

from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint import branch_law
from asperity.joint.branch_law import MEMBERS, _law, _states, _without_gaps, branch_laws

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
    for share in (0.05, 0.5, 0.9, 0.99, 1.0):
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


def test_a_law_of_three_preloads_is_a_parabola():
    """Angle at slip as the square of the logarithm's exponential: exact at the three preloads."""
    at = PRELOADS[[0, 5, 11]]
    forces = {
        "normal": np.repeat(at[:, None], 24, 1)[None],
        "tangential": (0.1 * at[:, None] * USED)[None],
        "compliance": np.tile(1e-5 / at[:, None], 24),
    }
    law = _law(at, 0.013 * at, at > 0.0, STEPS, USED, forces, False)
    assert law.sun_forces(at, np.full(3, 0.5))[1] == pytest.approx(0.05 * at, rel=1e-9)


@pytest.fixture
def drive(monkeypatch, paper_joint):
    """Branches of 0.013 m times the preload, in rolling of 0.012 m, 30 kN·m/rad, and 2e-4 of speed lost at slip."""
    asked = []

    def program(joint, preload, torque):
        asked.append((preload, torque))
        size = np.abs(torque)
        force = np.stack([preload, 2.0 * preload])
        return {
            "normal": force,
            "tangential": 0.1 * force,
            "rolling_normal": force,
            "rolling_tangential": 0.2 * force,
            "compliance": np.full(preload.shape, 1.0 / 3e4),
            "speed_loss": 1e-5 + 2e-4 * size / (0.012 * preload),
        }

    def of(standing=lambda preload: 0.013 * preload, largest=3000.0, **changes):
        capacities = lambda points, _: (standing(points.preload), 0.012 * points.preload)  # noqa: E731
        monkeypatch.setattr(branch_law, "compile_fast", lambda *_: capacities)
        monkeypatch.setattr(branch_law, "_program", program)
        return branch_laws(paper_joint(**changes), largest_preload=largest), asked

    return of


def test_tables_reach_from_a_twentieth_to_beyond_the_largest_preload_and_have_the_joints_own(drive):
    laws, asked = drive(output_torque=-5.0)
    preloads = laws.standing.preloads
    assert preloads[[0, -1]] == pytest.approx([50.0, 3060.0], rel=1e-12)
    assert 1000.0 in preloads
    assert np.all(np.diff(preloads) > 0.0)
    assert np.ptp(np.diff(np.log(preloads))) < 0.6 * np.diff(np.log(preloads)).mean()
    # the states that are asked for reach from no torque to the very slip, in the sense of the joint's torque
    assert (laws.direction, drive()[0].direction) == (-1.0, 1.0)
    for (preload, torque), arm in zip(asked[:2], (0.013, 0.012), strict=True):
        used = -torque / (arm * preload)
        assert used[:, 0] == pytest.approx(np.zeros(12))
        assert used[:, -1] == pytest.approx(np.ones(12), rel=2e-9, abs=0.0)
        assert np.all(used < 1.0)


def test_laws_of_springs_that_slip(drive):
    laws, _ = drive()
    preload = np.array([60.0, 1000.0, 2900.0])
    for law, arm, at_slip in (
        (laws.standing, 0.013, 0.013 * preload / 3e4),
        (laws.rolling, 0.012, np.full(3, 2e-4)),
    ):
        assert law.capacity(preload) == pytest.approx(arm * preload, rel=1e-6)
        assert law.demand_at_slip(preload) == pytest.approx(at_slip, rel=1e-3)
        for share in (-0.9, 0.3, 0.8):
            assert law.share(preload, share * at_slip) == pytest.approx(np.full(3, share), abs=2e-3)
    assert laws.standing.sun_forces(preload, np.ones(3))[1] == pytest.approx(0.1 * preload, rel=1e-9)
    assert laws.rolling.sun_forces(preload, np.ones(3))[1] == pytest.approx(0.2 * preload, rel=1e-9)


def test_preloads_without_capacity_are_left_out_and_drives_without_any_refused(drive):
    laws, _ = drive(lambda preload: np.where(preload < 60.0, 0.0, 0.013 * preload))
    assert laws.standing.preloads[0] > 60.0
    assert laws.standing.capacity(1000.0) == pytest.approx(13.0, rel=1e-6)
    for none in (lambda preload: 0.0 * preload, lambda preload: np.inf * preload):
        with pytest.raises(InputError, match="has no limit, or they pass none"):
            drive(none)


def test_states_of_branches_loose_ones_among_them(drive):
    laws, asked = drive(output_torque=-5.0)
    found = laws.states(np.array([1000.0, 0.0, 500.0]), np.array([5.0, 1.0, 2.0]))
    np.testing.assert_allclose(found["normal"], [[1000.0, np.nan, 500.0], [2000.0, np.nan, 1000.0]])
    np.testing.assert_allclose(
        found["speed_loss"], 1e-5 + 2e-4 * np.array([5.0 / 12.0, np.nan, 2.0 / 6.0]), rtol=1e-12
    )
    assert np.min(asked[-1][1]) == -5.0
    with pytest.raises(InputError, match="at most 288 branches"):
        laws.states(np.ones(289), np.ones(289))


def test_missing_values_at_the_slip_go_on_where_four_are_known():
    used = np.array([0.0, 0.5, 0.8, 0.9, 0.95, 1.0])
    rows = np.array([[2.0, 2.5, 2.8, 2.9, np.nan, np.nan], [2.0, 2.5, 2.8, np.nan, np.nan, np.nan]])
    np.testing.assert_allclose(
        _without_gaps(used, rows), [[2.0, 2.5, 2.8, 2.9, 2.95, 3.0], rows[1].tolist()], rtol=1e-12
    )


def test_a_branch_yields_without_the_shafts_that_all_share(monkeypatch):
    """Shafts with 10 and 15 % of the compliance leave three quarters of it to the branches."""
    five = jnp.ones((5, 2))
    forces = {"normal": five, "tangential": five, "slip_ratio": five}
    result = SimpleNamespace(
        solved=jnp.array([True, False]),
        forces=SimpleNamespace(**forces),
        diagnostics=SimpleNamespace(slip_ratio=five, pressure_over_first_yield=five),
        assembly=SimpleNamespace(
            input_shaft_share=0.1, output_shaft_share=0.15, stiffness=SimpleNamespace(output=2e4)
        ),
        rolling=SimpleNamespace(
            **forces,
            shakedown_ratio=five,
            speed_loss=jnp.ones(2),
            drift_per_output_turn=jnp.ones(2),
            output_speed=jnp.ones(2),
            power=SimpleNamespace(
                creep=five, skew=five, hysteresis=five, oil=five, bearings=jnp.ones(2), contact=4.0 * five
            ),
            life_hours=SimpleNamespace(drive=jnp.ones(2)),
        ),
    )
    pins = SimpleNamespace(
        pin_radial=2.0 * jnp.ones((2, 2)),
        pin_tangential=3.0 * jnp.ones((2, 2)),
        sun_torque=-1.5 * jnp.ones(2),
        carrier_torque=9.0 * jnp.ones(2),
        housing_torque=-7.5 * jnp.ones(2),
    )
    monkeypatch.setattr(branch_law, "evaluate", lambda joint: result)
    monkeypatch.setattr(branch_law, "loads_of_forces", lambda joint, normal, tangential: pins)
    monkeypatch.setattr(branch_law, "bearing_speeds", lambda joint, result: 7.0)
    monkeypatch.setattr(branch_law, "stacked_speeds", lambda speeds: jnp.full((4, 2), speeds))
    found = _states(SimpleNamespace(preload=jnp.ones(2), output_torque=jnp.ones(2)))
    np.testing.assert_allclose(found["compliance"], [0.75 / 2e4, np.nan], rtol=1e-12)
    assert found["normal"].shape == (5, 2)
    assert np.isnan(found["normal"][:, 1]).all()
    np.testing.assert_array_equal(found["bearing_speed"][:, 0], 7.0)
    np.testing.assert_array_equal(found["rolling_pins"][..., 0], [[2.0, 2.0], [3.0, 3.0]])
    assert [found[f"rolling_{name}_torque"][0] for name in MEMBERS] == [-1.5, 9.0, -7.5]
    np.testing.assert_array_equal(found["contact"][:, 0], 4.0)
