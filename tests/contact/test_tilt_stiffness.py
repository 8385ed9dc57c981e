"""Tilt stiffness of line contacts: an independent computation, differences of slices, and a closed form."""

import math

import numpy as np
import pytest

from asperity.contact.crowned_line import compression_and_shortening, crowned_line
from asperity.contact.tilt_stiffness import (
    freeing_tilt,
    line_load_stiffness,
    pressed_end_pressure,
    sliced_tilt_stiffness,
    tilt_stiffness,
    tilting_moment,
)
from asperity.contact.tilted_line import PLACES, profiled_line
from asperity.engine.control import at_once

MODULUS = 206e9 / (2.0 * (1.0 - 0.3**2))
RADIUS, B, N = 20e-3 / 3.0, 10e-3, 2000.0  # steel rollers of 10 and 20 mm
PAIR = {"normal_force": N, "contact_length": B, "effective_radius": RADIUS, "contact_modulus": MODULUS}
EVEN_WIDTH = math.sqrt(4.0 * N * RADIUS / (math.pi * MODULUS * B))
Y = B * PLACES
SLICE = float(line_load_stiffness(half_width=EVEN_WIDTH, loaded_length=B, contact_modulus=MODULUS))
STIFFNESS = float(tilt_stiffness(line_load_stiffness=SLICE, contact_length=B))
FREEING = float(freeing_tilt(line_load=N / B, line_load_stiffness=SLICE, contact_length=B))


def pressed(gap):
    return at_once(lambda some: profiled_line(gap=some, **PAIR), np.asarray(gap))


def moment(line):
    return float(tilting_moment(line_load=line.line_load, contact_length=B))


def of_slices(curvature, force=N):
    pair = PAIR | {"normal_force": force}

    def found(curvature):
        line = crowned_line(crown_curvature=curvature, **pair)
        _, shorter = compression_and_shortening(crown_curvature=curvature, **pair)
        length = 1.0 / (1.0 / B + shorter)
        return sliced_tilt_stiffness(
            line=line, loaded_length=length, contact_length=B, contact_modulus=MODULUS
        )

    return float(at_once(found, np.asarray(curvature)))


def test_check_contact():
    assert pytest.approx(4.9447e10, rel=1e-4) == SLICE
    assert pytest.approx(4120.6, rel=1e-4) == STIFFNESS
    assert pytest.approx(0.809e-3, rel=1e-3) == FREEING


@pytest.mark.parametrize(
    ("tilt", "peak", "end_over_mean", "about_middle"),
    [
        (0.0, 1039.6, 1.0, 0.0),
        (0.1e-3, 1102.3, 1.124, 0.4120),
        (0.25e-3, 1191.2, 1.313, 1.0290),
        (0.5e-3, 1328.1, 1.632, 2.0508),
        (1e-3, 1576.5, 2.299, 4.0520),
    ],
)
def test_tilted_cylinder_of_an_independent_computation(tilt, peak, end_over_mean, about_middle):
    found = pressed(-tilt * Y)
    assert float(found.peak_pressure) * 1e-6 == pytest.approx(peak, rel=1e-3)
    assert float(found.end_line_load) / (N / B) == pytest.approx(end_over_mean, rel=1e-3)
    assert moment(found) == pytest.approx(about_middle, rel=1e-3, abs=1e-12)
    if tilt < FREEING:
        end = pressed_end_pressure(peak_pressure=1039.6e6, tilt=tilt, freeing_tilt=FREEING)
        assert float(end) == pytest.approx(float(found.peak_pressure), rel=0.01)
        assert min(float(found.line_load[0]), float(found.line_load[-1])) > 0.0


def test_an_end_comes_free_near_its_tilt():
    assert float(pressed(-0.9 * FREEING * Y).line_load[0]) > 0.0
    assert float(pressed(-1.3 * FREEING * Y).line_load[0]) == 0.0


@pytest.mark.parametrize("curvature", [0.0, 0.02, 0.1])
def test_stiffness_is_the_difference_of_the_moment_of_slices(curvature):
    tilt = 0.02e-3
    line = pressed(0.5 * curvature * Y**2 - tilt * Y)
    assert of_slices(curvature) == pytest.approx(moment(line) / tilt, rel=5e-3)
    if curvature == 0.0:
        assert of_slices(curvature) == pytest.approx(STIFFNESS, rel=1e-9)


@pytest.mark.parametrize("crown", [0.3, 0.6, 1.0])
def test_free_ends_of_a_circular_crown(crown):
    """M = N phi R_c: the load moves to where the tilted circle is highest, and its peak stays."""
    assert of_slices(1.0 / crown) == pytest.approx(N * crown, rel=2e-3)
    straight, tilted = (pressed(Y**2 / (2.0 * crown) - tilt * Y) for tilt in (0.0, 0.5e-3))
    assert float(tilted.end_line_load) == 0.0
    assert moment(tilted) == pytest.approx(N * 0.5e-3 * crown, rel=1e-4)
    assert float(tilted.peak_pressure) == pytest.approx(float(straight.peak_pressure), rel=1e-4)
