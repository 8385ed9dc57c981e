"""Blocks of a sweep on disk: what is written is found, what is unfinished is known, nothing else is touched."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.parameters import parse_axis
from asperity.study.sweep.plan import make_plan
from asperity.study.sweep.store import open_store, prepare_store, remove_store, unfinished_blocks, write_block

pytest.importorskip("zarr")
AXES = [parse_axis("load.preload=800 N:1200 N:3"), parse_axis("load.output_torque=0 N*m:5 N*m:4")]


def written(path, plan, index, value):
    shape = tuple(part.stop - part.start for part in plan.block(index))
    found = {name: np.full(((5,) if name == "slip_ratio" else ()) + shape, value) for name in plan.results}
    write_block(path, plan, index, np.zeros(shape, dtype=np.int8), found)


def test_blocks_are_found_where_they_were_written(case, tmp_path):
    plan = make_plan(case, AXES, ("published_stiffness_output", "slip_ratio"), block_points=4)
    assert prepare_store(tmp_path / "s.zarr", plan) == [0, 1, 2]
    written(tmp_path / "s.zarr", plan, 1, 7.0)
    assert unfinished_blocks(tmp_path / "s.zarr") == prepare_store(tmp_path / "s.zarr", plan) == [0, 2]
    found = open_store(tmp_path / "s.zarr")
    assert list(found.data_vars) == ["status", *plan.results]
    np.testing.assert_array_equal(found["published_stiffness_output"][1], 7.0)
    np.testing.assert_array_equal(found["slip_ratio"][:, 1], 7.0)
    assert np.isnan(found["published_stiffness_output"][::2]).all()
    np.testing.assert_array_equal(found["status"], [[-1] * 4, [0] * 4, [-1] * 4])
    np.testing.assert_allclose(found["load.preload"], [800.0, 1000.0, 1200.0])


def test_a_store_made_anew_in_the_same_place_is_not_the_old_one(case, tmp_path):
    path = tmp_path / "s.zarr"
    for results, value in ((("published_stiffness_output",), 1.0), (("slip_ratio",), 2.0)):
        plan = make_plan(case, AXES, results)
        prepare_store(path, plan)
        written(path, plan, 0, value)
        np.testing.assert_array_equal(open_store(path)[results[0]], value)
        remove_store(path)
    assert not path.exists()


def test_what_is_no_store_or_another_sweeps_is_left_alone(case, tmp_path):
    plan = make_plan(case, AXES, ("slip_ratio",))
    (tmp_path / "mine").mkdir()
    for refused in (lambda: prepare_store(tmp_path / "mine", plan), lambda: remove_store(tmp_path / "mine")):
        with pytest.raises(InputError, match=r"is not (the store of a sweep|a sweep's store)"):
            refused()
    assert (tmp_path / "mine").is_dir()
    prepare_store(tmp_path / "s.zarr", plan)
    with pytest.raises(InputError, match=r"another sweep \(different: the results\)"):
        prepare_store(tmp_path / "s.zarr", make_plan(case, AXES, ("published_stiffness_output",)))
    with pytest.raises(InputError, match="there is no folder"):
        prepare_store(tmp_path / "nowhere" / "s.zarr", plan)
