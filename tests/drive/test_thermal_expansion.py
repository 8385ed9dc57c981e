"""What temperature does to the interference: by hand, by exact geometry; a ring in its housing by Lamé's equations."""

import math

import numpy as np
import pytest

from asperity.drive.geometry import DriveGeometry, triangle
from asperity.drive.mechanism import rest_state
from asperity.drive.thermal_expansion import interference_of_expansion, loosening_rise, ring_expansion

BODIES = ("sun", "planet", "loading_roller", "ring")
RADII = {"sun": 4e-3, "planet": 13.5e-3, "loading_roller": 5e-3, "ring": 40e-3}


def change(left=0.0, right=0.0, **strains):
    geometry = DriveGeometry(
        **{f"{body}_radius": radius for body, radius in RADII.items()},
        planet_count=3.0,
        left_push_angle=left,
        right_push_angle=right,
    )
    sides = triangle(geometry)
    rest = rest_state(geometry=geometry, sides=sides, preload=1000.0)
    given = dict.fromkeys(BODIES, 0.0) | strains
    return float(interference_of_expansion(geometry=geometry, sides=sides, rest=rest, **given))


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


def test_a_steel_drive_in_an_aluminium_ring_loses_nine_micrometres():
    """11.5e-6 1/K of difference times 40 mm times 20 K."""
    steel, aluminium = 11.5e-6 * 20.0, 23e-6 * 20.0
    found = change(sun=steel, planet=steel, loading_roller=steel, ring=aluminium)
    assert found == pytest.approx(-9.2e-6, rel=1e-12)


@pytest.mark.parametrize("body", BODIES)
def test_each_body_by_exact_geometry(body):
    strain = 2.3e-4
    sizes = {name: radius * (1.0 + strain * (name == body)) for name, radius in RADII.items()}
    exact = touching_ring(sizes["sun"], sizes["planet"], sizes["loading_roller"]) - sizes["ring"]
    assert change(**{body: strain}) == pytest.approx(exact, rel=5e-4)


def test_unlike_bodies_by_exact_geometry():
    """Ceramic rollers, a steel sun and an aluminium ring; what is left is of second order in the strain."""
    for rise, most in ((60.0, 1e-3), (6.0, 1e-4)):
        strains = {"sun": 12.6e-6 * rise, "planet": 2.6e-6 * rise, "loading_roller": 2.6e-6 * rise}
        sizes = [RADII[name] * (1.0 + strain) for name, strain in strains.items()]
        exact = touching_ring(*sizes) - RADII["ring"] * (1.0 + 23.6e-6 * rise)
        assert change(**strains, ring=23.6e-6 * rise) == pytest.approx(exact, rel=most)


@pytest.mark.parametrize("angles", [(0.0, 0.0), (0.2, 0.2), (-0.1, 0.3)])
def test_one_material_throughout_keeps_its_interference(angles):
    left, right = angles
    found = change(left=left, right=right, **dict.fromkeys(BODIES, 1e-3))
    assert abs(found) < 1e-17


def lame(ring, housing, inner, wall, young, poisson, support, plane_state):
    """Displacement of the inner rim per kelvin from the two boundary conditions, in the two constants A r + B/r."""
    outer = inner + wall
    if plane_state == "plane_strain":
        young, poisson = young / (1.0 - poisson**2), poisson / (1.0 - poisson)

    def stress(r):  # of u = A r + B / r
        return np.array([young / (1.0 - poisson), -young / (1.0 + poisson) / r**2])

    def moved(r):
        return np.array([r, 1.0 / r])

    # sigma(a) = 0; sigma(b) = -k (u(b) + alpha_r b - alpha_h b)
    free = (ring - housing) * outer
    rows = np.array([stress(inner), stress(outer) / support + moved(outer)])
    constants = np.linalg.solve(rows, np.array([0.0, -free]))
    return ring + moved(inner) @ constants / inner


@pytest.mark.parametrize("plane_state", ["plane_strain", "plane_stress"])
@pytest.mark.parametrize("wall", [2e-3, 10e-3, 60e-3])
@pytest.mark.parametrize("support", [1e11, 4e11, 1e13])
def test_a_ring_in_its_housing_by_lame(plane_state, wall, support):
    found = ring_expansion(
        ring=12.6e-6,
        housing=23.6e-6,
        inner_radius=40e-3,
        wall_thickness=wall,
        youngs_modulus=206e9,
        poisson_ratio=0.3,
        housing_stiffness=support,
        plane_state=plane_state,
    )
    expected = lame(12.6e-6, 23.6e-6, 40e-3, wall, 206e9, 0.3, support, plane_state)
    assert float(found) == pytest.approx(expected, rel=1e-12)


def test_limits_of_the_housing():
    ring = {
        "ring": 12e-6,
        "inner_radius": 40e-3,
        "youngs_modulus": 206e9,
        "poisson_ratio": 0.3,
        "plane_state": "plane_stress",
    }
    free = ring_expansion(**ring, housing=23e-6, wall_thickness=10e-3, housing_stiffness=0.0)
    alike = ring_expansion(**ring, housing=12e-6, wall_thickness=10e-3, housing_stiffness=math.inf)
    thin = ring_expansion(**ring, housing=23e-6, wall_thickness=1e-9, housing_stiffness=math.inf)
    plate = ring_expansion(**ring, housing=23e-6, wall_thickness=1e9, housing_stiffness=math.inf)
    assert float(free) == float(alike) == 12e-6
    assert float(thin) == pytest.approx(23e-6, rel=1e-6)
    # the hole in a wide plate that is stretched alike in both directions widens 2/(1 - nu) times as much
    assert float(plate) - 12e-6 == pytest.approx(11e-6 * 2.0 / 0.7, rel=1e-9)


def test_where_nothing_is_left():
    assert float(loosening_rise(interference=9.2e-6, change_per_kelvin=-0.46e-6)) == pytest.approx(20.0)
    assert float(loosening_rise(interference=9.2e-6, change_per_kelvin=0.46e-6)) == pytest.approx(-20.0)
    assert float(loosening_rise(interference=9.2e-6, change_per_kelvin=0.0)) == math.inf
