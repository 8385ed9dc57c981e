"""A joint over its working temperature: preload, stiffness and capacity."""

from __future__ import annotations

import dataclasses
import math

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.errors import InputError
from asperity.joint.capacity import torque_capacity
from asperity.joint.description import Joint
from asperity.joint.evaluation import evaluate
from asperity.joint.interference import joint_preload
from asperity.joint.planar.description import PlanarJoint
from asperity.joint.planar.temperature import solved_at

_TEMPERATURES = 41
_LEAST_MARGIN = 20.0  # of the axis beyond the temperatures of the file [K]


class TemperatureCurves(eqx.Module):
    """One joint over its working temperature. SI units; shape (n,); nan where it has no value.

    Parameters
    ----------
    temperature : Array
        Temperatures [degC].
    preload : Array
        Normal force between sun and planet at rest [N]; 0 where the joint is loose.
    stiffness : Array
        Assembled torsional stiffness at the output under the joint's torque [N·m/rad].
    torque_capacity : Array
        In the direction of its torque [N·m].
    """

    temperature: Array
    preload: Array
    stiffness: Array
    torque_capacity: Array


def temperature_curves(joint: Joint | PlanarJoint) -> TemperatureCurves:
    """Preload, assembled stiffness and torque capacity of a joint around the temperatures of its file.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        One joint with a :class:`asperity.joint.description.Fit`.

    Returns
    -------
    TemperatureCurves
        From half their difference below the colder to half of it above the warmer temperature, at least 20 K on either
        side.
    """
    fit = joint.fit
    if fit is None:
        raise InputError(
            "the preload of this joint does not depend on temperature: give load.interference and [temperature]"
        )
    ends = sorted((float(fit.assembly_temperature), float(fit.working_temperature)))
    margin = max(_LEAST_MARGIN, 0.5 * (ends[1] - ends[0]))
    temperature = np.linspace(ends[0] - margin, ends[1] + margin, _TEMPERATURES)
    if isinstance(joint, PlanarJoint):
        found = _of_planar_drive(joint, temperature)
    else:
        found = _of_the_papers_drive(joint, temperature)
    return TemperatureCurves(*map(jnp.asarray, (temperature, *found)))


def _of_planar_drive(joint: PlanarJoint, temperature: np.ndarray) -> tuple[np.ndarray, ...]:
    """Preload, assembled stiffness and torque capacity, one temperature after the other."""
    backwards = int(float(joint.output_torque) < 0.0)
    rows = []
    for each in temperature:
        result, capacity = solved_at(joint, each)
        limit = capacity.standing.output_torque[backwards]
        assembled = bool(np.all(result.rest.normal > 0.0)) and bool(np.isfinite(result.rest.residual))
        holds = assembled and bool(result.solved) and abs(float(joint.output_torque)) < float(limit)
        rows.append(
            (
                float(result.rest.normal[0]) if assembled else 0.0,
                float(result.assembly.stiffness.output) if holds else math.nan,
                float(limit) if assembled else math.nan,
            )
        )
    return tuple(np.array(rows).T)


def _of_the_papers_drive(joint: Joint, temperature: np.ndarray) -> tuple[np.ndarray, ...]:
    """Preload, assembled stiffness and torque capacity at all temperatures at once."""
    fit = joint.fit
    assert fit is not None
    length = float(fit.interference) + float(fit.change_per_kelvin) * (
        temperature - float(fit.assembly_temperature)
    )
    plain = dataclasses.replace(joint, fit=None, rolling=dataclasses.replace(joint.rolling, duty=()))
    preload = np.asarray(joint_preload(plain, jnp.asarray(length)))
    numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), plain)
    touching = np.where(preload > 0.0, preload, np.nan)
    points = dataclasses.replace(numbers, preload=touching)
    return preload, *map(np.asarray, compile_fast(_over_preload, points)(points))


def _over_preload(joint: Joint) -> tuple[Array, Array]:
    """Assembled stiffness and torque capacity of joints of different preloads."""
    result = evaluate(joint)
    capacity = torque_capacity(
        joint, direction=jnp.where(jnp.asarray(joint.output_torque) < 0.0, -1.0, 1.0)
    ).output_torque
    holds = result.solved & jnp.all(result.diagnostics.slip_ratio < 1.0, axis=0)
    bears = jnp.isfinite(jnp.asarray(joint.preload))
    return jnp.where(holds, result.assembly.stiffness.output, jnp.nan), jnp.where(bears, capacity, jnp.nan)
