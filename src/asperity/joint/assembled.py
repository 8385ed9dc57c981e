"""A joint as it is assembled, and the laws of its contacts around the forces that it has then."""

from __future__ import annotations

import functools
from typing import Any, NamedTuple

from asperity.drive.state.state import ContactLaws, DriveState
from asperity.drive.state.states import rest_forces, state_at_rest
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import scan
from asperity.joint.contacts import bulk_springs
from asperity.joint.laws import contact_laws, drive_load
from asperity.joint.machine import JointMachine
from asperity.types import Array

#: A force that is small for every wall: over Young's modulus times length times interference.
_SMALL_FORCE = 1e-5
#: Each leaves less than a thousandth of what its preload is away from that around which its laws are taken.
_ASSEMBLIES = 3


class Pressed(NamedTuple):
    """An assembled joint: laws of its contacts, and its state without the forces of a torque."""

    laws: ContactLaws
    rest: DriveState


def assembled(machine: JointMachine) -> Pressed:
    """A joint under its preload or interference alone, its laws around its forces; (A3), (E3) of :doc:`/equations`.

    Where the preload is an interference, the joint is assembled several times, each time with the laws around the force
    of the time before: the same force, stated as the preload, gives the same joint.
    """
    joint = machine.joint
    around = functools.partial(
        pressed_around,
        machine,
        pattern=joint.working_pattern,
        preload=joint.preload,
        interference=joint.interference,
    )
    if joint.unlike is not None:
        return around(joint.unlike.reference_force)
    forces = rest_forces(drive=joint.drive, pattern=xp.asarray(joint.pattern))
    if joint.preload is not None:
        return around(xp.asarray(joint.preload) * forces)

    def again(preload: Array, _: None) -> tuple[Array, Pressed]:
        pressed = around(preload * forces)
        return pressed.rest.normal[0], pressed

    _, passes = scan(again, _expected_preload(machine, forces), None, length=_ASSEMBLIES)
    return trees.map(lambda leaf: leaf[-1], passes)


def pressed_around(machine: JointMachine, reference_force: Array, **given: Any) -> Pressed:
    """State and laws of a joint without torque, laws taken around given forces, shape (contacts,) [N]; (A3), (M3).

    ``given`` is what presses it, as of :func:`asperity.drive.state.states.state_at_rest`.
    """
    laws, load = contact_laws(machine, reference_force), drive_load(machine.under(0.0))
    return Pressed(laws, state_at_rest(drive=machine.drive, laws=laws, load=load, **given))


def _expected_preload(machine: JointMachine, forces: Array) -> Array:
    """Preload by the work of the interference, the contacts as springs at a small force [N]; nan of a loose joint."""
    joint, contacts = machine.joint, machine.contacts
    young, length = joint.materials[0].youngs_modulus, xp.asarray(contacts.pairs.contact_length)[0]
    small = _SMALL_FORCE * young * length * xp.asarray(joint.interference)
    compliance = bulk_springs(
        contacts=contacts, half_width=xp.asarray(contacts.pairs.half_width(small * forces))
    ).secant_compliance
    rings = machine.ring_compliance
    compliance = compliance if rings is None else compliance + rings
    share = xp.sum(joint.working_pattern * forces) * xp.asarray(joint.interference)
    return xp.where(share > 0.0, share / xp.sum(compliance * forces**2), xp.nan)
