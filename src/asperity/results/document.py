"""A solved joint as one JSON document: SI units, the unit at the end of every key."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterable
from typing import Any

import numpy as np

import asperity
from asperity.drive.state.loads import pin_components
from asperity.drive.stiffness.loading_cam import held_cam_stiffness
from asperity.engine import trees
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.joint.loading_cam import mean_preload
from asperity.joint.pin_bound import bound_document
from asperity.joint.rims import bends
from asperity.joint.solve import Solution
from asperity.joint.temperature import assembly_document
from asperity.joint.temperature_limits import limits_document
from asperity.joint.torque_limits import capacity_document
from asperity.results import SEVERITIES
from asperity.results.all_limits import all_checks
from asperity.results.branch_document import branch_document
from asperity.results.heat_document import heat_document
from asperity.results.limit_check import LimitCheck
from asperity.results.loads_document import bearing_entries, rim_entry
from asperity.results.margins import margins, verdict_document
from asperity.results.notes import Note
from asperity.results.places import in_order, with_rows
from asperity.results.rolling_document import rolling_document
from asperity.results.solved import SolvedJoint
from asperity.results.torque_capacity import torque_capacity_document
from asperity.surface.roughness_average import corresponding_average, standard_cut_off
from asperity.types import Document
from asperity.units import format_apart, format_quantity

#: Below this share of the compliance a spring is only the rounding of the others.
NO_SHARE = 1e-12

#: What the joint that turns and the whole document both have, where readers look first.
_IN_ROLLING = ("speed_loss", "drift_rad_per_output_turn", "efficiency", "losses_W", "life_hours")


_ELASTIC_BODIES = (
    "the springs of a contact include the deformation of its whole bodies, such as the bending of a free ring"
)
_BELOW_ZERO = (
    "a negative share: the other forces on its bodies deflect this spring against its own force; the shares add up to "
    "100 %"
)


def budget_words(shares: Iterable[float | None], *, elastic_bodies: bool) -> str:
    """What the shares of the compliance [-] do not show, without a full stop; empty where they show it all."""
    below = any(share is not None and share < -NO_SHARE for share in shares)
    return "; ".join([_ELASTIC_BODIES] * elastic_bodies + [_BELOW_ZERO] * below)


def crossed_limits(document: Document, *, model: bool) -> list[list[Document]]:
    """Entries of crossed limits, those of the published contact law alone or all others, grouped by name and state."""
    crossed: dict[tuple[str, str], list[Document]] = {}
    for entry in document["diagnostics"]:
        if not entry["ok"] and (entry["severity"] == "model") == model:
            crossed.setdefault((entry["name"], entry.get("state", "")), []).append(entry)
    return list(crossed.values())


def diagnostic_documents(checks: tuple[LimitCheck, ...], notes: tuple[Note, ...]) -> list[Document]:
    """All limits of a joint and all notes on it, the most serious first."""
    entries = [*map(_limit_document, checks), *map(_note_document, notes)]
    for entry in entries:
        value, unit = entry["value"], entry.pop("display_unit")
        entry["infinite"] = math.isinf(value)
        if math.isfinite(value):
            entry["shown"], entry["limit_shown"] = format_apart(value, entry["limit"], unit)
        else:
            entry["shown"] = "infinite" if entry["infinite"] else "not known"
            entry["limit_shown"] = format_quantity(entry["limit"], unit)
    return sorted(entries, key=lambda entry: SEVERITIES.index(entry["severity"]))


def _limit_document(entry: LimitCheck) -> Document:
    """Value, limit and words of one limit of a joint, kept or crossed."""
    return {
        "name": entry.result.name,
        "label": entry.result.label,
        "contact": entry.contact,
        "value": entry.value,
        "limit": entry.limit,
        "ok": entry.ok,
        "known": entry.known,
        "severity": entry.rule.severity,
        "state": "" if entry.ok else entry.rule.state,
        "meaning": entry.meaning,
        "remedy": None if entry.ok or math.isnan(entry.value) else entry.rule.remedy,
        "unit": entry.result.si_unit,
        "display_unit": entry.result.display_unit,
    }


def _note_document(note: Note) -> Document:
    words = dataclasses.asdict(note)
    del words["used"], words["upper"]
    return words | {"known": not math.isnan(note.value), "unit": words.pop("dimension").si_unit}


def stiffness_unknown_because(result: JointResult) -> str | None:
    """Why a joint has no stiffness."""
    if bool(result.contact_law_holds):
        return None
    normal, elastic = np.asarray(result.forces.normal), np.asarray(result.contacts.normal_stiffness)
    plastic = [
        name for name, force, k in zip(result.contact_names, normal, elastic, strict=True) if force > 0.0 >= k
    ]
    return (
        f"every spot of {', '.join(plastic)} is plastic, and the contact law then has no stiffness; real surfaces do, "
        "so no level of the model has a value: raise fractal_dimension or hardness, or lower fractal_roughness, or use "
        "boundary elements"
    )


def plain_document(node: Any) -> Any:
    """A document of Python numbers instead of arrays, None for numbers that are not finite, which JSON cannot say."""
    if isinstance(node, dict):
        return {name: plain_document(value) for name, value in node.items()}
    if isinstance(node, list):
        return [plain_document(value) for value in node]
    if isinstance(node, str | bool | None):
        return node
    number = float(node)
    return number if math.isfinite(number) else None


def joint_document(solved: SolvedJoint, *, inputs: Document, assumptions: tuple[str, ...]) -> Document:
    """Everything that is known about a joint, ready for :func:`json.dumps`: the rows at their places, and the rest."""
    joint, solution, result = solved.joint, solved.solution, solved.result
    rims, limits = _rims(solved), limits_document(solved.temperature_limits)
    document = with_rows(
        {
            "asperity_version": asperity.__version__,
            "of_own_branches": joint.unlike is not None,
            "verdict": verdict_document(margins(solved), rims, solved.material_names),
            **in_order("mass_kg envelope_diameter_m"),
            "input": inputs,
            "input_speed_rad_per_s": joint.input_speed,
            "assumptions": list(assumptions),
            "geometry": _geometry(solved),
            "preload": {
                **in_order("force_N interference_m"),
                "at_assembly": assembly_document(joint, _at_assembly(solved), solved.temperature_limits),
                "temperature_limits": limits,
                "loading_cam": _loading_cam(joint, result),
            },
            "standing": {"forces": _forces(solved), **in_order("contacts")},
            "torque_capacity": torque_capacity_document(solved),
            "standing_torque_capacity": capacities_document(solution, solution),
            "surfaces": surface_averages(joint, inputs.get("surface", {})),
            "bearings": bearing_entries(solved),
            "rims": rims,
            **bound_document(joint),
            "torsional_stiffness": {
                level: {
                    **in_order("input_Nm_per_rad output_Nm_per_rad"),
                    "output_Nm_per_arcmin": stiffness.output_per_arcminute,
                }
                for level, stiffness in (
                    ("published", result.published),
                    ("series_with_bulk", result.series_with_bulk),
                    ("assembly", result.assembly.stiffness),
                )
            },
            "stiffness_unknown_because": stiffness_unknown_because(result),
            **in_order("stiffness_budget"),
            **dict.fromkeys(_IN_ROLLING),
            "rolling": rolling_document(solved),
            "heat": {} if joint.heat is None else heat_document(solved),
            "diagnostics": diagnostic_documents(all_checks(solved), solved.notes),
        },
        solved,
    )
    document |= {key: document["rolling"][key] for key in _IN_ROLLING}
    if joint.heat is None:
        del document["heat"]
    plain = plain_document(document)
    return (
        plain if solved.branches is None else plain | {"branches": branch_document(solved.branches, solution)}
    )


def _geometry(solved: SolvedJoint) -> Document:
    """Places, radii and speeds of the bodies; ratio and angles wait for their rows."""
    joint, drive = solved.joint, solved.joint.drive
    radii = zip(drive.contacts, np.asarray(drive.first_radius), np.asarray(drive.second_radius), strict=True)
    return {
        **in_order("speed_ratio"),
        "sectors": round(float(drive.sectors)) if joint.unlike is None else joint.unlike.sectors,
        "input": drive.input,
        "output": drive.output,
        "grounded": drive.ground,
        "centres_m": {
            body.name: [float(x) for x in centre]
            for body, centre in zip(drive.bodies, np.asarray(drive.centres), strict=True)
        },
        "track_radii_m": {
            contact.name: {contact.first: one, contact.second: two} for contact, one, two in radii
        },
        **in_order("alpha_rad theta_rad wedge_angle_rad"),
        "clearances": [
            {"name": name, "gap_m": gap}
            for name, gap in zip(solved.row_names("clearance"), solved.clearances, strict=True)
        ],
        "speeds_over_input": {
            drive.ground if name == drive.grounded else name: speed
            for name, speed in zip(drive.members, np.asarray(solved.result.speeds), strict=True)
        },
    }


def _loading_cam(joint: Joint, result: JointResult) -> Document | None:
    """The loading cam of a joint; None without one."""
    if joint.cam is None:
        return None
    return {
        "least_preload_N": mean_preload(joint, result.rest.normal),
        "force_per_torque_N_per_Nm": joint.cam.force_per_torque,
        "angle_rad": result.cam_angle,
        "held_stiffness_output_Nm_per_rad": held_cam_stiffness(result.assembly),
    }


def _forces(solved: SolvedJoint) -> Document:
    """Forces of the joint that stands; those with a row wait for it."""
    drive, result = solved.joint.drive, solved.result
    pinned = [drive.bodies[body].name for body in drive.pinned]
    components = pin_components(drive=drive, force=result.forces.pins)
    return {
        "normal_without_torque_N": dict(
            zip(result.contact_names, np.asarray(result.rest.normal), strict=True)
        ),
        **in_order("normal_N tangential_N"),
        "pin_N": {
            name: {"radial": radial, "tangential": tangential}
            for name, radial, tangential in zip(pinned, *components, strict=True)
        },
        **in_order("input_torque_Nm"),
        "output_torque_Nm": result.forces.output_torque,
        **in_order("body_mass_kg output_speed_rad_per_s balance_residual closure_residual"),
    }


def _at_assembly(solved: SolvedJoint) -> Solution | None:
    """Solution at the temperature of assembly; None without one."""
    fit = solved.joint.fit
    return None if fit is None else solved.at_temperature(float(fit.assembly_temperature))


def capacities_document(forward: Solution, reverse: Solution) -> Document:
    """Torque capacity of a joint that stands, in both directions, whatever damage it does."""
    names = forward.result.contact_names
    return {
        **capacity_document(forward.standing_capacity, contacts=names, first_slip=forward.first_slip),
        "reverse": capacity_document(
            reverse.reverse_standing_capacity, contacts=names, first_slip=reverse.reverse_first_slip
        ),
    }


def _rims(solved: SolvedJoint) -> Document:
    """Stresses and safeties of the rings and hollow rollers that bend, by the name of the body."""
    if not any(bends(solved.joint)):
        return {}
    names, rims = solved.row_names("body"), solved.rims
    return {
        names[number]: rim_entry(trees.map(lambda leaf, number=number: leaf[..., number], rims))
        for number, acts in enumerate(bends(solved.joint))
        if acts
    }


def surface_averages(joint: Joint, stated: Document) -> list[Document]:
    """What an instrument would show on the fractal surfaces of a joint [m]."""
    contacts = joint.contact_names
    shared = [contacts] if len(joint.surfaces) == 1 else [(name,) for name in contacts]
    by_surface: dict[tuple[float, float, float | None], list[str]] = {}
    for names, surface in zip(shared, joint.surfaces, strict=True):
        dimension, roughness = (
            float(surface.number(f"fractal_{name}")) for name in ("dimension", "roughness")
        )
        if math.isnan(dimension) or math.isnan(roughness):  # the law has none
            continue
        values = (dimension, roughness, _cut_off(stated.get(names[0], stated)))
        by_surface.setdefault(values, []).extend(names)
    return [_entry(names, *values) for values, names in by_surface.items()]


def _cut_off(entry: Document) -> float | None:
    """The cut-off of a surface that is stated by its Ra."""
    if "roughness_average" not in entry:
        return None
    return float(entry.get("cut_off", standard_cut_off(roughness_average=float(entry["roughness_average"]))))


def _entry(names: list[str], dimension: float, roughness: float, cut_off: float | None) -> Document:
    average = corresponding_average(fractal_dimension=dimension, fractal_roughness=roughness, cut_off=cut_off)
    return {
        "contacts": names,
        "fractal_dimension": dimension,
        "fractal_roughness_m": roughness,
        "roughness_average_m": average.per_body,
        "roughness_average_low_m": average.low,
        "roughness_average_high_m": average.high,
        "cut_off_m": average.cut_off,
    }
