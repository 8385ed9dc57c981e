"""The section [tilt] of joint files: axes that are out of parallel, by their names."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Annotated, Self

from pydantic import BeforeValidator, model_validator

from asperity.drive.layout.drive import CARRIER
from asperity.drive.structure.axis_tilts import AxisTilts
from asperity.errors import InputError, nearest
from asperity.joint_file import limits
from asperity.joint_file.quantity_key import Entered
from asperity.joint_file.section import Section

#: What the keys of [tilt] end on, behind the name of a body.
_AXIS = "_axis"


def _slope(written: object) -> float:
    """Slope of an axis [rad]."""
    slope = limits.AXIS_TILT.read(written)
    if slope.tolerance:
        raise InputError(f"a tilt has no tolerance here, got {written!r}: state the largest one")
    return slope.value


AxisTilt = Annotated[float, BeforeValidator(_slope, json_schema_input_type=str), Entered(limits.AXIS_TILT)]


class TiltEntry(Section):
    """Tilt of one axis over its length; its NAME is sun_axis, ring_axis, carrier_axis with all pins, and the like."""

    out: AxisTilt | None = None
    """Slope away from the axis of the drive: towards the first roller off it, planet 1, for bodies on the axis and for
    the carrier; a pin's towards its own roller, in every sector. It opens contacts in that direction at one end."""
    across: AxisTilt | None = None
    """Slope a right angle counter-clockwise from there. It skews contacts in the direction of out."""

    @model_validator(mode="after")
    def _some_tilt(self) -> Self:
        if self.out is None and self.across is None:
            raise InputError('out, across: one of both must be given, e.g. out = "1 mrad"')
        return self


def misnamed_tilts(
    entries: Mapping[str, TiltEntry], bodies: Mapping[str, str], floating: tuple[str, ...]
) -> Iterator[str]:
    """Messages about tilts of what has no axis to tilt; ``bodies``: name → place, of one sector of the drive.

    ``floating``: names of bodies on the axis that no bearing holds.
    """
    held = [name for name, place in bodies.items() if place != "free" and name not in floating]
    if "pin" in bodies.values():
        held.append(CARRIER)
    known = tuple(f"{name}{_AXIS}" for name in held)
    for key in entries:
        name = key.removesuffix(_AXIS)
        if key.endswith(_AXIS) and name in bodies and name not in held:
            yield (
                f"tilt.{key}: tilt of a floating body: no bearing holds its axis, which goes where its contacts put "
                f"it; state that of {', '.join(known)}"
            )
        elif key not in known:
            yield f"tilt.{key}: the drive has no such axis{nearest(key, known) or '; it has ' + ', '.join(known)}"


def axis_tilts(entries: Mapping[str, Mapping[str, float]] | None) -> AxisTilts | None:
    """The tilts of tables in SI units; None where a file states none."""
    if entries is None:
        return None
    return AxisTilts(
        bodies=tuple(key.removesuffix(_AXIS) for key in entries),
        out=tuple(entry.get("out", 0.0) for entry in entries.values()),
        across=tuple(entry.get("across", 0.0) for entry in entries.values()),
    )
