"""The wedge drive of Zou et al. 2025: two loading rollers in the wedges between each planet and the ring."""

from __future__ import annotations

from asperity.drive.layout.drive import CARRIER, Closure, Drive
from asperity.drive.layout.drive_type import (
    Assumed,
    Branches,
    DriveType,
    OwnBearings,
    Pairing,
    Part,
    Places,
    Sectors,
    Tables,
)
from asperity.drive.layout.sizes import (
    BEARING_TORQUE,
    PIN_FRICTION_COEFFICIENT,
    PUSH_ANGLE,
    RING_CROWN,
    Choice,
    ContactLength,
    Size,
    body_length,
    bore,
    crown,
    radius,
    ring_support,
    wall,
)
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.engine.arrays import xp
from asperity.types import Real

#: What the paper assumes of its drive: both contacts of a planet with its loading rollers have one coefficient (A3).
EQUAL_COEFFICIENTS = (("pwr", "pwl"),)
#: The body whose pin force a soft preload spring between two carriers keeps.
SPRING_LOADED_PINS = ("right_loading_roller",)

_SIZES = (
    *(f"{name}_radius" for name in ("sun", "planet", "loading_roller", "ring")),
    "left_push_angle",
    "right_push_angle",
)


def _layout(sizes: Tables) -> Places:
    sides = triangle(DriveGeometry(**{name: sizes[name] for name in _SIZES}, planet_count=sizes["planets"]))
    x, y = sides.roller_orbit * sides.sin_polar, sides.roller_orbit * sides.cos_polar
    zero = xp.zeros_like(x)
    return Places(
        centres={
            "planet": xp.stack([zero, zero + sides.planet_orbit]),
            "right_loading_roller": xp.stack([x, y]),
            "left_loading_roller": xp.stack([-x, y]),
        },
        # the right pin pushes counter-clockwise, so that outward is the other way round from the clockwise tangent
        push_angles={
            "right_loading_roller": -xp.asarray(sizes["right_push_angle"]),
            "left_loading_roller": sizes["left_push_angle"],
        },
    )


def _closure(tables: Tables) -> Closure:
    model = tables.get("model", {})
    return Closure(
        equal_coefficients=EQUAL_COEFFICIENTS if model.get("traction_split") == "equal_coefficients" else (),
        constant_pins=SPRING_LOADED_PINS if model.get("closure") == "constant_pin_force" else (),
    )


WEDGE = DriveType(
    name="wedge",
    former_names=("zou2025",),
    example="zou2025",
    words="wedge",
    summary="Radii and arrangement of the drive.",
    file_summary="A joint file: a planetary traction drive under load.",
    rank=0,
    default_type=True,
    sectors=Sectors("planets", "Number of planets, equally spaced.", "planets"),
    parts=(
        Part("sun", "axis"),
        Part("planet", "free"),
        Part("right_loading_roller", "pin", "loading_roller", "loading_roller", "right_roller"),
        Part("left_loading_roller", "pin", "loading_roller", "loading_roller", "left_roller"),
        Part("ring", "axis"),
    ),
    contacts=(
        Pairing("sp", "sun", "planet"),
        Pairing("pwr", "planet", "right_loading_roller"),
        Pairing("pwl", "planet", "left_loading_roller"),
        Pairing("wro", "right_loading_roller", "ring", internal=True),
        Pairing("wlo", "left_loading_roller", "ring", internal=True),
    ),
    sizes=(
        radius("sun", "Radius R_s of the sun roller.", start="4 mm"),
        radius("planet", "Radius R_p of the planets.", start="13.5 mm"),
        radius("loading_roller", "Radius R_w of the loading rollers, two to a planet.", start="5 mm"),
        radius("ring", "Inner radius R_o of the fixed outer ring.", start="40 mm"),
        wall("ring", "Wall of the outer ring.", start="60 mm"),
        ContactLength("5 mm"),
        Size(
            "left_push_angle",
            "Direction gamma_l of the carrier's push on the left loading roller, from the tangent.",
            PUSH_ANGLE,
            start="0 deg",
        ),
        Size(
            "right_push_angle",
            "Direction gamma_r of the carrier's push on the right loading roller, from the tangent.",
            PUSH_ANGLE,
            start="0 deg",
        ),
        body_length("planet", "Length of a planet, for its mass; if absent, the longest contact line on it."),
        body_length(
            "loading_roller",
            "Length of a loading roller, for its mass; if absent, the longest contact line on it.",
        ),
        bore("planet", "Diameter of the bore of hollow planets; solid if absent."),
        bore("loading_roller", "Diameter of the bore of hollow loading rollers; solid if absent."),
        crown(
            "sun",
            "Radius of the sun's crown along its axis, highest in the middle of the contact line; over a length B it "
            "drops by B^2/8 over this radius at the ends. A cylinder if absent.",
        ),
        crown("planet", "Radius of the planets' crown along their axes; cylinders if absent."),
        crown(
            "loading_roller", "Radius of the loading rollers' crown along their axes; cylinders if absent."
        ),
        RING_CROWN,
        ring_support(held_by="a rigid housing into which it is shrunk, nothing, so that it bends, or"),
    ),
    input="sun",
    output=CARRIER,
    grounded="ring",
    sense=-1,  # as the paper has it; so that a positive torque loads the right roller
    layout=_layout,
    closure=_closure,
    branches=Branches(
        "One planet with its loading rollers; write [[branch]] above each, as many as planets.",
        "Sizes of each planet and its loading rollers, where they differ: a section [[branch]] for each planet.",
        {
            "planet": "Radius of this planet above planet_radius; 0 if absent.",
            "right_roller": "Radius of its right loading roller above loading_roller_radius; 0 if absent.",
            "left_roller": "Radius of its left loading roller above loading_roller_radius; 0 if absent.",
        },
    ),
    bearings=OwnBearings(
        summary="Friction of the bearings, and the pins of the loading rollers; a joint file without this section has "
        "none.",
        keys=(
            Size("sun_torque", "Friction torque of one of the two sun bearings.", BEARING_TORQUE),
            Size(
                "loading_roller_torque",
                "Constant friction torque of one of the two bearings of a loading roller.",
                BEARING_TORQUE,
            ),
            Size("carrier_torque", "Friction torque of one of the two carrier bearings.", BEARING_TORQUE),
            Size(
                "pin_friction_coefficient",
                "Friction coefficient mu_b of the loading rollers' pins: friction force over pin force, at "
                "pin_friction_diameter, or at pin_diameter; it needs one of them.",
                PIN_FRICTION_COEFFICIENT,
            ),
        ),
        sections={
            "sun_bearing": "Rolling bearings of the sun's shaft, for their life under forces from outside.",
            "carrier_bearing": "Rolling bearings of the carrier, for their life under forces from outside.",
        },
        called={
            "sun_bearing": "input_bearing",
            "carrier_bearing": "output_bearing",
            "sun_torque": "input_torque",
            "carrier_torque": "output_torque",
            "loading_roller_torque": "roller_torque",
        },
    ),
    model=(
        Choice(
            "closure",
            "What keeps the preload under torque: the interference of the parts, or a soft spring that keeps the force "
            "of the right pin.",
            ("elastic", "constant_pin_force"),
            required=True,
        ),
        Choice(
            "traction_split",
            "How both loading rollers of a planet share its torque while the drive stands: by the slip of their "
            "contacts, or with equal traction coefficients, as the paper's closure assumes; springs if absent.",
            ("springs", "equal_coefficients"),
            default="springs",
        ),
        Choice(
            "carrier_balance",
            "Moment of the carrier: with the friction torques of the loading rollers' bearings, complete, or without "
            "them as equation (5) is printed; complete if absent.",
            ("complete", "printed"),
        ),
    ),
    assumed=tuple(
        Assumed(f"no drive.{key}: as long as the longest contact line on it", unless=key)
        for key in ("planet_length", "loading_roller_length")
    ),
)


def wedge_drive(geometry: DriveGeometry, *, planet_count: Real, closure: Closure | None = None) -> Drive:
    """The planetary drive of Zou et al. 2025: two loading rollers in the wedges between each planet and the ring.

    Parameters
    ----------
    geometry : DriveGeometry
        Radii and push angles.
    planet_count : Real
        Number of planets.
    closure : Closure or None, optional
        The paper's assumptions, :data:`EQUAL_COEFFICIENTS` and :data:`SPRING_LOADED_PINS`; None for neither.

    Returns
    -------
    Drive
        Contacts ``sp, pwr, pwl, wro, wlo``; sun in, carrier out, ring grounded.

    References
    ----------
    Equation (A1) of :doc:`/equations`.
    """
    sizes = {name: getattr(geometry, name) for name in _SIZES}
    return WEDGE.drive(sizes | {"planets": planet_count}, closure=closure)
