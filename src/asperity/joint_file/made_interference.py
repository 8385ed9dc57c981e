"""The interference with which the parts of a drive are made, for its drawing."""

from __future__ import annotations

import dataclasses
import math
from typing import NamedTuple

from asperity.errors import InputError, NoSolutionError
from asperity.joint.evaluation import JointResult
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_values, thermal_change_of
from asperity.joint_file.sections import without_expansion
from asperity.joint_file.si_tables import AnyCase, si_values


class MadeInterference(NamedTuple):
    """By how much the inner radius of the rings is made smaller than that at which all contacts just touch [m].

    None where it is not known; ``unknown_because`` says why.
    """

    size: float | None
    unknown_because: str = ""


def made_interference(case: AnyCase, result: JointResult | None = None) -> MadeInterference:
    """Interference of the parts at their assembly: that of the file, or that which makes the force that it states.

    Parameters
    ----------
    case : Case
        The joint file.
    result : JointResult, optional
        Its result, if it is known; otherwise the joint is solved without torque, as it is assembled.

    Returns
    -------
    MadeInterference
        A loading cam adds nothing to it: without torque the drive has its least preload. At another temperature than
        that of the assembly, less what temperature adds.
    """
    load = case.load
    if load.interference is not None:
        return MadeInterference(load.interference.value)
    values, added = si_values(case), 0.0
    if case.temperature is not None:
        unknown = without_expansion(case.bodies, case.materials)
        if unknown:
            return MadeInterference(None, f"the thermal_expansion of {', '.join(unknown)} is not in the file")
    try:
        if case.temperature is not None:
            added = thermal_change_of(values)
        if result is None or load.cam_force_per_torque is not None or not math.isfinite(result.interference):
            joint = joint_from_values(values)
            result = solve_joint(dataclasses.replace(joint, output_torque=0.0)).result
    except (InputError, NoSolutionError) as error:
        return MadeInterference(None, str(error))
    return MadeInterference(float(result.interference) - added)
