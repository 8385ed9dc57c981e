"""What a type of drive says of the keys of its section [drive]: meaning, range and unit; plain data.

The room of the joint files makes keys with units of it. Ranges only catch typing errors such as a wrong prefix where
physics sets no bound.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Range:
    """What a number measures and the range that it may have.

    ``dimension`` is the name of one of :class:`asperity.unit_table.Dimension`; ``lower`` and ``upper`` are in ``unit``;
    ``open_lower`` leaves out the bound itself; ``integer``: only whole numbers. ``example`` is what messages quote; if
    empty, that of the dimension. ``reason``: why nothing below the range is possible.
    """

    dimension: str
    lower: float
    upper: float
    unit: str = "1"
    open_lower: bool = False
    integer: bool = False
    example: str = ""
    reason: str = ""


#: Equal sectors between which the members on the axis stay centred by themselves.
SECTORS = Range(
    "DIMENSIONLESS",
    2,
    100,
    integer=True,
    example="3",
    reason="the forces of a single one would push the members on the axis off it, and what their bearings bear then is "
    "not computed",
)
RADIUS = Range("LENGTH", 1e-3, 1e5, "mm")
WALL_THICKNESS = Range("LENGTH", 1e-3, 1e5, "mm", example="10 mm")
BODY_LENGTH = Range("LENGTH", 0.0, 1e5, "mm", example="5 mm")
BORE_DIAMETER = Range("LENGTH", 0.0, 1e5, "mm", open_lower=True, example="4 mm")
CROWN_RADIUS = Range("LENGTH", 1.0, 1e9, "mm", example="1000 mm")
PROFILE_LOAD = Range("FORCE", 0.0, 1e9, "N", open_lower=True, example="1000 N")
#: Profiles of tracks along their axis besides crowns.
LOGARITHMIC, ISO_16281 = "logarithmic", "iso_16281"
DEVIATION = Range("LENGTH", -1e4, 1e4, "um", example="2 um")
PUSH_ANGLE = Range("ANGLE", -60.0, 60.0, "deg")
SPRING = Range("STIFFNESS", 1e-6, 1e15, "N/mm", example="2e5 N/mm")
BEARING_TORQUE = Range("TORQUE", 0.0, 1e6, "N*m", example="0.02 N*m")
PIN_FRICTION_COEFFICIENT = Range("DIMENSIONLESS", 0.0, 10.0, example="0.002")


@dataclass(frozen=True)
class Size:
    """A number of a section: its key, what it means, its range, and a value to start with in a template."""

    key: str
    meaning: str
    range: Range
    required: bool = True
    start: str = ""


@dataclass(frozen=True)
class Choice:
    """A word of a section, one of several; ``default`` is the word that stands for an absent key, None for none."""

    key: str
    meaning: str
    words: tuple[str, ...]
    required: bool = False
    default: str | None = None


@dataclass(frozen=True)
class ContactLength:
    """The key ``contact_length``: one for all contacts, or a table with one for each; a value to start with."""

    start: str = "10 mm"
    key: str = "contact_length"


Entry = Size | Choice | ContactLength


def radius(name: str, meaning: str, *, start: str = "") -> Size:
    """The radius of a track, ``NAME_radius``."""
    return Size(f"{name}_radius", meaning, RADIUS, start=start)


def wall(name: str, meaning: str, *, start: str = "10 mm") -> Size:
    """The wall of a ring, ``NAME_wall_thickness``."""
    return Size(f"{name}_wall_thickness", meaning, WALL_THICKNESS, start=start)


def bore(name: str, meaning: str) -> Size:
    """The bore of a roller, ``NAME_bore_diameter``; solid if absent."""
    return Size(f"{name}_bore_diameter", meaning, BORE_DIAMETER, required=False)


def body_length(name: str, meaning: str) -> Size:
    """The length of a roller along its axis, ``NAME_length``."""
    return Size(f"{name}_length", meaning, BODY_LENGTH, required=False)


def crown(name: str, meaning: str) -> Size:
    """The crown of a track, ``NAME_crown_radius``; a cylinder if absent."""
    return Size(f"{name}_crown_radius", meaning, CROWN_RADIUS, required=False)


def profile(name: str, *, ring: bool) -> tuple[Choice, Size]:
    """The profile of a track in place of its crown, ``NAME_profile``, and the load of one, ``NAME_profile_load``.

    Of the bore of a ``ring`` the standard for rollers knows none.
    """
    words = name.replace("_", " ")
    standard = (
        " ISO/TS 16281 has none for rings."
        if ring
        else f" {ISO_16281}: that of the standard, of 0.00035 times the diameter, for lines of at most 2.5 diameters."
    )
    return (
        Choice(
            f"{name}_profile",
            f"Profile along the axis in place of {name}_crown_radius. {LOGARITHMIC}: Lundberg's, of a normal force "
            f"{name}_profile_load.{standard} A cylinder, or the crown, if absent.",
            (LOGARITHMIC,) if ring else (LOGARITHMIC, ISO_16281),
        ),
        Size(
            f"{name}_profile_load",
            f"Normal force that the logarithmic profile of {words} alone spreads evenly over the line of each of its "
            "contacts.",
            PROFILE_LOAD,
            required=False,
        ),
    )


#: Crowns that most drives have.
SUN_CROWN = crown(
    "sun",
    "Radius of the sun's crown along its axis, highest in the middle of the contact line; a cylinder if absent.",
)
RING_CROWN = crown("ring", "Radius of the ring's crown along its axis; a cylinder if absent.")


def ring_support(
    of: str = "the ring",
    *,
    name: str = "ring",
    held_by: str = "a rigid housing, nothing, so that it bends, or",
) -> Choice:
    """What holds the outer rim of a ring, ``NAME_support``; ``held_by`` are the words before an elastic housing."""
    return Choice(
        f"{name}_support",
        f"What holds the outer rim of {of}: {held_by} a housing with the ring_housing_stiffness of [compliance] or the "
        "sizes in [housing]. A rigid housing if absent.",
        ("rigid_housing", "free", "elastic_housing"),
    )
