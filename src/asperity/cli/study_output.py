"""What the commands for studies print."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click
import numpy as np

if TYPE_CHECKING:
    import xarray

    from asperity.joint.results import Result

_MOST_ROWS = 60
_SHOWN = (
    "assembly_stiffness_output",
    "series_with_bulk_stiffness_output",
    "published_stiffness_output",
    "torque_capacity",
)
_MOST_COLUMNS = 10


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
    click.echo(f"{total} point{'s' * (total != 1)}, {counts.get(0, 0)} solved")
    for code, count in sorted(counts.items()):
        if code != 0:
            click.echo(f"  {count} not solved: {STATUS_MEANINGS[code] if code > 0 else 'not computed'}")


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
    """Print the points of a small sweep: coordinates, results (main ones, if there are many), status.

    Parameters
    ----------
    found : xarray.Dataset
        Evaluated points.
    """
    from asperity.cli.terminal import console, table
    from asperity.joint.results import RESULTS, row_name
    from asperity.joint.status import STATUS_NAMES
    from asperity.joint_file.si_tables import key_at
    from asperity.study.datasets import rows_of
    from asperity.study.parameters import long_name
    from asperity.units import from_si

    axes = [str(name) for name in found["status"].dims]
    asked = [str(name) for name in found.data_vars if name != "status"]
    chosen = asked if len(asked) <= _MOST_COLUMNS else [name for name in _SHOWN if name in found] or asked[:1]
    columns = [
        (row_name(name, row), RESULTS[name], values)
        for name in chosen
        for row, values in rows_of(found, name).items()
    ][:_MOST_COLUMNS]
    units = {path: key_at(path).unit for path in axes}
    target = console()
    headers = [f"{long_name(path)}{_unit(units[path])}" for path in axes]
    headers += [f"{name.replace('_', ' ')}{_unit(result.display_unit)}" for name, result, _ in columns]
    shown = table(target, "", *headers, "status")
    for column in shown.columns:
        column.no_wrap, column.justify = False, "right"
    points = np.ndindex(found["status"].shape)
    for _, place in zip(range(_MOST_ROWS), points, strict=False):
        at = dict(zip(axes, place, strict=True))
        coordinates = [f"{from_si(float(found[path][at[path]]), units[path]):.6g}" for path in axes]
        code = int(found["status"][place])
        values = [_cell(values.isel(at), result) for _, result, values in columns]
        shown.add_row(*coordinates, *values, STATUS_NAMES[code].replace("_", " ") if code else "")
    target.print(shown)
    more = found["status"].size - _MOST_ROWS
    if more > 0:
        click.echo(f"and {more} more point{'s' * (more != 1)}; --out writes them all")
    elif len(columns) < sum(len(rows_of(found, name)) for name in asked):
        click.echo(f"{len(asked)} results at each point; --out writes them all, --results chooses some")


def _unit(unit: str) -> str:
    return "" if unit == "1" else f" [{unit.replace('*', '·')}]"


def _cell(one: xarray.DataArray, result: Result) -> str:
    """A value in the unit of the column; a category by its name."""
    from asperity.units import from_si

    value = float(one)
    if np.isnan(value):
        return "-"
    if result.categories:
        return str(one.attrs["categories"]).split(" ")[int(value)]
    return f"{from_si(value, result.display_unit):.5g}"
