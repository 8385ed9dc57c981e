"""What tilted axes do to the contacts of a joint, as an entry of the document of its loads."""

from __future__ import annotations

import math

import numpy as np

from asperity.joint.tilt import TiltedLines, tilted_contacts
from asperity.results.solved import SolvedJoint
from asperity.types import Document

_NOTES = (
    "Each contact resists a tilt as cylinders pressed over their whole length, or as its crowns, at small slopes; "
    "floating rollers lie where these springs put them, those on pins as their pins. Asperities, bending of pins, "
    "shafts and rollers, and play of bearings are left out.",
    "Edge: an end of the line carries load; the pressure of its sharp edge has no bound in theory. Profiles or crowns "
    "free the ends: asperity crown says which.",
    "Sideways: axial force over friction, of this skew alone, in the joint that turns. Forces, creep and life are "
    "those of parallel axes: state the skew as rolling.skew for them.",
)
_UNKNOWN = (
    "not known: a contact carries no load, or the joint slips or does not roll under the torque; lower the torque, or "
    "raise the preload"
)


def tilt_document(solved: SolvedJoint) -> Document | None:
    """Contacts between tilted axes under the working torque, ready for :func:`json.dumps`; None without tilts.

    Angles without sign, numbers that are not known None. ``in_any_direction`` has the largest of each, of the same
    tilts in the direction that is worst for it.
    """
    joint = solved.joint
    if joint.tilts is None:
        return None
    tilts = {
        f"{name}_axis": {"out_rad": float(out), "across_rad": float(across)}
        for name, out, across in zip(joint.tilts.bodies, joint.tilts.out, joint.tilts.across, strict=True)
    }
    found = tilted_contacts(joint, solved.result)
    if found is None:
        return {"axes": tilts, "contacts": {}, "unknown_because": _UNKNOWN, "notes": []}
    notes = list(_NOTES)
    names = joint.contact_names
    freed = [
        name
        for name, slope, limit in zip(names, found.in_any_direction.slope, found.freeing_slope, strict=True)
        if slope > limit
    ]
    if freed:
        notes.append(
            f"{', '.join(freed)}: one end comes free: the contact then yields more to a tilt than is taken here, and "
            "slopes of floating rollers are estimates."
        )
    if np.any(np.isnan(found.as_stated.skew)):
        notes.append(
            "Skew not known: all contacts of a floating roller lie on one line, and nothing but friction holds it "
            "across; hold it by a pin or a cage."
        )
    contacts = {
        name: {
            "normal_force_N": float(found.normal_force[k]),
            "tilt_stiffness_Nm_per_rad": float(found.tilt_stiffness[k]),
            "freeing_slope_rad": _plain(found.freeing_slope[k]),
            "as_stated": _line(found.as_stated, k),
            "in_any_direction": _line(found.in_any_direction, k),
        }
        for k, name in enumerate(names)
    }
    return {"axes": tilts, "contacts": contacts, "unknown_because": None, "notes": notes}


def _line(lines: TiltedLines, k: int) -> Document:
    """One contact."""
    return {
        "slope_rad": float(lines.slope[k]),
        "skew_rad": _plain(lines.skew[k]),
        "peak_over_mean": float(lines.peak_over_mean[k]),
        "end_over_mean": float(lines.end_over_mean[k]),
        "edge": bool(lines.edge[k]),
        "peak_pressure_Pa": _plain(lines.peak_pressure[k]),
        "sideways_over_friction": _plain(lines.sideways[k]),
    }


def _plain(value: float) -> float | None:
    return float(value) if math.isfinite(value) else None
