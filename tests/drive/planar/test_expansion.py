"""What strains add to the interference of planar drives: by hand, by exact geometry, and by the paper's drive."""

import dataclasses
import math

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.geometry import DriveGeometry, triangle
from asperity.drive.mechanism import rest_state
from asperity.drive.planar.drives import wedge_drive
from asperity.drive.planar.equal_springs import rest_forces
from asperity.drive.planar.expansion import interference_of_strains, ring_interference
from asperity.drive.thermal_expansion import interference_of_expansion


def added(drive, carrier, **strains):
    """Interference of each contact, and of the drive, for strains of its bodies by name."""
    of = {body.name: strains.get(body.name, 0.0) for body in drive.bodies}
    pairs = tuple(jnp.array([of[getattr(c, side)] for c in drive.contacts]) for side in ("first", "second"))
    each = interference_of_strains(drive=drive, strains=pairs, carrier=jnp.asarray(carrier))
    inside = jnp.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
    forces = rest_forces(drive=drive, pattern=inside)
    return np.asarray(each), float(ring_interference(drive=drive, forces=forces, interference=each))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["wedge", "planetary", "multiroller", "stepped"])
def test_one_strain_throughout_changes_nothing(drives, name):
    drive = drives[name]
    each, whole = added(drive, 1e-3, **{body.name: 1e-3 for body in drive.bodies})
    assert np.all(each == 0.0)
    assert whole == 0.0


def test_a_planetary_drive_by_hand(drives):
    """Sun 10, planets 20, ring 50 mm: the ring is too small by what sun and two radii of the planets grow more."""
    drive = drives["planetary"]
    for carrier in (0.0, 2e-4, 9e-4):  # the pins leave the planets free in radial direction
        _, whole = added(drive, carrier, sun=2e-4, planet=3e-4, ring=6e-4)
        assert whole == pytest.approx(10e-3 * 2e-4 + 40e-3 * 3e-4 - 50e-3 * 6e-4, rel=1e-12)
    each, _ = added(drive, 3e-4, sun=2e-4, planet=3e-4, ring=6e-4)
    assert each == pytest.approx([-1e-4 * 10e-3, -3e-4 * 50e-3], rel=1e-12)


@pytest.mark.parametrize("angles", [(0.0, 0.0), (0.2, 0.2), (-0.1, 0.3)])
def test_the_wedge_drive_as_its_own_formula_has_it(angles):
    left, right = angles
    geometry = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, left, right)
    sides = triangle(geometry)
    rest = rest_state(geometry=geometry, sides=sides, preload=1000.0)
    own = interference_of_expansion(
        geometry=geometry, sides=sides, rest=rest, sun=1e-4, planet=2e-4, loading_roller=3.5e-4, ring=5e-4
    )
    drive = wedge_drive(geometry, planet_count=3)
    _, found = added(drive, 3.5e-4, sun=1e-4, planet=2e-4, right=3.5e-4, left=3.5e-4, ring=5e-4)
    assert found == pytest.approx(float(own), rel=1e-9)


@pytest.mark.parametrize("body", ["sun", "first_row", "second_row", "ring"])
def test_a_multiroller_drive_by_exact_geometry(drives, body):
    """The ring that just touches the second row, by the cosine rule with radii of which one body's have grown."""
    strain = 1e-4

    def touching(grown):
        of = {name: 1.0 + (strain if name == grown else 0.0) for name in ("sun", "first_row", "second_row")}
        orbit = 10e-3 * of["sun"] + 22e-3 * of["first_row"]
        reach = 9e-3 * of["first_row"] + 25e-3 * of["second_row"]
        half = math.pi / 4
        far = orbit * math.cos(half) + math.sqrt(reach**2 - (orbit * math.sin(half)) ** 2)
        return far + 14e-3 * of["second_row"]

    ring = touching("")
    exact = touching(body) - ring * (1.0 + (strain if body == "ring" else 0.0))
    _, found = added(drives["multiroller"], 0.0, **{body: strain})
    assert found == pytest.approx(exact, rel=1e-3)


def test_equal_interferences_of_all_rings_are_that_of_the_drive(drives):
    forces = jnp.array([1.0, 0.3, 0.7])
    found = ring_interference(
        drive=drives["stepped"], forces=forces, interference=jnp.array([0.0, 2e-5, 2e-5])
    )
    assert float(found) == pytest.approx(2e-5, rel=1e-12)
    other = ring_interference(
        drive=dataclasses.replace(drives["stepped"]),
        forces=forces,
        interference=jnp.array([1e-5, 2e-5, 3e-5]),
    )
    assert float(other) == pytest.approx(1e-5 + 0.3 * 2e-5 + 0.7 * 3e-5, rel=1e-12)
