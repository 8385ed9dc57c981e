"""What a body of a planar drive is besides its tracks: a solid or hollow roller, or a ring."""

from __future__ import annotations

from typing import Literal

import equinox as eqx

from asperity.types import Real


class BodyShape(eqx.Module):
    """What a body is besides its tracks.

    Parameters
    ----------
    kind : {"solid", "hollow", "ring"}
        Solid roller, roller with a bore, or ring with its tracks inside.
    size : Real or None
        Diameter of the bore, or wall of the ring [m].
    support : {"free", "rigid_housing"}
        What holds the outer rim of a ring.
    length : Real or None
        Length of its tracks [m]; None for that of the longest contact line on each.
    """

    kind: Literal["solid", "hollow", "ring"] = eqx.field(static=True)
    size: Real | None = None
    support: Literal["free", "rigid_housing"] = eqx.field(static=True, default="free")
    length: Real | None = None

    @property
    def bore_diameter(self) -> Real | None:
        """Diameter of the bore of a hollow roller [m]; None for other bodies."""
        return self.size if self.kind == "hollow" else None


SOLID = BodyShape("solid")
