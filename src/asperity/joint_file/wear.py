"""Wear of the joint of a file: what is worn, under which loads, over which life, and what is refused."""

from __future__ import annotations

import dataclasses

import numpy as np

from asperity.engine.control import at_once
from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.solve import (
    joint_state,
    refuse_impossible_joint,
    refuse_not_pressed,
    refuse_short_contacts,
)
from asperity.joint_file.own_branches import joint_with_branches
from asperity.joint_file.part_names import drive_type_of
from asperity.joint_file.si_tables import AnyCase, key_at, si_values
from asperity.results.wear_document import WearOverLife
from asperity.rolling.wear import joint_wear

_LIFE = "rolling.required_life"


def wear_of_case(case: AnyCase, *, life: float | None = None) -> WearOverLife:
    """Wear of the joint of a file, over a life [s], None for ``rolling.required_life``.

    An ``InputError`` if the preload is a force of which wear takes an unknown part, the joint does not slip in its
    contacts, or slips as a whole at the start, or the bodies do not fit; a ``NoSolutionError`` if no balance was found.
    """
    if life is not None:
        try:
            key_at(_LIFE).check(life)
        except InputError as error:
            raise InputError(f"{_LIFE}: {error}", options=["life"]) from None
    elif case.rolling is not None and case.rolling.required_life is not None:
        life = case.rolling.required_life.value
    values = si_values(case)
    joint = refuse_impossible_joint(at_once(lambda: joint_with_branches(values)))
    result = joint_state(joint)
    refuse_not_pressed(joint, result.rest, result.pressed)
    refuse_short_contacts(result)
    kind = drive_type_of(values)
    pressed_from_outside = any(contact.pressed for contact in kind.contacts)
    made_by = kind.approach(values["drive"]) if pressed_from_outside else None
    joint, keeps_force = _worn_joint(joint, made_by, float(result.interference))
    stated = joint.wear_coefficients
    coefficients = None if stated is None else np.array([float(each) for each in stated])
    largest = None if coefficients is None else float(coefficients.max())
    relative = np.ones(len(joint.drive.bodies)) if coefficients is None else coefficients / largest
    return WearOverLife(
        wear=joint_wear(
            joint,
            relative,
            keeps_force=keeps_force,
            also=None if life is None or largest is None else largest * life,
        ),
        coefficient=largest,
        life=life,
        follows=made_by == "" or joint.cam is not None,
    )


def _worn_joint(joint: Joint, made_by: str | None, interference: float) -> tuple[Joint, bool]:
    """The joint as wear loosens it, and whether its force stays.

    ``made_by``: what makes a preload of the drive, as its type says, no length where a force does, None where it does
    not say; ``interference`` that makes it [m].
    """
    if joint.interference is not None:
        return joint, False
    if joint.cam is not None or made_by == "":
        return joint, True
    if made_by is None:
        raise InputError(
            "load.preload: a force does not say what wear takes from it; state load.interference, which wear takes off "
            "length by length, or a cam (load.cam_force_per_torque), which follows"
        )
    return dataclasses.replace(joint, preload=None, interference=interference), False
