"""Solve one joint: refuse what cannot exist, find forces, contacts and stiffness, and the torque it can pass."""

from __future__ import annotations

import math

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from asperity.compilation import compile_fast
from asperity.drive.existence import some_contact_slips
from asperity.drive.geometry import Clearance, clearances
from asperity.errors import InputError
from asperity.joint.capacity import LIMIT_KINDS, TorqueCapacity, limit_words, torque_capacity
from asperity.joint.description import Joint, with_one_rank
from asperity.joint.evaluated import chain_programs, evaluated
from asperity.joint.evaluation import JointResult
from asperity.joint.plausibility import CheckedSizes, checked_sizes
from asperity.joint.refusal import (
    refuse_bad_numbers,
    refuse_locked_pins,
    refuse_overlap,
    refuse_pulled_rollers,
    refuse_short_contacts,
    refuse_thin_walls,
    refuse_unknown_variants,
    refuse_wide_contacts,
)
from asperity.joint.temperature import refuse_loose
from asperity.joint.unsolved import refuse_unsolved
from asperity.precision import require_double_precision
from asperity.units import format_quantity


class Solution(eqx.Module):
    """A joint's result beside what decides whether it can exist.

    Parameters
    ----------
    result : JointResult
        Forces, contacts, stiffness and diagnostics.
    clearances : tuple of Clearance
        Free distances between the rollers [m].
    capacity, reverse_capacity : TorqueCapacity
        Largest positive and largest negative output torque [N·m], and what limits them.
    sizes : CheckedSizes
        Sizes that are compared with usual ones.
    """

    result: JointResult
    clearances: tuple[Clearance, ...]
    capacity: TorqueCapacity
    reverse_capacity: TorqueCapacity
    sizes: CheckedSizes


def _limits(joint: Joint, result: JointResult) -> tuple[tuple[Clearance, ...], TorqueCapacity, CheckedSizes]:
    """Clearances of a joint, its torque capacity in both directions along a last axis, and its sizes."""
    in_both = jax.tree.map(lambda leaf: leaf[..., None], with_one_rank(joint))
    capacities = torque_capacity(in_both, direction=jnp.array([1.0, -1.0]))
    return clearances(joint.geometry), capacities, checked_sizes(joint, result)


def solve(joint: Joint) -> Solution:
    """Solve one joint and refuse one that cannot exist.

    For many joints at once, or inside ``jit``, ``vmap`` and ``grad``, use the pure
    :func:`asperity.joint.evaluation.evaluate` and look at its ``solved``, or at
    :func:`asperity.joint.status.joint_status`.

    Parameters
    ----------
    joint : Joint
        One joint, without batch axes.

    Returns
    -------
    Solution
        Its result, with leaves as NumPy arrays, its clearances and its torque capacity.

    Raises
    ------
    InputError
        If there is no such variant, a number is out of its range, the rollers do not fit, or the output torque
        exceeds the torque capacity; with the numbers.
    NoSolutionError
        If the force balance did not close; with what would have to change.
    PrecisionError
        If JAX is in single precision.
    """
    require_double_precision()
    refuse_unknown_variants(joint)
    numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    refuse_loose(numbers.fit)
    refuse_bad_numbers(numbers)
    *_, shapes = chain_programs(numbers)
    limits = compile_fast(_limits, numbers, shapes)
    result = evaluated(numbers)
    gaps, capacities, sizes = jax.tree.map(np.asarray, limits(numbers, result))
    capacity, reverse = (jax.tree.map(lambda leaf, i=i: leaf[..., i], capacities) for i in range(2))
    in_direction = reverse if float(numbers.output_torque) < 0.0 else capacity
    refuse_overlap(numbers, gaps)
    refuse_locked_pins(numbers)
    refuse_pulled_rollers(numbers, result)
    if LIMIT_KINDS[int(in_direction.limit)] == "contact_too_wide" and in_direction.output_torque > 0.0:
        _refuse_torque(numbers, in_direction)
    refuse_wide_contacts(numbers, result)
    if result.solved and some_contact_slips(slip_ratio=result.diagnostics.slip_ratio):
        _refuse_torque(numbers, in_direction)
    refuse_unsolved(numbers, result)
    refuse_short_contacts(result)
    refuse_thin_walls(result)
    return Solution(result=result, clearances=gaps, capacity=capacity, reverse_capacity=reverse, sizes=sizes)


def _refuse_torque(numbers: Joint, found: TorqueCapacity) -> None:
    """Refuse a torque beyond the capacity of its direction, and say what limits that."""
    limit, torque = float(found.output_torque), float(numbers.output_torque)
    if limit > 0.0 and abs(torque) < limit:
        return
    beyond = f"the output torque {format_quantity(torque, 'N*m')} is beyond the torque capacity"
    if limit == 0.0:
        raise InputError(
            f"{beyond}, which is 0 N·m: {limit_words(found)} even without a torque; lower the bearing friction or "
            "the speed, or raise the preload"
        )
    shown = format_quantity(math.copysign(limit, torque), "N*m")
    raise InputError(
        f"{beyond} {shown}, at which {limit_words(found)}; lower the torque, or change preload, friction coefficient "
        "or contact lengths"
    )
