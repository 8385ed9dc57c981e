"""Rating life and static safety of bearings: properties and limits."""

import math

import jax
import pytest

from asperity.drive.structure.bearing_life import LIFE_EXPONENTS, basic_rating_life, static_safety


def test_load_at_the_rating_gives_a_million_turns():
    for exponent in LIFE_EXPONENTS.values():
        assert float(basic_rating_life(dynamic_rating=7e3, load=7e3, exponent=exponent)) == pytest.approx(1e6)


def test_twice_the_load_of_a_roller_bearing():
    """Halving a load lengthens the life 2^(10/3) = 10.08 times."""
    life = [float(basic_rating_life(dynamic_rating=1.0, load=p, exponent=10 / 3)) for p in (0.2, 0.1)]
    assert life[1] / life[0] == pytest.approx(10.0794, rel=1e-5)


def test_no_load_and_no_number():
    life = {"dynamic_rating": 1e3, "exponent": 3.0}
    assert float(basic_rating_life(load=0.0, **life)) == math.inf
    assert math.isnan(float(basic_rating_life(load=math.nan, **life)))
    assert float(static_safety(static_rating=600.0, load=400.0)) == 1.5
    assert float(static_safety(static_rating=600.0, load=0.0)) == math.inf
    assert math.isnan(float(static_safety(static_rating=600.0, load=math.nan)))
    assert float(jax.grad(lambda p: basic_rating_life(load=p, **life))(0.0)) == 0.0
