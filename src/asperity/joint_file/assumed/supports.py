"""What is taken of what holds the rollers: bearings, pins, play and the springs of the structure."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint.bores import pins_bend
from asperity.joint.description import Joint
from asperity.joint.pin_bound import pins_rigid
from asperity.joint.pin_interval import presses_in_bores
from asperity.joint_file.assumed.described import Described


def friction(file: Described) -> Iterator[str]:
    """The friction of the bearings."""
    if file.case.bearings is None:
        yield "no section [bearings]: the bearings have no friction"
    else:
        yield (
            "[bearings]: their friction opposes the rotation, in the drive that stands too; where the input has no "
            "speed it opposes the sense of the torque"
        )


def pins(file: Described) -> Iterator[str]:
    """How pins load their rollers, and what they give way."""
    joint = file.joint
    if not joint.drive.pinned:
        return
    yield _pressed(joint)
    if pins_bend(joint):
        yield (
            "bearings.pin_length without compliance.pin_stiffness: pins bend and shear as beams of their rollers' "
            "material between rigid supports"
        )
    elif pins_rigid(joint):
        yield (
            "no compliance.pin_stiffness: pins are rigid, and stiffness, natural frequencies and K1 to K3 are upper "
            "bounds; state it, or both pin_diameter and pin_length of [bearings], of which the bending of the pins is "
            "computed"
        )


def _pressed(joint: Joint) -> str:
    """Where the force of a pin acts on its roller."""
    if not presses_in_bores(joint):
        return (
            "no bearings.pin_diameter: the force of a pin is spread over the rim of its roller; a pin that presses in "
            "a bore makes the joint softer and stresses the bore"
        )
    clearance = (
        "all round in the assembled drive, and the way of a pin across it is play, which [play] states"
        if joint.pin_clearance_stated
        else "none, since the file states no bearings.pin_radial_clearance"
    )
    return (
        "bearings.pin_diameter: a pin of its roller's material presses over an arc of the bore, as an elastic "
        f"cylinder that fills it but for its clearance: {clearance}; a rolling bearing between them counts as part "
        "of the pin. Away from the arc the bore is free. The bore of a roller without a bore diameter is as wide "
        "as the pin; of a stepped roller each track has its bore to itself, and its contacts give way as those on "
        "an empty bore. For solid rollers with journals state bearings.pin_friction_diameter in its place"
    )


def play(file: Described) -> Iterator[str]:
    """The play at the output."""
    if file.case.play is None:
        yield "no section [play]: the output has no play"


def springs(file: Described) -> Iterator[str]:
    """The springs of the structure around the rollers."""
    compliance = file.case.compliance
    if compliance is None:
        yield "no section [compliance]: shafts are rigid" + (
            "" if file.case.in_frame() else ", rollers without a pin float"
        )
        return
    useless = file.case.keys_without_effect()
    absent = [name for name, value in compliance if value is None and f"compliance.{name}" not in useless]
    if absent:
        yield f"[compliance] without {', '.join(absent)}: ideal, as their descriptions say"
