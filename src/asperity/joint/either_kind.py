"""All kinds of joints asked alike: that of the paper's drive, one with any planar drive, and one of unlike branches."""

from __future__ import annotations

import dataclasses
import math

from asperity.drive import geometry
from asperity.drive.planar import layout
from asperity.drive.planar.existence import refuse_impossible
from asperity.joint.description import Joint
from asperity.joint.planar.description import PlanarJoint
from asperity.joint.planar.solve import PlanarSolution, solve_planar
from asperity.joint.refusal import refuse_overlap
from asperity.joint.rolling_document import unknown_because
from asperity.joint.solve import Solution, solve
from asperity.joint.unlike_joint import UnlikeJoint
from asperity.joint.unlike_solution import UnlikeSolution, solve_unlike

AnyJoint = Joint | PlanarJoint
#: Those too whose branches are unlike; another drive than the paper's describes them as any of its joints.
OwnJoint = AnyJoint | UnlikeJoint
AnySolution = Solution | PlanarSolution | UnlikeSolution


def solve_any(joint: OwnJoint) -> AnySolution:
    """Solve one joint, whatever its drive.

    Parameters
    ----------
    joint : Joint, PlanarJoint or UnlikeJoint
        One joint.

    Returns
    -------
    Solution, PlanarSolution or UnlikeSolution
        Results have the same names in all; torque capacities too, but for unlike branches of the paper's drive.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the torque capacity.
    NoSolutionError
        If no balance was found.
    """
    if isinstance(joint, UnlikeJoint):
        return solve_unlike(joint)
    return solve_planar(joint) if isinstance(joint, PlanarJoint) else solve(joint)


def under_torque(joint: OwnJoint, output_torque: float) -> OwnJoint:
    """The same joint under another torque, at rest or in the rotation that a wind-up by this torque begins.

    Parameters
    ----------
    joint : Joint, PlanarJoint or UnlikeJoint
        One joint.
    output_torque : float
        Output torque of either sign [N·m].

    Returns
    -------
    Joint, PlanarJoint or UnlikeJoint
        The paper's drive turns with the torque; the input of another drive has one sense of rotation, so that a
        negative torque drives it.
    """
    if isinstance(joint, PlanarJoint):
        return dataclasses.replace(joint, output_torque=output_torque)
    speed = math.copysign(1.0, output_torque) * float(joint.sun_speed)
    if isinstance(joint, UnlikeJoint):
        return joint.under(output_torque, speed)
    return dataclasses.replace(joint, output_torque=output_torque, sun_speed=speed)


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


def has_own_branches(joint: OwnJoint) -> bool:
    """Whether a joint describes every branch by itself, because their sizes differ.

    Parameters
    ----------
    joint : Joint, PlanarJoint or UnlikeJoint
        One joint.

    Returns
    -------
    bool
        False where all are equal.
    """
    return isinstance(joint, UnlikeJoint) or (isinstance(joint, PlanarJoint) and joint.unlike is not None)


def why_unknown(joint: OwnJoint, solution: AnySolution) -> list[str]:
    """Why results of the rolling are absent.

    Parameters
    ----------
    joint : Joint, PlanarJoint or UnlikeJoint
        One joint.
    solution : Solution, PlanarSolution or UnlikeSolution
        What it does.

    Returns
    -------
    list of str
        One sentence for each reason; empty if everything is there.
    """
    if isinstance(joint, UnlikeJoint):
        assert isinstance(solution, UnlikeSolution)
        return solution.unknown_because(joint)
    return unknown_because(joint, solution.result)
