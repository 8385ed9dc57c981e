"""How a joint vibrates between motor and load."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint.pin_bound import bounded
from asperity.types import Document
from asperity.views.blocks import Block, Paragraph, Table
from asperity.views.numbers import number

_QUANTITIES = {
    "stiffness_output_Nm_per_rad": ("torsional stiffness at the output, assembled", "N·m/rad"),
    "input_inertia_at_output_kg_m2": ("inertia of motor and input, at the output", "kg·m²"),
    "spin_inertia_at_output_kg_m2": ("inertia of the rollers' spin, at the output", "kg·m²"),
    "output_inertia_kg_m2": ("inertia of load and all other motions", "kg·m²"),
    "locked_frequency_Hz": ("natural frequency, motor locked (antiresonance)", "Hz"),
    "free_frequency_Hz": ("natural frequency, both sides free (resonance)", "Hz"),
}
_OF_CREEP = {
    "creep_damping_Nms_per_rad": ("creep: torque per speed lost", "N·m·s/rad"),
    "corner_frequency_Hz": ("creep: corner frequency", "Hz"),
}
_OVER_TORQUE = {
    "torque\nN·m": "output_torque_Nm",
    "stiffness\nN·m/rad": "stiffness_output_Nm_per_rad",
    "motor locked\nHz": "locked_frequency_Hz",
    "both free\nHz": "free_frequency_Hz",
    "creep corner\nHz": "corner_frequency_Hz",
}


def dynamics(document: Document, *, damped: bool) -> Iterator[Block]:
    """Stiffness, inertias and frequencies at the torque and over it, from a document of dynamics.

    ``damped``: whether the file states how much work the spring loses.
    """
    at, over, bound = document["at_torque"], document["over_torque"], document["stiffness_bound"]
    creeps = at["creep_damping_Nms_per_rad"] is not None
    rows = [
        (bounded(said, bound) if _of_spring(key) else said, f"{number(at[key])} {unit}")
        for key, (said, unit) in {**_QUANTITIES, **(_OF_CREEP if creeps else {})}.items()
    ]
    yield Table(f"At an output torque of {number(at['output_torque_Nm'])} N·m", ("quantity", "value"), rows)
    yield Table(
        bounded("Over torque", bound),
        tuple(_OVER_TORQUE),
        list(zip(*(map(number, over[key][::4]) for key in _OVER_TORQUE.values()), strict=True)),
        words=(),
    )
    yield Paragraph(_about_damping(at, damped))


def _about_damping(at: Document, damped: bool) -> str:
    if at["creep_damping_Nms_per_rad"] is not None:
        said = "Below the creep corner frequency a joint that turns yields like a damper, above it like its spring."
    elif at["corner_frequency_Hz"] == 0.0:
        said = "The input stands: creep does not act."
    else:
        said = (
            "Creep is left out: under this torque the joint does not roll steadily, or a branch of it slips."
        )
    spring = "the spring loses no work, and nothing but creep limits the resonance."
    undamped = "" if damped else f" No dynamics.loss_factor: {spring}"
    return f"{said}{undamped} Play is not part of it."


def _of_spring(key: str) -> bool:
    """Whether a number of the document is a stiffness, or a frequency of the spring, which grows with it."""
    return key in (
        "stiffness_output_Nm_per_rad",
        "locked_frequency_Hz",
        "free_frequency_Hz",
        "corner_frequency_Hz",
    )
