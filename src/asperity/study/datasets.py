"""Results of studies as xarray datasets: dimensions, coordinates, units and long names; as files."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity import __version__
from asperity.errors import InputError
from asperity.extras import optional_module
from asperity.joint.status import STATUS_NAMES, flag_attributes
from asperity.joint_file.si_tables import key_at
from asperity.made_files import Kind, table_where
from asperity.results import RESULTS, Result, row_name
from asperity.study.parameters import SweepAxis, long_name
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import from_si, parse_quantity
from asperity.writing import check_folder, replacing

if TYPE_CHECKING:
    import pandas
    import xarray


#: Suffixes of files that hold a whole dataset, with what writes them.
SUFFIXES = (".nc", ".parquet", ".csv")


def require(module: str) -> Any:
    """A module of the extra ``study``, imported; a ``MissingExtraError`` if it is not installed."""
    return optional_module(module, extra="study", needs="studies need")


def coordinate(axis: SweepAxis) -> tuple[tuple[str], np.ndarray, dict[str, str]]:
    """One axis as a coordinate: dimensions, values, attributes."""
    return (axis.path,), axis.values, key_attributes(axis.path)


def key_attributes(path: str) -> dict[str, str]:
    """Attributes of a number of the joint file."""
    return {"units": key_at(path).dimension.si_unit, "long_name": long_name(path)}


def result_attributes(result: Result) -> dict[str, str]:
    """Attributes of a row of the table of results: ``units`` and ``long_name``.

    To them ``categories`` where its values number them; ``comment`` where not every joint has all of its rows.
    """
    attributes = {"units": result.si_unit, "long_name": result.said}
    if result.present is not None and result.note:
        attributes["comment"] = result.note
    return attributes | ({"categories": " ".join(result.categories)} if result.categories else {})


def result_rows(results: Iterable[Result]) -> list[tuple[str, str, str]]:
    """Every number that some results have: one, or one for each contact or clearance.

    Name such as ``slip_ratio_sp``, SI unit and label of each number.
    """
    return [
        (row_name(result.name, row), result.si_unit, f"{result.said}, {row}".removesuffix(", "))
        for result in results
        for row in result.row_names
    ]


def result_words(data: xarray.Dataset, name: str) -> str:
    """What a result is called for the drive whose points a dataset has."""
    return str(data[name].attrs["long_name"])


#: Dimensions that are not called after what their rows stand for: a result has that name.
_DIMENSIONS = {"clearance": "rollers"}
#: Dimension of rows → what its coordinate says.
ROW_COORDINATES = {
    "contact": "contact of a branch",
    "rollers": "rollers between which a clearance is",
    "body": "body of a branch; those on the axis are shared by all branches",
    "pin": "carrier pin, named after its loading roller",
    "bearing": "rolling bearing",
    "rim": "rim of a ring or of a hollow roller",
}


def row_dimensions(result: Result) -> tuple[str, ...]:
    """Dimensions in front of those of the points: none, or one name, what the rows of a result stand for."""
    return () if result.axis == "one" else (_DIMENSIONS.get(result.axis, result.axis),)


def row_coordinates(results: Iterable[Result]) -> dict[str, tuple[tuple[str], np.ndarray, dict[str, str]]]:
    """Coordinates of the contacts and clearances, where results have one number for each."""
    needed = {dimension: result.row_names for result in results for dimension in row_dimensions(result)}
    return {
        dimension: ((dimension,), np.array(names, dtype="U"), {"long_name": ROW_COORDINATES[dimension]})
        for dimension, names in needed.items()
    }


def rows_of(data: xarray.Dataset, name: str) -> dict[str, xarray.DataArray]:
    """Values of a variable by the name of their row, a contact or clearance; the name is empty for a single number."""
    variable = data[name]
    (dimension,) = (set(variable.dims) - set(data["status"].dims)) or {None}
    if dimension is None:
        return {"": variable}
    return {str(row): variable.sel({dimension: row}) for row in data[dimension].values}


def dataset(
    *,
    dimensions: tuple[str, ...],
    coordinates: Mapping[str, Any],
    status: np.ndarray,
    result_values: Mapping[str, np.ndarray],
    table: Mapping[str, Result],
    attributes: Mapping[str, Any],
) -> xarray.Dataset:
    """A dataset of evaluated points."""
    xr = require("xarray")
    variables: Document = {"status": (dimensions, status, flag_attributes())}
    for name, value in result_values.items():
        variables[name] = ((*row_dimensions(table[name]), *dimensions), value, result_attributes(table[name]))
    coords = {**coordinates, **row_coordinates(table[name] for name in result_values)}
    return xr.Dataset(variables, coords=coords, attrs=dict(attributes))


def asked_units(
    units: Iterable[str], *, axes: Iterable[SweepAxis], results: Iterable[Result]
) -> dict[str, str]:
    """Name of an axis or a result → the unit in which it is asked for, the last one that measures it.

    An ``InputError`` for a unit that is unknown or measures none of them.
    """
    dimensions = {axis.path: key_at(axis.path).dimension for axis in axes}
    dimensions |= {result.name: result.dimension for result in results if not result.categories}
    chosen: dict[str, str] = {}
    for unit in units:
        from_si(1.0, unit)  # raises if it is unknown
        fitting = [name for name, dimension in dimensions.items() if _measures(unit, dimension)]
        if not fitting:
            si = dict.fromkeys(d.si_unit for d in dimensions.values() if d is not Dimension.DIMENSIONLESS)
            raise InputError(
                f"the unit '{unit}' measures nothing here; in SI the numbers are in {', '.join(si)}"
            )
        chosen |= dict.fromkeys(fitting, unit)
    return chosen


def _measures(unit: str, dimension: Dimension) -> bool:
    if dimension is Dimension.DIMENSIONLESS and unit != "%":
        return False
    try:
        return parse_quantity(f"0 {unit}", dimension) == 0.0  # a temperature in K has another zero
    except InputError:
        return False


def in_units(dataset: xarray.Dataset, units: Mapping[str, str]) -> xarray.Dataset:
    """The same dataset with some of its axes and results in other units: name → unit."""
    converted = {}
    for name, unit in units.items():
        variable = dataset[name]
        numbers = from_si(variable.values, unit)
        converted[name] = (variable.dims, numbers, {**variable.attrs, "units": unit})
    axes = {name: values for name, values in converted.items() if name in dataset.coords}
    return dataset.assign({n: v for n, v in converted.items() if n not in axes}).assign_coords(axes)


def in_si(dataset: xarray.Dataset) -> xarray.Dataset:
    """A dataset of :func:`in_units` in SI units again."""
    made = dataset.copy()
    for name in map(str, (*dataset.coords, *dataset.data_vars)):
        variable = dataset[name]
        unit = variable.attrs.get("units")
        if unit is not None and name != "status":
            si = RESULTS[name].si_unit if name in RESULTS else key_at(name).dimension.si_unit
            if unit != si:
                attributes = {**variable.attrs, "units": si}
                made[name] = (variable.dims, variable.values / from_si(1.0, unit), attributes)
    return made


def common_attributes(title: str) -> dict[str, str]:
    """Attributes of every dataset: its title, source, conventions."""
    return {"title": title, "source": f"asperity {__version__}", "Conventions": "CF-1.11"}


def number_or_null(value: Any) -> float | None:
    """A number for a JSON document; None for nan and infinities, which JSON does not know."""
    number = float(value)
    return number if np.isfinite(number) else None


def _is_netcdf(file: Path) -> bool:
    with require("h5py").File(file) as stored:
        source = stored.attrs["source"]
    return str(source.decode() if isinstance(source, bytes) else source).startswith("asperity ")


def _is_parquet(file: Path) -> bool:
    require("pyarrow")
    import pyarrow.parquet

    return _is_of_sweep(pyarrow.parquet.read_schema(file).names)


#: Columns of every table of points.
_STATUS = ["status", "status_meaning"]


def _is_of_sweep(columns: list[str]) -> bool:
    """Whether columns are numbers of a joint file, the status, and results, the numbers all with a unit."""
    place = columns.index(_STATUS[0])
    axes, results = columns[:place], columns[place + len(_STATUS) :]
    if not axes or columns[place : place + len(_STATUS)] != _STATUS:
        return False
    for path in map(_named, axes):
        key_at(path)  # raises if there is none
    return all(
        name in RESULTS or any(name.startswith(f"{known}_") for known in RESULTS)
        for name in map(_named, results)
    )


def _named(column: str) -> str:
    """The name in front of the unit of a column; empty if there is no unit."""
    name, bracket, unit = column.partition(" [")
    return name if bracket and unit.endswith("]") else ""


#: Ending → tables of sweeps.
SWEEP_TABLES = {
    ".csv": table_where("the table of a sweep", _is_of_sweep),
    ".parquet": Kind("the table of a sweep", _is_parquet),
    ".nc": Kind("the dataset of a sweep", _is_netcdf),
}


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
    columns: Document = {}
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
    return pd.DataFrame(columns)


def _header(name: str, variable: xarray.DataArray) -> str:
    return f"{name} [{variable.attrs.get('units', '1')}]"


def write_table(dataset: xarray.Dataset, path: str | Path) -> None:
    """Write a dataset to one file, completely or not at all."""
    file = Path(path)
    with replacing(file, kind=SWEEP_TABLES.get(file.suffix)) as part:
        if file.suffix == ".nc":
            part.write_bytes(dataset.to_netcdf(engine="h5netcdf"))  # on a full disk HDF5 ends the process
        elif file.suffix == ".parquet":
            frame(dataset).to_parquet(part, engine="pyarrow", index=False)
        else:
            frame(dataset).to_csv(part, index=False)
