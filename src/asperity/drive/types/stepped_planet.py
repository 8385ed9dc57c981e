"""The drive of high ratio: stepped planets roll in a grounded ring and in a driven ring of almost the same size."""

from __future__ import annotations

from asperity.drive.layout.drive import Drive
from asperity.drive.layout.drive_type import (
    Assumed,
    Branches,
    DriveType,
    Pairing,
    Part,
    Places,
    Sectors,
    Tables,
)
from asperity.drive.layout.sizes import SUN_CROWN, ContactLength, bore, crown, radius, ring_support, wall
from asperity.engine.arrays import xp
from asperity.types import Real

_RADII = ("sun", "planet", "planet_second")


def _layout(sizes: Tables) -> Places:
    sun, one, two = (xp.asarray(sizes[f"{name}_radius"], dtype=float) for name in _RADII)
    return Places(
        centres={"planet": xp.stack([0.0 * sun, sun + one])},
        radii={"ring": sun + 2.0 * one, "driven_ring": sun + one + two},
    )


STEPPED_PLANET = DriveType(
    name="stepped_planet",
    words="stepped planet",
    summary="Drive of high ratio: stepped planets roll in a grounded ring and in a driven ring; the carrier is a free "
    "cage.",
    file_summary="A joint file with a drive of stepped planets.",
    rank=3,
    sectors=Sectors("planets", "Number of planets, equally spaced.", "planets", each="planet"),
    parts=(
        Part("sun", "axis"),
        Part("planet", "pin"),
        Part("held_ring", "axis", key="ring"),
        Part("driven_ring", "axis"),
    ),
    contacts=(
        Pairing("sp", "sun", "planet"),
        Pairing("pr1", "planet", "held_ring", internal=True),
        Pairing("pr2", "planet", "driven_ring", tracks=("planet_second", ""), internal=True),
    ),
    sizes=(
        radius("sun", "Radius s of the sun roller, the input.", start="10 mm"),
        radius(
            "planet", "Radius p_1 of the track that touches the sun and the grounded ring.", start="20 mm"
        ),
        radius(
            "planet_second",
            "Radius p_2 of the track that touches the driven ring, the output.",
            start="18 mm",
        ),
        wall("ring", "Wall of the grounded ring."),
        wall("driven_ring", "Wall of the driven ring, which carries itself."),
        ContactLength(),
        ring_support("the grounded ring", held_by="a rigid housing, nothing, or"),
        bore(
            "planet",
            "Diameter of the bore of hollow planets, at most 0.65 of that of the smaller track; solid "
            "if absent.",
        ),
        SUN_CROWN,
        crown(
            "planet",
            "Radius of the crown of the planets' first track, along their axes; cylinders if absent.",
        ),
        crown("planet_second", "Radius of the crown of the planets' second track; cylinders if absent."),
        crown("ring", "Radius of the grounded ring's crown along its axis; a cylinder if absent."),
        crown("driven_ring", "Radius of the driven ring's crown along its axis; a cylinder if absent."),
    ),
    input="sun",
    output="driven_ring",
    grounded="held_ring",
    layout=_layout,
    branches=Branches(
        "One stepped planet; write [[branch]] above each, as many as planets, counter-clockwise.",
        "Sizes of each planet, where they differ: a section [[branch]] for each.",
        {
            "planet": "Radius of the track in the grounded ring above planet_radius; 0 if absent.",
            "planet_second": "Radius of the track in the driven ring above planet_second_radius; 0 if absent.",
        },
    ),
    assumed=(
        Assumed(
            "the tracks of the planets lie in one plane: arrange them symmetrically, or their bearings carry the "
            "tilting moment; in compression a stepped roller is one spring for each contact"
        ),
        Assumed("both rings have the interference; the driven ring has no support"),
        Assumed("every track is as long as its longest contact line"),
    ),
)


def stepped_planet_drive(*, sun_radius: Real, planet_radii: tuple[Real, Real], planet_count: Real) -> Drive:
    """A drive of high ratio: stepped planets roll in a fixed ring and in a driven ring of slightly different radii.

    Parameters
    ----------
    sun_radius : Real
        Radius s [m].
    planet_radii : tuple of Real
        Radii p_1 of the track in the fixed ring, which also touches the sun, and p_2 of that in the driven one [m].
    planet_count : Real
        Number of planets.

    Returns
    -------
    Drive
        Contacts ``sp, pr1, pr2``; sun in, second ring out, first ring grounded, the carrier a free cage; ratio
        :math:`(1 + R_1/s)/(1 - R_1 p_2/(R_2 p_1))`.

    References
    ----------
    Willis' equation applied to both rings.
    """
    sizes = {f"{name}_radius": size for name, size in zip(_RADII, (sun_radius, *planet_radii), strict=True)}
    return STEPPED_PLANET.drive(sizes | {"planets": planet_count})
