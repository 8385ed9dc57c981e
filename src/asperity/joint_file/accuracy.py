"""The accuracy of a joint file over a turn: which form errors it states, what is refused, both directions."""

from __future__ import annotations

from collections import defaultdict
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive
from asperity.drive.state.rolling_balance import RollingBalance
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once
from asperity.errors import InputError, NoSolutionError
from asperity.joint.assembled import assembled
from asperity.joint.description import Joint, without_duty
from asperity.joint.machine import joint_machine
from asperity.joint.solve import refuse_impossible_joint
from asperity.joint.unfolding import SectorSizes, unfolded_joint
from asperity.joint_file.build import deviations_of, joint_from_values
from asperity.joint_file.form_parts import form_errors, form_parts, refuse_floating_runout
from asperity.joint_file.own_branches import floating_of, joint_with_branches
from asperity.joint_file.part_names import SECTORS
from asperity.joint_file.si_tables import AnyCase, Values, si_values
from asperity.results.accuracy_document import AccuracyOfJoint
from asperity.rolling.accuracy import (
    Accuracy,
    FormError,
    TurnErrors,
    accuracy_of,
    over_turn,
    rolling_balance_at_once,
    rolling_balance_of,
    turn_errors,
    under_interference,
)
from asperity.types import Array, Real
from asperity.units import format_quantity

#: A wave is at least so many half-widths of the contact long: the contact then rolls as if the track were round.
SHORTEST_WAVE = 20.0


def joint_accuracy(case: AnyCase, *, reverse: bool = False) -> AccuracyOfJoint:
    """What the form errors of a joint file do over a turn of its output, in both directions with ``reverse``.

    An ``InputError`` is raised if the file states no form errors, or such that no part can have, if the bodies do not
    fit, or with ``reverse`` if the input stands; a ``NoSolutionError`` if the joint does not roll steadily.
    """
    if case.form is None:
        raise InputError(
            "the joint file states no form errors, so that its output turns evenly; give sections [[form]], such as "
            'part = "ring" with runout = "6 um" and harmonics = { 2 = "2 um", 3 = "1 um" }'
        )
    joint, errors, sectors = _whole(case)
    if reverse and float(joint.input_speed) == 0.0:
        raise InputError(
            "the input stands (load.sun_speed is 0), so that there is no other direction; give it the speed of the "
            "work",
            options=["reverse"],
        )
    rolling = rolling_balance_at_once(joint)
    refuse_form(joint, rolling, errors)
    forward = accuracy_of(rolling, errors)
    backward = accuracy_of(rolling_balance_at_once(joint, backwards=True), errors) if reverse else None
    return AccuracyOfJoint(
        output=str(joint.drive.output),
        output_torque=float(joint.output_torque),
        sectors=sectors,
        forward=forward,
        backward=backward,
        over_turn=over_turn(forward),
        diameters=tuple(2.0 * _radius(rolling, error) for error in errors),
        lost_motion=_lost_motion(joint) if reverse else None,
    )


def _lost_motion(joint: Joint) -> float | None:
    """Lost motion of the wind-up under the torque of a joint [rad]; None where it does not stand under it both ways."""
    torque = abs(float(joint.output_torque))
    if torque == 0.0:
        return None
    from asperity.standing.windup import windup

    try:
        return float(windup(without_duty(joint), largest_torque=torque, level="assembly").lost_motion)
    except (InputError, NoSolutionError):
        return None


def turn_errors_of(values: Values) -> TurnErrors:
    """What the form errors of a file do over a turn, of tables whose numbers may be traced; pure.

    Tables of :func:`asperity.joint_file.part_names.with_structure`; nan where the joint does not roll, where waves are
    shorter than :data:`SHORTEST_WAVE` half-widths of their contacts, and where the amplitudes of a part exceed the
    interference of the drive.
    """
    equal = without_duty(under_interference(joint_from_values(values)))
    sectors = int(values[SECTORS])
    errors = form_errors(values, form_parts(values, equal.drive), equal.drive, sectors)
    joint = _unfolded(equal, values, sectors)
    rolling = rolling_balance_of(joint)
    alike = {(error.part, error.harmonic) for error in errors}
    groups = [sorted(alike).index((error.part, error.harmonic)) for error in errors]
    found = turn_errors(rolling, errors, None if "branch" in values else groups)
    holds = _form_holds(joint, rolling, errors)
    return TurnErrors(*(xp.where(holds, each, xp.nan) for each in found))


def _unfolded(equal: Joint, values: Values, sectors: int) -> Joint:
    """The joint with every sector by itself; pure."""
    if sectors == 1:
        return equal
    if "branch" in values:
        return without_duty(joint_with_branches(values))
    force = assembled(joint_machine(equal)).laws.reference_force
    support = xp.asarray(values.get("compliance", {}).get("sun_support_stiffness", 0.0), dtype=float)
    sizes = SectorSizes(xp.zeros((sectors, force.size)), xp.tile(force, (sectors, 1)), support)
    return unfolded_joint(equal, sizes, sectors=sectors, floating=floating_of(values, equal.drive))


def _form_holds(joint: Joint, rolling: RollingBalance, errors: list[FormError]) -> Array:
    """Whether no form error is one that :func:`refuse_form` refuses; pure."""
    long = [wave.length >= SHORTEST_WAVE * wave.half_width for wave in _waves(joint, rolling, errors)]
    interference = xp.max(xp.asarray(rolling.state.interference))
    small = [total <= interference for total in _totals(errors).values()]
    return xp.all(xp.stack([xp.asarray(each) for each in (*long, *small)]))


class _Wave(NamedTuple):
    """A form error at a contact, by its name: length of its waves, and half-width of the contact [m]."""

    error: FormError
    contact: str
    length: Real
    half_width: Real


def _waves(joint: Joint, rolling: RollingBalance, errors: list[FormError]) -> list[_Wave]:
    """All form errors at all contacts on their tracks; pure."""
    drive = rolling.machine.drive
    width = xp.asarray(joint_machine(joint).contacts.pairs.half_width(rolling.state.normal))
    radii = {"first": xp.asarray(drive.first_radius), "second": xp.asarray(drive.second_radius)}
    number = {contact.name: k for k, contact in enumerate(drive.contacts)}
    return [
        _Wave(error, name, 2.0 * xp.pi * radii[side][number[name]] / error.harmonic, width[number[name]])
        for error in errors
        for name, side in error.sides
    ]


def _totals(errors: list[FormError]) -> dict[tuple[str, int], Real]:
    """Part and sector → sum of the amplitudes [m]."""
    totals: dict[tuple[str, int], Real] = defaultdict(float)
    for error in errors:
        totals[error.part, error.sector] += error.amplitude
    return totals


def accuracy_of_case(case: AnyCase) -> Accuracy:
    """What the form errors of a joint file do in its own direction; raises as :func:`joint_accuracy`."""
    return joint_accuracy(case).forward


def _radius(rolling: RollingBalance, error: FormError) -> float:
    """Radius of the track of a form error [m]."""
    drive = rolling.machine.drive
    name, side = error.sides[0]
    contact = [contact.name for contact in drive.contacts].index(name)
    return float((drive.first_radius if side == "first" else drive.second_radius)[contact])


def _whole(case: AnyCase) -> tuple[Joint, list[FormError], int]:
    """The joint with every sector by itself, its form errors, and the number of sectors."""
    values = si_values(case)
    joint: Joint = at_once(lambda: under_interference(joint_from_values(values)))
    joint = refuse_impossible_joint(joint)
    drive: Drive = as_numbers(joint.drive)
    sectors = round(float(joint.drive.sectors))
    errors = form_errors(values, form_parts(values, drive), drive, sectors)
    refuse_floating_runout(values, drive)
    return whole_joint(joint, values), errors, sectors


def whole_joint(joint: Joint, values: dict[str, object]) -> Joint:
    """A joint of equal sectors with every sector by itself, and with the sizes of its branches where they differ."""
    if round(float(joint.drive.sectors)) == 1:
        return joint
    from asperity.branches.branches import assembled_branches

    return assembled_branches(joint, deviations_of(values)).joint


def refuse_form(joint: Joint, rolling: RollingBalance, errors: list[FormError]) -> None:
    """Refuse waves that are short against their contacts, and parts whose waves take the whole interference."""
    with np.errstate(all="ignore"):
        waves = _waves(joint, rolling, errors)
    for error, contact, length, half_width in waves:
        wave, half = float(length), float(half_width)
        if wave < SHORTEST_WAVE * half:
            most = int(error.harmonic * wave / (SHORTEST_WAVE * half))
            raise InputError(
                f"harmonic {error.harmonic} of the {error.part.replace('_', ' ')}: its waves of "
                f"{format_quantity(wave, 'mm', 3)} are shorter than {SHORTEST_WAVE:g} half-widths of the contact "
                f"{contact}, {format_quantity(half, 'um', 3)}, over which it rolls as on a round track; state "
                f"harmonics up to {most}: those above belong to the roughness"
            )
    interference = float(np.max(np.asarray(rolling.state.interference)))
    for (part, _), total in _totals(errors).items():
        if float(total) > interference:
            raise InputError(
                f"the amplitudes of the {part.replace('_', ' ')} add up to {format_quantity(float(total), 'um', 4)}, "
                f"more than the interference of the drive, {format_quantity(interference, 'um', 4)}: its contacts "
                "part; state smaller form errors, or a larger preload"
            )
