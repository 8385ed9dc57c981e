"""Blocks of a sweep on disk: what is written is found, what is unfinished is known, nothing else is touched."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.parameters import parse_axis
from asperity.study.sweep.store import (
    damaged_blocks,
    open_store,
    prepare_store,
    remove_store,
    repair_store,
    unfinished_blocks,
    write_block,
)
from asperity.study.sweep.sweep_plan import make_plan

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


@pytest.fixture
def filled(case, tmp_path):
    """A store of three finished blocks, the second of them without any result."""
    plan = make_plan(case, AXES, ("published_stiffness_output", "slip_ratio"), block_points=4)
    prepare_store(tmp_path / "s.zarr", plan)
    for index, value in enumerate((7.0, np.nan, 9.0)):
        written(tmp_path / "s.zarr", plan, index, value)
    return tmp_path / "s.zarr", plan


def test_an_intact_store_has_no_damage_even_where_there_is_no_result(filled):
    path, plan = filled
    assert damaged_blocks(path, plan) == []
    assert np.isnan(open_store(path)["slip_ratio"][:, 1]).all()


def chunk(path, name, block):
    return path / name / "c" / ("0" if name == "slip_ratio" else ".") / str(block) / "0"


@pytest.mark.parametrize("name", ["status", "published_stiffness_output", "slip_ratio"])
@pytest.mark.parametrize("block", [0, 1, 2])
@pytest.mark.parametrize(
    "accident", ["deleted", "emptied", "shortened", "first bit", "last bit", "swept over"]
)
def test_damage_is_found_and_repaired(filled, name, block, accident):
    path, plan = filled
    file = chunk(path, name, block)
    content = bytearray(file.read_bytes())
    match accident:
        case "deleted":
            file.unlink()
        case "emptied":
            file.write_bytes(b"")
        case "shortened":
            file.write_bytes(content[:-1])
        case "first bit":
            content[0] ^= 1
        case "last bit":
            content[-1] ^= 128
        case "swept over":
            content[:] = bytes(len(content))
    if accident in ("first bit", "last bit", "swept over"):
        file.write_bytes(content)
    assert damaged_blocks(path, plan) == [block]
    with pytest.raises(InputError, match="1 of 3 blocks are damaged or missing; the same sweep"):
        open_store(path)
    assert repair_store(path, plan) == [block]
    assert unfinished_blocks(path) == [block]
    written(path, plan, block, 5.0)
    assert damaged_blocks(path, plan) == unfinished_blocks(path) == []
    np.testing.assert_array_equal(open_store(path)[name][..., block, :], 0 if name == "status" else 5.0)


def test_every_bit_of_a_chunk_is_covered(filled):
    path, plan = filled
    file = chunk(path, "published_stiffness_output", 2)
    content = file.read_bytes()
    for bit in range(8 * len(content)):
        changed = bytearray(content)
        changed[bit // 8] ^= 1 << bit % 8
        file.write_bytes(changed)
        assert damaged_blocks(path, plan) == [2], bit


def test_damaged_marks_and_coordinates(filled):
    path, plan = filled
    marks = path / "progress" / "finished" / "c"
    (marks / "0").unlink()
    (marks / "1").write_bytes(b"")
    (marks / "2").write_bytes(b"\x03")
    assert unfinished_blocks(path) == [0, 1, 2]
    for index in range(3):
        written(path, plan, index, 1.0)
    for name, value in (("load.preload", b"\0" * 28), ("contact", None)):
        file = path / name / "c" / "0"
        if value is None:
            file.unlink()
        else:
            file.write_bytes(value)
        with pytest.raises(InputError, match="damaged or missing"):
            open_store(path)
        assert repair_store(path, plan) == []
        found = open_store(path)
        np.testing.assert_allclose(found["load.preload"], [800.0, 1000.0, 1200.0])
        assert found["contact"].values.tolist() == ["sp", "pwr", "pwl", "wro", "wlo"]


@pytest.mark.parametrize("content", [None, b"", b"{", b"[]", b'{"zarr_format": 3}'])
def test_a_damaged_description_is_said(filled, content):
    path, plan = filled
    for name, reason in (
        ("slip_ratio", "the description of the array 'slip_ratio' is damaged; --overwrite the store"),
        (".", "is not the store of a sweep"),
    ):
        file = path / name / "zarr.json"
        if content is None:
            file.unlink()
        else:
            file.write_bytes(content)
        with pytest.raises(InputError, match=reason):
            open_store(path)
    with pytest.raises(InputError, match="exists and is not the store of a sweep"):
        prepare_store(path, plan)


def test_two_first_runs_into_one_store(case, tmp_path, monkeypatch):
    from asperity.study.sweep import store

    plan = make_plan(case, AXES, ("slip_ratio",))
    build = store._build

    def overtaken(folder, plan):
        build(folder, plan)
        monkeypatch.undo()
        prepare_store(tmp_path / "s.zarr", plan)

    monkeypatch.setattr(store, "_build", overtaken)
    with pytest.raises(
        InputError, match=r"s\.zarr: another run has just created this store; let it finish, or"
    ):
        prepare_store(tmp_path / "s.zarr", plan)
    assert [path.name for path in tmp_path.iterdir()] == ["s.zarr"]
    assert prepare_store(tmp_path / "s.zarr", plan) == [0]


def test_a_store_of_an_older_format_is_refused(case, tmp_path, monkeypatch):
    plan = make_plan(case, AXES, ("slip_ratio",))
    monkeypatch.setattr("asperity.study.sweep.store._FORMAT", 1)
    prepare_store(tmp_path / "s.zarr", plan)
    monkeypatch.undo()
    with pytest.raises(InputError, match=r"different: the format of the store\); choose another --out"):
        prepare_store(tmp_path / "s.zarr", plan)
