"""Sweeps of a joint in a script, and pictures of them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol, TypeGuard

import numpy as np

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import displayed
from asperity.errors import InputError, quoted
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.quantity_key import parse_distribution
from asperity.joint_file.si_tables import key_at, si_values
from asperity.results import RESULTS, chosen_results, known_result
from asperity.study.datasets import asked_units, in_si, in_units, require
from asperity.study.design.design_plot import pareto_figure
from asperity.study.parameters import ListedAxis, SweepAxis, parse_axis
from asperity.study.sweep.sweep import sweep as evaluated
from asperity.study.sweep.sweep_plot import sweep_figure
from asperity.study.tolerances.influence_plot import tornado_figure, uncertainty_figure
from asperity.study.tolerances.sensitivity import sensitivity as differentiate
from asperity.study.tolerances.uncertainty import uncertainty as propagate

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure


#: Values of an axis: the steps as a text, a list of quantities, or numbers with one unit for all of them.
AxisValues = (
    str | Sequence[str | float | NamedQuantity] | np.ndarray | tuple[Sequence[float] | np.ndarray, str]
)


class Drawn(Protocol):
    """What has a figure of its own."""

    def plot(self) -> Figure:
        """Draw it."""
        ...


def sweep(
    joint: DescribedJoint,
    over: Mapping[str, AxisValues],
    *,
    results: Sequence[str] | str = "all",
    units: Sequence[str] = (),
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
    units : sequence of str, optional
        Units in place of SI units, such as ``["N*m/arcmin", "um"]``, each for everything that it measures.

    Returns
    -------
    xarray.Dataset
        One dimension an axis; coordinates and results in SI units unless others are asked for, with ``units`` and
        ``long_name`` in their attributes. ``status`` is 0 where a point is solved; elsewhere the results are nan.

    Raises
    ------
    InputError
        If there is no such number or result, a unit is missing or wrong, or a value is outside its range.
    MissingExtraError
        If xarray is not installed.
    """
    require_joint(joint)
    require("xarray")
    if not isinstance(over, Mapping) or not over:
        raise InputError(f"expected axes such as {{'load.preload': ['500 N', '1000 N']}}, got {quoted(over)}")
    kind = joint.case.type
    names = [results] if isinstance(results, str) else list(results)
    axes = [_axis(path, values, kind) for path, values in over.items()]
    table = results_of(si_values(joint.case))
    computed = [table[name] for name in chosen_results(names, table=table)]
    asked = asked_units(units, axes=axes, results=computed)
    return in_units(evaluated(joint.case, axes, results=names), asked)


def _axis(path: str, values: object, kind: str | None = None) -> SweepAxis:
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


def sensitivity(joint: DescribedJoint, results: Sequence[str] | None = None) -> xarray.Dataset:
    """Exact derivatives and elasticities of results with respect to every number of a joint file.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.
    results : sequence of str, optional
        Single results; by default those of :data:`asperity.study.tolerances.sensitivity.DEFAULT_RESULTS`.

    Returns
    -------
    xarray.Dataset
        As of :func:`asperity.study.tolerances.sensitivity.sensitivity`; :func:`plot` draws it.

    Raises
    ------
    InputError
        If there is no such result, or it has no derivatives.
    NoSolutionError
        If the joint has no result.
    """
    require_joint(joint)
    return differentiate(joint.case, results)


def uncertainty(
    joint: DescribedJoint,
    results: Sequence[str] | None = None,
    *,
    distribution: str | None = None,
    samples: int = 100_000,
    seed: int = 0,
    report: Callable[[int, int], None] | None = None,
) -> xarray.Dataset:
    """Intervals of the results from the tolerances of a joint file, and what each tolerance contributes.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`; its file has tolerances.
    results : sequence of str, optional
        Results or groups of them; by default the stiffness, the torque capacity and their limits.
    distribution : str, optional
        For tolerances whose distribution the file does not state: ``"uniform"``, ``"triangular"`` or ``"normal K
        sigma"``.
    samples, seed : int, optional
        Monte-Carlo samples, and the seed of the random numbers.
    report : callable, optional
        Called with the number of points done and of all points.

    Returns
    -------
    xarray.Dataset
        As of :func:`asperity.study.tolerances.uncertainty.uncertainty`; :func:`plot` draws it.

    Raises
    ------
    InputError
        If the file has no tolerances, a distribution is missing, or the joint itself has no result.
    """
    require_joint(joint)
    otherwise = None if distribution is None else parse_distribution(distribution)
    return propagate(
        joint.case, results=results, distribution=otherwise, samples=samples, seed=seed, report=report
    )


def plot(shown: xarray.Dataset | Drawn, *, result: str | None = None) -> Figure:
    """Draw a sweep, sensitivities, uncertainties, a Pareto front, or anything else that this package returns.

    Parameters
    ----------
    shown : xarray.Dataset or result
        What :func:`asperity.sweep`, :func:`asperity.sensitivity`, :func:`asperity.uncertainty` or
        :func:`asperity.design` returns; others are drawn by their own ``plot()``.
    result : str, optional
        Which result of a study; by default the first one, of a sweep the stiffness, on all levels if there is one axis.

    Returns
    -------
    matplotlib.figure.Figure
        A notebook shows it; elsewhere call its ``savefig``.

    Raises
    ------
    InputError
        If there is nothing to draw, or no such result.
    """
    if _is_dataset(shown):
        for kind in ("elasticity", "total_order"):
            if kind in shown:
                return displayed(_influences(shown, kind, result))
        if "status" in shown:
            return displayed(sweep_figure(in_si(shown), result=result))
        if "design" in shown.dims:
            goals = tuple(str(name) for name in shown.data_vars if name in RESULTS)
            return displayed(pareto_figure(shown, goals))
    if result is None and callable(getattr(shown, "plot", None)):
        return shown.plot()
    raise InputError(f"cannot draw {quoted(type(shown).__name__)}; expected a sweep, a solution or a wind-up")


def _is_dataset(shown: object) -> TypeGuard[xarray.Dataset]:
    """Whether something is a dataset of xarray, which need not be imported for that."""
    return hasattr(shown, "data_vars")


def _influences(shown: xarray.Dataset, kind: str, result: str | None) -> Figure:
    """A tornado plot of elasticities, or the histogram and Sobol indices of one result."""
    names = shown["result"].values.tolist()
    asked = known_result(result, among=names) if result else names[0]
    draw: Callable[..., Figure] = tornado_figure if kind == "elasticity" else uncertainty_figure
    return draw(shown, result=asked)
