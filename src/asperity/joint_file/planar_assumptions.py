"""What a joint file with a planar drive leaves out, and what is assumed instead."""

from __future__ import annotations

from typing import Any

from asperity.joint.planar.rims import bends
from asperity.joint_file.assumptions import (
    CROWNED,
    LOADING_CAM,
    fatigue_unknown,
    lubrication_assumptions,
    rolling_assumptions,
    temperature_assumptions,
)
from asperity.joint_file.drawn_surface import depth_assumptions
from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.planar_model import PlanarCase

_STEPPED = {"multiroller": "the rollers of both rows", "stepped_planet": "the planets"}


def planar_assumptions(case: PlanarCase) -> tuple[str, ...]:
    """What a joint file leaves out, and what is taken instead.

    Parameters
    ----------
    case : PlanarCase
        The joint file.

    Returns
    -------
    tuple of str
        One sentence each.
    """
    kind = case.type
    drive: Any = case.drive  # type: ignore[attr-defined]
    told = ["every track is as long as its longest contact line"]
    if case.bearings is None:
        told.append("no section [bearings]: the bearings have no friction")
    else:
        told.append(
            "[bearings]: their friction opposes the rotation, in the drive that stands too; where the input has no "
            "speed it opposes the sense of the torque"
        )
    if case.play is None:
        told.append("no section [play]: the output has no play")
    if case.compliance is None:
        told.append("no section [compliance]: pins and shafts are rigid")
    else:
        absent = [
            name for name, value in case.compliance if value is None and name != "sun_support_stiffness"
        ]
        if absent:
            told.append(f"[compliance] without {', '.join(absent)}: rigid")
    if isinstance(case, GeneralCase):
        told.append(
            "the rollers lie where all contacts just touch, as near as possible to the places of the file"
        )
        told.append("the tracks of a stepped roller lie in one plane, and are one spring for each contact")
        told += [
            f"contact {contact.name}: same_coefficient_as = '{contact.same_coefficient_as}': equal traction "
            "coefficients in place of the slip of springs, while the drive stands; the first contact that slips then "
            "ends it, and with springs one may slip earlier"
            for contact in case.contact
            if contact.same_coefficient_as is not None
        ]
        told += [
            f"roller {roller.name}: pin_force = 'constant': a soft spring moves the pin and keeps its force"
            for roller in case.roller
            if roller.pin_force is not None
        ]
    elif drive.ring_support is None:
        told.append("no drive.ring_support: a rigid housing holds the outer rim of the ring")
    if kind in _STEPPED:
        told.append(
            f"the tracks of {_STEPPED[kind]} lie in one plane: arrange them symmetrically, or their bearings carry the "
            "tilting moment; for their compression stepped rollers are one spring for each contact"
        )
    if kind == "stepped_planet":
        told.append("both rings have the interference; the driven ring carries itself")
    if case.model.bodies is None:
        told.append("no model.bodies: the bodies by plane elasticity, exact")
    if case.model.bodies != "springs" and case.model.plane_state is None:
        told.append("no model.plane_state: plane strain; plane stress is the bound for thin bodies")
    told.append("standing: forces from the slip of the contacts on one loading from rest")
    told.append(
        "torque capacity, standing: a contact that slips keeps the force of its friction while others carry the rest; "
        "it is the torque beyond which they cannot, or at which a contact lifts off. In rolling: the first gross slip"
    )
    entries = case.surface.values() if isinstance(case.surface, dict) else [case.surface]
    for ranged, which in (
        (True, "middle of its range"),
        (False, "value in the file, which Ra does not confirm"),
    ):
        if any(
            entry.roughness_average is not None and (entry.fractal_dimension.tolerance > 0.0) == ranged
            for entry in entries
        ):
            told.append(
                f"roughness_average: Ra leaves D open, and all results are those of the {which}; 'asperity joint' "
                "gives the interval of stiffness and drift"
            )
    told += depth_assumptions(case)
    if case.load.cam_force_per_torque is not None:
        told.append(LOADING_CAM)
    if case.branch is not None:
        told.append(
            "[[branch]]: every branch is solved by itself, together with the bodies on the axis; rings and carrier are "
            "centred, and what centres a ring that carries itself acts evenly all round; the standing drive is loaded "
            "from rest without torque; all numbers but those of the worst branch, of single branches, of their sums, "
            "of the forces on the members on the axis, of bearings and of rims that bend are of equal ones"
        )
        if case.compliance is None or case.compliance.sun_support_stiffness is None:
            told.append(
                "[[branch]] without compliance.sun_support_stiffness: the input is held rigidly on the axis; a sun "
                "that floats (0) shares the load among the branches"
            )
    told += temperature_assumptions(case, housed=not case.without_housing())
    joint = planar_joint_from_case(case)
    if joint.crown_curvatures is not None:
        told.append(CROWNED)
    told += rolling_assumptions(case.rolling)
    told += lubrication_assumptions(
        case.lubrication,
        materials={name: case.materials[name] for name in dict.fromkeys(case.bodies.values())},
    )
    told += [
        fatigue_unknown(body.name, case.bodies[body.name])
        for body, bent, material in zip(joint.drive.bodies, bends(joint), joint.materials, strict=True)
        if bent and material.fatigue_strength is None
    ]
    return tuple(told)
