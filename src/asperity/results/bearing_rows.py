"""Rows of the table of results: life and safety of the rolling bearings."""

from __future__ import annotations

import functools

from asperity.drive.structure.bearing_life import LARGEST_LOAD_RATIO
from asperity.results.result import Limit, Result
from asperity.unit_table import Dimension

_NEEDS = "nan without a section for its ratings, such as [pin_bearing]"
_bearing = functools.partial(
    Result, group="bearings", axis="bearing", present=lambda solved: solved.has_bearings
)

ROWS = (
    _bearing(
        "bearing_load",
        "radial load of one bearing",
        Dimension.FORCE,
        "N",
        "bearings.load",
        note=_NEEDS,
    ),
    _bearing(
        "bearing_life",
        "basic rating life L10 of a bearing",
        Dimension.TIME,
        "h",
        "bearings.life",
        note=f"ISO 281, nine in ten, without a_ISO, axial load and misalignment; nan where it stands; {_NEEDS}",
    ),
    _bearing(
        "bearing_duty_life",
        "basic rating life L10 of a bearing under the duty",
        Dimension.TIME,
        "h",
        "bearings.duty_life",
        note=f"by Miner's sum; nan without a duty; {_NEEDS}",
    ),
    _bearing(
        "bearing_static_safety",
        "static safety of a bearing",
        Dimension.DIMENSIONLESS,
        "1",
        "bearings.static_safety",
        lowest_limit=0.0,
        note=f"C_0 over the largest load without torque, under the torque and under the duty; {_NEEDS}",
        limit=Limit(
            "damage",
            "the raceways of the bearing keep their shape",
            "the largest load exceeds the static rating C_0 of the bearing: its raceways keep dents",
            "choose a larger bearing or more of them, or lower preload or torque",
            lowest=1.0,
            inclusive=True,
        ),
    ),
    _bearing(
        "bearing_load_ratio",
        "load over dynamic rating of a bearing",
        Dimension.DIMENSIONLESS,
        "1",
        "bearings.load_ratio",
        note=f"largest P/C under the torque and under the duty; {_NEEDS}",
        limit=Limit(
            "accuracy",
            "the load of the bearing is within the range of its rating life",
            "the load exceeds half the dynamic rating C of the bearing: its rating life is not valid",
            "choose a larger bearing or more of them, or lower preload or torque",
            highest=LARGEST_LOAD_RATIO,
            inclusive=True,
        ),
    ),
)
