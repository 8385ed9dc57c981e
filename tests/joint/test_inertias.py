"""Inertias of drives: cylinders that roll without slip by hand, and the vibration of all bodies on all springs."""

import math

import numpy as np
import pytest
import scipy.linalg

from asperity.drive.layout.drive import incidence, speed_ratio
from asperity.joint.bodies import joint_inertias
from asperity.joint.description import body_masses, cylinders
from asperity.joint.solve import solve_joint

DENSITY = 7810.0  # 52100


def disc(radius, length, bore=0.0):
    mass = DENSITY * math.pi * (radius**2 - bore**2 / 4.0) * length
    return mass, 0.5 * mass * (radius**2 + bore**2 / 4.0)


def test_planetary_with_the_carrier_as_output(planar_joint):
    """Three planets of 20 mm around a sun of 10 mm in a ring of 50 mm, which stands: i = 6."""
    entry, moved = joint_inertias(planar_joint("planetary"))
    mass, spin = disc(20e-3, 10e-3)
    # in one turn of the carrier the planet turns 1 - 50/20 times, in one of the sun a sixth of it
    assert float(entry) == pytest.approx(disc(10e-3, 10e-3)[1] + 3 * spin * (1.5 / 6.0) ** 2, rel=5e-3)
    assert float(moved) == pytest.approx(3 * mass * 30e-3**2, rel=5e-3)


def test_planetary_with_the_ring_as_output(planar_joint):
    joint = planar_joint("planetary", {'output = "carrier"': 'output = "ring"'})
    entry, moved = joint_inertias(joint)
    ring = disc(58e-3, 10e-3, bore=100e-3)[1]
    _, spin = disc(20e-3, 10e-3)
    assert float(moved) == pytest.approx(ring, rel=5e-3)
    assert float(entry) == pytest.approx(disc(10e-3, 10e-3)[1] + 3 * spin * 0.5**2, rel=5e-3)


def test_free_frequency_is_that_of_all_bodies_on_the_springs_of_all_contacts(planar_joint):
    """Two inertias on one spring against every displacement and rotation of a planetary, by its eigenvalues."""
    joint = planar_joint("planetary")
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
            np.full(len(drive.pinned), 1e12),
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
            mass[(place["carrier"],) * 2] += copies * float(each) * float(np.sum(drive.centres[number] ** 2))
            at = 2 * drive.floating.index(number)
            mass[at, at] = mass[at + 1, at + 1] = copies * float(each)
    mass[(place["sun"],) * 2] += motor
    mass[(place["carrier"],) * 2] += load
    kept = [k for k in range(len(mass)) if k != place["ring"]]
    stiffness, mass = stiffness[np.ix_(kept, kept)], mass[np.ix_(kept, kept)]
    rigid, squared, *_ = scipy.linalg.eigh(stiffness, mass, eigvals_only=True)
    assert abs(rigid) < 1e-6 * squared

    locked = [k for k in range(len(kept)) if kept[k] != place["sun"]]
    torque = np.eye(len(kept))[kept.index(place["carrier"])][locked]
    turned = np.linalg.solve(stiffness[np.ix_(locked, locked)], torque) @ torque
    entry, moved = (float(each) for each in joint_inertias(joint))
    ratio = float(speed_ratio(drive))
    two = (1.0 / (ratio**2 * (motor + entry)) + 1.0 / (load + moved)) / turned
    assert math.sqrt(two / squared) == pytest.approx(1.0, abs=0.01)


def test_the_wedge_drive_is_twice_the_kinetic_energy_of_its_bodies(paper_joint):
    """The carrier turns with 1 rad/s: rollers on the standing ring, planets that turn against them."""
    entry, moved = joint_inertias(paper_joint(density=DENSITY))
    mass, spin = disc(13.5e-3, 5e-3)
    roller_mass, roller_spin = disc(5e-3, 5e-3)
    # in the carrier's frame the surfaces of ring, roller and planet have one speed, 40 mm/s
    energy = 0.5 * (mass * 17.5e-3**2 + spin * (1.0 + 40.0 / 13.5) ** 2)
    energy += 2 * 0.5 * (roller_mass * 35e-3**2 + roller_spin * (35.0 / 5.0) ** 2)
    sun = 0.5 * disc(4e-3, 5e-3)[1] * 9.0**2
    assert float(moved + entry * 9.0**2) == pytest.approx(2.0 * (3.0 * energy + sun), rel=1e-12)
