"""The layout of a store: every chunk is a block with a checksum, and the store names its sweep."""

import json

import numpy as np
import pytest

from asperity import __version__
from asperity.joint.status import STATUS_NAMES
from asperity.study.sweep.store_layout import (
    FORMAT,
    MARKS,
    build_store,
    plan_identity,
    store_coordinates,
    store_group,
    stored_plan,
)
from asperity.study.sweep.sweep_plan import make_plan

pytest.importorskip("zarr")


@pytest.fixture
def built(case, tmp_path, axes):
    plan = make_plan(case, axes, ("published_stiffness_output", "slip_ratio"), block_points=4)
    build_store(tmp_path / "s.zarr", plan)
    return tmp_path / "s.zarr", plan


def test_a_chunk_is_a_block_of_all_contacts_and_ends_with_a_checksum(built):
    path, _ = built
    group = store_group(path, "r")
    assert group["slip_ratio"].chunks == (5, 1, 4)
    assert group["published_stiffness_output"].chunks == (1, 4)
    for name in ("status", "slip_ratio", "load.preload", "contact"):
        codecs = json.loads((path / name / "zarr.json").read_text())["codecs"]
        assert codecs[-1]["name"] == "crc32c", name
    assert group["status"].attrs["flag_meanings"].split() == list(STATUS_NAMES)
    assert group["published_stiffness_output"].attrs["units"] == "N*m/rad"
    np.testing.assert_array_equal(group["status"][:], -1)
    np.testing.assert_array_equal(group[MARKS][:], [0, 0, 0])


def test_coordinates_are_those_of_the_axes_in_si_units(built):
    path, plan = built
    found = {name: (dimensions, values) for name, dimensions, values, _ in store_coordinates(plan)}
    np.testing.assert_allclose(found["load.preload"][1], [800.0, 1000.0, 1200.0])
    assert found["contact"][1].tolist() == ["sp", "pwr", "pwl", "wro", "wlo"]
    group = store_group(path, "r")
    for name, (_, values) in found.items():
        np.testing.assert_array_equal(group[name][:], values)


def test_a_store_names_its_sweep_the_version_and_the_format(built, tmp_path):
    path, plan = built
    stored = stored_plan(path)
    assert stored == json.loads(json.dumps(plan_identity(plan)))
    assert (stored["version"], stored["format"]) == (__version__, FORMAT)
    assert stored["results"] == ["published_stiffness_output", "slip_ratio"]
    assert stored_plan(tmp_path) is None
