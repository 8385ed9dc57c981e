"""Hoop stress at the rims: thin-ring bending moments, Lamé, Kirsch's hole and a hollow roller."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hoop_stress import hoop_stress

from asperity.body.shapes import Annulus

E, NU = 206e9, 0.3
stress = jax.jit(hoop_stress, static_argnames="mode_count")


def spread(count, start=0.0):
    return start + 2 * math.pi / count * jnp.arange(count, dtype=float)


@pytest.mark.parametrize(
    ("count", "at_load", "midway"),
    [
        (2, -0.31831, 0.18169),
        (3, -0.18879, 0.09989),
        (4, -0.13662, 0.07049),
        (6, -0.08890, 0.04507),
        (8, -0.06613, 0.03332),
    ],
)
def test_bending_moments_of_a_thin_ring(count, at_load, midway):
    """Outward loads: M/PR as tabulated; positive moments stretch the inner rim. Axial force P cot/2 and P/(2 sin)."""
    wall, alpha = 4e-3, math.pi / count
    body = Annulus(1 - wall / 2, 1 + wall / 2, 1.0, E, NU, 0.0, 0.0, "inner", "plane_stress")
    found = stress(
        body=body,
        contact_angles=spread(count),
        radial_forces=jnp.ones(count),
        tangential_forces=jnp.zeros(count),
        angle=jnp.array([0.0, alpha, 0.1 * alpha, -0.1 * alpha]),
        mode_count=3000,
    )
    bending = 6.0 / wall**2
    outer_load, outer_mid = np.asarray(found.other_rim)[:2]
    inner_mid = float(found.loaded_rim[1])
    assert 0.5 * (inner_mid - outer_mid) / bending == pytest.approx(midway, rel=2e-3)
    axial = (
        0.5 / math.sin(alpha) + 2.0 * midway
    )  # the curved beam's hyperbola adds 2M/R to the mean of both rims
    assert 0.5 * (inner_mid + outer_mid) * wall == pytest.approx(axial, rel=2e-3)
    axial = 0.5 / math.tan(alpha) / wall
    assert -(outer_load - axial) / bending == pytest.approx(
        at_load, rel=2e-2
    )  # the load's own field spreads it by a wall
    assert float(found.loaded_rim[2]) == pytest.approx(float(found.loaded_rim[3]), rel=1e-9)


@pytest.mark.parametrize("rim", ["inner", "outer"])
def test_uniform_pressure_is_lames(rim):
    """Outward pull on one rim by many loads: at the far rim the thick cylinder's hoop stress."""
    count, inner, outer = 48, 1.0, 1.5
    loaded = inner if rim == "inner" else outer
    body = Annulus(inner, outer, 1.0, E, NU, 0.0, 0.0, rim, "plane_strain")
    found = stress(
        body=body,
        contact_angles=spread(count),
        radial_forces=jnp.full(count, 2 * math.pi * loaded / count),
        tangential_forces=jnp.zeros(count),
        angle=jnp.array([0.0, 0.03]),
        mode_count=120,
    )
    squares = outer**2 - inner**2
    expected = 2 * inner**2 / squares if rim == "inner" else 2 * outer**2 / squares
    assert np.asarray(found.other_rim) == pytest.approx(np.full(2, expected), rel=1e-5)


def test_far_loads_make_kirschs_hole():
    """Two opposite pulls on a wide disc with a small hole: uniaxial-like field; 3 s - t and 3 t - s at the hole.

    The disc's own centre stress is t = 6F/(pi D L) along the line of the pulls and s = -2F/(pi D L) across it.
    """
    body = Annulus(0.02, 1.0, 1.0, E, NU, 0.0, 0.0, "outer", "plane_stress")
    found = stress(
        body=body,
        contact_angles=spread(2),
        radial_forces=jnp.ones(2),
        tangential_forces=jnp.zeros(2),
        angle=jnp.array([0.0, 0.5 * math.pi]),
        mode_count=20,
    )
    along, across = 6 / (2 * math.pi), -2 / (2 * math.pi)
    assert np.asarray(found.other_rim) == pytest.approx([3 * across - along, 3 * along - across], rel=5e-3)


def test_tangential_force_beside_itself():
    """A tangential force drags tension behind it: 2F/(pi L d) at a small distance d, on a rim of either kind."""
    near = 1e-3
    for rim in ("inner", "outer"):
        body = Annulus(1.0, 3.0, 1.0, E, NU, math.inf, math.inf, rim, "plane_strain")
        radius = 1.0 if rim == "inner" else 3.0
        found = stress(
            body=body,
            contact_angles=jnp.zeros(1),
            radial_forces=jnp.zeros(1),
            tangential_forces=jnp.ones(1),
            angle=jnp.array([near / radius, -near / radius]),
            mode_count=40,
        )
        tension = 2 / (math.pi * near)
        assert np.asarray(found.loaded_rim) == pytest.approx([-tension, tension], rel=5e-3)


def test_statics_of_a_ring_under_unlike_loads():
    """A radial load at 0, tangential ones at +-90 degrees: N = sin/2 - N_pi cos, M - M_pi = N - N_pi - 1/2."""
    wall = 2e-3
    body = Annulus(1 - wall / 2, 1 + wall / 2, 1.0, E, NU, 0.0, 0.0, "inner", "plane_stress")
    angle = np.array([math.pi, 0.9, 0.4])
    found = stress(
        body=body,
        contact_angles=jnp.array([0.0, 0.5 * math.pi, -0.5 * math.pi]),
        radial_forces=jnp.array([1.0, 0.0, 0.0]),
        tangential_forces=jnp.array([0.0, 0.5, -0.5]),
        angle=jnp.asarray(angle),
        mode_count=6000,
    )
    inner, outer = np.asarray(found.loaded_rim), np.asarray(found.other_rim)
    moment = 0.5 * (inner - outer) * wall**2 / 6.0
    axial = 0.5 * (inner + outer) * wall - 2.0 * moment
    assert axial[1:] == pytest.approx(0.5 * np.sin(angle[1:]) - axial[0] * np.cos(angle[1:]), abs=2e-3)
    assert moment[1:] - moment[0] == pytest.approx(axial[1:] - axial[0] - 0.5, abs=2e-3)


@pytest.mark.slow
def test_slopes_are_finite():
    def peak(p):
        body = Annulus(p[0], p[1], 5e-3, E, NU, 0.0, 0.0, "inner", "plane_strain")
        return hoop_stress(
            body=body,
            contact_angles=spread(3),
            radial_forces=jnp.ones(3),
            tangential_forces=jnp.zeros(3),
            angle=jnp.array([0.0, 1.0]),
            mode_count=100,
        ).other_rim[0]

    at, step = jnp.array([40e-3, 50e-3]), jnp.array([0.0, 1e-7])
    slope = jax.grad(peak)(at)
    difference = (peak(at + step) - peak(at - step)) / 2e-7
    assert bool(jnp.all(jnp.isfinite(slope)))
    assert float(slope[1]) == pytest.approx(float(difference), rel=1e-6)
