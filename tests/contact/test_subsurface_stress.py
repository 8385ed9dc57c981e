"""Closed-form stresses against Flamant's solution by quadrature, the surface they start from, and equilibrium."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad

from asperity.contact.carter import rolling_traction
from asperity.contact.hertz_line import axis_shear_stress
from asperity.contact.subsurface_stress import (
    PlaneStress,
    largest_shear_stress,
    mises_stress,
    pressure_stress,
    rolling_stress,
    traction_stress,
)

A, P0, MU = 1.2e-4, 1.0e9, 0.3


def components(stress):
    return np.array([float(v) for v in (stress.longitudinal, stress.normal, stress.shear)])


def flamant(x, z, pressure, traction, width):
    """Johnson 1985, equations (2.23) and section 2.3: a line force presses and pulls at s, summed over the contact."""

    def integral(weight):
        points = [s for s in (x - z, x, x + z) if -width < s < width]
        return quad(weight, -width, width, points=points or None, epsrel=1e-10, limit=400)[0]

    def kernel(power_x, power_z):
        def share(s):
            d = x - s
            square = (d * d + z * z) ** 2
            normal = pressure(s) * d**power_x * z**power_z
            tangent = traction(s) * d ** (power_x + 1) * z ** (power_z - 1)
            return -2 / np.pi * (normal + tangent) / square

        return integral(share)

    return np.array([kernel(2, 1), kernel(0, 3), kernel(1, 2)])


PLACES = [(0.0, 0.786), (-0.866, 0.5), (0.5, 0.3), (1.4, 0.4), (-2.5, 2.0)]


@pytest.mark.parametrize(("across", "down"), PLACES)
def test_pressure_and_full_slip_are_flamant_summed(across, down):
    x, z = across * A, down * A

    def ellipse(s):
        return P0 * np.sqrt(max(1 - (s / A) ** 2, 0.0))

    pressed = pressure_stress(position=x, depth=z, half_width=A, peak_pressure=P0)
    pulled = traction_stress(position=x, depth=z, centre=0.0, half_width=A, peak_traction=MU * P0)
    np.testing.assert_allclose(components(pressed), flamant(x, z, ellipse, lambda s: 0.0, A), rtol=1e-6, atol=1.0)
    np.testing.assert_allclose(
        components(pulled), flamant(x, z, lambda s: 0.0, lambda s: MU * ellipse(s), A), rtol=1e-6, atol=1.0
    )


@pytest.mark.parametrize("share", [0.6, -0.3, 1.0, 0.0])
def test_partial_slip_is_flamant_summed_over_carters_traction(share):
    x, z = 0.35 * A, 0.45 * A

    def ellipse(s):
        return P0 * np.sqrt(max(1 - (s / A) ** 2, 0.0))

    def carter(s):
        return float(
            rolling_traction(
                position=s, slip_ratio=share, half_width=A, peak_pressure=P0, friction_coefficient=MU
            )
        )

    found = rolling_stress(
        position=x, depth=z, half_width=A, peak_pressure=P0, friction_coefficient=MU, slip_ratio=share
    )
    s = A * np.sin(np.linspace(-np.pi / 2, np.pi / 2, 4001))  # one call for the whole traction
    table = np.array(
        rolling_traction(
            position=jnp.array(s), slip_ratio=share, half_width=A, peak_pressure=P0, friction_coefficient=MU
        )
    )
    expected = flamant(x, z, ellipse, lambda v: np.interp(v, s, table), A)
    assert carter(0.0) == pytest.approx(np.interp(0.0, s, table))
    np.testing.assert_allclose(components(found), expected, rtol=2e-5, atol=1e4)


def test_surface_carries_pressure_and_traction():
    """At z = 0: sigma_z = -p, tau_xz = -q; inside sigma_x = -p - 2 mu p0 x/a; outside no pressure and no traction."""
    across = jnp.array([-1.5, -1.0, -0.9, 0.0, 0.4, 1.0, 3.0])
    found = rolling_stress(
        position=across * A, depth=0.0, half_width=A, peak_pressure=P0, friction_coefficient=MU, slip_ratio=1.0
    )
    s = np.array(across)
    pressure = P0 * np.sqrt(np.maximum(1 - s**2, 0.0))
    outside = np.where(np.abs(s) > 1, np.sign(s) * np.sqrt(np.maximum(s**2 - 1, 0.0)), 0.0)
    np.testing.assert_allclose(found.normal, -pressure, atol=1.0)
    np.testing.assert_allclose(found.shear, -MU * pressure, atol=1.0)
    np.testing.assert_allclose(found.longitudinal, -pressure - 2 * MU * P0 * (s - outside), atol=10.0)


@pytest.mark.parametrize("share", [1.0, 0.5])
def test_equilibrium_and_compatibility(share):
    """Divergence of the stress is 0, and sigma_x + sigma_z is harmonic (plane strain, no body force)."""

    def stress(place):
        found = rolling_stress(
            position=place[0],
            depth=place[1],
            half_width=1.0,
            peak_pressure=1.0,
            friction_coefficient=MU,
            slip_ratio=share,
        )
        return jnp.stack([found.longitudinal, found.normal, found.shear])

    for place in ([0.3, 0.4], [-1.3, 0.2], [0.9, 0.1]):
        slope = jax.jacfwd(stress)(jnp.array(place))
        assert float(slope[0, 0] + slope[2, 1]) == pytest.approx(0.0, abs=1e-11)
        assert float(slope[2, 0] + slope[1, 1]) == pytest.approx(0.0, abs=1e-11)
        bend = jax.hessian(lambda p: stress(p)[0] + stress(p)[1])(jnp.array(place))
        assert float(jnp.trace(bend)) == pytest.approx(0.0, abs=1e-9)


def test_axis_and_orthogonal_shear_of_johnson():
    """On the axis tau_1 = p0 (s - s^2/sqrt(1+s^2)); the largest tau_xz is p0/4 at x = -+0.866 a, z = 0.5 a."""
    depth = jnp.linspace(0.0, 3.0, 31) * A
    found = pressure_stress(position=0.0, depth=depth, half_width=A, peak_pressure=P0)
    johnson = axis_shear_stress(depth=depth, peak_pressure=P0, half_width=A)
    np.testing.assert_allclose(largest_shear_stress(stress=found, poisson_ratio=0.5), johnson, atol=10.0)
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
        mises_stress(stress=stress, poisson_ratio=nu), np.sqrt(1.5 * np.sum(deviator**2, axis=(1, 2))), rtol=1e-12
    )
    principal = np.linalg.eigvalsh(tensors)
    np.testing.assert_allclose(
        largest_shear_stress(stress=stress, poisson_ratio=nu), (principal[:, 2] - principal[:, 0]) / 2, rtol=1e-10
    )


@pytest.mark.parametrize("place", [(0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (2.0, 0.0), (0.0, 1e-9), (0.5, 5.0)])
def test_derivatives_are_finite_everywhere(place):
    def whole(x, z, share):
        found = rolling_stress(
            position=x, depth=z, half_width=1.0, peak_pressure=1.0, friction_coefficient=MU, slip_ratio=share
        )
        return mises_stress(stress=found, poisson_ratio=0.3)

    for share in (0.0, 0.5, 1.0):
        slope = jax.grad(whole, argnums=(0, 1, 2))(*place, share)
        assert all(np.isfinite(float(v)) for v in slope)
