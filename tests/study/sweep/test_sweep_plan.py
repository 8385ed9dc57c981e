"""Blocks tile the grid, each point once, and are not larger than asked."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from asperity.study.parameters import parse_axis
from asperity.study.sweep.sweep_plan import Plan, block_shape, make_plan


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
