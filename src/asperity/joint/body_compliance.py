"""The compliance of the bodies of a joint between its contacts, and the walls for which it is known."""

from __future__ import annotations

import numpy as np

from asperity.body.coupling import coupled_compliance
from asperity.body.rim_moments import WIDEST_CONTACT, walls_resolved
from asperity.body.shapes import Annulus
from asperity.body.stepped import WIDEST_BORE, bore_addition
from asperity.contact.hertz_line import (
    logarithmic_compliance,
    ring_secant_compliance,
    roller_secant_compliance,
)
from asperity.drive.layout.drive import Drive
from asperity.engine.arrays import xp
from asperity.engine.control import added_at
from asperity.joint.contacts import JointContacts
from asperity.joint.machine import JointMachine
from asperity.types import Array, Real


def body_compliance(*, machine: JointMachine, half_width: Array, stick_half_width: Array) -> Array:
    r"""Incremental compliance of all bodies of one sector between its contacts, shape (2 contacts, 2 contacts) [m/N].

    .. math:: C = \sum_{exact} P_b^\mathsf{T} C^{(b)} P_b + \operatorname{diag}\sum_{springs} \frac{1-\nu^2}{\pi E B}
              \left(2 \ln\frac{4R}{b} - 2\right) + \sum_{bores} \Delta C

    First the normal, then the tangential springs, from the half-widths of the strips and of their stick zones [m]. A
    stepped roller is a spring under each of its contacts; tangentially as stiff as normally, with the stick zone in
    place of the strip. To it comes what its bore adds, :func:`asperity.body.stepped.bore_addition`. Equations (E3) and
    (E6) of :doc:`/equations`.
    """
    count, contacts = len(machine.drive.contacts), machine.contacts
    exact = _exact_sides(machine.drive)
    compliance = xp.zeros((2 * count, 2 * count))
    if machine.bodies:
        compliance = coupled_compliance(
            bodies=list(machine.bodies),
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
    return compliance + xp.diag(xp.concatenate(local_compliance)) + _bores_of_stepped(machine)


def _exact_sides(drive: Drive) -> np.ndarray:
    """Whether the first and the second body of each contact are exact, those of one track, shape (2, contacts)."""
    exact = np.array([len(tracks) == 1 for tracks in drive.layout.tracks])
    return np.stack([exact[drive.layout.first], exact[drive.layout.second]])


def _bores_of_stepped(machine: JointMachine) -> Array:
    """What the bores of stepped rollers add to the compliance of all contacts, shape (2 contacts, 2 contacts) [m/N]."""
    count = len(machine.drive.contacts)
    added = xp.zeros((2 * count, 2 * count))
    for stepped in machine.stepped:
        part = bore_addition(
            roller=stepped.roller,
            contact_angles=stepped.contact_angles,
            contact_tracks=stepped.tracks,
            sectors=stepped.sectors,
        )
        contacts = np.array(stepped.contacts)
        both = np.concatenate([contacts, contacts + count])
        added = added_at(added, (both[:, None], both[None]), part)
    return added


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


def contact_walls(machine: JointMachine) -> list[tuple[list[int], Real]]:
    """Contacts of each ring, hollow roller and track of a hollow stepped roller, and the wall that they press [m]."""
    walls: list[tuple[list[int], Real]] = [
        (list(member.contacts), member.body.outer_radius - member.body.inner_radius)
        for member in machine.bodies
        if isinstance(member.body, Annulus)
    ]
    for stepped in machine.stepped:
        walls += [
            (stepped.on_track(track), radius - stepped.roller.bore_radius)
            for track, radius in enumerate(stepped.roller.radii)
        ]
    return walls


def walls_known(*, machine: JointMachine, half_width: Array) -> Array:
    """Whether every ring and hollow roller has a wall for which its compliance is known."""
    holds = xp.ones((), dtype=bool)
    for member in machine.bodies:
        body = member.body
        if not isinstance(body, Annulus):
            continue
        alone = member.sectors is None
        sectors: Real = 1.0 if member.sectors is None else member.sectors
        holds = holds & walls_resolved(
            ratio=body.inner_radius / body.outer_radius, sectors=sectors, one_sector=alone
        )
    for stepped in machine.stepped:
        holds = holds & (stepped.roller.bore_radius <= WIDEST_BORE * xp.minimum(*stepped.roller.radii))
    for contacts, wall in contact_walls(machine):
        holds = holds & ~(xp.max(half_width[np.array(contacts)]) > WIDEST_CONTACT * wall)
    return holds
