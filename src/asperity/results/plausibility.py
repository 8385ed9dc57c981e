"""Notes on the sizes of a joint, as those on the paper's drive."""

from __future__ import annotations

import numpy as np

from asperity.contact.hertz_line import effective_radius
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.results.contact_notes import Note, contact_notes, crown_notes


def plausibility(joint: Joint, result: JointResult) -> tuple[Note, ...]:
    """Notes on friction, lengths, oil film, crowns, and the sizes for which the contact factor was made."""
    drive, crowns = joint.drive, joint.crown_curvatures
    first, second = (np.asarray(radii, dtype=float) for radii in (drive.first_radius, drive.second_radius))
    frictions, lengths = (
        np.broadcast_to(np.asarray(values, dtype=float), first.shape)
        for values in (joint.friction_coefficients, joint.contact_lengths)
    )
    films = np.asarray(result.rolling.film_ratio)
    notes: list[Note] = []
    for index, name in enumerate(result.contact_names):
        notes += contact_notes(
            name,
            friction_coefficient=float(frictions[index]),
            contact_length=float(lengths[index]),
            smaller_radius=min(float(first[index]), float(second[index])),
            effective_radius=float(
                effective_radius(
                    radius_1=float(first[index]),
                    radius_2=float(second[index]),
                    sign=-1.0 if drive.contacts[index].internal else 1.0,
                )
            ),
            film_ratio=float(films[index]),
            contact_factor_model=joint.contact_factor_model,
        )
        if crowns is not None and float(crowns[index]) > 0.0:
            notes += crown_notes(name, result.diagnostics, index)
    return tuple(notes)
