"""Laws of the contacts of a planar joint: the force that an interference makes, and what turns with the carrier."""

import dataclasses
import math

import numpy as np
import pytest
from scipy.optimize import brentq

from asperity.joint.planar.description import body_masses, planar_contacts
from asperity.joint.planar.laws import contact_laws, drive_load

YOUNG, POISSON, LENGTH = 203e9, 0.29, 10e-3  # of the example
SPRINGS = {
    'bodies = "exact"': 'bodies = "springs"',
    'plane_state = "plane_strain"': "",
    'ring_support = "free"': "",
}


def test_reference_force_of_an_interference(planar_joint):
    """30 um are the compressions of both contacts: two cylinders, and a cylinder against a wall of 8 mm."""
    unit, modulus = (1.0 - POISSON**2) / (math.pi * YOUNG * LENGTH), YOUNG / (2.0 * (1.0 - POISSON**2))

    def compression(force):
        one, two = (
            math.sqrt(4.0 * force * radius / (math.pi * LENGTH * modulus))
            for radius in (20e-3 / 3.0, 100e-3 / 3.0)
        )
        sun = sum(2.0 * math.log(4.0 * radius / one) - 1.0 for radius in (10e-3, 20e-3))
        planet = 2.0 * math.log(4.0 * 20e-3 / two) - 1.0
        ring = 2.0 * (math.log(2.0 * 8e-3 / two) - POISSON / (2.0 * (1.0 - POISSON)))
        return force * unit * (sun + planet + ring)

    joint = planar_joint("planetary", SPRINGS)
    laws = contact_laws(joint, planar_contacts(joint))
    expected = brentq(lambda force: compression(force) - 30e-6, 10.0, 1e6)
    np.testing.assert_allclose(laws.reference_force, expected, rtol=1e-3)
    assert laws.coupling is None
    force = float(laws.reference_force[0])
    secants = np.asarray(laws.springs.secant_compliance)
    assert force * secants.sum() == pytest.approx(compression(force), rel=1e-12)


def test_a_given_preload_is_the_reference(planar_joint):
    joint = planar_joint("planetary", SPRINGS | {'interference = "30 um"': 'preload = "700 N"'})
    laws = contact_laws(joint, planar_contacts(joint))
    np.testing.assert_allclose(laws.reference_force, 700.0, rtol=1e-12)
    # asperities soften the slip in the sense of their stiffness
    assert np.all(np.asarray(laws.asperity_compliance) > 0.0)


def test_centrifugal_force_and_pin(planar_joint):
    """m omega^2 r outwards at 1500 rpm over the ratio 6; the pin is the reciprocal of its stiffness."""
    joint = dataclasses.replace(planar_joint("planetary"), pin_stiffness=1e8)
    load = drive_load(joint, body_masses(joint), 7.0)
    mass, omega = 7833.0 * math.pi * 20e-3**2 * LENGTH, 1500.0 * math.pi / 30.0 / 6.0
    np.testing.assert_allclose(load.body_force, [[0.0, mass * omega**2 * 30e-3]], rtol=1e-12, atol=1e-12)
    assert float(load.pin_compliance) == pytest.approx(1e-8)
    assert float(load.output_torque) == 7.0
    rigid = drive_load(planar_joint("planetary"), body_masses(joint), 7.0)
    assert float(rigid.pin_compliance) == 0.0
