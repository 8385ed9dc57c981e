"""What a body of a drive is besides its tracks: a solid or hollow roller, or a ring."""

from __future__ import annotations

import math
from typing import Literal

import equinox as eqx

from asperity.types import Real

#: What holds the outer rim of a ring.
RingSupport = Literal["rigid_housing", "free", "elastic_housing"]


class BodyShape(eqx.Module):
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
    """

    kind: Literal["solid", "hollow", "ring"] = eqx.field(static=True)
    size: Real | None = None
    support: RingSupport = eqx.field(static=True, default="free")
    housing_stiffness: Real | None = None
    length: Real | None = None

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


def ring_shape(wall: Real, support: RingSupport | None, housing_stiffness: Real | None) -> BodyShape:
    """A ring as joint files describe it: in a rigid housing where they do not say what holds it."""
    if support == "elastic_housing":
        return BodyShape("ring", wall, "elastic_housing", housing_stiffness)
    return BodyShape("ring", wall, support or "rigid_housing")
