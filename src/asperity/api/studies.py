"""Sweeps of a joint in a script, and pictures of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import displayed
from asperity.errors import InputError, quoted
from asperity.joint_file.si_tables import key_at
from asperity.study.datasets import require
from asperity.study.parameters import ListedAxis, SweepAxis, parse_axis

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure


def sweep(
    joint: DescribedJoint, over: Mapping[str, Any], *, results: Sequence[str] | str = "all"
) -> xarray.Dataset:
    """A joint on a grid of any of its numbers.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.
    over : mapping
        Dotted path → values: a list of texts with units, ``["500 N", "1000 N"]``; numbers and one unit for all of
        them, ``(np.linspace(500, 2000, 7), "N")``; or even steps as the command line writes them,
        ``"500 N:2000 N:7"``, ``"1e-10 mm:1e-8 mm:50:log"``. Bare numbers only where they are dimensionless.
    results : sequence of str or str, optional
        Results, or groups of them such as ``"stiffness"``; what is not asked for is not computed.

    Returns
    -------
    xarray.Dataset
        One dimension an axis; coordinates and results in SI units, with ``units`` and ``long_name`` in their
        attributes. ``status`` is 0 where a point is solved; elsewhere the results are nan.

    Raises
    ------
    InputError
        If there is no such number or result, a unit is missing or wrong, or a value is outside its range.
    MissingExtraError
        If xarray is not installed.
    """
    from asperity.study.sweep.sweep import sweep as evaluated

    require_joint(joint)
    require("xarray")
    if not isinstance(over, Mapping) or not over:
        raise InputError(f"expected axes such as {{'load.preload': ['500 N', '1000 N']}}, got {quoted(over)}")
    kind = joint.case.type
    names = [results] if isinstance(results, str) else list(results)
    return evaluated(joint.case, [_axis(path, values, kind) for path, values in over.items()], results=names)


def _axis(path: str, values: Any, kind: str | None = None) -> SweepAxis:
    key = key_at(path, kind)
    if isinstance(values, str):
        return parse_axis(f"{path}={values}", kind=kind)
    if (
        isinstance(values, tuple)
        and len(values) == 2
        and isinstance(values[1], str)
        and not isinstance(values[0], str)
    ):
        numbers, unit = values
        si_number(f"1 {unit}", key.dimension, name=path)
        values = [f"{float(number)!r} {unit}" for number in np.ravel(numbers)]
    if isinstance(values, NamedQuantity) or not isinstance(values, Sequence | np.ndarray):
        raise InputError(f"{path}: expected a list of values with their units, got {quoted(values)}")
    return ListedAxis(path, tuple(si_number(value, key.dimension, name=path) for value in values))


def plot(shown: Any, *, result: str | None = None) -> Figure:
    """Draw a sweep, a Pareto front, or anything else that this package returns.

    Parameters
    ----------
    shown : xarray.Dataset or result
        What :func:`asperity.sweep` or :func:`asperity.design` returns; others are drawn by their own ``plot()``.
    result : str, optional
        Which result of a sweep; by default the stiffness, on all levels if there is one axis.

    Returns
    -------
    matplotlib.figure.Figure
        A notebook shows it; elsewhere call its ``savefig``.

    Raises
    ------
    InputError
        If there is nothing to draw, or no such result.
    """
    if hasattr(shown, "data_vars"):
        if "status" in shown:
            from asperity.study.sweep.sweep_plot import sweep_figure

            return displayed(sweep_figure(shown, result=result))
        if "design" in shown.dims:
            from asperity.results import RESULTS
            from asperity.study.design.design_plot import pareto_figure

            goals = tuple(str(name) for name in shown.data_vars if name in RESULTS)
            return displayed(pareto_figure(shown, goals))
    if result is None and callable(getattr(shown, "plot", None)):
        figure: Figure = shown.plot()
        return figure
    raise InputError(f"cannot draw {quoted(type(shown).__name__)}; expected a sweep, a solution or a wind-up")
