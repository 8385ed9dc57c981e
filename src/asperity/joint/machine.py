"""A joint as a machine: everything that its description alone determines, found once and handed on."""

from __future__ import annotations

import dataclasses

import numpy as np

from asperity.body.coupling import BodyInMachine
from asperity.body.rim_moments import RimKernel
from asperity.drive.layout.drive import Drive
from asperity.drive.state.bores import Bores
from asperity.drive.state.supports import Supports, carrier_supports
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.joint.bodies import SteppedInMachine, exact_bodies, rims_of, stepped_rollers
from asperity.joint.bores import pin_compliances, pins_in_bores
from asperity.joint.contacts import JointContacts
from asperity.joint.description import Joint, body_masses, in_motion, joint_contacts
from asperity.types import Array, Real


class JointMachine(Module):
    """A joint with what no torque, force or speed changes. SI units.

    Parameters
    ----------
    joint : Joint
        Its description, of arrays, whose drive knows its matrices, speeds and angles.
    contacts : JointContacts
        The contacts of one sector, with what its exact bodies do at every load.
    bodies : tuple of BodyInMachine
        The bodies by plane elasticity.
    stepped : tuple of SteppedInMachine
        The hollow rollers with two tracks.
    masses : tuple of Real
        Of one of each body [kg].
    pin_compliance : Array
        Of each pin along its push, without its contact in the bore, shape (pins,) [m/N].
    bores : Bores or None
        The pins in the bores of their rollers; None where none is known to press there.
    ring_compliance : Array or None
        Of the springs in series with the contacts of rings, shape (contacts,) [m/N]; None for none.
    supports : Supports or None
        Springs that hold rollers on the carrier besides their pins along the push; None for none.
    """

    joint: Joint
    contacts: JointContacts
    bodies: tuple[BodyInMachine, ...]
    stepped: tuple[SteppedInMachine, ...]
    masses: tuple[Real, ...]
    pin_compliance: Array
    bores: Bores | None
    ring_compliance: Array | None
    supports: Supports | None

    @property
    def drive(self) -> Drive:
        """Bodies, contacts and pins."""
        return self.joint.drive

    def under(self, output_torque: Real, input_speed: Real | None = None) -> JointMachine:
        """The same machine under another output torque [N·m], and at another speed of the input [rad/s]."""
        speed = self.joint.input_speed if input_speed is None else input_speed
        joint = dataclasses.replace(self.joint, output_torque=output_torque, input_speed=speed)
        return dataclasses.replace(self, joint=joint)


def joint_machine(joint: Joint, rims: RimKernel | None = None) -> JointMachine:
    """The machine that a joint is; pure.

    ``rims``: what its exact bodies do at every load, where the laws of its contacts know that already.
    """
    joint = in_motion(trees.map(lambda leaf: xp.asarray(leaf, dtype=float), joint))
    bodies = tuple(exact_bodies(joint)) if joint.body_model == "exact" else ()
    contacts = dataclasses.replace(joint_contacts(joint), rims=rims_of(bodies) if rims is None else rims)
    return JointMachine(
        joint=joint,
        contacts=contacts,
        bodies=bodies,
        stepped=stepped_rollers(joint) if joint.body_model == "exact" else (),
        masses=tuple(body_masses(joint)),
        pin_compliance=pin_compliances(joint),
        bores=pins_in_bores(joint),
        ring_compliance=_springs_in_series(joint),
        supports=_supports(joint),
    )


def _springs_in_series(joint: Joint) -> Array | None:
    """Compliance of springs in series with contacts, shape (contacts,) [m/N]; None for none.

    For the bending of rings with theirs, and of a spring that presses with all.
    """
    bending, pressing = joint.ring_bending_stiffness, joint.pressing_stiffness
    if bending is None and pressing is None:
        return None
    inside = np.array([contact.internal for contact in joint.drive.contacts])
    of_rings = 0.0 if bending is None else 1.0 / xp.asarray(bending, dtype=float)
    of_all = 0.0 if pressing is None else 1.0 / xp.asarray(pressing, dtype=float)
    return xp.where(inside, of_rings, 0.0) + of_all


def _supports(joint: Joint) -> Supports | None:
    """Springs that hold the rollers of a joint on the carrier besides its pins along their push; None for none."""
    drive = joint.drive
    planets = tuple(
        body
        for body in drive.floating
        if drive.bodies[body].place == "free" and not drive.bodies[body].on_axis
    )
    return carrier_supports(
        drive=drive,
        pin_transverse_stiffness=joint.pin_transverse_stiffness,
        planet_support_stiffness=joint.planet_support_stiffness,
        planets=planets,
    )
