r"""Exact sensitivities of a joint to every number of its file, by automatic differentiation.

.. math:: \text{derivative} = \frac{\partial y}{\partial x}, \qquad
    \text{elasticity} = \frac{\partial y}{\partial x}\,\frac{x}{y}

An elasticity of 2 says that one per cent more of x makes about two per cent more of y.

A radius stands in two rows where the preload is made by interference. Its own is that of the number in the file, as in
:mod:`asperity.study.sweep.sweep`: of another drive with the same interference, in which the bore of a ring that follows
from the rollers follows them. The other is that of a finished part, :data:`FINISHED_PART`, which deviates while all
other parts stay as they are, as tolerances do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.joint.solve import refuse_impossible_joint, solve_joint
from asperity.joint.status import ALL_PLASTIC, STATUS_MEANINGS, UNBALANCED
from asperity.joint_file.any_joint import results_of, sizes_of_parts, with_nominal_sizes
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.si_tables import AnyCase, NumericKey, si_values, varied_keys
from asperity.precision import require_double_precision
from asperity.results import LEVELS, Result, known_result, row_name
from asperity.results.document import stiffness_unknown_because
from asperity.study.batch import derivatives_at, fixed_count
from asperity.study.datasets import common_attributes, require, result_rows
from asperity.study.parameters import long_name

if TYPE_CHECKING:
    import xarray

#: Results that are differentiated unless others are asked for, where the drive has them.
DEFAULT_RESULTS = (
    *(f"{level}_stiffness_output" for level in LEVELS),
    "standing_torque_capacity",
    "slip_ratio",
    "pressure_over_first_yield",
    "self_locking_ratio",
)


#: Behind the path of a radius in the names of inputs: a finished part, whose deviation adds to the interference.
FINISHED_PART = " (finished part)"


def path_of_input(name: str) -> str:
    """Dotted path of the number of the file that an input of :func:`sensitivity` is, or is the finished part of."""
    return name.removesuffix(FINISHED_PART)


def differentiable_rows(table: Mapping[str, Result]) -> dict[str, str]:
    """Everything that can be differentiated."""
    return {
        row_name(name, row): name
        for name, result in table.items()
        if result.differentiable
        for row in result.row_names
    }


def sensitivity(case: AnyCase, results: Sequence[str] | None = None) -> xarray.Dataset:
    """Derivatives and elasticities of results with respect to every number of a joint file.

    Parameters
    ----------
    case : Case
        The joint file.
    results : sequence of str, optional
        Names of results of the drive, :func:`asperity.joint_file.any_joint.results_of`; by default
        those of :data:`DEFAULT_RESULTS` that the drive has.

    Returns
    -------
    xarray.Dataset
        Dimensions ``result`` and ``input``; variables ``derivative`` (SI unit of the result per SI unit of the input,
        as the coordinates ``result_unit`` and ``input_unit`` say), ``elasticity``, ``value`` of the inputs,
        ``result_value``. The inputs are the numbers of the file, then the sizes of finished parts, their paths with
        :data:`FINISHED_PART` behind. An elasticity is nan where the result is 0, and the derivatives of an infinite
        capacity are nan.

    Raises
    ------
    InputError
        If a result has no derivatives, the rollers do not fit or the torque is beyond the capacity.
    NoSolutionError
        If the force balance does not close, or a result is a stiffness and every spot of a contact is plastic.
    PrecisionError
        If JAX is in single precision.

    Notes
    -----
    One entry for all contacts is one input: all five move together; so do the parts of one size. The number of planets
    is differentiated as if it were continuous, unless :func:`asperity.study.batch.fixed_count` has it. Where a result
    has a kink (no torque; two longest contact lines on one roller) the derivative is that of one side or their mean.
    """
    require_double_precision()
    require("xarray")
    tables = si_values(case)
    table = results_of(tables)
    allowed = [name for name, result in table.items() if result.differentiable]
    asked = [name for name in DEFAULT_RESULTS if name in table] if results is None else results
    names = tuple(known_result(name, among=allowed, what="differentiable result") for name in asked)
    keys = varied_keys(case)
    keys.pop(fixed_count(tables, names) or "", None)
    point = {path: np.array([entry.value]) for path, entry in keys.items()}
    refuse_impossible_joint(with_own_branches(case))
    sizes = sizes_of_parts(tables, keys)
    status, values, slopes = derivatives_at(
        with_nominal_sizes(tables), point, names, tuple(keys), nominal=sizes
    )
    y = np.concatenate([values[name][:, 0] for name in names])
    if status[0] != ALL_PLASTIC or np.isnan(y).any():
        refuse_failed(case, int(status[0]))
    inputs = keys | {f"{path}{FINISHED_PART}": keys[path] for path in sizes}
    jacobian = np.concatenate([slopes[name][:, 0] for name in names])
    # the numbers of the file first; the slopes of sizes alone are those of finished parts
    places, paths = np.arange(len(keys)), list(keys)
    parts = [paths.index(path) for path in sizes]
    places[parts] = len(keys) + np.arange(len(sizes))
    jacobian = jacobian[:, [*places, *parts]]
    return _dataset(result_rows(table[name] for name in names), y, inputs, jacobian)


def _dataset(
    rows: Sequence[tuple[str, str, str]],
    y: np.ndarray,
    inputs: Mapping[str, NumericKey],
    jacobian: np.ndarray,
) -> xarray.Dataset:
    """Derivatives and elasticities of results, of which ``y`` are the values and ``rows`` name, unit and label."""
    xr = require("xarray")
    x = np.array([entry.value for entry in inputs.values()])
    finite = np.isfinite(y)[:, None]
    derivative = np.where(finite, jacobian, np.nan)
    nonzero = np.where(y == 0.0, np.nan, y)[:, None]
    elasticity = np.where(finite, derivative * x / nonzero, np.nan)
    pair = ("result", "input")
    return xr.Dataset(
        {
            "derivative": (pair, derivative, {"long_name": "derivative", "units": "result_unit/input_unit"}),
            "elasticity": (
                pair,
                elasticity,
                {"long_name": "relative change of the result per relative change of the input", "units": "1"},
            ),
            "value": (("input",), x, {"long_name": "value of the input", "units": "input_unit"}),
            "result_value": (("result",), y, {"long_name": "value of the result", "units": "result_unit"}),
        },
        coords={
            "result": [name for name, _, _ in rows],
            "input": list(inputs),
            "result_unit": ("result", [unit for _, unit, _ in rows]),
            "input_unit": ("input", [entry.key.dimension.si_unit for entry in inputs.values()]),
            "result_name": ("result", [label for _, _, label in rows]),
            "input_name": ("input", [_named(name) for name in inputs]),
        },
        attrs=common_attributes("sensitivities of a joint"),
    )


def _named(name: str) -> str:
    """An input in words."""
    return f"{long_name(path_of_input(name))}{FINISHED_PART if name.endswith(FINISHED_PART) else ''}"


def refuse_failed(case: AnyCase, status: int) -> None:
    """Raise if a joint itself has no result, with all the numbers."""
    if status == 0:
        return
    result = solve_joint(with_own_branches(case)).result  # says it with the numbers
    reason = stiffness_unknown_because(result) or STATUS_MEANINGS[status]
    if status in (UNBALANCED, ALL_PLASTIC):
        raise NoSolutionError(reason)
    raise InputError(reason)


def ranking(sensitivities: xarray.Dataset, result: str) -> xarray.Dataset:
    """The inputs in the order of their influence on one result, along ``input``, largest absolute elasticity first.

    An ``InputError`` if there is no such result.
    """
    known_result(result, among=sensitivities["result"].values.tolist())
    one = sensitivities.sel(result=result)
    order = np.argsort(-np.abs(np.nan_to_num(one["elasticity"].values, nan=0.0)), kind="stable")
    return one.isel(input=order)
