"""Shakedown and first yield: the published values, Melan's theorem by optimisation, and the field itself."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from flamant import flamant_field
from scipy.optimize import minimize, minimize_scalar

from asperity.contact.shakedown import (
    mises_elastic_limit,
    shakedown_limit,
    shear_yield_strength,
    tresca_elastic_limit,
)
from asperity.contact.stress_peaks import mises_friction, mises_peak, shear_peak
from asperity.contact.subsurface_stress import rolling_stress


@pytest.mark.parametrize(
    ("friction", "limit"),
    [
        (0.0, 4.0),
        (0.02, 3.906),
        (0.05, 3.772),
        (0.08, 3.645),
        (0.10, 3.564),
        (0.15, 3.375),
        (0.20, 3.202),
        (0.25, 3.044),
        (0.30, 2.900),
        (0.35, 2.767),
        (0.367, 2.724),
        (0.4, 2.5),
        (1.0, 1.0),
    ],
)
def test_shakedown_limit_of_the_literature(friction, limit):
    """Computed apart from this package; Johnson (1985, section 9.2) gives 4.00 and the kink at 0.367."""
    assert float(shakedown_limit(friction_coefficient=friction)) == pytest.approx(limit, abs=6e-4)


def test_the_surface_takes_over_at_the_published_friction():
    friction = np.linspace(0.36, 0.38, 2001)
    limit = np.asarray(shakedown_limit(friction_coefficient=friction))
    first = friction[np.argmax(np.isclose(limit, 1 / friction, rtol=1e-12))]
    assert first == pytest.approx(0.367, abs=5e-4)


@pytest.mark.parametrize(
    ("friction", "poisson", "criterion"), [(0.1, 0.3, "mises"), (0.3, 0.3, "mises"), (0.36, 0.3, "tresca")]
)
def test_melans_theorem_at_the_limit(friction, poisson, criterion):
    """Residual stresses rho_x(z), rho_y(z) exist that keep every place below yield at the limit, and none above it."""
    limit = float(shakedown_limit(friction_coefficient=friction))
    depths = [1e-3, 0.05, 0.2, *np.linspace(0.33, 0.47, 8), 0.7, 1.2]
    x = np.linspace(-3, 3, 601)
    worst = 0.0
    for depth in depths:
        if depth < 0.01:  # the rule of the line forces needs a depth: at the surface the field is elementary
            inside = np.sqrt(np.maximum(1 - x**2, 0))
            outside = np.where(np.abs(x) > 1, np.sign(x) * np.sqrt(np.maximum(x**2 - 1, 0)), 0)
            sx, sz, t = -inside - 2 * friction * (x - outside), -inside, -friction * inside
        else:
            sx, sz, t = flamant_field(friction, x, np.full_like(x, depth), 800)

        def worst_square(rho, sx=sx, sz=sz, t=t):
            in_plane = ((sx + rho[0] - sz) / 2) ** 2 + t**2
            axial = poisson * (sx + sz) + rho[1] - (sx + rho[0] + sz) / 2
            if criterion == "mises":
                return np.max(in_plane + axial**2 / 3)
            return np.max(np.maximum(np.sqrt(in_plane), (np.sqrt(in_plane) + np.abs(axial)) / 2)) ** 2

        i = np.argmax(np.abs(t))
        starts = ([0.0, 0.2], [sz[i] - sx[i], sz[i] - poisson * (sx[i] + sz[i])])
        best = min(
            minimize(worst_square, s, method="Nelder-Mead", options={"xatol": 1e-7, "fatol": 1e-11}).fun
            for s in starts
        )
        worst = max(worst, np.sqrt(best))
    assert limit * worst == pytest.approx(1.0, abs=1e-3)


def test_mises_limit_at_the_surface_is_lower_beyond_031():
    """What the notes say: with k = Y/sqrt(3) and nu = 0.3 the surface's Mises limit is 9 % lower near 0.367."""
    x = np.linspace(-3, 3, 3001)
    inside = np.sqrt(np.maximum(1 - x**2, 0))
    outside = np.where(np.abs(x) > 1, np.sign(x) * np.sqrt(np.maximum(x**2 - 1, 0)), 0)
    options = {"bounds": (-1, 1), "method": "bounded", "options": {"xatol": 1e-8}}

    def exceeds(friction):
        sx, sz, t = -inside - 2 * friction * (x - outside), -inside, -friction * inside

        def best_axial(along):
            in_plane = ((sx + along - sz) / 2) ** 2 + t**2
            axial = 0.3 * (sx + sz) - (sx + along + sz) / 2
            return minimize_scalar(lambda rho: np.max(in_plane + (axial + rho) ** 2 / 3), **options).fun

        least = np.sqrt(minimize_scalar(best_axial, **options).fun)
        return least * float(shakedown_limit(friction_coefficient=friction))

    assert exceeds(0.31) < 1.0
    assert 1.08 < exceeds(0.366) < 1.09


@pytest.mark.parametrize("friction", [0.05, 0.2, 0.4])
def test_partial_slip_bears_more_than_full_slip_and_less_than_none(friction):
    x, z = np.meshgrid(np.linspace(-1.5, 1.5, 301), np.linspace(0.0, 1.0, 101), indexing="ij")
    full = float(shakedown_limit(friction_coefficient=friction))
    limits = []
    for share in (0.1, 0.5, 0.9, 0.99):
        stress = rolling_stress(
            position=x,
            depth=z,
            half_width=1.0,
            peak_pressure=1.0,
            friction_coefficient=friction,
            slip_ratio=share,
        )
        limits.append(1 / float(jnp.max(jnp.abs(stress.shear))))
    assert np.all(np.diff(limits) <= 0)
    assert full <= limits[-1] * (1 + 1e-12)
    assert limits[0] <= 4.001


@pytest.mark.parametrize("friction", [0.0, 0.1, 0.2, 0.24, 0.3, 0.5])
def test_first_yield_is_the_largest_stress_of_flamants_field(friction):
    x, z = np.meshgrid(np.linspace(-1.2, 1.2, 81), np.linspace(0.05, 1.2, 60), indexing="ij")
    sx, sz, t = flamant_field(friction, x, z, 800)
    inside = np.sqrt(1 - np.linspace(-1, 1, 401) ** 2)
    top = -inside - 2 * friction * np.linspace(-1, 1, 401), -inside, -friction * inside
    sx, sz, t = (np.concatenate([a.ravel(), b]) for a, b in zip((sx, sz, t), top, strict=True))
    in_plane, mean = np.sqrt((sx - sz) ** 2 / 4 + t**2), (sx + sz) / 2
    mises = 1 / np.sqrt(in_plane**2 + 0.16 / 3 * mean**2).max()
    tresca = 1 / np.maximum(in_plane, (in_plane + 0.4 * np.abs(mean)) / 2).max()
    arguments = {"friction_coefficient": friction, "poisson_ratio": 0.3}
    assert float(mises_elastic_limit(**arguments)) == pytest.approx(mises, rel=2e-3)
    assert float(tresca_elastic_limit(**arguments)) == pytest.approx(tresca, rel=2e-3)


def test_first_yield_without_friction_is_johnsons():
    """Johnson 1985, section 6.2: p0 = 3.3 k (Tresca) and 3.1 k (Mises, nu = 0.3)."""
    none = {"friction_coefficient": 0.0, "poisson_ratio": 0.3}
    assert float(mises_elastic_limit(**none)) == pytest.approx(3.107, abs=5e-4)
    assert float(tresca_elastic_limit(**none)) == pytest.approx(3.330, abs=5e-4)


@pytest.mark.long
def test_interpolation_errors_are_those_stated():
    random = np.random.default_rng(2)
    friction = random.uniform(0, 0.366, 40)
    exact = 1 / np.asarray(shear_peak(friction_coefficient=friction).stress)
    np.testing.assert_allclose(shakedown_limit(friction_coefficient=friction), exact, rtol=1e-10)
    poisson = random.uniform(0.19, 0.5, 60)
    friction = random.uniform(0, 1, 60) * mises_friction(poisson)
    peak = 1 / np.asarray(mises_peak(friction_coefficient=friction, poisson_ratio=poisson).stress)
    surface = 1 / np.sqrt(friction**2 + (1 - 2 * poisson) ** 2 / 3 * (1 + friction**2))
    found = mises_elastic_limit(friction_coefficient=friction, poisson_ratio=poisson)
    np.testing.assert_allclose(found, np.minimum(peak, surface), rtol=4e-6)


@pytest.mark.slow
@pytest.mark.parametrize("poisson", [0.0, 0.15, 0.194, 0.3, 0.5])
def test_limits_fall_with_friction_and_have_finite_slopes(poisson):
    friction = jnp.linspace(0.0, 1.0, 501)
    for limit in (
        lambda m: shakedown_limit(friction_coefficient=m),
        lambda m: mises_elastic_limit(friction_coefficient=m, poisson_ratio=poisson),
        lambda m: tresca_elastic_limit(friction_coefficient=m, poisson_ratio=poisson),
    ):
        values, slopes = jax.vmap(jax.value_and_grad(limit))(friction)
        assert np.all(np.diff(values) <= 1e-12)
        assert np.all(np.isfinite(slopes))
        middle = np.asarray(friction[1:-1])
        numeric = (np.asarray(limit(middle + 1e-6)) - np.asarray(limit(middle - 1e-6))) / 2e-6
        kinks = np.abs(np.diff(slopes, append=slopes[-1]))[1:-1] > 0.2 * np.abs(slopes[1:-1])
        np.testing.assert_allclose(np.asarray(slopes)[1:-1][~kinks], numeric[~kinks], rtol=1e-4, atol=1e-5)


def test_shear_yield_strength_by_mises():
    assert float(shear_yield_strength(yield_strength=450e6)) == pytest.approx(259.8e6, rel=1e-4)
