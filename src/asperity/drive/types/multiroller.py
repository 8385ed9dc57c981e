"""The multiroller drive: two rows of stepped rollers between sun and ring, after A. L. Nasvytis."""

from __future__ import annotations

import math

import numpy as np

from asperity.drive.layout.drive import CARRIER, Drive
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
from asperity.drive.layout.sizes import (
    RING_CROWN,
    SUN_CROWN,
    ContactLength,
    bore,
    crown,
    radius,
    ring_support,
    wall,
)
from asperity.engine.arrays import xp
from asperity.types import Real

_RADII = ("sun", "first_row", "first_row_small", "second_row", "second_row_small")


def _layout(sizes: Tables) -> Places:
    sun, x_1, y_1, x_2, y_2 = (xp.asarray(sizes[f"{name}_radius"], dtype=float) for name in _RADII)
    orbit = sun + x_1
    half = xp.asarray(math.pi / sizes["rollers_per_row"])
    with np.errstate(invalid="ignore"):  # nan where the second row finds no place
        far = orbit * xp.cos(half) + xp.sqrt((y_1 + x_2) ** 2 - (orbit * xp.sin(half)) ** 2)
    return Places(
        centres={
            "first_row": xp.stack([0.0 * orbit, orbit]),
            "second_row": far * xp.stack([-xp.sin(half), xp.cos(half)]),
        },
        radii={"ring": far + y_2},
    )


MULTIROLLER = DriveType(
    name="multiroller",
    words="multiroller",
    summary="Multiroller drive: two rows of stepped rollers between sun and ring, the carrier of the second row "
    "grounded.",
    file_summary="A joint file with a two-row multiroller drive.",
    rank=2,
    sectors=Sectors(
        "rollers_per_row",
        "Number of rollers in each row, equally spaced.",
        "rollers in a row",
        counted="rollers in each row",
        start="4",
    ),
    parts=(
        Part("sun", "axis"),
        Part("first_row", "free"),
        Part("second_row", "pin"),
        Part("ring", "axis"),
    ),
    contacts=(
        Pairing("sf", "sun", "first_row"),
        Pairing("fsl", "first_row", "second_row", tracks=("first_row_small", "")),
        Pairing("fsr", "first_row", "second_row", tracks=("first_row_small", ""), sector=-1),
        Pairing("sr", "second_row", "ring", tracks=("second_row_small", ""), internal=True),
    ),
    sizes=(
        radius("sun", "Radius s of the sun roller, the input.", start="9.4 mm"),
        radius(
            "first_row", "Large radius x_1 of the first row's rollers, which touches the sun.", start="16 mm"
        ),
        radius(
            "first_row_small",
            "Small radius y_1 of the first row's rollers, which touches two rollers of the second row.",
            start="10 mm",
        ),
        radius(
            "second_row",
            "Large radius x_2 of the second row's rollers, which touches two rollers of the first row.",
            start="18 mm",
        ),
        radius(
            "second_row_small",
            "Small radius y_2 of the second row's rollers, which touches the ring, the output.",
            start="10 mm",
        ),
        wall("ring", "Wall of the ring."),
        ContactLength(),
        ring_support(),
        bore(
            "first_row",
            "Diameter of the bore of the first row's rollers, at most 0.65 of that of the smaller track; solid "
            "if absent.",
        ),
        bore(
            "second_row",
            "Diameter of the bore of the second row's rollers, at most 0.65 of that of the smaller track; solid "
            "if absent.",
        ),
        SUN_CROWN,
        crown(
            "first_row",
            "Radius of the crown of the first row's large tracks, along their axes; cylinders if absent.",
        ),
        crown("first_row_small", "Radius of the crown of the first row's small tracks; cylinders if absent."),
        crown("second_row", "Radius of the crown of the second row's large tracks; cylinders if absent."),
        crown(
            "second_row_small", "Radius of the crown of the second row's small tracks; cylinders if absent."
        ),
        RING_CROWN,
    ),
    input="sun",
    output="ring",
    grounded=CARRIER,
    layout=_layout,
    branches=Branches(
        "One roller of each row, the second row's next counter-clockwise.\n\nWrite [[branch]] above each, as many as "
        "rollers in a row, counter-clockwise.",
        "Sizes of the rollers of each sector, where they differ: a section [[branch]] for each.",
        {
            "first_row": "Large radius of the first row's roller above first_row_radius; 0 if absent.",
            "first_row_small": "Its small radius above first_row_small_radius; 0 if absent.",
            "second_row": "Large radius of the second row's roller above second_row_radius; 0 if absent.",
            "second_row_small": "Its small radius above second_row_small_radius; 0 if absent.",
        },
    ),
    assumed=(
        Assumed(
            "the tracks of the rollers of both rows lie in one plane: arrange them symmetrically, or their bearings "
            "carry the tilting moment; in compression a stepped roller is one spring for each contact"
        ),
        Assumed("every track is as long as its longest contact line"),
    ),
)


def two_row_multiroller(
    *,
    sun_radius: Real,
    first_row_radii: tuple[Real, Real],
    second_row_radii: tuple[Real, Real],
    roller_count: Real,
) -> Drive:
    """The multiroller drive with two rows of stepped rollers between sun and ring.

    Parameters
    ----------
    sun_radius : Real
        Radius s [m].
    first_row_radii, second_row_radii : tuple of Real
        Large and small radius x and y of each row's rollers [m]: the sun drives x of the first row, whose y drives x
        of the second, whose y drives the ring.
    roller_count : Real
        Rollers in each row; each second-row roller lies between two of the first row.

    Returns
    -------
    Drive
        Contacts ``sf, fsl, fsr, sr``; sun in, ring out, the carrier of the second row grounded; ratio
        :math:`(x_1/s)(x_2/y_1)(R/y_2)`.

    References
    ----------
    A. L. Nasvytis's multiroller drive as described in NASA's reports on it; the ratio follows from rolling without
    slip.
    """
    radii = (sun_radius, *first_row_radii, *second_row_radii)
    sizes = {f"{name}_radius": size for name, size in zip(_RADII, radii, strict=True)}
    return MULTIROLLER.drive(sizes | {"rollers_per_row": roller_count})
