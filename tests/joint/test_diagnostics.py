"""Diagnostics of the paper's joint: each against plain arithmetic from the forces, in order and out of it."""

import math
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.diagnostics import _along_the_line

MODULUS = 206e9 / (2 * 0.91)
RADII = [(4e-3, 13.5e-3, 1), (13.5e-3, 5e-3, 1), (13.5e-3, 5e-3, 1), (5e-3, 40e-3, -1), (5e-3, 40e-3, -1)]


@pytest.fixture
def paper(solved_paper):
    return solved_paper[1].result


def half_widths(normal):
    """Johnson 1985, (4.43)."""
    radii = np.array([a * b / abs(a + sign * b) for a, b, sign in RADII])
    return np.sqrt(4 * normal * radii / (math.pi * 5e-3 * MODULUS))


def test_hertz_strip_and_first_yield(paper):
    normal, found = np.asarray(paper.forces.normal), paper.diagnostics
    width = half_widths(normal)
    pressure = 2 * normal / (math.pi * width * 5e-3)
    np.testing.assert_allclose(found.hertz_half_width, width, rtol=1e-12)
    np.testing.assert_allclose(found.hertz_pressure, pressure, rtol=1e-12)
    np.testing.assert_allclose(found.pressure_over_first_yield, pressure / (1.67 * 450e6), rtol=3e-3)
    assert float(found.hertz_pressure[0]) == pytest.approx(1.53e9, rel=5e-3)  # the model's own figure
    assert float(found.pressure_over_first_yield[0]) == pytest.approx(2.0, rel=0.03)


def test_real_area_and_largest_spot_exceed_the_strip(paper):
    """Sun contact at 1000 N by benchmarks/baseline_scipy.py: a_l = 37.788, A_r = 7.3748 mm^2; the strip: 0.83 mm^2."""
    assert float(paper.contacts.largest_area[0]) == pytest.approx(37.788e-6, rel=5e-3)
    assert float(paper.contacts.real_contact_area[0]) == pytest.approx(7.3748e-6, rel=5e-3)
    strip = 2 * half_widths(np.asarray(paper.forces.normal)) * 5e-3
    assert strip[0] == pytest.approx(0.833e-6, rel=5e-3)
    found = paper.diagnostics
    np.testing.assert_allclose(
        found.real_area_over_hertz_area, paper.contacts.real_contact_area / strip, rtol=1e-12
    )
    np.testing.assert_allclose(
        found.largest_spot_over_hertz_area, paper.contacts.largest_area / strip, rtol=1e-12
    )


def test_slip(paper):
    forces, found = paper.forces, paper.diagnostics
    np.testing.assert_allclose(
        found.slip_ratio, np.abs(forces.tangential) / (0.12 * forces.normal), rtol=1e-12
    )


def test_plastic_share_and_distance_from_lift_off(paper):
    critical = 1e-22 * (2 * MODULUS / 1260e6) ** 5  # (19) at D = 1.4
    found = paper.diagnostics
    np.testing.assert_allclose(
        found.critical_over_largest_spot, critical / paper.contacts.largest_area, rtol=1e-9
    )
    side = 1000.0 / (2 * math.cos(math.radians(27.0831)))
    rest = np.array(
        [1000.0, side, side, side * math.cos(math.radians(13.1582)), side * math.cos(math.radians(13.1582))]
    )
    np.testing.assert_allclose(found.normal_force_over_preload, paper.forces.normal / rest, rtol=1e-5)


def test_spread_of_a_line_load_by_hand():
    """200 N/mm on average over 5 mm, of which 4 mm bear, 0.1 mm wide; nothing where the contact is open."""
    lines = SimpleNamespace(
        loaded_share=jnp.array([0.8, 0.8]),
        line_load=jnp.array([[3e5, 3e5]]),
        end_line_load=jnp.array([1e4, 1e4]),
        half_width=jnp.array([[5e-5, 5e-5]]),
        solved=jnp.array([True, False]),
    )
    found = _along_the_line(lines, SimpleNamespace(contact_length=5e-3), jnp.array([1000.0, 0.0]))
    by_hand = {
        "loaded_length_share": 0.8,
        "peak_line_load_ratio": 1.5,
        "end_line_load_ratio": 0.05,
        "loaded_length_over_width": 40.0,
    }
    for name, value in by_hand.items():
        np.testing.assert_allclose(found[name], [value, np.nan], rtol=1e-12)
    assert found["slices_hold"].tolist() == [True, True]
