"""A sweep equals the joint solved point by point, in memory and from disk, and survives interruption."""

import json
import shutil

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.parameters import parse_axis
from asperity.study.sweep import sweep as sweep_module
from asperity.study.sweep.store import open_store
from asperity.study.sweep.store_layout import unfinished_blocks
from asperity.study.sweep.sweep import sweep

# the force balance stops when the last point of a batch has converged: neighbours may change its last digits,
# to 3e-12 here
AXES = tuple(
    parse_axis(text)
    for text in (
        "load.output_torque=0 N*m:20 N*m:5",
        "surface.fractal_roughness=1e-10 mm:1e-8 mm:3:log",
        "load.preload=800 N:1200 N:2",
    )
)
RESULTS = ("published_stiffness_output", "normal_force", "slip_ratio")


@pytest.fixture(scope="module")
def in_memory(case):
    return sweep(case, AXES, results=RESULTS)


@pytest.fixture(scope="module")
def filled(case, tmp_path_factory):
    path = tmp_path_factory.mktemp("sweep") / "s.zarr"
    sweep(case, AXES, results=RESULTS, store=path, block_points=7)
    return path


@pytest.mark.long
def test_equals_the_joint_solved_directly(in_memory, evaluated_directly):
    direct = evaluated_directly(AXES)
    slips = ~np.asarray(direct.solved).reshape(5, 3, 2)  # equal coefficients: the first slip ends it
    assert 0 < slips.sum() < slips.size
    np.testing.assert_array_equal(in_memory["status"].values != 0, slips)
    stiffness = np.asarray(direct.published.output).reshape(5, 3, 2)
    found = in_memory["published_stiffness_output"].values
    np.testing.assert_allclose(found[~slips], stiffness[~slips], rtol=1e-10)
    assert np.all(np.isnan(found[slips]))
    forces = np.asarray(direct.forces.normal).reshape(5, 5, 3, 2)
    np.testing.assert_allclose(in_memory["normal_force"].values[:, ~slips], forces[:, ~slips], rtol=1e-10)


@pytest.mark.slow
def test_dataset_says_what_it_holds(in_memory):
    assert in_memory["published_stiffness_output"].dims == tuple(axis.path for axis in AXES)
    assert in_memory["normal_force"].dims[0] == "contact"
    for name, variable in {**in_memory.data_vars, **in_memory.coords}.items():
        assert variable.attrs["long_name"]
        assert name == "contact" or variable.attrs["units"]
    torque = in_memory["load.output_torque"]
    assert (torque.attrs["units"], torque.values[-1]) == ("N*m", 20.0)
    meanings = in_memory["status"].attrs["flag_meanings"].split()
    code = int(in_memory["status"].sel({"load.output_torque": 20.0}).max())
    flag = in_memory["status"].attrs["flag_values"].index(code)
    assert meanings[flag] == "beyond_standing_capacity"


@pytest.mark.long
def test_from_disk_it_is_the_same(in_memory, filled):
    stored = open_store(filled).load()
    assert set(stored.data_vars) == set(in_memory.data_vars)
    for name in in_memory.data_vars:
        np.testing.assert_allclose(stored[name].values, in_memory[name].values, rtol=1e-10)
        assert stored[name].attrs["units"] == in_memory[name].attrs["units"]
    assert stored["contact"].values.tolist() == ["sp", "pwr", "pwl", "wro", "wlo"]


@pytest.mark.long
def test_only_unfinished_blocks_are_computed_again(case, filled, tmp_path, monkeypatch):
    import zarr

    path = tmp_path / "s.zarr"
    shutil.copytree(filled, path)
    group = zarr.open_group(str(path), mode="r+")
    # a block whose data are half written has no mark; one that is marked is never touched again
    group["progress/finished"][2] = 0
    group["published_stiffness_output"][1, 0, 1] = -1.0
    group["normal_force"][0, 0, 0, 0] = -7.0
    assert unfinished_blocks(path) == [2]
    computed = []
    block_results = sweep_module.block_results
    monkeypatch.setattr(
        sweep_module,
        "block_results",
        lambda plan, block, **o: computed.append(block) or block_results(plan, block, **o),
    )
    told = []
    again = sweep(case, AXES, results=RESULTS, store=path, block_points=7, report=lambda *n: told.append(n))
    assert len(computed) == 1
    assert told[0] == (30 - again["status"][computed[0]].size, 30)
    assert told[-1] == (30, 30)
    assert float(again["normal_force"][0, 0, 0, 0]) == -7.0
    assert unfinished_blocks(path) == []


@pytest.mark.long
def test_damaged_blocks_are_computed_again_and_said(case, in_memory, filled, tmp_path):
    path = tmp_path / "s.zarr"
    shutil.copytree(filled, path)
    (path / "published_stiffness_output" / "c" / "0" / "0" / "0").unlink()
    changed = path / "normal_force" / "c" / "0" / "1" / "0" / "0"
    content = bytearray(changed.read_bytes())
    content[40] ^= 4
    changed.write_bytes(content)
    said = []
    again = sweep(case, AXES, results=RESULTS, store=path, block_points=7, notice=said.append)
    assert said == [f"2 blocks of {path} are damaged or missing and are computed again"]
    for name in RESULTS:
        np.testing.assert_allclose(again[name].values, in_memory[name].values, rtol=1e-10)
    assert sweep(case, AXES, results=RESULTS, store=path, block_points=7, notice=said.append) is not None
    assert len(said) == 1


@pytest.mark.slow
def test_interruption_keeps_what_is_done(case, in_memory, tmp_path):
    path = tmp_path / "s.zarr"

    def interrupt(done, total):
        if done >= total // 2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sweep(case, AXES, results=RESULTS, store=path, block_points=7, report=interrupt)
    left = unfinished_blocks(path)
    assert 0 < len(left) < 5
    assert int((open_store(path)["status"] == -1).sum()) > 0
    finished = sweep(case, AXES, results=RESULTS, store=path, block_points=7)
    np.testing.assert_array_equal(finished["status"].values, in_memory["status"].values)


@pytest.mark.slow
def test_another_sweep_is_not_written_over(case, joint_text, filled):
    before = json.dumps(sorted(str(p) for p in filled.rglob("*")))
    with pytest.raises(InputError, match="contains another sweep \\(different: the axes, the results"):
        sweep(case, AXES[:1], results=("forces",), store=filled)
    assert json.dumps(sorted(str(p) for p in filled.rglob("*"))) == before


@pytest.mark.long
def test_overwriting_is_only_for_stores_of_sweeps(case, filled, tmp_path):
    path = tmp_path / "s.zarr"
    shutil.copytree(filled, path)
    one = AXES[:1]
    replaced = sweep(case, one, results=RESULTS, store=path, overwrite=True)
    assert replaced["status"].shape == (5,)
    other = tmp_path / "photos.zarr"
    other.mkdir()
    (other / "keep.txt").write_text("mine")
    for overwrite in (False, True):
        with pytest.raises(InputError, match=r"not the store of a sweep|not a sweep's store"):
            sweep(case, one, results=RESULTS, store=other, overwrite=overwrite)
    assert (other / "keep.txt").read_text() == "mine"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"store": "/nowhere/at/all/s.zarr"}, "no folder"),
        ({"scheduler": "tcp://127.0.0.1:1"}, "a cluster writes to a store"),
        ({"results": ("nothing",)}, "no result 'nothing'"),
    ],
)
def test_refusals(case, arguments, told):
    with pytest.raises(InputError, match=told):
        sweep(case, AXES, **{"results": RESULTS, **arguments})


def test_too_large_for_memory_or_disk(case, tmp_path):
    axes = [parse_axis("load.output_torque=0 N*m:5 N*m:2000000")]
    with pytest.raises(InputError, match="stream them to a store"):
        sweep(case, axes, results=RESULTS)
    keys = (
        "sun_torque",
        "loading_roller_torque",
        "carrier_torque",
        "pin_friction_coefficient",
        "pin_diameter",
    )
    units = dict(zip(keys, (" N*m", " N*m", " N*m", "", " mm"), strict=True))
    huge = [parse_axis(f"bearings.{key}=0{unit}:0.1{unit}:1000") for key, unit in units.items()]
    with pytest.raises(InputError, match="GB are free"):
        sweep(case, huge, results=RESULTS, store=tmp_path / "s.zarr")
    assert not (tmp_path / "s.zarr").exists()
