"""Solve one joint: refuse what cannot exist, find forces, contacts and stiffness, and the torque it can pass."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import equinox as eqx
import jax
import numpy as np

from asperity.compilation import compile_fast
from asperity.drive.capacity import TorqueCapacity, capacity_by_search
from asperity.drive.existence import some_contact_slips
from asperity.drive.geometry import CONTACT_NAMES, Clearance, clearances
from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult, evaluate
from asperity.joint.refusal import (
    refuse_bad_numbers,
    refuse_locked_pins,
    refuse_overlap,
    refuse_pulled_rollers,
    refuse_unknown_variants,
    refuse_wide_contacts,
)
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
    capacity : TorqueCapacity
        Largest output torque without gross slip [N·m], and the contact that limits it.
    """

    result: JointResult
    clearances: tuple[Clearance, ...]
    capacity: TorqueCapacity


def solve_program(joint: Joint) -> tuple[JointResult, tuple[Clearance, ...]]:
    """What is compiled to solve a joint: everything about it, and its clearances.

    Parameters
    ----------
    joint : Joint
        One joint.

    Returns
    -------
    tuple
        Its result and its clearances.
    """
    return evaluate(joint), clearances(joint.geometry)


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
    refuse_bad_numbers(numbers)
    program = compile_fast(solve_program, numbers)
    result, gaps = jax.tree.map(np.asarray, program(numbers))
    refuse_overlap(numbers, gaps)
    refuse_locked_pins(numbers)
    refuse_pulled_rollers(numbers, result)
    refuse_wide_contacts(numbers, result)
    capacity = _capacity(numbers, program)
    if some_contact_slips(slip_ratio=result.diagnostics.slip_ratio):
        _refuse_torque(numbers, result, capacity)
    refuse_unsolved(numbers, result)
    return Solution(result=result, clearances=gaps, capacity=capacity)


def _capacity(numbers: Joint, program: Callable[..., Any]) -> TorqueCapacity:
    """Torque capacity by the program that has just solved the joint, called with other torques."""

    def slip_ratios(torque: float) -> np.ndarray:
        result, _ = program(dataclasses.replace(numbers, output_torque=np.float64(torque)))
        return np.where(result.solved, result.diagnostics.slip_ratio, np.nan)

    orbit = numbers.geometry.ring_radius - numbers.geometry.loading_roller_radius
    friction = min(float(each) for each in numbers.friction_coefficients)
    first_guess = friction * float(numbers.preload * orbit * numbers.geometry.planet_count)
    return capacity_by_search(slip_ratios=slip_ratios, first_guess=first_guess)


def _refuse_torque(numbers: Joint, result: JointResult, found: TorqueCapacity) -> None:
    """Say what the torque, under which some contact slips, is beyond."""
    limit, torque = float(found.output_torque), float(numbers.output_torque)
    if torque < limit:
        return
    beyond = f"the output torque {format_quantity(torque, 'N*m')} is beyond the torque capacity"
    if math.isnan(limit):
        refuse_unsolved(numbers, result)
        raise InputError(
            f"{beyond}, which is unknown, because the force balance does not close at every torque below; lower the "
            "torque, or raise preload or friction coefficient"
        )
    contact = CONTACT_NAMES[int(found.limiting_contact)]
    if limit == 0.0:
        raise InputError(
            f"{beyond}, which is 0 N·m: contact {contact} slips or lifts off even without a torque; lower the bearing "
            "friction or the speed, or raise the preload"
        )
    raise InputError(
        f"{beyond} {format_quantity(limit, 'N*m')}, at which contact {contact} slips; allowed are at least 0 N·m and "
        f"below {format_quantity(limit, 'N*m')}, unless preload or friction coefficient are raised"
    )
