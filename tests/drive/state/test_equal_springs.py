"""Forces of an assembled drive by statics, and of one whose springs decide."""

import math

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.state.states import rest_forces


def test_rest_forces_of_the_drives_by_statics(drives):
    wedge = rest_forces(drive=drives["wedge"], pattern=jnp.array([0.0, 0.0, 0.0, 1.0, 1.0]))
    theta, beta = math.radians(27.0831), math.radians(13.1582)
    side = 0.5 / math.cos(theta)
    np.testing.assert_allclose(
        wedge, [1.0, side, side, side * math.cos(beta), side * math.cos(beta)], rtol=1e-5
    )
    planetary = rest_forces(drive=drives["planetary"], pattern=jnp.array([0.0, 1.0]))
    np.testing.assert_allclose(planetary, 1.0, rtol=1e-12)


def test_rest_forces_of_the_multiroller_by_statics(drives):
    """Two first-row rollers hold each second-row roller: 2 cos(angle to its radius) N_f = N_r; likewise at the sun."""
    forces = rest_forces(drive=drives["multiroller"], pattern=jnp.array([0.0, 0.0, 0.0, 1.0]))
    orbit, far, reach = 32.0, 32.0 * math.sqrt(0.5) + math.sqrt(34.0**2 - 512.0), 34.0
    # triangle of the axis and both centres: 45 degrees at the axis
    at_first = (
        far * math.sqrt(0.5) - orbit
    ) / reach  # cosine between the first roller's radius and the contact
    at_second = (far - orbit * math.sqrt(0.5)) / reach
    between = 1.0 / (2.0 * at_first)
    np.testing.assert_allclose(forces, [1.0, between, between, 2.0 * at_second * between], rtol=1e-12)


def test_springs_share_where_statics_does_not_decide(drives):
    """Held ring and driven ring with equal springs and interferences: the sun's force parts into halves."""
    forces = rest_forces(drive=drives["stepped"], pattern=jnp.array([0.0, 1.0, 1.0]))
    np.testing.assert_allclose(forces, [1.0, 0.5, 0.5], rtol=1e-12)
    # 1 = y + 2 d and 0 = y + d where only one of them has the interference 2 d
    one = rest_forces(drive=drives["stepped"], pattern=jnp.array([0.0, 1.0, 0.0]))
    assert float(one[1] + one[2]) == pytest.approx(1.0, rel=1e-12)
    assert float(one[2]) == pytest.approx(
        -1.0, rel=1e-12
    )  # pulled: it follows the planet, which moved inward by 1
