"""What strains add to the interference of drives: by hand, by exact geometry, and by the paper's drive."""

import dataclasses
import math

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.expansion import interference_of_strains, ring_interference
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.state.states import rest_forces
from asperity.drive.types.wedge import wedge_drive


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


RADII = {"sun": 4e-3, "planet": 13.5e-3, "loading_roller": 5e-3, "ring": 40e-3}


def wedge_change(left=0.0, right=0.0, carrier=0.0, **strains):
    """Interference that strains of the bodies add to the paper's drive."""
    drive = wedge_drive(DriveGeometry(*RADII.values(), 3.0, left, right), planet_count=3)
    rollers = dict.fromkeys(
        ("right_loading_roller", "left_loading_roller"), strains.pop("loading_roller", 0.0)
    )
    return added(drive, carrier, **strains, **rollers)[1]


def touching_ring(sun, planet, loading_roller):
    """Radius at which the ring just touches rollers held at the polar angle of the nominal drive."""
    orbit, reach, far = (
        RADII["sun"] + RADII["planet"],
        RADII["planet"] + RADII["loading_roller"],
        RADII["ring"] - RADII["loading_roller"],
    )
    cosine = (orbit**2 + far**2 - reach**2) / (2.0 * orbit * far)
    orbit, reach = sun + planet, planet + loading_roller
    return orbit * cosine + math.sqrt(reach**2 - orbit**2 * (1.0 - cosine**2)) + loading_roller


def test_a_steel_wedge_drive_in_an_aluminium_ring_loses_nine_micrometres():
    """11.5e-6 1/K of difference times 40 mm times 20 K."""
    steel, aluminium = 11.5e-6 * 20.0, 23e-6 * 20.0
    found = wedge_change(sun=steel, planet=steel, loading_roller=steel, ring=aluminium)
    assert found == pytest.approx(-9.2e-6, rel=1e-12)


@pytest.mark.parametrize("body", RADII)
def test_each_body_of_the_wedge_drive_by_exact_geometry(body):
    strain = 2.3e-4
    sizes = {name: radius * (1.0 + strain * (name == body)) for name, radius in RADII.items()}
    exact = touching_ring(sizes["sun"], sizes["planet"], sizes["loading_roller"]) - sizes["ring"]
    assert wedge_change(**{body: strain}) == pytest.approx(exact, rel=5e-4)


def test_unlike_bodies_by_exact_geometry():
    """Ceramic rollers, a steel sun and an aluminium ring; what is left is of second order in the strain."""
    for rise, most in ((60.0, 1e-3), (6.0, 1e-4)):
        strains = {"sun": 12.6e-6 * rise, "planet": 2.6e-6 * rise, "loading_roller": 2.6e-6 * rise}
        sizes = [RADII[name] * (1.0 + strain) for name, strain in strains.items()]
        exact = touching_ring(*sizes) - RADII["ring"] * (1.0 + 23.6e-6 * rise)
        assert wedge_change(**strains, ring=23.6e-6 * rise) == pytest.approx(exact, rel=most)


@pytest.mark.parametrize("angles", [(0.2, 0.2), (-0.1, 0.3)])
def test_one_material_throughout_keeps_its_interference_whatever_the_push(angles):
    left, right = angles
    assert abs(wedge_change(left, right, carrier=1e-3, **dict.fromkeys(RADII, 1e-3))) < 1e-17


def test_a_planet_of_the_wedge_drive_counts_twice_nearly():
    """1.9413, computed independently; a nearer sun counts with cos(theta)/cos(beta)."""
    theta, beta = np.radians(27.0831), np.radians(13.1582)
    assert wedge_change(planet=1.0) == pytest.approx(1.9413 * RADII["planet"], rel=3e-5)
    assert wedge_change(sun=1.0) == pytest.approx(RADII["sun"] * np.cos(theta) / np.cos(beta), rel=1e-5)


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
