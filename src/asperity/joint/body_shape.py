"""What a body of a drive is besides its tracks: a solid or hollow roller, or a ring; the housing that holds rings."""

from __future__ import annotations

import dataclasses
import math
from typing import Literal

from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.materials import Material
from asperity.types import Real

#: What holds the outer rim of a ring.
RingSupport = Literal["rigid_housing", "free", "elastic_housing"]


class BodyShape(Module):
    """What a body is besides its tracks.

    Parameters
    ----------
    kind : {"solid", "hollow", "ring"}
        Solid roller, roller with a bore, or ring with its tracks inside.
    size : Real or None
        Diameter of the bore, or wall of the ring [m].
    support : {"free", "rigid_housing", "elastic_housing"}
        What holds the outer rim of a ring.
    housing_stiffness : Real or None
        Radial stiffness of an elastic housing, per area of the outer rim [N/m^3]; None for others.
    length : Real or None
        Length along the axis, for mass and pin [m]; None: that of the contact lines.
    pin_diameter : Real or None
        Of the pin that presses in the bore of a hollow roller [m]; None where it is not known.
    """

    kind: Literal["solid", "hollow", "ring"] = static()
    size: Real | None = None
    support: RingSupport = static(default="free")
    housing_stiffness: Real | None = None
    length: Real | None = None
    pin_diameter: Real | None = None

    @property
    def rim_stiffness(self) -> tuple[Real, Real]:
        """Radial and tangential stiffness of what holds the outer rim of a ring, per area [N/m^3].

        A rigid housing holds it in both directions, an elastic one in the radial direction only.
        """
        if self.support == "elastic_housing":
            assert self.housing_stiffness is not None
            return self.housing_stiffness, 0.0
        return (math.inf, math.inf) if self.support == "rigid_housing" else (0.0, 0.0)

    @property
    def bore_diameter(self) -> Real | None:
        """Diameter of the bore of a hollow roller [m]; None for other bodies."""
        return self.size if self.kind == "hollow" else None


SOLID = BodyShape("solid")


class Housing(Module):
    """The housing into which the rings are pressed that are not free.

    Parameters
    ----------
    material : Material
        Its material.
    outer_radius : Real
        Its outer radius [m].
    interference : Real
        By how much the outer diameter of a ring exceeds the bore at the assembly [m].
    friction_coefficient : Real
        Of the seat [-].
    temperature_rise : Real or None, optional
        Working temperature above that of the assembly [K]; None where the file states none.
    assembly_temperature : Real or None, optional
        Temperature of the assembly [degC]; None where the file states none.
    """

    material: Material
    outer_radius: Real
    interference: Real
    friction_coefficient: Real
    temperature_rise: Real | None = None
    assembly_temperature: Real | None = None


#: Bore that stands for none, over the radius of the roller.
_NO_BORE = 1e-4


def on_pin(shape: BodyShape, diameter: Real, radius: Real) -> BodyShape:
    """A roller on a pin: a solid one has a bore as wide as its pin; a pin of no width presses in no bore."""
    if shape.kind == "hollow":
        return dataclasses.replace(shape, pin_diameter=diameter)
    if isinstance(diameter, float) and diameter > 0.0:
        return dataclasses.replace(shape, kind="hollow", size=diameter, pin_diameter=diameter)
    bore = xp.where(xp.asarray(diameter) > 0.0, diameter, _NO_BORE * radius)
    return dataclasses.replace(shape, kind="hollow", size=bore, pin_diameter=diameter)


def ring_shape(wall: Real, support: RingSupport | None, housing_stiffness: Real | None) -> BodyShape:
    """A ring as joint files describe it: in a rigid housing where they do not say what holds it."""
    if support == "elastic_housing":
        return BodyShape("ring", wall, "elastic_housing", housing_stiffness)
    return BodyShape("ring", wall, support or "rigid_housing")
