"""States of every drive: forces by hand, energy, the wedge drive's own solver, and published figures."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from steel_laws import steel_laws

from asperity.drive.layout.drive import incidence, speed_ratio
from asperity.drive.state.creep import creepages
from asperity.drive.state.state import STATE_TOLERANCE, Creeping, DriveLoad
from asperity.drive.state.states import loaded_state, rolling_state, state_at_rest

NAMES = ["wedge", "planetary", "multiroller", "stepped"]
TORQUE = {"wedge": 5.0, "planetary": 8.0, "multiroller": 20.0, "stepped": 6.0}


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_states_are_solved_and_balanced(drives, solved, name):
    drive = drives[name]
    rest, rolling = solved(name, TORQUE[name])
    assert float(rest.residual) < STATE_TOLERANCE
    assert float(rolling.residual) < STATE_TOLERANCE
    matrices = incidence(drive)
    for state in (rest, rolling):
        force = matrices.approach.T @ state.normal + matrices.sliding.T @ state.tangential
        np.testing.assert_allclose(force + matrices.pins.T @ state.pin_force, 0.0, atol=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_power_lost_is_the_power_of_creep(drives, solved, name):
    _, found = solved(name, TORQUE[name])
    drive = drives[name]
    creep_power = drive.sectors * float(found.tangential @ (incidence(drive).turning @ found.speed))
    power_out = TORQUE[name] * abs(float(found.speed[drive.members.index(drive.output)]))
    assert float(found.input_torque) - power_out == pytest.approx(creep_power, rel=1e-9)
    assert creep_power > 0.0
    # without slip the torques have the ratio of the speeds
    assert float(found.input_torque) == pytest.approx(TORQUE[name] / abs(float(speed_ratio(drive))), rel=1e-9)


@pytest.mark.slow
def test_wedge_at_rest_by_hand(solved):
    rest, _ = solved("wedge", 5.0)
    theta, beta = math.radians(27.0831), math.radians(13.1582)
    side = 500.0 / math.cos(theta)
    ring = side * math.cos(beta)
    np.testing.assert_allclose(rest.normal, [1000.0, side, side, ring, ring], rtol=1e-5)


@pytest.mark.slow
def test_wedge_rolling_as_computed_independently(solved):
    """The reference turns its contacts with the displacements: 0.15 N of 1000 N for a micrometre and millimetre.

    Half of this torque is one of the checks of the installation.
    """
    _, found = solved("wedge", 10.0)
    np.testing.assert_allclose(found.normal, [1007.78, 753.13, 367.42, 746.43, 349.72], atol=0.8)
    np.testing.assert_allclose(np.abs(found.tangential[:3]), [92.5926, 57.3155, 35.2771], rtol=1.5e-3)
    assert float(found.speed_loss) == pytest.approx(3.905719e-3, rel=3e-4)
    assert abs(float(found.displacement[0, 0])) == pytest.approx(5.1111e-6, rel=5e-3)


def test_planetary_by_hand(solved):
    rest, found = solved("planetary", 8.0)
    np.testing.assert_allclose(rest.normal, 1000.0, rtol=1e-12)  # sun and ring press the planet alike
    # the carrier pushes each planet with T_out/(3 orbit); sun and ring take half of it each
    np.testing.assert_allclose(np.abs(found.tangential), 8.0 / (3.0 * 30e-3) / 2.0, rtol=1e-12)
    np.testing.assert_allclose(np.abs(found.pin_force), 8.0 / (3.0 * 30e-3), rtol=1e-12)
    one, two = (abs(float(creep)) for creep in found.creepage)
    assert float(found.speed_loss) == pytest.approx((one + two) * 50.0 / 60.0, rel=2e-3)


def test_plain_planetary_with_a_published_sun_contact(drives, solved):
    # T1: radii 10 and 20 mm, 10 mm long, 2000 N, mu .1, q .5: creepages 5.381e-4 and 2.406e-4, 0.234 degrees a turn;
    # creepage scales with mu, and the pressure of 1000 N over 5 mm is the same
    torque = 0.5 * 0.12 * 1000.0 * 2.0 * 3.0 * 30e-3
    _, found = solved("planetary", torque)
    np.testing.assert_allclose(np.abs(found.creepage), 1.2 * np.array([5.3806e-4, 2.406e-4]), rtol=2e-4)
    assert float(found.speed_loss) / 1.2 * 360.0 == pytest.approx(0.234, rel=3e-3)


def test_interference_grows_with_preload_as_the_logarithmic_law(solved):
    soft, hard = solved("planetary", 1.0, preload=500.0)[0], solved("planetary", 1.0, preload=2000.0)[0]
    ratio = float(hard.interference[1] / soft.interference[1])
    assert 3.5 < ratio < 4.0  # a little less than four times the load: the strips grow wider


@pytest.mark.slow
def test_drift_is_odd_in_the_torque(solved):
    for name in NAMES:
        _, one = solved(name, 0.2 * TORQUE[name])
        _, other = solved(name, -0.2 * TORQUE[name])
        assert float(other.speed_loss) == pytest.approx(
            -float(one.speed_loss), rel=4.0 * float(one.speed_loss)
        )


@pytest.mark.slow
def test_gradient_of_the_loss(solved):
    def loss(torque):
        return solved("planetary", torque)[1].speed_loss

    expected = (loss(8.0 + 1e-3) - loss(8.0 - 1e-3)) / 2e-3
    assert float(jax.grad(loss)(8.0)) == pytest.approx(float(expected), rel=1e-6)


def test_gross_slip_is_not_a_state(solved):
    _, found = solved("planetary", 40.0)  # 222 N of 120
    assert not bool(found.residual < STATE_TOLERANCE)
    assert jnp.isfinite(solved("planetary", 10.0)[1].residual)


def _grown_law(law, normal, tangential):
    """A creep law whose size depends on both forces."""
    used = jnp.abs(tangential) / (law.friction_coefficient * normal)
    grown = law.gross_slip_scale * (1.0 + normal / 2000.0 + used**2)
    return dataclasses.replace(law, gross_slip_scale=grown)


def _grown(law, normal, tangential):
    """Creep by it."""
    creepage = creepages(law=_grown_law(law, normal, tangential), normal=normal, tangential=tangential)
    return Creeping(creepage, law.friction_coefficient * normal, jnp.zeros_like(normal))


@pytest.mark.slow
def test_the_creep_law_under_the_forces_is_met_by_the_rolling_state(drives):
    """By passes with the law around the forces of the last pass, until they stay; its derivative by differences."""
    drive = drives["planetary"]

    @jax.jit
    def states(torque):
        laws = steel_laws(drive=drive)
        rest = state_at_rest(drive=drive, laws=laws, pattern=jnp.array([0.0, 1.0]), preload=1000.0)

        def at_once(torque):
            found = loaded_state(
                drive=drive,
                laws=laws,
                rest=rest,
                load=DriveLoad(torque),
                rolls=True,
                creep_of=jax.tree_util.Partial(_grown, laws.creep),
            )
            return found.speed_loss, found

        def once_more(_, before):
            around = dataclasses.replace(laws, creep=_grown_law(laws.creep, before.normal, before.tangential))
            return rolling_state(
                drive=drive, laws=around, interference=rest.interference, output_torque=torque, start=before
            )

        _, slope, found = jax.jvp(at_once, (torque,), (jnp.ones_like(torque),), has_aux=True)
        passed = jax.lax.fori_loop(0, 20, once_more, once_more(0, rest))
        ends = [at_once(torque + way)[0] for way in (1e-3, -1e-3)]
        return found, passed, slope, (ends[0] - ends[1]) / 2e-3

    found, passed, slope, expected = states(jnp.asarray(15.0))  # 83 N of 120
    assert float(found.residual) < STATE_TOLERANCE
    np.testing.assert_allclose(found.creepage, passed.creepage, rtol=1e-9)
    np.testing.assert_allclose(found.tangential, passed.tangential, rtol=1e-9)
    assert float(slope) == pytest.approx(float(expected), rel=1e-6)
