"""Samples without a value count as the worst: by counting by hand, and by the table of results."""

import numpy as np
import pytest

from asperity.joint_file.reader import parse_case
from asperity.results import RESULTS
from asperity.study.tolerances import uncertainty
from asperity.study.tolerances.failed_samples import quantiles_with_failed, worse_end

SHARES = np.array([0.025, 0.5, 0.975])


@pytest.mark.parametrize(
    ("name", "end"),
    [
        ("assembly_stiffness_output", "low"), ("torque_capacity", "low"), ("drive_life", "low"),
        ("slip_safety", "low"), ("efficiency", "low"), ("slip_ratio", "high"), ("hertz_pressure", "high"),
        ("drift", "high"), ("mass", ""), ("speed_ratio", ""),
    ],
)  # fmt: skip
def test_which_end_is_the_worse_one(name, end):
    assert worse_end(RESULTS[name]) == end


def test_a_few_failed_samples_move_the_quantile_by_their_number():
    """Of 1000 lives 1 to 1000, the ten that fail make 15 of those that live the worst 2.5 %."""
    lives = np.append(np.arange(11.0, 1001.0), np.full(10, np.nan))
    low, median, high = quantiles_with_failed(lives, SHARES, worse="low")
    assert (low, median, high) == (25.0, 500.0, 975.0)  # as if the ten lived 1 to 10
    low, median, high = quantiles_with_failed(lives - 10.0, SHARES, worse="high")
    assert (low, median, high) == (26.0, 501.0, 976.0)  # as if the ten were the largest; the next one above


def test_more_failed_samples_than_the_share_leave_no_value():
    values = np.append(np.arange(965.0), np.full(35, np.nan))  # 3.5 % of the drives slip
    assert quantiles_with_failed(values, SHARES, worse="low")[0] == -np.inf
    assert quantiles_with_failed(values, SHARES, worse="low")[2] < 964.0
    assert quantiles_with_failed(values, SHARES, worse="high")[2] == np.inf
    assert np.isnan(quantiles_with_failed(values, SHARES, worse="")).all()


def test_without_failures_they_are_those_of_the_samples():
    values = np.random.default_rng(0).normal(size=999)
    for worse in ("low", "high", ""):
        np.testing.assert_array_equal(
            quantiles_with_failed(values, SHARES, worse=worse), np.quantile(values, SHARES)
        )


def test_a_life_that_some_drives_do_not_have_keeps_its_mean(monkeypatch, joint_text):
    """A twentieth of the drives do not roll: a mean all the same, and a lower end that fails."""

    def lives(values, points, names, **_):
        preload = np.asarray(points["load.preload"])
        return np.zeros(preload.size, dtype=np.int8), {
            "drive_life": np.where(preload < 910.0, np.nan, preload)[None],
            "torque_capacity": preload[None],
        }

    monkeypatch.setattr(uncertainty, "evaluate_points", lives)
    case = parse_case(joint_text.replace('"1000 N"', '"1000 N +- 100 N, uniform"'), source="x")
    found = uncertainty.uncertainty(case, results=("drive_life", "torque_capacity"), samples=20_000)
    life, capacity = found.sel(result="drive_life"), found.sel(result="torque_capacity")
    # evenly between 900 and 1100 N: a twentieth below 910 N
    assert float(life["failed"]) == pytest.approx(0.05, abs=0.006)
    assert float(life["mean"]) == pytest.approx(1005.0, abs=2.0)
    assert life["quantiles"].values[0] == -np.inf
    # those that fail are the worst: the median of all drives, not of those that live
    assert life["quantiles"].values[1:] == pytest.approx([1000.0, 1095.0], abs=3.0)
    assert float(capacity["failed"]) == 0.0
    assert capacity["quantiles"].values == pytest.approx([905.0, 1000.0, 1095.0], abs=3.0)
