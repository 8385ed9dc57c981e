"""The bodies of a drive, discs and annuli by plane elasticity, stepped rollers as springs; their inertias."""

from __future__ import annotations

import dataclasses

import numpy as np

from asperity.body.coupling import BodyInMachine, coupled_compliance, machine_kernel
from asperity.body.rim_moments import WIDEST_CONTACT, walls_resolved
from asperity.body.shapes import Annulus, Disc
from asperity.body.stepped import WIDEST_BORE, SteppedRoller, bore_addition
from asperity.contact.hertz_line import (
    logarithmic_compliance,
    ring_secant_compliance,
    roller_secant_compliance,
)
from asperity.drive.layout.drive import CARRIER, contact_angles, speeds
from asperity.drive.structure.inertia import roller_inertia
from asperity.engine.arrays import xp
from asperity.engine.control import added_at
from asperity.joint.contacts import JointContacts
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


def hollow_stepped(joint: Joint) -> dict[int, SteppedRoller]:
    """The hollow rollers with two tracks, by the numbers of the bodies."""
    rollers = {}
    for number, (shape, material) in enumerate(zip(joint.shapes, joint.materials, strict=True)):
        tracks = tracks_of(joint, number)
        if shape.kind != "hollow" or len(tracks) != 2:
            continue
        assert shape.size is not None
        one, two = track_lengths(joint, number)
        rollers[number] = SteppedRoller(
            (tracks[0][0], tracks[1][0]),
            (one, two),
            0.5 * shape.size,
            material.youngs_modulus,
            material.poisson_ratio,
            joint.plane_state,
        )
    return rollers


def _bores_of_stepped(joint: Joint) -> Array:
    """What the bores of stepped rollers add to the compliance of all contacts, shape (2 contacts, 2 contacts) [m/N]."""
    count = len(joint.drive.contacts)
    first, _ = places(joint.drive)
    at_first, at_second = contact_angles(joint.drive)
    added = xp.zeros((2 * count, 2 * count))
    for number, roller in hollow_stepped(joint).items():
        on_track = [(k, track) for track, (_, ks) in enumerate(tracks_of(joint, number)) for k in ks]
        contacts = np.array([k for k, _ in on_track])
        part = bore_addition(
            roller=roller,
            contact_angles=xp.stack([at_first[k] if first[k] == number else at_second[k] for k in contacts]),
            contact_tracks=tuple(track for _, track in on_track),
            sectors=joint.drive.sectors if joint.drive.bodies[number].place == "axis" else 1.0,
        )
        both = np.concatenate([contacts, contacts + count])
        added = added_at(added, (both[:, None], both[None]), part)
    return added


def _exact_sides(joint: Joint) -> np.ndarray:
    """Whether the first and the second body of each contact are exact, shape (2, contacts)."""
    exact = [len(tracks_of(joint, number)) == 1 for number in range(len(joint.drive.bodies))]
    return np.array([[exact[body] for body in side] for side in places(joint.drive)])


def one_sided_secants(contacts: JointContacts, half_width: Array) -> tuple[Array, Array]:
    """Secant compliance of the first and of the second body of each contact as springs.

    Shape (contacts,) [m/N].
    """
    pairs = contacts.pairs
    one, two = (
        {
            "contact_length": pairs.contact_length,
            "youngs_modulus": body.youngs_modulus,
            "poisson_ratio": body.poisson_ratio,
            "half_width": half_width,
        }
        for body in (contacts.driving, contacts.driven)
    )
    second = xp.where(
        pairs.sign > 0.0,
        roller_secant_compliance(radius=pairs.radius_2, **two),
        ring_secant_compliance(wall_thickness=contacts.ring_wall_thickness, **two),
    )
    return xp.asarray(roller_secant_compliance(radius=pairs.radius_1, **one)), second


def body_compliance(
    *, joint: Joint, contacts: JointContacts, half_width: Array, stick_half_width: Array
) -> Array:
    r"""Incremental compliance of all bodies of one sector between its contacts, shape (2 contacts, 2 contacts) [m/N].

    .. math:: C = \sum_{exact} P_b^\mathsf{T} C^{(b)} P_b + \operatorname{diag}\sum_{springs} \frac{1-\nu^2}{\pi E B}
              \left(2 \ln\frac{4R}{b} - 2\right) + \sum_{bores} \Delta C

    First the normal, then the tangential springs, from the half-widths of the strips and of their stick zones [m]. A
    stepped roller is a spring under each of its contacts; tangentially as stiff as normally, with the stick zone in
    place of the strip. To it comes what its bore adds, :func:`asperity.body.stepped.bore_addition`. Equations (E3) and
    (E6) of :doc:`/equations`.
    """
    count = len(joint.drive.contacts)
    exact = _exact_sides(joint)
    compliance = xp.zeros((2 * count, 2 * count))
    bodies = exact_bodies(joint)
    if bodies:
        compliance = coupled_compliance(
            bodies=bodies,
            contact_lengths=contacts.pairs.contact_length,
            half_widths=half_width,
            stick_half_widths=stick_half_width,
            kernel=contacts.rims,
        )
    if exact.all():
        return compliance
    local_compliance = []
    for width in (half_width, stick_half_width):
        sides = zip(
            one_sided_secants(contacts, width), (contacts.driving, contacts.driven), exact, strict=True
        )
        parts = []
        for secant, body, known in sides:
            bend = logarithmic_compliance(
                contact_length=contacts.pairs.contact_length,
                youngs_modulus=body.youngs_modulus,
                poisson_ratio=body.poisson_ratio,
            )
            parts.append(xp.where(known, 0.0, secant - bend))
        local_compliance.append(parts[0] + parts[1])
    return compliance + xp.diag(xp.concatenate(local_compliance)) + _bores_of_stepped(joint)


def with_rims(joint: Joint, contacts: JointContacts) -> JointContacts:
    """The contacts of a joint, with what its exact bodies do at every load."""
    bodies = exact_bodies(joint) if joint.body_model == "exact" else []
    return dataclasses.replace(contacts, rims=machine_kernel(bodies)) if bodies else contacts


def contact_walls(joint: Joint) -> list[tuple[list[int], Real]]:
    """Contacts of each ring, hollow roller and track of a hollow stepped roller, and the wall that they press [m]."""
    walls: list[tuple[list[int], Real]] = [
        (list(member.contacts), member.body.outer_radius - member.body.inner_radius)
        for member in exact_bodies(joint)
        if isinstance(member.body, Annulus)
    ]
    for number, roller in hollow_stepped(joint).items():
        walls += [(contacts, radius - roller.bore_radius) for radius, contacts in tracks_of(joint, number)]
    return walls


def walls_known(*, joint: Joint, half_width: Array) -> Array:
    """Whether every ring and hollow roller has a wall for which its compliance is known."""
    holds = xp.ones((), dtype=bool)
    if joint.body_model == "springs":
        return holds
    for member in exact_bodies(joint):
        body = member.body
        if not isinstance(body, Annulus):
            continue
        alone = member.sectors is None
        sectors: Real = 1.0 if member.sectors is None else member.sectors
        holds = holds & walls_resolved(
            ratio=body.inner_radius / body.outer_radius, sectors=sectors, one_sector=alone
        )
    for roller in hollow_stepped(joint).values():
        holds = holds & (roller.bore_radius <= WIDEST_BORE * xp.minimum(*roller.radii))
    for contacts, wall in contact_walls(joint):
        holds = holds & ~(xp.max(half_width[np.array(contacts)]) > WIDEST_CONTACT * wall)
    return holds


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
