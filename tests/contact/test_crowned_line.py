"""Crowned line contact: Hertz's ellipse, 3-D boundary elements, the cylinder, quadrature and bisection, properties."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from asperity.bem import FreeHalfSpace, PeriodicHalfSpace, elastic_pair, normal_contact
from asperity.bem.stick_stiffness import tangential_stiffness
from asperity.contact.crowned_line import (
    crown_compliance,
    crown_compression,
    crowned_line,
)
from asperity.contact.crowned_shear import crown_shear_compliance
from asperity.contact.hertz_line import effective_radius, half_width

E, NU, B, N = 206e9, 0.3, 10e-3, 2000.0
MODULUS = E / (2 * (1 - NU**2))
RADIUS = float(effective_radius(radius_1=10e-3, radius_2=20e-3, sign=1.0))
PAIR = {"contact_length": B, "effective_radius": RADIUS, "contact_modulus": MODULUS}
STEEL = elastic_pair(youngs_modulus_1=E, youngs_modulus_2=E, poisson_ratio_1=NU, poisson_ratio_2=NU)
EVEN_WIDTH = float(
    half_width(normal_force=N, contact_length=B, effective_radius=RADIUS, contact_modulus=MODULUS)
)


_loaded, _compression = jax.jit(crowned_line), jax.jit(crown_compression)
_compliance, _shear = jax.jit(crown_compliance), jax.jit(crown_shear_compliance)
_slope = jax.jit(jax.grad(lambda k: crown_compression(normal_force=N, crown_curvature=k, **PAIR)))


def loaded(crown_radius, force=N, **changes):
    return _loaded(normal_force=force, crown_curvature=1.0 / crown_radius, **(PAIR | changes))


def compression(crown_radius, force=N, **changes):
    return float(_compression(normal_force=force, crown_curvature=1.0 / crown_radius, **(PAIR | changes)))


def half_space_line(force, length=B):
    """Approach in the middle of an evenly loaded line of this length on half-spaces (Lundberg 1939)."""
    width = math.sqrt(4 * force * RADIUS / (math.pi * MODULUS * length))
    return force / (math.pi * MODULUS * length) * (2 * math.log(2 * length / width) + 1)


def peak_pressure(found):
    return 2 * float(found.line_load[0]) / (math.pi * float(found.half_width[0]))


def test_cylinder_has_an_even_load_and_no_more_approach():
    found = loaded(np.inf)
    np.testing.assert_allclose(found.line_load, N / B, rtol=1e-14)
    np.testing.assert_allclose(found.half_width, EVEN_WIDTH, rtol=1e-14)
    assert float(found.end_line_load) == pytest.approx(N / B, rel=1e-14)
    assert float(found.loaded_share) == 1.0
    assert float(jnp.sum(found.length_share)) == pytest.approx(1.0, rel=1e-15)
    assert abs(compression(np.inf)) < 1e-19


@pytest.mark.parametrize(
    ("axes", "pressure", "approach"),
    [
        (1000.0, 0.007, 0.011),
        (100.0, 0.01, 0.015),
        (10.0, 0.015, 0.022),
        (4.0, 0.021, 0.021),
        (3.0, 0.03, 0.018),
        (2.6, 0.041, 0.02),
    ],
)
def test_hertz_ellipse(axes, pressure, approach):
    """Both on the side of too much, by the ratio of the semi-axes b/a (Johnson 1985, 4.25–4.29)."""
    squared = 1 - axes**-2
    first, second = ellipk(squared), ellipe(squared)
    crown = RADIUS * (axes**2 * second - first) / (first - second)
    a = 1e-4
    peak = MODULUS * axes**2 * a * squared / (2 * crown * (first - second))
    force = 2 / 3 * math.pi * peak * axes * a**2
    length = 20 * axes * a
    found = loaded(crown, force, contact_length=length)
    assert bool(found.solved)
    assert 0 < peak_pressure(found) / peak - 1 < pressure
    more = compression(crown, force, contact_length=length)
    assert 0 < (half_space_line(force, length) + more) / (peak * a * first / MODULUS) - 1 < approach
    assert float(found.loaded_share) * length == pytest.approx(2 * axes * a, rel=0.025)


@pytest.mark.parametrize(("crown", "error"), [(2.0, 2e-3), (0.3, 0.016)])
def test_boundary_elements_between_free_end_faces(crown, error):
    """Half-spaces whose load is mirrored at the end faces, as if these were cut free; error of the largest pressure."""
    rows, across, pixel = 24, 1024, EVEN_WIDTH / 6
    y = (np.arange(rows) - rows / 2 + 0.5) * B / rows
    x = (np.arange(across) - across // 2) * pixel
    bodies = PeriodicHalfSpace(STEEL, shape=(across, rows), pixel_size=(pixel, B / rows))
    heights = -(x[:, None] ** 2 / (2 * RADIUS) + y**2 / (2 * crown))
    elements = np.asarray(normal_contact(bodies, heights, normal_force=N, tolerance=1e-4).pressure)
    found = loaded(crown)
    assert float(found.line_load[0]) == pytest.approx(elements.sum(0).max() * pixel, rel=0.05)
    assert peak_pressure(found) == pytest.approx(elements.max(), rel=error + 0.006)  # of the grid
    lines = np.interp(np.asarray(found.position), y, elements.sum(0) * pixel)
    assert np.abs(lines - found.line_load)[:-1].max() < 0.07 * lines.max()  # the slice at the end aside


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_shear_compliance_against_boundary_elements():
    """An ellipse of 1 : 5.6 on half-spaces: shear along its short axis is 13 % softer than compression; within 3 %."""
    length, force, crown = 20e-3, 500.0, 0.1
    found = loaded(crown, force, contact_length=length)
    a, b = float(found.half_width[0]), 0.5 * float(found.loaded_share) * length
    pixel = (a / 8, b / 24)
    x, y = ((np.arange(n) - n // 2) * step for n, step in zip((19, 55), pixel, strict=True))
    bodies = FreeHalfSpace(STEEL, shape=(19, 55), pixel_size=pixel)
    ellipse = np.asarray(
        normal_contact(
            bodies, -(x[:, None] ** 2 / (2 * RADIUS) + y**2 / (2 * crown)), normal_force=force
        ).pressure
    )
    elements = 1 / float(tangential_stiffness(bodies, ellipse > 0, axis=0).stiffness)
    step = 1e-4 * force
    line = (half_space_line(force + step, length) - half_space_line(force - step, length)) / (2 * step)
    strain = 2 * NU * (1 + NU) / E
    more = _shear(
        stick_force=force,
        crown_curvature=1 / crown,
        lateral_strain_compliance=strain,
        **(PAIR | {"contact_length": length}),
    )
    ours = line + 2 / math.pi * strain / length + float(more)
    assert ours == pytest.approx(elements, rel=0.03)
    normal = _compliance(normal_force=force, crown_curvature=1 / crown, **(PAIR | {"contact_length": length}))
    assert 1.1 < ours / (line + float(normal)) < 1.16


@pytest.mark.parametrize("crown", [30.0, 1.5, 0.2])
def test_load_by_quadrature_and_bisection(crown):
    """The slices' law written anew, integrated adaptively over the line, and solved by bisection."""

    def load(approach):
        end = 0.5 * min(B, 2 * math.sqrt(2 * crown * approach))
        ratio = B**2 / (8 * crown * approach)
        length = B * (1 + ratio**4) ** -0.125
        depth = 2 * length / math.sqrt(math.e)

        def at(y):
            compression = approach - y**2 / (2 * crown)

            def law(line):
                width = math.sqrt(4 * line * RADIUS / (math.pi * MODULUS))
                return line / (math.pi * MODULUS) * (2 * math.log(depth / width) - 1) - compression

            most = math.pi * MODULUS * (depth / 3) ** 2 / (4 * RADIUS)  # near the widest that the law has
            return brentq(law, 1e-12, most, rtol=1e-13) if compression > 0 else 0.0

        return 2 * quad(at, 0, end, epsabs=1e-9, epsrel=1e-9)[0], at

    approach = brentq(lambda delta: load(delta)[0] - N, 1e-7, 3e-5, rtol=1e-11)
    _, at = load(approach)
    found = loaded(crown)
    assert float(found.line_load[0]) == pytest.approx(at(0.0), rel=3e-7)
    assert float(found.end_line_load) == pytest.approx(at(0.5 * B), rel=3e-6)
    assert float(jnp.sum(found.line_load * found.length_share)) * B == pytest.approx(N, rel=1e-13)


@pytest.mark.parametrize("curvature", [1e-3, 0.5, 1.0, 5.0])
def test_derivatives(curvature):
    def added(force, curvature):
        return compression(1 / curvature, force)

    found = _compliance(normal_force=N, crown_curvature=curvature, **PAIR)
    by_curvature = _slope(curvature)
    step = 1e-3
    force = (added(N * (1 + step), curvature) - added(N * (1 - step), curvature)) / (2 * step * N)
    crown = (added(N, curvature * (1 + step)) - added(N, curvature * (1 - step))) / (2 * step * curvature)
    assert float(found) == pytest.approx(float(force), rel=1e-5, abs=1e-14)
    assert float(by_curvature) == pytest.approx(float(crown), rel=1e-5)


def test_derivative_at_the_cylinder_is_a_third_of_the_drop_at_the_ends():
    """A small crown takes its mean height, B^2/24 of the curvature, out of an evenly pressed line."""
    assert float(_slope(0.0)) == pytest.approx(B**2 / 24, rel=1e-12)


def test_lengths_scale():
    """Twice the size, four times the force: the same pressures, twice the approach."""
    size = {"contact_length": 2 * B, "effective_radius": 2 * RADIUS}
    one, two = loaded(0.8), loaded(1.6, 4 * N, **size)
    assert peak_pressure(two) == pytest.approx(peak_pressure(one), rel=1e-13)
    assert float(two.loaded_share) == pytest.approx(float(one.loaded_share), rel=1e-13)
    assert compression(1.6, 4 * N, **size) == pytest.approx(2 * compression(0.8), rel=1e-12)


@pytest.mark.slow
def test_more_crown_shortens_the_loaded_length_and_raises_the_peak():
    curvature = np.concatenate([np.zeros(1), np.geomspace(1e-3, 20.0, 60)])
    found = _loaded(normal_force=N, crown_curvature=curvature, **PAIR)
    assert bool(jnp.all(found.solved))
    assert bool(jnp.all(jnp.diff(found.loaded_share) <= 0.0))
    assert bool(jnp.all(jnp.diff(found.line_load[0]) > 0.0))
    assert bool(jnp.all(jnp.diff(found.end_line_load) <= 0.0))
    assert bool(jnp.all((found.end_line_load == 0.0) == (found.loaded_share < 1.0)))
    added = _compression(normal_force=N, crown_curvature=curvature, **PAIR)
    assert bool(jnp.all(jnp.diff(added) > 0.0))
    shear = _shear(
        stick_force=N, crown_curvature=curvature, lateral_strain_compliance=2 * NU * (1 + NU) / E, **PAIR
    )
    normal = _compliance(normal_force=N, crown_curvature=curvature, **PAIR)
    assert bool(jnp.all(shear >= normal))


def test_a_contact_that_is_too_short_is_not_solved():
    """Twice as long as wide is the least."""
    curvature = np.geomspace(20.0, 80.0, 61)
    found = _loaded(normal_force=N, crown_curvature=curvature, **PAIR)
    aspect = np.asarray(found.loaded_share * B / (2 * found.half_width[0]))
    solved = np.asarray(found.solved)
    assert 2.0 < aspect[solved].min() < 2.1
    assert aspect[~solved].max() < 2.1
    assert bool(loaded(0.03).solved)
    assert not bool(loaded(1e-3).solved)
