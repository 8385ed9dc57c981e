"""The budget of losses, loss by loss from the powers of single contacts added up by hand."""

import dataclasses
from types import SimpleNamespace

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.rolling.conditions import PLAIN_ROLLING
from asperity.rolling.power import oil_drag, rolling_input_torque, rolling_power

NORMAL = jnp.array([1000.0, 660.0, 465.0, 647.0, 449.0])
TANGENTIAL = jnp.array([46.0, 25.0, 21.0, 25.0, 21.0])
CREEPAGE = jnp.array([7e-4, 4.6e-4, 3.9e-4, 3.7e-4, 3.1e-4])
DRAG = jnp.array([-3.0, 2.0, 2.0, -1.0, -1.0])  # of the oil, with the sign of the rotation
AXIAL, SKEW = jnp.array([40.0, 0.0, 0.0, -10.0, 0.0]), jnp.array([1e-3, 0.0, 0.0, -2e-3, 0.0])
ROLLING = jnp.array([2.0, 2.0, 2.0, 2.0, 2.0])  # the speed at which every contact rolls [m/s]
MOMENT = jnp.array([-1e-3, 2e-3, 2e-3, -1e-3, -2e-3])  # of hysteresis, with the sign of the rotation
FIRST, SECOND = jnp.array([4.0, 13.5, 13.5, 5.0, 5.0]) * 1e-3, jnp.array([13.5, 5.0, 5.0, 40.0, 40.0]) * 1e-3
RADIUS = jnp.array([3e-3, 3.6e-3, 3.6e-3, 5.7e-3, 5.7e-3])
COUNT, CARRIER, SUN, BEARINGS = 3.0, 60.0, 600.0, 36.0


def budget(*, output_torque=5.0, rolling=ROLLING, carrier=CARRIER, **conditions):
    state = SimpleNamespace(
        normal=NORMAL,
        tangential=TANGENTIAL,
        creepage=CREEPAGE,
        drag=DRAG,
        hysteresis_moment=MOMENT,
    )
    speeds = SimpleNamespace(
        rolling=rolling,
        driving=1.001 * rolling,
        driven=0.999 * rolling,
        body=jnp.array([660.0, 200.0, 540.0, 530.0, 60.0]),
        output=jnp.asarray(carrier),
    )
    return rolling_power(
        branches=COUNT,
        pairs=SimpleNamespace(radius_1=FIRST, radius_2=SECOND, sign=jnp.array([1.0, 1.0, 1.0, -1.0, -1.0])),
        conditions=dataclasses.replace(PLAIN_ROLLING, **conditions),
        state=state,
        speeds=speeds,
        axial_force=AXIAL,
        lateral_creepage=SKEW,
        bearing_power=jnp.asarray(BEARINGS),
        output_torque=output_torque,
    )


def test_creep_and_skew_are_force_times_creepage_times_speed():
    found = budget()
    np.testing.assert_allclose(found.creep, COUNT * TANGENTIAL * CREEPAGE * 2.0, rtol=1e-12)
    np.testing.assert_allclose(found.skew, COUNT * AXIAL * SKEW * 2.0, rtol=1e-12)
    assert np.all(np.isnan(found.hysteresis))
    assert np.all(np.isnan(found.oil))
    np.testing.assert_allclose(found.contact, found.creep + found.skew, rtol=1e-12)


def test_hysteresis_and_oil_count_where_they_are_asked_for():
    """The moment turns both bodies, an internal one along; the oil drags both surfaces."""
    found = budget(hysteresis_loss_factor=0.01, viscosity=0.03)
    turned = 2.002 / FIRST + np.array([1.0, 1.0, 1.0, -1.0, -1.0]) * 1.998 / SECOND
    expected = COUNT * np.abs(MOMENT) * turned
    np.testing.assert_allclose(found.hysteresis, expected, rtol=1e-12)
    np.testing.assert_allclose(found.oil, COUNT * 2.0 * np.abs(DRAG) * 2.0, rtol=1e-12)
    np.testing.assert_allclose(
        found.contact, found.creep + found.skew + found.hysteresis + found.oil, rtol=1e-12
    )
    assert float(found.loss) == pytest.approx(float(np.sum(found.contact) + found.bearings), rel=1e-12)


def test_what_enters_is_what_leaves_and_the_losses():
    for torque in (5.0, -5.0):
        found = budget(output_torque=torque)
        assert float(found.input) == pytest.approx(float(found.output + found.loss), rel=1e-12)
        assert float(found.efficiency) == pytest.approx(float(found.output / found.input), rel=1e-12)
    assert float(budget().output) == pytest.approx(5.0 * CARRIER, rel=1e-12)
    assert float(budget(output_torque=-5.0).input) == pytest.approx(5.0 * CARRIER, rel=1e-12)


def test_a_torque_that_drives_less_than_the_losses_leaves_nothing():
    losses = float(budget().loss)
    found = budget(output_torque=-0.5 * losses / CARRIER)
    assert np.isnan(found.output)
    assert np.isnan(found.efficiency)
    assert float(budget(output_torque=-2.0 * losses / CARRIER).efficiency) == pytest.approx(0.5, rel=1e-9)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_the_oil_drags_by_biboulet_and_houperts_force():
    """In full; nothing where nothing rolls."""
    pairs = SimpleNamespace(
        effective_radius=RADIUS, contact_length=5e-3, moduli=SimpleNamespace(contact_modulus=1.13e11)
    )
    found = oil_drag(
        pairs=pairs, viscosity=0.03, normal_force=NORMAL, rolling_speed=ROLLING.at[1].set(0.0), lines=None
    )
    modulus = 2.0 * 1.13e11
    speed = 2.0 * 0.03 * 2.0 / (modulus * RADIUS)
    load = NORMAL / 5e-3 / (modulus * RADIUS)
    stiffness = (1.4 / 1.45) * np.sqrt(load / np.sqrt(speed))
    force = 1.42 * np.sqrt(speed * load) / (1.0 + stiffness**10) ** 0.1 * modulus * RADIUS
    np.testing.assert_allclose(found, 5e-3 * force * np.array([1.0, 0.0, 1.0, 1.0, 1.0]), rtol=1e-12)
    slices = SimpleNamespace(
        line_load=jnp.stack([NORMAL, NORMAL]) / 5e-3, length_share=jnp.array([[0.3], [0.7]])
    )
    sliced = oil_drag(pairs=pairs, viscosity=0.03, normal_force=NORMAL, rolling_speed=ROLLING, lines=slices)
    np.testing.assert_allclose(sliced, 5e-3 * force, rtol=1e-12)


def test_the_motor_feeds_or_is_fed_all_that_passes_the_input():
    """Power at the input over its speed, of either sign; a torque too small to drive the losses needs the motor."""
    for output_torque, sign in ((5.0, 1.0), (-5.0, -1.0)):
        power = budget(output_torque=output_torque)
        at_input = power.input if sign > 0.0 else power.output
        found = rolling_input_torque(
            power=power, output_torque=output_torque, output_speed=-CARRIER, input_speed=SUN
        )
        assert float(found) == pytest.approx(sign * float(at_input) / SUN, rel=1e-12)
    weak = -0.01
    power = budget(output_torque=weak)
    assert np.isnan(power.output)
    speeds = {"output_speed": CARRIER, "input_speed": SUN}
    found = rolling_input_torque(power=power, output_torque=weak, **speeds)
    assert float(found) == pytest.approx((float(power.loss) - 0.01 * CARRIER) / SUN, rel=1e-12)
    still = rolling_input_torque(power=power, output_torque=5.0, output_speed=0.0, input_speed=0.0)
    assert np.isnan(still)
