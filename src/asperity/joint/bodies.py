"""The bodies of a joint: discs and annuli by plane elasticity, stepped rollers; their inertias."""

from __future__ import annotations

import numpy as np

from asperity.body.coupling import BodyInMachine, machine_kernel
from asperity.body.rim_moments import RimKernel
from asperity.body.shapes import Annulus, Disc
from asperity.body.stepped import SteppedRoller
from asperity.drive.layout.drive import CARRIER, contact_angles, speeds
from asperity.drive.structure.inertia import roller_inertia
from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.joint.description import (
    Joint,
    body_masses,
    contact_values,
    cylinders,
    places,
    track_lengths,
    tracks_of,
)
from asperity.types import Array, Real


def exact_bodies(joint: Joint) -> list[BodyInMachine]:
    """Bodies with one track, whose contacts balance in one plane.

    Not stepped rollers, whose tracks lie in several planes.
    """
    lengths = contact_values(joint, joint.contact_lengths)
    first, _ = places(joint.drive)
    at_first, at_second = contact_angles(joint.drive)
    bodies = []
    for number, (body, shape, material) in enumerate(
        zip(joint.drive.bodies, joint.shapes, joint.materials, strict=True)
    ):
        tracks = tracks_of(joint, number)
        if len(tracks) != 1:
            continue
        radius, contacts = tracks[0]
        length = xp.max(lengths[np.array(contacts)])
        elastic = (length, material.youngs_modulus, material.poisson_ratio)
        solid: Disc | Annulus
        if shape.kind == "ring":
            assert shape.size is not None
            outer = radius + shape.size
            solid = Annulus(radius, outer, *elastic, *shape.rim_stiffness, "inner", joint.plane_state)
        elif shape.kind == "hollow":
            assert shape.size is not None
            solid = Annulus(0.5 * shape.size, radius, *elastic, 0.0, 0.0, "outer", joint.plane_state)
        else:
            solid = Disc(radius, *elastic, joint.plane_state)
        angles = [at_first[k] if first[k] == number else at_second[k] for k in contacts]
        sectors = joint.drive.sectors if body.place == "axis" else None
        bodies.append(BodyInMachine(solid, tuple(contacts), xp.stack(angles), sectors))
    return bodies


class SteppedInMachine(Module):
    """A hollow roller with two tracks, and the positions of its contacts.

    Parameters
    ----------
    roller : SteppedRoller
        The roller.
    contacts, tracks : tuple of int
        Numbers of its contacts, and of the track of each [-].
    contact_angles : Array
        Their polar angles about its centre, shape (n,) [rad].
    sectors : Real
        Number of equal sectors that share it [-].
    """

    roller: SteppedRoller
    contacts: tuple[int, ...] = static()
    tracks: tuple[int, ...] = static()
    contact_angles: Array
    sectors: Real

    def on_track(self, track: int) -> list[int]:
        """Its contacts on one of its tracks."""
        return [contact for contact, on in zip(self.contacts, self.tracks, strict=True) if on == track]


def are_stepped(joint: Joint) -> tuple[int, ...]:
    """Numbers of the hollow rollers with two tracks."""
    return tuple(
        number
        for number, shape in enumerate(joint.shapes)
        if shape.kind == "hollow" and len(tracks_of(joint, number)) == 2
    )


def stepped_rollers(joint: Joint) -> tuple[SteppedInMachine, ...]:
    """The hollow rollers with two tracks."""
    first, _ = places(joint.drive)
    at_first, at_second = contact_angles(joint.drive)
    rollers = []
    for number in are_stepped(joint):
        (radius, ones), (other, others) = tracks_of(joint, number)
        shape, material = joint.shapes[number], joint.materials[number]
        assert shape.size is not None
        one, two = track_lengths(joint, number)
        elastic = (material.youngs_modulus, material.poisson_ratio)
        roller = SteppedRoller((radius, other), (one, two), 0.5 * shape.size, *elastic, joint.plane_state)
        contacts = (*ones, *others)
        angles = [at_first[k] if first[k] == number else at_second[k] for k in contacts]
        sectors = joint.drive.sectors if joint.drive.bodies[number].place == "axis" else 1.0
        tracks = (0,) * len(ones) + (1,) * len(others)
        rollers.append(SteppedInMachine(roller, contacts, tracks, xp.stack(angles), sectors))
    return tuple(rollers)


def rims_of(bodies: tuple[BodyInMachine, ...]) -> RimKernel | None:
    """What exact bodies do at every load; None without any."""
    return machine_kernel(list(bodies)) if bodies else None


def body_spins(joint: Joint) -> list[Real]:
    """Moment of inertia of one of each body about its own axis [kg·m^2]; (D1)."""
    return [
        sum(
            roller_inertia(mass=part, radius=radius, bore_diameter=bore)
            for part, radius, bore in cylinders(joint, number)
        )
        for number in range(len(joint.shapes))
    ]


def joint_inertias(joint: Joint) -> tuple[Real, Real, Real]:
    r"""Inertias of the input roller, of the spin of the rollers off the axis, and of all other motions.

    .. math::
        J_{in} = I_{in}, \qquad J_{spin} = \sum_b n_b I_b \left(\frac{\omega_b}{\omega_{in}}\right)^2, \qquad
        J_{out} = \sum_b n_b m_b r_b^2 \left(\frac{\omega_c}{\omega_{out}}\right)^2
        + \sum_a I_a \left(\frac{\omega_a}{\omega_{out}}\right)^2

    over the bodies b off the axis, whose orbit is that of the carrier, and the bodies a on the axis but the input.

    Parameters
    ----------
    joint : Joint
        One joint.

    Returns
    -------
    tuple of Real
        The first two about the axis of the input, the third at the output [kg·m^2]; without the carrier, whose shape a
        joint file does not state.

    Notes
    -----
    What the drive has when it rolls without slip. In a vibration the spin follows the springs of the contacts:
    :func:`asperity.drive.structure.dynamics.natural_frequencies`.

    References
    ----------
    Twice the kinetic energy of rolling without slip; equation (D1) of :doc:`/equations`.
    """
    drive = joint.drive
    speed = speeds(drive)
    carrier, out = speed[drive.members.index(CARRIER)], speed[drive.members.index(drive.output)]
    entry: Real = 0.0
    spinning: Real = 0.0
    moved: Real = 0.0
    parts = zip(drive.bodies, body_masses(joint), body_spins(joint), strict=True)
    for number, (body, mass, spin) in enumerate(parts):
        if body.name == drive.input:
            entry = entry + spin
        elif body.on_axis:
            moved = moved + spin * (speed[number] / out) ** 2
        else:
            spinning = spinning + drive.sectors * spin * speed[number] ** 2  # the input has the speed 1
            moved = moved + drive.sectors * mass * xp.sum(drive.centres[number] ** 2) * (carrier / out) ** 2
    return entry, spinning, moved
