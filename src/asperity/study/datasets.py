"""Results of studies as xarray datasets: dimensions, coordinates, units and long names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity import __version__
from asperity.drive.geometry import CONTACT_NAMES
from asperity.errors import MissingExtraError
from asperity.joint.results import RESULTS
from asperity.joint.status import flag_attributes
from asperity.joint_file.values import key_at
from asperity.study.parameters import Axis, long_name

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
    import importlib

    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise MissingExtraError(
            f"studies need the package '{error.name or module}', which is not installed: pip install 'asperity[study]'"
        ) from None


def coordinate(axis: Axis) -> tuple[tuple[str], np.ndarray, dict[str, str]]:
    """One axis as a coordinate.

    Parameters
    ----------
    axis : Axis
        The axis.

    Returns
    -------
    tuple
        Dimensions, values, attributes.
    """
    return (axis.path,), axis.values, key_attributes(axis.path)


def key_attributes(path: str) -> dict[str, str]:
    """Attributes of a number of the joint file.

    Parameters
    ----------
    path : str
        Its dotted path.

    Returns
    -------
    dict
        ``units`` and ``long_name``.
    """
    return {"units": key_at(path).dimension.si_unit, "long_name": long_name(path)}


def result_attributes(name: str) -> dict[str, str]:
    """Attributes of a result.

    Parameters
    ----------
    name : str
        A name of :data:`asperity.joint.results.RESULTS`.

    Returns
    -------
    dict
        ``units`` and ``long_name``.
    """
    return {"units": RESULTS[name].unit, "long_name": RESULTS[name].description}


def contact_coordinate() -> tuple[tuple[str], np.ndarray, dict[str, str]]:
    """The contact axis as a coordinate.

    Returns
    -------
    tuple
        Dimensions, values, attributes.
    """
    names = np.array(CONTACT_NAMES, dtype="U3")
    return ("contact",), names, {"long_name": "contact of a branch: sun-planet, planet-rollers, rollers-ring"}


def dataset(
    *,
    dimensions: tuple[str, ...],
    coordinates: Mapping[str, Any],
    status: np.ndarray,
    found: Mapping[str, np.ndarray],
    attributes: Mapping[str, Any],
) -> xarray.Dataset:
    """A dataset of evaluated points.

    Parameters
    ----------
    dimensions : tuple of str
        Dimensions of the points.
    coordinates : mapping
        Name → (dimensions, values, attributes).
    status : ndarray
        Codes of the points.
    found : mapping
        Name of a result → values, with the contact axis first if there is one.
    attributes : mapping
        Attributes of the whole.

    Returns
    -------
    xarray.Dataset
        With ``status`` and one variable a result.
    """
    xr = require("xarray")
    variables: dict[str, Any] = {"status": (dimensions, status, flag_attributes())}
    for name, value in found.items():
        dims = ("contact", *dimensions) if RESULTS[name].per_contact else dimensions
        variables[name] = (dims, value, result_attributes(name))
    coords = dict(coordinates)
    if any(RESULTS[name].per_contact for name in found):
        coords["contact"] = contact_coordinate()
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
