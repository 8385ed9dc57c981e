"""The torque under which a joint still rolls: there one contact is at its friction limit."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.mechanism import Bearings
from asperity.joint.rolling_capacity import rolling_torque_capacity
from asperity.joint.rolling_refusal import rolling_capacity_of
from asperity.joint.solve import solve


@pytest.mark.slow
def test_root_search_and_halving_find_the_same_torque_in_either_direction(wedged):
    """Two ways: a search on the slip ratio with derivatives, and halving with the whole joint solved each time."""
    bearings = Bearings(*map(np.asarray, (0.002, 0.001, 0.01, 0.01, 2e-3)))
    joint = dataclasses.replace(wedged, bearings=bearings, sun_speed=np.asarray(100.0))
    direction = jnp.array([1.0, 1.0, 1.0, -1.0])

    def total(preload):
        found = rolling_torque_capacity(dataclasses.replace(joint, preload=preload), direction=direction)
        return jnp.sum(found), found

    slopes, found = jax.jit(jax.grad(total, has_aux=True))(jnp.array([999.0, 1000.0, 1001.0, 1000.0]))
    assert float(slopes[1]) == pytest.approx(float(found[2] - found[0]) / 2.0, rel=1e-6)
    for value, torque in zip(found[jnp.array([1, 3])], (8.0, -8.0), strict=True):
        loaded = dataclasses.replace(joint, output_torque=torque)
        assert float(value) == pytest.approx(
            rolling_capacity_of(loaded, solve(loaded), direction=np.sign(torque)), rel=1e-8
        )
    assert float(found[1]) != pytest.approx(float(found[3]), rel=1e-3)
