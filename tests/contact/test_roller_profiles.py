"""Logarithmic profiles: peaks of an independent computation, and what each profile was made for."""

import math

import numpy as np
import pytest

from asperity.contact.crowned_line import crowned_line
from asperity.contact.roller_profiles import (
    ISO_16281_LENGTH,
    iso_16281_coefficient,
    johns_gohar_share,
    logarithmic_profile,
    lundberg_coefficient,
)
from asperity.contact.tilted_line import PLACES, logarithmic_drop, logarithmic_end_drop, profiled_line
from asperity.engine.control import at_once

E, NU = 206e9, 0.3
MODULUS = E / (2.0 * (1.0 - NU**2))
RADIUS, B, N = 20e-3 / 3.0, 10e-3, 2000.0  # steel rollers of 10 and 20 mm
PAIR = {"normal_force": N, "contact_length": B, "effective_radius": RADIUS, "contact_modulus": MODULUS}
EVEN_WIDTH = math.sqrt(4.0 * N * RADIUS / (math.pi * MODULUS * B))  # Hertz
Y = B * PLACES
LUNDBERG = float(lundberg_coefficient(line_load=N / B, contact_modulus=MODULUS))
SHARE = float(johns_gohar_share(even_half_width=EVEN_WIDTH, contact_length=B))
PROFILES = {
    "cylinder": 0.0 * Y,
    "lundberg": logarithmic_profile(coefficient=LUNDBERG, end_share=1.0),
    "johns_gohar": logarithmic_profile(coefficient=LUNDBERG, end_share=SHARE),
    "iso_16281": logarithmic_profile(coefficient=iso_16281_coefficient(roller_diameter=20e-3), end_share=1.0),
    "crown of 2 m": Y**2 / 4.0,
}


def pressed(gap, tilt):
    return at_once(lambda some: profiled_line(gap=some, **PAIR), np.asarray(gap) - tilt * Y)


@pytest.mark.parametrize(
    ("profile", "tilt", "peak"),
    [
        ("cylinder", 0.0, 1039.6),
        ("cylinder", 0.5e-3, 1328.1),
        ("lundberg", 0.0, 1082.8),
        ("lundberg", 0.5e-3, 1247.0),
        ("johns_gohar", 0.0, 1081.5),
        ("johns_gohar", 0.5e-3, 1246.7),
        ("iso_16281", 0.0, 1383.0),
        ("iso_16281", 0.5e-3, 1398.2),
        ("crown of 2 m", 0.0, 1279.3),
        ("crown of 2 m", 0.5e-3, 1298.3),
    ],
)
def test_peaks_of_an_independent_computation(profile, tilt, peak):
    """Slices by another program; boundary elements had 1353 and 1370 MPa for the ISO profile, 1260 for the crown."""
    found = pressed(PROFILES[profile], tilt)
    assert float(found.peak_pressure) * 1e-6 == pytest.approx(peak, rel=2e-3)
    assert float(np.trapezoid(found.line_load, Y)) == pytest.approx(N, rel=1e-9)


def test_coefficients_of_the_check_contact():
    assert pytest.approx(0.56245e-6, rel=1e-4) == LUNDBERG
    drop = LUNDBERG * float(logarithmic_end_drop(even_half_width=EVEN_WIDTH, contact_length=B))
    assert drop == pytest.approx(2.757e-6, rel=1e-3)
    assert -LUNDBERG * math.log(1.0 - SHARE) == pytest.approx(drop, rel=1e-12)
    shape = logarithmic_drop(even_half_width=EVEN_WIDTH, contact_length=B)
    assert np.asarray(PROFILES["johns_gohar"]) == pytest.approx(drop * np.asarray(shape), rel=1e-12)


def test_the_standard_profile_is_lundbergs_of_a_roller_on_a_flat_under_3000_mpa():
    """As the MESYS manual says of its default, .00035 D_w."""
    line_load = math.pi * 10e-3 * 3e9**2 / MODULUS  # Hertz, R = D_w/2 = 10 mm
    assert float(lundberg_coefficient(line_load=line_load, contact_modulus=MODULUS)) == pytest.approx(
        float(iso_16281_coefficient(roller_diameter=20e-3)), rel=0.01
    )
    assert ISO_16281_LENGTH == 2.5


def test_drops_without_bound_leave_the_ends_free():
    for profile in ("lundberg", "iso_16281"):
        for tilt in (0.0, 0.5e-3, 5e-3):
            found = pressed(PROFILES[profile], tilt)
            assert float(found.end_line_load) == 0.0
            assert math.isinf(float(found.end_gap))


def test_in_the_middle_it_is_a_circle_of_this_radius():
    """z = A c (2y/B)^2 there: B^2/(8 A c), and with a large A a circle over the whole length."""
    share = 1e-6
    flat = logarithmic_profile(coefficient=1e-6 / share, end_share=share)
    assert np.asarray(flat) == pytest.approx(1e-6 * (2.0 * PLACES) ** 2, rel=1e-6, abs=1e-20)
    crowned = at_once(lambda c: crowned_line(crown_curvature=c, **PAIR), np.asarray(8.0 * 1e-6 / B**2))
    assert float(pressed(flat, 0.0).line_load[100]) == pytest.approx(float(crowned.line_load[0]), rel=3e-3)
