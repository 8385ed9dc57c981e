"""Shares of asperities and film: a table of an independent computation, the balance itself, limits and orderings."""

import dataclasses
import math

import numpy as np
import pytest
from traction_contacts import HALF_WIDTH, MODULUS, OILS, PEAK, oiled_contact

from asperity.contact.film_thickness import central_film_thickness
from asperity.contact.load_sharing import asperity_separation, rival_share, shared_load

#: M100 at 60 °C, heights of 0.1 µm, over the speed [m/s]: film without asperities over the heights, share of the
#: asperities, and by 1 − erf; computed apart.
KNOWN = [
    (0.01, 0.0889, 0.8839, 0.8999),
    (0.03, 0.191, 0.6184, 0.7868),
    (0.1, 0.444, 0.2410, 0.5299),
    (0.3, 0.957, 0.0606, 0.1760),
]


@pytest.mark.parametrize(("speed", "ratio", "share", "rival"), KNOWN)
def test_shares_of_an_independent_computation(speed, ratio, share, rival):
    oiled = oiled_contact("M100", 60.0, speed, 1e-7)
    assert oiled.full_film / 1e-7 == pytest.approx(ratio, abs=6e-4)
    assert oiled.contact.asperity_share == pytest.approx(share, abs=6e-5)
    assert rival_share(film_thickness=oiled.full_film, rms_height=1e-7) == pytest.approx(rival, abs=3e-4)


def test_film_and_separation_meet():
    """The film of its share of the load, on bodies as much softer, is as thick as the asperities are apart."""
    oiled = oiled_contact("M100", 60.0, [1e-3, 0.05, 1.0, 20.0], 2e-7)
    contact = oiled.contact
    assert contact.asperity_share + contact.film_share == pytest.approx(np.ones(4), rel=1e-15)
    apart = asperity_separation(
        asperity_share=contact.asperity_share,
        decay_length=0.48 * 2e-7,
        rms_height=2e-7,
        half_width=HALF_WIDTH,
        contact_modulus=MODULUS,
        mean_pressure=math.pi / 4.0 * PEAK,
    )
    assert contact.film_thickness == pytest.approx(apart, rel=1e-9, abs=0.0)
    softer = type(oiled.inlet)(
        *(
            value * contact.film_share if name in ("line_load", "contact_modulus") else value
            for name, value in vars(oiled.inlet).items()
        )
    )
    heat = oiled.full_film / central_film_thickness(inlet=oiled.inlet)
    assert contact.film_thickness == pytest.approx(
        heat * central_film_thickness(inlet=softer), rel=1e-12, abs=0.0
    )


def test_asperities_carry_all_at_rest_and_nothing_over_a_thick_film():
    slow = oiled_contact("M100", 60.0, 1e-9, 1e-7)
    assert float(slow.contact.film_share[0]) < 1e-7
    thick = oiled_contact("M100", 25.0, 50.0, 1e-9)
    assert float(thick.contact.asperity_share[0]) < 1e-80
    assert thick.contact.film_thickness == pytest.approx(thick.full_film, rel=1e-12, abs=0.0)


def test_orderings():
    """A falls with speed and viscosity, and rises with the roughness."""
    by_speed = oiled_contact("M100", 60.0, np.geomspace(1e-4, 10.0, 40), 1e-7).contact.asperity_share
    assert np.all(np.diff(by_speed) < 0.0)
    by_height = oiled_contact("M100", 60.0, 0.3, np.geomspace(1e-8, 1e-6, 40)).contact.asperity_share
    assert np.all(np.diff(by_height) > 0.0)
    cold, warm = (
        oiled_contact("M100", celsius, 0.1, 1e-7).contact.asperity_share[0] for celsius in (40.0, 80.0)
    )
    assert cold < warm


def test_random_states():
    """Shares add up to 1; that of the asperities falls with speed and viscosity, at one heat, and rises with height."""
    random, size = np.random.default_rng(3), 4000
    for oil in OILS:
        load, speed, height = (
            np.exp(random.uniform(np.log(low), np.log(high), size))
            for low, high in ((30.0, 6000.0), (1e-5, 10.0), (1e-8, 1e-6))
        )
        oiled = oiled_contact(oil, random.uniform(20.0, 110.0, size), speed, height, load=load)
        inlet, contact = oiled.inlet, oiled.contact

        def sharing(inlet=inlet, height=height, contact=contact):
            return shared_load(
                inlet=inlet,
                decay_length=0.48 * height,
                rms_height=height,
                half_width=contact.half_width,
                mean_pressure=0.25 * math.pi * contact.peak_pressure,
            )

        at = sharing()
        assert at.asperity_share + at.film_share == pytest.approx(np.ones(size), rel=1e-15)
        assert np.all(at.film_thickness > 0.0)
        film = central_film_thickness(inlet=inlet, film_share=at.film_share)
        assert at.film_thickness == pytest.approx(film, rel=1e-12, abs=0.0)
        between = (at.asperity_share > 1e-60) & (at.film_share > 1e-12)
        assert np.count_nonzero(between) > size // 2
        for less in (
            sharing(dataclasses.replace(inlet, rolling_speed=1.05 * speed)),
            sharing(dataclasses.replace(inlet, viscosity=1.05 * inlet.viscosity)),
            sharing(height=height / 1.05),
        ):
            assert np.all(less.asperity_share[between] < at.asperity_share[between])


def test_a_film_of_negative_thickness_carries_nothing_that_is_known():
    """A factor on the thickness beyond the range of its fit: not a number, beside contacts that have one."""
    oiled = oiled_contact("M100", 60.0, [1.0, 1.0], 2e-7)
    found = shared_load(
        inlet=oiled.inlet,
        decay_length=0.48 * np.full(2, 2e-7),
        rms_height=np.full(2, 2e-7),
        half_width=np.full(2, HALF_WIDTH),
        mean_pressure=np.full(2, math.pi / 4.0 * PEAK),
        thickness_factor=np.array([0.9, -0.1]),
    )
    for values in found:
        assert np.isfinite(values).tolist() == [True, False]


def test_separation_by_hand():
    """u0 ln 2 where beta E*/(A p) is 1: 1.1 pi/a h E*/p with a 110 pi µm, h 0.1 µm, E* 100 GPa, p 0.5 GPa and A 0.2."""
    found = asperity_separation(
        asperity_share=0.2,
        decay_length=5e-8,
        rms_height=1e-7,
        half_width=110e-6 * math.pi,
        contact_modulus=100e9,
        mean_pressure=0.5e9,
    )
    assert found == pytest.approx(5e-8 * math.log(2.0), rel=1e-12, abs=0.0)
