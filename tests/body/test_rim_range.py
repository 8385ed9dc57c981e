"""Stresses along the rims under passing contacts: thin rings, Lamé, other sums of the same fields, statics, fatigue."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hoop_stress import hoop_stress

from asperity.body.compliance import wall_of
from asperity.body.rim_range import (
    MODES,
    POINTS,
    RimLoads,
    _resolved,
    fatigue_safety,
    mises_stress,
    rim_range,
    rim_stresses,
)
from asperity.body.shapes import Annulus

E, NU = 206e9, 0.3
summed = jax.jit(hoop_stress, static_argnames="mode_count")
stresses = jax.jit(lambda body, loads: rim_stresses(body=body, loads=loads))


def ring(wall, support=0.0, radius=1.0, length=1.0, state="plane_strain", shear_support=None):
    shear = support if shear_support is None else shear_support
    return Annulus(
        radius, radius + wall, length, E, NU, np.asarray(support), np.asarray(shear), "inner", state
    )


def load(angles, radial, tangential, sectors, width=1e-4):
    angles = np.asarray(angles)
    return RimLoads(
        angles,
        np.asarray(radial) * np.ones_like(angles),
        np.asarray(tangential) * np.ones_like(angles),
        width * np.ones_like(angles),
        sectors,
    )


@pytest.mark.parametrize(
    ("count", "at_load", "midway"),
    [
        (3.0, -0.18879, 0.09989),
        (4.0, -0.13662, 0.07049),
        (6.0, -0.08890, 0.04507),
        (8.0, -0.06613, 0.03332),
    ],
)
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_bending_of_a_thin_ring(count, at_load, midway):
    """M/PR as tabulated, with the axial force: mean and amplitude of the outer rim, whose extremes are these two."""
    wall, alpha = 0.025, math.pi / count
    body = ring(wall, radius=1.0 - wall / 2.0, state="plane_stress")
    found = rim_range(body=body, stresses=stresses(body, load([0.0], 1.0, 0.0, count)))
    bending = 6.0 / wall**2
    high = -at_load * bending + 0.5 / math.tan(alpha) / wall
    low = -midway * bending + 0.5 / math.sin(alpha) / wall
    assert float(found.amplitude[1]) == pytest.approx(0.5 * (high - low), rel=4e-2)
    assert float(found.largest[1]) == pytest.approx(
        high, rel=6e-2
    )  # the load's own field spreads it by a wall
    assert float(found.mean[1]) == pytest.approx(0.5 * (high + low), rel=4e-2)
    # the inner rim is stretched midway; the curved beam's hyperbola adds a wall over the radius
    inner = midway * bending + 0.5 / math.sin(alpha) / wall
    assert float(found.largest[0]) == pytest.approx(inner, rel=3e-2)


def test_even_pressure_is_lames():
    count, inner, outer = 48.0, 1.0, 1.5
    body = ring(outer - inner)
    found = stresses(body, load([0.0], 2.0 * math.pi * inner / count, 0.0, count))
    expected = 2.0 * inner**2 / (outer**2 - inner**2)
    assert np.asarray(found.other_hoop) == pytest.approx(np.full(POINTS + 3, expected), rel=1e-5)
    assert np.asarray(found.other_radial) == pytest.approx(np.zeros(POINTS + 3), abs=1e-5)
    # a pressure p makes the hoop stress -p under itself: even pressure has it everywhere, point loads nowhere between
    between = (outer**2 + inner**2) / (outer**2 - inner**2) + 1.0
    assert float(found.loaded_hoop[POINTS + 2]) == pytest.approx(between, rel=1e-6)


def test_even_pressure_in_a_rigid_housing():
    """Lamé with no displacement at the outer rim: A = C (1 + ...)/b^2; plane strain, k = 3 - 4 nu."""
    count, inner, outer = 60.0, 1.0, 1.3
    found = stresses(ring(outer - inner, math.inf), load([0.0], 2.0 * math.pi * inner / count, 0.0, count))
    # s_r = A - C/r^2, 2 G u/r = (k - 1)/2 A + C/r^2 = 0 at the outer rim, s_r = -1 at the inner one
    even = np.linalg.solve([[1.0, -1.0 / inner**2], [1.0 - 2.0 * NU, 1.0 / outer**2]], [-1.0, 0.0])
    assert float(found.other_radial[3]) == pytest.approx(even[0] - even[1] / outer**2, rel=1e-5)
    assert float(found.other_hoop[3]) == pytest.approx(even[0] + even[1] / outer**2, rel=1e-5)


@pytest.mark.parametrize(("support", "along"), [(0.0, 0.0), (5e13, 2e12), (math.inf, math.inf)])
def test_sum_over_all_contacts(support, along):
    """The same as hoop_stress of all six contacts, whose sums are others, contact by contact."""
    apart, wall = math.radians(13.9248), 10e-3
    body = ring(wall, support, radius=40e-3, length=5e-3, shear_support=along)
    radial, tangential = np.array([647.0, 449.0]), np.array([-27.0, -19.0])
    found = stresses(body, load([0.5 - apart, 0.5 + apart], radial, tangential, 3.0))
    grid = np.arange(POINTS) / POINTS * 2.0 * math.pi / 3.0
    branches = 2.0 * math.pi / 3.0 * np.arange(3)
    every = np.add.outer(branches, [0.5 - apart, 0.5 + apart]).ravel()
    by_sum = summed(
        body=body,
        contact_angles=np.asarray(every),
        radial_forces=jnp.tile(radial, 3),
        tangential_forces=jnp.tile(tangential, 3),
        angle=np.asarray(grid),
        mode_count=400,
    )
    beside = ~np.isnan(np.asarray(found.loaded_hoop[:POINTS]))
    assert beside.sum() > POINTS - 8
    scale = float(jnp.max(jnp.abs(by_sum.other_rim)))
    assert np.asarray(found.other_hoop[:POINTS]) == pytest.approx(
        np.asarray(by_sum.other_rim), abs=1e-9 * scale
    )
    assert np.asarray(found.loaded_hoop[:POINTS])[beside] == pytest.approx(
        np.asarray(by_sum.loaded_rim)[beside], abs=1e-8 * scale
    )


@pytest.mark.slow
def test_one_body_between_three_contacts():
    """A hollow planet: sums of one sector, with its mode 1."""
    body = Annulus(6e-3, 13.5e-3, 5e-3, E, NU, 0.0, 0.0, "outer", "plane_strain")
    angles = np.array([-0.5 * math.pi, 1.0981, 2.0435])
    push, drag = np.array([-1001.0, -657.0, -465.0]), np.array([46.3, -27.1, -19.2])
    found = stresses(body, load(angles, push, drag, None))
    grid = np.arange(POINTS) / POINTS * 2.0 * math.pi
    by_sum = summed(
        body=body,
        contact_angles=angles,
        radial_forces=push,
        tangential_forces=drag,
        angle=np.asarray(grid),
        mode_count=80,
    )
    beside = ~np.isnan(np.asarray(found.loaded_hoop[:POINTS]))
    for ours, theirs in ((found.other_hoop, by_sum.other_rim), (found.loaded_hoop, by_sum.loaded_rim)):
        scale = float(jnp.max(jnp.abs(theirs[beside])))
        assert np.asarray(ours[:POINTS])[beside] == pytest.approx(
            np.asarray(theirs)[beside], abs=1e-9 * scale
        )
    assert np.asarray(found.other_radial) == pytest.approx(np.zeros(POINTS + 5), abs=1e-6 * scale)
    assert np.asarray(found.other_shear) == pytest.approx(np.zeros(POINTS + 5), abs=1e-6 * scale)


def test_the_housing_takes_the_torque_and_every_sector_its_push():
    """Tractions of the outer rim by quadrature: their moment is that of the drag, their push along a sector's axis
    that of the loads and of the hoop forces in the two cuts."""
    apart, radius, wall, length = 0.24, 40e-3, 6e-3, 5e-3
    body = ring(wall, math.inf, radius=radius, length=length)
    push, drag = np.array([600.0, 450.0]), np.array([-27.0, -19.0])
    found = stresses(body, load([-apart, apart], push, drag, 3.0))
    outer = radius + wall
    step = 2.0 * math.pi / 3.0 / POINTS * outer * length
    torque = float(jnp.sum(found.other_shear[:POINTS])) * step * outer
    # the ring turns with the drag, its outer rim holds it back: positive shear there drags the ring on
    assert torque == pytest.approx(-float(jnp.sum(drag)) * radius, rel=1e-9)
    assert float(jnp.min(found.other_radial)) < -1e6


def test_held_and_free_rims_enter_the_equivalent_stress():
    assert float(
        mises_stress(first=3.0, second=0.0, shear=0.0, poisson_ratio=0.3, plane_state="plane_stress")
    ) == pytest.approx(3.0)
    strain = {"poisson_ratio": 0.3, "plane_state": "plane_strain"}
    assert float(mises_stress(first=3.0, second=0.0, shear=0.0, **strain)) == pytest.approx(
        3.0 * math.sqrt(1.0 - 0.3 + 0.09)
    )
    # by the eigenvalues of the stress
    s = np.array([[2.0, 1.5, 0.0], [1.5, -1.0, 0.0], [0.0, 0.0, 0.3 * (2.0 - 1.0)]])
    a, b, c = np.linalg.eigvalsh(s)
    expected = math.sqrt(0.5 * ((a - b) ** 2 + (b - c) ** 2 + (c - a) ** 2))
    assert float(mises_stress(first=2.0, second=-1.0, shear=1.5, **strain)) == pytest.approx(expected)
    assert float(mises_stress(first=0.0, second=0.0, shear=0.0, **strain)) == 0.0


def test_line_of_haighs_diagram():
    line = {"fatigue_strength": 300e6, "strength": 900e6}
    assert float(fatigue_safety(mean=0.0, amplitude=150e6, **line)) == pytest.approx(2.0)
    assert float(fatigue_safety(mean=450e6, amplitude=0.0, **line)) == pytest.approx(2.0)
    assert float(fatigue_safety(mean=-450e6, amplitude=150e6, **line)) == pytest.approx(2.0)  # no help
    assert float(fatigue_safety(mean=450e6, amplitude=150e6, **line)) == pytest.approx(1.0)


@pytest.mark.parametrize(("sectors", "fineness"), [(3.0, 1), (1.0, 1), (1.0, 3)])
def test_modes_left_out_are_a_ten_thousandth_of_the_stress_at_most(sectors, fineness):
    """Stresses of the other rim go as n^2 times the decay; the thinnest wall whose rest, summed here, is small."""
    walls = np.geomspace(0.005, 0.15, 161)
    modes = sectors * np.arange(1, 12_000)[:, None]
    terms = modes**2 * (1.0 + walls) ** -modes
    share = terms[fineness * MODES :].sum(axis=0) / terms.sum(axis=0)
    resolved = np.asarray(_resolved(wall_of(ring(walls)), np.asarray(sectors), fineness))
    assert share[resolved].max() == pytest.approx(1e-4, rel=0.3)
    assert resolved.sum() == np.argmin(resolved[::-1])  # all thicker ones


def test_too_thin_a_wall_has_no_stress_and_slopes_are_finite():
    thin = ring(0.005)
    assert bool(jnp.all(jnp.isnan(stresses(thin, load([0.0], 1.0, 0.0, 3.0)).other_hoop)))

    @jax.jit
    def largest(wall):
        body = ring(wall, radius=40e-3)
        return rim_range(
            body=body, stresses=rim_stresses(body=body, loads=load([0.2], 1.0, 0.3, 3.0))
        ).largest

    _, slope = jax.jvp(largest, (10e-3,), (1.0,))
    difference = (largest(10.01e-3) - largest(9.99e-3)) / 2e-5
    assert np.asarray(slope) == pytest.approx(np.asarray(difference), rel=1e-4)
