"""Tilted rollers: against crowned ones without tilt, Hertz's ellipse and boundary elements."""

import math

import jax.numpy as jnp
import numpy as np
import pytest
from scipy.special import ellipe, ellipk

from asperity.bem import FreeHalfSpace, normal_contact
from asperity.bem.elastic_pair import elastic_pair
from asperity.contact.crowned_line import crowned_line
from asperity.contact.tilted_line import PLACES, logarithmic_drop, profiled_line
from asperity.errors import NoSolutionError
from asperity.results.crown_document import least_pressed_drop

E, NU = 206e9, 0.3
MODULUS = E / (2.0 * (1.0 - NU**2))
RADIUS, B, N = 20e-3 / 3.0, 10e-3, 2000.0  # steel rollers of 10 and 20 mm
PAIR = {"normal_force": N, "contact_length": B, "effective_radius": RADIUS, "contact_modulus": MODULUS}
EVEN_WIDTH = math.sqrt(4.0 * N * RADIUS / (math.pi * MODULUS * B))  # Hertz
Y, CIRCLE = B * PLACES, (2.0 * PLACES) ** 2
LOGARITHM = logarithmic_drop(even_half_width=EVEN_WIDTH, contact_length=B)


@pytest.mark.parametrize("crown", [np.inf, 5.0, 1.0, 0.3])
def test_a_circular_crown_without_tilt(crown):
    found, crowned = (
        profiled_line(gap=Y**2 / (2.0 * crown), **PAIR),
        crowned_line(crown_curvature=1.0 / crown, **PAIR),
    )
    assert float(jnp.trapezoid(found.line_load, Y)) == pytest.approx(N, rel=1e-12)
    assert float(found.line_load[100]) == pytest.approx(float(crowned.line_load[0]), rel=3e-3)
    assert float(found.end_line_load) == pytest.approx(float(crowned.end_line_load), rel=3e-3)
    assert (float(found.end_gap) > 0.0) == (float(crowned.end_line_load) == 0.0)
    pressure = 2.0 * found.line_load.max() / math.pi / (2.0 * RADIUS / MODULUS * found.peak_pressure)
    assert float(pressure) == pytest.approx(
        float(found.peak_pressure), rel=1e-12
    )  # p = 2P'/(pi a), a = 2R p/E*


def test_the_pressed_end_of_a_tilted_cylinder_is_the_last_slice():
    found = profiled_line(gap=-0.5e-3 * Y, **PAIR)
    assert float(found.end_line_load) == pytest.approx(float(found.line_load[-1]), rel=1e-12)


def _hertz(crown):
    """Largest pressure and long semi-axis of the ellipse of this crown under N (Johnson 1985, 4.25-4.29)."""

    def of_one_metre(axes):
        squared = 1 - axes**-2
        first, second = ellipk(squared), ellipe(squared)
        ratio = (axes**2 * second - first) / (first - second)
        return ratio, MODULUS * axes**2 * squared / (2 * ratio * RADIUS * (first - second))

    low, high = 1.01, 1e5
    for _ in range(100):
        axes = math.sqrt(low * high)
        low, high = (axes, high) if of_one_metre(axes)[0] < crown / RADIUS else (low, axes)
    peak = of_one_metre(axes)[1]
    a = (N / (2 / 3 * math.pi * peak * axes)) ** (1 / 3)  # the pressure grows with the short semi-axis a
    return peak * a, axes * a


def test_the_gentlest_crown_that_frees_a_tilted_end_is_hertzs_ellipse_moved_aside():
    """A tilt moves the summit of a circle by tilt times radius: free if that and half of the ellipse fit in B/2."""
    tilt = 0.5e-3
    low, high = 0.3, 3.0
    for _ in range(60):
        crown = 0.5 * (low + high)
        low, high = (crown, high) if tilt * crown + _hertz(crown)[1] < 0.5 * B else (low, crown)
    drop = least_pressed_drop(CIRCLE, tilt=tilt, **PAIR)
    assert drop == pytest.approx(B**2 / (8.0 * crown), rel=0.03)
    found = profiled_line(gap=drop * CIRCLE - tilt * Y, **PAIR)
    assert float(found.peak_pressure) == pytest.approx(_hertz(crown)[0], rel=0.025)
    assert float(found.end_line_load) < 1e-3 * N / B
    assert Y[int(jnp.argmax(found.line_load))] == pytest.approx(tilt * crown, abs=B / 150)
    assert least_pressed_drop(CIRCLE, tilt=-tilt, **PAIR) == pytest.approx(drop, rel=1e-5)


def test_logarithmic_profile_by_hand():
    """End drop of Johns and Gohar, 1.193 + ln(B/2b) of Lundberg's coefficient; near the middle A (2y/B)^2."""
    at_end = 1.193 + math.log(B / (2.0 * EVEN_WIDTH))
    assert [float(LOGARITHM[k]) for k in (0, 100, 200)] == pytest.approx([1.0, 0.0, 1.0])
    assert float(LOGARITHM[101]) * at_end == pytest.approx(0.01**2, rel=0.05)
    middle = -math.log(1.0 - (1.0 - math.exp(-at_end)) * 0.25) / at_end
    assert float(LOGARITHM[50]) == pytest.approx(middle, rel=1e-3)


@pytest.mark.parametrize("shape", [CIRCLE, LOGARITHM], ids=["circle", "logarithm"])
@pytest.mark.parametrize("tilt", [0.0, 0.5e-3])
def test_boundary_elements_on_half_spaces_that_go_on_beyond_the_ends(shape, tilt):
    """The pressure with the recommended drop; half of it loads the sharp ends, twice as much the middle."""
    bodies = elastic_pair(youngs_modulus_1=E, youngs_modulus_2=E, poisson_ratio_1=NU, poisson_ratio_2=NU)
    across, width = 96, 5.0 * EVEN_WIDTH
    half_space = FreeHalfSpace(bodies, shape=(across, 200), pixel_size=(width / across, B / 200))
    x = (np.arange(across) + 0.5 - across / 2) * width / across
    drop = least_pressed_drop(shape, tilt=tilt, **PAIR)

    def elements(factor):
        gap = np.asarray(factor * drop * shape - tilt * Y)
        heights = -(x[:, None] ** 2 / (2.0 * RADIUS) + 0.5 * (gap[1:] + gap[:-1]))
        return float(normal_contact(half_space, heights, normal_force=N, tolerance=1e-4).pressure.max())

    none, half, recommended, double = map(elements, (0.0, 0.5, 1.0, 2.0))
    found = profiled_line(gap=drop * shape - tilt * Y, **PAIR)
    assert float(found.peak_pressure) == pytest.approx(recommended, rel=0.04)
    assert recommended < double < none
    assert recommended < 0.95 * half < none


def test_too_short_a_contact_is_refused():
    short = PAIR | {"contact_length": 1e-3}
    with pytest.raises(NoSolutionError, match="no crown takes up a tilt of 50 mrad"):
        least_pressed_drop(CIRCLE, tilt=50e-3, **short)
