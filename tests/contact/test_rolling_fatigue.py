"""Fatigue life: the published form in two unit systems, Lundberg and Palmgren's capacity, Weibull by sampling."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.contact.rolling_fatigue import (
    BEARING_STEEL,
    WEIBULL_SLOPE,
    damage_shares,
    life_at_reliability,
    line_contact_life,
    spectrum_life,
    stressed_track_life,
)

MODULUS, RADIUS, LENGTH = 206e9 / (2 * (1 - 0.3**2)), 20e-3 / 3, 10e-3


def life(peak, **changes):
    arguments = {
        "peak_pressure": peak,
        "half_width": 2 * peak * RADIUS / MODULUS,
        "contact_length": LENGTH,
        "track_radius": 10e-3,
        "material_constant": BEARING_STEEL,
    }
    return line_contact_life(**(arguments | changes))


def test_constant_in_pounds_and_inches_gives_the_same_life():
    """K_1 = 3.583e56 in pounds and inches is the other form in which the source is quoted."""
    psi, inch = 6894.757, 0.0254
    metric = stressed_track_life(
        shear_stress=3.0e8, depth=6e-5, stressed_volume=4e-8, material_constant=BEARING_STEEL
    )
    imperial = stressed_track_life(
        shear_stress=3.0e8 / psi,
        depth=6e-5 / inch,
        stressed_volume=4e-8 / inch**3,
        material_constant=3.583e56,
    )
    assert float(imperial) == pytest.approx(float(metric), rel=2e-3)


@pytest.mark.parametrize("side", ["inner", "outer"])
@pytest.mark.parametrize("load", [1500.0, 4000.0])
def test_level_and_exponent_of_lundberg_and_palmgren(side, load):
    """Second route, a raceway's 552 (1 -+ g)^(29/27)/(1 +- g)^(1/4) (D/d_m)^(2/9) D^(29/27) l^(7/9) Z^(-1/4).

    Capacity in N and mm for a million turns, life (Q_c/Q)^4 (Lundberg and Palmgren 1952). 14 rollers 10 x 10 mm on a
    pitch circle of 60 mm; its inner ring turns, the raceways see Z (1 +- g)/2 rollers a turn. The two models have
    Weibull slopes 10/9 and 9/8 and agree within 25 %.
    """
    sign = 1.0 if side == "inner" else -1.0
    diameter, pitch, length, rollers = 10.0, 60.0, 10.0, 14
    g = diameter / pitch
    capacity = 552 * (1 - sign * g) ** (29 / 27) / (1 + sign * g) ** 0.25 * g ** (2 / 9)
    capacity *= diameter ** (29 / 27) * length ** (7 / 9) * rollers**-0.25
    expected = (capacity / load) ** 4
    track = (pitch - sign * diameter) / 2e3
    radius = 1 / (2e3 / diameter + sign / track)
    width = math.sqrt(4 * load / (length / 1e3) * radius / (math.pi * MODULUS))
    found = line_contact_life(
        peak_pressure=2 * load / (math.pi * width * length / 1e3),
        half_width=width,
        contact_length=length / 1e3,
        track_radius=track,
        material_constant=BEARING_STEEL,
    ) / (rollers * (1 + sign * g) / 2)
    assert float(found) == pytest.approx(expected, rel=0.25)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_exponents_of_pressure_and_load():
    slope = jax.grad(lambda x: jnp.log(life(jnp.exp(x))))(math.log(1.5e9))
    assert float(slope) == pytest.approx(
        -8.1, rel=1e-12
    )  # p0 ~ sqrt(load): -4.05 in the load, -4 by Lundberg
    longer = life(1.5e9, contact_length=2 * LENGTH) / life(1.5e9)
    assert float(longer) == pytest.approx(0.5**0.9, rel=1e-12)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_unloaded_tracks_live_for_ever():
    found = jax.vmap(life)(np.array([0.0, 1e9]))
    assert float(found[0]) == np.inf
    assert np.isfinite(float(jax.grad(life)(0.0)))


def test_reliability_of_the_rating():
    assert float(life_at_reliability(life=7.0, reliability=0.9)) == pytest.approx(7.0, rel=1e-14)
    there = float(life_at_reliability(life=7.0, reliability=0.99))
    assert 0.9 ** ((there / 7.0) ** WEIBULL_SLOPE) == pytest.approx(0.99, rel=1e-12)


def test_spectrum_adds_damage():
    """Half of the time 10 turns/s at a life of 1000 turns, a quarter 4 turns/s at 200, a quarter at rest."""
    found = spectrum_life(
        lives=np.array([1000.0, 200.0, 50.0]),
        cycle_rates=np.array([10.0, 4.0, 0.0]),
        time_shares=np.array([0.5, 0.25, 0.25]),
    )
    assert float(found) == pytest.approx(1 / (0.5 * 10 / 1000 + 0.25 * 4 / 200), rel=1e-14)
    still = spectrum_life(lives=np.array([np.inf]), cycle_rates=np.array([3.0]), time_shares=np.array([1.0]))
    assert float(still) == np.inf


def test_damage_of_each_load():
    """The spectrum above: 0.005 and 0.005 a second."""
    found = damage_shares(
        lives=np.array([1000.0, 200.0, 50.0]),
        cycle_rates=np.array([10.0, 4.0, 0.0]),
        time_shares=np.array([0.5, 0.25, 0.25]),
    )
    np.testing.assert_allclose(found, [0.5, 0.5, 0.0], rtol=1e-14)
    still = damage_shares(lives=np.array([9.0]), cycle_rates=np.array([0.0]), time_shares=np.array([1.0]))
    assert bool(jnp.isnan(still[0]))


def test_a_spectrum_with_an_unknown_life_has_none():
    unknown = spectrum_life(
        lives=np.array([1e9, np.nan]), cycle_rates=np.array([1.0, 1.0]), time_shares=np.array([0.5, 0.5])
    )
    assert bool(jnp.isnan(unknown))
