"""A roller between two contacts and a ring under six loads, by plane finite elements of our own: nine-node, mapped."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hoop_stress import hoop_stress
from pressed_pin import disc
from scipy.sparse import bmat, coo_matrix
from scipy.sparse.linalg import splu

from asperity.body.bore import bore_modes, pin_stress
from asperity.body.compliance import compliance_matrix, modes_needed
from asperity.body.conforming_pin import conforming_compliance, conforming_pressure, pressure_shares
from asperity.body.rim_range import POINTS, RimLoads, rim_stresses
from asperity.body.shapes import Annulus, Disc

E, NU = 206e9, 0.3
stresses = jax.jit(rim_stresses)
matrix = jax.jit(compliance_matrix, static_argnames=("copies", "mode_count"))


class PolarMesh:
    """Nine-node elements between circles and rays, plane strain, unit length; unknowns are Cartesian."""

    def __init__(self, radii, angles):
        self.radii, self.angles = (self._with_middles(points) for points in (radii, angles))
        nr, nt = self.radii.size, self.angles.size
        self.number = np.arange(nr * nt).reshape(nr, nt)
        r, t = np.meshgrid(self.radii, self.angles, indexing="ij")
        self.points = np.stack([r * np.cos(t), r * np.sin(t)], -1).reshape(-1, 2)
        self.stiffness = self._stiffness()

    @staticmethod
    def _with_middles(points):
        points = np.asarray(points)
        return np.sort(np.concatenate([points, 0.5 * (points[1:] + points[:-1])]))

    @staticmethod
    def _shape(x):
        return np.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2]), np.array([x - 0.5, -2 * x, x + 0.5])

    def _stiffness(self):
        nr, nt = (self.radii.size - 1) // 2, (self.angles.size - 1) // 2
        first = self.number[:-1:2, :-1:2].reshape(-1, 1, 1)
        nodes = (first + np.arange(3)[:, None] * self.angles.size + np.arange(3)).reshape(nr * nt, 9)
        lame, shear = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
        law = np.array([[lame + 2 * shear, lame, 0], [lame, lame + 2 * shear, 0], [0, 0, shear]])
        total = np.zeros((nodes.shape[0], 18, 18))
        for x, wx in zip(*np.polynomial.legendre.leggauss(3), strict=True):
            for y, wy in zip(*np.polynomial.legendre.leggauss(3), strict=True):
                (nx, dx), (ny, dy) = self._shape(x), self._shape(y)
                local = np.stack([np.outer(dx, ny).ravel(), np.outer(nx, dy).ravel()])
                jacobian = np.einsum("ak,ekc->eac", local, self.points[nodes])
                slope = np.linalg.solve(jacobian, np.broadcast_to(local, (nodes.shape[0], 2, 9)))
                strain = np.zeros((nodes.shape[0], 3, 18))
                strain[:, 0, ::2], strain[:, 1, 1::2] = slope[:, 0], slope[:, 1]
                strain[:, 2, ::2], strain[:, 2, 1::2] = slope[:, 1], slope[:, 0]
                size = wx * wy * np.abs(np.linalg.det(jacobian))
                total += size[:, None, None] * np.einsum("eai,ab,ebj->eij", strain, law, strain)
        unknowns = np.stack([2 * nodes, 2 * nodes + 1], -1).reshape(-1, 18)
        rows, columns = np.repeat(unknowns, 18, axis=1), np.tile(unknowns, 18)
        size = 2 * self.number.size
        return coo_matrix((total.ravel(), (rows.ravel(), columns.ravel())), shape=(size, size)).tocsc()

    def punch(self, ring, angle, half_width, along):
        """Forces of a unit load under a punch on a circle; along is 0 for radial, 1 for tangential."""
        load = np.zeros(2 * self.number.size)
        count = 600
        for step in range(count):
            at = angle + half_width / self.radii[ring] * math.cos((step + 0.5) * math.pi / count)
            edge = min(np.searchsorted(self.angles[::2], at, side="right") - 1, self.angles.size // 2 - 1)
            left, right = self.angles[2 * edge], self.angles[2 * edge + 2]
            weights, _ = self._shape(2 * (at - left) / (right - left) - 1)
            direction = (math.cos(at), math.sin(at)) if along == 0 else (-math.sin(at), math.cos(at))
            for node, weight in zip(self.number[ring, 2 * edge : 2 * edge + 3], weights, strict=True):
                load[2 * node : 2 * node + 2] += weight / count * np.array(direction)
        return load

    def across(self, ray, along):
        """Constraint rows: displacement along (0) or across (1) a ray is nothing."""
        angle, nodes = self.angles[ray], self.number[:, ray]
        direction = (math.cos(angle), math.sin(angle)) if along == 0 else (-math.sin(angle), math.cos(angle))
        rows = np.zeros((nodes.size, 2 * self.number.size))
        rows[np.arange(nodes.size), 2 * nodes], rows[np.arange(nodes.size), 2 * nodes + 1] = direction
        return rows

    def answers(self, loads, constraints):
        """Displacements under the loads, with constraints by multipliers."""
        rows = coo_matrix(constraints).tocsc()
        scale = E
        system = bmat([[self.stiffness / scale, rows.T], [rows, None]], format="csc")
        right = np.zeros((system.shape[0], len(loads)))
        right[: loads[0].size] = np.array(loads).T / scale
        return splu(system).solve(right)[: loads[0].size].T


def graded(start, stop, centre, finest, growth):
    """Points from start to stop, densest at the centre."""

    def side(length):
        steps = [finest]
        while sum(steps) < length:
            steps.append(min(steps[-1] * growth, 0.1 * length))
        return np.cumsum(steps) * (length / sum(steps))

    parts = [np.array([centre])]
    if centre > start:
        parts.append(centre - side(centre - start))
    if centre < stop:
        parts.append(centre + side(stop - centre))
    return np.unique(np.concatenate(parts))


def test_roller_between_two_contacts():
    """Half a roller; the finite elements have a bore of a hundredth of the radius."""
    radius, half_width = 5e-3, 0.1e-3
    mesh = PolarMesh(
        graded(0.01 * radius, radius, radius, 0.15 * half_width, 1.25),
        graded(0.0, math.pi, 0.5 * math.pi, 0.15 * half_width / radius, 1.25),
    )
    load = mesh.punch(mesh.radii.size - 1, 0.5 * math.pi, half_width, 0)
    pin = np.zeros((1, load.size))
    pin[0, 2 * mesh.number[-1, mesh.angles.size // 2]] = 1.0
    (u,) = mesh.answers([load], np.vstack([mesh.across(0, 1), mesh.across(-1, 1), pin]))
    disc = Disc(radius, 1.0, E, NU, "plane_strain")
    ours = matrix(
        body=disc,
        contact_angles=np.array([0.0, math.pi]),
        half_widths=np.full(2, half_width),
        stick_half_widths=np.full(2, half_width),
        copies=1,
        mode_count=0,
    )
    assert float(ours[0, 0] + ours[0, 1]) == pytest.approx(float(load @ u), rel=0.01, abs=0.0)


@pytest.mark.parametrize("support", [0.0, math.inf, 5e13])
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_ring_under_six_loads(support):
    """Loads at +-14 degrees about three planets: alike on both sides, and opposite, radial and tangential."""
    radius, wall, half_width, apart = 40e-3, 10e-3, 0.4e-3, math.radians(13.9248)
    mesh = PolarMesh(
        graded(radius, radius + wall, radius, 0.12 * half_width, 1.3),
        graded(0.0, math.pi / 3.0, apart, 0.12 * half_width / radius, 1.25),
    )
    nodes = mesh.number[-1]
    if support and math.isfinite(support):
        add_support(mesh, nodes, support, radius + wall)
    radial, tangential = (mesh.punch(0, apart, half_width, along) for along in (0, 1))
    held = np.zeros((0, radial.size))
    if math.isinf(support):
        held = np.zeros((2 * nodes.size, radial.size))
        held[np.arange(2 * nodes.size), np.concatenate([2 * nodes, 2 * nodes + 1])] = 1.0
    ring = Annulus(radius, radius + wall, 1.0, E, NU, support, support, "inner", "plane_strain")
    ours = np.array(
        matrix(
            body=ring,
            contact_angles=np.array([apart, -apart]),
            half_widths=np.full(2, half_width),
            stick_half_widths=np.full(2, half_width),
            copies=3,
            mode_count=modes_needed(inner_radius=radius, outer_radius=radius + wall, copies=3),
        )
    )
    for sign, along in (
        (1.0, 1),
        (-1.0, 0),
    ):  # mirror planes: no motion across; or, for opposite loads, none along
        rows = [mesh.across(0, along), mesh.across(-1, along), held]
        if held.size:
            free = ~np.isin(np.arange(mesh.radii.size), [mesh.radii.size - 1])
            rows = [rows[0][free], rows[1][free], held]
        loads = [radial, tangential]
        if sign < 0.0 and support == 0.0:  # nothing holds the ring against turning: balance on the outer rim
            even = sum(
                np.diff(mesh.angles[2 * k : 2 * k + 3 : 2])[0] * edge_shear(mesh, k)
                for k in range(mesh.angles.size // 2)
            ) / (math.pi / 3.0)
            even *= radius / (radius + wall)
            loads = [radial, tangential - even]
            rows.append(even[None])
        u = mesh.answers(loads, np.vstack(rows))
        expected = np.array(loads) @ u.T
        found = np.array(
            [
                [ours[0, 0] + sign * ours[0, 1], ours[0, 2] - sign * ours[0, 3]],
                [ours[2, 0] + sign * ours[2, 1], ours[2, 2] - sign * ours[2, 3]],
            ]
        )
        assert found == pytest.approx(expected, rel=0.01, abs=2e-3 * expected[0, 0])
        if sign > 0.0 and support == 0.0:
            check_stress(mesh, u, ring, apart)
        if sign > 0.0 and math.isinf(support):
            check_housing(mesh, u, ring, apart)


def pin_pressure(mesh, downwards, arc):
    """Forces of a pin's pressure on the lower or upper side of the bore, of which half a body bears one newton."""
    load = np.zeros(2 * mesh.number.size)
    nodes, weights = np.polynomial.legendre.leggauss(6)
    ends = mesh.angles[::2]
    half = 0.5 * np.diff(ends)[:, None]
    at = 0.5 * (ends[1:] + ends[:-1])[:, None] + half * nodes
    away = np.asarray(at + math.copysign(0.5 * math.pi, downwards))
    pressed = 2.0 * np.asarray(conforming_pressure(angle=away, arc=arc)) * half * weights
    for k in range(mesh.angles.size // 2):
        for angle, x, force in zip(at[k], nodes, pressed[k], strict=True):
            shape, _ = mesh._shape(x)
            for node, share in zip(mesh.number[0, 2 * k : 2 * k + 3], shape, strict=True):
                load[2 * node : 2 * node + 2] += force * share * np.array([math.cos(angle), math.sin(angle)])
    return load


@pytest.mark.slow
@pytest.mark.parametrize(
    ("bore", "radius", "half_angle"), [(13e-3, 20e-3, 1.48), (2e-3, 5e-3, 1.48), (13e-3, 20e-3, 0.5)]
)
def test_a_pin_in_a_bore_between_two_contacts(bore, radius, half_angle):
    """Both contacts drag a hollow planet by one newton, or press it; its pin holds it over an arc of its bore."""
    half_width, arc = 0.01 * radius, np.asarray(math.sin(0.5 * half_angle) ** 2)
    side = graded(0.0, 0.5 * math.pi, 0.0, 0.15 * half_width / radius, 1.25)
    side = np.concatenate([side[side < 0.2], np.linspace(0.2, 0.5 * math.pi, 49)])
    mesh = PolarMesh(np.linspace(bore, radius, 40), np.concatenate([-side[:0:-1], side]))
    drag, push = (mesh.punch(mesh.radii.size - 1, 0.0, half_width, along) for along in (1, 0))
    held = np.zeros((1, drag.size))
    held[0, 2 * mesh.number[-1, mesh.angles.size // 2] + 1] = 1.0
    loads = [drag + pin_pressure(mesh, 1.0, arc), push]
    motions = mesh.answers(loads, np.vstack([mesh.across(0, 1), mesh.across(-1, 1), held]))
    expected = np.array(loads) @ motions.T

    body = Annulus(bore, radius, 1.0, E, NU, 0.0, 0.0, "outer", "plane_strain")
    contacts, widths = np.array([0.0, math.pi]), np.full(2, half_width)
    rim = matrix(
        body=body,
        contact_angles=contacts,
        half_widths=widths,
        stick_half_widths=widths,
        copies=1,
        mode_count=60,
    )
    modes = bore_modes(body=body, contact_angles=contacts, push_angle=-0.5 * math.pi)
    shares = np.asarray(pressure_shares(arc=arc))
    plate = float(conforming_compliance(arc=arc)) + float(modes.wall @ shares**2)
    own = float(modes.shift + modes.scale * plate) - flattening_of_pin(half_angle)
    dragged, pushed = np.array([0.0, 0.0, 1.0, -1.0]), np.array([1.0, 1.0, 0.0, 0.0])
    force = 2.0  # of the pin, downwards
    by_pin = force * (modes.along + modes.rim @ shares)
    found = [
        [dragged @ rim @ dragged + 2.0 * by_pin @ dragged + own * force**2, by_pin @ pushed],
        [by_pin @ pushed, pushed @ rim @ pushed],
    ]
    # coarse elements are up to a hundredth too stiff under the contacts
    assert 0.5 * np.array(found) == pytest.approx(expected, rel=0.01)

    places = np.radians([-90.0, -70.0, -50.0, -30.0, 30.0, 50.0, 70.0, 90.0])
    at = [int(np.argmin(np.abs(mesh.angles - place))) for place in places]
    places = mesh.angles[at]
    away = np.asarray(places) + 0.5 * math.pi
    pin = pin_stress(body=body, force=np.asarray(force), arc=arc, away=away)
    rest = hoop_stress(
        body=body,
        contact_angles=contacts,
        radial_forces=np.zeros(2),
        tangential_forces=np.array([1.0, -1.0]),
        angle=np.asarray(places),
        mode_count=240,
    )
    for row, ours, radial in (
        (0, pin.bore_hoop + rest.other_rim, pin.bore_radial),
        (-1, pin.rim_hoop + rest.loaded_rim, 0.0 * places),
    ):
        nodes = mesh.number[row]
        x, y = motions[0][2 * nodes], motions[0][2 * nodes + 1]
        outward = x * np.cos(mesh.angles) + y * np.sin(mesh.angles)
        turned = -x * np.sin(mesh.angles) + y * np.cos(mesh.angles)
        slope = np.gradient(turned, mesh.angles, edge_order=2)
        strain = (outward + slope)[at] / mesh.radii[row]
        stress = strain * E / (1 - NU**2) + NU / (1 - NU) * np.asarray(radial)
        assert np.asarray(ours) == pytest.approx(stress, rel=0.02, abs=0.01 * np.max(np.abs(stress)))


def flattening_of_pin(half_angle):
    """What a disc of unit length gives way by under a pin's pressure over an arc, mode by mode [m/N]."""
    mode = np.arange(2, 2001)
    nodes, weights = np.polynomial.legendre.leggauss(4000)
    angle = half_angle * np.sin(0.5 * math.pi * nodes)
    weights = weights * 0.5 * math.pi * half_angle * np.cos(0.5 * math.pi * nodes)
    arc = np.asarray(math.sin(0.5 * half_angle) ** 2)
    weights = weights * np.asarray(conforming_pressure(angle=np.asarray(angle), arc=arc))
    kolosov, modulus = 3.0 - 4.0 * NU, E / (2.0 * (1.0 + NU))
    shares = np.cos(np.outer(mode, angle)) @ weights
    even = 0.25 * (kolosov - 1.0) * (np.sum(weights) ** 2 + 1.0)
    return (even + np.sum(disc(mode, kolosov) * shares**2)) / (2.0 * math.pi * modulus)


def edge_shear(mesh, k):
    """Forces of a unit uniform shear over edge k of the outer rim."""
    load = np.zeros(2 * mesh.number.size)
    for node, weight, place in zip(
        mesh.number[-1, 2 * k : 2 * k + 3], (1, 4, 1), range(2 * k, 2 * k + 3), strict=True
    ):
        at = mesh.angles[place]
        load[2 * node : 2 * node + 2] += weight / 6.0 * np.array([-math.sin(at), math.cos(at)])
    return load


def add_support(mesh, nodes, stiffness, radius):
    """Springs in both directions along the outer rim."""
    entries = []
    for k in range(mesh.angles.size // 2):
        length = radius * (mesh.angles[2 * k + 2] - mesh.angles[2 * k])
        mass = length / 30.0 * np.array([[4.0, 2.0, -1.0], [2.0, 16.0, 2.0], [-1.0, 2.0, 4.0]])
        for i in range(3):
            for j in range(3):
                for c in range(2):
                    entries.append(
                        (2 * nodes[2 * k + i] + c, 2 * nodes[2 * k + j] + c, stiffness * mass[i, j])
                    )
    rows, columns, values = zip(*entries, strict=True)
    mesh.stiffness = (
        mesh.stiffness + coo_matrix((values, (rows, columns)), shape=mesh.stiffness.shape).tocsc()
    )


def check_stress(mesh, motions, ring, apart):
    """Hoop strain along both rims from the nodes gives the hoop stress there, away from the contact."""
    angles = np.array([0.0, math.pi / 3.0, apart])
    planets = (0, 2 * math.pi / 3, 4 * math.pi / 3)
    contacts = np.array([planet + s * apart for planet in planets for s in (1, -1)])
    forces = ((np.ones(6), np.zeros(6)), (np.zeros(6), np.array([1.0, -1.0] * 3)))
    for u, (pushes, drags) in zip(motions, forces, strict=True):
        stress = hoop_stress(
            body=ring,
            contact_angles=contacts,
            radial_forces=pushes,
            tangential_forces=drags,
            angle=np.asarray(angles),
            mode_count=240,
        )
        for row, ours, places in ((0, stress.loaded_rim, (0, 1)), (-1, stress.other_rim, (0, 1, 2))):
            nodes = mesh.number[row]
            x, y = u[2 * nodes], u[2 * nodes + 1]
            radial = x * np.cos(mesh.angles) + y * np.sin(mesh.angles)
            tangential = -x * np.sin(mesh.angles) + y * np.cos(mesh.angles)
            for place in places:
                at = int(np.argmin(np.abs(mesh.angles - angles[place])))
                near = np.argsort(np.abs(mesh.angles - mesh.angles[at]))[:5]
                away = (mesh.angles[near] - mesh.angles[at]) / 0.1
                powers = (1, 3) if place < 2 else (0, 1, 2)  # odd in the mirror planes
                basis = np.stack([away**k for k in powers], 1)
                slope = np.linalg.lstsq(basis, tangential[near], rcond=None)[0][powers.index(1)] / 0.1
                expected = (radial[at] + slope) / mesh.radii[row] * E / (1 - NU**2)
                assert float(ours[place]) == pytest.approx(expected, rel=0.01, abs=0.5)


def check_housing(mesh, motions, ring, apart):
    """Tractions of a held outer rim: their first Fourier coefficients from the reactions of the nodes."""
    nodes, outer = mesh.number[-1], mesh.radii[-1]
    angle = np.arange(POINTS) / POINTS * 2.0 * math.pi / 3.0
    forces = ((np.ones(2), np.zeros(2)), (np.zeros(2), np.array([-1.0, 1.0])))
    for u, (pushes, drags) in zip(motions, forces, strict=True):
        reaction = mesh.stiffness @ u
        x, y = reaction[2 * nodes], reaction[2 * nodes + 1]
        radial = x * np.cos(mesh.angles) + y * np.sin(mesh.angles)
        tangential = -x * np.sin(mesh.angles) + y * np.cos(mesh.angles)
        loads = RimLoads(np.array([-apart, apart]), pushes, drags, np.full(2, 1e-5), 3.0)
        ours = stresses(body=ring, loads=loads)
        step = math.pi / 3.0 / POINTS * outer  # half a sector, as that of the elements
        for mode in (0, 3, 6, 12):
            expected = radial @ np.cos(mode * mesh.angles)
            found = float(step * ours.other_radial[:POINTS] @ jnp.cos(mode * angle))
            assert found == pytest.approx(expected, rel=0.01, abs=2e-3)
            expected = tangential @ np.sin(mode * mesh.angles)
            found = float(step * ours.other_shear[:POINTS] @ jnp.sin(mode * angle))
            assert found == pytest.approx(expected, rel=0.01, abs=2e-3)
