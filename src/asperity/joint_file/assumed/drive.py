"""What is taken of the drive: its sizes, where its rollers are, and how its forces close."""

from __future__ import annotations

from collections.abc import Iterator

from asperity.joint_file.assumed.described import Described
from asperity.joint_file.general_model import GeneralCase
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import leaves
from asperity.units import format_quantity

_EQUAL_COEFFICIENTS = (
    "at standstill; the first contact that slips is the limit. With springs the forces follow from the slip of the "
    "contacts, and one of them may slip earlier, as the wind-up shows"
)


def open_sizes(file: Described) -> Iterator[str]:
    """The radius and the speed that follow from a ratio."""
    case, joint = file
    if case.open_radius is not None:
        yield f"{case.open_radius.words}, the radius that the file leaves open"
    if case.load.output_speed is not None:
        yield (
            f"load.output_speed: the input turns at {format_quantity(float(joint.input_speed), 'rpm')}, by the ratio "
            "without slip"
        )


def placement(file: Described) -> Iterator[str]:
    """Where the rollers of a listed drive are, and what holds the ring of another."""
    case, _ = file
    if not isinstance(case, GeneralCase):
        if None in case.ring_supports():
            yield "no drive.ring_support: a rigid housing holds the outer rim of the ring"
        return
    yield "the rollers are placed where all contacts just touch, as near as possible to the positions in the file"
    yield "the tracks of a stepped roller lie in one plane; each contact is one spring"
    for contact in case.contact:
        if contact.same_coefficient_as is not None:
            yield (
                f"contact {contact.name}: same_coefficient_as = '{contact.same_coefficient_as}': equal traction "
                f"coefficients in place of the slip of springs, {_EQUAL_COEFFICIENTS}"
            )
    for roller in case.roller:
        if roller.pin_force is not None:
            yield f"roller {roller.name}: pin_force = 'constant': a soft spring moves the pin and keeps its force"


def closures(file: Described) -> Iterator[str]:
    """What closes the balance of forces in place of the springs of the assembly."""
    joint = file.joint
    if not file.case.drive_type.is_listed and joint.drive.closure.equal_coefficients:
        yield (
            "model.traction_split: equal traction coefficients at both loading rollers of a planet, as the paper's "
            f"closure has it, {_EQUAL_COEFFICIENTS}"
        )
    if joint.closure_springs is not None:
        yield (
            f"model.closure_springs = '{joint.closure_springs}': the forces under load are those of one spring for "
            "each contact between rigid pins, as in the paper's closure; bending rings and compliant pins change "
            "them only without this key"
        )


def of_type(file: Described) -> Iterator[str]:
    """What its type says of a drive: how its tracks lie, and how long they are."""
    for sentence, unless in file.case.drive_type.assumed:
        if not unless or getattr(file.case.drive, unless, None) is None:
            yield sentence


def balance(_: Described) -> Iterator[str]:
    """How the drive is loaded, and what its capacity is."""
    yield "standing: forces from the slip of the contacts, loaded once from rest"
    yield (
        "torque capacity, standing: a contact that slips keeps the force of its friction while others carry the rest; "
        "it is the torque beyond which they cannot, or at which a contact lifts off. In rolling: the first gross slip"
    )


def tolerances(file: Described) -> Iterator[str]:
    """Tolerances of radii that do not move a preload stated as a force."""
    case, _ = file
    widths = {
        path: key.tolerance
        for path, key in leaves(case.drive, Quantity, "drive")
        if path.endswith("_radius") and key.tolerance
    }
    if case.load.preload is not None and widths:
        yield (
            f"load.preload is a force: the tolerance of {', '.join(widths)}, up to {1e6 * max(widths.values()):.3g} "
            "µm, does not move it; give load.interference if the sizes make the preload"
        )


def loading_cam(file: Described) -> Iterator[str]:
    """What a loading cam does."""
    if file.case.load.cam_force_per_torque is not None:
        yield (
            "loading cam: its ramps have no friction, so that it follows every change of the torque and turns as far "
            "as the work on the contacts demands; a cam that sticks is stiffer and adds hysteresis"
        )


def form_errors(file: Described) -> Iterator[str]:
    """What is taken of the form errors that a file states."""
    if file.case.form is None:
        return
    yield (
        "form errors: to first order; quasi-static, so that the shortest wave must come below a third of the first "
        "natural frequency (asperity dynamics); in the plane: no tilt and no axial runout; of the drive's own parts "
        "alone"
    )
    if any(entry.phase is None for entry in file.case.form):
        yield "no form.phase: the worst and the mean of all phases count"


def axis_tilts(file: Described) -> Iterator[str]:
    """Which results the tilts of a file reach."""
    if file.case.tilt is not None:
        yield (
            "[tilt] is used by `asperity loads` only: forces, stiffness, creep, wear and life are those of parallel "
            "axes; a skew that `asperity loads` finds counts in them as rolling.skew"
        )


def own_branches(file: Described) -> Iterator[str]:
    """How branches of their own sizes share the load."""
    case, _ = file
    if case.branch is None:
        return
    yield (
        "[[branch]]: every branch is solved by itself, together with the bodies on the axis; rings and carrier are "
        "centred, and what centres a ring that carries itself acts evenly all round; the standing drive is loaded "
        "from rest without torque"
    )
    if case.compliance is None or case.compliance.sun_support_stiffness is None:
        yield (
            "[[branch]] without compliance.sun_support_stiffness: the input is held rigidly on the axis; a sun "
            "that floats (0) shares the load among the branches"
        )
