"""Rows of the table of results: loads of pins and of the grounded member."""

from __future__ import annotations

import functools

from asperity.joint.bores import bore_stiffness
from asperity.joint.working_loads import pin_bending
from asperity.results.result import Result
from asperity.unit_table import Dimension

_load = functools.partial(Result, group="loads")
_STATE = "in rolling where the input turns, standing under the torque where it stands"

ROWS = (
    _load(
        "pin_load",
        "force of a roller on its pin",
        Dimension.FORCE,
        "N",
        lambda solved: abs(solved.loads.pin),
        axis="pin",
        note=_STATE,
    ),
    _load(
        "pin_bending_moment",
        "bending moment of a pin",
        Dimension.TORQUE,
        "N*m",
        lambda solved: pin_bending(solved.joint, solved.loads.pin)[0],
        axis="pin",
        note="nan without bearings.pin_length",
    ),
    _load(
        "pin_bending_stress",
        "bending stress of a pin",
        Dimension.PRESSURE,
        "MPa",
        lambda solved: pin_bending(solved.joint, solved.loads.pin)[1],
        axis="pin",
        note="nan without bearings.pin_length and pin_diameter",
    ),
    _load(
        "bore_stiffness",
        "stiffness of a roller's bore under its pin",
        Dimension.STIFFNESS,
        "N/um",
        lambda solved: bore_stiffness(solved.joint),
        axis="pin",
        note="between the pin and forces spread over the rim, its own stiffness not counted; infinite without "
        "bearings.pin_diameter",
    ),
    _load(
        "grounded_torque",
        "torque of the rollers on the grounded member",
        Dimension.TORQUE,
        "N*m",
        lambda solved: (
            solved.joint.drive.sense
            * solved.loads.moments[solved.joint.drive.members.index(solved.joint.drive.grounded)]
        ),
        positive=False,
        note=f"positive in the sense in which the input turns; {_STATE}",
    ),
)
