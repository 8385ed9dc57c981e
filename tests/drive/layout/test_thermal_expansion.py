"""What temperature does to a ring in its housing, by Lamé's equations, and where nothing is left of an interference."""

import math

import numpy as np
import pytest

from asperity.drive.layout.expansion import loosening_rise, ring_expansion


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
