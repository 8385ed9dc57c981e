"""What the commands for studies print."""

from __future__ import annotations

import itertools
from typing import TYPE_CHECKING

import click
import numpy as np

from asperity.cli.terminal import show_blocks
from asperity.joint.pin_bound import RIGID_PINS
from asperity.joint.status import STATUS_MEANINGS, STATUS_NAMES
from asperity.joint_file.si_tables import key_at
from asperity.results import RESULTS, row_name
from asperity.study.datasets import rows_of
from asperity.study.parameters import long_name
from asperity.units import from_si
from asperity.views.blocks import Table
from asperity.views.numbers import number, unit_words

if TYPE_CHECKING:
    import xarray

    from asperity.results import Result

_MOST_ROWS = 60
_SHOWN = (
    "assembly_stiffness_output",
    "series_with_bulk_stiffness_output",
    "published_stiffness_output",
    "torque_capacity",
    "standing_torque_capacity",
)
_MOST_COLUMNS = 24
_MOST_NAMES = 8


def show_status(dataset: xarray.Dataset) -> None:
    """Say how many points have a result, and why others have none."""
    counts = status_counts(dataset)
    total = sum(counts.values())
    click.echo(f"{total} point{'s' * (total != 1)}, {counts.get(0, 0)} solved")
    for code, count in sorted(counts.items()):
        if code != 0:
            click.echo(f"  {count} not solved: {STATUS_MEANINGS[code] if code > 0 else 'not computed'}")
    if "rolling_slip_ratio" in dataset:
        slipping = _points_beyond(dataset["rolling_slip_ratio"], 1.0)
        if slipping:
            click.echo(
                f"  {slipping} solved standing, but a contact slips as a whole in rolling: skew takes its friction"
            )


def _points_beyond(values: xarray.DataArray, limit: float) -> int:
    """How many points have a value of at least the limit at one of their contacts."""
    rows = [name for name in values.dims if name == "contact"]
    return int((values >= limit).any(rows).sum())


def status_counts(dataset: xarray.Dataset) -> dict[int, int]:
    """How many points have each status."""
    data = dataset["status"].data
    if hasattr(data, "to_delayed"):  # chunks of a store: never all at once
        parts = [part.compute(scheduler="synchronous") for part in data.to_delayed().ravel()]
    else:
        parts = [data]
    counts: dict[int, int] = {}
    for part in parts:
        codes, numbers = np.unique(np.asarray(part), return_counts=True)
        for code, count in zip(codes.tolist(), numbers.tolist(), strict=True):
            counts[code] = counts.get(code, 0) + count
    return counts


def show_points(dataset: xarray.Dataset, asked_units: dict[str, str]) -> None:
    """Print the points of a small sweep: coordinates, results (main ones, if many), status where one is unsolved.

    ``asked_units`` of axes and results by their names; the others have those of every table.
    """
    axes = [str(name) for name in dataset["status"].dims]
    asked = [str(name) for name in dataset.data_vars if name != "status"]
    of_result = {name: rows_of(dataset, name) for name in asked}
    chosen = asked
    if sum(map(len, of_result.values())) > _MOST_COLUMNS:
        chosen = [name for name in _SHOWN if name in dataset] or asked[:1]
    units = {path: key_at(path).unit for path in axes}
    units |= {name: RESULTS[name].display_unit for name in asked} | asked_units
    places = list(itertools.islice(np.ndindex(dataset["status"].shape), _MOST_ROWS))
    at = [dict(zip(axes, place, strict=True)) for place in places]
    absent = {
        (name, row)
        for name in chosen
        for row, values in of_result[name].items()
        if RESULTS[name].present is not None and all(np.isnan(float(values.isel(point))) for point in at)
    }
    columns = [
        (name, row, values)
        for name in chosen
        for row, values in of_result[name].items()
        if (name, row) not in absent
    ][:_MOST_COLUMNS]
    coordinates = {
        f"{long_name(path)}{_unit(units[path])}": [
            number(from_si(float(dataset[path][point[path]]), units[path]), digits=6) for point in at
        ]
        for path in axes
    }
    cells = {
        f"{row_name(name, row).replace('_', ' ')}{_unit(units[name])}": [
            _cell(values.isel(point), RESULTS[name], units[name]) for point in at
        ]
        for name, row, values in columns
    }
    codes = [int(dataset["status"][place]) for place in places]
    if any(codes):
        cells["status"] = [STATUS_NAMES[code].replace("_", " ") if code else "" for code in codes]
    shown = coordinates | cells
    in_words = (*range(len(coordinates)), *([len(shown) - 1] if any(codes) else []))
    show_blocks(Table("", tuple(shown), list(zip(*shown.values(), strict=True)), words=in_words))
    more = dataset["status"].size - _MOST_ROWS
    if more > 0:
        click.echo(f"and {more} more point{'s' * (more != 1)}; --out writes them all")
    for name in chosen:
        rows = [row.replace("_", " ") for row in of_result[name] if (name, row) in absent]
        if rows:
            note = f": {RESULTS[name].note}" if RESULTS[name].note else ""
            click.echo(f"no value of {name}{' of ' if rows[0] else ''}{', '.join(rows)}{note}")
    show_bounds({name: str(dataset[name].attrs.get("long_name", "")) for name in chosen})
    shown_results = {name for name, *_ in columns} | {name for name, _ in absent}
    left_out = [name for name in asked if name not in shown_results]
    if left_out:
        names = (
            ", ".join(left_out)
            if len(left_out) <= _MOST_NAMES
            else f"{len(left_out)} of {len(asked)} results"
        )
        click.echo(f"not shown: {names}; --out writes them all, --results chooses some")


def show_bounds(said: dict[str, str]) -> None:
    """Say which results, by name, are bounds and no values, as far as what is said of them tells."""
    names = [name for name, words in said.items() if RIGID_PINS in words]
    if names:
        click.echo(f"{RIGID_PINS}: {', '.join(names)}")


def _unit(unit: str) -> str:
    """A unit behind the head of a column."""
    return "" if unit == "1" else f" [{unit_words(unit)}]"


def _cell(one: xarray.DataArray, result: Result, unit: str) -> str:
    """A value in the unit of the column; a category by its name."""
    value = float(one)
    if result.categories and not np.isnan(value):
        return str(one.attrs["categories"]).split(" ")[int(value)]
    return number(from_si(value, unit), digits=5)
