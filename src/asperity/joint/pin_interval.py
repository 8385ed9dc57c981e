"""How far the stiffness of a joint reaches over the clearance of its pins, where nobody states one."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from asperity.joint.description import Joint, without_duty
from asperity.joint.evaluation import JointResult
from asperity.joint.solve import joint_state
from asperity.library.tolerance_grades import LARGEST_SIZE, standard_tolerances
from asperity.types import Document
from asperity.units import format_quantity

#: The closest fit of ISO 286 in which a pin may turn, and the grades of its bore and pin.
FIT, _GRADES = "H7/h6", ("IT7", "IT6")
#: Clearances at which the stiffness is computed, over the largest: it need not fall all the way.
_SHARES = (1.0 / 27.0, 1.0 / 9.0, 1.0 / 3.0, 1.0)


def presses_in_bores(joint: Joint) -> bool:
    """Whether pins of a known diameter press in the bores of their rollers."""
    diameters = [joint.shapes[body].pin_diameter for body in joint.drive.pinned]
    return any(diameter is not None and float(np.asarray(diameter)) > 0.0 for diameter in diameters)


def largest_clearance(diameter: float) -> float:
    """Largest radial clearance of the fit :data:`FIT` at a diameter up to 500 mm [m]."""
    widths = standard_tolerances(diameter)
    return 0.5 * sum(widths[grade] for grade in _GRADES)


def clearance_interval(joint: Joint, result: JointResult) -> Document | None:
    """Ends of the assembled stiffness of one joint between no clearance and the largest of a close fit.

    None where no pin presses in a bore, its clearance is stated, or no fit is known for its size; both ends are None
    where the joint has no state or no stiffness at one of the clearances. With ``words``.
    """
    if joint.pin_clearance_stated or not presses_in_bores(joint):
        return None
    diameter = max(float(np.asarray(joint.shapes[body].pin_diameter)) for body in joint.drive.pinned)
    if diameter > LARGEST_SIZE:
        return None
    most = largest_clearance(diameter)
    clearances: list[Document] = [{"pin_clearance": np.asarray(share * most)} for share in _SHARES]
    results = [
        result,
        *(joint_state(dataclasses.replace(without_duty(joint), **change)) for change in clearances),
    ]
    values = [float(each.assembly.stiffness.output) for each in results if bool(each.solved)]
    known = len(values) == len(results) and all(math.isfinite(value) for value in values)
    low, high = (min(values), max(values)) if known else (None, None)
    told = "is not known over it"
    if low is not None and high is not None:
        ends = [format_quantity(end, "N*m/arcmin", 3) for end in (low, high)]
        told = f"is {ends[0].split(' ')[0]} to {ends[1]}"
    return {
        "fit": FIT,
        "largest_clearance_m": most,
        "low_Nm_per_rad": low,
        "high_Nm_per_rad": high,
        "words": f"bearings.pin_radial_clearance is not stated, and the numbers are those of pins without clearance; "
        f"between none and {format_quantity(most, 'um', 3)}, the most of a fit {FIT}, the assembled stiffness {told}",
    }
