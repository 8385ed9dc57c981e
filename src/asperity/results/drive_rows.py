"""Rows of the table of results: geometry, size and mass of the drive, and the torque it can pass."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable
from typing import Any

from asperity.drive.layout.wedge import wedge_angles
from asperity.joint.torque_limits import LIMIT_KINDS
from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.results.torque_capacity import CAPACITY_LIMITS, PLACE_AXES, torque_capacity, torque_safety
from asperity.unit_table import Dimension

_geometry = functools.partial(Result, group="geometry", needs="geometry")
_size = functools.partial(Result, group="size", needs="geometry")
_capacity = functools.partial(Result, group="capacity", needs="geometry")
_torque = functools.partial(_capacity, dimension=Dimension.TORQUE, display_unit="N*m")
_code = functools.partial(
    _capacity, dimension=Dimension.DIMENSIONLESS, display_unit="1", differentiable=False, positive=False
)
_LENGTH, _MASS = Dimension.LENGTH, Dimension.MASS


def _angle(name: str, label: str, key: str) -> Result:
    """An angle of the wedges, by its name among them."""

    def value(solved: SolvedJoint) -> Any:
        return getattr(wedge_angles(solved.joint.drive), name)

    return _geometry(
        f"{name}_angle", label, Dimension.ANGLE, "deg", value, needs_wedges=True, place=f"geometry.{key}"
    )


def _capacities(reverse: bool, prefix: str, way: str, words: str) -> tuple[Result, ...]:
    """The capacities in one direction: that of the joint, and those of slip alone."""

    def part(name: str) -> Callable[[SolvedJoint], Any]:
        return lambda solved: getattr(torque_capacity(solved, reverse=reverse), name)

    return (
        _torque(
            f"{prefix}torque_capacity",
            f"{way}torque capacity",
            value=part("output_torque"),
            note=f"the largest {words} output torque before the first limit of function or damage, standing or in "
            "rolling; 0 where one is crossed without torque",
        ),
        _code(
            f"{prefix}capacity_limit",
            f"limit of the {way}torque capacity",
            value=part("limit"),
            categories=CAPACITY_LIMITS,
            note=f"its number in the order {', '.join(CAPACITY_LIMITS)}, from 0",
        ),
        _code(
            f"{prefix}limiting_place",
            f"contact or part that limits the {way}torque capacity",
            value=part("place"),
            categories=(*PLACE_AXES, "none"),
        ),
        _torque(
            f"{prefix}standing_torque_capacity",
            f"{way}torque capacity standing, of slip alone",
            value=f"{prefix}standing_capacity.output_torque",
            note=f"the largest {words} output torque that the joint passes while it stands, whatever damage it does",
        ),
        _code(
            f"{prefix}standing_capacity_limit",
            f"limit of the {way}torque capacity standing",
            value=f"{prefix}standing_capacity.limit",
            categories=LIMIT_KINDS,
            note=f"its number in the order {', '.join(LIMIT_KINDS)}, from 0",
        ),
        _code(
            f"{prefix}standing_limiting_contact",
            f"contact that limits the {way}torque capacity standing",
            value=f"{prefix}standing_capacity.limiting_contact",
            categories=("contact", "none"),
        ),
        _torque(
            f"{prefix}rolling_torque_capacity",
            f"{way}torque capacity in rolling, of slip alone",
            value=f"{prefix}rolling_capacity",
            note=f"the largest {words} output torque under which the joint rolls without gross slip, whatever damage "
            "it does; below the capacity standing where equal creep loads the weaker side of a planet more",
        ),
    )


ROWS = (
    _angle("polar", "angle alpha between planet and loading roller", "alpha_rad"),
    _angle("direction", "direction theta from planet to loading roller", "theta_rad"),
    _angle("wedge", "wedge angle beta", "wedge_angle_rad"),
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
        place="",
    ),
    _geometry(
        "output_speed",
        "angular velocity of the output",
        Dimension.ANGULAR_VELOCITY,
        "rpm",
        "result.output_speed",
        positive=False,
        place="standing.forces.output_speed_rad_per_s",
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
        place="",
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
        place="",
    ),
    _size(
        "envelope_volume",
        "volume of the envelope",
        Dimension.VOLUME,
        "cm^3",
        "size.envelope_volume",
        note="nan where rollers are stepped",
        place="",
    ),
    _size("mass", "mass of the rolling parts", _MASS, "kg", "size.mass"),
    _size(
        "body_mass",
        "mass of a body",
        _MASS,
        "g",
        "result.masses",
        axis="body",
        place="standing.forces.body_mass_kg.*",
    ),
    *(
        dataclasses.replace(row, place="")  # the document says them in words
        for reverse, prefix, words in ((False, "", "positive"), (True, "reverse_", "negative"))
        for row in _capacities(reverse, prefix, prefix.replace("_", " "), words)
    ),
    Result(
        "torque_safety",
        "safety factor of the torque",
        Dimension.DIMENSIONLESS,
        "1",
        torque_safety,
        group="diagnostics",
        needs="geometry",
        lowest_limit=1.0,
        used=("torque", "capacity"),
        note="torque capacity in the direction of the output torque, over that torque; at least this where the limit "
        "is contact_too_wide or wall_too_thin, standing or in rolling, at which only what is computed ends",
        place="",
    ),
)
