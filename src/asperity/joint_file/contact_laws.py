"""Stiffness and drift of a joint by every contact law that its surfaces allow, side by side."""

from __future__ import annotations

import dataclasses
import math

from asperity.contact.laws.law import ContactLaw
from asperity.contact.laws.registry import LAWS
from asperity.errors import AsperityError
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult
from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.drawn_surface import surface_entries
from asperity.joint_file.material_entries import ContactLawName, served_laws
from asperity.joint_file.model import Case
from asperity.types import Document


def with_law(case: Case, law: ContactLawName) -> Case:
    """The joint file with a contact law."""
    return case.model_copy(update={"model": case.model.model_copy(update={"contact_law": law})})


def laws_of_file(case: Case, joint: Joint, result: JointResult) -> list[Document]:
    """The joint of a file by every law that its surfaces allow, as :func:`laws_side_by_side`.

    Those of a decay length differ in where it is from, not in what they make of the one that a file states.
    """
    used = case.contact_law()
    laws = [
        law.name
        for law in served_laws(entry.stated_keys() for _, entry in surface_entries(case))
        if law.name == used or law.from_measurement != "decay_length"
    ]
    surfaces = {law: joint_from_case(with_law(case, law)).surfaces for law in laws if len(laws) > 1}
    return laws_side_by_side(joint, result, used=used, surfaces=surfaces)


def laws_side_by_side(
    joint: Joint,
    result: JointResult,
    *,
    used: ContactLawName,
    surfaces: dict[ContactLawName, tuple[ContactLaw, ...]],
) -> list[Document]:
    """Assembled stiffness at the output and drift of a solved joint by several laws.

    ``used`` is the law of the joint, ``surfaces``: law → those of all contacts or of each. One entry a law; its numbers
    are None where the joint has no solution or no stiffness; an empty list for one law only.
    """
    entries = []
    for law in (law for law in LAWS if law in surfaces and len(surfaces) > 1):
        one: JointResult | None = result
        if law != used:
            own = surfaces[law]
            if len(own) > 1:  # with sections [[branch]] those of every branch
                own *= len(joint.drive.contacts) // len(own)
            try:
                one = solve_joint(dataclasses.replace(joint, surfaces=own)).result
            except AsperityError:  # by this law it does not carry the torque
                one = None
        numbers = [math.nan, math.nan]
        if one is not None and bool(one.contact_law_holds):
            numbers = [float(one.assembly.stiffness.output), float(one.rolling.drift_per_output_turn)]
        stiffness, drift = (number if math.isfinite(number) else None for number in numbers)
        entries.append(
            {
                "law": law,
                "used": law == used,
                "assembly_Nm_per_rad": stiffness,
                "drift_rad_per_output_turn": drift,
                "over_boundary_elements": list(LAWS[law].over_boundary_elements),
            }
        )
    return entries
