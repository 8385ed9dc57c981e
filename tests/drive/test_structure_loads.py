"""Loads of the structure: every body of the machine in equilibrium by vectors, and beams by statics."""

import math

import numpy as np
import pytest

from asperity.drive.geometry import triangle
from asperity.drive.mechanism import opposed
from asperity.drive.structure_loads import (
    magnitude,
    pin_bending_moment,
    pin_bending_stress,
    structure_loads,
)
from asperity.joint.description import sense_of_rotation
from asperity.joint.evaluation import mechanism

SIZE = 256


@pytest.fixture(scope="module")
def machines(paper_joint, solved_forces):
    """Joints of random sizes, push angles, bearings and torques of both senses, their forces and loads."""
    random = np.random.default_rng(3)

    def between(low, high):
        return random.uniform(low, high, SIZE)

    joint = paper_joint(
        sun_radius=between(3.8e-3, 4.3e-3),
        planet_radius=between(13.2e-3, 13.8e-3),
        loading_roller_radius=between(4.9e-3, 5.2e-3),
        left_push_angle=between(-0.3, 0.3),
        right_push_angle=between(-0.3, 0.3),
        output_torque=between(-4.0, 4.0),
        preload=between(700.0, 2000.0),
        sun_speed=between(0.0, 1000.0),
        sun_torque=between(0.0, 2e-3),
        loading_roller_torque=between(0.0, 1e-3),
        carrier_torque=between(0.0, 1e-2),
        pin_friction_coefficient=between(0.0, 3e-3),
        pin_diameter=between(3e-3, 5e-3),
    )
    forces = solved_forces(joint)
    assert np.all(np.asarray(forces.balance_residual) < 1e-9)
    bearings = opposed(bearings=joint.bearings, sense_of_rotation=sense_of_rotation(joint))
    loads = structure_loads(
        geometry=joint.geometry,
        sides=triangle(joint.geometry),
        bearings=bearings,
        normal=forces.normal,
        tangential=forces.tangential,
    )
    return joint, forces, loads, bearings


def turned(vector, angle):
    x, y = vector
    return np.array([x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle)])


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


@pytest.mark.slow
def test_every_body_of_the_machine_is_in_equilibrium(machines):
    """Positions and forces of all contacts of all branches as vectors; nothing of equations (1) to (5) is used."""
    joint, forces, loads, bearings = machines
    g = {name: np.asarray(value) for name, value in vars(joint.geometry).items()}
    rs, rp, rw, ro = (g[f"{name}_radius"] for name in ("sun", "planet", "loading_roller", "ring"))
    normal, tangential = np.asarray(forces.normal), np.asarray(forces.tangential)
    scale = normal.max(axis=0)
    # centres by the cosine theorem
    op, pw, ow = rs + rp, rp + rw, ro - rw
    alpha = np.arccos((op**2 + ow**2 - pw**2) / (2.0 * op * ow))
    zero = np.zeros(SIZE)
    planet = np.array([zero, op])
    up = np.array([zero, zero + 1.0])
    angular, sun_force, ring_force, carrier_force = carrier_speed(g, joint), 0.0, 0.0, 0.0
    sun_moment, ring_moment, carrier_moment = 0.0, 0.0, 0.0
    masses = mechanism(joint)
    on_planet = normal[0] * up + tangential[0] * np.array([zero + 1.0, zero])
    on_planet = on_planet + up * masses.planet_mass * angular**2 * op
    planet_moment = cross(rs * up - planet, tangential[0] * np.array([zero + 1.0, zero]))
    on_sun = -normal[0] * up - tangential[0] * np.array([zero + 1.0, zero])
    for index, hand in enumerate((1.0, -1.0)):
        centre = ow * np.array([hand * np.sin(alpha), np.cos(alpha)])
        away = (centre - planet) / pw  # planet to roller
        outward = centre / ow
        pushed = normal[1 + index] * away + tangential[1 + index] * np.array([-away[1], away[0]])
        on_planet = on_planet - pushed
        planet_moment = planet_moment + cross(rp * away, -pushed)
        on_ring = normal[3 + index] * outward + tangential[3 + index] * np.array([outward[1], -outward[0]])
        counter = np.array([-outward[1], outward[0]])  # the sense in which the carrier is driven
        on_pin = (
            np.asarray(loads.pin_radial)[index] * outward + np.asarray(loads.pin_tangential)[index] * counter
        )
        fling = masses.loading_roller_mass * angular**2 * ow * outward
        residual = pushed - on_ring - on_pin + fling
        assert np.abs(residual / scale).max() < 1e-9
        friction = 2.0 * np.asarray((forces.right_bearing_torque, forces.left_bearing_torque)[index])
        turning = cross(-rw * away, pushed) + cross(rw * outward, -on_ring)
        assert np.abs((turning + friction) / (scale * rw)).max() < 1e-9
        for branch in range(3):
            angle = 2.0 * math.pi * branch / 3.0
            ring_force = ring_force + turned(on_ring, angle)
            ring_moment = ring_moment + cross(turned(ro * outward, angle), turned(on_ring, angle))
            carrier_force = carrier_force + turned(on_pin, angle)
            carrier_moment = carrier_moment + cross(turned(centre, angle), turned(on_pin, angle))
    for branch in range(3):
        angle = 2.0 * math.pi * branch / 3.0
        sun_force = sun_force + turned(on_sun, angle)
        sun_moment = sun_moment + cross(turned(rs * up, angle), turned(on_sun, angle))
    assert np.abs(on_planet / scale).max() < 1e-9
    assert np.abs(planet_moment / (scale * rp)).max() < 1e-9
    for force in (sun_force, ring_force, carrier_force):
        assert np.abs(force / scale).max() < 1e-9
    # the sun is driven clockwise, its bearings brake; ring and carrier take what the rollers give them
    moments = (
        -np.asarray(loads.sun_torque) + sun_moment + 2.0 * np.asarray(bearings.sun_torque),
        np.asarray(loads.carrier_torque) - carrier_moment,
        np.asarray(loads.housing_torque) + ring_moment,
        carrier_moment - np.asarray(joint.output_torque) - 2.0 * np.asarray(bearings.carrier_torque),
    )
    for moment in moments:
        assert np.abs(moment / (scale * ro)).max() < 1e-9
    assert np.asarray(loads.sun_torque) == pytest.approx(np.asarray(forces.input_torque), rel=1e-12)


def carrier_speed(g, joint):
    return np.asarray(joint.sun_speed) * g["sun_radius"] / (g["ring_radius"] - g["sun_radius"])


def test_pins_carry_the_published_pin_forces(machines):
    _, forces, loads, _ = machines
    resultant = np.asarray(loads.pin_resultant)
    assert resultant[0] == pytest.approx(np.abs(np.asarray(forces.pin_right)), rel=1e-9)
    assert resultant[1] == pytest.approx(np.abs(np.asarray(forces.pin_left)), rel=1e-9)


def test_pin_as_a_beam():
    """The moment by summing the load over the beam; a load over the whole span makes F l/8, a point load F l/4."""
    force, length, roller, diameter = 120.0, 9e-3, 5e-3, 4e-3
    at = (np.arange(10000) + 0.5) / 10000 * roller + 0.5 * (length - roller)
    share = force / at.size
    middle = 0.5 * length
    both = 0.5 * force * middle - np.sum(share * (middle - at)[at < middle])
    beam = {"force": force, "free_length": length, "roller_length": roller}
    assert float(pin_bending_moment(**beam, support="both_ends")) == pytest.approx(both, rel=1e-6)
    assert float(pin_bending_moment(**beam, support="one_end")) == pytest.approx(np.sum(share * at), rel=1e-9)
    whole = {"force": 8.0, "free_length": 1.0, "support": "both_ends"}
    assert float(pin_bending_moment(roller_length=1.0, **whole)) == pytest.approx(1.0)
    assert float(pin_bending_moment(roller_length=0.0, **whole)) == pytest.approx(2.0)
    # by the second moment of area of a circle
    stress = both / (math.pi * (0.5 * diameter) ** 4 / 4.0) * 0.5 * diameter
    assert float(pin_bending_stress(moment=both, diameter=diameter)) == pytest.approx(stress, rel=1e-12)
    assert math.isnan(float(pin_bending_stress(moment=both, diameter=0.0)))


def test_magnitude_has_finite_slopes_at_zero():
    import jax

    assert float(magnitude(3.0, -4.0)) == 5.0
    assert math.isnan(float(magnitude(math.nan, 0.0)))
    assert float(jax.grad(lambda x: magnitude(x, 0.0))(0.0)) == 0.0
