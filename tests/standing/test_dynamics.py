"""Dynamics of the paper's joint: its own stiffness, creep and masses by hand."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import AsperityError
from asperity.joint.solve import solve_joint
from asperity.joint.torque_limits import LIMIT_KINDS, MODEL_LIMITS
from asperity.joint_file.build import joint_from_case
from asperity.results.dynamics_document import response_columns
from asperity.standing.dynamics import Inertias, _between_inertias, _limit, _over_torque, dynamics

COUPLED = Inertias(2e-6, 0.05, 0.02)


@pytest.fixture(scope="module")
def found(paper_joint):
    return dynamics(paper_joint(), COUPLED)


@pytest.mark.long
def test_inertias_by_hand(found):
    """Steel cylinders of 5 mm: sun 4, planets 13.5, rollers 5 mm; the ratio is 9."""
    mass = {r: 7850.0 * math.pi * r**2 * 5e-3 for r in (4e-3, 13.5e-3, 5e-3)}
    sun = 0.5 * mass[4e-3] * 4e-3**2
    planet, roller = mass[13.5e-3], mass[5e-3]
    spins = 0.5 * planet * 13.5e-3**2 * (40 / 13.5 + 1) ** 2 + 2 * 0.5 * roller * 5e-3**2 * 7.0**2
    assert float(found.at_torque.input_inertia) == pytest.approx(81.0 * (2e-6 + sun) + 3 * spins, rel=1e-12)
    orbits = planet * 17.5e-3**2 + 2 * roller * 35e-3**2
    assert float(found.at_torque.output_inertia) == pytest.approx(0.05 + 3 * orbits, rel=1e-12)


@pytest.mark.slow
def test_stiffness_and_frequency_are_those_of_the_solved_joint(paper_joint, found):
    k = float(solve_joint(paper_joint()).result.assembly.stiffness.output)
    assert float(found.at_torque.stiffness) == pytest.approx(k, rel=1e-9)
    at = found.at_torque
    assert float(at.locked_frequency) == pytest.approx(
        math.sqrt(k / at.output_inertia) / (2 * math.pi), rel=1e-9
    )
    both = 1.0 / float(at.input_inertia) + 1.0 / float(at.output_inertia)
    assert float(at.free_frequency) == pytest.approx(math.sqrt(k * both) / (2 * math.pi), rel=1e-9)


@pytest.mark.slow
def test_creep_damping_is_the_slope_of_the_lost_speed(paper_joint, found):
    torques = np.array([4.999, 5.001])
    lost = [
        float(solve_joint(paper_joint(output_torque=t)).result.rolling.speed_loss) * 6000 * math.pi / 30 / 9
        for t in torques
    ]
    by_difference = np.diff(torques)[0] / (lost[1] - lost[0])
    assert float(found.at_torque.creep_damping) == pytest.approx(by_difference, rel=1e-6)
    corner = float(found.at_torque.stiffness) / by_difference / (2 * math.pi)
    assert float(found.at_torque.corner_frequency) == pytest.approx(corner, rel=1e-6)


@pytest.mark.slow
def test_a_joint_that_stands_has_no_creep(paper_joint):
    found = dynamics(paper_joint(sun_speed=0.0), COUPLED)
    assert np.isinf(found.at_torque.creep_damping)
    assert float(found.at_torque.corner_frequency) == 0.0
    np.testing.assert_array_equal(found.turning_load, found.standing_load)


@pytest.mark.slow
def test_over_torque_up_to_nearly_the_capacity(paper_joint, found):
    over = found.over_torque
    assert over.output_torque[0] == 0.0
    capacity = float(solve_joint(paper_joint()).standing_capacity.output_torque)
    assert over.output_torque[-1] == pytest.approx(0.98 * capacity, rel=1e-9)
    assert np.all(np.diff(over.locked_frequency) < 0.0)
    reverse = dynamics(dataclasses.replace(paper_joint(), output_torque=np.asarray(-5.0)), COUPLED)
    assert reverse.over_torque.output_torque[-1] < 0.0


@pytest.mark.slow
@pytest.mark.parametrize(
    ("torque", "limit", "kind", "largest"),
    [
        (-5.0, 10.0, "gross_slip", -6.86),
        (5.0, math.inf, "none", 5.0),
    ],
)
def test_the_axis_ends_below_the_capacity_in_the_sense_of_the_torque(
    paper_joint, monkeypatch, torque, limit, kind, largest
):
    """At 98 % of 7 N·m backwards, or at the torque itself where there is no limit."""
    limits = {"standing_capacity": limit, "reverse_standing_capacity": 7.0}
    known = {
        name: SimpleNamespace(output_torque=value, limit=LIMIT_KINDS.index(kind))
        for name, value in limits.items()
    }
    solution = SimpleNamespace(result=solve_joint(paper_joint()).result, **known)
    monkeypatch.setattr("asperity.standing.dynamics.solve_joint", lambda joint: solution)
    found = dynamics(paper_joint(output_torque=torque), COUPLED)
    assert float(found.over_torque.output_torque[-1]) == pytest.approx(largest, rel=1e-12)
    assert float(found.at_torque.output_torque) == torque


@pytest.mark.slow
def test_another_drive_creeps_by_its_lost_speed_at_the_output(planar_case, monkeypatch):
    """A share of 2e-3 and 0 of 1500 rpm over 6 for each N·m; nan where a contact slips, infinite without creep."""
    made_up = SimpleNamespace(
        solved=np.array([True, True, False]),
        assembly=np.array([[9000.0, 1.0], [8000.0, 1.0], [7000.0, 1.0]]),
    )
    monkeypatch.setattr("asperity.standing.dynamics.standing_over_torque", lambda *_, **__: made_up)
    slopes = np.array([2e-3, 0.0, 2e-3])
    monkeypatch.setattr("asperity.standing.dynamics.lost_speed_slopes", lambda *_: slopes)
    monkeypatch.setattr("asperity.standing.dynamics.joint_inertias", lambda _: (1e-6, 0.01))
    found = _over_torque(joint_from_case(planar_case("planetary")), COUPLED, np.array([1.0, 2.0, 3.0]))
    lost = 2e-3 * 1500.0 * math.pi / 30.0 / 6.0
    np.testing.assert_allclose(found.creep_damping, [1.0 / lost, math.inf, 1.0 / lost], rtol=1e-12)
    np.testing.assert_allclose(found.stiffness, [9000.0, 8000.0, math.nan], rtol=1e-12)
    corner = 9000.0 * lost / (2.0 * math.pi)
    np.testing.assert_allclose(found.corner_frequency, [corner, 0.0, math.nan], rtol=1e-12)
    np.testing.assert_allclose(found.input_inertia, 36.0 * (2e-6 + 1e-6), rtol=1e-12)
    np.testing.assert_allclose(found.output_inertia, 0.05 + 0.01, rtol=1e-12)


@pytest.mark.slow
def test_far_below_the_resonance_two_masses_move_as_one(found):
    assert np.angle(complex(found.standing_motor[0]), deg=True) % 360.0 == pytest.approx(180.0, abs=0.1)
    slow = abs(complex(found.standing_load[0])) * (2 * math.pi * float(found.frequency[0])) ** 2
    both = float(found.at_torque.input_inertia + found.at_torque.output_inertia)
    assert slow * both == pytest.approx(1.0, rel=1e-3)
    assert found.over_torque.locked_frequency.shape == (25,)


def test_a_response_without_losses_is_shown_beside_its_natural_frequencies(paper_joint, monkeypatch):
    """On them rounding decides; a millionth below and above them 1 - r^2 is -+2e-6."""

    def over(joint, torques, **_):
        shape = np.size(torques)
        each = np.column_stack([np.full(shape, 9000.0), np.ones(shape)])
        return SimpleNamespace(solved=np.full(shape, True), assembly=each)

    limit = SimpleNamespace(output_torque=13.0, limit=LIMIT_KINDS.index("gross_slip"))
    stiffness = SimpleNamespace(stiffness=SimpleNamespace(output=9000.0))
    solution = SimpleNamespace(
        result=SimpleNamespace(assembly=stiffness), standing_capacity=limit, reverse_standing_capacity=limit
    )
    monkeypatch.setattr("asperity.standing.dynamics.solve_joint", lambda _: solution)
    monkeypatch.setattr("asperity.standing.dynamics.standing_over_torque", over)
    monkeypatch.setattr(
        "asperity.standing.dynamics.lost_speed_slopes", lambda _, torques: np.full(np.size(torques), 1e-4)
    )
    found = dynamics(paper_joint(), Inertias(2e-6, 0.05, 0.0))
    at, columns = found.at_torque, response_columns(found)
    assert all(np.all(np.isfinite(column)) for column in columns.values())
    beside = np.abs(columns["frequency_Hz"] / at.free_frequency - 1.0) < 2e-6
    assert np.sum(beside) == 2
    both = float(at.input_inertia + at.output_inertia)
    peak = 1.0 / (both * (2.0 * math.pi * float(at.free_frequency)) ** 2 * 2e-6)
    np.testing.assert_allclose(columns["standing_load_rad_per_Nm"][beside], peak, rtol=1e-5)


@pytest.mark.slow
def test_a_joint_that_slips_is_refused(paper_joint):
    with pytest.raises(AsperityError, match="beyond the standing torque capacity"):
        dynamics(paper_joint(output_torque=50.0), COUPLED)


def test_a_joint_between_two_inertias_by_hand():
    """Ratio 6: 36 (2e-6 + 1e-6) at the input, 0.05 + 0.01 at the output; 9000 N·m/rad; 1/0.2 and 1800/2 pi."""
    slope = np.array([0.2, 0.0, np.nan])
    found = _between_inertias(
        np.zeros(3), np.full(3, 9000.0), slope, 6.0, (1e-6, 0.01), Inertias(2e-6, 0.05, 0.02)
    )
    np.testing.assert_allclose(found.input_inertia, 1.08e-4, rtol=1e-12)
    np.testing.assert_allclose(found.output_inertia, 0.06, rtol=1e-12)
    np.testing.assert_allclose(found.locked_frequency, math.sqrt(9000.0 / 0.06) / (2 * math.pi), rtol=1e-12)
    both = 1.0 / 1.08e-4 + 1.0 / 0.06
    np.testing.assert_allclose(found.free_frequency, math.sqrt(9000.0 * both) / (2 * math.pi), rtol=1e-12)
    np.testing.assert_allclose(found.creep_damping, [5.0, math.inf, math.nan], rtol=1e-12)
    np.testing.assert_allclose(found.corner_frequency, [1800.0 / (2 * math.pi), 0.0, math.nan], rtol=1e-12)


def test_the_axis_ends_at_the_capacity_or_where_the_model_does():
    """In the sense of the torque; at most at 2/0.98 of it where only what is computed ends."""
    for torque, limit, kind, end in (
        (5.0, 10.0, "gross_slip", 10.0),
        (-5.0, 10.0, "gross_slip", 7.0),
        (5.0, 2e4, MODEL_LIMITS[0], 10.0 / 0.98),
        (5.0, 6.0, MODEL_LIMITS[0], 6.0),
    ):
        known = LIMIT_KINDS.index(kind)
        solution = SimpleNamespace(
            standing_capacity=SimpleNamespace(output_torque=limit, limit=known),
            reverse_standing_capacity=SimpleNamespace(output_torque=7.0, limit=known),
        )
        assert _limit(solution, torque) == pytest.approx(end, rel=1e-12)
