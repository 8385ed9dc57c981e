"""From the tables of a joint file in SI units to a :class:`asperity.joint.description.Joint`."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Collection
from typing import Any, NamedTuple

import numpy as np

from asperity.branches.branches import SectorDeviations
from asperity.drive.bearings import Bearings
from asperity.drive.layout.drive import Drive, speed_ratio
from asperity.drive.layout.drive_type import DriveType
from asperity.drive.layout.expansion import interference_of_sizes
from asperity.drive.stiffness.loading_cam import LoadingCam
from asperity.drive.structure.pin_beam import PinBeam
from asperity.engine.arrays import xp
from asperity.joint.body_shape import BodyShape, Housing, on_pin
from asperity.joint.description import Joint, tracks_of
from asperity.joint.housing import in_housing
from asperity.joint.temperature import contact_fit
from asperity.joint_file.heat import Temperatures, balance_of, temperatures_of, with_steady_temperatures
from asperity.joint_file.material_entries import contact_law_of
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import (
    HOUSING,
    contacts_of,
    drive_type_of,
    paths_of_track,
    size_keys,
    sized_tracks,
    sizes_of_tracks,
)
from asperity.joint_file.parts import layout_of
from asperity.joint_file.roller_profiles import crowns_of
from asperity.joint_file.section_build import (
    alike,
    entries,
    material_of,
    play_of,
    rated_bearing,
    rolling_conditions,
    surface_of,
)
from asperity.joint_file.si_tables import Values, si_values
from asperity.joint_file.tilt_entries import axis_tilts
from asperity.materials import Material
from asperity.types import Array, Document, Real

_SIDES = ("first_radius", "second_radius")


def joint_from_case(case: Case) -> Joint:
    """The joint that a file describes, in SI units."""
    return joint_from_values(si_values(case))


def joint_from_values(values: Values) -> Joint:
    """The joint of nested tables of SI numbers; a function of its leaves that can be differentiated.

    Tables as :func:`asperity.joint_file.si_tables.si_values` makes them. Where they say what cools the drive, the joint
    is at the temperatures that it settles at.
    """
    return joint_at_temperatures(with_steady_temperatures(values, joint_at_temperatures))


def joint_at_temperatures(values: Values) -> Joint:
    """As :func:`joint_from_values`, at temperatures that are known; those around a drive that is cooled otherwise."""
    temperatures = temperatures_of(values)
    kind = drive_type_of(values)
    drive, shapes, pattern = layout_of(_nominal_contacts(values))
    shapes = _on_pins(values.get("bearings", {}), drive, shapes)
    load, model, springs = values["load"], values["model"], values.get("compliance", {})
    names, cam = contacts_of(values), load.get("cam_force_per_torque")
    surfaces = alike(entries(values["surface"], names))
    law = contact_law_of(surfaces, stated=model.get("contact_law"))
    rings = pattern
    if "nominal" in values:  # the rings have their nominal radii, whatever the rollers have
        pattern = tuple(xp.asarray(pattern) + _grown(values, drive) / load["interference"])
    materials = {name: material_of(entry) for name, entry in values["materials"].items()}
    of_bodies = tuple(materials[values["bodies"][kind.material_key(body.name)]] for body in drive.bodies)
    lengths = entries(values["drive"]["contact_length"], names)
    crowns = crowns_of(kind, values, drive, of_bodies, lengths)
    joint = Joint(
        type=kind.name,
        drive=drive,
        shapes=shapes,
        materials=of_bodies,
        surfaces=tuple(
            surface_of(entry, asperity_base=model["asperity_base"], contact_law=law) for entry in surfaces
        ),
        contact_lengths=lengths,
        friction_coefficients=entries(load["friction_coefficient"], names),
        pattern=pattern,
        preload=load.get("preload"),
        interference=load.get("interference"),
        output_torque=load["output_torque"],
        input_speed=load["sun_speed"]
        if "sun_speed" in load
        else load["output_speed"] * abs(speed_ratio(drive)),
        pin_stiffness=springs.get("pin_stiffness"),
        input_shaft_stiffness=springs.get("input_shaft_stiffness", math.inf),
        output_shaft_stiffness=springs.get("output_shaft_stiffness", math.inf),
        contact_factor_model=model["contact_factor"],
        body_model=model.get("bodies", "exact"),
        plane_state=model.get("plane_state", "plane_strain"),
        closure_springs=model.get("closure_springs"),
        carrier_balance=model.get("carrier_balance", "complete"),
        pin_transverse_stiffness=springs.get("pin_transverse_stiffness"),
        planet_support_stiffness=springs.get("planet_support_stiffness"),
        ring_bending_stiffness=springs.get("ring_bending_stiffness"),
        pressing_stiffness=None
        if kind.pressing_stiffness is None
        else kind.pressing_stiffness(values["drive"]),
        rolling=rolling_conditions(values, None if temperatures is None else temperatures.rollers),
        bearings=_bearings(kind, values.get("bearings")),
        pin=_pin(values.get("bearings", {})),
        pin_clearance=values.get("bearings", {}).get("pin_radial_clearance", 0.0),
        pin_clearance_stated="pin_radial_clearance" in values.get("bearings", {}),
        play=play_of(values),
        pin_bearing=rated_bearing(values.get("pin_bearing")),
        input_bearing=rated_bearing(_called(kind, values).get("input_bearing")),
        output_bearing=rated_bearing(_called(kind, values).get("output_bearing")),
        crown_curvatures=crowns.curvatures,
        logarithmic_crowns=crowns.logarithmic,
        wear_coefficients=_wear_coefficients(kind, values, drive),
        tilts=axis_tilts(values.get("tilt")),
        cam=None if cam is None else LoadingCam(force_per_torque=cam, pattern=rings),
        heat=balance_of(values),
    )
    if "housing" not in values:
        expansion = values.get("temperature", {}).get("housing_expansion")
        return _warmed(joint, values, temperatures, expansion)
    material = materials[values["bodies"][HOUSING]]
    joint = _in_housing(joint, values["housing"], material, temperatures)
    return _warmed(joint, values, temperatures, material.thermal_expansion)


def _warmed(
    joint: Joint, values: Values, temperatures: Temperatures | None, housing_expansion: Real | None
) -> Joint:
    """The joint with what its temperatures do to its interference, where a file states both."""
    if temperatures is None or temperatures.assembly is None or "interference" not in values["load"]:
        return joint
    fit = contact_fit(
        joint,
        assembly_temperature=temperatures.assembly,
        working_temperature=temperatures.housing,
        housing_expansion=housing_expansion,
        roller_rise=temperatures.rollers - temperatures.housing if temperatures.apart else None,
    )
    return dataclasses.replace(joint, fit=fit)


def _in_housing(joint: Joint, entry: Values, material: Material, temperatures: Temperatures | None) -> Joint:
    """A joint in the housing that a file describes."""
    assembly = None if temperatures is None else temperatures.assembly
    housing = Housing(
        material=material,
        outer_radius=0.5 * entry["outer_diameter"],
        interference=entry["interference"],
        friction_coefficient=entry["friction_coefficient"],
        temperature_rise=None
        if temperatures is None or assembly is None
        else temperatures.housing - assembly,
        assembly_temperature=assembly,
    )
    shapes = tuple(
        in_housing(shape, tracks_of(joint, number)[0][0], housing)
        for number, shape in enumerate(joint.shapes)
    )
    return dataclasses.replace(joint, shapes=shapes, housing=housing)


def _wear_coefficients(kind: DriveType, values: Values, drive: Drive) -> tuple[Real, ...] | None:
    """Wear coefficient of each body [1/Pa]; None where the file states none."""
    if "wear" not in values:
        return None
    stated = values["wear"]["coefficient"]
    if not isinstance(stated, dict):
        return (stated,) * len(drive.bodies)
    return tuple(stated[kind.material_key(body.name)] for body in drive.bodies)


def _called(kind: DriveType, entry: Values) -> Values:
    """Tables whose keys of bearings have the names of all types."""
    called = {} if kind.bearings is None else kind.bearings.called
    return {called.get(key, key): value for key, value in entry.items()}


def _bearings(kind: DriveType, entry: Values | None) -> Bearings | None:
    """Friction of the bearings; None for none."""
    if entry is None:
        return None
    stated: Document = _called(kind, entry)
    stated.setdefault("pin_friction_diameter", stated.get("pin_diameter", 0.0))
    return Bearings(**{name: stated.get(name, 0.0) for name in Bearings.number_fields})


def _on_pins(entry: Values, drive: Drive, shapes: tuple[BodyShape, ...]) -> tuple[BodyShape, ...]:
    """What the bodies are, those on pins of a stated diameter with their bores."""
    diameter = entry.get("pin_diameter")
    if diameter is None or (isinstance(diameter, float) and diameter == 0.0):
        return shapes
    names = [body.name for body in drive.bodies]
    radii = dict(zip([contact.first for contact in drive.contacts], drive.first_radius, strict=True))
    radii |= dict(zip([contact.second for contact in drive.contacts], drive.second_radius, strict=True))
    return tuple(
        on_pin(shape, diameter, radii[names[number]]) if number in drive.pinned else shape
        for number, shape in enumerate(shapes)
    )


def _pin(entry: Values) -> PinBeam | None:
    if "pin_length" not in entry:
        return None
    return PinBeam(entry["pin_length"], entry.get("pin_support", "both_ends"), entry.get("pin_diameter", 0.0))


def thermal_change_of(values: Values) -> float:
    """Interference [m] that the temperatures of a file add to that of its drive, whatever makes its preload.

    ``values`` are tables in SI units with temperatures; the expansions of all materials are known.
    """
    values = with_steady_temperatures(values, joint_at_temperatures)
    load = {name: value for name, value in values["load"].items() if name != "preload"}
    fit = joint_at_temperatures(values | {"load": load | {"interference": 1e-5}}).fit
    assert fit is not None
    return float(fit.thermal_change)


def deviations_of(values: Values) -> SectorDeviations:
    """Sizes of the sectors of a joint file, where they differ, with the interference that they add to every contact.

    Equal ones without sections ``[[branch]]``. Tables in SI units.
    """
    drive, *_ = layout_of(values)
    count = len(values.get("branch", ())) or round(float(drive.sectors))
    return SectorDeviations(
        deviations={
            name: np.array(track_deviations, dtype=float)
            for name, track_deviations in _deviations(values, count).items()
        },
        added=np.asarray(added_by_branches(values, count)),
        per_size=np.asarray(_per_size(drive, next(iter(sized_tracks(values).values())))),
        input_support_stiffness=values.get("compliance", {}).get("sun_support_stiffness", math.inf),
    )


def added_by_branches(values: Values, count: int) -> Array:
    """Interference that the sizes of each branch add to its contacts, shape (branches, contacts) [m]; pure."""
    drive, *_ = layout_of(values)
    parts = [
        xp.outer(
            xp.stack([xp.asarray(one, dtype=float) for one in track_deviations]),
            _per_size(drive, sized_tracks(values)[name]),
        )
        for name, track_deviations in _deviations(values, count).items()
    ]
    return xp.sum(xp.stack(parts), axis=0)


def _deviations(values: Values, count: int) -> dict[str, list[Any]]:
    """Names of the tracks → their deviations, one for each branch; 0 without sections ``[[branch]]``."""
    stated: Values = values.get("branch", {})
    entries = [stated.get(str(number), {}) for number in range(1, count + 1)]
    kind, sizes = drive_type_of(values), [drive_type_of(values).deviations(entry) for entry in entries]
    return {name: [size.get(name, 0.0) for size in sizes] for name in kind.sized_tracks(values)}


def _per_size(drive: Drive, sides: Collection[tuple[str, str]]) -> Array:
    """Interference of each contact over the deviation of a radius, shape (contacts,) [-]."""
    first, second = (
        xp.array([1.0 if (contact.name, side) in sides else 0.0 for contact in drive.contacts])
        for side in ("first", "second")
    )
    return interference_of_sizes(drive=drive, first=first, second=second)


class TolerancedTrack(NamedTuple):
    """What a number of a joint file, at a dotted path, does to the interference of the contacts.

    ``per_branch`` tells whether every branch has a part of its own with this size; ``per_size`` is the interference of
    each contact over it, shape (contacts,) [-].
    """

    path: str
    per_branch: bool
    per_size: np.ndarray


def toleranced_tracks(values: Values, paths: tuple[str, ...]) -> list[TolerancedTrack]:
    """What numbers of a joint file do to the interference of its contacts, of those that do."""
    drive, _, pattern = layout_of(values)
    sides_of_track = sized_tracks(values)
    off_axis = {body.name for body in drive.bodies if body.place != "axis"}
    known: list[TolerancedTrack] = []
    seen: set[str] = set()
    for path in paths:
        section, *_, key = path.split(".")
        name = key.removesuffix("_radius")
        if path == "load.interference":
            known.append(TolerancedTrack(path, False, np.asarray(pattern)))
        elif section == "drive" and key.endswith("_radius") and name in size_keys(values):
            parts = [track for track, size in sizes_of_tracks(values).items() if size == name]
            known += [
                TolerancedTrack(path, True, np.asarray(_per_size(drive, sides_of_track[track])))
                for track in parts
            ]
            if not parts:
                sides = drive_type_of(values).sides_of_track(name)
                known.append(TolerancedTrack(path, False, np.asarray(_per_size(drive, sides))))
        elif section == "contact" and key.endswith("_radius") and path not in seen:
            same = paths_of_track(values, path)
            seen.update(same)
            steps = [track_path.split(".") for track_path in same]
            sides = [
                (values["contact"][number]["name"], side.removesuffix("_radius")) for _, number, side in steps
            ]
            body = values["contact"][steps[0][1]][sides[0][1]]
            known.append(TolerancedTrack(path, body in off_axis, np.asarray(_per_size(drive, sides))))
    return known


def with_nominal_sizes(values: Values) -> Values:
    """Tables in which changes of the radii are deviations from their present values."""
    if "interference" not in values["load"]:
        return values
    if "contact" in values:
        radii = {index: {side: entry[side] for side in _SIDES} for index, entry in values["contact"].items()}
    else:
        radii = {name: size for name, size in values["drive"].items() if name.endswith("_radius")}
    return values | {"nominal": radii}


def _nominal_contacts(values: Values) -> Values:
    """Tables whose listed contacts have their nominal radii: those of finished parts need not close a drive."""
    if "nominal" not in values or "contact" not in values:
        return values
    nominal = values["nominal"]
    return values | {"contact": {index: entry | nominal[index] for index, entry in values["contact"].items()}}


def _grown(values: Values, drive: Drive) -> Array:
    """Interference of each contact that the deviations of finished parts from their nominal sizes add, [m]."""
    if "contact" in values:
        first, second = (
            xp.stack(
                [entry[side] - values["nominal"][index][side] for index, entry in values["contact"].items()]
            )
            for side in _SIDES
        )
        return interference_of_sizes(drive=drive, first=first, second=second)
    nominal, *_ = layout_of(values | {"drive": values["drive"] | values["nominal"]})
    if not drive_type_of(values).layout(values["drive"]).radii:  # the file states the radii of all tracks
        return interference_of_sizes(
            drive=drive,
            first=drive.first_radius - nominal.first_radius,
            second=drive.second_radius - nominal.second_radius,
        )
    inside = xp.array([contact.internal for contact in drive.contacts])
    return xp.where(inside, drive.second_radius - nominal.second_radius, 0.0)
