"""A small sweep and its store."""

import shutil

import numpy as np
import pytest

from asperity.study.parameters import parse_axis
from asperity.study.sweep.store import prepare_store, write_block
from asperity.study.sweep.sweep_plan import make_plan


@pytest.fixture(scope="session")
def axes():
    """Three preloads by four torques."""
    return [parse_axis("load.preload=800 N:1200 N:3"), parse_axis("load.output_torque=0 N*m:5 N*m:4")]


@pytest.fixture(scope="session")
def written():
    """Writes a block whose results all have one value."""

    def write(path, plan, index, value):
        shape = tuple(part.stop - part.start for part in plan.block(index))
        found = {
            name: np.full(((5,) if name == "slip_ratio" else ()) + shape, value) for name in plan.results
        }
        write_block(path, plan, index, np.zeros(shape, dtype=np.int8), found)

    return write


@pytest.fixture(scope="session")
def filled_once(case, tmp_path_factory, axes, written):
    plan = make_plan(case, axes, ("published_stiffness_output", "slip_ratio"), block_points=4)
    path = tmp_path_factory.mktemp("filled") / "s.zarr"
    prepare_store(path, plan)
    for index, value in enumerate((7.0, np.nan, 9.0)):
        written(path, plan, index, value)
    return path, plan


@pytest.fixture
def filled(filled_once, tmp_path):
    """A store of three finished blocks, the second of them without any result: a copy to be damaged."""
    path, plan = filled_once
    return shutil.copytree(path, tmp_path / "s.zarr"), plan
