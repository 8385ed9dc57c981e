"""Blocks tile the grid, each point once, and are not larger than asked."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from asperity.study.parameters import parse_axis
from asperity.study.sweep import sweep_plan as module
from asperity.study.sweep.sweep_plan import Plan, block_results, block_shape, make_plan


@given(st.lists(st.integers(1, 12), min_size=1, max_size=4), st.integers(1, 200))
def test_blocks_tile_the_grid(shape, most):
    block = block_shape(tuple(shape), most)
    assert 1 <= math.prod(block) <= most
    axes = tuple(type("A", (), {"count": count})() for count in shape)
    seen = np.zeros(shape, dtype=int)
    plan = Plan({}, axes, (), block)
    for part in map(plan.block, range(plan.block_count)):
        seen[part] += 1
    assert np.all(seen == 1)


def test_blocks_are_filled_well():
    # 4 axes, 1e7 points: blocks of nearly the size asked for
    block = block_shape((50, 40, 100, 50), 250_000)
    assert math.prod(block) >= 200_000


@pytest.mark.parametrize("results", [("published_stiffness_output",), ("all",)])
def test_plan_is_plain_data(case, results):
    plan = make_plan(case, [parse_axis("load.output_torque=0 N*m:5 N*m:11")], results)
    assert pickle.loads(pickle.dumps(plan)) == plan
    assert plan.points == 11
    assert plan.as_dict()["axes"][0]["path"] == "load.output_torque"


def test_size_of_results_and_of_blocks_of_many_results(case, monkeypatch):
    """A byte for the status and eight for each number; a block holds so many points that its numbers fit."""
    axes = [parse_axis("load.output_torque=0 N*m:5 N*m:100"), parse_axis("load.preload=900 N:1 kN:70")]
    plan = make_plan(case, axes, ("published_stiffness_output", "slip_ratio"))
    assert plan.bytes == 7000 * (1 + 8 * 6)  # the stiffness, and the slip of five contacts
    assert plan.block_shape == (100, 70)
    monkeypatch.setattr(module, "_BLOCK_NUMBERS", 6 * 700)
    few = make_plan(case, axes, ("published_stiffness_output", "slip_ratio"))
    assert few.block_shape == (10, 70)
    monkeypatch.setattr(module, "BLOCK_POINTS", 350)
    assert make_plan(case, axes, ("published_stiffness_output", "slip_ratio")).block_shape == (5, 70)


def test_a_block_has_its_results_where_its_points_are(case, monkeypatch):
    axes = [parse_axis("load.output_torque=0 N*m:5 N*m:6"), parse_axis("load.preload=100 N:400 N:4")]
    plan = make_plan(case, axes, ("published_stiffness_output",), block_points=12)

    def evaluated(values, points, results, *, batch):
        assert batch == 12
        both = points["load.output_torque"] + points["load.preload"]
        return points["load.output_torque"].astype(np.int8), {"a": both, "b": np.stack([both, 2.0 * both])}

    monkeypatch.setattr(module, "evaluate_points", evaluated)
    block = plan.block(1)
    status, found = block_results(plan, block)
    torque, preload = np.arange(3.0, 6.0), np.array([100.0, 200.0, 300.0, 400.0])
    assert status.tolist() == [[3] * 4, [4] * 4, [5] * 4]
    np.testing.assert_allclose(found["a"], torque[:, None] + preload)
    np.testing.assert_allclose(found["b"][1], 2.0 * (torque[:, None] + preload))
