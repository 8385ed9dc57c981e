"""Bodies of planar joints: which are exact, where they are touched, and stepped rollers."""

import dataclasses
import math

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.body.shapes import Annulus, Disc
from asperity.body.stepped import SteppedRoller, bore_addition
from asperity.joint.bodies import exact_bodies
from asperity.joint.body_compliance import body_compliance, one_sided_secants, walls_known
from asperity.joint.description import joint_contacts
from asperity.joint.machine import joint_machine

YOUNG, POISSON, LENGTH = 203e9, 0.29, 10e-3  # of the examples
UNIT = (1.0 - POISSON**2) / (math.pi * YOUNG * LENGTH)


def test_sun_and_planet_are_discs_and_the_ring_an_annulus(planar_joint):
    sun, planet, ring = exact_bodies(planar_joint("planetary"))
    assert isinstance(sun.body, Disc)
    assert isinstance(planet.body, Disc)
    assert isinstance(ring.body, Annulus)
    assert (float(ring.body.inner_radius), float(ring.body.outer_radius)) == pytest.approx((50e-3, 58e-3))
    assert (sun.contacts, planet.contacts, ring.contacts) == ((0,), (0, 1), (1,))
    # the planet lies above the sun: it is touched from below by the sun and from above by the ring
    np.testing.assert_allclose(np.cos(planet.contact_angles), [0.0, 0.0], atol=1e-12)
    np.testing.assert_allclose(np.sin(planet.contact_angles), [-1.0, 1.0])
    np.testing.assert_allclose(np.sin([sun.contact_angles[0], ring.contact_angles[0]]), 1.0)
    assert (sun.sectors, planet.sectors, ring.sectors) == (3.0, None, 3.0)


def test_hollow_planets_have_half_the_bore_as_inner_radius(planar_joint):
    planet = exact_bodies(planar_joint("planetary_hollow"))[1].body
    assert (float(planet.inner_radius), float(planet.outer_radius)) == pytest.approx((13e-3, 20e-3))


def test_a_stepped_planet_is_a_spring_at_each_contact(planar_joint):
    """Beside sun and rings: (1 - nu^2)/(pi E B) (2 ln(4 R/b) - 2), without coupling."""
    joint = planar_joint("stepped_planet")
    assert [member.contacts for member in exact_bodies(joint)] == [(0,), (1,), (2,)]
    machine = dataclasses.replace(joint_machine(joint), bodies=())
    width, stick = jnp.array([0.1e-3, 0.2e-3, 0.15e-3]), jnp.array([0.05e-3, 0.1e-3, 0.1e-3])
    whole = body_compliance(machine=machine, half_width=width, stick_half_width=stick)
    radius = np.array([20e-3, 20e-3, 18e-3])
    by_hand = [UNIT * (2.0 * np.log(4.0 * radius / each) - 2.0) for each in (width, stick)]
    np.testing.assert_allclose(whole, np.diag(np.concatenate(by_hand)), rtol=1e-9)


@pytest.mark.long
def test_a_bore_of_a_stepped_planet_adds_its_compliance(planar_joint):
    """Between the contacts of the planet, which lies above the sun, and nothing else."""
    bored = planar_joint("stepped_planet", {"[drive]": '[drive]\nplanet_bore_diameter = "16 mm"'})
    width = jnp.array([0.1e-3, 0.2e-3, 0.15e-3])
    hollow, solid = (
        body_compliance(machine=joint_machine(joint), half_width=width, stick_half_width=width)
        for joint in (bored, planar_joint("stepped_planet"))
    )
    added = bore_addition(
        roller=SteppedRoller((20e-3, 18e-3), (LENGTH, LENGTH), 8e-3, YOUNG, POISSON, "plane_strain"),
        contact_angles=jnp.array([-0.5, 0.5, 0.5]) * math.pi,
        contact_tracks=(0, 0, 1),
        sectors=1.0,
    )
    np.testing.assert_allclose(hollow - solid, added, rtol=1e-9, atol=1e-9 * float(jnp.max(jnp.abs(solid))))
    assert float(added[0, 0]) > 0.05 * float(solid[0, 0])


@pytest.mark.parametrize(
    ("bore", "wide", "known"), [(23e-3, 1e-4, True), (24e-3, 1e-4, False), (22e-3, 1.5e-3, False)]
)
def test_walls_of_a_stepped_planet(planar_joint, bore, wide, known):
    """Its bore is at most 0.65 of 36 mm; 18 mm less half of 22 mm are 7 mm, five half-widths of 1.4 mm."""
    joint = planar_joint("stepped_planet", {"[drive]": f'[drive]\nplanet_bore_diameter = "{1e3 * bore} mm"'})
    assert bool(walls_known(machine=joint_machine(joint), half_width=jnp.array([1e-4, 1e-4, wide]))) == known


def test_springs_of_one_side(planar_joint):
    """Johnson section 5.6 for rollers, Weber and Banaschek over the wall for the ring."""
    width = np.array([0.1e-3, 0.2e-3])
    first, second = one_sided_secants(joint_contacts(planar_joint("planetary")), jnp.asarray(width))
    np.testing.assert_allclose(
        first, UNIT * (2.0 * np.log(4.0 * np.array([10e-3, 20e-3]) / width) - 1.0), rtol=1e-12
    )
    planet = UNIT * (2.0 * math.log(4.0 * 20e-3 / 0.1e-3) - 1.0)
    ring = 2.0 * UNIT * (math.log(2.0 * 8e-3 / 0.2e-3) - POISSON / (2.0 * (1.0 - POISSON)))
    np.testing.assert_allclose(second, [planet, ring], rtol=1e-12)


@pytest.mark.parametrize(("width", "known"), [(1.59e-3, True), (1.61e-3, False)])
def test_a_wall_has_five_half_widths(planar_joint, width, known):
    """The ring of the example has 8 mm."""
    joint = planar_joint("planetary")
    assert bool(walls_known(machine=joint_machine(joint), half_width=jnp.array([9e-3, width]))) == known


@pytest.mark.parametrize(("wall", "known"), [("0.2 mm", False), ("1 mm", True)])
def test_a_ring_of_three_sectors_has_a_wall_of_about_one_percent(planar_joint, wall, known):
    """1 % of its radius of 50 mm is 0.5 mm."""
    joint = planar_joint("planetary", {'ring_wall_thickness = "8 mm"': f'ring_wall_thickness = "{wall}"'})
    assert bool(walls_known(machine=joint_machine(joint), half_width=jnp.array([9e-3, 1e-5]))) == known


def test_springs_need_no_wall(planar_joint):
    springs = {
        'bodies = "exact"': 'bodies = "springs"',
        'plane_state = "plane_strain"': "",
        'ring_support = "free"': "",
    }
    assert bool(
        walls_known(machine=joint_machine(planar_joint("planetary", springs)), half_width=jnp.full(2, 1.0))
    )
