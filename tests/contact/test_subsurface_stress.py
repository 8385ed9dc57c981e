"""Closed-form stresses against Flamant's solution by quadrature, the surface they start from, and equilibrium."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.contact.carter import rolling_traction
from asperity.contact.subsurface_stress import (
    PlaneStress,
    mises_stress,
    pressure_stress,
    rolling_stress,
    traction_stress,
)

compiled_rolling_stress = jax.jit(
    rolling_stress
)  # one program for all places, instead of each operation by itself

A, P0, MU = 1.2e-4, 1.0e9, 0.3


def components(stress):
    return np.array([float(v) for v in (stress.longitudinal, stress.normal, stress.shear)])


def flamant(x, z, pressure, traction, width, kink=0.0):
    """Johnson 1985, equations (2.23) and section 2.3: a line force presses and pulls at s, summed over the contact.

    Gauss's rule on both sides of a kink, after a substitution that removes the roots at the ends.
    """
    nodes, weights = np.polynomial.legendre.leggauss(300)
    sums = np.zeros(3)
    for low, high in ((-width, kink), (kink, width)):
        middle, half = (low + high) / 2, (high - low) / 2
        s = middle + half * np.sin(np.pi / 2 * nodes)
        weight = weights * half * np.pi / 2 * np.cos(np.pi / 2 * nodes)
        d = x - s
        p, q = pressure(s), traction(s)
        share = -2 / np.pi * weight / (d * d + z * z) ** 2
        sums += [
            np.sum(share * (p * d**2 * z + q * d**3)),
            np.sum(share * (p * z**3 + q * d * z**2)),
            np.sum(share * (p * d * z**2 + q * d**2 * z)),
        ]
    return sums


def ellipse(s):
    return P0 * np.sqrt(np.maximum(1 - (s / A) ** 2, 0.0))


def nothing(s):
    return 0.0 * s


PLACES = [(0.0, 0.786), (-0.866, 0.5), (0.5, 0.3), (1.4, 0.4), (-2.5, 2.0)]


@pytest.mark.parametrize(("across", "down"), PLACES)
def test_pressure_and_full_slip_are_flamant_summed(across, down):
    x, z = across * A, down * A
    pressed = pressure_stress(position=x, depth=z, half_width=A, peak_pressure=P0)
    pulled = traction_stress(position=x, depth=z, centre=0.0, half_width=A, peak_traction=MU * P0)
    np.testing.assert_allclose(components(pressed), flamant(x, z, ellipse, nothing, A), atol=10.0)
    np.testing.assert_allclose(
        components(pulled), flamant(x, z, nothing, lambda s: MU * ellipse(s), A), atol=10.0
    )


@pytest.mark.parametrize("share", [0.6, -0.3, 1.0, 0.0])
@pytest.mark.parametrize(("across", "down"), [(0.35, 0.45), (-0.8, 0.3)])
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_partial_slip_is_flamant_summed_over_carters_traction(share, across, down):
    x, z = across * A, down * A
    contact = {"half_width": A, "peak_pressure": P0, "friction_coefficient": MU, "slip_ratio": share}

    def carter(s):
        return np.asarray(rolling_traction(position=jnp.asarray(s), **contact))

    found = compiled_rolling_stress(position=x, depth=z, **contact)
    kink = A - 2 * A * np.sqrt(1 - abs(share))
    np.testing.assert_allclose(components(found), flamant(x, z, ellipse, carter, A, kink), atol=1e3)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_surface_carries_pressure_and_traction():
    """At z = 0: sigma_z = -p, tau_xz = -q; inside sigma_x = -p - 2 mu p0 x/a; outside no pressure and no traction."""
    across = jnp.array([-1.5, -1.0, -0.9, 0.0, 0.4, 1.0, 3.0])
    found = rolling_stress(
        position=across * A,
        depth=0.0,
        half_width=A,
        peak_pressure=P0,
        friction_coefficient=MU,
        slip_ratio=1.0,
    )
    s = np.array(across)
    pressure = P0 * np.sqrt(np.maximum(1 - s**2, 0.0))
    outside = np.where(np.abs(s) > 1, np.sign(s) * np.sqrt(np.maximum(s**2 - 1, 0.0)), 0.0)
    np.testing.assert_allclose(found.normal, -pressure, atol=1.0)
    np.testing.assert_allclose(found.shear, -MU * pressure, atol=1.0)
    np.testing.assert_allclose(found.longitudinal, -pressure - 2 * MU * P0 * (s - outside), atol=10.0)


def test_equilibrium_and_compatibility():
    """Divergence of the stress is 0, and sigma_x + sigma_z is harmonic (plane strain, no body force)."""

    def stress(place, share):
        found = rolling_stress(
            position=place[0],
            depth=place[1],
            half_width=1.0,
            peak_pressure=1.0,
            friction_coefficient=MU,
            slip_ratio=share,
        )
        return jnp.stack([found.longitudinal, found.normal, found.shear])

    @jax.jit
    @jax.vmap
    def derivatives(place, share):
        return jax.jacfwd(stress)(place, share), jax.hessian(lambda p: jnp.sum(stress(p, share)[:2]))(place)

    places = jnp.array([[0.3, 0.4], [-1.3, 0.2], [0.9, 0.1]])
    slopes, bend = derivatives(jnp.concatenate([places, places]), jnp.repeat(jnp.array([1.0, 0.5]), 3))
    np.testing.assert_allclose(slopes[:, 0, 0] + slopes[:, 2, 1], 0.0, atol=1e-11)
    np.testing.assert_allclose(slopes[:, 2, 0] + slopes[:, 1, 1], 0.0, atol=1e-11)
    np.testing.assert_allclose(bend[:, 0, 0] + bend[:, 1, 1], 0.0, atol=1e-9)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_axis_and_orthogonal_shear_of_johnson():
    """On the axis tau_1 = p0 (s - s^2/sqrt(1+s^2)); the largest tau_xz is p0/4 at x = -+0.866 a, z = 0.5 a."""
    depth = jnp.linspace(0.0, 3.0, 31) * A
    found = pressure_stress(position=0.0, depth=depth, half_width=A, peak_pressure=P0)
    ratio = depth / A
    johnson = P0 * (ratio - ratio**2 / np.sqrt(1 + ratio**2))
    np.testing.assert_allclose(0.5 * abs(found.longitudinal - found.normal), johnson, atol=10.0)
    at = pressure_stress(
        position=jnp.sqrt(0.75) * A * jnp.array([-1.0, 1.0]), depth=0.5 * A, half_width=A, peak_pressure=P0
    )
    np.testing.assert_allclose(at.shear, [0.25 * P0, -0.25 * P0], rtol=1e-12)


def test_equivalent_stresses_of_the_principal_stresses():
    random = np.random.default_rng(5)
    sx, sz, t = random.normal(size=(3, 50))
    nu = 0.3
    stress = PlaneStress(jnp.array(sx), jnp.array(sz), jnp.array(t))
    tensors = np.zeros((50, 3, 3))
    tensors[:, 0, 0], tensors[:, 1, 1], tensors[:, 2, 2] = sx, nu * (sx + sz), sz
    tensors[:, 0, 2] = tensors[:, 2, 0] = t
    deviator = tensors - np.trace(tensors, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
    np.testing.assert_allclose(
        mises_stress(stress=stress, poisson_ratio=nu),
        np.sqrt(1.5 * np.sum(deviator**2, axis=(1, 2))),
        rtol=1e-12,
    )


def test_derivatives_are_finite_everywhere():
    """In the middle, at both edges, outside, nearly at the surface and far below it, without and with traction."""
    places = np.array([(0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (2.0, 0.0), (0.0, 1e-9), (0.5, 5.0)])

    def whole(x, z, share):
        found = rolling_stress(
            position=x, depth=z, half_width=1.0, peak_pressure=1.0, friction_coefficient=MU, slip_ratio=share
        )
        return mises_stress(stress=found, poisson_ratio=0.3)

    slopes = jax.jit(jax.vmap(jax.grad(whole, argnums=(0, 1, 2))))
    for by in slopes(*np.tile(places, (3, 1)).T, np.repeat([0.0, 0.5, 1.0], 6)):
        assert np.all(np.isfinite(by))
