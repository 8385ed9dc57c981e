"""Everything the figures and the claims need, computed in two batches: all roller pairs, all joints."""

from __future__ import annotations

import math
from dataclasses import dataclass

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.errors import NoSolutionError
from asperity.joint.evaluation import Joint, evaluate
from asperity.precision import require_double_precision
from asperity.types import Real
from asperity.zou2025 import preset
from asperity.zou2025.roller_pair import pair_contact

#: Output torques of the families of curves in Figs. 7 and 8 [N·m]; ours, within the paper's 0–5 N·m.
OUTPUT_TORQUES = np.arange(0.0, 6.0)
_FRICTION_RANGE = (0.04, 0.30)
_LARGEST_RADIUS_SCALE = 2.0


@dataclass(frozen=True)
class PairCurve:
    """One case of Table 1.

    Parameters
    ----------
    case : str
        Letter of the case and of the panel of Fig. 4; ``e_low`` and ``f_low`` are cases e and f at the lowest
        fractal dimension of case c, which the paper does not show.
    name : str
        What is varied, an argument of :func:`asperity.zou2025.preset.table_1_pair`.
    values : ndarray
        Its values, SI, shape (n,).
    tangential_stiffness : ndarray
        K_t, shape (n,) [N/m].
    """

    case: str
    name: str
    values: np.ndarray
    tangential_stiffness: np.ndarray


@dataclass(frozen=True)
class JointCurves:
    """The joint of Table 2 over a grid of output torques (first axis) and one more quantity (last axis).

    Parameters
    ----------
    output_torque : ndarray
        Output torques, shape (m,) [N·m].
    name : str
        The other varied quantity, a field of :class:`asperity.zou2025.preset.OperatingPoint`.
    values : ndarray
        Its values, SI, shape (n,).
    normal_force, tangential_force : ndarray
        Forces of the five contacts, shape (5, m, n) [N].
    contact_torsional_stiffness : ndarray
        Each contact's own K_T at its driven roller, shape (5, m, n) [N·m/rad].
    output_stiffness : ndarray
        Published torsional stiffness at the output, shape (m, n) [N·m/rad].
    sun_stiffness : ndarray
        The same at the sun, shape (m, n) [N·m/rad].
    """

    output_torque: np.ndarray
    name: str
    values: np.ndarray
    normal_force: np.ndarray
    tangential_force: np.ndarray
    contact_torsional_stiffness: np.ndarray
    output_stiffness: np.ndarray
    sun_stiffness: np.ndarray


@dataclass(frozen=True)
class Curves:
    """All computed numbers of the reproduction.

    Parameters
    ----------
    pairs : dict
        Letter of the case of Table 1 → its curve.
    loads : JointCurves
        Over a fine grid of output torques, at the D of Table 1 (Fig. 5).
    dimension, roughness, length, friction, radius : JointCurves
        Over the quantity named, for :data:`OUTPUT_TORQUES` (Figs. 6–8; ``radius`` is in no figure).
    high_friction : JointCurves
        At the end of the range of friction, at twice and at four times as much (in no figure).
    """

    pairs: dict[str, PairCurve]
    loads: JointCurves
    dimension: JointCurves
    roughness: JointCurves
    length: JointCurves
    friction: JointCurves
    radius: JointCurves
    high_friction: JointCurves


def _dimensions() -> np.ndarray:
    lower, upper = preset.DIMENSION_RANGE
    return np.linspace(lower, upper, round((upper - lower) / 0.0025) + 1)


def _pair_axes() -> dict[str, tuple[str, np.ndarray, float]]:
    """Case → what it varies, over which values, at which D; case b goes on past gross slip, to show it."""
    slip = preset.FRICTION_COEFFICIENT * preset.PAIR_NORMAL_FORCE
    dimension, low = preset.FRACTAL_DIMENSION, preset.DIMENSION_RANGE[0]
    radii = np.linspace(*preset.SECOND_RADIUS_RANGE, 161)
    lengths = np.linspace(*preset.CONTACT_LENGTH_RANGE, 101)
    return {
        "a": ("normal_force", np.linspace(0.0, preset.PAIR_NORMAL_FORCE, 201), dimension),
        "b": ("tangential_force", np.linspace(0.0, 1.1 * slip, 331), dimension),
        "c": ("fractal_dimension", _dimensions(), dimension),
        "d": ("fractal_roughness", np.geomspace(*preset.ROUGHNESS_RANGE, 101), dimension),
        "e": ("second_radius", radii, dimension),
        "f": ("contact_length", lengths, dimension),
        "e_low": ("second_radius", radii, low),
        "f_low": ("contact_length", lengths, low),
    }


def pair_curves() -> dict[str, PairCurve]:
    """The six cases of Table 1.

    Returns
    -------
    dict
        Letter of the case → its curve.
    """
    require_double_precision()
    axes = _pair_axes()
    columns: dict[str, list[np.ndarray]] = {name: [] for name in preset.TABLE_1}
    for name, values, dimension in axes.values():  # one flat batch: what a case does not vary keeps its value
        fixed = {**preset.TABLE_1, "fractal_dimension": dimension}
        for key, column in columns.items():
            column.append(values if key == name else np.full(values.size, fixed[key]))
    varied = {key: jnp.asarray(np.concatenate(column)) for key, column in columns.items()}
    contact = eqx.filter_jit(pair_contact)(**varied)
    stiffness = np.asarray(contact.tangential_stiffness)
    ends = np.cumsum([values.size for _, values, _ in axes.values()])[:-1]
    return {
        case: PairCurve(case, name, values, part)
        for (case, (name, values, _)), part in zip(axes.items(), np.split(stiffness, ends), strict=True)
    }


@eqx.filter_jit
def _published(joint: Joint) -> tuple[dict[str, Real], Array]:
    """What the figures show; compiling no more than that leaves the assembly model out, which costs the most."""
    result = evaluate(joint)
    shown = {
        "normal_force": result.forces.normal,
        "tangential_force": result.forces.tangential,
        "contact_torsional_stiffness": result.contact_torsional_stiffness,
        "output_stiffness": result.published.output,
        "sun_stiffness": result.published.sun,
    }
    return shown, result.solved


def joint_curves() -> dict[str, JointCurves]:
    """All sweeps of the joint of Table 2, solved as one batch.

    Returns
    -------
    dict
        Field of :class:`Curves` → its sweep.

    Raises
    ------
    NoSolutionError
        Where a force balance does not close.
    """
    require_double_precision()
    axes: dict[str, tuple[np.ndarray, str, np.ndarray]] = {
        "loads": (
            np.linspace(*preset.OUTPUT_TORQUE_RANGE, 101),
            "fractal_dimension",
            np.array([preset.FRACTAL_DIMENSION]),
        ),
        "dimension": (OUTPUT_TORQUES, "fractal_dimension", _dimensions()),
        "roughness": (OUTPUT_TORQUES, "fractal_roughness", np.geomspace(*preset.ROUGHNESS_RANGE, 101)),
        "length": (OUTPUT_TORQUES, "contact_length", np.linspace(*preset.CONTACT_LENGTH_RANGE, 51)),
        "friction": (OUTPUT_TORQUES, "friction_coefficient", np.linspace(*_FRICTION_RANGE, 261)),
        "high_friction": (
            OUTPUT_TORQUES,
            "friction_coefficient",
            _FRICTION_RANGE[1] * np.array([1.0, 2.0, 4.0]),
        ),
        "radius": (OUTPUT_TORQUES, "radius_scale", np.linspace(1.0, _LARGEST_RADIUS_SCALE, 21)),
    }
    grids = [preset.operating_grid(output_torque=t, **{name: v}) for t, name, v in axes.values()]
    shown, solved = _published(preset.table_2_joint(preset.joined(tuple(grids))))
    if not np.all(solved):
        raise NoSolutionError(
            f"the force balance did not close at {np.count_nonzero(~np.asarray(solved))} of {solved.size} points of "
            "the reproduction; this is a defect of the solver, because every point lies within the paper's ranges"
        )
    wanted = {name: np.asarray(values) for name, values in shown.items()}
    curves: dict[str, JointCurves] = {}
    start = 0
    for key, (torque, name, values) in axes.items():
        stop = start + math.prod((torque.size, values.size))
        shape = (torque.size, values.size)
        parts = {k: v[..., start:stop].reshape(*v.shape[:-1], *shape) for k, v in wanted.items()}
        curves[key] = JointCurves(output_torque=torque, name=name, values=values, **parts)
        start = stop
    return curves


def compute() -> Curves:
    """Recompute everything the paper plots.

    Returns
    -------
    Curves
        SI units.

    Raises
    ------
    PrecisionError
        If JAX is in single precision.
    NoSolutionError
        Where a force balance does not close.
    """
    return Curves(pairs=pair_curves(), **joint_curves())
