"""What a joint does with equal branches, also where only its own, of unlike sizes, carry the torque."""

from __future__ import annotations

import dataclasses
import math

from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.solve import Solution, solve_joint

_SHARE = 0.9  # of the torque that equal branches carry


def solve_equal_branches(joint: Joint) -> tuple[Solution, bool]:
    """What a joint does with equal branches, where it may have others that carry more.

    Parameters
    ----------
    joint : Joint
        One joint.

    Returns
    -------
    solution : Solution
        What it does; under a smaller torque where equal branches do not carry its own.
    carries : bool
        Whether equal branches carry its own torque.

    Raises
    ------
    InputError, NoSolutionError
        As :func:`asperity.joint.solve.solve_joint`, if the reason is not the size of the torque.
    """
    torque = float(joint.output_torque)
    try:
        return solve_joint(joint), True
    except (InputError, NoSolutionError) as refusal:
        try:
            free = solve_joint(dataclasses.replace(joint, output_torque=0.0))
        except (InputError, NoSolutionError):
            raise refusal from None
        limit = float((free.reverse_capacity if torque < 0.0 else free.capacity).output_torque)
        if not limit <= abs(torque):
            raise
    return solve_joint(dataclasses.replace(joint, output_torque=math.copysign(_SHARE * limit, torque))), False
