"""A sweep on disk: a Zarr store that is filled block by block and remembers which blocks are complete.

Every block is one chunk of every array. When the data of a block are written, a mark follows: an interrupted sweep
continues with the blocks that have no mark, and a half-written block is written again.
"""

from __future__ import annotations

import errno
import functools
import json
import os
import re
import shutil
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from asperity.errors import InputError, one_line
from asperity.study.datasets import require
from asperity.study.parameters import axis_from_dict
from asperity.study.sweep.store_layout import (
    MARKS,
    build_store,
    damaged_blocks,
    plan_identity,
    same_values,
    store_coordinates,
    store_group,
    stored_arrays,
    stored_plan,
    unfinished_blocks,
)
from asperity.study.sweep.sweep_plan import PLAN, Plan
from asperity.types import Document
from asperity.writing import cannot_write, check_folder, interrupted_afterwards

if TYPE_CHECKING:
    import xarray


#: Ending of a file that Zarr was writing when it was interrupted.
_UNFINISHED = r"\.[0-9a-f]{32}\.partial"


def prepare_store(path: str | Path, plan: Plan) -> list[int]:
    """Create the store of a sweep, or open it where an earlier run left it."""
    folder = Path(path)
    if folder.exists():
        _refuse_other(folder, plan)
        return unfinished_blocks(folder)
    check_folder(folder)
    _refuse_full_disk(folder, plan)
    try:
        building = Path(tempfile.mkdtemp(prefix=f".{folder.name}-", dir=folder.parent))
        try:
            with interrupted_afterwards():  # Zarr writes in threads, which would go on
                build_store(building, plan)
            building.chmod(0o777 & ~_umask())
            building.rename(folder)
        except BaseException:
            shutil.rmtree(building, ignore_errors=True)
            raise
    except OSError as error:
        if error.errno in (errno.ENOTEMPTY, errno.EEXIST):
            raise InputError(
                f"{folder}: another run has just created this store; let it finish, or choose another folder",
                options=["out"],
            ) from None
        raise cannot_write(folder, error) from None
    return list(range(plan.block_count))


def write_block(
    path: str | Path, plan: Plan, index: int, status: np.ndarray, result_values: dict[str, np.ndarray]
) -> None:
    """Write a computed block, then mark it as complete; arrays in the shape of the block.

    An ``InputError`` is raised if the disk is full or the like.
    """
    region = plan.block(index)
    made = Path(path).joinpath("zarr.json").stat()
    arrays = _arrays(str(path), (made.st_ino, made.st_mtime_ns))
    try:
        arrays["status"][region] = status
        for name, value in result_values.items():
            arrays[name][(..., *region)] = value
        arrays[MARKS][index] = 1
    except OSError as error:
        raise cannot_write(path, error) from None


@functools.lru_cache(maxsize=2)
def _arrays(path: str, _made: tuple[int, int]) -> Document:
    """The arrays of a store, opened once in a process: to open them for each block costs as much as to write it."""
    group = store_group(path, "r+")
    # a chunk that is all nan is written like any other, so that a missing chunk always means damage
    with require("zarr").config.set({"array.write_empty_chunks": True}):
        return {name: group[name] for name in ("status", MARKS, *json.loads(group.attrs[PLAN])["results"])}


def open_store(path: str | Path, *, verify: bool = True) -> xarray.Dataset:
    """The dataset of a store; its arrays are read when they are used.

    ``verify`` reads all data once and compares them with their checksums; without it a deleted chunk reads as nan. An
    ``InputError`` is raised if this is not the store of a sweep, or data of it are damaged.
    """
    xr = require("xarray")
    stored = stored_plan(Path(path))
    if stored is None:
        raise InputError(f"{path}: this is not the store of a sweep")
    if verify:
        axes = tuple(axis_from_dict(axis) for axis in stored["axes"])
        plan = Plan(stored["joint"], axes, tuple(stored["results"]), tuple(stored["block_shape"]))
        damaged = damaged_blocks(path, plan)
        if damaged or not all(
            same_values(store_group(path, "r"), n, values) for n, _, values, _ in store_coordinates(plan)
        ):
            raise InputError(
                f"{path}: {len(damaged)} of {plan.block_count} blocks are damaged or missing; the same sweep into this "
                "store computes them again"
            )
    return xr.open_zarr(str(path), consolidated=False)[["status", *stored["results"]]]


def remove_store(path: str | Path) -> None:
    """Delete the store of a sweep, and nothing else."""
    if Path(path).is_symlink():
        raise InputError(f"{path}: this is a link; give the name of the store itself", options=["out"])
    stored = stored_plan(Path(path))
    if stored is None:
        raise InputError(
            f"{path}: this is not the store of a sweep, so it is not deleted; choose another folder",
            options=["out"],
        )
    other = next(_not_of_store(Path(path), stored), None)
    if other is not None:
        raise InputError(
            f"{path}: {one_line(str(other))} in this store is of no sweep, so nothing is deleted; move it away, or "
            "choose another folder",
            options=["out"],
        )
    shutil.rmtree(path)


def check_store(path: str | Path, *inputs: str | Path) -> None:
    """Raise an ``InputError`` if one of the input files is in the folder that is to be the store."""
    folder = Path(path).resolve()
    for name in inputs:
        if folder in Path(name).resolve().parents:
            raise InputError(
                f"{path}: {one_line(str(name))}, which is read, is in this folder; choose another folder",
                options=["out"],
            )


def _not_of_store(folder: Path, stored: Document) -> Iterator[Path]:
    """Files below a store that Zarr has not written for its sweep: neither descriptions nor chunks of its arrays."""
    arrays = stored_arrays(stored)
    groups = {name.rpartition("/")[0] for name in arrays} - {""}
    array, group = ("|".join(map(re.escape, sorted(names))) for names in (arrays, arrays | groups))
    own = re.compile(rf"(({group})/)?zarr(\.json|{_UNFINISHED})|({array})/c(/\d+)+({_UNFINISHED})?", re.ASCII)
    for file in folder.rglob("*"):
        within = file.relative_to(folder)
        if file.is_symlink() or not (file.is_dir() or own.fullmatch(within.as_posix())):
            yield within


def _refuse_other(folder: Path, plan: Plan) -> None:
    """Raise unless the store here belongs to this very sweep."""
    stored = stored_plan(folder)
    if stored is None:
        raise InputError(
            f"{folder}: this exists and is not the store of a sweep; choose another folder or remove it",
            options=["out"],
        )
    wanted = plan_identity(plan)
    differing = [part for part in wanted if stored.get(part) != wanted[part]]
    if differing:
        # the shape of the blocks follows from the others
        differing = [part for part in differing if part != "block_shape"] or differing
        words = {
            "joint": "the joint file",
            "axes": "the axes",
            "results": "the results",
            "version": "the version",
            "format": "the format of the store",
        }
        differ = ", ".join(words.get(part, part) for part in differing)
        raise InputError(
            f"{folder}: this contains another sweep (different: {differ}); choose another folder, or overwrite it",
            options=["out", "overwrite"],
        )


def _refuse_full_disk(folder: Path, plan: Plan) -> None:
    free = shutil.disk_usage(folder.parent).free
    if plan.bytes > free:
        raise InputError(
            f"{folder}: {plan.points:.3g} points with {len(plan.results)} results take about {plan.bytes / 1e9:.3g} GB "
            f"and {free / 1e9:.3g} GB are free; ask for fewer results, or for fewer points",
            options=["results"],
        )


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
