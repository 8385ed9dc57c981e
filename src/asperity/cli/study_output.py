"""What the commands for studies print."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click
import numpy as np

if TYPE_CHECKING:
    import xarray

_MOST_ROWS = 60
_SHOWN = (
    "assembly_stiffness_output",
    "series_with_bulk_stiffness_output",
    "published_stiffness_output",
    "torque_capacity",
)
_MOST_COLUMNS = 4


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


def show_status(found: xarray.Dataset) -> None:
    """Say how many points have a result, and why others have none.

    Parameters
    ----------
    found : xarray.Dataset
        Evaluated points.
    """
    from asperity.joint.status import STATUS_MEANINGS

    counts = status_counts(found)
    total = sum(counts.values())
    click.echo(f"{total} points, {counts.get(0, 0)} solved")
    for code, count in sorted(counts.items()):
        if code != 0:
            click.echo(f"  {count} without a result: {STATUS_MEANINGS[code] if code > 0 else 'not computed'}")


def status_counts(found: xarray.Dataset) -> dict[int, int]:
    """How many points have each status.

    Parameters
    ----------
    found : xarray.Dataset
        Evaluated points; a lazy one is read chunk by chunk.

    Returns
    -------
    dict
        Code → number of points.
    """
    data = found["status"].data
    if hasattr(data, "to_delayed"):  # chunks of a store: never all at once
        parts = [part.compute(scheduler="synchronous") for part in data.to_delayed().ravel()]
    else:
        parts = [data]
    counts: dict[int, int] = {}
    for part in parts:
        codes, numbers = np.unique(np.asarray(part), return_counts=True)
        for code, number in zip(codes.tolist(), numbers.tolist(), strict=True):
            counts[code] = counts.get(code, 0) + number
    return counts


def show_points(found: xarray.Dataset) -> None:
    """Print the points of a small sweep: coordinates, main results, status.

    Parameters
    ----------
    found : xarray.Dataset
        Evaluated points.
    """
    from asperity.cli.terminal import console, table
    from asperity.joint.results import RESULTS
    from asperity.joint.status import STATUS_NAMES
    from asperity.joint_file.values import key_at
    from asperity.study.parameters import long_name
    from asperity.units import from_si

    axes = [str(name) for name in found["status"].dims]
    scalars = [str(name) for name, value in found.data_vars.items() if "contact" not in value.dims]
    results = [name for name in _SHOWN if name in found] or scalars[1 : 1 + _MOST_COLUMNS]
    units = {path: key_at(path).unit for path in axes}
    target = console()
    headers = [f"{long_name(path)}{_unit(units[path])}" for path in axes]
    headers += [f"{name.replace('_', ' ')}{_unit(RESULTS[name].si_unit)}" for name in results]
    shown = table(target, "", *headers, "status")
    for column in shown.columns:
        column.no_wrap, column.justify = False, "right"
    points = np.ndindex(found["status"].shape)
    for _, place in zip(range(_MOST_ROWS), points, strict=False):
        at = dict(zip(axes, place, strict=True))
        coordinates = [f"{from_si(float(found[path][at[path]]), units[path]):.6g}" for path in axes]
        code = int(found["status"][place])
        values = [_number(float(found[name].isel(at))) for name in results]
        shown.add_row(*coordinates, *values, STATUS_NAMES[code].replace("_", " ") if code else "")
    target.print(shown)
    more = found["status"].size - _MOST_ROWS
    if more > 0:
        click.echo(f"and {more} more points; --out writes them all")
    elif len(found.data_vars) > len(results) + 1:
        click.echo(f"{len(found.data_vars) - 1} results at each point; --out writes them all")


def _unit(unit: str) -> str:
    return "" if unit == "1" else f" [{unit.replace('*', '·')}]"


def _number(value: float) -> str:
    return "-" if np.isnan(value) else f"{value:.5g}"
