"""Bodies, tracks, masses and contacts of planar joints by hand."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint.description import (
    ContactFit,
    bodies_of_contacts,
    body_masses,
    contact_values,
    joint_contacts,
    tracks_of,
)

DENSITY = 7833.0  # of 52100 in the library


def test_tracks_of_a_stepped_roller(planar_joint):
    joint = planar_joint("stepped_planet")
    planet = [(float(radius), contacts) for radius, contacts in tracks_of(joint, 1)]
    assert planet == [(pytest.approx(20e-3), [0, 1]), (pytest.approx(18e-3), [2])]
    assert [len(tracks_of(joint, body)) for body in (0, 2, 3)] == [1, 1, 1]


def test_masses(planar_joint):
    """Cylinders and rings, pi rho L; every track as long as its longest contact."""
    lengths = {'contact_length = "10 mm"': 'contact_length = { sp = "10 mm", pr = "12 mm" }'}
    sun, planet, ring = body_masses(planar_joint("planetary", lengths))
    unit = DENSITY * math.pi
    assert float(sun) == pytest.approx(unit * 10e-3**2 * 10e-3, rel=1e-12)
    assert float(planet) == pytest.approx(unit * 20e-3**2 * 12e-3, rel=1e-12)
    assert float(ring) == pytest.approx(unit * (58e-3**2 - 50e-3**2) * 12e-3, rel=1e-12)
    bored = body_masses(planar_joint("planetary_hollow"))[1]
    assert float(bored) == pytest.approx(unit * (20e-3**2 - 13e-3**2) * 10e-3, rel=1e-12)
    stepped = body_masses(planar_joint("stepped_planet"))[1]
    assert float(stepped) == pytest.approx(unit * (20e-3**2 + 18e-3**2) * 10e-3, rel=1e-12)
    through = {"[drive]": '[drive]\nplanet_bore_diameter = "16 mm"'}
    hollow = body_masses(planar_joint("stepped_planet", through))[1]
    assert float(hollow) == pytest.approx(unit * (20e-3**2 + 18e-3**2 - 2.0 * 8e-3**2) * 10e-3, rel=1e-12)


def test_interference_at_work_counts_sizes_and_temperature(planar_joint):
    """30 um at the ring; 2 um of sizes, and 0.1 um less and 0.2 um more for each of 30 K."""
    joint = dataclasses.replace(
        planar_joint("planetary"),
        fit=ContactFit(30e-6, 1e-7, 20.0, 50.0, np.array([-1e-7, 2e-7])),
    )
    np.testing.assert_allclose(joint.working_pattern, [-0.1, 1.2], rtol=1e-12)
    sized = dataclasses.replace(joint, unlike=SimpleNamespace(added=np.array([2e-6, 0.0])))
    np.testing.assert_allclose(sized.working_pattern, [-0.1 + 2.0 / 30.0, 1.2], rtol=1e-12)


def test_contacts(planar_joint):
    """1/R = 1/10 + 1/20 at the sun and 1/20 - 1/50 in the ring [1/mm]; E* of two steel bodies."""
    table = {"friction_coefficient = 0.08": "friction_coefficient = { sp = 0.08, pr = 0.06 }"}
    contacts = joint_contacts(planar_joint("planetary", table))
    np.testing.assert_allclose(contacts.pairs.effective_radius, [20e-3 / 3.0, 100e-3 / 3.0], rtol=1e-12)
    np.testing.assert_allclose(contacts.pairs.friction_coefficient, [0.08, 0.06])
    np.testing.assert_allclose(contacts.pairs.moduli.contact_modulus, 203e9 / (2.0 * (1.0 - 0.29**2)))
    assert float(contacts.ring_wall_thickness[1]) == pytest.approx(8e-3)


def test_one_entry_for_all_or_one_each(planar_joint):
    joint = planar_joint("multiroller")
    np.testing.assert_allclose(contact_values(joint, (2.0,)), [2.0, 2.0, 2.0, 2.0])
    np.testing.assert_allclose(contact_values(joint, (1.0, 2.0, 3.0, 4.0)), [1.0, 2.0, 3.0, 4.0])


def test_bodies_of_contacts(planar_joint):
    joint = planar_joint("multiroller")
    bodies = bodies_of_contacts(joint)
    assert bodies.names == ("sun", "first_row", "second_row", "ring")
    assert bodies.shared == (True, False, False, True)
    assert (bodies.driving, bodies.driven) == ((0, 1, 1, 2), (1, 2, 2, 3))
    assert joint.contact_names == ("sf", "fsl", "fsr", "sr")
