"""The free chart: any number of the joint file against any result, evaluated by the batch evaluator of the studies."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from asperity.errors import InputError
from asperity.joint.status import STATUS_MEANINGS
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.quantity_key import Key
from asperity.joint_file.si_tables import AnyCase, key_at, si_values, varied_keys
from asperity.page.joint_request import JointRequest, asked_joint
from asperity.page.requests import MOST_POINTS, AskedChart, ChartRequest, checked
from asperity.results import Result, known_result, row_name
from asperity.study.batch import evaluate_points
from asperity.study.parameters import Axis, ListedAxis, check_axes
from asperity.types import Document
from asperity.units import format_quantity, from_si, parse_quantity

#: Points of one call of the compiled program, which therefore serves charts of any number of points.
BLOCK = 64

#: Units of the page where they are not those of the tables: as on its cards.
_SHOWN_UNITS = {"N*m/rad": "N*m/arcmin", "rad": "arcmin"}


class JointChart(NamedTuple):
    """The chart that is wanted of a joint."""

    joint: JointRequest
    chart: AskedChart


def result_rows(table: Mapping[str, Result]) -> dict[str, tuple[Result, int]]:
    """Every number that a chart can show."""
    return {
        row_name(name, row): (result, index)
        for name, result in table.items()
        if not result.categories
        for index, row in enumerate(result.row_names)
    }


def chart_results(joint: JointRequest) -> list[Document]:
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


def chart_request(body: object) -> JointChart:
    """The chart that the JSON body of a request asks for; an ``InputError`` where the body is none of its model."""
    request = checked(ChartRequest, body)
    return JointChart(asked_joint(request), request.chart)


def chart_answer(request: JointChart) -> Document:
    """The curves of a chart."""
    asked, family = request.chart, request.chart.family
    case = request.joint.solved_case()
    kind = case.type
    values = si_values(case)
    rows = result_rows(results_of(values))
    result, row = rows[known_result(asked.result, among=tuple(rows))]
    stated = varied_keys(case)
    key = key_at(asked.over, kind)
    family_key = key_at(family.over, kind) if family else None
    x = _axis_values(asked, case, key)
    curves = (
        [_quantity(text, family_key, family.over, "value") for text in family.values]
        if family and family_key
        else []
    )
    axes = [ListedAxis(asked.over, x.tolist())]
    if family:
        axes.append(ListedAxis(family.over, curves))
    check_axes(case, axes)
    absent = [axis.path for axis in axes if axis.path not in stated]
    if absent:
        raise InputError(
            f"{absent[0]}: the joint file does not state this number; give it a value before it is varied"
        )

    here = stated[asked.over].value
    columns = {asked.over: np.tile([*x, here], max(len(curves), 1))}
    if family:
        columns[family.over] = np.repeat(curves, x.size + 1)
    status, result_values = evaluate_points(values, columns, (result.name,), batch=BLOCK)
    y = np.atleast_2d(result_values[result.name])[row].reshape(-1, x.size + 1)
    status = status.reshape(-1, x.size + 1)
    used = sorted(set(status.reshape(-1).tolist()) - {0})
    return {
        "over": asked.over,
        "unit": key.unit,
        "result": asked.result,
        "result_label": _label(result, row),
        "result_unit": _unit(result),
        "family": family.over if family else None,
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
        if family
        else {
            "x": here,
            "x_shown": _shown(np.array([here]), key.unit)[0],
            "y": _shown(y[0, -1:], "")[0],
            "y_shown": _shown(y[0, -1:], _unit(result))[0],
            "status": int(status[0, -1]),
        },
        "reasons": {str(code): STATUS_MEANINGS[code] for code in used},
    }


def _axis_values(asked: AskedChart, case: AnyCase, key: Key) -> np.ndarray:
    start, stop = (
        _quantity(text, key, asked.over, what) for text, what in ((asked.start, "start"), (asked.stop, "end"))
    )
    if key.integer:
        low, high = sorted((start, stop))
        values = np.arange(np.ceil(low), np.floor(high) + 1.0)
        if not 1 <= values.size <= MOST_POINTS:
            raise InputError(
                f"{asked.over}: 1 to {MOST_POINTS} whole numbers are allowed, from {low:g} to {high:g} there are "
                f"{values.size}"
            )
        return values
    axis = Axis(asked.over, start, stop, asked.points, "log" if asked.scale == "log" else "linear")
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
