"""Inertias by quadrature and by the kinetic energy of every body."""

import jax
import numpy as np
import pytest

from asperity.drive.structure.inertia import mass_matrix, roller_inertia


def test_a_hollow_roller_by_quadrature():
    radius, bore, mass = 5e-3, 6e-3, 0.02
    r = np.linspace(bore / 2, radius, 20_001)
    by_quadrature = mass * np.trapezoid(r**3, r) / np.trapezoid(r, r)
    assert float(roller_inertia(mass=mass, radius=radius, bore_diameter=bore)) == pytest.approx(
        by_quadrature, rel=1e-8
    )


def test_masses_by_the_speeds_of_all_bodies(planar_joint):
    """A planet whose centre moves by u while the carrier turns by psi: the vector sum of both."""
    drive = jax.tree.map(np.asarray, planar_joint("planetary").drive)
    masses, spins = np.array([0.03, 0.1, 0.2]), np.array([1e-6, 2e-5, 6e-4])
    matrix = mass_matrix(drive=drive, masses=masses, spins=spins)
    moved = np.random.default_rng(1).normal(size=len(matrix))
    u, turned = moved[:2], moved[2:]
    x, y = drive.centres[1]
    planet = 0.1 * ((u[0] - y * turned[-1]) ** 2 + (u[1] + x * turned[-1]) ** 2)
    energy = 3.0 * (planet + 2e-5 * turned[1] ** 2) + 1e-6 * turned[0] ** 2 + 6e-4 * turned[2] ** 2
    assert moved @ matrix @ moved == pytest.approx(energy, rel=1e-12)
