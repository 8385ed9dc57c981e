"""From the section [drive] of a joint file to a drive: which bodies and contacts each type has."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

from asperity.drive.layout.closing import closed
from asperity.drive.layout.drive import CARRIER, Body, Closure, Contact, Drive
from asperity.drive.layout.drives import (
    EQUAL_COEFFICIENTS,
    SPRING_LOADED_PINS,
    planetary_drive,
    stepped_planet_drive,
    two_row_multiroller,
    wedge_drive,
)
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.engine.arrays import xp
from asperity.joint.body_shape import SOLID, BodyShape, ring_shape
from asperity.joint_file.part_names import WEDGE_TYPE, track_of, type_of
from asperity.joint_file.si_tables import Values


def general_layout(values: Values) -> tuple[Drive, tuple[BodyShape, ...], tuple[float, ...]]:
    """The drive that the rollers and contacts of a file make."""
    rollers, contacts, drive = values["roller"].values(), values["contact"].values(), values["drive"]
    housing = values.get("compliance", {}).get("ring_housing_stiffness")
    made = Drive(
        bodies=tuple(Body(roller["name"], roller["place"]) for roller in rollers),
        contacts=tuple(
            Contact(
                contact["name"],
                contact["first"],
                contact["second"],
                internal=bool(contact["internal"]),
                sector=int(contact["sector"]),
                tracks=(track_of(contacts, contact, "first"), track_of(contacts, contact, "second")),
            )
            for contact in contacts
        ),
        centres=xp.stack([_centre(roller) for roller in rollers]),
        first_radius=xp.stack([xp.asarray(contact["first_radius"]) for contact in contacts]),
        second_radius=xp.stack([xp.asarray(contact["second_radius"]) for contact in contacts]),
        push_angles=xp.array(
            [roller.get("push_angle", 0.0) for roller in rollers if roller["place"] == "pin"], dtype=float
        ),
        sectors=drive["sectors"],
        input=drive["input"],
        output=drive["output"],
        grounded=drive["grounded"],
        closure=Closure(
            equal_coefficients=tuple(
                (contact["same_coefficient_as"], contact["name"])
                for contact in contacts
                if "same_coefficient_as" in contact
            ),
            constant_pins=tuple(
                roller["name"] for roller in rollers if roller.get("pin_force") == "constant"
            ),
        ),
    )
    return (
        closed(made),
        tuple(_shape(roller, housing) for roller in rollers),
        tuple(1.0 if contact["internal"] else 0.0 for contact in contacts),
    )


def _centre(roller: Values) -> Any:
    angle = roller.get("angle", 0.5 * math.pi)
    return roller.get("orbit", 0.0) * xp.stack([xp.cos(angle), xp.sin(angle)])


def _shape(roller: Values, housing: Any) -> BodyShape:
    if "wall_thickness" in roller:
        ring = ring_shape(roller["wall_thickness"], roller.get("ring_support"), housing)
        return dataclasses.replace(ring, length=roller.get("length"))
    bore = roller.get("bore_diameter")
    return BodyShape("solid" if bore is None else "hollow", bore, length=roller.get("length"))


#: A drive, what its bodies are, and the share of its interference at each contact.
Layout = tuple[Drive, tuple[BodyShape, ...], tuple[float, ...]]


def _ring(values: Values) -> BodyShape:
    drive, housing = values["drive"], values.get("compliance", {}).get("ring_housing_stiffness")
    return ring_shape(drive["ring_wall_thickness"], drive.get("ring_support"), housing)


def _wedge(values: Values) -> Layout:
    drive, model = values["drive"], values["model"]
    made = wedge_drive(
        DriveGeometry(**{name: drive[name] for name in _WEDGE_SIZES}, planet_count=drive["planets"]),
        planet_count=drive["planets"],
        closure=Closure(
            equal_coefficients=EQUAL_COEFFICIENTS
            if model.get("traction_split") == "equal_coefficients"
            else (),
            constant_pins=SPRING_LOADED_PINS if model["closure"] == "constant_pin_force" else (),
        ),
    )
    planet, roller = (_roller(drive, name) for name in ("planet", "loading_roller"))
    return made, (SOLID, planet, roller, roller, _ring(values)), (0.0, 0.0, 0.0, 1.0, 1.0)


_WEDGE_SIZES = (
    *(f"{name}_radius" for name in ("sun", "planet", "loading_roller", "ring")),
    "left_push_angle",
    "right_push_angle",
)


def _roller(drive: Values, name: str) -> BodyShape:
    bore = drive.get(f"{name}_bore_diameter")
    return BodyShape("solid" if bore is None else "hollow", bore, length=drive.get(f"{name}_length"))


def _planetary(values: Values) -> Layout:
    drive = values["drive"]
    made = planetary_drive(
        sun_radius=drive["sun_radius"], planet_radius=drive["planet_radius"], planet_count=drive["planets"]
    )
    if drive.get("output") == "ring":
        made = dataclasses.replace(made, output="ring", grounded=CARRIER)
    return made, (SOLID, _roller(drive, "planet"), _ring(values)), (0.0, 1.0)


def _multiroller(values: Values) -> Layout:
    drive = values["drive"]
    made = two_row_multiroller(
        sun_radius=drive["sun_radius"],
        first_row_radii=(drive["first_row_radius"], drive["first_row_small_radius"]),
        second_row_radii=(drive["second_row_radius"], drive["second_row_small_radius"]),
        roller_count=drive["rollers_per_row"],
    )
    rows = (_roller(drive, name) for name in ("first_row", "second_row"))
    return made, (SOLID, *rows, _ring(values)), (0.0, 0.0, 0.0, 1.0)


def _stepped_planet(values: Values) -> Layout:
    drive = values["drive"]
    made = stepped_planet_drive(
        sun_radius=drive["sun_radius"],
        planet_radii=(drive["planet_radius"], drive["planet_second_radius"]),
        planet_count=drive["planets"],
    )
    rings = _ring(values), BodyShape("ring", drive["driven_ring_wall_thickness"], "free")
    return made, (SOLID, _roller(drive, "planet"), *rings), (0.0, 1.0, 1.0)


_LAYOUTS: dict[str, Callable[[Values], Layout]] = {
    WEDGE_TYPE: _wedge,
    "planetary": _planetary,
    "multiroller": _multiroller,
    "stepped_planet": _stepped_planet,
    "planar": general_layout,
}


def layout_of(values: Values) -> Layout:
    """The drive of tables in SI units, what its bodies are, and the interference of each contact over its own."""
    return _LAYOUTS[type_of(values)](values)
