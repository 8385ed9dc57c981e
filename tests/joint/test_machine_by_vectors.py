"""Every body of the paper's machine in equilibrium, by positions and forces as vectors."""

import math

import jax
import numpy as np
import pytest

from asperity.joint.working_loads import working_loads

SIZE = 64


def turned(vector, angle):
    x, y = vector
    return np.array([x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle)])


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


@pytest.fixture(scope="module")
def machines(paper_joint, evaluated_together):
    """Joints of random sizes, push angles, bearings and torques of both senses, their results and loads."""
    random = np.random.default_rng(3)

    def between(low, high):
        return random.uniform(low, high, SIZE)

    numbers = {
        "sun_radius": between(3.8e-3, 4.3e-3),
        "planet_radius": between(13.2e-3, 13.8e-3),
        "loading_roller_radius": between(4.9e-3, 5.2e-3),
        "left_push_angle": between(-0.3, 0.3),
        "right_push_angle": between(-0.3, 0.3),
        "output_torque": between(-4.0, 4.0),
        "preload": between(700.0, 2000.0),
        "sun_speed": between(10.0, 1000.0),
        "sun_torque": between(0.0, 2e-3),
        "loading_roller_torque": between(0.0, 1e-3),
        "carrier_torque": between(0.0, 1e-2),
        "pin_friction_coefficient": between(0.0, 3e-3),
        "pin_diameter": between(3e-3, 5e-3),
    }
    joint = paper_joint(body_model="springs", ring_wall_thickness=60e-3, traction_split="springs", **numbers)
    result = evaluated_together(joint)
    assert np.all(result.solved)
    by_joint = jax.tree.map(lambda leaf: np.moveaxis(leaf, -1, 0), result)
    loads = jax.jit(jax.vmap(working_loads, out_axes=-1))(joint, by_joint)
    return numbers, result, loads


@pytest.mark.slow
@pytest.mark.parametrize("rolls", [False, True])
def test_every_body_of_the_machine_is_in_equilibrium(machines, rolls):
    """Nothing of equations (1) to (5) is used; the sun turns clockwise, against the angles."""
    x, result, loads = machines
    state = result.rolling if rolls else result.forces
    normal, tangential = np.asarray(state.normal), np.asarray(state.tangential)
    scale = normal.max(axis=0)
    rs, rp, rw, ro = x["sun_radius"], x["planet_radius"], x["loading_roller_radius"], 40e-3
    op, pw, ow = rs + rp, rp + rw, ro - rw
    alpha = np.arccos((op**2 + ow**2 - pw**2) / (2.0 * op * ow))  # the cosine theorem
    zero = np.zeros(SIZE)
    up, across = np.array([zero, zero + 1.0]), np.array([zero + 1.0, zero])
    planet = op * up
    speed = x["sun_speed"] * rs / (ro - rs)
    bore = 0.5 * x["pin_diameter"]  # each loading roller sits on a pin of its own
    area = {"planet": math.pi * rp**2, "roller": math.pi * (rw**2 - bore**2)}
    mass = {name: 7850.0 * each * 5e-3 for name, each in area.items()}
    on_planet = normal[0] * up + tangential[0] * across + up * mass["planet"] * speed**2 * op
    planet_moment = cross(rs * up - planet, tangential[0] * across)
    on_sun = -normal[0] * up - tangential[0] * across
    forces, moments = np.zeros((3, 2, SIZE)), np.zeros((3, SIZE))  # on sun, ring and carrier
    for index, hand in enumerate((1.0, -1.0)):
        centre = ow * np.array([hand * np.sin(alpha), np.cos(alpha)])
        away, outward = (centre - planet) / pw, centre / ow
        pushed = normal[1 + index] * away + tangential[1 + index] * np.array([-away[1], away[0]])
        on_planet = on_planet - pushed
        planet_moment = planet_moment + cross(rp * away, -pushed)
        on_ring = normal[3 + index] * outward + tangential[3 + index] * np.array([outward[1], -outward[0]])
        fling = mass["roller"] * speed**2 * ow * outward
        on_pin = pushed - on_ring + fling
        # a pin takes up what acts along its push, and nothing else does
        push = x["right_push_angle" if hand > 0.0 else "left_push_angle"]
        counter = np.array([-outward[1], outward[0]])
        along = hand * np.cos(push) * counter + np.sin(push) * outward
        size = np.sum(on_pin * along, axis=0)
        assert np.abs(cross(on_pin, along) / scale).max() < 1e-8
        friction = 2.0 * (
            x["loading_roller_torque"]
            + 0.25 * x["pin_friction_coefficient"] * x["pin_diameter"] * np.abs(size)
        )
        turning = cross(-rw * away, pushed) + cross(rw * outward, -on_ring)
        assert np.abs((turning + friction) / (scale * rw)).max() < 1e-8
        if rolls:
            assert np.asarray(np.abs(loads.pin[index])) == pytest.approx(np.abs(size), rel=1e-6, abs=1e-4)
        for angle in 2.0 * math.pi * np.arange(3) / 3.0:
            forces[1] += turned(on_ring, angle)
            moments[1] += cross(turned(ro * outward, angle), turned(on_ring, angle))
            forces[2] += turned(on_pin, angle)
            moments[2] += cross(turned(centre, angle), turned(on_pin, angle))
            moments[2] -= friction  # the bearings of a roller act on the carrier too
    for angle in 2.0 * math.pi * np.arange(3) / 3.0:
        forces[0] += turned(on_sun, angle)
        moments[0] += cross(turned(rs * up, angle), turned(on_sun, angle))
    assert np.abs(on_planet / scale).max() < 1e-8
    assert np.abs(planet_moment / (scale * rp)).max() < 1e-8
    assert np.abs(forces / scale).max() < 1e-8
    given = moments[2] - x["output_torque"] - 2.0 * x["carrier_torque"]
    assert np.abs(given / (scale * ro)).max() < 1e-8
    if not rolls:
        entered = moments[0] + 2.0 * x["sun_torque"]
        np.testing.assert_allclose(result.forces.input_torque, entered, rtol=1e-7, atol=1e-9)
