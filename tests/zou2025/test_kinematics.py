"""Speeds and radii of the paper's drive by hand."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.zou2025.kinematics import carrier_speed, contact_radii, speed_ratio

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)


def test_kinematics_of_the_paper():
    assert speed_ratio(PAPER) == pytest.approx(-9.0, rel=1e-15)
    assert carrier_speed(geometry=PAPER, sun_speed=628.3185307179587) == pytest.approx(-69.81317007977318)


def test_speed_ratio_from_rolling_without_slip():
    """In the carrier's frame every rolling contact hands the surface speed on, and the fixed ring turns backwards."""
    carrier = float(carrier_speed(geometry=PAPER, sun_speed=100.0))
    assert (100.0 - carrier) * 4e-3 == pytest.approx(-carrier * 40e-3, rel=1e-14)


def test_contact_radii_name_driver_and_driven():
    driving, driven, sign = contact_radii(PAPER)
    np.testing.assert_allclose(driving, [4e-3, 13.5e-3, 13.5e-3, 5e-3, 5e-3])
    np.testing.assert_allclose(driven, [13.5e-3, 5e-3, 5e-3, 40e-3, 40e-3])
    np.testing.assert_array_equal(sign, [1, 1, 1, -1, -1])
    batch = contact_radii(DriveGeometry(**(vars(PAPER) | {"sun_radius": jnp.linspace(3e-3, 4e-3, 7)})))
    assert [part.shape for part in batch] == [(5, 7), (5, 7), (5, 1)]
