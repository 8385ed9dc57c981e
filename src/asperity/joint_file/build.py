"""From the tables of a joint file in SI units to a :class:`asperity.joint.description.Joint`."""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Mapping
from typing import Any

import jax.numpy as jnp
import numpy as np

from asperity.drive.assembly import IDEAL_STRUCTURE, StructureSprings
from asperity.drive.geometry import DriveGeometry, triangle
from asperity.drive.interference import interference_of_sizes
from asperity.drive.mechanism import Bearings, rest_state
from asperity.errors import InputError
from asperity.joint.branch_results import UnequalBranches
from asperity.joint.branch_sizes import BranchSizes
from asperity.joint.description import Bodies, Crowns, Fit, Joint, PinBeam
from asperity.joint.interference import joint_preload
from asperity.joint.temperature import thermal_interference
from asperity.joint_file.material_build import material_of, surface_of
from asperity.joint_file.part_names import contacts_of
from asperity.joint_file.section_build import entries, play_of, rated_bearing, rolling_conditions
from asperity.joint_file.si_tables import Values, check_values, replace_values, si_values
from asperity.joint_file.wedge_model import Case
from asperity.types import Real


def joint_from_case(case: Case) -> Joint:
    """The joint that a file describes.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    Joint
        In SI units.
    """
    return joint_from_values(si_values(case))


def with_values(case: Case, changes: Mapping[str, Any]) -> Joint:
    """The joint that a file describes, with some of its numbers replaced by others or by arrays of them.

    Parameters
    ----------
    case : Case
        The joint file.
    changes : mapping
        Dotted path → SI number or array, see :func:`asperity.joint_file.si_tables.replace_values`. Arrays broadcast
        against each other and become the batch axes of the joint.

    Returns
    -------
    Joint
        One joint, or many along trailing batch axes.

    Raises
    ------
    InputError
        If there is no such number, or a value is outside its range.
    """
    check_values(changes)
    return joint_from_values(replace_values(si_values(case), changes))


def joint_from_values(values: Values) -> Joint:
    """The joint of nested tables of SI numbers; a function of its leaves that can be differentiated.

    Parameters
    ----------
    values : dict
        Tables as :func:`asperity.joint_file.si_tables.si_values` makes them; leaves may be arrays. Without ``bearings``
        there is no bearing friction, without ``play`` no play, without ``compliance`` the structure is
        :data:`asperity.drive.assembly.IDEAL_STRUCTURE`; rollers without a length are as long as the longest contact
        line on them.

    Returns
    -------
    Joint
        In SI units.
    """
    drive, load, model = values["drive"], values["load"], values["model"]
    bearings, compliance = values.get("bearings", {}), values.get("compliance", {})
    materials = {name: material_of(entry) for name, entry in values["materials"].items()}
    names = contacts_of(values)
    lengths = entries(drive["contact_length"], names)
    joint = Joint(
        geometry=DriveGeometry(
            sun_radius=drive["sun_radius"],
            planet_radius=drive["planet_radius"],
            loading_roller_radius=drive["loading_roller_radius"],
            ring_radius=drive["ring_radius"],
            planet_count=drive["planets"],
            left_push_angle=drive["left_push_angle"],
            right_push_angle=drive["right_push_angle"],
        ),
        bodies=Bodies(**{body: materials[name] for body, name in values["bodies"].items()}),
        surfaces=tuple(
            surface_of(entry, asperity_base=model["asperity_base"])
            for entry in entries(values["surface"], names)
        ),
        contact_lengths=lengths,
        friction_coefficients=entries(load["friction_coefficient"], names),
        planet_length=drive.get("planet_length", _longest(lengths[:3])),
        loading_roller_length=drive.get("loading_roller_length", _longest(lengths[1:] or lengths)),
        ring_wall_thickness=drive["ring_wall_thickness"],
        bearings=Bearings(
            sun_torque=bearings.get("sun_torque", 0.0),
            loading_roller_torque=bearings.get("loading_roller_torque", 0.0),
            carrier_torque=bearings.get("carrier_torque", 0.0),
            pin_friction_coefficient=bearings.get("pin_friction_coefficient", 0.0),
            pin_diameter=bearings.get("pin_diameter", 0.0),
        ),
        preload=load.get("preload", load.get("interference")),
        output_torque=load["output_torque"],
        sun_speed=load["sun_speed"],
        structure=StructureSprings(
            **{name: compliance.get(name, ideal) for name, ideal in vars(IDEAL_STRUCTURE).items()}
        ),
        play=play_of(values),
        closure=model["closure"],
        closure_springs=model["closure_springs"],
        contact_factor_model=model["contact_factor"],
        body_model=model.get("bodies", "exact"),
        plane_state=model.get("plane_state", "plane_strain"),
        ring_support=drive.get("ring_support"),
        planet_bore=drive.get("planet_bore_diameter"),
        loading_roller_bore=drive.get("loading_roller_bore_diameter"),
        crowns=_crowns(drive),
        rolling=rolling_conditions(values),
        pin=_pin(bearings),
        pin_bearing=rated_bearing(values.get("pin_bearing")),
        sun_bearing=rated_bearing(values.get("sun_bearing")),
        carrier_bearing=rated_bearing(values.get("carrier_bearing")),
        cam_force_per_torque=load.get("cam_force_per_torque"),
    )
    if "interference" not in load:
        return joint
    assembled = load["interference"] + _too_large(values, joint)
    if "temperature" not in values:
        return dataclasses.replace(joint, preload=joint_preload(joint, assembled))
    fit = _fit(values["temperature"], joint, assembled)
    working = joint_preload(joint, fit.interference + fit.thermal_change)
    return dataclasses.replace(joint, preload=working, fit=fit)


def _crowns(drive: Values) -> Crowns | None:
    """Curvatures of the crowns; None where no roller is crowned."""
    radii = {body: drive.get(f"{body}_crown_radius") for body in _ROLLING}
    if all(radius is None for radius in radii.values()):
        return None
    return Crowns(**{body: 0.0 if radius is None else 1.0 / radius for body, radius in radii.items()})


def _fit(temperature: Values, joint: Joint, interference: Real) -> Fit:
    """How the drive was assembled, and what temperature does to it."""
    return Fit(
        interference=interference,
        change_per_kelvin=thermal_interference(
            joint, temperature_rise=1.0, housing_expansion=temperature.get("housing_expansion")
        ),
        assembly_temperature=temperature["assembly"],
        working_temperature=temperature["working"],
    )


def with_nominal_sizes(values: Values) -> Values:
    """Tables in which changes of the radii are deviations from their present values.

    Parameters
    ----------
    values : dict
        Tables in SI units.

    Returns
    -------
    dict
        Tables of which :func:`joint_from_values` adds the deviations to the interference, as those of finished parts;
        unchanged where the preload is stated as a force. Without this, changed radii are those of another drive with
        the same interference.
    """
    if "interference" not in values["load"]:
        return values
    nominal = {f"{name}_radius": values["drive"][f"{name}_radius"] for name in _ROLLING}
    return values | {"nominal": nominal}


_ROLLING = ("sun", "planet", "loading_roller", "ring")


def _too_large(values: Values, joint: Joint) -> Real:
    """Interference by the deviations of the radii from their nominal values."""
    if "nominal" not in values:
        return 0.0
    sizes = values["nominal"]
    geometry = joint.geometry
    nominal = dataclasses.replace(geometry, **sizes)
    sun, planet, roller, ring = (
        getattr(geometry, f"{name}_radius") - sizes[f"{name}_radius"] for name in _ROLLING
    )
    rest = rest_state(geometry=nominal, sides=triangle(nominal), preload=1.0)
    return interference_of_sizes(
        rest=rest, sun=sun, planet=planet, right_roller=roller, left_roller=roller, ring=ring
    )


def branches_from_case(case: Case) -> tuple[float, BranchSizes]:
    """The branches of a joint file by their own sizes; equal ones without sections ``[[branch]]``.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    interference : float
        Nominal interference at the working temperature [m].
    sizes : BranchSizes
        Deviations of the branches, and the bearings of the sun.

    Raises
    ------
    InputError
        If the preload is a force, which sizes do not change.
    """
    if case.load.interference is None:
        raise InputError(
            "sizes of branches make no preload that a spring holds: give load.interference in place of load.preload"
        )
    values = si_values(case)
    equal: Values = {str(index): {} for index in range(round(case.drive.planets.value))}
    entries = list(values.get("branch", equal).values())
    planet, right, left = (
        np.array([entry.get(f"{name}_deviation", 0.0) for entry in entries])
        for name in ("planet", "right_roller", "left_roller")
    )
    support = values.get("compliance", {}).get("sun_support_stiffness", math.inf)
    fit = joint_from_values(values).fit
    nominal = values["load"]["interference"] if fit is None else float(fit.interference + fit.thermal_change)
    return nominal, BranchSizes(planet, right, left, support)


def unequal_branches(case: Case, joint: Joint) -> UnequalBranches | None:
    """What the sections ``[[branch]]`` of a joint file do to its joint.

    Parameters
    ----------
    case : Case
        The joint file.
    joint : Joint
        Its joint.

    Returns
    -------
    UnequalBranches or None
        None where there are no such sections.
    """
    if case.branch is None:
        return None
    from asperity.joint.branch_bearings import with_duty
    from asperity.joint.branch_limits import refuse_beyond
    from asperity.joint.branches import BranchedJoint

    interference, sizes = branches_from_case(case)
    found = BranchedJoint(joint, interference).branches(sizes)
    refuse_beyond(found, float(joint.output_torque))
    return with_duty(found, joint, lambda there: BranchedJoint(there, interference).working(sizes))


def _pin(bearings: Values) -> PinBeam | None:
    if "pin_length" not in bearings:
        return None
    return PinBeam(bearings["pin_length"], bearings.get("pin_support", "both_ends"))


def _longest(lengths: tuple[Real, ...]) -> Real:
    if all(isinstance(length, float) for length in lengths):
        return max(lengths)
    return functools.reduce(jnp.maximum, lengths)
