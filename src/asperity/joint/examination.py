"""A joint that is going to be reported: solved once, fast to compile, and refused where it cannot exist."""

from __future__ import annotations

import math

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np

from asperity.compilation import compile_fast
from asperity.drive.existence import overlaps, pin_lock, smaller_body, some_contact_slips, too_wide
from asperity.drive.force_balance import BALANCE_TOLERANCE
from asperity.drive.geometry import CONTACT_NAMES, Clearance, clearances
from asperity.errors import InputError, NoSolutionError
from asperity.joint.capacity import LIMIT_KINDS, TorqueCapacity, limit_words, torque_capacity
from asperity.joint.description import Joint, with_one_rank
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
    capacity, reverse_capacity : TorqueCapacity
        Largest positive and largest negative output torque [N·m], and what limits them.
    """

    result: JointResult
    clearances: tuple[Clearance, ...]
    capacity: TorqueCapacity
    reverse_capacity: TorqueCapacity


def _examined(joint: Joint) -> tuple[JointResult, tuple[Clearance, ...], TorqueCapacity]:
    in_both = jax.tree.map(lambda leaf: leaf[..., None], with_one_rank(joint))
    capacities = torque_capacity(in_both, direction=jnp.array([1.0, -1.0]))
    return evaluate(joint), clearances(joint.geometry), capacities


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
    result, gaps, capacities = jax.tree.map(np.asarray, program(numbers))
    capacity, reverse = (jax.tree.map(lambda leaf, i=i: leaf[..., i], capacities) for i in range(2))
    in_direction = reverse if float(numbers.output_torque) < 0.0 else capacity
    _refuse_overlap(numbers, gaps)
    _refuse_locked_pins(numbers)
    if LIMIT_KINDS[int(in_direction.limit)] == "contact_too_wide" and in_direction.output_torque > 0.0:
        _refuse_torque(numbers, in_direction)
    _refuse_wide_contacts(numbers, result)
    if some_contact_slips(slip_ratio=result.diagnostics.gross_slip):
        _refuse_torque(numbers, in_direction)
    _refuse_unsolved(result)
    return Examination(result=result, clearances=gaps, capacity=capacity, reverse_capacity=reverse)


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
            f"the rollers do not fit: {clearance.name}; {found} ({radii}, {float(geometry.planet_count):g} planets)"
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


def _refuse_torque(numbers: Joint, found: TorqueCapacity) -> None:
    """Refuse a torque beyond the capacity of its direction, and say what limits that."""
    limit, torque = float(found.output_torque), float(numbers.output_torque)
    if limit > 0.0 and abs(torque) < limit:
        return
    sentence = f"the output torque {format_quantity(torque, 'N*m')} is beyond the torque capacity"
    if limit == 0.0:
        raise InputError(f"{sentence}, which is 0 N·m: {limit_words(found)} even without a torque")
    shown = format_quantity(math.copysign(limit, torque), "N*m")
    raise InputError(
        f"{sentence} {shown}, at which {limit_words(found)}; lower the torque, or change preload, friction "
        "coefficient or contact lengths"
    )


def _refuse_unsolved(result: JointResult) -> None:
    if not bool(result.solved):
        raise NoSolutionError(
            f"the force balance did not close: relative residual {float(result.forces.balance_residual):.3g} (balance) "
            f"and {float(result.forces.closure_residual):.3g} (closure), allowed {BALANCE_TOLERANCE:g}; check radii, "
            "preload and torque"
        )
