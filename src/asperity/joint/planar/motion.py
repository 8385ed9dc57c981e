"""What moves how in a joint with a planar drive, found once for all that ask for it."""

from __future__ import annotations

import dataclasses

from asperity.drive.planar.layout import contact_angles, incidence, speeds
from asperity.joint.planar.description import PlanarJoint


def in_motion(joint: PlanarJoint) -> PlanarJoint:
    """A joint whose drive knows its matrices, speeds and angles; of NumPy's numbers they are found without a program.

    Parameters
    ----------
    joint : PlanarJoint
        One joint.

    Returns
    -------
    PlanarJoint
        The same joint.
    """
    drive = joint.drive
    return dataclasses.replace(
        joint,
        drive=dataclasses.replace(drive, motion=(incidence(drive), speeds(drive), contact_angles(drive))),
    )
