"""A solved joint with a planar drive as one JSON document, with the names of the paper's drive."""

from __future__ import annotations

from typing import Any

import jax
import numpy as np

import asperity
from asperity.drive.planar.layout import PlanarDrive
from asperity.drive.planar.loads import pin_components
from asperity.drive.planar.wedge import wedge_angles, wedges
from asperity.joint.all_limits import all_checks
from asperity.joint.branch_document import branch_document
from asperity.joint.capacity import capacity_document
from asperity.joint.document import (
    contact_documents,
    diagnostic_documents,
    plain_document,
    stiffness_budget,
    stiffness_unknown_because,
    torsional_stiffness_document,
)
from asperity.joint.loading_cam import loading_cam_document
from asperity.joint.planar.rims import bends
from asperity.joint.planar.solve import PlanarSolution
from asperity.joint.planar.solved import SolvedJoint
from asperity.joint.planar.temperature import planar_assembly_document
from asperity.joint.rolling_document import losses, rolling_document
from asperity.joint.strength_document import bearing_entries, rim_entry
from asperity.joint.surface_averages import surface_averages

Document = dict[str, Any]


def planar_document(solved: SolvedJoint, *, inputs: Document, assumptions: tuple[str, ...]) -> Document:
    """Everything that is known about a joint, ready for :func:`json.dumps`.

    Parameters
    ----------
    solved : SolvedJoint
        The joint, and what came out.
    inputs : dict
        Tables of the joint file in SI units.
    assumptions : tuple of str
        What the file leaves out, one sentence each.

    Returns
    -------
    dict
        Nested tables of numbers and text. Numbers that are not finite are None; the diagnostics say why.
    """
    joint, solution, branches = solved.joint, solved.solution, solved.branches
    result, drive = solution.result, joint.drive
    forward = float(joint.output_torque) >= 0.0
    pinned = [drive.bodies[body].name for body in drive.pinned]
    names = result.contact_names
    checks = all_checks(solved)
    document = plain_document(
        {
            "asperity_version": asperity.__version__,
            "input": inputs,
            "assumptions": list(assumptions),
            "geometry": {
                "speed_ratio": result.speed_ratio,
                "sectors": round(float(drive.sectors)),
                "input": drive.input,
                "output": drive.output,
                "grounded": drive.grounded,
                "centres_m": {
                    body.name: [float(x) for x in centre]
                    for body, centre in zip(drive.bodies, np.asarray(drive.centres), strict=True)
                },
                "track_radii_m": {
                    contact.name: {contact.first: one, contact.second: two}
                    for contact, one, two in zip(
                        drive.contacts,
                        np.asarray(drive.first_radius),
                        np.asarray(drive.second_radius),
                        strict=True,
                    )
                },
                **_wedge_document(drive),
                "clearances": [
                    {"name": name, "gap_m": gap}
                    for name, gap in zip(solved.row_names("clearance"), solved.clearances, strict=True)
                ],
                "speeds_over_input": dict(zip(drive.members, np.asarray(result.speeds), strict=True)),
            },
            "preload": {
                "force_N": result.preload,
                "interference_m": result.interference,
                "at_assembly": planar_assembly_document(joint),
                "loading_cam": loading_cam_document(
                    result,
                    least_preload=result.rest.normal[0],
                    force_per_torque=None if joint.cam is None else joint.cam.force_per_torque,
                ),
            },
            "forces": {
                "normal_without_torque_N": dict(zip(names, np.asarray(result.rest.normal), strict=True)),
                "normal_N": dict(zip(names, np.asarray(result.forces.normal), strict=True)),
                "tangential_N": dict(zip(names, np.asarray(result.forces.tangential), strict=True)),
                "pin_N": {
                    name: {"radial": radial, "tangential": tangential}
                    for name, radial, tangential in zip(
                        pinned, *pin_components(drive=drive, force=result.forces.pins), strict=True
                    )
                },
                "input_torque_Nm": result.forces.input_torque,
                "output_torque_Nm": result.forces.output_torque,
                "body_mass_kg": dict(zip(result.body_names, np.asarray(result.masses), strict=True)),
                "output_speed_rad_per_s": result.output_speed,
                "balance_residual": result.forces.balance_residual,
                "closure_residual": result.forces.closure_residual,
            },
            "torque_capacity": planar_capacity_document(solution, solution),
            "contacts": contact_documents(solved),
            "surfaces": surface_averages(joint, inputs.get("surface", {})),
            "bearings": bearing_entries(solved),
            "rims": _rims(solved),
            "torsional_stiffness": torsional_stiffness_document(result),
            "stiffness_unknown_because": solved.no_equal_state or stiffness_unknown_because(result),
            "stiffness_budget": stiffness_budget(result),
            "speed_loss": result.rolling.speed_loss,
            "drift_rad_per_output_turn": result.rolling.drift_per_output_turn,
            "efficiency": result.rolling.power.efficiency,
            "losses_W": losses(result.rolling),
            "life_hours": result.rolling.life_hours.drive,
            "rolling": {
                **rolling_document(joint, result, solved.no_equal_state, unlike=branches is not None),
                "torque_capacity_Nm": (
                    solution.rolling_capacity if forward else solution.reverse_rolling_capacity
                ).output_torque,
            },
            "diagnostics": diagnostic_documents(checks, solved.notes),
        }
    )
    return document | ({} if branches is None else {"branches": branch_document(branches)})


def _wedge_document(drive: PlanarDrive) -> Document:
    """Angles of the wedges of a drive that has them [rad]."""
    if not wedges(drive):
        return {}
    angles = wedge_angles(drive)
    return {"alpha_rad": angles.polar, "theta_rad": angles.direction, "wedge_angle_rad": angles.wedge}


def planar_capacity_document(forward: PlanarSolution, reverse: PlanarSolution) -> Document:
    """Torque capacity of a joint that stands, in both directions.

    Parameters
    ----------
    forward, reverse : PlanarSolution
        What the joint does under a positive and under a negative torque.

    Returns
    -------
    dict
        As :func:`asperity.joint.capacity.capacity_document` says them, with the torque of the first slip.
    """
    names = forward.result.contact_names
    return {
        **capacity_document(forward.capacity, contacts=names, first_slip=forward.first_slip),
        "reverse": capacity_document(
            reverse.reverse_capacity, contacts=names, first_slip=reverse.reverse_first_slip
        ),
    }


def _rims(solved: SolvedJoint) -> Document:
    """Stresses and safeties of the rings and hollow rollers that bend, by the name of the body."""
    if not any(bends(solved.joint)):
        return {}
    names, found = solved.row_names("body"), solved.rims
    return {
        names[number]: rim_entry(jax.tree.map(lambda leaf, number=number: leaf[..., number], found))
        for number, acts in enumerate(bends(solved.joint))
        if acts
    }
