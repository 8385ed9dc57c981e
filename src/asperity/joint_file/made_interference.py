"""The interference with which the parts of a drive are made, for its drawing."""

from __future__ import annotations

import math

from asperity.joint.planar.evaluation import PlanarResult
from asperity.joint_file.planar_build import thermal_change_of
from asperity.joint_file.si_tables import AnyCase, si_values
from asperity.joint_file.temperature_section import without_expansion


def made_interference(case: AnyCase, result: PlanarResult | None = None) -> float | None:
    """Interference of the parts at their assembly: that of the file, or that which makes the force that it states.

    Parameters
    ----------
    case : PlanarCase
        The joint file.
    result : PlanarResult, optional
        Its result, for a file that states a force.

    Returns
    -------
    float or None
        Interference [m]. None where it is not known: without a result, with a loading cam, whose force is not that of
        the assembly, and with a temperature whose effect on it is not known.
    """
    load = case.load
    if load.interference is not None:
        return load.interference.value
    if result is None or load.cam_force_per_torque is not None:
        return None
    found = float(result.interference)
    if not math.isfinite(found):
        return None
    if case.temperature is None:
        return found
    if without_expansion(case.bodies, case.materials):
        return None
    return found - thermal_change_of(si_values(case))
