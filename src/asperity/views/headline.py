"""The figures by which a joint is decided, each in a few words: what a page keeps in view."""

from __future__ import annotations

from asperity.types import Document
from asperity.views.blocks import Figure
from asperity.views.heat import at_temperature
from asperity.views.joint import in_its_direction
from asperity.views.numbers import number, number_in, percent, quantity


def headline(document: Document) -> list[Figure]:
    """Stiffness, drift, torque capacity, life, efficiency, mass and diameter of a joint.

    ``document``: of the whole joint, or of its state under its torque alone, which has no torque capacity: that figure
    is then left out.
    """
    stiffness = document["torsional_stiffness"]["assembly"]
    capacity = [_capacity(document)] if "torque_capacity" in document else []
    return [
        Figure(
            "Stiffness",
            number(stiffness["output_Nm_per_arcmin"]),
            "N·m/arcmin",
            document["stiffness_bound"] or "at the output, assembled",
            stiffness["output_Nm_per_rad"],
        ),
        Figure(
            "Drift",
            number_in(document["drift_rad_per_output_turn"], "arcmin"),
            "arcmin/turn",
            _known(document, "speed_loss") or f"{percent(document['speed_loss'])} of the speed",
            document["drift_rad_per_output_turn"],
        ),
        *capacity,
        _life(document),
        Figure(
            "Efficiency",
            number(document["efficiency"], 100.0),
            "%",
            _known(document, "efficiency")
            or f"{quantity(document['losses_W']['total'], 'W')} lost{at_temperature(document)}",
            document["efficiency"],
        ),
        Figure("Mass", number(document["mass_kg"]), "kg", "", document["mass_kg"]),
        Figure(
            "Diameter",
            number_in(document["envelope_diameter_m"], "mm"),
            "mm",
            "",
            document["envelope_diameter_m"],
        ),
    ]


def _known(document: Document, key: str) -> str:
    """Why a joint does not have a number, without the explanation behind the colon; empty where it has it."""
    if document[key] is not None:
        return ""
    return "; ".join(reason.partition(":")[0] for reason in document["rolling"]["unknown_because"])


def _capacity(document: Document) -> Figure:
    """Torque capacity in the direction of the torque, with what limits it."""
    capacity = in_its_direction(document, document["torque_capacity"])
    torque = capacity["output_torque_Nm"]
    return Figure("Torque capacity", number(torque), "N·m", capacity["meaning"], torque)


def _life(document: Document) -> Figure:
    """Rating life in hours, in turns of an output whose speed is not known."""
    rolling = document["rolling"]
    hours, turns = document["life_hours"], rolling["life_output_turns"]
    detail = f"{number(rolling['reliability'], 100.0)} % reliability"
    if hours is None and turns is not None:
        return Figure("Life", number(turns), "output turns", detail, turns)
    if hours is None:
        why = rolling["no_life_because"]
        detail = why.partition(":")[0] if why else _known(document, "life_hours")
    return Figure("Life", number(hours), "h", detail, None if hours is None else 3600.0 * hours)
