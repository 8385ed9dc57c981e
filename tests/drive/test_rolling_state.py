"""The rolling drive against rigid bodies in the plane and published numbers; energy, symmetry and gradients."""

import math

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import brentq, fsolve

from asperity.contact.hertz_line import effective_radius
from asperity.drive.equilibrium import balance_equations
from asperity.drive.force_balance import force_balance, loaded_branch
from asperity.drive.geometry import contact_radii
from asperity.drive.rolling_state import (
    ROLLING_TOLERANCE,
    CreepLaw,
    creepages,
    rolling_state,
    speed_loss,
)
from asperity.joint.description import with_one_rank
from asperity.joint.evaluation import mechanism

MODULUS, POISSON, FRICTION, LENGTH, WALL = 206e9, 0.3, 0.12, 5e-3, 60e-3
CONTACT_MODULUS = MODULUS / (2.0 * (1.0 - POISSON**2))


@pytest.fixture(scope="module")
def rolled(paper_joint):
    """The paper's joint under a torque, smooth bodies alone, sun at rest unless said otherwise."""

    @eqx.filter_jit
    def compiled(joint):
        joint = with_one_rank(joint)
        drive = mechanism(joint)
        standing = force_balance(mechanism=drive, output_torque=joint.output_torque)
        return drive, rolling_state(mechanism=drive, standing=standing, law=law(drive))

    def state(torque, *, sun_speed=0.0, **changes):
        joint = paper_joint(sun_speed=sun_speed, output_torque=torque, ring_wall_thickness=WALL, **changes)
        return compiled(jax.tree.map(jnp.asarray, joint))

    return state


def law(drive):
    driving, driven, sign = contact_radii(drive.geometry)
    radius = effective_radius(radius_1=driving, radius_2=driven, sign=sign)
    per_root_newton = jnp.sqrt(4.0 * radius / (math.pi * LENGTH * CONTACT_MODULUS))
    friction = jnp.full((1,) * radius.ndim, FRICTION)
    return CreepLaw(friction, FRICTION * per_root_newton / radius)


class RigidBodiesInThePlane:
    """Planet and rollers as rigid bodies with two displacements and an angular velocity each, contacts from Hertz,
    Johnson, Weber–Banaschek and Carter, in NumPy and SciPy; shares no code with the package."""

    def __init__(self, sun, planet, roller, ring):
        orbit, pair, far = sun + planet, planet + roller, ring - roller
        polar = math.acos((orbit**2 + far**2 - pair**2) / (2.0 * orbit * far))
        at = {
            "s": np.zeros(2),
            "o": np.zeros(2),
            "p": np.array([0.0, orbit]),
            "r": far * np.array([math.sin(polar), math.cos(polar)]),
            "l": far * np.array([-math.sin(polar), math.cos(polar)]),
        }
        self.contacts = [
            ("s", "p", sun, planet, 1.0),
            ("p", "r", planet, roller, 1.0),
            ("p", "l", planet, roller, 1.0),
            ("r", "o", roller, ring, -1.0),
            ("l", "o", roller, ring, -1.0),
        ]
        self.ratio = sun / (ring - sun)
        self.place = {"p": 0, "r": 2, "l": 4}
        self.approach = np.zeros((5, 6))
        self.sliding = np.zeros((5, 6))
        self.radius = np.array([a * b / abs(a + sign * b) for *_, a, b, sign in self.contacts])
        for k, (one, two, *_, sign) in enumerate(self.contacts):
            normal = sign * (at[two] - at[one])
            normal /= np.linalg.norm(normal)
            tangent = np.array([-normal[1], normal[0]])
            for body, hand in ((one, 1.0), (two, -1.0)):
                if body in self.place:
                    columns = slice(self.place[body], self.place[body] + 2)
                    self.approach[k, columns] += hand * normal
                    self.sliding[k, columns] += hand * tangent
        self.pins, self.levers = np.zeros((2, 6)), []
        for j, body in enumerate("rl"):
            tangent = np.array([at[body][1], -at[body][0]]) / far
            self.pins[j, self.place[body] : self.place[body] + 2] = tangent
            self.levers.append(at[body][0] * tangent[1] - at[body][1] * tangent[0])
        theta = math.atan2(at["r"][0], at["r"][1] - orbit)
        side = 500.0 / math.cos(theta)
        ring_force = side * math.cos(theta - polar)
        self.rest = np.array([1000.0, side, side, ring_force, ring_force])
        self.interference = self.rest @ self.compression(self.rest) / (2.0 * ring_force)

    def compression(self, normal):
        found = []
        for k, (*_, a, b, sign) in enumerate(self.contacts):
            width = math.sqrt(4.0 * normal[k] * self.radius[k] / (math.pi * LENGTH * CONTACT_MODULUS))
            per_log = normal[k] / LENGTH * (1.0 - POISSON**2) / (math.pi * MODULUS)
            both = 2.0 * math.log(4.0 * a / width) - 1.0
            both += (
                2.0 * math.log(4.0 * b / width) - 1.0
                if sign > 0.0
                else 2.0 * (math.log(2.0 * WALL / width) - POISSON / (2.0 * (1.0 - POISSON)))
            )
            found.append(per_log * both)
        return np.array(found)

    def solve(self, torque):
        scale = np.r_[np.full(5, 1e3), np.full(5, 1e2), 1e2, 1e2, np.full(6, 1e-6), np.ones(4)]

        def speeds(turn):
            omega = {"s": -1.0, "o": 0.0, "p": turn[0], "r": turn[1], "l": turn[2]}
            first = np.array([a * (omega[one] - turn[3]) for one, _, a, _, _ in self.contacts])
            second = np.array([s * b * (omega[two] - turn[3]) for _, two, _, b, s in self.contacts])
            return first, second

        def equations(scaled):
            normal, tangential, pin, moved, turn = np.split(scaled * scale, [5, 10, 12, 18])
            first, second = speeds(turn)
            q = np.minimum(np.abs(tangential) / (FRICTION * normal), 0.99)
            width = np.sqrt(4.0 * normal * self.radius / (math.pi * LENGTH * CONTACT_MODULUS))
            creep = np.sign(tangential) * FRICTION * width / self.radius * (1.0 - np.sqrt(1.0 - q))
            gap = self.approach @ moved
            gap[3:] += self.interference
            force = -(self.approach.T @ normal) - self.sliding.T @ tangential - self.pins.T @ pin
            moment = [
                -sum(
                    (a * (one == body) + sign * b * (two == body)) * t
                    for (one, two, a, b, sign), t in zip(self.contacts, tangential, strict=True)
                )
                for body in "prl"
            ]
            return np.r_[
                (self.compression(normal) - gap) * 1e6,
                (creep - (first + second) / (0.5 * np.abs(first - second))) * 1e3,
                force / 100.0,
                moment,
                3.0 * pin @ np.array(self.levers) - torque,
                self.pins @ moved * 1e6,
            ]

        carrier = self.ratio
        planet = carrier + (1.0 + carrier) * self.contacts[0][2] / self.contacts[0][3]
        roller = carrier - (planet - carrier) * self.contacts[1][2] / self.contacts[1][3]
        guess = np.r_[self.rest, torque * np.array([-9.2, 4.6, 4.6, -4.6, -4.6]), 100.0, -140.0]
        guess = np.r_[guess, np.zeros(6), planet, roller, roller, carrier] / scale
        found, _, _, message = fsolve(equations, guess, full_output=True, xtol=1e-14)
        assert np.max(np.abs(equations(found))) < 1e-9, message
        values = found * scale
        return values[:5], np.abs(values[5:10]), values[12], 1.0 - values[-1] / carrier


@pytest.mark.slow
@pytest.mark.parametrize("torque", [0.5, 5.0, 10.0])
def test_agrees_with_rigid_bodies_in_the_plane(rolled, torque):
    _, found = rolled(torque)
    normal, tangential, _, loss = RigidBodiesInThePlane(4e-3, 13.5e-3, 5e-3, 40e-3).solve(torque)
    np.testing.assert_allclose(found.normal, normal, rtol=1e-9)
    np.testing.assert_allclose(found.tangential, tangential, rtol=1e-8)
    assert float(found.speed_loss) == pytest.approx(loss, rel=1e-8)
    assert float(found.residual) < ROLLING_TOLERANCE


@pytest.mark.slow
@pytest.mark.parametrize(
    ("torque", "normal", "tangential", "loss"),
    [
        (5.0, [1001.74, 657.80, 464.95, 646.33, 447.98], [46.2963, 25.4224, 20.8739], 1.633763e-3),
        (10.0, [1007.78, 753.13, 367.42, 746.43, 349.72], [92.5926, 57.3155, 35.2771], 3.905719e-3),
    ],
)
def test_independent_solution_with_displaced_contacts(rolled, torque, normal, tangential, loss):
    # computed with the directions of the contacts following the displacements (2.6 and 5.1 micrometres sideways),
    # which turns a force of 1000 N by 0.15 N for each micrometre and millimetre: up to 0.2 % of the smallest force
    _, found = rolled(torque)
    np.testing.assert_allclose(found.normal, normal, rtol=2.5e-3)
    np.testing.assert_allclose(found.normal, normal, atol=0.8)
    np.testing.assert_allclose(found.tangential[:3], tangential, rtol=1.5e-3)
    assert float(found.speed_loss) == pytest.approx(loss, rel=3e-4)


def test_equal_creep_under_given_normal_forces(rolled):
    # static normal forces at 5 N·m; split, series creepage and loss computed independently
    drive, _ = rolled(5.0)
    normal = jnp.array([1001.05, 657.33, 465.11, 646.77, 449.06])

    def creep(right):
        force = jnp.array([46.2963, right, 46.2963 - right, right, 46.2963 - right])
        return creepages(law=law(drive), normal=normal, tangential=force)

    def difference(right):
        found = creep(right)
        return float(found[1] + found[3] - found[2] - found[4])

    right = brentq(difference, 20.0, 30.0, xtol=1e-9)
    assert right == pytest.approx(25.4135, abs=1e-4)
    found = creep(right)
    series = float(found[0] + found[1] + found[3])
    assert series == pytest.approx(1.47176e-3, rel=1e-5)
    first_order = series * 40.0 / 36.0
    assert first_order == pytest.approx(1.63529e-3, rel=1e-5)
    exact = float(speed_loss(geometry=drive.geometry, creepage=found))
    assert exact == pytest.approx(first_order, rel=2.0 * series)
    assert exact * 360.0 == pytest.approx(0.589, abs=1e-3)  # degrees an output turn
    at_rest = creepages(
        law=law(drive), normal=normal, tangential=jnp.array([46.2963, 27.1, 19.2, 27.1, 19.2])
    )
    np.testing.assert_allclose(at_rest, [7.00e-4, 4.59e-4, 3.86e-4, 3.70e-4, 3.15e-4], rtol=6e-3)


@pytest.mark.parametrize("closure", ["elastic", "constant_pin_force"])
def test_every_published_equation_holds(rolled, closure):
    drive, found = rolled(
        4.0,
        sun_speed=600.0,
        closure=closure,
        sun_torque=0.01,
        loading_roller_torque=0.003,
        carrier_torque=0.02,
    )
    branch = loaded_branch(mechanism=drive, output_torque=4.0)
    torque = 2.0 * drive.bearings.sun_torque + 3.0 * drive.geometry.sun_radius * found.tangential[0]
    equations = balance_equations(
        geometry=drive.geometry,
        sides=drive.sides,
        bearings=drive.bearings,
        normal=tuple(found.normal),
        tangential=tuple(found.tangential),
        pin_left=found.pin_left,
        pin_right=found.pin_right,
        left_bearing_torque=found.left_bearing_torque,
        right_bearing_torque=found.right_bearing_torque,
        input_torque=torque,
        output_torque=4.0,
        planet_centrifugal=branch.planet_centrifugal,
        roller_centrifugal=branch.roller_centrifugal,
    )
    assert np.max(np.abs(np.asarray(equations))) < 1e-9 * np.max(found.normal)


@pytest.mark.parametrize("torque", [0.7, 5.0, -3.0])
def test_creep_power_is_what_is_lost(rolled, torque):
    drive, found = rolled(torque)
    geometry = drive.geometry
    sun_speed = 1.0
    carrier = sun_speed * geometry.sun_radius / (geometry.ring_radius - geometry.sun_radius)
    carrier = carrier * (1.0 - found.speed_loss)
    first = geometry.sun_radius * (sun_speed + carrier)  # surface of the sun, seen from the carrier
    power = 0.0
    surface = {"sun": first}
    for k, (driving, driven) in enumerate(
        [("sun", "planet"), ("planet", "right"), ("planet", "left"), ("right", "ring"), ("left", "ring")]
    ):
        creep = float(found.creepage[k])
        slower = surface[driving] * (1.0 - 0.5 * creep) / (1.0 + 0.5 * creep)
        surface[driven] = surface.get(driven, slower)
        power += 3.0 * float(found.tangential[k]) * float(surface[driving] - slower)
    assert float(surface["ring"]) == pytest.approx(float(geometry.ring_radius * carrier), rel=1e-12)
    power_in = 3.0 * float(found.tangential[0] * geometry.sun_radius) * sun_speed
    power_out = torque * float(carrier)
    assert power_in - power_out == pytest.approx(power, rel=1e-9)
    assert power / power_in == pytest.approx(float(found.speed_loss), rel=1e-9)


def test_the_other_direction_is_the_mirror_image(rolled):
    _, one = rolled(5.0)
    _, other = rolled(-5.0)
    mirror = np.array([0, 2, 1, 4, 3])
    np.testing.assert_allclose(other.normal, one.normal[mirror], rtol=1e-12)
    np.testing.assert_allclose(other.creepage, -one.creepage[mirror], rtol=1e-12)
    # odd to first order in the creepage
    assert float(other.speed_loss) == pytest.approx(-float(one.speed_loss), rel=2.0 * float(one.speed_loss))


@pytest.mark.slow
def test_gradients_are_finite_and_right(rolled):
    def loss(torque):
        return rolled(torque)[1].speed_loss

    for torque in (5.0, -2.0):
        expected = (loss(torque + 1e-3) - loss(torque - 1e-3)) / 2e-3
        assert float(jax.grad(loss)(torque)) == pytest.approx(float(expected), rel=1e-6)
    assert float(jax.grad(loss)(0.0)) == pytest.approx(float(loss(1e-4) / 1e-4), rel=1e-4)


@pytest.mark.slow
def test_batch_is_its_members(rolled):
    torques = jnp.array([0.0, 1.0, 5.0, -8.0])
    _, many = rolled(torques)
    for i, torque in enumerate(torques):
        _, one = rolled(torque)
        np.testing.assert_allclose(many.normal[:, i], one.normal, rtol=1e-12)
        np.testing.assert_allclose(many.speed_loss[i], one.speed_loss, rtol=1e-10, atol=1e-18)


def test_a_contact_that_slips_as_a_whole_has_no_rolling_state(rolled):
    _, found = rolled(30.0)
    assert np.all(np.isnan(found.creepage))
    assert np.isnan(found.residual)
