"""Inertias of drives: cylinders that roll without slip by hand, and the vibration of all bodies on all springs."""

import math

import numpy as np
import pytest
import scipy.linalg

from asperity.drive.layout.drive import incidence
from asperity.joint.bodies import joint_inertias
from asperity.joint.description import body_masses, cylinders
from asperity.joint.solve import solve_joint
from asperity.standing.dynamics import Inertias, dynamics

DENSITY = 7810.0  # 52100


def disc(radius, length, bore=0.0):
    mass = DENSITY * math.pi * (radius**2 - bore**2 / 4.0) * length
    return mass, 0.5 * mass * (radius**2 + bore**2 / 4.0)


def test_planetary_with_the_carrier_as_output(planar_joint):
    """Three planets of 20 mm around a sun of 10 mm in a ring of 50 mm, which stands: i = 6."""
    entry, spinning, moved = joint_inertias(planar_joint("planetary"))
    mass, spin = disc(20e-3, 10e-3)
    # in one turn of the carrier the planet turns 1 - 50/20 times, in one of the sun a sixth of it
    assert float(entry) == pytest.approx(disc(10e-3, 10e-3)[1], rel=5e-3)
    assert float(spinning) == pytest.approx(3 * spin * (1.5 / 6.0) ** 2, rel=5e-3)
    assert float(moved) == pytest.approx(3 * mass * 30e-3**2, rel=5e-3)


def test_planetary_with_the_ring_as_output(planar_joint):
    joint = planar_joint("planetary", {'output = "carrier"': 'output = "ring"'})
    entry, spinning, moved = joint_inertias(joint)
    ring = disc(58e-3, 10e-3, bore=100e-3)[1]
    _, spin = disc(20e-3, 10e-3)
    assert float(moved) == pytest.approx(ring, rel=5e-3)
    assert float(entry) == pytest.approx(disc(10e-3, 10e-3)[1], rel=5e-3)
    assert float(spinning) == pytest.approx(3 * spin * 0.5**2, rel=5e-3)


@pytest.mark.slow
def test_free_frequency_is_that_of_three_inertias_on_the_printed_springs(planetary):
    """Sun with motor, planets, carrier with load; between them what ``asperity joint`` prints of the contacts.

    A soft ring holds the planets less than the sun does: they do not turn as rolling without slip demands.
    """
    joint, _, document = planetary
    motor, load = 2e-5, 0.05
    stiffness = document["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    shares = document["stiffness_budget"]["tangential_share"]
    sun, planet, ring, count = 10e-3, 20e-3, 50e-3, 3
    # 1 N·m at the carrier is 1/6 N·m at the sun: Q each contact; n Q^2/k is the share of a contact of 1/K, n k below
    force = 1.0 / 6.0 / (count * sun)
    springs = [count * count * force**2 * stiffness / shares[name] for name in ("sp", "pr")]
    mass, spin = disc(planet, 10e-3)
    rows = np.array([[sun, planet, -(sun + planet)], [0.0, planet, ring - planet]])
    inertias = np.diag([motor + disc(sun, 10e-3)[1], count * spin, load + count * mass * (sun + planet) ** 2])
    rigid, squared, _ = scipy.linalg.eigh(rows.T @ np.diag(springs) @ rows, inertias, eigvals_only=True)
    assert abs(rigid) < 1e-6 * squared
    found = dynamics(joint, Inertias(motor, load, 0.0)).at_torque
    by_hand = math.sqrt(squared) / (2.0 * math.pi)
    assert 4137.0 < by_hand < 4160.0
    assert float(found.free_frequency) == pytest.approx(by_hand, rel=2e-3)


@pytest.mark.slow
@pytest.mark.parametrize("ring_contact", ["10 mm", "2 mm"])
def test_free_frequency_is_that_of_all_bodies_on_the_springs_of_all_contacts(planar_joint, ring_contact):
    """One spring for each contact, that of the ring soft or not: all displacements and rotations of a planetary."""
    replaced = {
        'bodies = "exact"': 'bodies = "springs"',
        'ring_support = "free" ': 'ring_support = "rigid_housing" ',
        'contact_length = "10 mm"': f'contact_length = {{ sp = "10 mm", pr = "{ring_contact}" }}',
    }
    joint = planar_joint("planetary", replaced)
    motor, load = 2e-5, 0.05
    drive, result = joint.drive, solve_joint(joint).result
    matrices, members, sectors = incidence(drive), list(drive.members), float(drive.sectors)
    moves = np.asarray(matrices.approach).shape[1]
    nothing = np.zeros((len(drive.contacts), len(members)))
    springs = [
        (np.hstack([matrices.approach, nothing]), np.asarray(result.interfaces.normal)),
        (np.hstack([matrices.sliding, matrices.turning]), np.asarray(result.interfaces.tangential)),
        (
            np.hstack([matrices.pins, np.zeros((len(drive.pinned), len(members)))]),
            np.full(len(drive.pinned), 1e14),
        ),
    ]
    stiffness = sectors * sum(rows.T @ np.diag(values) @ rows for rows, values in springs)
    mass = np.zeros_like(stiffness)
    place = {name: moves + k for k, name in enumerate(members)}
    for number, (body, each) in enumerate(zip(drive.bodies, body_masses(joint), strict=True)):
        copies = 1.0 if body.place == "axis" else sectors
        for part, radius, bore in cylinders(joint, number):
            mass[(place[body.name],) * 2] += (
                copies * 0.5 * float(part) * (float(radius) ** 2 + float(bore) ** 2 / 4)
            )
        if body.place != "axis":
            # the carrier takes the centre along, and the displacement comes on top
            x, y = drive.centres[number]
            velocity = np.zeros((2, len(mass)))
            at = 2 * drive.floating.index(number)
            velocity[0, at] = velocity[1, at + 1] = 1.0
            velocity[:, place["carrier"]] = -y, x
            mass += copies * float(each) * velocity.T @ velocity
    mass[(place["sun"],) * 2] += motor
    mass[(place["carrier"],) * 2] += load
    kept = [k for k in range(len(mass)) if k != place["ring"]]
    stiffness, mass = stiffness[np.ix_(kept, kept)], mass[np.ix_(kept, kept)]
    rigid, squared, *_ = scipy.linalg.eigh(stiffness, mass, eigvals_only=True)
    assert abs(rigid) < 1e-6 * squared
    locked = [k for k in range(len(kept)) if kept[k] != place["sun"]]
    held = scipy.linalg.eigh(
        stiffness[np.ix_(locked, locked)], mass[np.ix_(locked, locked)], eigvals_only=True
    )
    found = dynamics(joint, Inertias(motor, load, 0.0)).at_torque
    assert float(found.free_frequency) == pytest.approx(math.sqrt(squared) / (2.0 * math.pi), rel=1e-5)
    assert float(found.locked_frequency) == pytest.approx(math.sqrt(held[0]) / (2.0 * math.pi), rel=1e-5)


def test_the_wedge_drive_is_twice_the_kinetic_energy_of_its_bodies(paper_joint):
    """The carrier turns with 1 rad/s: rollers on the standing ring, planets that turn against them."""
    entry, spinning, moved = joint_inertias(paper_joint(density=DENSITY))
    mass, spin = disc(13.5e-3, 5e-3)
    roller_mass, roller_spin = disc(5e-3, 5e-3)
    # in the carrier's frame the surfaces of ring, roller and planet have one speed, 40 mm/s
    energy = 0.5 * (mass * 17.5e-3**2 + spin * (1.0 + 40.0 / 13.5) ** 2)
    energy += 2 * 0.5 * (roller_mass * 35e-3**2 + roller_spin * (35.0 / 5.0) ** 2)
    sun = 0.5 * disc(4e-3, 5e-3)[1] * 9.0**2
    assert float(moved + (entry + spinning) * 9.0**2) == pytest.approx(2.0 * (3.0 * energy + sun), rel=1e-12)
