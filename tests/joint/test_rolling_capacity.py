"""The torque under which a joint still rolls: there one contact is at its friction limit."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from asperity.joint.rolling_capacity import rolling_torque_capacity
from asperity.joint.rolling_refusal import rolling_capacity_of

from asperity.drive.mechanism import Bearings
from asperity.joint.planar.solve import solve_planar


@pytest.mark.slow
@pytest.mark.parametrize("skew", [None, pytest.param((np.asarray(0.5e-3),), marks=pytest.mark.long)])
def test_root_search_and_extrapolation_find_the_same_torque_in_either_direction(wedged, skew):
    """Two ways: a search on the slip ratio with derivatives, and extrapolation, the whole joint solved each time."""
    bearings = Bearings(*map(np.asarray, (0.002, 0.001, 0.01, 0.01, 2e-3)))
    rolling = dataclasses.replace(wedged.rolling, skew=skew)
    joint = dataclasses.replace(wedged, bearings=bearings, sun_speed=np.asarray(100.0), rolling=rolling)
    direction = jnp.array([1.0, 1.0, 1.0, -1.0])

    def total(preload):
        found = rolling_torque_capacity(dataclasses.replace(joint, preload=preload), direction=direction)
        return jnp.sum(found), found

    slopes, found = jax.jit(jax.grad(total, has_aux=True))(jnp.array([999.0, 1000.0, 1001.0, 1000.0]))
    assert float(slopes[1]) == pytest.approx(float(found[2] - found[0]) / 2.0, rel=1e-6)
    for value, torque in zip(found[jnp.array([1, 3])], (8.0, -8.0), strict=True):
        loaded = dataclasses.replace(joint, output_torque=torque)
        assert float(value) == pytest.approx(
            rolling_capacity_of(loaded, solve_planar(loaded), direction=np.sign(torque)), rel=1e-8
        )
    assert float(found[1]) != pytest.approx(float(found[3]), rel=1e-3)


@pytest.mark.slow
def test_skew_takes_its_share_of_the_friction_at_the_capacity(wedged):
    """At the capacity one contact uses all that skew leaves it, and skew that slips by itself leaves no capacity."""

    def skewed(angle):
        return dataclasses.replace(wedged, rolling=dataclasses.replace(wedged.rolling, skew=(angle,)))

    capacity = jax.jit(lambda angle: rolling_torque_capacity(skewed(angle), direction=1.0))
    parallel, half, whole = (float(capacity(jnp.asarray(angle))) for angle in (0.0, 0.5e-3, 20e-3))
    assert parallel == pytest.approx(float(rolling_torque_capacity(wedged, direction=1.0)), rel=1e-9)
    assert 0.5 * parallel < half < 0.999 * parallel
    assert whole == 0.0
    joint = skewed(np.asarray(0.5e-3))
    at = solve_planar(
        dataclasses.replace(joint, output_torque=np.asarray(half * (1.0 - 1e-9)))
    ).result.rolling
    left = (
        np.asarray(wedged.friction_coefficients[0])
        * np.asarray(at.normal)
        * (1.0 - np.asarray(at.capacity_loss))
    )
    assert np.max(np.abs(np.asarray(at.tangential)) / left) == pytest.approx(1.0, abs=1e-6)
