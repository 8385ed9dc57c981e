"""Stiffness of drives with given springs: by hand, by virtual work, and with shafts."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.drive import speed_ratio
from asperity.drive.layout.unfolding import unfolded
from asperity.drive.normal_springs import NormalSprings
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.state import STATE_TOLERANCE, ContactLaws, DriveLoad
from asperity.drive.state.states import drive_states
from asperity.drive.state.supports import carrier_supports
from asperity.drive.stiffness.network import network_stiffness, with_shafts
from asperity.drive.types.planetary import planetary_drive
from asperity.drive.types.stepped_planet import stepped_planet_drive

ORBIT, COUNT = 30e-3, 3


@pytest.fixture(scope="module")
def planetary():
    return planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=COUNT)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_planetary_by_hand(planetary):
    """The carrier turns by the slips of both contacts over twice the orbit, and by its pins over the orbit."""
    tangential = jnp.array([2e-9, 3e-9])
    held = network_stiffness(drive=planetary, normal_compliance=None, tangential_compliance=tangential)
    assert float(held.output) == pytest.approx(COUNT * (2.0 * ORBIT) ** 2 / 5e-9, rel=1e-12)
    np.testing.assert_allclose(held.tangential_share, [0.4, 0.6], rtol=1e-12)
    np.testing.assert_allclose(np.abs(held.tangential_force), 1.0 / (COUNT * 2.0 * ORBIT), rtol=1e-12)
    floating = network_stiffness(
        drive=planetary,
        normal_compliance=jnp.array([1e-9, 4e-9]),
        tangential_compliance=tangential,
        pin_compliance=7e-9,
    )
    compliance = (5e-9 / 4.0 + 7e-9) / (COUNT * ORBIT**2)
    assert 1.0 / float(floating.output) == pytest.approx(compliance, rel=1e-12)
    np.testing.assert_allclose(
        floating.normal_share, 0.0, atol=1e-12
    )  # radial springs bear no tangential force
    assert float(floating.pin_share) == pytest.approx(7e-9 / (7e-9 + 5e-9 / 4.0), rel=1e-9)


def test_coupling_adds_its_work(planetary):
    """A mutual compliance m of the two tangential springs adds 2 m T_1 T_2."""
    drive, mutual = planetary, 0.4e-9
    coupling = jnp.zeros((4, 4)).at[2, 3].set(mutual).at[3, 2].set(mutual)
    springs = {"normal_compliance": jnp.full(2, 1e-9), "tangential_compliance": jnp.array([2e-9, 3e-9])}
    alone = network_stiffness(drive=drive, **springs)
    coupled = network_stiffness(drive=drive, **springs, coupling=coupling)
    one, two = (float(force) for force in alone.tangential_force)
    assert 1.0 / float(coupled.output) - 1.0 / float(alone.output) == pytest.approx(
        COUNT * 2.0 * mutual * one * two, rel=1e-9
    )


@pytest.mark.slow
def test_stepped_planets_by_virtual_work():
    """Each spring adds n T^2 c: the driven ring's force 1/(n R_2), the sun's by the ratio, the held ring's balances."""
    drive = stepped_planet_drive(sun_radius=10e-3, planet_radii=(20e-3, 18e-3), planet_count=3)
    ratio = float(speed_ratio(drive))
    sun, ring = 1.0 / ratio / (3.0 * 10e-3), 1.0 / (3.0 * 48e-3)
    forces = np.array([sun, ring - sun, ring])
    compliance = np.array([2e-9, 3e-9, 5e-9])
    found = network_stiffness(
        drive=drive, normal_compliance=jnp.full(3, 1e-9), tangential_compliance=jnp.asarray(compliance)
    )
    np.testing.assert_allclose(np.abs(found.tangential_force), forces, rtol=1e-9)
    assert 1.0 / float(found.output) == pytest.approx(3.0 * float(forces**2 @ compliance), rel=1e-9)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_the_bearing_of_a_floating_sun_has_its_share(planetary):
    """The share of a spring is k dC/dk over -C; unlike sectors push the sun into its bearing."""
    drive = unfolded(planetary, sectors=COUNT, floating=("sun",))
    count = len(drive.contacts)

    def network(stiffness):
        return network_stiffness(
            drive=drive,
            normal_compliance=jnp.full(count, 1e-9),
            tangential_compliance=1e-9 * jnp.array([2.0, 3.0, 2.0, 3.0, 6.0, 4.0]),
            support_stiffness=jnp.array([stiffness]),
        )

    found = network(1e8)
    shares = (found.tangential_share, found.normal_share, found.pin_share, found.support_share)
    assert sum(float(jnp.sum(share)) for share in shares) == pytest.approx(1.0, rel=1e-12)
    step = 1e-4
    softer, stiffer = (1.0 / float(network(1e8 * (1.0 + sign * step)).output) for sign in (-1.0, 1.0))
    expected = (softer - stiffer) / (2.0 * step) * float(found.output)
    assert expected > 1e-3
    assert float(jnp.sum(found.support_share)) == pytest.approx(expected, rel=1e-6)


def test_shafts_are_in_series():
    found, entry, out = with_shafts(
        stiffness=jnp.asarray(3000.0), ratio=6.0, input_shaft_stiffness=100.0, output_shaft_stiffness=jnp.inf
    )
    assert float(found) == pytest.approx(1.0 / (1.0 / 3000.0 + 1.0 / 3600.0), rel=1e-12)
    assert float(entry) == pytest.approx(3000.0 / 6600.0, rel=1e-12)
    assert float(out) == 0.0
    found, entry, out = with_shafts(
        stiffness=jnp.asarray(3000.0), ratio=6.0, input_shaft_stiffness=100.0, output_shaft_stiffness=6000.0
    )
    compliance = 1.0 / 3000.0 + 1.0 / 3600.0 + 1.0 / 6000.0
    assert float(found) == pytest.approx(1.0 / compliance, rel=1e-12)
    assert (float(entry), float(out)) == pytest.approx(
        (1.0 / 3600.0 / compliance, 1.0 / 6000.0 / compliance), rel=1e-12
    )


def test_a_rigid_shaft_has_finite_derivatives():
    def stiffness(ratio):
        rigid = {"input_shaft_stiffness": math.inf, "output_shaft_stiffness": math.inf}
        return with_shafts(stiffness=jnp.asarray(1e5), ratio=ratio, **rigid)[0]

    assert jax.value_and_grad(stiffness)(6.0) == (pytest.approx(1e5), 0.0)


@pytest.mark.long
@pytest.mark.parametrize("held", [None, (2e7, 3e7)])
def test_the_stiffness_is_the_slope_of_the_states_also_where_a_contact_slides(drives, held):
    """Linear springs, whose slip does not depend on the normal force: 5 N·m, and 10 N·m with a roller that slides."""
    drive, friction = drives["wedge"], jnp.array([0.12, 0.12, 0.12, 0.09, 0.09])
    normal, pins = jnp.array([6e-9, 5e-9, 5e-9, 4e-9, 4e-9]), 3e-9
    laws = ContactLaws(
        springs=NormalSprings(normal, normal),
        reference_force=jnp.full(5, 500.0),
        creep=CreepLaw(friction, jnp.full(5, 3e-5)),
    )
    pattern = jnp.array([0.0, 0.0, 0.0, 1.0, 1.0])
    supports = None
    if held is not None:
        supports = carrier_supports(
            drive=drive, pin_transverse_stiffness=held[0], planet_support_stiffness=held[1], planets=(1,)
        )

    @jax.vmap
    def compared(torque):
        def turned(torque):
            load = DriveLoad(torque, pin_compliance=pins, supports=supports)
            state = drive_states(drive=drive, laws=laws, pattern=pattern, preload=1000.0, load=load).standing
            return state.rotation[-1], state

        _, slope, state = jax.jvp(turned, (torque,), (jnp.ones_like(torque),), has_aux=True)
        found = network_stiffness(
            drive=drive,
            normal_compliance=normal,
            tangential_compliance=normal,
            pin_compliance=pins,
            sliding_friction=friction * state.slides,
            supports=supports,
        )
        return state, jnp.abs(slope), found

    state, slope, found = jax.jit(compared)(jnp.array([5.0, 10.0]))
    assert np.count_nonzero(state.slides[0]) == 0
    assert np.count_nonzero(state.slides[1]) == 1
    assert np.all(np.asarray(state.residual) < STATE_TOLERANCE)
    np.testing.assert_allclose(found.output, 1.0 / slope, rtol=1e-9)
    assert float(found.output[1]) < float(found.output[0])
    shares = np.sum(found.tangential_share + found.normal_share, axis=1) + found.pin_share
    shares = shares + np.sum(found.support_share, axis=1)
    np.testing.assert_allclose(shares, 1.0, rtol=1e-9)


def test_a_contact_that_slides_has_no_spring_where_centres_are_held(planetary):
    """Its compliance does not matter, and without another path nothing holds the output."""
    tangential = jnp.array([2e-9, 3e-9])
    slides = jnp.array([0.0, 0.1])
    found = network_stiffness(
        drive=planetary, normal_compliance=None, tangential_compliance=tangential, sliding_friction=slides
    )
    assert not float(found.output) > 1e-3
