"""A joint file solved, and its document."""

from __future__ import annotations

import functools
from typing import NamedTuple

from asperity.joint.pin_interval import clearance_interval
from asperity.joint.solve import solve_joint
from asperity.joint_file.accuracy import accuracy_of_case
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.contact_laws import laws_of_file
from asperity.joint_file.drawn_surface import drawn_interval
from asperity.joint_file.own_branches import branches_of
from asperity.joint_file.part_names import body_key
from asperity.joint_file.si_tables import AnyCase, si_values, without_measurement
from asperity.results.document import joint_document
from asperity.results.solved import SolvedJoint, solved_with_capacities
from asperity.types import Document


class SolvedCase(NamedTuple):
    """A joint file, solved by :func:`solved_case`, and all of it as plain data in SI units."""

    solved: SolvedJoint
    document: Document


def solve_case(case: AnyCase) -> SolvedCase:
    """A joint file solved, and its document; raises as :func:`solved_case`."""
    solved = solved_case(case)
    return SolvedCase(solved, document_of(case, solved))


def document_of(case: AnyCase, solved: SolvedJoint) -> Document:
    """The document of a joint file that is solved already."""
    joint = solved.joint if solved.branches is None else solved.branches.equal
    return joint_document(
        solved, inputs=without_measurement(si_values(case)), assumptions=assumptions(case, joint)
    )


def solved_case(case: AnyCase) -> SolvedJoint:
    """A joint file solved; with sections ``[[branch]]`` the joint and its results have every branch by itself.

    Raised are an ``InputError`` if the bodies do not fit or the output torque exceeds the capacity, and a
    ``NoSolutionError`` if no balance was found.
    """
    branches = branches_of(case)
    joint = joint_from_case(case) if branches is None else branches.joint
    solved = solved_with_capacities(joint, solve_joint(joint), branches)
    solved.material_names = {
        body.name: case.bodies[body_key(joint.type, body.name, case.bodies)] for body in joint.drive.bodies
    }
    if case.rolling is not None and case.rolling.required_life is not None:
        solved.required_life = case.rolling.required_life.value
    if case.rolling is not None and case.rolling.allowed_transmission_error is not None:
        solved.allowed_transmission_error = case.rolling.allowed_transmission_error.value
    if case.form is not None:
        solved.over_turn = functools.partial(accuracy_of_case, case)
    return solved


def solve_with_surface(case: AnyCase) -> SolvedCase:
    """A joint file solved, with the document that ``asperity joint --json`` prints; raises as :func:`solved_case`."""
    solved = solved_case(case)
    return SolvedCase(solved, full_document(case, solved))


def full_document(case: AnyCase, solved: SolvedJoint) -> Document:
    """The document of a joint file that is solved already, with what is open of its surfaces and pins.

    Beside :func:`document_of` the ``measured_surface``, if there is one, the ``stiffness_interval`` over what is open,
    the ``contact_laws`` side by side, and the ``pin_clearance_interval`` where a pin presses in a bore without a stated
    clearance.
    """
    document = document_of(case, solved)
    over_clearance = clearance_interval(solved.joint, solved.result)
    document |= {} if over_clearance is None else {"pin_clearance_interval": over_clearance}
    if case.measured is not None:
        document |= case.measured.document(case, solved.joint)
        laws = case.measured.laws(case, solved.joint, solved.result)
    else:
        interval = drawn_interval(case)
        document |= {} if interval is None else {"stiffness_interval": interval}
        laws = laws_of_file(case, solved.joint, solved.result)
    return document | ({"contact_laws": laws} if laws else {})
