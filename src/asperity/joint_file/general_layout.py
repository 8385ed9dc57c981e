"""From the rollers and contacts that a joint file lists to a drive."""

from __future__ import annotations

import math
from typing import Any

from asperity.arrays import namespace
from asperity.drive.layout.closing import closed
from asperity.drive.layout.drive import Body, Closure, Contact, Drive
from asperity.joint.body_shape import BodyShape, ring_shape
from asperity.joint_file.part_names import track_of
from asperity.joint_file.si_tables import Values


def general_layout(values: Values) -> tuple[Drive, tuple[BodyShape, ...], tuple[float, ...]]:
    """The drive that the rollers and contacts of a file make."""
    rollers, contacts, drive = values["roller"].values(), values["contact"].values(), values["drive"]
    xp = namespace(values["roller"], values["contact"], drive)
    housing = values.get("compliance", {}).get("ring_housing_stiffness")
    made = Drive(
        bodies=tuple(Body(roller["name"], roller["place"]) for roller in rollers),
        contacts=tuple(
            Contact(
                each["name"],
                each["first"],
                each["second"],
                internal=bool(each["internal"]),
                sector=int(each["sector"]),
                tracks=(track_of(contacts, each, "first"), track_of(contacts, each, "second")),
            )
            for each in contacts
        ),
        centres=xp.stack([_centre(roller) for roller in rollers]),
        first_radius=xp.stack([xp.asarray(each["first_radius"]) for each in contacts]),
        second_radius=xp.stack([xp.asarray(each["second_radius"]) for each in contacts]),
        push_angles=xp.array(
            [roller.get("push_angle", 0.0) for roller in rollers if roller["place"] == "pin"], dtype=float
        ),
        sectors=drive["sectors"],
        input=drive["input"],
        output=drive["output"],
        grounded=drive["grounded"],
        closure=Closure(
            equal_coefficients=tuple(
                (each["same_coefficient_as"], each["name"])
                for each in contacts
                if "same_coefficient_as" in each
            ),
            constant_pins=tuple(
                roller["name"] for roller in rollers if roller.get("pin_force") == "constant"
            ),
        ),
    )
    return (
        closed(made),
        tuple(_shape(roller, housing) for roller in rollers),
        tuple(1.0 if each["internal"] else 0.0 for each in contacts),
    )


def _centre(roller: Values) -> Any:
    angle = roller.get("angle", 0.5 * math.pi)
    xp = namespace(angle)
    return roller.get("orbit", 0.0) * xp.stack([xp.cos(angle), xp.sin(angle)])


def _shape(roller: Values, housing: Any) -> BodyShape:
    if "wall_thickness" in roller:
        return ring_shape(roller["wall_thickness"], roller.get("ring_support"), housing)
    bore = roller.get("bore_diameter")
    return BodyShape("solid" if bore is None else "hollow", bore, length=roller.get("length"))
