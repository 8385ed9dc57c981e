"""Notes on the sizes of a joint with a planar drive, as those on the paper's drive."""

from __future__ import annotations

import numpy as np

from asperity.compilation import call_compiled
from asperity.joint.planar.description import PlanarJoint, planar_contacts
from asperity.joint.planar.evaluation import PlanarResult
from asperity.joint.plausibility import Note, contact_notes


def planar_plausibility(joint: PlanarJoint, result: PlanarResult) -> tuple[Note, ...]:
    """Notes on friction, lengths, oil film, and the sizes for which the contact factor was made.

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
    pairs = call_compiled(planar_contacts, joint).pairs
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
    return tuple(notes)
