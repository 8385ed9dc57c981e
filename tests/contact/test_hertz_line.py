"""Smooth line contact against numbers and integrals of its own."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad

from asperity.contact.hertz_line import (
    FIRST_YIELD_RATIO,
    effective_radius,
    first_yield_pressure,
    half_width,
    logarithmic_compliance,
    peak_pressure,
    ring_secant_compliance,
    roller_secant_compliance,
    stick_half_width,
)

E, NU, B = 206e9, 0.3, 5e-3
MODULUS = E / (2 * (1 - NU**2))
BODY = {"contact_length": B, "youngs_modulus": E, "poisson_ratio": NU}


def test_effective_radius_inside_and_outside():
    assert float(effective_radius(radius_1=4e-3, radius_2=13.5e-3, sign=1.0)) == pytest.approx(
        54e-6 / 17.5e-3
    )
    assert float(effective_radius(radius_1=5e-3, radius_2=40e-3, sign=-1.0)) == pytest.approx(200e-6 / 35e-3)


def test_strip_of_the_papers_sun_contact():
    """Sun on planet at 1000 N, plain arithmetic: 1.53 GPa, about twice first yield of a 450 MPa steel."""
    radius = effective_radius(radius_1=4e-3, radius_2=13.5e-3, sign=1.0)
    width = half_width(
        normal_force=1000.0, contact_length=B, effective_radius=radius, contact_modulus=MODULUS
    )
    pressure = peak_pressure(normal_force=1000.0, contact_length=B, half_width=width)
    assert float(width) == pytest.approx(
        math.sqrt(4 * 1000 * 3.0857142857142857e-3 / (math.pi * B * MODULUS)), rel=1e-12
    )
    assert float(pressure) == pytest.approx(1.53e9, rel=3e-3)
    assert float(pressure) / (FIRST_YIELD_RATIO * 450e6) == pytest.approx(2.0, rel=0.03)


def test_elliptic_pressure_carries_the_load():
    width = half_width(normal_force=700.0, contact_length=B, effective_radius=3e-3, contact_modulus=MODULUS)
    peak = float(peak_pressure(normal_force=700.0, contact_length=B, half_width=width))
    load, _ = quad(lambda s: peak * math.sqrt(1 - s * s) * B * float(width), -1, 1)
    assert load == pytest.approx(700.0, rel=1e-9)


def test_first_yield_by_tresca():
    """tau_max = 0.300 p0, Johnson 1985, section 4.2(c), reaches half the yield strength."""
    found = first_yield_pressure(yield_strength=450e6)
    assert found == pytest.approx(450e6 / 2 / 0.300, rel=3e-3)


def compression_of(secant, **geometry):
    def compression(force):
        width = half_width(
            normal_force=force, contact_length=B, effective_radius=3e-3, contact_modulus=MODULUS
        )
        return force * secant(half_width=width, **geometry, **BODY)

    return compression


@pytest.mark.parametrize(
    ("secant", "geometry"),
    [(roller_secant_compliance, {"radius": 4e-3}), (ring_secant_compliance, {"wall_thickness": 8e-3})],
)
def test_incremental_compliance_is_secant_less_one_logarithmic_unit(secant, geometry):
    compression = compression_of(secant, **geometry)
    force = 600.0
    incremental = jax.grad(compression)(force)
    unit = (1 - NU**2) / (math.pi * E * B)
    assert float(logarithmic_compliance(**BODY)) == pytest.approx(unit, rel=1e-14, abs=0.0)
    assert float(compression(force)) / force - float(incremental) == pytest.approx(unit, rel=1e-9, abs=0.0)


def test_compression_of_a_roller_and_of_a_wall_by_hand():
    force = 600.0
    width = math.sqrt(4 * force * 3e-3 / (math.pi * B * MODULUS))
    unit = force / B * (1 - NU**2) / (math.pi * E)
    roller = compression_of(roller_secant_compliance, radius=4e-3)(force)
    wall = compression_of(ring_secant_compliance, wall_thickness=8e-3)(force)
    assert float(roller) == pytest.approx(unit * (2 * math.log(4 * 4e-3 / width) - 1), rel=1e-12)
    assert float(wall) == pytest.approx(
        2 * unit * (math.log(2 * 8e-3 / width) - NU / (2 * (1 - NU))), rel=1e-12
    )


def test_wall_compression_is_boussinesq_minus_far_field():
    """Plane strain half plane under an elliptic pressure: depth integral of the strain under its middle down to h.

    On the axis (Johnson 1985, 4.46) sigma_x = -p0 [(b^2 + 2 z^2)/(b sqrt(b^2 + z^2)) - 2 z/b],
    sigma_z = -p0 b/sqrt(b^2 + z^2).
    """
    force, depth = 600.0, 8e-3
    width = math.sqrt(4 * force * 3e-3 / (math.pi * B * MODULUS))
    peak = 2 * force / (math.pi * width * B)

    def strain(z):
        root = math.hypot(width, z)
        across = -peak * ((width**2 + 2 * z**2) / (width * root) - 2 * z / width)
        down = -peak * width / root
        return -((1 - NU**2) * down - NU * (1 + NU) * across) / E

    exact, _ = quad(strain, 0.0, depth, epsrel=1e-10, points=[width, 10 * width], limit=200)
    found = compression_of(ring_secant_compliance, wall_thickness=depth)(force)
    assert float(found) == pytest.approx(exact, rel=2e-3)  # the formula drops terms of (b/h)^2
    np.testing.assert_array_less(width / depth, 0.02)


LOAD, LENGTH, WIDTH, MU = 1000.0, 5e-3, 8e-5, 0.12


def traction(x, force):
    stick = stick_half_width(
        half_width=WIDTH, normal_force=LOAD, tangential_force=force, friction_coefficient=MU
    )
    limit = MU * peak_pressure(normal_force=LOAD, contact_length=LENGTH, half_width=WIDTH)

    def ellipse(width):
        return jnp.where(jnp.abs(x) < width, jnp.sqrt(jnp.maximum(1.0 - (x / width) ** 2, 0.0)), 0.0)

    # Johnson 1985, equation (7.24)
    return limit * (ellipse(WIDTH) - jnp.where(stick > 0.0, stick / WIDTH * ellipse(stick), 0.0))


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9, 1.0])
def test_the_traction_integrates_to_the_tangential_force(share):
    force = share * MU * LOAD
    kinks = [WIDTH * np.sqrt(max(1.0 - share, 0.0))]
    total = quad(lambda x: float(traction(x, force)), 0.0, WIDTH, points=kinks, epsabs=0.0, epsrel=1e-9)[0]
    assert 2.0 * total * LENGTH == pytest.approx(force, rel=1e-7)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_the_traction_never_exceeds_friction():
    x = np.linspace(-WIDTH, WIDTH, 401)
    pressure = peak_pressure(normal_force=LOAD, contact_length=LENGTH, half_width=WIDTH) * jnp.sqrt(
        1.0 - (x / WIDTH) ** 2
    )
    assert bool(jnp.all(traction(x, 60.0) <= MU * pressure * (1.0 + 1e-12)))


def test_stick_zone_of_the_cattaneo_benchmark():
    """Johnson 1985, equation (7.28): 7/8 of mu N leaves sqrt(1/8) of the width of a line contact."""
    ours = stick_half_width(half_width=1.0, normal_force=1.0, tangential_force=0.35, friction_coefficient=0.4)
    assert float(ours) == pytest.approx(np.sqrt(1.0 / 8.0), rel=1e-14)
    gone = stick_half_width(half_width=1.0, normal_force=1.0, tangential_force=0.5, friction_coefficient=0.4)
    assert float(gone) == 0.0
