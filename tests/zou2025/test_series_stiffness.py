"""Springs in series and parallel: (25)-(30) against (A7) and against rollers turned by hand."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.zou2025.series_stiffness import driven_radii, referred_to_sun, series_torsional_stiffness

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
SPRINGS = jnp.array([4e8, 2.1e8, 1.4e8, 3e8, 1.9e8])


def test_series_is_one_line():
    """(A7): n R_s^2 / (1/K_sp + 1/(K_pwr + K_pwl) + 1/(K_wro + K_wlo)); planets' and rollers' radii cancel."""
    found = series_torsional_stiffness(geometry=PAPER, tangential_stiffness=SPRINGS)
    expected = 3 * 4e-3**2 / (1 / 4e8 + 1 / 3.5e8 + 1 / 4.9e8)
    assert float(found.input) == pytest.approx(expected, rel=1e-14)
    assert float(found.output) == pytest.approx(81 * expected, rel=1e-14)


def test_series_by_turning_rollers_against_their_springs():
    """A torque on the sun with the ring fixed: equilibrium of planets and rollers as a linear system of arcs."""
    sp, pw, wo = float(SPRINGS[0]), float(SPRINGS[1] + SPRINGS[2]), float(SPRINGS[3] + SPRINGS[4])
    chain = np.array(
        [[sp, -sp, 0.0], [-sp, sp + pw, -pw], [0.0, -pw, pw + wo]]
    )  # arcs of sun, planet, rollers
    arc = np.linalg.solve(chain, [1.0, 0.0, 0.0])[0]  # unit force at the sun's surface of one branch
    found = series_torsional_stiffness(geometry=PAPER, tangential_stiffness=SPRINGS)
    assert float(found.input) == pytest.approx(3 * 4e-3 / (arc / 4e-3), rel=1e-12)


def test_reference_to_the_sun():
    assert referred_to_sun(
        torsional_stiffness=2e8 * 13.5e-3**2, sun_radius=4e-3, radius=13.5e-3
    ) == pytest.approx(2e8 * 16e-6)
    np.testing.assert_allclose(driven_radii(PAPER), [13.5e-3, 5e-3, 5e-3, 5e-3, 5e-3])


@pytest.mark.parametrize("stage", [(0,), (1, 2), (3, 4)])
def test_a_stage_that_slips_leaves_nothing(stage):
    slipping = SPRINGS.at[jnp.array(stage)].set(0.0)
    assert float(series_torsional_stiffness(geometry=PAPER, tangential_stiffness=slipping).input) == 0.0


def test_one_slipping_side_leaves_the_other():
    found = series_torsional_stiffness(geometry=PAPER, tangential_stiffness=SPRINGS.at[2].set(0.0))
    assert float(found.input) == pytest.approx(3 * 4e-3**2 / (1 / 4e8 + 1 / 2.1e8 + 1 / 4.9e8), rel=1e-14)
