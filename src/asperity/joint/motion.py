"""What moves how in a joint, found once for all that ask for it."""

from __future__ import annotations

import dataclasses

from asperity.drive.layout.drive import contact_angles, incidence, speeds
from asperity.joint.description import Joint


def in_motion(joint: Joint) -> Joint:
    """A joint whose drive knows its matrices, speeds and angles; of NumPy's numbers they are found without a program.

    Parameters
    ----------
    joint : Joint
        One joint.

    Returns
    -------
    Joint
        The same joint.
    """
    drive = joint.drive
    return dataclasses.replace(
        joint,
        drive=dataclasses.replace(drive, motion=(incidence(drive), speeds(drive), contact_angles(drive))),
    )
