"""The answer about one joint: the document of ``asperity joint``, the drawing, the wind-up and the curves."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from asperity.drive.layout.drive import sector_rotation
from asperity.errors import AsperityError
from asperity.joint.description import Joint, places, tracks_of
from asperity.joint.evaluation import JointResult
from asperity.joint.housing import ring_fit, seated
from asperity.joint_file.choices import choices_of_case
from asperity.joint_file.edited_text import entered_values
from asperity.joint_file.model import Case
from asperity.joint_file.quantity_key import Key
from asperity.joint_file.si_tables import numeric_keys
from asperity.joint_file.solved_document import solve_with_surface
from asperity.joint_file.stated_parts import made_interference
from asperity.page.description import form_of
from asperity.page.joint_request import JointRequest
from asperity.page.list_changes import stated_lists
from asperity.results.solved import SolvedJoint
from asperity.results.windup_document import windup_columns
from asperity.rolling.curves import creep_curves
from asperity.show.free_bodies import BodyForce, body_forces, drawn_apart
from asperity.show.section_view import drive_section
from asperity.standing.standing import torque_curves
from asperity.standing.windup import windup
from asperity.types import Document
from asperity.units import from_si
from asperity.views.screens import page_views
from asperity.views.solved_view import SolvedView

Answer = Document

#: Even steps of the wind-up in each direction: half as many as elsewhere, so that the page answers sooner.
_WINDUP_STEPS = 20


def joint_answer(request: JointRequest) -> Answer:
    """Everything that the page shows of one joint."""
    case = request.case()
    solved, document = solve_with_surface(request.solved_case())
    made = made_interference(request.solved_case(), solved.result).size
    return {
        "id": request.identity,
        "name": request.name,
        **stated_values(case, request.file_tables),
        "document": document,
        "views": page_views(SolvedView(solved, document, made)),
        "drawing": drive_shapes(solved.joint, solved.result) | {"made_interference_m": made},
        "curves": _curves(solved),
        "creep": _creep(solved),
        "windup": _windup(solved),
    }


def stated_values(case: Case, tables: Mapping[str, Any]) -> Answer:
    """What a joint file states, in its tables without changes, for the fields of the page.

    ``numbers``: dotted path → value in the unit of display, and in SI; ``entered``: the same, with their texts, for
    numbers that no study varies, an Rz and the shares of a duty; ``lists`` of sections, see
    :func:`asperity.page.list_changes.stated_lists`; ``choices``: dotted path → word, empty where the file leaves it
    out; ``form``: what can be set in a file with this type of drive.
    """
    choices = {}
    for path in choices_of_case(case):
        section, key = path.split(".")
        above = getattr(case, section)
        word = above.get(key) if isinstance(above, dict) else getattr(above, key, None)
        choices[path] = word or ""
    return {
        "form": form_of(case),
        "numbers": {path: _number(entry, entry.key) for path, entry in numeric_keys(case).items()},
        "entered": {
            path: _number(entry, key) | {"text": entry.text}
            for path, (key, entry) in entered_values(case).items()
        },
        "lists": stated_lists(case, tables),
        "choices": choices,
    }


def _number(entry: Any, key: Key) -> Answer:
    """A number in the unit of display, to 14 digits as conversion makes up the last two, and in SI."""
    shown = float(f"{from_si(entry.value, key.unit):.14g}")
    return {"value": shown, "si": entry.value, "tolerance": entry.tolerance}


def plain_numbers(values: Any) -> list[float | None]:
    """An array as a list for JSON."""
    return [number if math.isfinite(number) else None for number in np.asarray(values, dtype=float).tolist()]


def _curves(solved: SolvedJoint) -> Answer:
    capacity = float(solved.standing_capacity_of_direction.output_torque)
    curves = torque_curves(joint=solved.joint, torque_capacity=capacity)
    return {
        "torque_Nm": plain_numbers(curves.torque),
        "published_Nm_per_rad": plain_numbers(curves.published),
        "series_with_bulk_Nm_per_rad": plain_numbers(curves.series_with_bulk),
        "assembly_Nm_per_rad": plain_numbers(curves.assembly),
        "drift_rad_per_output_turn": plain_numbers(curves.drift_per_output_turn),
        "efficiency": plain_numbers(curves.efficiency),
        "total_loss_W": plain_numbers(curves.total_loss),
        "life_hours": plain_numbers(curves.life_hours),
        "life_output_turns": plain_numbers(curves.life_turns),
        "largest_slip_ratio": plain_numbers(curves.slip_ratio),
    }


def _creep(solved: SolvedJoint) -> Answer:
    """Creep curve of each contact: traction T/N over creepage."""
    curves = creep_curves(solved.joint, solved.result)
    return {
        name: {"traction": plain_numbers(traction), "creepage": plain_numbers(creepage)}
        for name, traction, creepage in zip(
            solved.result.contact_names, curves.traction, curves.creepage, strict=True
        )
    }


def _windup(solved: SolvedJoint) -> Answer:
    """The loop at the joint's torque, or why there is none."""
    torque = abs(float(solved.joint.output_torque))
    if torque == 0.0:
        return {"unknown_because": "no torque, no wind-up: set an output torque"}
    try:
        curve = windup(solved.joint, largest_torque=torque, level="assembly", steps=_WINDUP_STEPS)
    except AsperityError as error:
        return {"unknown_because": str(error)}
    return {
        "unknown_because": None,
        "hysteresis_rad": float(curve.hysteresis),
        "lost_motion_rad": float(curve.lost_motion),
        "dissipated_energy_J": float(curve.dissipated_energy),
        **{name: plain_numbers(column) for name, column in windup_columns(curve).items()},
    }


def drive_shapes(joint: Joint, result: JointResult) -> Document:
    """Circles of a drive, its section along the axis, and the contact forces of its first sector."""
    drive, centres = joint.drive, np.asarray(joint.drive.centres)
    circles, rings = [], []
    for number, (body, shape) in enumerate(zip(drive.bodies, joint.shapes, strict=True)):
        name = body.name.replace("_", " ")
        radii = [float(radius) for radius, _ in tracks_of(joint, number)]
        if shape.kind == "ring":
            wall = 0.0 if shape.size is None else float(shape.size)
            seat = float(ring_fit(joint, number, working=False).bore_change) if seated(joint)[number] else 0.0
            rings += [
                {"body": name, "inner_radius_m": radius, "wall_m": wall, "bore_change_m": seat}
                for radius in radii
            ]
            continue
        for sector in range(1 if body.on_axis else int(drive.sectors)):
            x, y = sector_rotation(drive, sector) @ centres[number]
            circles += [
                {"body": name, "x_m": float(x), "y_m": float(y), "radius_m": radius}
                for radius in sorted([*radii, *_bore(joint, number)], reverse=True)
            ]
    known = bool(np.all(np.isfinite(np.asarray(result.forces.normal))))
    forces = body_forces(joint, result)
    return {
        "rollers": circles,
        "rings": rings,
        "section": _section(joint),
        "forces": _contact_forces(joint, forces) if known else [],
        "bodies": [_free_body(joint, number, forces) for number in drawn_apart(drive) if known],
    }


def _section(joint: Joint) -> list[Document]:
    """Rectangles of the section along the axis, developed through the contacts; ``cut``: whether they are hatched."""
    return [
        {
            "low_m": 1e-3 * block.low,
            "high_m": 1e-3 * block.high,
            "left_m": 1e-3 * block.left,
            "right_m": 1e-3 * block.right,
            "cut": bool(block.hatched),
        }
        for block in drive_section(joint, 1.0).blocks
    ]


def _bore(joint: Joint, number: int) -> list[float]:
    """Radius of the bore of a hollow roller [m]."""
    bore = joint.shapes[number].bore_diameter
    return [] if bore is None else [0.5 * float(bore)]


def _contact_forces(joint: Joint, forces: list[BodyForce]) -> list[Document]:
    """The forces of each contact on its first body, where they act."""
    centres = np.asarray(joint.drive.centres)
    acting = {(force.name, force.kind, force.body): force for force in forces}
    entries = []
    for k, (contact, number) in enumerate(zip(joint.drive.contacts, places(joint.drive)[0], strict=True)):
        normal, tangential = (acting[contact.name, kind, contact.first] for kind in ("N", "T"))
        x, y = centres[number] + float(joint.drive.first_radius[k]) * np.array(normal.place)
        entries.append(
            {
                "contact": contact.name,
                "on": contact.first.replace("_", " "),
                "x_m": float(x),
                "y_m": float(y),
                "normal_N": _vector(normal),
                "tangential_N": _vector(tangential),
            }
        )
    return entries


def _free_body(joint: Joint, number: int, forces: list[BodyForce]) -> Document:
    """One roller with the forces on it: its tracks and bore, and where around its axis each force acts."""
    body = joint.drive.bodies[number].name
    return {
        "body": body.replace("_", " "),
        "radii_m": [*(float(radius) for radius, _ in tracks_of(joint, number)), *_bore(joint, number)],
        "forces": [
            {
                "name": force.name,
                "kind": {"N": "normal", "T": "tangential", "F": "pin"}[force.kind],
                "radius_m": 0.0 if force.kind == "F" else _track(joint, force),
                "place": list(force.place),
                "force_N": _vector(force),
            }
            for force in forces
            if force.body == body
        ],
    }


def _track(joint: Joint, force: BodyForce) -> float:
    """Radius of the track on which the force of a contact acts [m]."""
    for k, contact in enumerate(joint.drive.contacts):
        if contact.name == force.name:
            mine = joint.drive.first_radius if contact.first == force.body else joint.drive.second_radius
            return float(mine[k])
    raise KeyError(force.name)


def _vector(force: BodyForce) -> list[float]:
    return [force.size * component for component in force.direction]
