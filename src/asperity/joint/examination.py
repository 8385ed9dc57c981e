"""A joint that is going to be reported: solved once, fast to compile, and refused where it cannot exist."""

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
from asperity.drive.existence import overlaps, pin_lock, smaller_body, some_contact_slips, too_wide
from asperity.drive.force_balance import BALANCE_TOLERANCE
from asperity.drive.geometry import CONTACT_NAMES, Clearance, clearances
from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult, evaluate
from asperity.precision import require_double_precision
from asperity.units import format_quantity


class Examination(eqx.Module):
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


def _examined(joint: Joint) -> tuple[JointResult, tuple[Clearance, ...]]:
    return evaluate(joint), clearances(joint.geometry)


def examine(joint: Joint) -> Examination:
    """Solve one joint and refuse one that cannot exist.

    Parameters
    ----------
    joint : Joint
        One joint, without batch axes.

    Returns
    -------
    Examination
        Its result, with leaves as NumPy arrays, its clearances and its torque capacity.

    Raises
    ------
    InputError
        If the rollers do not fit, or the output torque exceeds the torque capacity; with the numbers.
    NoSolutionError
        If the force balance did not close.
    PrecisionError
        If JAX is in single precision.
    """
    require_double_precision()
    numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    program = compile_fast(_examined, numbers)
    result, gaps = jax.tree.map(np.asarray, program(numbers))
    _refuse_overlap(numbers, gaps)
    _refuse_locked_pins(numbers)
    _refuse_wide_contacts(numbers, result)
    capacity = _capacity(numbers, program)
    if some_contact_slips(slip_ratio=result.diagnostics.slip_ratio):
        _refuse_torque(numbers, result, capacity)
    _refuse_unsolved(result)
    return Examination(result=result, clearances=gaps, capacity=capacity)


def _capacity(numbers: Joint, program: Callable[..., Any]) -> TorqueCapacity:
    """Torque capacity by the program that has just solved the joint, called with other torques."""

    def slip_ratios(torque: float) -> np.ndarray:
        result, _ = program(dataclasses.replace(numbers, output_torque=np.float64(torque)))
        return np.where(result.solved, result.diagnostics.slip_ratio, np.nan)

    orbit = numbers.geometry.ring_radius - numbers.geometry.loading_roller_radius
    friction = min(float(each) for each in numbers.friction_coefficients)
    first_guess = friction * float(numbers.preload * orbit * numbers.geometry.planet_count)
    return capacity_by_search(slip_ratios=slip_ratios, first_guess=first_guess)


def _refuse_overlap(joint: Joint, gaps: tuple[Clearance, ...]) -> None:
    geometry = joint.geometry
    for clearance in gaps:
        if not overlaps(gap=clearance.gap):
            continue
        gap = float(clearance.gap)
        radii = ", ".join(
            f"{symbol} = {format_quantity(float(value), 'mm')}"
            for symbol, value in (
                ("R_s", geometry.sun_radius),
                ("R_p", geometry.planet_radius),
                ("R_w", geometry.loading_roller_radius),
                ("R_o", geometry.ring_radius),
            )
        )
        found = f"the gap is {format_quantity(gap, 'mm')}, it must be above 0 mm"
        if math.isnan(gap):
            found = "the triangle sun, planet, loading roller does not close"
        raise InputError(
            f"the rollers do not fit: {clearance.condition}; {found} "
            f"({radii}, {float(geometry.planet_count):g} planets)"
        )


def _refuse_wide_contacts(joint: Joint, result: JointResult) -> None:
    """Line-contact theory has a positive stiffness only where the strip is narrower than its bodies."""
    bodies = smaller_body(geometry=joint.geometry, ring_wall_thickness=joint.ring_wall_thickness)
    widths = result.diagnostics.hertz_half_width
    wide = too_wide(
        half_width=widths, smaller_body=bodies, bulk_normal_stiffness=result.interfaces.bulk_normal
    )
    if np.any(wide):
        first = int(np.argmax(wide))
        name, width, body = CONTACT_NAMES[first], float(np.asarray(widths)[first]), float(bodies[first])
        raise InputError(
            f"the contact {name} is {format_quantity(2.0 * width, 'mm')} wide, too wide for a radius or "
            f"wall of {format_quantity(body, 'mm')}: line-contact theory needs a half-width far below it; lower "
            "the preload, or choose longer contact lines or stiffer materials"
        )


def _refuse_locked_pins(joint: Joint) -> None:
    pins = pin_lock(geometry=joint.geometry, bearings=joint.bearings)
    if pins.too_thick:
        raise InputError(
            f"the pin diameter {format_quantity(float(joint.bearings.pin_diameter), 'mm')} must be below the diameter "
            f"of the loading roller, {format_quantity(2.0 * float(joint.geometry.loading_roller_radius), 'mm')}"
        )
    if pins.locks:
        raise InputError(
            "the pins lock: pin friction coefficient times pin diameter over loading roller radius is "
            f"{float(pins.grip):.3g}, it must be below the cosine of the push angle, {float(pins.push):.3g}"
        )


def _refuse_torque(numbers: Joint, result: JointResult, found: TorqueCapacity) -> None:
    """Say what the torque, under which some contact slips, is beyond."""
    limit, torque = float(found.output_torque), float(numbers.output_torque)
    if torque < limit:
        return
    told = f"the output torque {format_quantity(torque, 'N*m')} is beyond the torque capacity"
    if math.isnan(limit):
        _refuse_unsolved(result)
        raise InputError(
            f"{told}, which is unknown, because the force balance does not close at every torque below; lower the "
            "torque, or raise preload or friction coefficient"
        )
    contact = CONTACT_NAMES[int(found.limiting_contact)]
    if limit == 0.0:
        raise InputError(
            f"{told}, which is 0 N·m: contact {contact} slips or lifts off even without a torque"
        )
    raise InputError(
        f"{told} {format_quantity(limit, 'N*m')}, at which contact {contact} slips; allowed are at least 0 N·m and "
        f"below {format_quantity(limit, 'N*m')}, unless preload or friction coefficient are raised"
    )


def _refuse_unsolved(result: JointResult) -> None:
    if not bool(result.solved):
        raise NoSolutionError(
            f"the force balance did not close: relative residual {float(result.forces.balance_residual):.3g} (balance) "
            f"and {float(result.forces.closure_residual):.3g} (closure), allowed {BALANCE_TOLERANCE:g}; check radii, "
            "preload and torque"
        )
