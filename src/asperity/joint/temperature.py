"""A joint at its working temperature: what that adds to the interference of its contacts, and curves over it."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import numpy as np

from asperity.drive.layout.expansion import interference_of_strains, ring_expansion, ring_interference
from asperity.drive.state.states import rest_forces
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.module import Module
from asperity.errors import InputError
from asperity.joint.description import ContactFit, Joint, WarmerRollers, places
from asperity.joint.fit import fit_document
from asperity.joint.loading_cam import mean_preload
from asperity.joint.solve import Solution
from asperity.joint.temperature_limits import TemperatureLimit
from asperity.rolling.conditions import ZERO_CELSIUS
from asperity.types import Array, Document, Real


def contact_expansion(joint: Joint, *, housing_expansion: Real | None) -> Array:
    """Interference that a kelvin adds to each contact of a joint, shape (contacts,) [m/K]."""
    drive = joint.drive
    expansions = [xp.asarray(material.thermal_expansion) for material in joint.materials]
    first, second = places(drive)
    outer = []
    for contact, body in enumerate(second):
        shape, material = joint.shapes[body], joint.materials[body]
        expansion: Any = expansions[body]
        if housing_expansion is not None and shape.kind == "ring" and shape.support != "free":
            assert shape.size is not None
            expansion = ring_expansion(
                ring=expansion,
                housing=housing_expansion,
                inner_radius=drive.second_radius[contact],
                wall_thickness=shape.size,
                youngs_modulus=material.youngs_modulus,
                poisson_ratio=material.poisson_ratio,
                housing_stiffness=shape.rim_stiffness[0],
                # as the seat in a described housing, (I5)
                plane_state=joint.plane_state if joint.housing is None else "plane_stress",
            )
        outer.append(expansion)
    inner = xp.stack([expansions[body] for body in first])
    carrier = expansions[drive.pinned[0]] if drive.pinned else expansions[0]
    if drive.layout.in_frame and housing_expansion is not None:  # the frame is the housing
        carrier = xp.asarray(housing_expansion)
    return interference_of_strains(drive=drive, strains=(inner, xp.stack(outer)), carrier=carrier)


def roller_expansion(joint: Joint) -> Array:
    """Interference that rollers add to each contact which are a kelvin warmer than rings and housing.

    Shape (contacts,) [m/K]. A carrier that turns with the rollers is as warm as they are; one in the frame is not.
    """
    drive, none = joint.drive, xp.zeros(())
    expansions = [
        none if shape.kind == "ring" else xp.asarray(material.thermal_expansion)
        for shape, material in zip(joint.shapes, joint.materials, strict=True)
    ]
    inner, outer = (xp.stack([expansions[body] for body in side]) for side in places(drive))
    carrier = none
    if not drive.layout.in_frame:
        turning = drive.pinned[0] if drive.pinned else 0
        carrier = xp.asarray(joint.materials[turning].thermal_expansion)
    return interference_of_strains(drive=drive, strains=(inner, outer), carrier=carrier)


def contact_fit(
    joint: Joint,
    *,
    assembly_temperature: Real,
    working_temperature: Real,
    housing_expansion: Real | None,
    roller_rise: Real | None = None,
) -> ContactFit:
    """How a drive was assembled, and what temperature does to it.

    ``roller_rise`` of the rollers above rings and housing [K]; None where all bodies have one temperature.
    """
    drive, pattern = joint.drive, xp.asarray(joint.pattern)
    forces = rest_forces(drive=drive, pattern=pattern)
    change = contact_expansion(joint, housing_expansion=housing_expansion)
    assembled = pattern * xp.asarray(joint.interference)
    rollers = None
    if roller_rise is not None:
        of_rollers = roller_expansion(joint)
        added = ring_interference(drive=drive, forces=forces, interference=of_rollers)
        rollers = WarmerRollers(roller_rise, added, of_rollers)
    return ContactFit(
        interference=ring_interference(drive=drive, forces=forces, interference=assembled),
        change_per_kelvin=ring_interference(drive=drive, forces=forces, interference=change),
        assembly_temperature=assembly_temperature,
        working_temperature=working_temperature,
        contact_change_per_kelvin=change,
        warmer_rollers=rollers,
    )


def at_temperatures(joint: Joint, *, housing: Real, rollers: Real) -> Joint:
    """The same joint with its housing and rings at another temperature, and its rollers and their oil [degC]; pure.

    Rollers that are warmer than the housing make interference only where the joint knows what cools it.
    """
    fit, held = joint.fit, joint.housing
    if fit is not None:
        warmer = fit.warmer_rollers
        if warmer is not None:
            warmer = dataclasses.replace(warmer, rise=rollers - housing)
        fit = dataclasses.replace(fit, working_temperature=housing, warmer_rollers=warmer)
    if held is not None and held.assembly_temperature is not None:
        held = dataclasses.replace(held, temperature_rise=housing - held.assembly_temperature)
    rolling = joint.rolling.with_oil_at(rollers + ZERO_CELSIUS)
    return dataclasses.replace(joint, fit=fit, housing=held, rolling=rolling)


def at_temperature(joint: Joint, temperature: float) -> Joint:
    """The same joint, of NumPy's numbers, all of it and its oil at another working temperature [degC]."""
    return as_numbers(at_temperatures(joint, housing=temperature, rollers=temperature))


def assembly_document(
    joint: Joint, at_assembly: Solution | None, limits: tuple[TemperatureLimit, ...]
) -> Document | None:
    """Preload and interference at the assembly, and what temperature does to them, for a JSON document.

    ``limits`` are those of :func:`asperity.joint.temperature_limits.temperature_limits`.
    """
    if joint.fit is None:
        return None
    preload = math.nan
    if at_assembly is not None:
        preload = float(mean_preload(joint, at_assembly.result.rest.normal))
    loose = [limit.temperature for limit in limits if limit.lost in ("interference", "contact")]
    return fit_document(joint.fit, preload, loose[0] if loose else None)


_TEMPERATURES = 41
_LEAST_MARGIN = 20.0  # of the axis beyond the temperatures of the file [K]


class TemperatureCurves(Module):
    """One joint over its working temperature [degC]; shape (n,), nan where it has no value.

    ``preload`` is the normal force of the first contact at rest, the mean of unlike sectors [N], 0 where the joint is
    loose; ``stiffness``, that of the assembly at the output under the joint's torque [N·m/rad];
    ``standing_torque_capacity``, in the direction of its torque [N·m].
    """

    temperature: Array
    preload: Array
    stiffness: Array
    standing_torque_capacity: Array


def temperature_span(assembly: float, working: float) -> tuple[float, float]:
    """Ends of an axis around the temperatures of a file, half their distance beyond them, at least 20 K [degC]."""
    low, high = sorted((assembly, working))
    margin = max(_LEAST_MARGIN, 0.5 * (high - low))
    return low - margin, high + margin


def temperature_curves(joint: Joint, solved_at: Callable[[float], Solution | None]) -> TemperatureCurves:
    """Preload, assembled stiffness and standing torque capacity of a joint at 41 temperatures around those of its file.

    ``solved_at`` gives the solution at a working temperature [degC], None where the joint is loose. An ``InputError``
    is raised if temperature does not change the preload.
    """
    fit = joint.fit
    if fit is None:
        raise InputError(
            "the preload of this joint does not depend on temperature: give load.interference and [temperature]"
        )
    ends = temperature_span(float(fit.assembly_temperature), float(fit.working_temperature))
    temperature = np.linspace(*ends, _TEMPERATURES)
    curves = _of_drive(joint, [solved_at(celsius) for celsius in temperature])
    return TemperatureCurves(*map(xp.asarray, (temperature, *curves)))


def _of_drive(joint: Joint, solutions: list[Solution | None]) -> tuple[np.ndarray, ...]:
    """Preload, assembled stiffness and standing torque capacity, one temperature after the other."""
    torque, rows = float(joint.output_torque), []
    for solution in solutions:
        if solution is None:
            rows.append((0.0, math.nan, math.nan))
            continue
        result = solution.result
        limit = (
            solution.reverse_standing_capacity if torque < 0.0 else solution.standing_capacity
        ).output_torque
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
