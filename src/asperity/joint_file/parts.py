"""From the section [drive] of a joint file to a drive: which bodies and contacts each type has."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Any

from asperity.drive.layout.drive import CARRIER, Closure, Drive
from asperity.drive.layout.drives import (
    EQUAL_COEFFICIENTS,
    SPRING_LOADED_PINS,
    planetary_drive,
    stepped_planet_drive,
    two_row_multiroller,
    wedge_drive,
)
from asperity.drive.wedge.geometry import DriveGeometry
from asperity.joint.body_shape import SOLID, BodyShape, ring_shape
from asperity.joint_file.general_layout import general_layout, misdescribed
from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.messages import closest, nearest
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import CONTACTS, WEDGE_TYPE, material_keys, type_of
from asperity.joint_file.si_tables import Values

#: A drive, what its bodies are, and the share of its interference at each contact.
Layout = tuple[Drive, tuple[BodyShape, ...], tuple[float, ...]]


def misnamed_parts(case: Case) -> list[str]:
    """Messages about tables whose entries are not the bodies or contacts of the drive."""
    kind = case.type
    drive: Any = case.drive
    found: list[str] = []
    if isinstance(case, GeneralCase):
        contacts = tuple(contact.name for contact in case.contact)
        bodies = tuple(roller.name for roller in case.roller)
        found += misdescribed(case)
        if case.pin_bearing is not None and all(roller.place != "pin" for roller in case.roller):
            found.append(
                'pin_bearing: no [[roller]] has place = "pin"; leave the section out, or give the roller its pin'
            )
    else:
        contacts, bodies = tuple(CONTACTS[kind]), material_keys(kind)
    for path, table, known in (
        ("bodies", case.bodies, bodies),
        ("drive.contact_length", drive.contact_length, contacts),
        ("load.friction_coefficient", case.load.friction_coefficient, contacts),
        ("rolling.skew", None if case.rolling is None else case.rolling.skew, contacts),
        ("surface", case.surface, contacts),
    ):
        if isinstance(table, dict):
            found += [
                f"{path}.{name}: a {kind} drive has no such {'body' if path == 'bodies' else 'contact'}"
                f"{nearest(name, known) or '; it has ' + ', '.join(known)}"
                for name in table
                if name not in known
            ]
            meant = {closest(name, known) for name in table if name not in known}
            missing = [name for name in known if name not in table and name not in meant]
            if missing:
                instead = "; write one [surface] for all contacts, or a section for each"
                found.append(
                    f"{path}: {', '.join(missing)} {'is' if len(missing) == 1 else 'are'} missing"
                    + (instead if path == "surface" else "")
                )
    return found


def _ring(values: Values) -> BodyShape:
    drive, housing = values["drive"], values.get("compliance", {}).get("ring_housing_stiffness")
    return ring_shape(drive["ring_wall_thickness"], drive.get("ring_support"), housing)


def _wedge(values: Values) -> Layout:
    drive, model = values["drive"], values["model"]
    made = wedge_drive(
        DriveGeometry(
            **{name: drive[name] for name in _WEDGE_SIZES},
            planet_count=drive["planets"],
        ),
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
        sun_radius=drive["sun_radius"],
        planet_radius=drive["planet_radius"],
        planet_count=drive["planets"],
    )
    if drive.get("output") == "ring":
        made = dataclasses.replace(made, output="ring", grounded=CARRIER)
    planet = _roller(drive, "planet")
    return made, (SOLID, planet, _ring(values)), (0.0, 1.0)


def _multiroller(values: Values) -> Layout:
    drive = values["drive"]
    made = two_row_multiroller(
        sun_radius=drive["sun_radius"],
        first_row_radii=(drive["first_row_radius"], drive["first_row_small_radius"]),
        second_row_radii=(drive["second_row_radius"], drive["second_row_small_radius"]),
        roller_count=drive["rollers_per_row"],
    )
    return made, (SOLID, SOLID, SOLID, _ring(values)), (0.0, 0.0, 0.0, 1.0)


def _stepped_planet(values: Values) -> Layout:
    drive = values["drive"]
    made = stepped_planet_drive(
        sun_radius=drive["sun_radius"],
        planet_radii=(drive["planet_radius"], drive["planet_second_radius"]),
        planet_count=drive["planets"],
    )
    rings = _ring(values), BodyShape("ring", drive["driven_ring_wall_thickness"], "free")
    return made, (SOLID, SOLID, *rings), (0.0, 1.0, 1.0)


_LAYOUTS: dict[str, Callable[[Values], Layout]] = {
    WEDGE_TYPE: _wedge,
    "planetary": _planetary,
    "multiroller": _multiroller,
    "stepped_planet": _stepped_planet,
    "planar": general_layout,
}


def layout_of(values: Values) -> Layout:
    """The drive that the tables of a joint file describe.

    Parameters
    ----------
    values : dict
        Tables in SI units, with their ``type``.

    Returns
    -------
    Drive, tuple of BodyShape, tuple of float
        The drive, what each body is, and the interference of each contact over that of the drive.
    """
    return _LAYOUTS[type_of(values)](values)
