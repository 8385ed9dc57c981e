"""Where the output of a joint is: drift beside stiffness, and the torque up to which both hold, for people to read."""

from __future__ import annotations

from typing import NamedTuple

from asperity.joint.pin_bound import bounded
from asperity.types import Document
from asperity.views.joint import in_its_direction
from asperity.views.numbers import quantity


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
    turning, at_rest = (
        in_its_direction(document, both)
        for both in (rolling["torque_capacity"], document["standing_torque_capacity"])
    )
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
        PositionRow(
            "torque capacity, rolling",
            turning["output_torque_Nm"],
            "N*m",
            f"{turning['meaning']}; standing: {quantity(at_rest['output_torque_Nm'], 'N*m')}"
            if at_rest["output_torque_Nm"] is not None
            else f"{turning['meaning']}; standing: {at_rest['meaning']}",
        ),
    ]


def _comes_back(document: Document) -> PositionRow:
    """The torque over the stiffness there, unless a contact that slips leaves the rest of the stiffness to others."""
    torque = document["standing"]["forces"]["output_torque_Nm"]
    spring = document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    first_slip = in_its_direction(document, document["standing_torque_capacity"]).get("first_slip")
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
