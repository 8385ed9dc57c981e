"""Both kinds of joints asked alike: that of the paper's drive, and one with any planar drive."""

from __future__ import annotations

import dataclasses

from asperity.drive import geometry
from asperity.drive.planar import layout
from asperity.drive.planar.existence import refuse_impossible
from asperity.joint.description import Joint
from asperity.joint.planar.description import PlanarJoint
from asperity.joint.planar.solve import PlanarSolution, solve_planar
from asperity.joint.refusal import refuse_overlap
from asperity.joint.solve import Solution, solve

AnyJoint = Joint | PlanarJoint
AnySolution = Solution | PlanarSolution


def solve_any(joint: AnyJoint) -> AnySolution:
    """Solve one joint, whatever its drive.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        One joint.

    Returns
    -------
    Solution or PlanarSolution
        Result and torque capacities have the same names in both.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the torque capacity.
    NoSolutionError
        If no balance was found.
    """
    return solve_planar(joint) if isinstance(joint, PlanarJoint) else solve(joint)


def under_torque(joint: AnyJoint, output_torque: float) -> AnyJoint:
    """The same joint under another torque, at rest or in the rotation that a wind-up by this torque begins.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        One joint.
    output_torque : float
        Output torque of either sign [N·m].

    Returns
    -------
    Joint or PlanarJoint
        The paper's drive turns with the torque; the input of another drive has one sense of rotation, so that a
        negative torque drives it.
    """
    if isinstance(joint, PlanarJoint):
        return dataclasses.replace(joint, output_torque=output_torque)
    sense = -1.0 if output_torque < 0.0 else 1.0
    return dataclasses.replace(joint, output_torque=output_torque, sun_speed=sense * float(joint.sun_speed))


def refuse_no_room(joint: AnyJoint) -> None:
    """Refuse a joint whose bodies do not fit.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        One joint.

    Raises
    ------
    InputError
        With the members and the gap between them.
    """
    if isinstance(joint, PlanarJoint):
        refuse_impossible(joint.drive)
    else:
        refuse_overlap(joint, geometry.clearances(joint.geometry))


def unloaded_ratio(joint: AnyJoint) -> float:
    """Speed of the input over that of the output without creep.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        One joint.

    Returns
    -------
    float
        Ratio [-]; negative where they turn in opposite directions.
    """
    if isinstance(joint, PlanarJoint):
        return float(layout.speed_ratio(joint.drive))
    return float(geometry.speed_ratio(joint.geometry))


def has_own_branches(joint: AnyJoint) -> bool:
    """Whether a joint describes every branch by itself, because their sizes differ.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        One joint.

    Returns
    -------
    bool
        False where all are equal.
    """
    return isinstance(joint, PlanarJoint) and joint.unlike is not None
