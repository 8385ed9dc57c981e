r"""Exact sensitivities of a joint to every number of its file, by automatic differentiation.

.. math:: \text{derivative} = \frac{\partial y}{\partial x}, \qquad
    \text{elasticity} = \frac{\partial y}{\partial x}\,\frac{x}{y}

An elasticity of 2 says that one per cent more of x makes about two per cent more of y.
"""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.drive.geometry import CONTACT_NAMES
from asperity.errors import InputError, NoSolutionError
from asperity.joint.evaluation import Joint, evaluate
from asperity.joint.results import RESULTS, Solved
from asperity.joint.solve import solve
from asperity.joint.status import STATUS_MEANINGS, UNBALANCED, joint_status
from asperity.joint_file.build import joint_from_case, joint_from_values
from asperity.joint_file.model import Case
from asperity.joint_file.si_tables import NumericKey, numeric_keys, replace_values, si_values
from asperity.joint_file.table_numbers import table_structure
from asperity.precision import require_double_precision
from asperity.study.datasets import common_attributes, require
from asperity.study.parameters import long_name

if TYPE_CHECKING:
    import xarray

_LEVELS = ("assembly_stiffness_output", "series_with_bulk_stiffness_output", "published_stiffness_output")
_MARGINS: dict[str, tuple[str, str]] = {
    "slip_margin": ("gross_slip", "slip margin 1 - T/(mu N)"),
    "pressure_margin": ("pressure_over_first_yield", "pressure margin 1 - p0/(first yield)"),
    "self_locking_margin": ("self_locking", "self-locking margin 1 - tan(beta/2)/mu"),
}


def judged_results() -> dict[str, tuple[str, str]]:
    """Results whose sensitivities are taken.

    Returns
    -------
    dict
        Name → (unit, description): stiffness at the output on three levels, torque capacity, margins, which are
        positive where all is well.
    """
    found = {name: (RESULTS[name].unit, RESULTS[name].description) for name in (*_LEVELS, "torque_capacity")}
    for margin, (ratio, words) in _MARGINS.items():
        if RESULTS[ratio].per_contact:
            found.update({f"{margin}_{contact}": ("1", f"{words}, {contact}") for contact in CONTACT_NAMES})
        else:
            found[margin] = ("1", words)
    return found


def _judged(joint: Joint) -> tuple[Array, Array]:
    """Values of :func:`judged_results` of a batch, in their order, shape (results, batch), and the status."""
    result = evaluate(joint)
    solved = Solved(joint, result)
    rows = [RESULTS[name].value(solved) for name in (*_LEVELS, "torque_capacity")]
    for ratio, _ in _MARGINS.values():
        margin = 1.0 - RESULTS[ratio].value(solved)
        rows.extend(margin if RESULTS[ratio].per_contact else [margin])
    shape = result.solved.shape
    return jnp.stack([jnp.broadcast_to(row, shape) for row in rows]), joint_status(joint, result)


def sensitivity(case: Case) -> xarray.Dataset:
    """Derivatives and elasticities of stiffness, capacity and margins with respect to every number of a joint file.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    xarray.Dataset
        Dimensions ``result`` and ``input``; variables ``derivative`` (SI unit of the result per SI unit of the input,
        as the coordinates ``result_unit`` and ``input_unit`` say), ``elasticity``, ``value`` of the inputs,
        ``result_value``. An elasticity is nan where the result is 0, and the derivatives of an infinite capacity
        are nan.

    Raises
    ------
    InputError
        If the rollers do not fit or the torque is beyond the capacity.
    NoSolutionError
        If the force balance does not close.
    PrecisionError
        If JAX is in single precision.

    Notes
    -----
    One entry for all contacts is one input: all five move together. The number of planets is differentiated as if
    it were continuous. Where a result has a kink (no torque; two longest contact lines on one roller) the derivative
    is that of one side or their mean.
    """
    require_double_precision()
    xr = require("xarray")
    inputs = numeric_keys(case)
    point = jnp.asarray([entry.value for entry in inputs.values()])
    values, jacobian = _differentiated(case, inputs, point)
    names = judged_results()
    x, y = np.asarray(point), np.asarray(values)
    finite = np.isfinite(y)[:, None]
    derivative = np.where(finite, np.asarray(jacobian), np.nan)
    nonzero = np.where(y == 0.0, np.nan, y)[:, None]
    elasticity = np.where(finite, derivative * x / nonzero, np.nan)
    pair = ("result", "input")
    made: xarray.Dataset = xr.Dataset(
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
            "result": list(names),
            "input": list(inputs),
            "result_unit": ("result", [unit for unit, _ in names.values()]),
            "input_unit": ("input", [entry.key.dimension.si_unit for entry in inputs.values()]),
            "result_name": ("result", [words for _, words in names.values()]),
            "input_name": ("input", [long_name(path) for path in inputs]),
        },
        attrs=common_attributes("sensitivities of a joint"),
    )
    return made


def _differentiated(case: Case, inputs: dict[str, NumericKey], point: Array) -> tuple[Array, Array]:
    form = (table_structure(si_values(case)), tuple(inputs))
    values, status, jacobian = compile_fast(_jacobian, point, options=form)(point)
    refuse_failed(case, int(status))
    return values, jacobian


def _jacobian(structure: str, paths: tuple[str, ...], point: Array) -> tuple[Array, Array, Array]:
    """Values, status and Jacobian at all numbers of a file of this structure.

    The joint is repeated along the batch axis, once for each number, and each copy is moved along its own: JAX follows
    that in a fraction of the time of a vectorising transformation.
    """
    tables = json.loads(structure)

    def judged(table: Array) -> tuple[Array, Array]:
        return _judged(joint_from_values(replace_values(tables, dict(zip(paths, table, strict=True)))))

    copies = jnp.repeat(point[:, None], point.size, axis=1)
    values, jacobian, status = jax.jvp(judged, (copies,), (jnp.eye(point.size),), has_aux=True)
    return values[:, 0], status[0], jacobian


def refuse_failed(case: Case, status: int) -> None:
    """Raise if a joint itself has no result, with all the numbers.

    Parameters
    ----------
    case : Case
        The joint file.
    status : int
        Its code, :data:`asperity.joint.status.STATUS_MEANINGS`.

    Raises
    ------
    InputError
        If the joint cannot exist or slips.
    NoSolutionError
        If its force balance does not close.
    """
    if status == 0:
        return
    solve(joint_from_case(case))  # says it with the numbers
    reason = STATUS_MEANINGS[status]
    if status == UNBALANCED:
        raise NoSolutionError(reason)
    raise InputError(reason)


def ranking(sensitivities: xarray.Dataset, result: str) -> xarray.Dataset:
    """The inputs in the order of their influence on one result.

    Parameters
    ----------
    sensitivities : xarray.Dataset
        What :func:`sensitivity` returns.
    result : str
        Which result.

    Returns
    -------
    xarray.Dataset
        Along ``input``, largest absolute elasticity first.

    Raises
    ------
    InputError
        If there is no such result.
    """
    known = sensitivities["result"].values.tolist()
    if result not in known:
        raise InputError(f"there is no result '{result}' among {', '.join(known)}")
    one = sensitivities.sel(result=result)
    order = np.argsort(-np.abs(np.nan_to_num(one["elasticity"].values, nan=0.0)), kind="stable")
    ranked: xarray.Dataset = one.isel(input=order)
    return ranked
