"""Rolling bearings in a joint file."""

from __future__ import annotations

from typing import Annotated, Literal

from asperity.joint_file import limits
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import Section

LoadRating = Annotated[Quantity, limits.LOAD_RATING]


class PinBearing(Section):
    """Rolling bearings between a roller and its carrier pin, for their life; none if the section is absent."""

    type: Literal["ball", "roller"]
    """Rolling elements; needle bearings are roller bearings."""
    dynamic_rating: LoadRating
    """Basic dynamic radial load rating C of one bearing, from its catalogue."""
    static_rating: LoadRating
    """Basic static radial load rating C_0 of one bearing, from its catalogue."""
    count: Annotated[Quantity, limits.BEARING_COUNT]
    """Bearings of one roller, which share its pin force equally."""


class HeldBearing(Section):
    """A bearing on the axis of the drive, which equal branches do not load."""

    type: Literal["ball", "roller"]
    """Rolling elements; needle bearings are roller bearings."""
    dynamic_rating: LoadRating
    """Basic dynamic radial load rating C of one bearing, from its catalogue."""
    static_rating: LoadRating
    """Basic static radial load rating C_0 of one bearing, from its catalogue."""
    outside_force: Annotated[Quantity, limits.OUTSIDE_FORCE]
    """Radial force on the most loaded bearing from outside the drive: weights, belts, couplings, the arm."""
