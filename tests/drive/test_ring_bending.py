"""The thin ring against the classical coefficients of evenly spaced loads, and against an exact free annulus."""

import dataclasses

import jax.numpy as jnp
import pytest

from asperity.drive.geometry import DriveGeometry, triangle
from asperity.drive.ring_bending import thin_ring_compliance

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
#: u EI/(P R^3) under n even loads P: [(alpha + sin alpha cos alpha)/sin^2 alpha − 2/alpha]/4, alpha = pi/n
EVEN_LOADS = {2: 0.07438920, 3: 0.01593859, 4: 0.00607931, 5: 0.00297632, 6: 0.00168182, 8: 0.00069311}


def compliance(geometry=PAPER, sides=None, wall=1e-3):
    return thin_ring_compliance(
        geometry=geometry,
        sides=triangle(geometry) if sides is None else sides,
        wall_thickness=wall,
        length=5e-3,
        youngs_modulus=206e9,
    )


@pytest.mark.parametrize("count", EVEN_LOADS)
def test_two_rollers_in_one_place_are_one_load(count):
    geometry = dataclasses.replace(PAPER, planet_count=float(count))
    together = dataclasses.replace(triangle(PAPER), sin_polar=0.0, cos_polar=1.0)
    wall, radius = 1e-3, 40.5e-3
    found = compliance(geometry, together, wall)
    bending = 206e9 * 5e-3 * wall**3 / 12.0 / radius**3
    stretch = count / jnp.pi * radius / (206e9 * 5e-3 * wall)
    assert float((found.alike - stretch) * bending) == pytest.approx(2.0 * EVEN_LOADS[count], rel=1e-5)
    assert float(found.opposed) == 0.0


@pytest.mark.parametrize(
    ("wall", "free", "housed"),
    [(4e-3, 2.21915e-7, 2.20987e-9), (10e-3, 2.43827e-8, 2.71043e-9), (60e-3, 4.93787e-9, 3.81412e-9)],
)
def test_what_a_housing_takes_away_from_an_exact_annulus(wall, free, housed):
    """Six loads of half-width 91.2 um in plane strain, by Fourier series [m/N]; a wall of 60 mm is no thin ring."""
    assert float(compliance(wall=wall).alike) == pytest.approx(
        free - housed, rel=0.25 if wall > 0.05 else 0.08
    )


def test_opposed_loads_do_not_stretch_the_ring():
    one, other = compliance(wall=1e-3), compliance(wall=2e-3)
    ratio = (41.0 / 40.5) ** 3 / 8.0
    assert float(other.opposed / one.opposed) == pytest.approx(ratio, rel=1e-12)
    assert float(one.alike) > 0.0
