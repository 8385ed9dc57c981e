"""Laws of smooth contacts: Hertz's width, the compression of cylinders, and the limit of Carter's creep."""

import math

import numpy as np
import pytest

from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.types.planetary import planetary_drive

E, NU, MU, B = 206e9, 0.3, 0.12, 5e-3


def laws(force):
    return smooth_contact_laws(
        drive=planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=3),
        youngs_modulus=E,
        poisson_ratio=NU,
        friction_coefficient=MU,
        contact_length=B,
        ring_wall_thickness=8e-3,
        reference_force=force,
    )


def half_width(force, radius):
    """Johnson 1985, section 4.2, two bodies of one material."""
    return math.sqrt(4.0 * force * radius / (math.pi * B * E / (2.0 * (1.0 - NU**2))))


def test_sun_and_planet_against_johnson():
    """Two solid cylinders: section 5.6; creep at gross slip mu a/R: section 8.3."""
    found, force = laws(500.0), 500.0
    width = half_width(force, 10e-3 * 20e-3 / 30e-3)
    unit = (1.0 - NU**2) / (math.pi * E * B)
    secant = sum(unit * (2.0 * math.log(4.0 * radius / width) - 1.0) for radius in (10e-3, 20e-3))
    assert float(found.springs.secant_compliance[0]) == pytest.approx(secant, rel=1e-12)
    # d(delta)/dN with the half-width proportional to sqrt(N): each logarithm loses 1/2 twice
    assert float(found.springs.incremental_compliance[0]) == pytest.approx(secant - 2.0 * unit, rel=1e-12)
    scale = float(found.creep.gross_slip_scale[0]) * math.sqrt(force)
    assert scale == pytest.approx(MU * width / (10e-3 * 20e-3 / 30e-3), rel=1e-12)


def test_planet_and_ring_against_weber_and_banaschek():
    """The ring, held by a rigid housing, is compressed over its wall only; its curvature is subtracted."""
    found = laws(500.0)
    width = half_width(500.0, 20e-3 * 50e-3 / 30e-3)
    unit = (1.0 - NU**2) / (math.pi * E * B)
    planet = unit * (2.0 * math.log(4.0 * 20e-3 / width) - 1.0)
    ring = 2.0 * unit * (math.log(2.0 * 8e-3 / width) - NU / (2.0 * (1.0 - NU)))
    internal = -1  # the last contact of the branch
    assert float(found.springs.secant_compliance[internal]) == pytest.approx(planet + ring, rel=1e-12)


def test_the_reference_force_is_no_part_of_the_law():
    """Compliances at 500 N follow from those at 50 N by the logarithm of the force."""
    low, high = laws(50.0), laws(500.0)
    unit = (1.0 - NU**2) / (math.pi * E * B)
    np.testing.assert_allclose(
        np.asarray(low.springs.secant_compliance) - np.asarray(high.springs.secant_compliance),
        2.0 * unit * math.log(10.0),
        rtol=1e-10,
    )
    np.testing.assert_allclose(low.creep.gross_slip_scale, high.creep.gross_slip_scale, rtol=1e-12)
