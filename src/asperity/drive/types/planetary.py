"""The plain planetary drive: planets between a sun and a ring that presses them together."""

from __future__ import annotations

from asperity.drive.layout.drive import CARRIER, Drive
from asperity.drive.layout.drive_type import Branches, DriveType, Pairing, Part, Places, Sectors, Tables
from asperity.drive.layout.sizes import (
    RING_CROWN,
    SUN_CROWN,
    Choice,
    ContactLength,
    body_length,
    bore,
    crown,
    radius,
    ring_support,
    wall,
)
from asperity.engine.arrays import xp
from asperity.types import Real


def _layout(sizes: Tables) -> Places:
    sun, planet = (xp.asarray(sizes[f"{name}_radius"], dtype=float) for name in ("sun", "planet"))
    return Places(centres={"planet": xp.stack([0.0 * sun, sun + planet])}, radii={"ring": sun + 2.0 * planet})


def _roles(sizes: Tables) -> tuple[str, str]:
    return ("ring", CARRIER) if sizes.get("output") == "ring" else (CARRIER, "ring")


PLANETARY = DriveType(
    name="planetary",
    words="planetary",
    summary="Plain planetary drive: planets between a sun and a ring, which presses them together.",
    file_summary="A joint file with a plain planetary drive.",
    rank=1,
    sectors=Sectors("planets", "Number of planets, equally spaced.", "planets", each="planet"),
    parts=(Part("sun", "axis"), Part("planet", "pin"), Part("ring", "axis")),
    contacts=(Pairing("sp", "sun", "planet"), Pairing("pr", "planet", "ring", internal=True)),
    sizes=(
        radius("sun", "Radius R_s of the sun roller, the input.", start="10 mm"),
        radius(
            "planet",
            "Radius R_p of the planets; the ring's inner radius is R_s + 2 R_p, less the interference.",
            start="20 mm",
        ),
        wall("ring", "Wall of the ring."),
        ContactLength(),
        Choice(
            "output",
            "Which member is the output, the other one being grounded: the carrier if absent.",
            ("carrier", "ring"),
        ),
        ring_support(),
        bore("planet", "Diameter of the bore of hollow planets; solid if absent."),
        body_length(
            "planet",
            "Length of a planet, for its mass and its pin; if absent, the longest contact line on it.",
        ),
        SUN_CROWN,
        crown("planet", "Radius of the planets' crown along their axes; cylinders if absent."),
        RING_CROWN,
    ),
    input="sun",
    output=CARRIER,
    grounded="ring",
    layout=_layout,
    roles=_roles,
    branches=Branches(
        "One planet; write [[branch]] above each, as many as planets, counter-clockwise.",
        "Sizes of each planet, where they differ: a section [[branch]] for each.",
        {"planet": "Radius of this planet above planet_radius; 0 if absent."},
    ),
)


def planetary_drive(*, sun_radius: Real, planet_radius: Real, planet_count: Real) -> Drive:
    """The simple planetary drive: planets between a sun and a ring that presses them together.

    Parameters
    ----------
    sun_radius, planet_radius : Real
        Radii [m]; the ring's is the sun's and twice the planets'.
    planet_count : Real
        Number of planets.

    Returns
    -------
    Drive
        Contacts ``sp, pr``; sun in, carrier out, ring grounded; ratio 1 + R_r/R_s.

    References
    ----------
    Willis' equation with a fixed ring.
    """
    return PLANETARY.drive(
        {"sun_radius": sun_radius, "planet_radius": planet_radius, "planets": planet_count}
    )
