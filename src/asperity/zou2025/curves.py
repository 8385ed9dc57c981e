"""Everything that the figures and the claims need, computed in two batches: all roller pairs, all joints."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from asperity.engine import trees
from asperity.engine.control import at_once
from asperity.errors import NoSolutionError
from asperity.types import Array, ArrayLike, Real
from asperity.zou2025 import preset
from asperity.zou2025.published import PublishedJoint, published_joint

#: Output torques of the families of curves in Figs. 7 and 8 [N·m]; assumed, within the paper's 0–5 N·m.
OUTPUT_TORQUES = np.arange(0.0, 6.0)
_FRICTION_RANGE = (0.04, 0.30)
_LARGEST_RADIUS_SCALE = 2.0


@dataclass(frozen=True)
class PairCurve:
    """K_t [N/m] of one case of Table 1 over the values [SI] of a key of :data:`asperity.zou2025.preset.TABLE_1`."""

    name: str
    values: np.ndarray
    tangential_stiffness: np.ndarray


@dataclass(frozen=True)
class JointCurves:
    """The joint of Table 2 over m output torques [N·m] (first axis) and n values of one more quantity (last axis).

    ``name`` of the other varied quantity, a field of :class:`asperity.zou2025.preset.OperatingPoint`, and its
    ``values``, SI. Of the five contacts, shape (5, m, n): ``normal_force`` and ``tangential_force`` [N], and
    ``contact_torsional_stiffness``, K_T at the driven roller [N·m/rad]. Shape (m, n): published torsional stiffness at
    the output and at the sun [N·m/rad].
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

    ``pairs``: case of Table 1 (and panel of Fig. 4) → its curve; ``e_low`` and ``f_low`` are cases e and f at the
    lowest fractal dimension of case c, which the paper does not show. ``loads``: over a fine grid of output torques, at
    the D of Table 1 (Fig. 5). ``dimension`` to ``radius``: over the quantity named, for :data:`OUTPUT_TORQUES` (Figs.
    6–8; ``radius`` is in no figure); ``high_friction``: at one, two and four times the upper end of the range of
    friction (in no figure).
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
    """Case → what it varies, its values, at which D; case b extends beyond gross slip."""
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


def _joint_axes() -> dict[str, tuple[np.ndarray, str, np.ndarray]]:
    """Field of :class:`Curves` → output torques, what else is varied, its values."""
    torques = OUTPUT_TORQUES
    doublings = _FRICTION_RANGE[1] * np.array([1.0, 2.0, 4.0])
    return {
        "loads": (
            np.linspace(*preset.OUTPUT_TORQUE_RANGE, 101),
            "fractal_dimension",
            np.array([preset.FRACTAL_DIMENSION]),
        ),
        "dimension": (torques, "fractal_dimension", _dimensions()),
        "roughness": (torques, "fractal_roughness", np.geomspace(*preset.ROUGHNESS_RANGE, 101)),
        "length": (torques, "contact_length", np.linspace(*preset.CONTACT_LENGTH_RANGE, 51)),
        "friction": (torques, "friction_coefficient", np.linspace(*_FRICTION_RANGE, 261)),
        "high_friction": (torques, "friction_coefficient", doublings),
        "radius": (torques, "radius_scale", np.linspace(1.0, _LARGEST_RADIUS_SCALE, 21)),
    }


def pair_curves() -> dict[str, PairCurve]:
    """The six cases of Table 1, and two of them at a lower fractal dimension, as one batch."""
    axes = _pair_axes()
    cases: list[dict[str, ArrayLike]] = [
        {**preset.TABLE_1, "fractal_dimension": dimension, name: values}
        for name, values, dimension in axes.values()
    ]
    sizes = [values.size for _, values, _ in axes.values()]
    batch = {
        key: np.concatenate(
            [np.broadcast_to(case[key], size) for case, size in zip(cases, sizes, strict=True)]
        )
        for key in preset.TABLE_1
    }
    contact = at_once(lambda numbers: preset.table_1_contact(**numbers), batch)
    parts = np.split(contact.tangential_stiffness, np.cumsum(sizes)[:-1])
    return {
        case: PairCurve(name, values, part)
        for (case, (name, values, _)), part in zip(axes.items(), parts, strict=True)
    }


def _published(joint: PublishedJoint) -> tuple[dict[str, Real], Array]:
    """Results that the figures show, and whether each joint is solved."""
    result = published_joint(joint)
    shown = {
        "normal_force": result.forces.normal,
        "tangential_force": result.forces.tangential,
        "contact_torsional_stiffness": result.contact_torsional_stiffness,
        "output_stiffness": result.stiffness.output,
        "sun_stiffness": result.stiffness.input,
    }
    return shown, result.solved


def joint_curves() -> dict[str, JointCurves]:
    """All sweeps of the joint of Table 2, solved as one batch."""
    axes = _joint_axes()
    grids = [preset.operating_grid(output_torque=t, **{name: values}) for t, name, values in axes.values()]
    batch: preset.OperatingPoint = trees.map(
        lambda *leaves: np.concatenate([np.ravel(leaf) for leaf in leaves]), *grids
    )
    shown, solved = at_once(_published, preset.table_2_joint(batch))
    if not np.all(solved):
        raise NoSolutionError(
            f"the force balance did not converge at {np.count_nonzero(~solved)} of {solved.size} points of "
            "the reproduction; this is a defect of the solver, because all points lie within the paper's ranges"
        )
    ends = np.cumsum([t.size * values.size for t, _, values in axes.values()])[:-1]
    parts = {key: np.split(numbers, ends, axis=-1) for key, numbers in shown.items()}
    return {
        field: JointCurves(
            torque,
            name,
            values,
            **{k: p[i].reshape(*p[i].shape[:-1], torque.size, -1) for k, p in parts.items()},
        )
        for i, (field, (torque, name, values)) in enumerate(axes.items())
    }


def compute() -> Curves:
    """Recompute everything that the paper plots, in SI units."""
    return Curves(pairs=pair_curves(), **joint_curves())
