"""A joint over its working temperature: preload, stiffness and capacity."""

from __future__ import annotations

import math
from collections.abc import Callable

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.loading_cam import mean_preload
from asperity.joint.solve import Solution

_TEMPERATURES = 41
_LEAST_MARGIN = 20.0  # of the axis beyond the temperatures of the file [K]


class TemperatureCurves(eqx.Module):
    """One joint over its working temperature [degC]; shape (n,), nan where it has no value.

    ``preload`` is the normal force of the first contact at rest, the mean of unlike sectors [N], 0 where the joint is
    loose; ``stiffness``, that of the assembly at the output under the joint's torque [N·m/rad]; ``torque_capacity``, in
    the direction of its torque [N·m].
    """

    temperature: Array
    preload: Array
    stiffness: Array
    torque_capacity: Array


def temperature_curves(joint: Joint, solved_at: Callable[[float], Solution | None]) -> TemperatureCurves:
    """Preload, assembled stiffness and torque capacity of a joint at 41 temperatures around those of its file.

    ``solved_at`` gives the solution at a working temperature [degC], None where the joint is loose. An ``InputError``
    is raised if temperature does not change the preload.
    """
    fit = joint.fit
    if fit is None:
        raise InputError(
            "the preload of this joint does not depend on temperature: give load.interference and [temperature]"
        )
    ends = sorted((float(fit.assembly_temperature), float(fit.working_temperature)))
    margin = max(_LEAST_MARGIN, 0.5 * (ends[1] - ends[0]))
    temperature = np.linspace(ends[0] - margin, ends[1] + margin, _TEMPERATURES)
    curves = _of_drive(joint, [solved_at(celsius) for celsius in temperature])
    return TemperatureCurves(*map(jnp.asarray, (temperature, *curves)))


def _of_drive(joint: Joint, solutions: list[Solution | None]) -> tuple[np.ndarray, ...]:
    """Preload, assembled stiffness and torque capacity, one temperature after the other."""
    torque, rows = float(joint.output_torque), []
    for solution in solutions:
        if solution is None:
            rows.append((0.0, math.nan, math.nan))
            continue
        result = solution.result
        limit = (solution.reverse_capacity if torque < 0.0 else solution.capacity).output_torque
        assembled = bool(np.all(result.rest.normal > 0.0)) and bool(np.isfinite(result.rest.residual))
        holds = assembled and bool(result.solved) and abs(torque) < float(limit)
        rows.append(
            (
                float(mean_preload(joint, result.rest.normal)) if assembled else 0.0,
                float(result.assembly.stiffness.output) if holds else math.nan,
                float(limit) if assembled else math.nan,
            )
        )
    return tuple(np.array(rows).T)
