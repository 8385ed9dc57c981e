"""Compliance between contacts: published numbers, thin rings, limits, symmetry, and sums of modes with SciPy."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import j0

from asperity.body.compliance import compliance_matrix, loaded_radius, modes_needed
from asperity.body.shapes import Annulus, Disc
from asperity.contact.hertz_line import (
    logarithmic_compliance,
    ring_secant_compliance,
    roller_secant_compliance,
)

E, NU, L = 206e9, 0.3, 5e-3
STEEL = {"contact_length": L, "youngs_modulus": E, "poisson_ratio": NU}
solve = jax.jit(compliance_matrix, static_argnames=("copies", "mode_count"))


def matrix(body, angles, half_width, copies=1, modes=0, stick=None):
    widths = jnp.broadcast_to(jnp.asarray(half_width, float), (len(angles),))
    sticks = widths if stick is None else jnp.broadcast_to(jnp.asarray(stick, float), (len(angles),))
    return np.asarray(
        solve(
            body=body,
            contact_angles=jnp.asarray(angles, float),
            half_widths=widths,
            stick_half_widths=sticks,
            copies=copies,
            mode_count=modes,
        )
    )


def ring(wall, support=0.0, radius=40e-3, rim="inner", state="plane_strain"):
    return Annulus(radius, radius + wall, L, E, NU, support, support, rim, state)


def modes_of(body, copies=1):
    """As many as the bodies of these tests need at most, so that they share programs."""
    needed = modes_needed(inner_radius=body.inner_radius, outer_radius=body.outer_radius, copies=copies)
    assert needed <= 256
    return 256


# --- discs


def test_disc_between_two_contacts_and_johnson():
    """R 13.5, L 5 mm, a 80 um: 6.205e-9 m/N by a sum of 80 000 modes, which is 2e-4 short; Johnson 6.204e-9."""
    c = matrix(Disc(13.5e-3, L, E, NU, "plane_strain"), [0.0, math.pi], 80e-6)
    both = c[0, 0] + c[0, 1] + c[1, 0] + c[1, 1]
    assert both == pytest.approx(6.205e-9, rel=3e-4)
    scale = logarithmic_compliance(**STEEL)
    secant = roller_secant_compliance(radius=13.5e-3, half_width=80e-6, **STEEL)
    assert both == pytest.approx(2.0 * float(secant - scale), rel=5e-4)


@pytest.mark.parametrize("state", ["plane_strain", "plane_stress"])
def test_disc_by_the_sum_of_its_modes(state):
    kappa = 3 - 4 * NU if state == "plane_strain" else (3 - NU) / (1 + NU)
    radius, angles, a, c = (
        5e-3,
        np.array([0.3, 2.9, 4.5]),
        np.array([1e-4, 2e-4, 1.5e-4]),
        np.array([6e-5, 2e-4, 1e-4]),
    )
    n = np.arange(1.0, 3e5)
    plus, minus = kappa / (n + 1), np.where(n > 1, 1 / np.maximum(n - 1, 1.0), 0.0)
    window = np.clip(2 - 2 * n / n[-1], 0, 1)
    expected = np.zeros((6, 6))
    for i in range(3):
        for j in range(3):
            turn = angles[i] - angles[j]
            pressing, shearing = (j0(n * w[i] / radius) * j0(n * w[j] / radius) for w in (a, c))
            crossed = j0(n * a[i] / radius) * j0(n * c[j] / radius)
            expected[i, j] = 0.5 * (kappa - 1) + np.sum(window * pressing * (plus + minus) * np.cos(n * turn))
            expected[3 + i, 3 + j] = np.sum(window * shearing * (plus + minus) * np.cos(n * turn))
            expected[i, 3 + j] = -np.sum(window * crossed * (plus - minus) * np.sin(n * turn))
            expected[3 + j, i] = expected[i, 3 + j]
    expected /= 4 * math.pi * E / (2 * (1 + NU)) * L
    ours = matrix(Disc(radius, L, E, NU, state), angles, a, stick=c)
    assert ours == pytest.approx(expected, rel=5e-5, abs=1e-7 * expected[0, 0])


def test_uniform_pressure_on_a_disc():
    """Many contacts of equal pressure: u = p R (1 - nu)/E in plane stress."""
    count = 60
    c = matrix(Disc(10e-3, L, E, NU, "plane_stress"), [0.0], 20e-6, copies=count)
    pressure = count / (2 * math.pi * 10e-3 * L)
    # beside the mean, each contact dents its own part of the rim: the half-plane's, periodic over the pitch
    dent = 2 / (math.pi * E * L) * math.log(1.0 / math.sin(20e-6 * count / 10e-3 / 2))
    assert c[0, 0] == pytest.approx(pressure * 10e-3 * (1 - NU) / E + dent, rel=1e-3)


# --- rings


# wall; all six loads, free and held, by sums of 40 000 modes, which are 2.0e-12 short; Weber and Banaschek [m/N]
WALLS = [
    (4e-3, 2.21915e-7, 2.20987e-9, 2.1147e-9),
    (10e-3, 2.43827e-8, 2.71043e-9, 2.6301e-9),
    (60e-3, 4.93787e-9, 3.81412e-9, 3.6379e-9),
]
POLAR = math.radians(13.9248)
SIX = [planet + side * POLAR for planet in 2 * math.pi / 3 * np.arange(3) for side in (-1, 1)]


@pytest.mark.parametrize(("wall", "free", "held", "spring"), WALLS)
def test_ring_of_the_paper(wall, free, held, spring):
    short = 2.0e-12
    for support, expected in ((0.0, free), (math.inf, held)):
        body = ring(wall, support)
        six = matrix(body, SIX, 91.2e-6, modes=modes_of(body))
        assert six[0, :6].sum() == pytest.approx(expected + short, rel=3e-5, abs=0.0)
        sector = matrix(body, SIX[:2], 91.2e-6, copies=3, modes=modes_of(body, 3))
        assert sector[0, :2].sum() == pytest.approx(expected + short, rel=3e-5, abs=0.0)
        folded = np.kron(np.eye(2), np.tile(np.eye(2), (3, 1)))
        assert sector == pytest.approx((six @ folded)[[0, 1, 6, 7]], rel=1e-8, abs=1e-16)
    ours = float(ring_secant_compliance(wall_thickness=wall, half_width=91.2e-6, **STEEL)) - float(
        logarithmic_compliance(**STEEL)
    )
    assert ours == pytest.approx(spring, rel=1e-4, abs=0.0)
    alone = matrix(ring(wall, math.inf), [0.0], 91.2e-6, modes=modes_of(ring(wall)))[0, 0]
    assert alone == pytest.approx(spring, rel=0.05)  # held by a rigid housing: what the spring stands for


def test_loads_on_a_thin_held_ring_do_not_meet():
    body = ring(4e-3, math.inf)
    six = matrix(body, SIX, 91.2e-6, modes=modes_of(body))
    assert six[0, 0] == pytest.approx(six[0, :6].sum(), rel=1e-3)


TABLE = [  # loads, u at a load and midway, times EI/(P R^3): closed forms of ring bending
    (2, 0.07438920, -0.06830989),
    (3, 0.01593859, -0.01425677),
    (4, 0.00607931, -0.00538620),
    (5, 0.00297632, -0.00262524),
    (6, 0.00168182, -0.00147982),
    (8, 0.00069311, -0.00060838),
]


@pytest.mark.parametrize(("count", "at_load", "midway"), TABLE)
def test_thin_ring_under_equal_loads(count, at_load, midway):
    radius, wall = 1.0, 2e-3
    alpha = math.pi / count
    closed = (alpha + math.sin(alpha) * math.cos(alpha)) / math.sin(alpha) ** 2 / 4 - 1 / (2 * alpha)
    assert closed == pytest.approx(at_load, abs=1e-8)
    body = Annulus(radius - wall / 2, radius + wall / 2, 1.0, E, NU, 0.0, 0.0, "inner", "plane_stress")
    c = matrix(body, [0.0, alpha], wall / 50, copies=count, modes=math.ceil(6000 / count))
    unit = radius**3 / (E * wall**3 / 12)
    assert c[0, 0] / unit == pytest.approx(at_load, rel=1e-3)
    assert c[0, 1] / unit == pytest.approx(midway, rel=1e-3)


@pytest.mark.parametrize("count", [2, 3, 6])
@pytest.mark.parametrize("wall", [0.05, 0.1])
def test_curved_beam_with_axial_force_and_shear(count, wall):
    """Midway between the loads against Winkler's curved beam, to 1/E: the squeeze of the wall, which no beam has."""
    alpha, area = math.pi / count, wall
    neutral = wall / math.log((1 + wall / 2) / (1 - wall / 2))
    offset, shear = 1 - neutral, 1.2 * 2 * (1 + NU)
    half = 1 / (2 * math.sin(alpha))

    def moment(psi, mid):
        return mid - half * (1 - math.cos(psi))

    def mean(f):
        return quad(f, 0.0, alpha)[0]

    mid = mean(lambda p: half * (1 - math.cos(p)) / offset + half * math.cos(p)) * offset / alpha
    u = 2 * mean(
        lambda p: (
            moment(p, mid) * moment(alpha - p, 0.0) / (area * offset)
            + half**2 * math.cos(p) * math.cos(alpha - p) / area
            - (moment(p, mid) * half * math.cos(alpha - p) + moment(alpha - p, 0.0) * half * math.cos(p))
            / area
            - shear * half**2 * math.sin(p) * math.sin(alpha - p) / area
        )
    )
    body = Annulus(1 - wall / 2, 1 + wall / 2, 1.0, E, NU, 0.0, 0.0, "inner", "plane_stress")
    c = matrix(body, [0.0, alpha], wall / 50, copies=count, modes=modes_of(body, count))
    assert c[0, 1] * E == pytest.approx(u, rel=5e-3, abs=1.0)


def test_lame_is_the_mean_over_the_rim():
    """The mean radial displacement over the inner rim under one load is that of its uniform part alone."""
    body = ring(10e-3, state="plane_stress")
    points = 720
    angles = np.concatenate([[0.0], 0.01 + 2 * math.pi * np.arange(points) / points])
    c = matrix(body, angles[: points // 8 + 1], 20e-6, copies=8, modes=modes_of(body, 8))
    ratio = (body.outer_radius / body.inner_radius) ** 2
    lame = ((ratio + 1) / (ratio - 1) + NU) / (2 * math.pi * E * L) * 8
    assert np.mean(c[0, 1 : points // 8 + 1]) == pytest.approx(lame, rel=2e-3)


# --- limits


def test_annulus_becomes_a_disc_as_its_bore_closes():
    angles, a = [0.0, 1.0, 3.0], 5e-5
    disc = matrix(Disc(5e-3, L, E, NU, "plane_strain"), angles, a)
    for bore, tolerance in ((5e-5, 1e-3), (5e-6, 1e-5)):
        hollow = Annulus(bore, 5e-3, L, E, NU, 0.0, 0.0, "outer", "plane_strain")
        assert matrix(hollow, angles, a, modes=8) == pytest.approx(disc, abs=tolerance * disc[0, 0])


def test_near_contacts_of_a_thick_ring_see_a_half_plane():
    """Relative motion of two near points of the rim: Flamant's logarithm, -2/(pi E') ln(d/a) from its own depth."""
    a, apart, radius = 2e-5, 1e-3, 40e-3
    for body in (ring(200e-3), Disc(radius, L, E, NU, "plane_strain")):
        c = matrix(body, [0.0, apart / radius], a, modes=12)
        difference = c[0, 0] - c[0, 1]
        assert difference == pytest.approx(
            2 * (1 - NU**2) / (math.pi * E * L) * math.log(2 * apart / a), rel=0.02
        )
        shear = c[2, 2] - c[2, 3]
        assert shear == pytest.approx(
            difference, rel=0.02
        )  # a line contact is as stiff in shear as in compression


def test_a_support_leads_from_free_to_held():
    stiffness = [0.0, 1e8, 1e11, 1e13, 1e15, 1e19, math.inf]
    found = [matrix(ring(10e-3, k), SIX[:2], 91.2e-6, copies=3, modes=30)[0, :2].sum() for k in stiffness]
    assert np.all(np.diff(found) <= 0.0)
    assert found[1] == pytest.approx(found[0], rel=1e-3)
    assert found[-2] == pytest.approx(found[-1], rel=1e-3)


# --- properties


@pytest.mark.parametrize(
    "body",
    [
        Disc(13.5e-3, L, E, NU, "plane_stress"),
        ring(6e-3),
        ring(6e-3, math.inf),
        ring(6e-3, 1e12),
        Annulus(2e-3, 5e-3, L, E, NU, 0.0, 0.0, "outer", "plane_strain"),
        Annulus(2e-3, 5e-3, L, E, NU, math.inf, 0.0, "outer", "plane_strain"),
    ],
)
def test_reciprocal_positive_and_the_same_after_a_turn(body):
    angles, a = np.array([0.1, 1.3, 2.9]), np.array([5e-5, 8e-5, 6e-5])
    modes = 0 if isinstance(body, Disc) else modes_of(body)
    c = matrix(body, angles, a, modes=modes, stick=0.7 * a)
    assert c == pytest.approx(c.T, rel=1e-12, abs=1e-13 * c[0, 0])
    assert np.linalg.eigvalsh(c).min() > 0.0
    assert matrix(body, angles + 2.0, a, modes=modes, stick=0.7 * a) == pytest.approx(c, abs=1e-10 * c[0, 0])
    mirrored = matrix(body, -angles, a, modes=modes, stick=0.7 * a)
    sign = np.array([1.0] * 3 + [-1.0] * 3)
    assert mirrored == pytest.approx(sign[:, None] * c * sign, abs=1e-10 * c[0, 0])


def test_compliance_scales_with_modulus_and_length_alone():
    small, large = Disc(5e-3, L, E, NU, "plane_strain"), Disc(50e-3, L / 3, 3 * E, NU, "plane_strain")
    one, other = matrix(small, [0.0, 2.0], 5e-5), matrix(large, [0.0, 2.0], 5e-4)
    assert other == pytest.approx(one, rel=1e-12, abs=1e-12 * one[0, 0])


def test_shear_of_a_line_contact_in_partial_slip():
    """The stick width in place of the half-width gives C0 + sum (1 - nu^2)/(pi E B) ln[1/(1 - T/mu N)]."""
    a, ratio = 91.2e-6, 0.57
    for body in (Disc(5e-3, L, E, NU, "plane_strain"), ring(60e-3, math.inf)):
        stuck = matrix(body, [0.0], a, modes=20)
        slips = matrix(body, [0.0], a, modes=20, stick=a * math.sqrt(1 - ratio))
        assert slips[0, 0] == stuck[0, 0]
        increase = float(logarithmic_compliance(**STEEL)) * math.log(1 / (1 - ratio))
        assert slips[1, 1] - stuck[1, 1] == pytest.approx(
            increase, rel=0.03
        )  # the half-plane's part of the body


def test_too_few_modes_and_too_wide_contacts_are_no_number():
    assert np.isnan(matrix(ring(1e-3), SIX[:2], 91.2e-6, copies=3, modes=20)).any()
    assert np.isnan(matrix(ring(1e-3), SIX[:2], 0.9e-3, copies=3, modes=400)).any()
    assert np.isfinite(matrix(ring(1e-3), SIX[:2], 91.2e-6, copies=3, modes=400)).all()


@pytest.mark.slow
def test_a_batch_is_its_bodies_one_by_one():
    walls = np.array([8e-3, 20e-3, 60e-3])
    angles, widths = np.array(SIX[:2]), np.array([9e-5, 7e-5])
    batch = solve(
        body=ring(jnp.asarray(walls)),
        contact_angles=jnp.asarray(angles)[:, None],
        half_widths=jnp.asarray(widths)[:, None],
        stick_half_widths=jnp.asarray(widths)[:, None],
        copies=3,
        mode_count=40,
    )
    assert batch.shape == (4, 4, 3)
    for k, wall in enumerate(walls):
        one = matrix(ring(wall), angles, widths, copies=3, modes=40)
        assert np.asarray(batch[..., k]) == pytest.approx(one, rel=1e-12, abs=1e-24)


@pytest.mark.long
@pytest.mark.parametrize("support", [0.0, 1e12, math.inf])
def test_slopes_are_finite_and_those_of_differences(support):
    def energy(p):
        body = Annulus(p[0], p[0] + p[1], L, p[2], p[3], support, support, "inner", "plane_strain")
        c = compliance_matrix(
            body=body,
            contact_angles=jnp.stack([p[4], -p[4]]),
            half_widths=jnp.stack([p[5], p[5]]),
            stick_half_widths=jnp.stack([p[6], p[6]]),
            copies=3,
            mode_count=30,
        )
        force = jnp.array([1.0, -0.5, 0.3, 0.2])
        return force @ c @ force * 1e9

    energy = jax.jit(energy)
    at = jnp.array([40e-3, 10e-3, E, NU, POLAR, 9e-5, 6e-5])
    slope = jax.jit(jax.grad(energy))(at)
    for k in range(at.size):
        step = jnp.zeros_like(at).at[k].set(1e-5 * at[k])
        difference = (energy(at + step) - energy(at - step)) / (2e-5 * at[k])
        assert float(slope[k]) == pytest.approx(float(difference), rel=2e-6, abs=0.0)


def test_loaded_radius_is_that_of_the_contacts():
    assert loaded_radius(Disc(3.0, 1.0, 1.0, 0.3, "plane_strain")) == 3.0
    assert loaded_radius(Annulus(1.0, 2.0, 1.0, 1.0, 0.3, 0.0, 0.0, "inner", "plane_strain")) == 1.0
    assert loaded_radius(Annulus(1.0, 2.0, 1.0, 1.0, 0.3, 0.0, 0.0, "outer", "plane_strain")) == 2.0


def test_modes_needed_grow_as_the_wall_thins():
    thin, thick = (
        modes_needed(inner_radius=40.0, outer_radius=40.0 + wall, copies=1) for wall in (1.0, 10.0)
    )
    assert 400 < thin < 900
    assert (
        thick**2 * (40.0 / 50.0) ** (2 * thick)
        < 1e-10
        < (thick - 1) ** 2 * (40.0 / 50.0) ** (2 * (thick - 1))
    )
    assert modes_needed(inner_radius=40.0, outer_radius=50.0, copies=3) == math.ceil(thick / 3)
