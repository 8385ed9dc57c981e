"""Notes on a solved joint that can exist, but whose numbers lie outside what the model or the practice knows."""

from __future__ import annotations

import dataclasses
import math
from dataclasses import dataclass

import jax
import numpy as np

from asperity.compilation import compile_fast
from asperity.drive.geometry import CONTACT_NAMES, triangle
from asperity.drive.ring_bending import thin_ring_compliance
from asperity.joint.contacts import joint_contacts
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult, evaluate
from asperity.joint.results import Severity
from asperity.units import format_quantity

#: Loss of assembled stiffness from which the bending of a ring is worth a warning [-].
RING_BENDING_LIMIT = 0.05
#: Friction coefficients above are those of dry or tacky surfaces; traction fluids end near 0.12 [-].
FRICTION_LIMIT = 0.3
#: Contact length over the smaller roller's diameter above which a roller skews rather than bears evenly [-].
SLENDERNESS_LIMIT = 3.0
#: The paper's pairs of rollers, Tables 1 and 2: effective radius and contact length [m].
PAPER_EFFECTIVE_RADII = (3.0e-3, 8.4e-3)
PAPER_CONTACT_LENGTHS = (5e-3, 30e-3)


@dataclass(frozen=True, slots=True)
class Note:
    """One comparison with what is usual, for a contact or for the whole drive.

    Parameters
    ----------
    name, label : str
        What is compared, for machines and for people.
    contact : str or None
        Which contact; None for the whole drive.
    value, limit : float
        The value and the limit it is compared with [SI].
    ok : bool
        Whether the value is on the good side of its limit.
    severity : {"function", "damage", "accuracy", "model"}
        How serious it is if it is not.
    meaning : str
        What that means.
    remedy : str or None
        What to do if it is not.
    """

    name: str
    label: str
    contact: str | None
    value: float
    limit: float
    ok: bool
    severity: Severity
    meaning: str
    remedy: str | None


def plausibility(joint: Joint, result: JointResult) -> tuple[Note, ...]:
    """Notes on the ring's wall, the friction, the lengths, and the sizes for which lambda was made.

    Parameters
    ----------
    joint : Joint
        One joint.
    result : JointResult
        Its result.

    Returns
    -------
    tuple of Note
        One for the drive or for each contact; those that are not ok are warnings.
    """
    contacts = joint_contacts(joint)
    pairs = contacts.pairs
    lengths, friction, radius_1, radius_2, effective = (
        np.broadcast_to(np.asarray(values, dtype=float), (len(CONTACT_NAMES),))
        for values in (
            pairs.contact_length,
            pairs.friction_coefficient,
            pairs.radius_1,
            pairs.radius_2,
            pairs.effective_radius,
        )
    )
    notes = list(_ring_bending(joint, result, float(max(lengths[3:]))))
    for index, name in enumerate(CONTACT_NAMES):
        mu = float(friction[index])
        notes.append(
            _note(
                "friction_coefficient",
                "friction coefficient",
                name,
                mu,
                FRICTION_LIMIT,
                ("a usual friction coefficient", "traction fluids reach 0.12, clean dry steel 0.3"),
                "measure a coefficient this high before relying on it",
            )
        )
        notes.append(
            _note(
                "contact_length_over_diameter",
                "contact length over diameter",
                name,
                float(lengths[index] / (2.0 * min(radius_1[index], radius_2[index]))),
                SLENDERNESS_LIMIT,
                (
                    "a usual length of a contact line",
                    "the contact line is long for its roller: a slight skew or bending loads one end, and the even "
                    "line load of the model is lost",
                ),
                "shorten it, or crown the rollers",
            )
        )
        if joint.contact_factor_model != "unity":
            notes.append(
                _size(joint.contact_factor_model, name, float(effective[index]), float(lengths[index]))
            )
    return tuple(notes)


def _note(
    name: str, label: str, contact: str, value: float, limit: float, words: tuple[str, str], remedy: str
) -> Note:
    ok = value <= limit
    meaning = words[0] if ok else words[1]
    return Note(name, label, contact, value, limit, ok, "accuracy", meaning, None if ok else remedy)


def _size(model: str, contact: str, radius: float, length: float) -> Note:
    """Whether a pair of rollers is of the paper's sizes; told by whichever of radius and length is farther outside."""
    ranges = ((radius, PAPER_EFFECTIVE_RADII), (length, PAPER_CONTACT_LENGTHS))
    value, (low, high) = max(ranges, key=lambda entry: max(entry[1][0] / entry[0], entry[0] / entry[1][1]))
    ok = low <= value <= high
    inside = "the sizes are those for which the paper uses lambda"
    mm = [format_quantity(bound, "mm", 2) for bound in (*PAPER_EFFECTIVE_RADII, *PAPER_CONTACT_LENGTHS)]
    outside = (
        f'contact_factor = "{model}" contains a length in mm, so that it depends on the size of the drive: the paper '
        f"uses it for effective radii of {mm[0]} to {mm[1]} and contact lengths of {mm[2]} to {mm[3]}. By this alone "
        'the published stiffness of the paper\'s joint would gain 28 % at ten times its size ("printed"), and lose '
        "93 % at a tenth"
    )
    return Note(
        "contact_factor_size",
        "size of the contact",
        contact,
        value,
        low if value < low else high,
        ok,
        "model",
        inside if ok else outside,
        None if ok else 'use contact_factor = "unity", which has no such scale',
    )


def _ring_bending(joint: Joint, result: JointResult, length: float) -> tuple[Note, ...]:
    """What a ring that carries itself would lose, where the joint does not say what holds it."""
    stated = joint.ring_support is not None or not math.isinf(float(joint.structure.ring_bending_stiffness))
    held = float(result.assembly.stiffness.output)
    if stated or float(joint.geometry.planet_count) < 2.0 or not held > 0.0:
        return ()
    if joint.body_model == "exact":
        bent_joint = dataclasses.replace(joint, ring_support="free")
        means = "drive.ring_support is not stated, and a rigid housing is assumed to hold the ring. In a ring that"
        remedy = "state drive.ring_support, or hold the ring in a rigid housing"
    else:
        compliance = thin_ring_compliance(
            geometry=joint.geometry,
            sides=triangle(joint.geometry),
            wall_thickness=joint.ring_wall_thickness,
            length=length,
            youngs_modulus=joint.bodies.ring.youngs_modulus,
        )
        spring = 1.0 / compliance.opposed
        bent_joint = dataclasses.replace(
            joint, structure=dataclasses.replace(joint.structure, ring_bending_stiffness=spring)
        )
        means = (
            "the springs are those of a ring in a rigid housing. By thin-ring theory, with a ring_bending_stiffness of "
            f"about {format_quantity(float(spring), 'N/um', 3)} under each loading roller, in a ring that"
        )
        remedy = 'choose bodies = "exact", give ring_bending_stiffness, or hold the ring in a rigid housing'
    bent = float(_output(bent_joint))
    loss = 1.0 - bent / held
    bent_to, held_at = (format_quantity(value, "N*m/rad", 3) for value in (bent, held))
    ok = loss <= RING_BENDING_LIMIT
    return (
        Note(
            "ring_bending_loss",
            "stiffness lost by bending of the ring",
            None,
            loss,
            RING_BENDING_LIMIT,
            ok,
            "accuracy",
            f"{means} carries itself the assembled stiffness would be {bent_to} instead of {held_at}",
            None if ok else remedy,
        ),
    )


def _output(joint: Joint) -> np.ndarray:
    numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    found: np.ndarray = np.asarray(compile_fast(_assembled, numbers)(numbers))
    return found


def _assembled(joint: Joint) -> object:
    return evaluate(joint).assembly.stiffness.output
