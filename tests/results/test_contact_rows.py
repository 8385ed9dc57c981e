"""Rows of forces and contacts of the paper's joint, by hand."""

import math

import numpy as np
import pytest

SUN, PLANET, ROLLER, RING, LENGTH = 4e-3, 13.5e-3, 5e-3, 40e-3, 5e-3
MODULUS = 206e9 / (2.0 * (1.0 - 0.3**2))
RADIUS = np.array(
    [
        SUN * PLANET / (SUN + PLANET),
        *[PLANET * ROLLER / (PLANET + ROLLER)] * 2,
        *[ROLLER * RING / (RING - ROLLER)] * 2,
    ]
)


def test_forces(value):
    """The sun's moment over three contacts; a planet's own moment; the preload that the file states."""
    tangential = np.abs(value("tangential_force"))
    assert value("input_torque") == pytest.approx(5.0 / 9.0, rel=1e-9)
    assert tangential[0] == pytest.approx(5.0 / 9.0 / (3.0 * SUN), rel=1e-9)
    assert tangential[1] + tangential[2] == pytest.approx(tangential[0], rel=1e-9)
    assert value("preload") == 1000.0
    # bodies as springs, computed independently: 12.904 micrometres; as elastic bodies a little less
    assert value("interference") == pytest.approx(12.904e-6, rel=0.02)
    assert (value("thermal_interference"), value("cam_angle")) == (0.0, 0.0)


def test_hertz(value):
    """b^2 = 4 N R/(pi B E*), p = 2 N/(pi b B)."""
    normal = value("normal_force")
    width = np.sqrt(4.0 * normal * RADIUS / (math.pi * LENGTH * MODULUS))
    np.testing.assert_allclose(value("hertz_half_width"), width, rtol=1e-9)
    np.testing.assert_allclose(value("hertz_pressure"), 2.0 * normal / (math.pi * width * LENGTH), rtol=1e-9)


def test_spots_carry_the_normal_force(value):
    np.testing.assert_allclose(
        value("elastic_load") + value("plastic_load"), value("normal_force"), rtol=1e-9
    )
    # integral of a n(a) up to the largest spot, for D = 1.4, times the contact factor
    psi = value("domain_extension_factor")
    whole = 1.4 / 0.6 * psi**0.3 * value("largest_area")
    np.testing.assert_allclose(value("real_contact_area"), value("contact_factor") * whole, rtol=1e-9)


def test_tangential_against_normal_stiffness_of_the_asperities(value):
    """Equation (24) for each spot: what is left of 2 (1 - nu)/(2 - nu) times the normal one under the traction."""
    traction = np.abs(value("tangential_force")) / (0.12 * value("normal_force"))
    ratio = value("asperity_tangential_stiffness") / value("asperity_normal_stiffness")
    np.testing.assert_allclose(ratio, 2.0 * 0.7 / 1.7 * (1.0 - traction) ** (1.0 / 3.0), rtol=1e-9)


def test_torsional_stiffness_of_a_contact_is_at_its_driven_roller(value):
    lever = np.array([PLANET, ROLLER, ROLLER, ROLLER, ROLLER])
    np.testing.assert_allclose(
        value("contact_torsional_stiffness"), value("asperity_tangential_stiffness") * lever**2, rtol=1e-9
    )


def test_contacts_without_crowns_have_no_results_of_crowns(value):
    for name in ("loaded_length_share", "peak_line_load_ratio", "end_line_load_ratio"):
        assert np.all(np.isnan(value(name)))
