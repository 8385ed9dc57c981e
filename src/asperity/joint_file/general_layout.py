"""From the rollers and contacts that a joint file lists to a drive."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator
from typing import Any

from asperity.arrays import namespace
from asperity.drive.layout.closing import closed
from asperity.drive.layout.drive import CARRIER, Body, Closure, Contact, Drive
from asperity.joint.body_shape import BodyShape, ring_shape
from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.messages import nearest
from asperity.joint_file.part_names import track_of
from asperity.joint_file.si_tables import Values


def misdescribed(case: GeneralCase) -> Iterator[str]:
    """Messages about rollers and contacts that do not fit together."""
    rollers = [roller.name for roller in case.roller]
    for what, names in (("roller", rollers), ("contact", [contact.name for contact in case.contact])):
        yield from (
            f"{what}: there is more than one '{n}'" for n, count in Counter(names).items() if count > 1
        )
    if CARRIER in rollers:
        yield f"roller: '{CARRIER}' is the name of the member that carries the pins"
    for contact in case.contact:
        for side in ("first", "second"):
            name = getattr(contact, side)
            if name not in rollers:
                yield f"contact {contact.name}: {side}: there is no roller '{name}'{nearest(name, rollers)}"
    yield from _unlike_crowns(case)
    yield from _misassumed(case)
    rings = {contact.second for contact in case.contact if contact.internal}
    touched = {name for contact in case.contact for name in (contact.first, contact.second)}
    for roller in case.roller:
        if roller.name not in touched:
            yield f"roller {roller.name}: it has no contact"
        if (roller.orbit is None) != (roller.place == "axis"):
            verb = "must not have" if roller.place == "axis" else "needs"
            yield f"roller {roller.name}: place = '{roller.place}' {verb} an orbit"
        if (roller.name in rings) != (roller.wall_thickness is not None):
            verb = "needs" if roller.name in rings else "is no ring and must not have"
            yield f"roller {roller.name}: it {verb} a wall_thickness"
        if roller.push_angle is not None and roller.place != "pin":
            yield f"roller {roller.name}: push_angle is for rollers on a pin"
    sized = [roller.name for roller in case.roller if roller.place != "axis"]
    for number, branch in enumerate(case.branch or (), start=1):
        for name in branch.deviation or ():
            if name not in sized:
                has = "; a sector has " + ", ".join(sized)
                why = f"there is no such roller{nearest(name, sized) or has}"
                if name in rollers:
                    why = f"it is on the axis, common to all{has}"
                yield f"branch.{number}.deviation.{name}: {why}"
    members = [*(roller.name for roller in case.roller if roller.place == "axis"), CARRIER]
    roles = {role: getattr(case.drive, role) for role in ("input", "output", "grounded")}
    for role, name in roles.items():
        if name not in members:
            yield f"drive.{role}: '{name}' is neither a roller on the axis nor the carrier{nearest(name, members)}"
    if len(set(roles.values())) < len(roles):
        yield "drive: input, output and grounded must be three different members"
    if case.drive.grounded != CARRIER and not any(roller.place == "pin" for roller in case.roller):
        yield "drive.grounded: no roller is on a pin, so that nothing turns the carrier; ground it, or use a pin"


def _misassumed(case: GeneralCase) -> Iterator[str]:
    """Assumptions in place of compatibility that cannot be made."""
    names = [contact.name for contact in case.contact]
    others = [contact.same_coefficient_as for contact in case.contact]
    for contact, other in zip(case.contact, others, strict=True):
        if other is None:
            continue
        key = f"contact {contact.name}: same_coefficient_as"
        if other == contact.name or other not in names:
            yield f"{key}: there is no other contact '{other}'{nearest(other, set(names) - {contact.name})}"
        elif others[names.index(other)] is not None:
            yield f"{key}: contact '{other}' has that of another contact itself; name the same one in both"
    for roller in case.roller:
        if roller.pin_force is not None and roller.place != "pin":
            yield f"roller {roller.name}: pin_force is for rollers on a pin"


def _unlike_crowns(case: GeneralCase) -> Iterator[str]:
    """Contacts that say of a track what another contact on it does not."""
    stated: dict[tuple[str, str], tuple[str, float | None]] = {}
    for contact in case.contact:
        for side in ("first", "second"):
            radius, crown = (getattr(contact, f"{side}_{name}") for name in ("radius", "crown_radius"))
            track = getattr(contact, side), f"{radius.value:.12g}"
            own = contact.name, None if crown is None else crown.value
            other = stated.setdefault(track, own)
            if own[1] != other[1]:
                yield (
                    f"contact {contact.name}: {side}_crown_radius: contact {other[0]} says something else of the same "
                    f"track of {track[0]}; a track has one crown: give it in every contact of the track, or in none"
                )


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
