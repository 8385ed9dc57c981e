"""Every damage of a store is found, whatever bit it hits, and repaired by the same sweep."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.study.sweep.store import open_store, prepare_store
from asperity.study.sweep.store_integrity import damaged_blocks, repair_store, unfinished_blocks

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


@pytest.mark.slow
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
