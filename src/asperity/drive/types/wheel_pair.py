"""The pair of wheels: the simplest traction drive, and the twin-disc rig on which friction is measured."""

from __future__ import annotations

from collections.abc import Mapping

from asperity.drive.layout.drive import CARRIER
from asperity.drive.layout.drive_type import Assumed, DriveType, Pairing, Part, Places, Tables
from asperity.drive.layout.sizes import SPRING, Choice, ContactLength, Size, body_length, bore, crown, radius
from asperity.engine.arrays import xp
from asperity.errors import InputError
from asperity.types import Real


def _layout(sizes: Tables) -> Places:
    driver, driven = (xp.asarray(sizes[f"{name}_radius"], dtype=float) for name in ("driver", "driven"))
    return Places(centres={"driven": xp.stack([0.0 * driver, driver + driven])})


def _refuse(stated: Mapping[str, Mapping[str, str]]) -> None:
    """Raise if what presses the wheels is not described, or described twice."""
    drive, load = stated["drive"], stated["load"]
    by = f'drive.pressed_by = "{drive["pressed_by"]}"'
    if drive["pressed_by"] == "spring" and "spring_stiffness" not in drive:
        raise InputError(
            f'{by}: the stiffness of the spring is missing; give drive.spring_stiffness, e.g. "20 N/mm", or '
            'pressed_by = "force" for a force that no size changes'
        )
    if drive["pressed_by"] != "spring" and "spring_stiffness" in drive:
        raise InputError(
            f"drive.spring_stiffness = '{drive['spring_stiffness']}': with {by} no spring presses the wheels; leave it "
            'out, or write pressed_by = "spring"'
        )
    if drive["pressed_by"] == "fixed_centres" and "cam_force_per_torque" in load:
        raise InputError(
            f"load.cam_force_per_torque = '{load['cam_force_per_torque']}': with {by} a cam cannot move the wheels "
            'together; leave it out, or write pressed_by = "force"'
        )
    if drive["pressed_by"] == "spring" and "cam_force_per_torque" in load:
        raise InputError(
            f"load.cam_force_per_torque = '{load['cam_force_per_torque']}': with {by} it is not known whether the cam "
            'compresses the spring or presses beside it; write pressed_by = "force", with the force of the spring as '
            "load.preload, for a cam beside a soft spring"
        )
    if drive["pressed_by"] == "force" and "interference" in load:
        raise InputError(
            f"load.interference = '{load['interference']}': with {by} no size makes the force of the contact; give it "
            'as load.preload, e.g. "200 N", or write pressed_by = "fixed_centres" or "spring"'
        )


def _approach(sizes: Tables) -> str:
    """What makes the preload: travel of the spring, with the approach of the contact, interference, or no length."""
    return {"spring": "spring travel", "fixed_centres": "interference"}.get(str(sizes["pressed_by"]), "")


def _spring(sizes: Tables) -> Real | None:
    """Stiffness of the spring that presses the wheels [N/m]; None for fixed centres and for a force."""
    return sizes.get("spring_stiffness")


WHEEL_PAIR = DriveType(
    name="wheel_pair",
    words="wheel pair",
    summary="Pair of wheels: two wheels with parallel axes, pressed together from outside; a twin-disc rig too.",
    file_summary="A joint file with a pair of wheels.",
    rank=5,
    sectors=None,
    parts=(Part("driver", "held"), Part("driven", "held")),
    contacts=(Pairing("dd", "driver", "driven", pressed=True),),
    sizes=(
        radius("driver", "Radius R_1 of the driving wheel, the input.", start="20 mm"),
        radius("driven", "Radius R_2 of the driven wheel, the output.", start="40 mm"),
        ContactLength(),
        Choice(
            "pressed_by",
            "What presses the wheels together: a force, load.preload, that no size and no temperature changes; a "
            "spring on the bearing of one of them, whose other end load.preload or load.interference has moved from "
            "first touch on; or fixed centres, whose distance is shorter than the sum of both radii by "
            "load.interference, or by as much as makes load.preload.",
            ("force", "spring", "fixed_centres"),
            required=True,
        ),
        Size(
            "spring_stiffness",
            'Stiffness of the spring along the line of centres; needed for, and only for, pressed_by = "spring".',
            SPRING,
            required=False,
        ),
        bore("driver", "Diameter of the bore of a hollow driving wheel; solid if absent."),
        bore("driven", "Diameter of the bore of a hollow driven wheel; solid if absent."),
        body_length(
            "driver", "Length of the driving wheel, for its mass; if absent, that of the contact line."
        ),
        body_length(
            "driven", "Length of the driven wheel, for its mass; if absent, that of the contact line."
        ),
        crown(
            "driver",
            "Radius of the driving wheel's crown along its axis, highest in the middle of the contact line; a cylinder "
            "if absent.",
        ),
        crown("driven", "Radius of the driven wheel's crown along its axis; a cylinder if absent."),
    ),
    input="driver",
    output="driven",
    grounded=CARRIER,
    layout=_layout,
    refuse=_refuse,
    pressing_stiffness=_spring,
    approach=_approach,
    assumed=(
        Assumed(
            "both wheels turn in bearings that do not give way across the line of centres; the force of a wheel is "
            "taken as that of one bearing"
        ),
        Assumed("the track of the driving wheel is as long as its contact line", unless="driver_length"),
        Assumed("the track of the driven wheel is as long as its contact line", unless="driven_length"),
        Assumed(
            "the bores of hollow wheels are free: a shaft in one makes the joint stiffer than computed, and the "
            "interference of the same preload smaller"
        ),
    ),
)
