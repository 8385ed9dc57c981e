"""Where the output of a joint is: drift beside stiffness, and the torque up to which both hold, for people to read."""

from __future__ import annotations

import math
from typing import NamedTuple

from asperity.joint.pin_bound import bounded
from asperity.joint.torque_limits import may_carry_more
from asperity.types import Document
from asperity.units import format_quantity


class PositionRow(NamedTuple):
    """One number about the position of the output.

    Label, value [SI], None where there is none, unit to show, meaning.
    """

    label: str
    value: float | None
    unit: str
    meaning: str


def position_rows(document: Document) -> list[PositionRow]:
    """Drift and stiffness, two numbers that do not replace each other, and the capacity in rolling, in order."""
    rolling = document["rolling"]
    capacity = _finite(rolling["torque_capacity_Nm"])
    return [
        PositionRow(
            "drift per output turn",
            rolling["drift_rad_per_output_turn"],
            "arcmin",
            "accumulates with every turn and does not come back",
        ),
        PositionRow("speed loss", rolling["speed_loss"], "%", "drift as a share of the output speed"),
        PositionRow(
            "stiffness at standstill",
            document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"],
            "N*m/arcmin",
            bounded("assembled, at this torque", document["stiffness_bound"]),
        ),
        _comes_back(document),
        PositionRow("torque capacity, rolling", capacity, "N*m", _beyond(document)),
    ]


def _comes_back(document: Document) -> PositionRow:
    """The torque over the stiffness there, unless a contact that slips leaves the rest of the stiffness to others."""
    torque = document["standing"]["forces"]["output_torque_Nm"]
    spring = document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    first_slip = _in_its_direction(document).get("first_slip")
    label = "torque over stiffness"
    if first_slip is not None and abs(torque) >= first_slip["output_torque_Nm"]:
        return PositionRow(
            label, None, "arcmin", "a contact slips: 'asperity windup' gives the wind-up that comes back"
        )
    return PositionRow(
        label,
        torque / spring if spring else None,
        "arcmin",
        "approximate wind-up that comes back; exact: 'asperity windup'",
    )


def _beyond(document: Document) -> str:
    """Words for what ends the rolling beyond its capacity, and the capacity at rest."""
    capacity, torque = (
        document["standing_torque_capacity"],
        _finite(document["rolling"]["torque_capacity_Nm"]),
    )
    if torque is None:
        ends = "not limited by friction"
    elif may_carry_more(capacity, torque):
        ends = "at least: what is computed ends there"
    else:
        ends = "beyond, a contact slips"
    at_rest = _finite(_in_its_direction(document)["output_torque_Nm"])
    standing = "not limited by friction" if at_rest is None else format_quantity(at_rest, "N*m")
    return f"{ends}; standing: {standing}"


def _finite(value: float | None) -> float | None:
    """A number, or None where it is infinite or unknown."""
    return None if value is None or not math.isfinite(value) else float(value)


def _in_its_direction(document: Document) -> Document:
    """The capacity of the joint that stands, in the direction of its torque."""
    capacity: Document = document["standing_torque_capacity"]
    reverse: Document = capacity["reverse"]
    return reverse if document["standing"]["forces"]["output_torque_Nm"] < 0.0 else capacity
