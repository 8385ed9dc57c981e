"""Inertias of planar drives by hand: cylinders that roll without slip."""

import math

import pytest

from asperity.joint.planar.inertias import planar_inertias

DENSITY = 7810.0  # 52100


def disc(radius, length, bore=0.0):
    mass = DENSITY * math.pi * (radius**2 - bore**2 / 4.0) * length
    return mass, 0.5 * mass * (radius**2 + bore**2 / 4.0)


def test_planetary_with_the_carrier_as_output(planar_joint):
    """Three planets of 20 mm around a sun of 10 mm; the ring stands."""
    sun, moved = planar_inertias(planar_joint("planetary"))
    assert float(sun) == pytest.approx(disc(10e-3, 10e-3)[1], rel=5e-3)
    mass, spin = disc(20e-3, 10e-3)
    # in one turn of the carrier the planet turns 1 - 50/20 times
    assert float(moved) == pytest.approx(3 * (mass * 30e-3**2 + spin * 1.5**2), rel=5e-3)


def test_planetary_with_the_ring_as_output(planar_joint):
    joint = planar_joint("planetary", {'output = "carrier"': 'output = "ring"'})
    _, moved = planar_inertias(joint)
    ring = disc(58e-3, 10e-3, bore=100e-3)[1]
    _, spin = disc(20e-3, 10e-3)
    assert float(moved) == pytest.approx(ring + 3 * spin * 2.5**2, rel=5e-3)


def test_the_wedge_drive_is_twice_the_kinetic_energy_of_its_bodies(paper_joint):
    """The carrier turns with 1 rad/s: rollers on the standing ring, planets that turn against them."""
    _, moved = planar_inertias(paper_joint(density=DENSITY))
    mass, spin = disc(13.5e-3, 5e-3)
    roller_mass, roller_spin = disc(5e-3, 5e-3)
    # in the carrier's frame the surfaces of ring, roller and planet have one speed, 40 mm/s
    energy = 0.5 * (mass * 17.5e-3**2 + spin * (1.0 + 40.0 / 13.5) ** 2)
    energy += 2 * 0.5 * (roller_mass * 35e-3**2 + roller_spin * (35.0 / 5.0) ** 2)
    assert float(moved) == pytest.approx(2.0 * 3.0 * energy, rel=1e-12)
