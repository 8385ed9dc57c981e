"""A sweep on disk: a Zarr store that is filled block by block and remembers which blocks are complete.

Every block is one chunk of every array. When its data are written, a mark of its own follows: an interrupted
sweep goes on with the blocks that have no mark, and a half-written block is written again.
"""

from __future__ import annotations

import functools
import json
import os
import shutil
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity import __version__
from asperity.errors import InputError
from asperity.joint.results import RESULTS, ROW_NAMES
from asperity.joint.status import flag_attributes
from asperity.study.datasets import (
    common_attributes,
    coordinate,
    require,
    result_attributes,
    row_coordinates,
    row_dimensions,
)
from asperity.study.sweep.plan import Plan
from asperity.writing import cannot_write, check_folder

if TYPE_CHECKING:
    import xarray

_PLAN, _MARKS = "asperity_sweep", "progress/finished"


def prepare_store(path: str | Path, plan: Plan) -> list[int]:
    """Create the store of a sweep, or open it where an earlier run left it.

    Parameters
    ----------
    path : str or Path
        Where it is or shall be.
    plan : Plan
        The sweep.

    Returns
    -------
    list of int
        Numbers of the blocks that are still to be computed.

    Raises
    ------
    InputError
        If something else is there already, or nothing can be written there.
    """
    folder = Path(path)
    if folder.exists():
        _refuse_other(folder, plan)
        return unfinished_blocks(folder)
    check_folder(folder)
    _refuse_full_disk(folder, plan)
    try:
        building = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.parent))
        try:
            _build(building, plan)
            building.chmod(0o777 & ~_umask())
            building.rename(folder)
        except BaseException:
            shutil.rmtree(building, ignore_errors=True)
            raise
    except OSError as error:
        raise cannot_write(folder, error) from None
    return list(range(plan.block_count))


def write_block(
    path: str | Path, plan: Plan, index: int, status: np.ndarray, found: dict[str, np.ndarray]
) -> None:
    """Write a computed block, then mark it as complete.

    Parameters
    ----------
    path : str or Path
        The store.
    plan : Plan
        The sweep.
    index : int
        Number of the block.
    status : ndarray
        Codes, in the shape of the block.
    found : dict of ndarray
        Results, in the shape of the block.

    Raises
    ------
    InputError
        If the disk is full or the like.
    """
    region = plan.block(index)
    made = Path(path).joinpath("zarr.json").stat()
    arrays = _arrays(str(path), (made.st_ino, made.st_mtime_ns))
    try:
        arrays["status"][region] = status
        for name, value in found.items():
            arrays[name][(*(slice(None),) * len(RESULTS[name].row_shape), *region)] = value
        arrays[_MARKS][index] = 1
    except OSError as error:
        raise cannot_write(path, error) from None


@functools.lru_cache(maxsize=2)
def _arrays(path: str, _made: tuple[int, int]) -> dict[str, Any]:
    """The arrays of a store, opened once in a process: to open them for each block costs as much as to write it."""
    group = _group(path, "r+")
    return {name: group[name] for name in ("status", _MARKS, *json.loads(group.attrs[_PLAN])["results"])}


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
    return np.flatnonzero(np.asarray(_group(path, "r")[_MARKS][:]) == 0).tolist()


def open_store(path: str | Path) -> xarray.Dataset:
    """The dataset of a store; its arrays are read when they are used.

    Parameters
    ----------
    path : str or Path
        The store.

    Returns
    -------
    xarray.Dataset
        Lazy.
    """
    xr = require("xarray")
    opened = xr.open_zarr(str(path), consolidated=False)
    told = _plan_of(Path(path))
    ordered: xarray.Dataset = opened if told is None else opened[["status", *told["results"]]]
    return ordered


def remove_store(path: str | Path) -> None:
    """Delete a store that a sweep has made, and nothing else.

    Parameters
    ----------
    path : str or Path
        The store.

    Raises
    ------
    InputError
        If it is no store of a sweep.
    """
    if _plan_of(Path(path)) is None:
        raise InputError(f"{path}: this is not a sweep's store, so it is not deleted; choose another --out")
    shutil.rmtree(path)


def _group(path: str | Path, mode: str) -> Any:
    return require("zarr").open_group(str(path), mode=mode)


def _plan_of(folder: Path) -> dict[str, Any] | None:
    """What a store says about its sweep; None if it is no such store."""
    if not (folder / "zarr.json").is_file():
        return None
    try:
        attributes = _group(folder, "r").attrs
    except (OSError, ValueError, KeyError):
        return None
    told = attributes.get(_PLAN)
    return json.loads(told) if isinstance(told, str) else None


def _refuse_other(folder: Path, plan: Plan) -> None:
    """Raise unless the store here belongs to this very sweep."""
    told = _plan_of(folder)
    if told is None:
        raise InputError(
            f"{folder}: this exists and is not the store of a sweep; choose another --out or remove it"
        )
    wanted = _identity(plan)
    differing = [part for part in wanted if told.get(part) != wanted[part]]
    if differing:
        differing = [
            part for part in differing if part != "block_shape"
        ] or differing  # it follows from the others
        words = {
            "joint": "the joint file",
            "axes": "the axes",
            "results": "the results",
            "version": "the version",
        }
        differ = ", ".join(words.get(part, part) for part in differing)
        raise InputError(
            f"{folder}: this holds another sweep (different: {differ}); choose another --out, or --overwrite it"
        )


def _identity(plan: Plan) -> dict[str, Any]:
    return {**plan.as_dict(), "version": __version__}


def _refuse_full_disk(folder: Path, plan: Plan) -> None:
    free = shutil.disk_usage(folder.parent).free
    if plan.bytes > free:
        raise InputError(
            f"{folder}: {plan.points:.3g} points with {len(plan.results)} results take about {plan.bytes / 1e9:.3g} GB "
            f"and {free / 1e9:.3g} GB are free; ask for fewer with --results, or for fewer points"
        )


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def _build(folder: Path, plan: Plan) -> None:
    """Empty arrays and full coordinates."""
    zarr = require("zarr")
    group = zarr.open_group(str(folder), mode="w")
    dims = tuple(axis.path for axis in plan.axes)

    def add(name: str, dimensions: tuple[str, ...], values: np.ndarray, attrs: dict[str, Any]) -> None:
        made = group.create_array(
            name, shape=values.shape, dtype=values.dtype, chunks=values.shape, dimension_names=dimensions
        )
        made[...] = values
        made.attrs.update(attrs)

    def add_empty(name: str, rows: tuple[str, ...], dtype: str, fill: float, attrs: dict[str, Any]) -> None:
        row_shape = tuple(len(ROW_NAMES[row]) for row in rows)
        made = group.create_array(
            name,
            shape=row_shape + plan.shape,
            chunks=row_shape + plan.block_shape,
            dtype=dtype,
            fill_value=fill,
            dimension_names=rows + dims,
            compressors=zarr.codecs.BloscCodec(cname="lz4", clevel=1, shuffle="shuffle"),
        )
        made.attrs.update(attrs)

    for axis in plan.axes:
        add(axis.path, *coordinate(axis))
    for row, (dimensions, names, attrs) in row_coordinates(plan.results).items():
        add(row, dimensions, names.astype(np.dtypes.StringDType()), attrs)
    add_empty("status", (), "int8", -1, flag_attributes())
    for name in plan.results:
        add_empty(name, row_dimensions(name), "float64", np.nan, result_attributes(name))
    count = plan.block_count
    group.create_array(_MARKS, shape=(count,), chunks=(1,), dtype="uint8", fill_value=0)
    group.attrs.update({**common_attributes("sweep of a joint"), _PLAN: json.dumps(_identity(plan))})
