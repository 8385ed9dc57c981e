"""Datasets of studies as files: netCDF, Parquet, CSV."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.errors import InputError
from asperity.joint.status import STATUS_NAMES
from asperity.results import row_name
from asperity.study.datasets import require, rows_of
from asperity.writing import check_folder, replacing

if TYPE_CHECKING:
    import pandas
    import xarray

#: Suffixes of files that hold a whole dataset, with what writes them.
SUFFIXES = (".nc", ".parquet", ".csv")


def check_table_path(path: str | Path, *, overwrite: bool) -> None:
    """Raise unless a table can be written here, before anything is computed."""
    file = Path(path)
    if file.suffix not in SUFFIXES:
        raise InputError(f"{path}: the ending must be one of .zarr, {', '.join(SUFFIXES)}")
    if file.exists() and (file.is_dir() or not overwrite):
        raise InputError(
            f"{path}: this exists already; choose another name, or allow it to be overwritten",
            options=["overwrite"],
        )
    check_folder(file)
    for module in {".nc": ("h5netcdf", "h5py"), ".parquet": ("pyarrow",), ".csv": ()}[file.suffix]:
        require(module)


def frame(dataset: xarray.Dataset) -> pandas.DataFrame:
    """A dataset as a flat table: one row per point, units in the column names."""
    pd = require("pandas")
    dims = tuple(dataset["status"].dims)
    shape = tuple(dataset.sizes[name] for name in dims)
    columns: dict[str, Any] = {}
    for name in dims:
        if name in dataset.coords:
            column = dataset.coords[name]
            places = (1,) * dims.index(name) + (-1,) + (1,) * (len(dims) - dims.index(name) - 1)
            columns[_header(str(name), column)] = np.broadcast_to(
                column.values.reshape(places), shape
            ).ravel()
    codes = dataset["status"].transpose(*dims).values.ravel()
    columns["status"] = codes
    columns["status_meaning"] = np.array([*STATUS_NAMES, "not_computed"], dtype=object)[codes]
    for name in dataset.data_vars:
        if name == "status":
            continue
        for row, values in rows_of(dataset, str(name)).items():
            columns[_header(row_name(str(name), row), values)] = values.transpose(*dims).values.ravel()
    made: pandas.DataFrame = pd.DataFrame(columns)
    return made


def _header(name: str, variable: xarray.DataArray) -> str:
    return f"{name} [{variable.attrs.get('units', '1')}]"


def write_table(dataset: xarray.Dataset, path: str | Path) -> None:
    """Write a dataset to one file, completely or not at all."""
    file = Path(path)
    with replacing(file) as part:
        if file.suffix == ".nc":
            dataset.to_netcdf(part, engine="h5netcdf")
        elif file.suffix == ".parquet":
            frame(dataset).to_parquet(part, engine="pyarrow", index=False)
        else:
            frame(dataset).to_csv(part, index=False)
