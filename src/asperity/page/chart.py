"""The free chart: any number of the joint file against any result, evaluated by the batch evaluator of the studies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from asperity.errors import InputError, quoted
from asperity.joint.status import STATUS_MEANINGS
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.quantity_key import Key
from asperity.joint_file.si_tables import AnyCase, key_at, si_values, varied_keys
from asperity.page.joint_request import JointRequest, joint_request
from asperity.results import Result, known_result, row_name
from asperity.study.batch import evaluate_points
from asperity.study.parameters import Axis, ListedAxis, check_axes
from asperity.units import format_quantity, from_si, parse_quantity

MOST_POINTS = 201
MOST_CURVES = 5
#: Points of one call of the compiled program, which therefore serves charts of any number of points.
BLOCK = 64

#: Units of the page where they are not those of the tables: as on its cards.
_SHOWN_UNITS = {"N*m/rad": "N*m/arcmin", "rad": "arcmin"}
_ENTRIES = ("over", "from", "to", "points", "scale", "result", "family")


@dataclass(frozen=True)
class ChartRequest:
    """One chart of a joint.

    Curves of ``points`` ``over`` a number of the file, by its dotted path, between two texts with units. ``scale``:
    even steps of the number, "linear", or of its logarithm, "log". ``result``: one result, with its row:
    ``slip_ratio_sp``. ``family``: dotted path of the number that differs from curve to curve, with its values as text;
    empty for a single curve.
    """

    joint: JointRequest
    over: str
    start: str
    stop: str
    points: int
    scale: str
    result: str
    family: str = ""
    values: tuple[str, ...] = ()


def result_rows(table: Mapping[str, Result]) -> dict[str, tuple[Result, int]]:
    """Every number that a chart can show."""
    return {
        row_name(name, row): (result, index)
        for name, result in table.items()
        if not result.categories
        for index, row in enumerate(result.row_names)
    }


def chart_results(joint: JointRequest) -> list[dict[str, Any]]:
    """What charts of a joint can show, for the lists of the page."""
    return [
        {
            "name": name,
            "label": _label(result, index),
            "unit": _unit(result),
            "group": result.group,
            # of a design: goals and limits are about all rows of a result
            "design": {"name": result.name, "label": result.said} if result.differentiable else None,
        }
        for name, (result, index) in result_rows(results_of(si_values(joint.case()))).items()
    ]


def _label(result: Result, index: int) -> str:
    row = result.row_names[index].replace("_", " ")
    return f"{result.said}, {row}" if row else result.said


def _unit(result: Result) -> str:
    return _SHOWN_UNITS.get(result.display_unit, result.display_unit)


def chart_request(body: Any) -> ChartRequest:
    """Check the JSON body of a request."""
    if not isinstance(body, dict) or not isinstance(body.get("chart"), dict):
        raise InputError("the body must be a JSON object with a joint and an object 'chart'")
    joint = joint_request({name: value for name, value in body.items() if name != "chart"})
    chart = body["chart"]
    unknown = sorted(set(chart) - set(_ENTRIES))
    if unknown:
        raise InputError(f"chart: unknown entry {quoted(unknown[0])}; known are {', '.join(_ENTRIES)}")
    texts = {name: _text(chart.get(name), f"chart.{name}") for name in ("over", "from", "to", "result")}
    points, scale = chart.get("points", 41), chart.get("scale", "linear")
    if isinstance(points, bool) or not isinstance(points, int) or not 2 <= points <= MOST_POINTS:
        raise InputError(
            f"chart.points: a whole number from 2 to {MOST_POINTS} is needed, got {quoted(points)}"
        )
    if scale not in ("linear", "log"):
        raise InputError(f"chart.scale: 'linear' or 'log' is needed, got {quoted(scale)}")
    family, values = _family(chart.get("family"))
    return ChartRequest(
        joint, texts["over"], texts["from"], texts["to"], points, scale, texts["result"], family, values
    )


def _text(value: Any, name: str) -> str:
    if not isinstance(value, str) or not 0 < len(value) <= 200:
        raise InputError(f"{name}: a text of at most 200 characters is needed, got {quoted(value)}")
    return value


def _family(entry: Any) -> tuple[str, tuple[str, ...]]:
    if entry is None:
        return "", ()
    if (
        not isinstance(entry, dict)
        or set(entry) != {"over", "values"}
        or not isinstance(entry["values"], list)
    ):
        raise InputError("chart.family: an object with 'over' and a list 'values' is needed")
    if not 1 <= len(entry["values"]) <= MOST_CURVES:
        raise InputError(f"chart.family: 1 to {MOST_CURVES} values are allowed, got {len(entry['values'])}")
    return _text(entry["over"], "chart.family.over"), tuple(
        _text(value, "chart.family.values") for value in entry["values"]
    )


def chart_answer(request: ChartRequest) -> dict[str, Any]:
    """The curves of a chart."""
    case = request.joint.solved_case()
    kind = case.type
    values = si_values(case)
    rows = result_rows(results_of(values))
    result, row = rows[known_result(request.result, among=tuple(rows))]
    stated = varied_keys(case)
    key = key_at(request.over, kind)
    family_key = key_at(request.family, kind) if request.family else None
    x = _axis_values(request, case, key)
    curves = (
        [_quantity(text, family_key, request.family, "value") for text in request.values]
        if family_key
        else []
    )
    axes = [ListedAxis(request.over, x.tolist())]
    if request.family:
        axes.append(ListedAxis(request.family, curves))
    check_axes(case, axes)
    absent = [axis.path for axis in axes if axis.path not in stated]
    if absent:
        raise InputError(
            f"{absent[0]}: the joint file does not state this number; give it a value before it is varied"
        )

    here = stated[request.over].value
    columns = {request.over: np.tile([*x, here], max(len(curves), 1))}
    if request.family:
        columns[request.family] = np.repeat(curves, x.size + 1)
    status, result_values = evaluate_points(values, columns, (result.name,), batch=BLOCK)
    y = np.atleast_2d(result_values[result.name])[row].reshape(-1, x.size + 1)
    status = status.reshape(-1, x.size + 1)
    used = sorted(set(status.reshape(-1).tolist()) - {0})
    return {
        "over": request.over,
        "unit": key.unit,
        "result": request.result,
        "result_label": _label(result, row),
        "result_unit": _unit(result),
        "family": request.family or None,
        "x": x.tolist(),
        "x_shown": _shown(x, key.unit),
        "curves": [
            {
                "value": curves[index] if family_key else None,
                "value_shown": format_quantity(curves[index], family_key.unit, 6) if family_key else "",
                "y": _shown(y[index, :-1], ""),
                "y_shown": _shown(y[index, :-1], _unit(result)),
                "status": status[index, :-1].tolist(),
            }
            for index in range(len(y))
        ],
        "joint": None
        if request.family
        else {
            "x": here,
            "x_shown": _shown(np.array([here]), key.unit)[0],
            "y": _shown(y[0, -1:], "")[0],
            "y_shown": _shown(y[0, -1:], _unit(result))[0],
            "status": int(status[0, -1]),
        },
        "reasons": {str(code): STATUS_MEANINGS[code] for code in used},
    }


def _axis_values(request: ChartRequest, case: AnyCase, key: Key) -> np.ndarray:
    start, stop = (
        _quantity(text, key, request.over, what)
        for text, what in ((request.start, "start"), (request.stop, "end"))
    )
    if key.integer:
        low, high = sorted((start, stop))
        values = np.arange(np.ceil(low), np.floor(high) + 1.0)
        if not 1 <= values.size <= MOST_POINTS:
            raise InputError(
                f"{request.over}: 1 to {MOST_POINTS} whole numbers are allowed, from {low:g} to {high:g} there are "
                f"{values.size}"
            )
        return values
    axis = Axis(request.over, start, stop, request.points, "log" if request.scale == "log" else "linear")
    check_axes(case, [axis])
    return axis.values


def _quantity(text: str, key: Key, path: str, what: str) -> float:
    try:
        return parse_quantity(text, key.dimension, example=key.example or None)
    except InputError as error:
        raise InputError(f"{path}: the {what} of the chart: {error}") from None


def _shown(values: np.ndarray, unit: str) -> list[float | None]:
    """As a list for JSON, in a unit if one is given."""
    return [
        (float(f"{from_si(value, unit):.12g}") if unit else value) if np.isfinite(value) else None
        for value in np.asarray(values, dtype=float).tolist()
    ]
