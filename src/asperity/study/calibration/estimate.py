"""A calibrated unknown with its interval."""

from __future__ import annotations

import math
from dataclasses import dataclass

from asperity.study.design.design_problem import Variable


@dataclass(frozen=True)
class Estimate:
    """One calibrated unknown: its ``path``, and the least-squares estimate of its ``value`` [SI].

    ``lower`` and ``upper``: 95 % interval, by the scatter of the data and the error of the model [SI], nan where it is
    not determined; ``scatter_lower`` and ``scatter_upper``, by the scatter of the data alone. ``determined``: whether
    the data and the model say more about it than its bounds do; ``at_bound``: "lower" or "upper" if the search ended
    on a bound, where ``value`` is that bound and nothing is determined, else empty.
    """

    path: str
    value: float
    lower: float
    upper: float
    scatter_lower: float
    scatter_upper: float
    determined: bool
    at_bound: str


def estimated(
    unknown: Variable, scaled_value: float, by_scatter: float, by_model: float, *, lost: bool
) -> Estimate:
    """An unknown with its interval, of which the scatter of the data and the error of the model make their parts.

    ``lost``: the data do not determine it.
    """
    half = math.hypot(by_scatter, by_model)
    bound = "lower" if scaled_value < 1e-6 else "upper" if scaled_value > 1.0 - 1e-6 else ""
    lost = lost or bool(bound)
    steps = {"lower": -half, "upper": half, "scatter_lower": -by_scatter, "scatter_upper": by_scatter}
    return Estimate(
        path=unknown.path,
        value=float(unknown.from_unit(scaled_value)),
        **{
            name: math.nan if lost else float(unknown.from_unit(scaled_value + step))
            for name, step in steps.items()
        },
        determined=not lost,
        at_bound=bound,
    )
