"""Which blocks of a store are finished, damaged or missing.

Every chunk ends with its CRC-32C checksum, which Zarr verifies whenever it reads the chunk. A chunk that is deleted or
changed after it was written is found by :func:`damaged_blocks`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from asperity.errors import InputError
from asperity.study.sweep.store_layout import MARKS, store_coordinates, store_group
from asperity.study.sweep.sweep_plan import Plan


def unfinished_blocks(path: str | Path) -> list[int]:
    """Numbers of the blocks of a store that have no mark of completion.

    Parameters
    ----------
    path : str or Path
        The store.

    Returns
    -------
    list of int
        In order.
    """
    marks = store_group(path, "r")[MARKS]
    try:
        found = np.asarray(marks[:])
    except Exception:  # a damaged mark is no mark
        found = np.array([_mark(marks, index) for index in range(marks.shape[0])])
    return np.flatnonzero(found != 1).tolist()


def _mark(marks: Any, index: int) -> int:
    try:
        return int(marks[index])
    except Exception:
        return 0


def damaged_blocks(path: str | Path, plan: Plan) -> list[int]:
    """Numbers of the blocks that are marked as complete but whose data are missing or differ from their checksum."""
    unfinished = set(unfinished_blocks(path))
    group = store_group(path, "r")
    arrays = {name: _described(group, name, path, plan) for name in ("status", *plan.results)}
    return [
        index
        for index in range(plan.block_count)
        if index not in unfinished
        and not all(_intact(path, name, a, plan, index) for name, a in arrays.items())
    ]


def repair_store(path: str | Path, plan: Plan) -> list[int]:
    """Take the marks of damaged blocks away, and write damaged coordinates again."""
    damaged = damaged_blocks(path, plan)
    try:
        group = store_group(path, "r+")
        for index in damaged:
            group[MARKS][index] = 0
        for name, _, values, _ in store_coordinates(plan):
            if not same_values(group, name, values):
                group[name][...] = values
    except (OSError, KeyError, ValueError) as error:
        raise InputError(
            f"{path}: cannot be repaired ({error}); overwrite it", options=["overwrite"]
        ) from None
    return damaged


def _described(group: Any, name: str, path: str | Path, plan: Plan) -> Any:
    """An array of a store, whose description is as it was written."""
    try:
        array = group[name]
        rows = array.ndim - len(plan.shape)
        if array.shape[rows:] == plan.shape and array.chunks == array.shape[:rows] + plan.block_shape:
            return array
    except Exception:
        pass
    raise InputError(
        f"{path}: the description of the array '{name}' is damaged; overwrite the store",
        options=["overwrite"],
    )


def _intact(path: str | Path, name: str, array: Any, plan: Plan, index: int) -> bool:
    """Whether a block of an array is there and matches its checksum, which Zarr verifies on reading."""
    rows = array.ndim - len(plan.shape)
    key = array.metadata.encode_chunk_key((0,) * rows + plan.block_place(index))
    if not Path(path, name, key).is_file():
        return False
    try:
        array[(slice(None),) * rows + plan.block(index)]
    except Exception:  # the codecs raise errors of many kinds on bytes that are not theirs
        return False
    return True


def same_values(group: Any, name: str, values: np.ndarray) -> bool:
    """Whether an array of a store can be read and has the values that it should have."""
    try:
        return bool(np.array_equal(np.asarray(group[name][...]), values))
    except Exception:
        return False
