"""Logarithmic profiles in slices: an independent computation, quadrature and bisection, differences, both shapes."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from asperity.contact.crown_shapes import CrownShape
from asperity.contact.crowned_line import crown_compliance, crown_compression, crowned_line
from asperity.engine.control import at_once

MODULUS = 206e9 / (2.0 * (1.0 - 0.3**2))
RADIUS, B, N = 20e-3 / 3.0, 10e-3, 2000.0  # steel rollers of 10 and 20 mm
LUNDBERG = N / B / (math.pi * MODULUS)
PAIR = {"contact_length": B, "effective_radius": RADIUS, "contact_modulus": MODULUS, "logarithmic": 1.0}


def of_coefficient(coefficient, force=N):
    return at_once(
        lambda force: crowned_line(normal_force=force, crown_curvature=8.0 * coefficient / B**2, **PAIR),
        np.asarray(force),
    )


@pytest.mark.parametrize(("coefficient", "peak"), [(LUNDBERG, 1082.8), (0.00035 * 20e-3, 1383.0)])
def test_peaks_of_an_independent_computation(coefficient, peak):
    found = of_coefficient(coefficient)
    pressure = 2.0 * float(found.line_load[0]) / (math.pi * float(found.half_width[0]))
    assert pressure * 1e-6 == pytest.approx(peak, rel=1e-3)
    assert bool(found.solved)
    assert float(found.end_line_load) == 0.0


def _by_bisection(coefficient, force):
    """Loaded half-length, and load in the middle, of slices of any length: quadrature, and roots one in the other."""

    def load(compression, length):
        def excess(log):
            squared = 4.0 * math.exp(log) * RADIUS / (math.pi * MODULUS)
            line = math.exp(log) / (math.pi * MODULUS)
            return line * (2.0 * math.log(2.0 * length / math.sqrt(math.e * squared)) - 1.0) - compression

        widest = (
            math.pi * MODULUS * (2.0 * length / math.sqrt(math.e) / 3.0) ** 2 / (4.0 * RADIUS)
        )  # of the law
        return math.exp(brentq(excess, -10.0, math.log(widest), xtol=1e-13)) if compression > 1e-13 else 0.0

    def total(approach):
        half = 0.5 * B * math.sqrt(-math.expm1(-approach / coefficient))

        def at(depth):  # y = half (1 - depth^2), denser towards the end
            y = half * (1.0 - depth**2)
            gap = -coefficient * math.log1p(-((2.0 * y / B) ** 2))
            return 2.0 * depth * half * load(approach - gap, 2.0 * half)

        return 2.0 * quad(at, 0.0, 1.0, epsrel=1e-10, limit=200)[0], half, load(approach, 2.0 * half)

    approach = brentq(lambda approach: total(approach)[0] - force, 1e-8, 3e-5, xtol=1e-16)
    return total(approach)[1:]


@pytest.mark.parametrize("coefficient", [0.5 * LUNDBERG, 3.0 * LUNDBERG, 20.0 * LUNDBERG])
@pytest.mark.parametrize("force", [200.0, 2000.0])
def test_load_by_quadrature_and_bisection(coefficient, force):
    half, middle = _by_bisection(coefficient, force)
    found = of_coefficient(coefficient, force)
    assert 0.5 * B * float(found.loaded_share) == pytest.approx(half, rel=1e-3)
    assert float(found.line_load[0]) == pytest.approx(middle, rel=5e-4)
    assert float(np.sum(found.line_load * found.length_share)) * B == pytest.approx(force, rel=1e-9)


@pytest.mark.parametrize("coefficient", [0.5 * LUNDBERG, 10.0 * LUNDBERG])
def test_derivatives(coefficient):
    numbers = PAIR | {"crown_curvature": 8.0 * coefficient / B**2}

    def compression(force, curvature):
        return crown_compression(normal_force=force, **(numbers | {"crown_curvature": curvature}))

    curvature = numbers["crown_curvature"]
    by_force, by_curvature = jax.jit(jax.grad(compression, argnums=(0, 1)))(N, curvature)
    step = 1e-4
    for found, less, more, size in (
        (by_force, (N * (1 - step), curvature), (N * (1 + step), curvature), N),
        (by_curvature, (N, curvature * (1 - step)), (N, curvature * (1 + step)), curvature),
    ):
        difference = (float(compression(*more)) - float(compression(*less))) / (2.0 * step * size)
        assert float(found) == pytest.approx(difference, rel=1e-5)
    compliance = at_once(lambda force: crown_compliance(normal_force=force, **numbers), np.asarray(N))
    assert float(compliance) == pytest.approx(float(by_force), rel=1e-9)


def test_both_shapes_side_by_side_are_each_alone():
    """And with a zero for every contact it is what circles alone are, by another path to the root."""
    curvature = jnp.array([0.3, 0.3, 2.0])
    numbers = {key: value for key, value in PAIR.items() if key != "logarithmic"} | {"normal_force": N}
    both = crowned_line(crown_curvature=curvature, logarithmic=jnp.array([0.0, 1.0, 0.0]), **numbers)
    circles = crowned_line(crown_curvature=curvature, **numbers)
    profiles = crowned_line(crown_curvature=curvature, logarithmic=1.0, **numbers)
    for k, alone in enumerate((circles, profiles, circles)):
        for name in ("line_load", "half_width", "loaded_share", "end_line_load"):
            one, other = getattr(both, name)[..., k], getattr(alone, name)[..., k]
            assert np.asarray(one) == pytest.approx(np.asarray(other), rel=1e-10)


def test_a_light_load_is_that_of_the_circle_in_the_middle():
    """B²/(8A) is the radius there."""
    numbers = {key: value for key, value in PAIR.items() if key != "logarithmic"} | {"normal_force": 2.0}
    curvature = 8.0 * 20.0 * LUNDBERG / B**2
    profile = crowned_line(crown_curvature=curvature, logarithmic=1.0, **numbers)
    circle = crowned_line(crown_curvature=curvature, **numbers)
    assert float(profile.loaded_share) < 0.1
    assert float(profile.line_load[0]) == pytest.approx(float(circle.line_load[0]), rel=2e-3)


def test_slopes_of_the_shapes_are_differences():
    approach, step = np.array([0.05, 0.5, 3.0]), 1e-6
    crown, place = np.array([0.3, 0.2, 0.1]), 0.97
    for logarithmic in (None, np.array([1.0, 0.0, 1.0])):
        less, shape, more = (
            CrownShape(approach * factor, crown, logarithmic) for factor in (1.0 - step, 1.0, 1.0 + step)
        )

        def along(value, less=less, more=more):
            return (value(more) - value(less)) / (2.0 * step)

        assert shape.factor_drift() == pytest.approx(along(CrownShape.length_factor), rel=1e-5, abs=1e-9)
        growth = along(lambda one: np.log(one.loaded_share()))
        assert shape.share_growth() == pytest.approx(growth, rel=1e-5, abs=1e-9)
        slope = shape.slices(place)[1]
        assert slope == pytest.approx(along(lambda one: one.slices(place)[0]), rel=1e-5)
        assert np.all(shape.spread() <= 1.0)
        free = (approach < crown) if logarithmic is None else (approach < crown) | (logarithmic > 0.0)
        assert shape.end_compression() == pytest.approx(np.where(free, 0.0, approach - crown))
