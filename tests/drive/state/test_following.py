"""A drive that is loaded step by step, as far as its planets carry together."""

import math
from types import SimpleNamespace
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.drives import planetary_drive
from asperity.drive.layout.unfolding import unfolded
from asperity.drive.mechanism import NormalSprings
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.following import followed
from asperity.drive.state.state import ContactLaws, DriveLoad
from asperity.drive.state.states import state_at_rest

FRICTION, COMPLIANCE = 0.1, 1e-9


@pytest.mark.slow
def test_planets_slip_one_after_the_other_by_hand():
    """Three planets between a held sun and a ring, alike but for their interference.

    A planet passes the same tangential force at both contacts and slips at mu N; its share of the torque at the carrier
    is 2 T (R_s + R_p). The others take over what a slipping planet does not carry, until all slip.
    """
    drive = unfolded(planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=3), sectors=3)
    even = jnp.full(6, COMPLIANCE)
    laws = ContactLaws(
        springs=NormalSprings(secant_compliance=even, incremental_compliance=even),
        reference_force=jnp.full(6, 5000.0),
        creep=CreepLaw(jnp.full(6, FRICTION), jnp.full(6, 1e-4)),
    )
    interference = np.array(
        [12e-6, 10e-6, 4e-6]
    )  # of each planet: sizes at its sun, the ring's 10 um at the ring
    pattern = jnp.array([[own - 10e-6, 10e-6] for own in interference]).ravel() / 10e-6
    load = DriveLoad(output_torque=1.0)
    rest = state_at_rest(drive=drive, laws=laws, pattern=pattern, interference=10e-6, load=load)
    force = interference / (2.0 * COMPLIANCE)
    np.testing.assert_allclose(np.asarray(rest.normal).reshape(3, 2), np.tile(force, (2, 1)).T, rtol=1e-12)
    each = 2.0 * FRICTION * force * 30e-3

    def at(most):
        state, torque = followed(
            drive=drive,
            pressed=lambda torque: (laws, rest),
            load=load,
            first_step=0.05 * each[0],
            most=most,
            keeps=lambda state: jnp.asarray(True),
        )
        carried = 2.0 * 30e-3 * np.abs(np.asarray(state.tangential).reshape(3, 2)[:, 0])
        return state, float(torque), carried

    _, most, carried = at(math.inf)
    assert most == pytest.approx(each.sum(), rel=1e-5)  # up to the deflection of the pins' planets
    state, reached, carried = at(0.9 * each.sum())
    assert reached == pytest.approx(0.9 * each.sum(), rel=1e-12)
    assert float(state.residual) < 1e-9
    assert carried.sum() == pytest.approx(reached, rel=1e-9)
    assert carried[2] == pytest.approx(each[2], rel=1e-5)
    # the two that hold are alike and carry alike, whatever they are pressed with, while neither slips
    assert carried[0] == pytest.approx(carried[1], rel=0.02)


class Balance(NamedTuple):
    residual: jax.Array
    torque: jax.Array
    slides: jax.Array


@pytest.mark.parametrize(
    ("capacity", "sign", "most", "reached"),
    [
        (3e-4, 1.0, math.inf, 3e-4),
        (3e-4, -1.0, 3.5e-4, 3e-4),
        (3e-4, -1.0, 1e-4, 1e-4),
        (math.inf, 1.0, math.inf, 1e-5 * (1.5**400 - 1.0) / 0.5),  # 400 steps, each half as long again
    ],
)
def test_followed_up_to_the_last_torque_that_holds(monkeypatch, capacity, sign, most, reached):
    """Where balances exist up to a torque, the following ends there or at the torque asked for, in its sense."""
    module = "asperity.drive.state.following"
    for name in ("machine_of", "forces_on"):
        monkeypatch.setattr(f"{module}.{name}", lambda *_, **__: None)
    monkeypatch.setattr(f"{module}.started_from", lambda *_: jnp.zeros(()))

    def balance(machine, task, found, *, slides, pressed_sectors):
        return jnp.asarray(task.load.output_torque), slides | True

    def state(machine, task, found, slides):
        assert task.load.pin_compliance == 1e-8
        return Balance(jnp.where(abs(found) > capacity, 1.0, 1e-12), found, slides)

    monkeypatch.setattr(f"{module}.solved", balance)
    monkeypatch.setattr(f"{module}.state_of", state)
    rest = SimpleNamespace(
        interference=jnp.array([1e-6, 2e-6]),
        displacement=jnp.zeros((1, 2)),
        slides=jnp.zeros(2, dtype=bool),
        pin_force=jnp.zeros(1),
        normal=jnp.ones(2),
    )
    found, torque = followed(
        drive=None,
        pressed=lambda torque: (SimpleNamespace(closure=None), rest),
        load=DriveLoad(output_torque=sign * 7.0, pin_compliance=1e-8),
        first_step=1e-5,
        most=most,
        keeps=lambda state: jnp.asarray(True),
    )
    assert float(torque) == pytest.approx(reached, rel=1e-10, abs=0.0)
    assert float(found.torque) == sign * float(torque)  # the balance is that of the torque which is told
    assert np.all(found.slides)
