"""Drives with every sector by itself: the same drive, and springs by hand where the sectors differ."""

import dataclasses

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.layout.drive import Closure, gaps, incidence, speed_ratio
from asperity.drive.layout.existence import neighbour_gaps, refuse_impossible
from asperity.drive.layout.unfolding import forces_on_centre, unfolded
from asperity.drive.normal_springs import NormalSprings
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.state import ContactLaws, DriveLoad
from asperity.drive.state.states import drive_states, state_at_rest

CENTRES = {
    "wedge": ("sun", "ring"),
    "planetary": ("sun", "ring"),
    "multiroller": ("sun", "ring"),
    "stepped": ("sun", "held_ring", "driven_ring"),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CENTRES)
def test_the_same_drive(drives, name):
    drive = drives[name]
    count = round(float(drive.sectors))
    whole = unfolded(drive, sectors=count)
    assert len(whole.contacts) == count * len(drive.contacts)
    assert len(whole.pinned) == count * len(drive.pinned)
    np.testing.assert_allclose(gaps(whole), 0.0, atol=1e-16)
    assert float(speed_ratio(whole)) == pytest.approx(float(speed_ratio(drive)), rel=1e-12)
    # equal forces of all sectors leave nothing on the members in the middle
    left = forces_on_centre(
        drive=whole,
        bodies=CENTRES[name],
        normal=jnp.tile(jnp.linspace(1.0, 2.0, len(drive.contacts)), count),
        tangential=jnp.tile(jnp.linspace(-0.3, 0.5, len(drive.contacts)), count),
        pin_force=jnp.tile(jnp.linspace(0.2, 0.3, len(drive.pinned)), count),
    )
    assert left.shape == (len(CENTRES[name]) + 1, 2)
    np.testing.assert_allclose(left, 0.0, atol=1e-14)


def test_sectors_are_numbered_counter_clockwise_from_one(drives):
    """Three planets 120 degrees apart; the sun and the ring are one body each."""
    whole = unfolded(drives["planetary"], sectors=3, floating=("sun",))
    assert [(body.name, body.place) for body in whole.bodies[:2]] == [("sun", "free"), ("ring", "held")]
    assert [body.name for body in whole.bodies[2:]] == ["planet_1", "planet_2", "planet_3"]
    assert [contact.name for contact in whole.contacts] == ["sp_1", "pr_1", "sp_2", "pr_2", "sp_3", "pr_3"]
    planets = [(contact.first, contact.second) for contact in whole.contacts[2:4]]
    assert planets == [("sun", "planet_2"), ("planet_2", "ring")]
    x, y = np.asarray(whole.centres)[2:].T
    np.testing.assert_allclose(np.exp(1j * np.diff(np.arctan2(y, x))), np.exp(2j * np.pi / 3.0), rtol=1e-12)


@pytest.mark.parametrize("floating", [(), ("sun",)])
def test_planets_by_themselves_have_the_room_of_equal_ones(drives, floating):
    """Nothing overlaps: sun and ring lie inside each other, and the planets are as far apart as before."""
    drive = drives["planetary"]
    whole = unfolded(drive, sectors=3, floating=floating)
    refuse_impossible(whole)
    apart = float(neighbour_gaps(drive)["planet", "planet"])
    found = neighbour_gaps(whole)
    pairs = [("planet_1", "planet_2"), ("planet_1", "planet_3"), ("planet_2", "planet_3")]
    assert [float(found[pair]) for pair in pairs] == pytest.approx([apart] * 3, rel=1e-12)


def linear_laws(contacts, compliance=1e-9, force=1000.0):
    """Springs whose approach is in proportion to the force, and creep that plays no part."""
    even = jnp.full(contacts, compliance)
    return ContactLaws(
        springs=NormalSprings(secant_compliance=even, incremental_compliance=even),
        reference_force=jnp.full(contacts, force),
        creep=CreepLaw(jnp.full(contacts, 0.1), jnp.full(contacts, 1e-4)),
        asperity_compliance=None,
    )


def of_sizes(drive, added, support=None, interference=10e-6):
    """What a state of a plain planetary drive is found from, with interference of each contact beside the ring's."""
    inner = jnp.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
    return {
        "drive": drive,
        "laws": linear_laws(len(drive.contacts)),
        "pattern": inner + jnp.asarray(added) / interference,
        "interference": interference,
        "load": DriveLoad(output_torque=40.0, support_stiffness=support),
    }


@pytest.fixture(scope="module")
def opposed():
    from asperity.drive.types.planetary import planetary_drive

    return planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=2)


@pytest.mark.slow
def test_two_opposed_planets_by_hand(opposed):
    """Errors of ±e on the radii: each planet is a spring 2c between sun and ring, pressed by delta ± 2 e.

    With the sun held, N = (delta ± 2 e)/(2 c) and the sun bears their difference. On bearings of stiffness k it moves
    by u, and N = (delta ± (2 e - u))/(2 c), k u = N_1 - N_2: u = 2 e/(1 + k c).
    """
    compliance, error, stiffness = 1e-9, 1e-6, 3e8
    added = np.array([error, error, -error, -error])
    held = state_at_rest(**of_sizes(unfolded(opposed, sectors=2), added))
    normal = np.asarray(held.normal).reshape(2, 2)
    expected = (10e-6 + 2.0 * error * np.array([1.0, -1.0])) / (2.0 * compliance)
    np.testing.assert_allclose(normal, np.stack([expected, expected], axis=1), rtol=1e-12)
    drive = unfolded(opposed, sectors=2, floating=("sun",))
    soft = state_at_rest(**of_sizes(drive, added, support=jnp.array([stiffness, 0.0, 0.0])))
    moved = 2.0 * error / (1.0 + stiffness * compliance)
    # away from the larger planet, which lies above it
    np.testing.assert_allclose(soft.displacement[0], [0.0, -moved], atol=1e-16)
    expected = (10e-6 + (2.0 * error - moved) * np.array([1.0, -1.0])) / (2.0 * compliance)
    np.testing.assert_allclose(
        np.asarray(soft.normal).reshape(2, 2), np.stack([expected, expected], axis=1), rtol=1e-12
    )


@pytest.mark.slow
@pytest.mark.parametrize("rolls", [False, True])
def test_the_bearings_of_the_sun_carry_what_the_planets_leave(drives, rolls):
    """Balance of the sun under a torque on soft bearings; without them three planets leave nothing on it."""
    added = np.repeat([1e-6, 0.0, -1.5e-6], 2)
    for stiffness in (2e8, 0.0):
        drive = unfolded(drives["planetary"], sectors=3, floating=("sun",))
        support = jnp.array([stiffness, 0.0, 0.0, 0.0])
        found = drive_states(**of_sizes(drive, added, support))
        state = found.rolling if rolls else found.standing
        assert float(state.residual) < 1e-9
        on_sun, on_ring, on_carrier = forces_on_centre(
            drive=drive,
            bodies=("sun", "ring"),
            normal=state.normal,
            tangential=state.tangential,
            pin_force=state.pin_force,
        )
        np.testing.assert_allclose(on_sun, stiffness * state.displacement[0], atol=1e-7)
        # no force acts from outside: all bearings together carry nothing
        np.testing.assert_allclose(on_sun + on_ring + on_carrier, 0.0, atol=1e-7)
        assert float(incidence(drive).levers @ state.pin_force) == pytest.approx(40.0, rel=1e-9)


def test_every_sector_keeps_the_closure_of_its_own_contacts_and_pins(drives):
    closure = Closure(equal_coefficients=(("pwr", "pwl"),), constant_pins=("left_loading_roller",))
    found = unfolded(dataclasses.replace(drives["wedge"], closure=closure), sectors=3)
    assert found.closure == Closure(
        equal_coefficients=(("pwr_1", "pwl_1"), ("pwr_2", "pwl_2"), ("pwr_3", "pwl_3")),
        constant_pins=tuple(f"left_loading_roller_{sector}" for sector in (1, 2, 3)),
    )
    assert {name for pair in found.closure.equal_coefficients for name in pair} <= {
        contact.name for contact in found.contacts
    }
