"""Results of studies as xarray datasets: dimensions, coordinates, units and long names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity import __version__
from asperity.extras import optional_module
from asperity.joint.status import flag_attributes
from asperity.joint_file.si_tables import key_at
from asperity.results import Result, row_name
from asperity.study.parameters import SweepAxis, long_name

if TYPE_CHECKING:
    import xarray


def require(module: str) -> Any:
    """Import a module of the extra ``study``.

    Parameters
    ----------
    module : str
        Its name.

    Returns
    -------
    module
        Imported.

    Raises
    ------
    MissingExtraError
        If it is not installed.
    """
    return optional_module(module, extra="study", needs="studies need")


def coordinate(axis: SweepAxis) -> tuple[tuple[str], np.ndarray, dict[str, str]]:
    """One axis as a coordinate.

    Parameters
    ----------
    axis : Axis or ListedAxis
        The axis.

    Returns
    -------
    tuple
        Dimensions, values, attributes.
    """
    return (axis.path,), axis.values, key_attributes(axis.path)


def key_attributes(path: str) -> dict[str, str]:
    """Attributes of a number of the joint file."""
    return {"units": key_at(path).dimension.si_unit, "long_name": long_name(path)}


def result_attributes(result: Result) -> dict[str, str]:
    """Attributes of a result.

    Parameters
    ----------
    result : Result
        A row of the table of results.

    Returns
    -------
    dict
        ``units`` and ``long_name``; ``categories`` where its values number them; ``comment`` where not every joint has
        all of its rows.
    """
    attributes = {"units": result.si_unit, "long_name": result.label}
    if result.present is not None and result.note:
        attributes["comment"] = result.note
    return attributes | ({"categories": " ".join(result.categories)} if result.categories else {})


def result_rows(results: Iterable[Result]) -> list[tuple[str, str, str]]:
    """Every number that some results have: one, or one for each contact or clearance.

    Parameters
    ----------
    results : iterable of Result
        Rows of the table of results.

    Returns
    -------
    list of tuple
        Name such as ``slip_ratio_sp``, SI unit and label of each number.
    """
    return [
        (row_name(result.name, row), result.si_unit, f"{result.label}, {row}".removesuffix(", "))
        for result in results
        for row in result.row_names
    ]


def result_words(data: xarray.Dataset, name: str) -> str:
    """What a result is called for the drive whose points a dataset has.

    Parameters
    ----------
    data : xarray.Dataset
        Evaluated points.
    name : str
        One of its variables.

    Returns
    -------
    str
        Its label.
    """
    return str(data[name].attrs["long_name"])


#: Dimensions that are not called after what their rows stand for: a result has that name.
_DIMENSIONS = {"clearance": "rollers"}
_ROW_COORDINATES = {
    "contact": "contact of a branch",
    "rollers": "rollers between which a clearance is",
    "body": "body of a branch; those on the axis are shared by all branches",
    "pin": "carrier pin, named after its loading roller",
    "bearing": "rolling bearing",
    "rim": "rim of a ring or of a hollow roller",
}


def row_dimensions(result: Result) -> tuple[str, ...]:
    """Dimensions in front of those of the points: none, or what its rows stand for.

    Parameters
    ----------
    result : Result
        A row of the table of results.

    Returns
    -------
    tuple of str
        At most one name.
    """
    return () if result.axis == "one" else (_DIMENSIONS.get(result.axis, result.axis),)


def row_coordinates(results: Iterable[Result]) -> dict[str, tuple[tuple[str], np.ndarray, dict[str, str]]]:
    """Coordinates of the contacts and clearances, where results have one number for each."""
    needed = {dimension: result.row_names for result in results for dimension in row_dimensions(result)}
    return {
        each: ((each,), np.array(names, dtype="U"), {"long_name": _ROW_COORDINATES[each]})
        for each, names in needed.items()
    }


def rows_of(data: xarray.Dataset, name: str) -> dict[str, xarray.DataArray]:
    """A variable cut into its rows: one for each contact or clearance, or the variable itself.

    Parameters
    ----------
    data : xarray.Dataset
        Evaluated points.
    name : str
        One of its variables.

    Returns
    -------
    dict
        Name of the row, empty for a single number → values at the points.
    """
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
    found: Mapping[str, np.ndarray],
    table: Mapping[str, Result],
    attributes: Mapping[str, Any],
) -> xarray.Dataset:
    """A dataset of evaluated points."""
    xr = require("xarray")
    variables: dict[str, Any] = {"status": (dimensions, status, flag_attributes())}
    for name, value in found.items():
        variables[name] = ((*row_dimensions(table[name]), *dimensions), value, result_attributes(table[name]))
    coords = {**coordinates, **row_coordinates(table[name] for name in found)}
    made: xarray.Dataset = xr.Dataset(variables, coords=coords, attrs=dict(attributes))
    return made


def common_attributes(title: str) -> dict[str, str]:
    """Attributes of every dataset.

    Parameters
    ----------
    title : str
        What it is.

    Returns
    -------
    dict
        Title, source, conventions.
    """
    return {"title": title, "source": f"asperity {__version__}", "Conventions": "CF-1.11"}


def number_or_null(value: Any) -> float | None:
    """A number for a JSON document; None for nan and infinities, which JSON does not know.

    Parameters
    ----------
    value : float or array
        One number.

    Returns
    -------
    float or None
        The number.
    """
    number = float(value)
    return number if np.isfinite(number) else None
