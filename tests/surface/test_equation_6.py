"""Equation (6), the Weierstrass–Mandelbrot profile, written out term by term beside the function."""

import math

import numpy as np
import pytest

from asperity.surface.weierstrass import weierstrass_mandelbrot_profile

LENGTH, D, G, GAMMA, LOWEST = 2e-3, 1.4, 1e-11, 1.5, -2
PHASES = (0.3, 1.9, 4.1, 5.5, 0.0, 2.7)


def profile(position):
    return weierstrass_mandelbrot_profile(
        position=np.asarray(position),
        profile_length=LENGTH,
        fractal_dimension=D,
        fractal_roughness=G,
        frequency_ratio=GAMMA,
        phases=np.array(PHASES),
        lowest_index=LOWEST,
    )


def test_profile_is_the_printed_sum():
    for x in (0.0, 1.7e-6, 4.4e-4, 1.9e-3):
        terms = [
            GAMMA ** ((D - 2.0) * n)
            * (math.cos(phase) - math.cos(2.0 * math.pi * GAMMA**n * x / LENGTH - phase))
            for n, phase in enumerate(PHASES, start=LOWEST)
        ]
        printed = LENGTH * (G / LENGTH) ** (D - 1.0) * math.sqrt(math.log(GAMMA)) * math.fsum(terms)
        assert float(profile(x)) == pytest.approx(printed, rel=1e-12, abs=1e-24)


def test_profile_starts_at_zero_whatever_the_phases():
    assert float(profile(0.0)) == 0.0
