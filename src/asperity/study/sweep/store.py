"""A sweep on disk: a Zarr store that is filled block by block and remembers which blocks are complete.

Every block is one chunk of every array, and every chunk ends with its CRC-32C checksum, which Zarr verifies whenever
it reads the chunk. When the data of a block are written, a mark follows: an interrupted sweep continues with the
blocks that have no mark, and a half-written block is written again. A chunk that is deleted or changed later is found
by :func:`damaged_blocks`.
"""

from __future__ import annotations

import errno
import functools
import json
import os
import shutil
import tempfile
from collections.abc import Iterator
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
from asperity.study.parameters import axis_from_dict
from asperity.study.sweep.sweep_plan import Plan
from asperity.writing import cannot_write, check_folder

if TYPE_CHECKING:
    import xarray

_PLAN, _MARKS = "asperity_sweep", "progress/finished"
#: Version of the layout of a store; 2: chunks have checksums and are written even if all values are nan.
_FORMAT = 2


def prepare_store(path: str | Path, plan: Plan) -> list[int]:
    """Create the store of a sweep, or open it where an earlier run left it.

    Parameters
    ----------
    path : str or Path
        Folder of the store.
    plan : Plan
        The sweep.

    Returns
    -------
    list of int
        Numbers of the blocks that are still to be computed.

    Raises
    ------
    InputError
        If something else exists there already, or nothing can be written there.
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
        if error.errno in (errno.ENOTEMPTY, errno.EEXIST):
            raise InputError(
                f"{folder}: another run has just created this store; let it finish, or choose another --out"
            ) from None
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
    # a chunk that is all nan is written like any other, so that a missing chunk always means damage
    with require("zarr").config.set({"array.write_empty_chunks": True}):
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
    marks = _group(path, "r")[_MARKS]
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
    """Numbers of the blocks that are marked as complete but whose data are missing or differ from their checksum.

    Parameters
    ----------
    path : str or Path
        The store.
    plan : Plan
        The sweep.

    Returns
    -------
    list of int
        In order.

    Raises
    ------
    InputError
        If not the data but the description of an array is damaged.
    """
    unfinished = set(unfinished_blocks(path))
    group = _group(path, "r")
    arrays = {name: _described(group, name, path, plan) for name in ("status", *plan.results)}
    return [
        index
        for index in range(plan.block_count)
        if index not in unfinished
        and not all(_intact(path, name, a, plan, index) for name, a in arrays.items())
    ]


def repair_store(path: str | Path, plan: Plan) -> list[int]:
    """Take the marks of damaged blocks away, and write damaged coordinates again.

    Parameters
    ----------
    path : str or Path
        The store.
    plan : Plan
        The sweep.

    Returns
    -------
    list of int
        Numbers of the blocks that are to be computed again.

    Raises
    ------
    InputError
        As :func:`damaged_blocks`, or if the store cannot be written.
    """
    damaged = damaged_blocks(path, plan)
    try:
        group = _group(path, "r+")
        for index in damaged:
            group[_MARKS][index] = 0
        for name, _, values, _ in _coordinates(plan):
            if not _same_values(group, name, values):
                group[name][...] = values
    except (OSError, KeyError, ValueError) as error:
        raise InputError(f"{path}: cannot be repaired ({error}); --overwrite it") from None
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
    raise InputError(f"{path}: the description of the array '{name}' is damaged; --overwrite the store")


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


def _same_values(group: Any, name: str, values: np.ndarray) -> bool:
    try:
        return bool(np.array_equal(np.asarray(group[name][...]), values))
    except Exception:
        return False


def open_store(path: str | Path, *, verify: bool = True) -> xarray.Dataset:
    """The dataset of a store; its arrays are read when they are used.

    Parameters
    ----------
    path : str or Path
        The store.
    verify : bool, optional
        Whether to read all data once and compare them with their checksums. Without it a deleted chunk reads as nan.

    Returns
    -------
    xarray.Dataset
        Lazy.

    Raises
    ------
    InputError
        If this is not the store of a sweep, or data of it are damaged.
    """
    xr = require("xarray")
    stored = _plan_of(Path(path))
    if stored is None:
        raise InputError(f"{path}: this is not the store of a sweep")
    if verify:
        axes = tuple(axis_from_dict(axis) for axis in stored["axes"])
        plan = Plan(stored["joint"], axes, tuple(stored["results"]), tuple(stored["block_shape"]))
        damaged = damaged_blocks(path, plan)
        if damaged or not all(
            _same_values(_group(path, "r"), n, values) for n, _, values, _ in _coordinates(plan)
        ):
            raise InputError(
                f"{path}: {len(damaged)} of {plan.block_count} blocks are damaged or missing; the same sweep into this "
                "store computes them again"
            )
    opened = xr.open_zarr(str(path), consolidated=False)
    ordered: xarray.Dataset = opened[["status", *stored["results"]]]
    return ordered


def remove_store(path: str | Path) -> None:
    """Delete the store of a sweep, and nothing else.

    Parameters
    ----------
    path : str or Path
        The store.

    Raises
    ------
    InputError
        If it is not the store of a sweep.
    """
    if _plan_of(Path(path)) is None:
        raise InputError(f"{path}: this is not a sweep's store, so it is not deleted; choose another --out")
    shutil.rmtree(path)


def _group(path: str | Path, mode: str) -> Any:
    return require("zarr").open_group(str(path), mode=mode)


def _plan_of(folder: Path) -> dict[str, Any] | None:
    """The description of its sweep in a store; None if it is not such a store."""
    if not (folder / "zarr.json").is_file():
        return None
    try:
        stored = json.loads(_group(folder, "r").attrs[_PLAN])
    except Exception:  # not a store, not ours, or damaged beyond recognition
        return None
    return stored if isinstance(stored, dict) else None


def _refuse_other(folder: Path, plan: Plan) -> None:
    """Raise unless the store here belongs to this very sweep."""
    stored = _plan_of(folder)
    if stored is None:
        raise InputError(
            f"{folder}: this exists and is not the store of a sweep; choose another --out or remove it"
        )
    wanted = _identity(plan)
    differing = [part for part in wanted if stored.get(part) != wanted[part]]
    if differing:
        differing = [
            part for part in differing if part != "block_shape"
        ] or differing  # it follows from the others
        words = {
            "joint": "the joint file",
            "axes": "the axes",
            "results": "the results",
            "version": "the version",
            "format": "the format of the store",
        }
        differ = ", ".join(words.get(part, part) for part in differing)
        raise InputError(
            f"{folder}: this contains another sweep (different: {differ}); choose another --out, or --overwrite it"
        )


def _identity(plan: Plan) -> dict[str, Any]:
    return {**plan.as_dict(), "version": __version__, "format": _FORMAT}


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

    def add_empty(name: str, rows: tuple[str, ...], dtype: str, fill: float, attrs: dict[str, Any]) -> None:
        row_shape = tuple(len(ROW_NAMES[row]) for row in rows)
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

    for name, dimensions, values, attributes in _coordinates(plan):
        add(name, dimensions, values, attributes)
    add_empty("status", (), "int8", -1, flag_attributes())
    for name in plan.results:
        add_empty(name, row_dimensions(name), "float64", np.nan, result_attributes(name))
    count = plan.block_count
    group.create_array(_MARKS, shape=(count,), chunks=(1,), dtype="uint8", fill_value=0, compressors=None)
    group.attrs.update({**common_attributes("sweep of a joint"), _PLAN: json.dumps(_identity(plan))})


def _coordinates(plan: Plan) -> Iterator[tuple[str, tuple[str, ...], np.ndarray, dict[str, Any]]]:
    """Name, dimensions, values and attributes of the coordinates."""
    for axis in plan.axes:
        yield axis.path, *coordinate(axis)
    for row, (dimensions, names, attrs) in row_coordinates(plan.results).items():
        yield row, dimensions, names.astype(np.dtypes.StringDType()), attrs
