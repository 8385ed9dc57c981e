"""The rolling wedge drive against rigid bodies in the plane, and its creep by hand."""

import math

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import brentq, fsolve
from steel_laws import steel_laws

from asperity.drive.state.creep import creepages
from asperity.drive.state.state import STATE_TOLERANCE

MODULUS, POISSON, FRICTION, LENGTH, WALL = 206e9, 0.3, 0.12, 5e-3, 60e-3
CONTACT_MODULUS = MODULUS / (2.0 * (1.0 - POISSON**2))


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
def test_agrees_with_rigid_bodies_in_the_plane(solved, torque):
    _, found = solved("wedge", torque)
    normal, tangential, _, loss = RigidBodiesInThePlane(4e-3, 13.5e-3, 5e-3, 40e-3).solve(torque)
    np.testing.assert_allclose(found.normal, normal, rtol=1e-9)
    np.testing.assert_allclose(np.abs(found.tangential), tangential, rtol=1e-8)
    assert float(found.speed_loss) == pytest.approx(loss, rel=1e-8)
    assert float(found.residual) < STATE_TOLERANCE


def test_equal_creep_under_given_normal_forces(drives):
    # static normal forces at 5 N·m; split, series creepage and loss computed independently
    law = steel_laws(drive=drives["wedge"]).creep
    normal = jnp.array([1001.05, 657.33, 465.11, 646.77, 449.06])

    def creep(right):
        force = jnp.array([46.2963, right, 46.2963 - right, right, 46.2963 - right])
        return creepages(law=law, normal=normal, tangential=force)

    def difference(right):
        found = creep(right)
        return float(found[1] + found[3] - found[2] - found[4])

    right = brentq(difference, 20.0, 30.0, xtol=1e-9)
    assert right == pytest.approx(25.4135, abs=1e-4)
    found = creep(right)
    series = float(found[0] + found[1] + found[3])
    assert series == pytest.approx(1.47176e-3, rel=1e-5)
    assert series * 40.0 / 36.0 * 360.0 == pytest.approx(0.589, abs=1e-3)  # degrees an output turn
    at_rest = creepages(law=law, normal=normal, tangential=jnp.array([46.2963, 27.1, 19.2, 27.1, 19.2]))
    np.testing.assert_allclose(at_rest, [7.00e-4, 4.59e-4, 3.86e-4, 3.70e-4, 3.15e-4], rtol=6e-3)
