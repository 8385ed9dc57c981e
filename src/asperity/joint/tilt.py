"""A joint with tilted axes: how its contacts are loaded along their lines, and how far they push sideways."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from asperity.contact.crowned_line import compression_and_shortening, crowned_line
from asperity.contact.roller_profiles import logarithmic_profile
from asperity.contact.tilt_stiffness import (
    freeing_tilt,
    line_load_stiffness,
    sliced_tilt_stiffness,
    tilt_stiffness,
)
from asperity.contact.tilted_line import PLACES, profiled_line
from asperity.drive.structure.axis_tilts import contact_angles_of_tilts
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once
from asperity.joint.contacts import JointContacts
from asperity.joint.crowned_contacts import crowned_lines
from asperity.joint.description import Joint, joint_contacts
from asperity.joint.evaluation import JointResult
from asperity.joint.laws import creep_law
from asperity.joint.machine import joint_machine
from asperity.joint.working_loads import working_forces
from asperity.rolling.creep import contact_friction
from asperity.types import Array

Numbers = NDArray[np.float64]


class TiltedLines(NamedTuple):
    """Contacts at angles between their axes, shape (contacts,).

    ``slope`` and ``skew`` without sign [rad]; ``peak_over_mean`` and ``end_over_mean``, line loads, the larger of both
    ends, without the stress of its edge [-]; ``edge``, whether an end is loaded; ``peak_pressure``, nan there [Pa];
    ``sideways``, axial force over friction of the skew, nan where the joint does not roll or the skew is not known [-].
    """

    slope: Numbers
    skew: Numbers
    peak_over_mean: Numbers
    end_over_mean: Numbers
    edge: NDArray[np.bool_]
    peak_pressure: Numbers
    sideways: Numbers


class TiltedContacts(NamedTuple):
    """What tilted axes do to the contacts of a joint under its torque, shape (contacts,).

    ``normal_force`` [N]; ``tilt_stiffness`` without tilt [N·m/rad]; ``freeing_slope``, near which an end of a cylinder
    comes free, nan of crowned contacts [rad]. ``as_stated``, and ``in_any_direction``: the largest of each, of the same
    tilts in the worst direction for it.
    """

    normal_force: Numbers
    tilt_stiffness: Numbers
    freeing_slope: Numbers
    as_stated: TiltedLines
    in_any_direction: TiltedLines


def tilted_contacts(joint: Joint, result: JointResult) -> TiltedContacts | None:
    """What the tilts of a joint do to its contacts in the state in which it works; None where that is not known.

    Forces and creep are those of parallel axes; (M5), (B13), (B14) and (B3). Of a joint with tilts.
    """
    tilts = joint.tilts
    assert tilts is not None
    joint = as_numbers(joint)
    normal = np.asarray(working_forces(joint, result)[0], dtype=float)
    if not np.all(normal > 0.0):
        return None
    contacts = at_once(joint_contacts, joint)
    stiffness, freeing = (np.asarray(found) for found in at_once(_stiffness, contacts, normal))
    angles = contact_angles_of_tilts(drive=joint.drive, stiffness=stiffness, tilts=tilts)
    lines = [
        _lines(joint, result, contacts, normal, np.abs(slope), np.abs(skew))
        for slope, skew in ((angles.slope, angles.skew), (angles.largest_slope, angles.largest_skew))
    ]
    return TiltedContacts(normal, stiffness, freeing, *lines)


def _stiffness(contacts: JointContacts, normal: Array) -> tuple[Array, Array]:
    """Tilt stiffness of the contacts [N·m/rad], and the slope at which an end of cylinders comes free [rad]."""
    pairs = contacts.pairs
    length, modulus = pairs.contact_length, pairs.moduli.contact_modulus
    if contacts.crown_curvature is None:
        slice_stiffness = line_load_stiffness(
            half_width=pairs.half_width(normal), loaded_length=length, contact_modulus=modulus
        )
        free = freeing_tilt(
            line_load=normal / length, line_load_stiffness=slice_stiffness, contact_length=length
        )
        even = tilt_stiffness(line_load_stiffness=slice_stiffness, contact_length=length)
        return xp.asarray(even), xp.asarray(free)
    line = crowned_lines(
        pairs=pairs, crown_curvature=contacts.crown_curvature, logarithmic=contacts.logarithmic
    )
    _, shorter = compression_and_shortening(normal_force=normal, **vars(line))
    found = sliced_tilt_stiffness(
        line=crowned_line(normal_force=normal, **vars(line)),
        loaded_length=1.0 / (1.0 / line.contact_length + shorter),
        contact_length=line.contact_length,
        contact_modulus=line.contact_modulus,
    )
    return found, np.nan * found


def _lines(
    joint: Joint, result: JointResult, contacts: JointContacts, normal: Numbers, slope: Numbers, skew: Numbers
) -> TiltedLines:
    """Contacts at these angles, without sign [rad]."""
    pairs = contacts.pairs
    length, radius, modulus = (
        np.broadcast_to(np.asarray(values, dtype=float), normal.shape)
        for values in (pairs.contact_length, pairs.effective_radius, pairs.moduli.contact_modulus)
    )
    curvature = np.zeros_like(normal) if contacts.crown_curvature is None else contacts.crown_curvature
    logarithmic = np.zeros_like(normal) if contacts.logarithmic is None else contacts.logarithmic
    peaks, ends, pressures = [], [], []
    for k, force in enumerate(normal):
        along = length[k] * PLACES
        line = profiled_line(
            gap=crown_gap(float(curvature[k]), length[k], logarithmic=bool(logarithmic[k]))
            - slope[k] * along,
            normal_force=force,
            contact_length=length[k],
            effective_radius=radius[k],
            contact_modulus=modulus[k],
        )
        mean = force / length[k]
        peaks.append(float(np.max(line.line_load)) / mean)
        ends.append(float(line.end_line_load) / mean)
        pressures.append(float(line.peak_pressure))
    edge = np.array(ends) > 0.0
    return TiltedLines(
        slope=slope,
        skew=skew,
        peak_over_mean=np.array(peaks),
        end_over_mean=np.array(ends),
        edge=edge,
        peak_pressure=np.where(edge, np.nan, pressures),
        sideways=_sideways(joint, result, normal, skew),
    )


def crown_gap(curvature: float, length: float, *, logarithmic: bool) -> Array:
    """Gap of the crowns of both bodies at the places of slices [m], of their curvature in the middle [1/m]."""
    if not logarithmic:
        return 0.5 * curvature * (length * xp.asarray(PLACES)) ** 2
    return logarithmic_profile(coefficient=curvature * length**2 / 8.0, end_share=1.0)


def _sideways(joint: Joint, result: JointResult, normal: Numbers, skew: Numbers) -> Numbers:
    """Axial force of skewed contacts over their friction, as ``rolling.skew`` has it; nan where it is not known."""
    if float(joint.input_speed) == 0.0:
        return np.full_like(normal, np.nan)
    known = np.isfinite(skew)
    turned = np.where(known, skew, 0.0)
    skewed = dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, skew=tuple(turned)))

    def lateral(joint: Joint, normal: Array, tangential: Array) -> Array:
        machine = joint_machine(joint)
        creep = creep_law(machine, normal, tangential)
        creepage = creep.creepage(normal, tangential)
        return contact_friction(
            pairs=machine.contacts.pairs, creep=creep, normal_force=normal, creepage=creepage
        ).lateral

    tangential = np.asarray(result.rolling.tangential, dtype=float)
    return np.where(known, np.abs(at_once(lateral, skewed, normal, tangential)), np.nan)
