"""The content of a joint file: a class for each section, a field for each key."""

from __future__ import annotations

import math
from typing import Annotated

from pydantic import BeforeValidator, Field

from asperity.errors import InputError
from asperity.joint_file import limits
from asperity.joint_file.quantity_key import Entered, Quantity
from asperity.joint_file.section import (
    Section,
)

Length = Annotated[Quantity, limits.ROLLER_RADIUS]
ContactLength = Annotated[Quantity, limits.CONTACT_LENGTH]
BodyLength = Annotated[Quantity, limits.BODY_LENGTH]
PushAngle = Annotated[Quantity, limits.PUSH_ANGLE]
Friction = Annotated[Quantity, limits.FRICTION_COEFFICIENT]
BearingTorque = Annotated[Quantity, limits.BEARING_TORQUE]
CrownRadius = Annotated[Quantity, limits.CROWN_RADIUS]
Skew = Annotated[Quantity, limits.SKEW]


class Lubrication(Section):
    """The oil; without it the contacts are dry."""

    viscosity: Annotated[Quantity, limits.VISCOSITY]
    """Viscosity of the oil at the inlet of the contacts; makes the rolling loss of the oil."""
    pressure_coefficient: Annotated[Quantity, limits.PRESSURE_COEFFICIENT] | None = None
    """Pressure coefficient of the viscosity; makes the thickness of the oil film, which is left out without it."""
    roughness: Annotated[Quantity, limits.ROUGHNESS] | None = None
    """Root mean square of the heights of both surfaces together, sqrt(Rq1^2 + Rq2^2); makes the ratio lambda of the oil
    film to it. From the Ra of [surface], where all contacts have one, if absent: 1.2533 times the Ra of both."""


_Share = Annotated[float, Field(gt=0.0, le=1.0)] | str


def _share(written: object) -> float:
    """A share of the time, as a number or as text in per cent."""
    found = limits.SHARE.read(written)
    if found.tolerance:
        raise InputError(f"a share of the time has no tolerance, got {written!r}")
    return found.value


class DutyLoad(Section):
    """One load of the duty; write [[duty]] above each."""

    output_torque: Annotated[Quantity, limits.DUTY_TORQUE]
    """Torque at the output; negative where it drives the rotation."""
    sun_speed: Annotated[Quantity, limits.SUN_SPEED]
    """Speed of the sun, or of the input, whatever its name."""
    share: Annotated[float, BeforeValidator(_share, json_schema_input_type=_Share), Entered(limits.SHARE)]
    """Share of the time, as 0.4 or "40 %"; the shares of all loads add up to 1."""


Duty = Annotated[tuple[DutyLoad, ...], Field(min_length=1)]


def refuse_part_of_a_duty(duty: tuple[DutyLoad, ...] | None) -> None:
    """Refuse a duty whose loads do not share the whole time."""
    total = math.fsum(load.share for load in duty or ())
    if duty is not None and abs(total - 1.0) > 1e-9:
        raise InputError(f"the shares of [[duty]] must add up to 1, they add up to {total:.10g}")


class DynamicsEntry(Section):
    """What is coupled to the joint, for its natural frequencies."""

    input_inertia: Annotated[Quantity, limits.INPUT_INERTIA]
    """Moment of inertia of motor and coupling at the sun."""
    output_inertia: Annotated[Quantity, limits.OUTPUT_INERTIA]
    """Moment of inertia of the load at the carrier, the carrier included."""
    loss_factor: Annotated[Quantity, limits.LOSS_FACTOR] | None = None
    """Loss factor of the joint's spring; without it the spring loses no work."""


class PlayEntry(Section):
    """Play at the output; a joint file without this section has none."""

    angle: Annotated[Quantity, limits.PLAY_ANGLE]
    """Angle that the output turns freely on passing zero torque, from one side to the other."""
    take_up_torque: Annotated[Quantity, limits.TAKE_UP_TORQUE]
    """Torque T_p over which the play is taken up, angle/2 tanh(T/T_p); 0 for all at once."""
