"""What is in the Zarr store of a sweep: coordinates, empty arrays, marks of progress, and the sweep it belongs to."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from asperity import __version__
from asperity.joint.status import flag_attributes
from asperity.study.datasets import (
    common_attributes,
    coordinate,
    require,
    result_attributes,
    row_coordinates,
    row_dimensions,
)
from asperity.study.sweep.sweep_plan import PLAN, Plan

#: Name of the attribute with the sweep, and of the array with a mark for each finished block.
MARKS = "progress/finished"
#: Version of the layout of a store; 2: chunks have checksums and are written even if all values are nan.
FORMAT = 2


def store_group(path: str | Path, mode: str) -> Any:
    """The Zarr group of a store.

    Parameters
    ----------
    path : str or Path
        The store.
    mode : {"r", "r+"}
        For reading, or also for writing.

    Returns
    -------
    zarr.Group
        Open.
    """
    return require("zarr").open_group(str(path), mode=mode)


def stored_plan(folder: Path) -> dict[str, Any] | None:
    """The sweep that a store belongs to."""
    if not (folder / "zarr.json").is_file():
        return None
    try:
        stored = json.loads(store_group(folder, "r").attrs[PLAN])
    except Exception:  # not a store, not ours, or damaged beyond recognition
        return None
    return stored if isinstance(stored, dict) else None


def plan_identity(plan: Plan) -> dict[str, Any]:
    """What distinguishes the store of one sweep from that of another."""
    return {**plan.as_dict(), "version": __version__, "format": FORMAT}


def build_store(folder: Path, plan: Plan) -> None:
    """Write the coordinates of a sweep and its empty arrays."""
    zarr = require("zarr")
    group = zarr.open_group(str(folder), mode="w")
    dims = tuple(axis.path for axis in plan.axes)
    checksum = zarr.codecs.Crc32cCodec()

    def add(name: str, dimensions: tuple[str, ...], values: np.ndarray, attrs: dict[str, Any]) -> None:
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
        attrs: dict[str, Any],
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


def store_coordinates(plan: Plan) -> Iterator[tuple[str, tuple[str, ...], np.ndarray, dict[str, Any]]]:
    """The coordinates of a sweep.

    Parameters
    ----------
    plan : Plan
        The sweep.

    Yields
    ------
    tuple
        Name, dimensions, values and attributes of each.
    """
    for axis in plan.axes:
        yield axis.path, *coordinate(axis)
    for row, (dimensions, names, attrs) in row_coordinates(plan.rows).items():
        yield row, dimensions, names.astype(np.dtypes.StringDType()), attrs
