"""Rows of the table of results: geometry, size and mass of the drive, and the torque it can pass."""

from __future__ import annotations

import functools
from typing import Any

from asperity.drive.layout.wedge import wedge_angles
from asperity.joint.torque_limits import LIMIT_KINDS
from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.unit_table import Dimension

_geometry = functools.partial(Result, group="geometry", needs="geometry")
_size = functools.partial(Result, group="size", needs="geometry")
_capacity = functools.partial(Result, group="capacity", needs="geometry")
_LENGTH, _MASS = Dimension.LENGTH, Dimension.MASS


def _angle(name: str, label: str) -> Result:
    """An angle of the wedges, by its name among them."""

    def value(solved: SolvedJoint) -> Any:
        return getattr(wedge_angles(solved.joint.drive), name)

    return _geometry(f"{name}_angle", label, Dimension.ANGLE, "deg", value, needs_wedges=True)


ROWS = (
    _angle("polar", "angle alpha between planet and loading roller"),
    _angle("direction", "direction theta from planet to loading roller"),
    _angle("wedge", "wedge angle beta"),
    _geometry(
        "speed_ratio",
        "speed ratio, input over output",
        Dimension.DIMENSIONLESS,
        "1",
        "result.speed_ratio",
        positive=False,
        note="negative: they turn in opposite directions",
    ),
    _geometry(
        "absolute_speed_ratio",
        "speed ratio without its sign",
        Dimension.DIMENSIONLESS,
        "1",
        lambda solved: abs(solved.result.speed_ratio),
    ),
    _geometry(
        "output_speed",
        "angular velocity of the output",
        Dimension.ANGULAR_VELOCITY,
        "rpm",
        "result.output_speed",
        positive=False,
    ),
    _geometry(
        "clearance",
        "clearance",
        _LENGTH,
        "mm",
        "clearances",
        axis="clearance",
        positive=False,
        lowest_limit=0.0,
        note="free distance between two rollers; the joint exists where all are positive",
    ),
    _size(
        "envelope_diameter",
        "outer diameter of the largest body",
        _LENGTH,
        "mm",
        "size.envelope_diameter",
        note="of the housing where the file describes one",
    ),
    _size(
        "envelope_length",
        "length of the rolling parts",
        _LENGTH,
        "mm",
        "size.envelope_length",
        note="nan where rollers are stepped: how far their tracks lie apart is not part of the description",
    ),
    _size(
        "envelope_volume",
        "volume of the envelope",
        Dimension.VOLUME,
        "cm^3",
        "size.envelope_volume",
        note="nan where rollers are stepped",
    ),
    _size("mass", "mass of the rolling parts", _MASS, "kg", "size.mass"),
    _size("body_mass", "mass of a body", _MASS, "g", "result.masses", axis="body"),
    *(
        row
        for prefix, words in (("", "positive"), ("reverse_", "negative"))
        for row in (
            _capacity(
                f"{prefix}torque_capacity",
                f"{prefix.replace('_', ' ')}torque capacity",
                Dimension.TORQUE,
                "N*m",
                f"{prefix}capacity.output_torque",
                note=f"the largest {words} output torque before the first limit",
            ),
            _capacity(
                f"{prefix}capacity_limit",
                f"limit of the {prefix.replace('_', ' ')}torque capacity",
                Dimension.DIMENSIONLESS,
                "1",
                f"{prefix}capacity.limit",
                differentiable=False,
                positive=False,
                categories=LIMIT_KINDS,
                note=f"its number in the order {', '.join(LIMIT_KINDS)}, from 0",
            ),
            _capacity(
                f"{prefix}limiting_contact",
                f"contact that limits the {prefix.replace('_', ' ')}torque capacity",
                Dimension.DIMENSIONLESS,
                "1",
                f"{prefix}capacity.limiting_contact",
                differentiable=False,
                positive=False,
                categories=("none",),
            ),
            _capacity(
                f"{prefix}rolling_torque_capacity",
                f"{prefix.replace('_', ' ')}torque capacity in rolling",
                Dimension.TORQUE,
                "N*m",
                f"{prefix}rolling_capacity",
                note=f"the largest {words} output torque under which the joint rolls without gross slip; below the "
                "capacity standing where equal creep loads the weaker side of a planet more",
            ),
        )
    ),
)
