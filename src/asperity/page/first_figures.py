"""The key figures of a joint that need no torque capacity: known long before all else, and shown first."""

from __future__ import annotations

import dataclasses

from asperity.joint.evaluation import JointResult
from asperity.joint.pin_bound import bound_document
from asperity.joint.solve import joint_state, refuse_impossible_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.own_branches import branches_of
from asperity.page.joint_request import JointRequest
from asperity.results.document import plain_document
from asperity.results.solved import joint_size
from asperity.rolling.document import losses, no_life_because, unknown_because
from asperity.rolling.heat import HeatBalance
from asperity.types import Document
from asperity.views.headline import headline


def first_figures(request: JointRequest) -> Document:
    """Stiffness, drift, life, efficiency, mass and diameter of a joint under its torque.

    ``figures``: as those of :func:`asperity.page.answer.joint_answer`, which add the torque capacity; none where the
    joint has no state under its torque, of which that answer says why. Raised is an ``InputError`` if the bodies do
    not fit.
    """
    case = request.solved_case()
    branches = branches_of(case)
    joint = refuse_impossible_joint(joint_from_case(case) if branches is None else branches.joint)
    result: JointResult = joint_state(joint)
    if not bool(result.solved):
        return {"figures": []}
    stiffness, rolling, size = result.assembly.stiffness, result.rolling, joint_size(joint, result)
    known = plain_document(
        {
            **_heat(joint.heat),
            "torsional_stiffness": {
                "assembly": {
                    "output_Nm_per_rad": stiffness.output,
                    "output_Nm_per_arcmin": stiffness.output_per_arcminute,
                }
            },
            **bound_document(joint),
            "drift_rad_per_output_turn": rolling.drift_per_output_turn,
            "speed_loss": rolling.speed_loss,
            "efficiency": rolling.power.efficiency,
            "losses_W": losses(rolling),
            "life_hours": rolling.life_hours.drive,
            "mass_kg": size.mass,
            "envelope_diameter_m": size.envelope_diameter,
            "rolling": {
                "unknown_because": unknown_because(joint, result),
                "no_life_because": no_life_because(joint, result),
                "reliability": joint.rolling.reliability,
                "life_output_turns": rolling.life_turns.drive,
            },
        }
    )
    return {"figures": [dataclasses.asdict(figure) for figure in headline(known)]}


def _heat(heat: HeatBalance | None) -> Document:
    """What the figures say of the temperature at which a joint settles."""
    if heat is None:
        return {}
    return {
        "heat": {
            "steady": bool(heat.is_steady),
            "unsteady_because": heat.unsteady_because or None,
            "roller_temperature_degC": heat.roller_temperature,
        }
    }
