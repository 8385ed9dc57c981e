"""The forces on the rollers of one sector of a drive."""

from __future__ import annotations

import math

import numpy as np

from asperity.drive.layout.drive import contact_angles
from asperity.joint.description import Joint, places
from asperity.joint.evaluation import JointResult
from asperity.rolling.turning import driving_sense
from asperity.show.body_force import BodyForce


def body_forces(joint: Joint, result: JointResult) -> list[BodyForce]:
    """Forces on the bodies of the first sector under the joint's torque, without the centrifugal ones.

    Parameters
    ----------
    joint : Joint
        One joint.
    result : JointResult
        Its result.

    Returns
    -------
    list of BodyForce
        For each contact the normal and the tangential force on its first and on its second body, then the force of
        each pin on its roller. Bodies on the axis have these forces from every sector.

    References
    ----------
    Equation (M1) of :doc:`/equations`, with the signs of :func:`asperity.drive.layout.drive.incidence`.
    """
    drive = joint.drive
    names = [body.name for body in drive.bodies]
    angles = np.asarray(contact_angles(drive))
    tangential = np.asarray(driving_sense(drive)) * np.asarray(result.forces.tangential)
    found = []
    for k, contact in enumerate(drive.contacts):
        normal = float(result.forces.normal[k])
        for side, body in enumerate(places(drive)):
            x, y = math.cos(angles[side][k]), math.sin(angles[side][k])
            # the rim of a ring is pushed outwards, and the other way round
            sign = 1.0 if side == 1 and contact.internal else -1.0
            found += [
                BodyForce(names[body[k]], contact.name, "N", (x, y), (sign * x, sign * y), normal),
                BodyForce(
                    names[body[k]], contact.name, "T", (x, y), (sign * y, -sign * x), -float(tangential[k])
                ),
            ]
    for pin, number in enumerate(drive.pinned):
        x, y = (float(each) for each in np.asarray(drive.centres)[number])
        outward = (x / math.hypot(x, y), y / math.hypot(x, y))
        cosine, sine = math.cos(float(drive.push_angles[pin])), math.sin(float(drive.push_angles[pin]))
        push = (cosine * outward[1] + sine * outward[0], -cosine * outward[0] + sine * outward[1])
        found.append(BodyForce(names[number], "pin", "F", (0.0, 0.0), push, -float(result.forces.pins[pin])))
    return found
