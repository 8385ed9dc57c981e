"""The layout of a store: every chunk is a block with a checksum, and the store names its sweep."""

import json

import numpy as np
import pytest

from asperity import __version__
from asperity.errors import InputError
from asperity.joint.status import STATUS_NAMES
from asperity.study.sweep.store import open_store, prepare_store
from asperity.study.sweep.store_layout import (
    FORMAT,
    MARKS,
    build_store,
    damaged_blocks,
    plan_identity,
    repair_store,
    store_coordinates,
    store_group,
    stored_plan,
    unfinished_blocks,
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


pytest.importorskip("zarr")


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
def test_damage_is_found_and_repaired(filled, name, block, accident, written):
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


@pytest.mark.long
def test_every_bit_of_a_chunk_is_covered(filled):
    path, plan = filled
    file = chunk(path, "published_stiffness_output", 2)
    content = file.read_bytes()
    for bit in range(8 * len(content)):
        changed = bytearray(content)
        changed[bit // 8] ^= 1 << bit % 8
        file.write_bytes(changed)
        assert damaged_blocks(path, plan) == [2], bit


def test_damaged_marks_and_coordinates(filled, written):
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
        ("slip_ratio", "the description of the array 'slip_ratio' is damaged; overwrite the store"),
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
