"""Notes on the sizes of a joint with a planar drive, as those on the paper's drive."""

from __future__ import annotations

import numpy as np

from asperity.compilation import call_compiled
from asperity.joint.contact_notes import Note, contact_notes, crown_notes
from asperity.joint.planar.description import PlanarJoint, planar_contacts
from asperity.joint.planar.evaluation import PlanarResult


def planar_plausibility(joint: PlanarJoint, result: PlanarResult) -> tuple[Note, ...]:
    """Notes on friction, lengths, oil film, crowns, and the sizes for which the contact factor was made.

    Parameters
    ----------
    joint : PlanarJoint
        One joint.
    result : PlanarResult
        Its result.

    Returns
    -------
    tuple of Note
        One or more for each contact; those that are not ok are warnings.
    """
    contacts = call_compiled(planar_contacts, joint)
    pairs, crowns = contacts.pairs, contacts.crown_curvature
    smaller = np.minimum(np.asarray(joint.drive.first_radius), np.asarray(joint.drive.second_radius))
    films = np.asarray(result.rolling.film_ratio)
    notes: list[Note] = []
    for index, name in enumerate(result.contact_names):
        notes += contact_notes(
            name,
            friction_coefficient=float(np.asarray(pairs.friction_coefficient)[index]),
            contact_length=float(np.asarray(pairs.contact_length)[index]),
            smaller_radius=float(smaller[index]),
            effective_radius=float(np.asarray(pairs.effective_radius)[index]),
            film_ratio=float(films[index]),
            contact_factor_model=joint.contact_factor_model,
        )
        if crowns is not None and float(crowns[index]) > 0.0:
            notes += crown_notes(name, result.diagnostics, index)
    return tuple(notes)
