"""What is in the Zarr store of a sweep: coordinates, empty arrays, marks of progress, and the sweep it belongs to."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from asperity import __version__
from asperity.errors import InputError
from asperity.joint.status import flag_attributes
from asperity.study.datasets import (
    ROW_COORDINATES,
    common_attributes,
    coordinate,
    require,
    result_attributes,
    row_coordinates,
    row_dimensions,
)
from asperity.study.sweep.sweep_plan import PLAN, Plan
from asperity.types import Document

#: Name of the attribute with the sweep, and of the array with a mark for each finished block.
MARKS = "progress/finished"
#: Version of the layout of a store; 2: chunks have checksums and are written even if all values are nan.
FORMAT = 2


def store_group(path: str | Path, mode: str) -> Any:
    """The open Zarr group of a store."""
    return require("zarr").open_group(str(path), mode=mode)


def stored_plan(folder: Path) -> Document | None:
    """The sweep that a store belongs to."""
    if not (folder / "zarr.json").is_file():
        return None
    try:
        stored = json.loads(store_group(folder, "r").attrs[PLAN])
    except Exception:  # not a store, not ours, or damaged beyond recognition
        return None
    return stored if isinstance(stored, dict) else None


def stored_arrays(stored: Document) -> set[str]:
    """Names of all arrays that a store with this sweep may have, below the folder of the store."""
    axes = (axis["path"] for axis in stored["axes"])
    return {"status", MARKS, *axes, *stored["results"], *ROW_COORDINATES}


def plan_identity(plan: Plan) -> Document:
    """What distinguishes the store of one sweep from that of another."""
    return {**plan.as_dict(), "version": __version__, "format": FORMAT}


def build_store(folder: Path, plan: Plan) -> None:
    """Write the coordinates of a sweep and its empty arrays."""
    zarr = require("zarr")
    group = zarr.open_group(str(folder), mode="w")
    dims = tuple(axis.path for axis in plan.axes)
    checksum = zarr.codecs.Crc32cCodec()

    def add(name: str, dimensions: tuple[str, ...], values: np.ndarray, attrs: Document) -> None:
        made = group.create_array(
            name,
            shape=values.shape,
            dtype=values.dtype,
            chunks=values.shape,
            dimension_names=dimensions,
            compressors=(checksum,),
        )
        made[...] = values
        made.attrs.update(attrs)

    def add_empty(
        name: str,
        rows: tuple[str, ...],
        row_shape: tuple[int, ...],
        dtype: str,
        fill: float,
        attrs: Document,
    ) -> None:
        made = group.create_array(
            name,
            shape=row_shape + plan.shape,
            chunks=row_shape + plan.block_shape,
            dtype=dtype,
            fill_value=fill,
            dimension_names=rows + dims,
            compressors=(zarr.codecs.BloscCodec(cname="lz4", clevel=1, shuffle="shuffle"), checksum),
        )
        made.attrs.update(attrs)

    for name, dimensions, values, attributes in store_coordinates(plan):
        add(name, dimensions, values, attributes)
    add_empty("status", (), (), "int8", -1, flag_attributes())
    for row in plan.rows:
        add_empty(row.name, row_dimensions(row), row.row_shape, "float64", np.nan, result_attributes(row))
    count = plan.block_count
    group.create_array(MARKS, shape=(count,), chunks=(1,), dtype="uint8", fill_value=0, compressors=None)
    group.attrs.update({**common_attributes("sweep of a joint"), PLAN: json.dumps(plan_identity(plan))})


def store_coordinates(plan: Plan) -> Iterator[tuple[str, tuple[str, ...], np.ndarray, Document]]:
    """Name, dimensions, values and attributes of each coordinate of a sweep."""
    for axis in plan.axes:
        yield axis.path, *coordinate(axis)
    for row, (dimensions, names, attrs) in row_coordinates(plan.rows).items():
        yield row, dimensions, names.astype(np.dtypes.StringDType()), attrs


def unfinished_blocks(path: str | Path) -> list[int]:
    """Numbers, in order, of the blocks of a store that have no mark of completion."""
    marks = store_group(path, "r")[MARKS]
    try:
        complete = np.asarray(marks[:])
    except Exception:  # a damaged mark is no mark
        complete = np.array([_mark(marks, index) for index in range(marks.shape[0])])
    return np.flatnonzero(complete != 1).tolist()


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
