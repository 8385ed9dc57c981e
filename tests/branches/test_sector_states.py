"""Sectors by themselves have crowns and skew like those of the joint with equal sectors."""

import dataclasses
from types import SimpleNamespace
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.branches.branches import BranchedJoint
from asperity.branches.sector_states import (
    SectorStates,
    _loaded_up_to,
    _meaning,
    _on_centre,
    _output_moments,
    _turned,
    _working_interference,
    sector_states,
)
from asperity.joint.loading_cam import Pressed
from asperity.joint.solve import solve_joint
from asperity.joint.unfolding import SectorSizes, SettledSectors, unfolded_joint
from asperity.joint_file.build import deviations_of, joint_from_case
from asperity.joint_file.si_tables import si_values
from asperity.rolling.power import RollingLosses
from asperity.rolling.turning import driving_sense


@pytest.mark.long
def test_equal_sectors_with_crowned_and_skewed_rollers_are_the_joint(planar_case):
    case = planar_case(
        "planetary",
        replaced={
            'bodies = "exact"': 'bodies = "springs"',
            'ring_support = "free" ': 'ring_support = "rigid_housing" ',
            "[load]": 'planet_crown_radius = "4 m"\n\n[load]',
            "[model]": '[rolling]\nskew = { sp = "0.1 mrad", pr = "0.2 mrad" }\n\n[model]',
        },
    )
    joint = joint_from_case(case)
    solution = solve_joint(joint)
    found = BranchedJoint(joint, solution).branches(deviations_of(si_values(case)))
    result = solution.result
    np.testing.assert_allclose(found.preload, float(result.preload), rtol=1e-10)
    assert found.stiffness == pytest.approx(float(result.assembly.stiffness.output), rel=1e-9)
    np.testing.assert_allclose(found.rolling.slip_ratio, np.max(result.rolling.slip_ratio), rtol=1e-9)
    life = float(result.rolling.life_hours.drive)
    np.testing.assert_allclose(found.rolling.limits["life_hours"], life, rtol=1e-9)
    assert found.capacity.first_slip == pytest.approx(float(solution.first_slip.output_torque), rel=1e-8)
    assert found.rolling_capacity.first_slip == pytest.approx(
        float(solution.rolling_capacity.output_torque), rel=1e-6
    )


#: Directions of the planets of three sectors, the first above the sun, counter-clockwise.
TOWARDS = np.array(
    [[np.cos(angle), np.sin(angle)] for angle in np.pi / 2.0 + 2.0 * np.pi / 3.0 * np.arange(3)]
)
ACROSS = TOWARDS @ np.array([[0.0, 1.0], [-1.0, 0.0]])  # each turned counter-clockwise by a right angle

STATES = {"rest", "standing", "rolling", "limits", "most_torque"}  # that no meaning has


@pytest.fixture(scope="module")
def planetary_of_three(planar_joint):
    """The example, and the same with a floating sun and every sector by itself."""

    def of(replaced=None):
        joint = jax.tree.map(np.asarray, planar_joint("planetary", replaced or {}))
        sizes = SectorSizes(np.zeros((3, 2)), np.ones((3, 2)), 5e7)
        return joint, unfolded_joint(joint, sizes, sectors=3, floating=("sun",))

    return of


def test_sectors_pass_what_they_carry_to_the_output(planetary_of_three):
    """Pins of 14, 28 and 0 N at 30 mm, or forces of 7, 14 and -7 N at the ring of 50 mm."""
    _, whole = planetary_of_three()
    state = SimpleNamespace(pin_force=jnp.array([14.0, 28.0, 0.0]), tangential=jnp.ones(6))
    moments = np.asarray(_output_moments(whole, state, 3))
    np.testing.assert_allclose(np.abs(moments), [0.42, 0.84, 0.0], atol=1e-12)
    assert moments[0] * moments[1] > 0.0
    _, whole = planetary_of_three({'output = "carrier"': 'output = "ring"'})
    state = SimpleNamespace(tangential=jnp.array([1.0, 7.0, 2.0, 14.0, 3.0, -7.0]), pin_force=jnp.ones(3))
    moments = np.asarray(_output_moments(whole, state, 3))
    np.testing.assert_allclose(np.sign(moments[0]) * moments, [0.35, 0.7, -0.35], atol=1e-12)


def test_a_floating_sun_takes_interference_from_the_planets_it_moves_to(planetary_of_three):
    _, whole = planetary_of_three()
    moved = np.array([1e-6, -3e-6])
    rest = SimpleNamespace(
        interference=jnp.full(6, 30e-6),
        displacement=jnp.array([moved, [5e-6, 1e-6], [2e-6, 2e-6], [1e-6, 4e-6]]),  # of the planets, too
    )
    found = np.asarray(_working_interference(whole, ("sun",), rest)).reshape(3, 2)
    np.testing.assert_allclose(found[:, 0], 30e-6 + TOWARDS @ moved, rtol=1e-12)
    np.testing.assert_allclose(found[:, 1], 30e-6, rtol=1e-12)
    held = np.asarray(_working_interference(whole, (), rest))
    np.testing.assert_allclose(held, 30e-6, rtol=1e-12)


def test_forces_on_the_members_in_the_middle_by_hand(planetary_of_three):
    """Planets press the sun inwards and the ring outwards; tangential forces act along the circles of both."""
    joint, whole = planetary_of_three()
    normal = np.array([[100.0, 110.0], [200.0, 190.0], [150.0, 130.0]])
    state = SimpleNamespace(
        normal=jnp.asarray(normal.ravel()), tangential=jnp.zeros(6), pin_force=jnp.array([10.0, -4.0, 7.0])
    )
    sun, ring, carrier = np.asarray(_on_centre(joint, whole, state))
    np.testing.assert_allclose(sun, -normal[:, 0] @ TOWARDS, rtol=1e-12)
    np.testing.assert_allclose(ring, normal[:, 1] @ TOWARDS, rtol=1e-12)
    pins = np.array([10.0, -4.0, 7.0]) @ ACROSS
    np.testing.assert_allclose(np.sign(carrier[0] * pins[0]) * carrier, pins, rtol=1e-12)
    drag = SimpleNamespace(
        normal=jnp.zeros(6), tangential=jnp.array([5.0, 0.0, 2.0, 0.0, -1.0, 0.0]), pin_force=jnp.zeros(3)
    )
    sun = np.asarray(_on_centre(joint, whole, drag))[0]
    along = np.array([5.0, 2.0, -1.0]) @ ACROSS
    np.testing.assert_allclose(np.sign(sun[0] * along[0]) * sun, along, rtol=1e-12)


def test_a_joint_is_followed_while_its_strips_are_narrower_than_its_bodies(planetary_of_three, monkeypatch):
    """Strips of the half-width b carry b^2 pi L E*/(4 R): of the ring's wall 8 mm, of the sun 10 mm."""
    _, whole = planetary_of_three()
    young, poisson, length = 203e9, 0.29, 10e-3
    per_square = np.pi * length * young / (2.0 * (1.0 - poisson**2)) / 4.0
    most = np.tile(
        [10e-3**2 * per_square / (20e-3 / 3.0), 8e-3**2 * per_square / (100e-3 / 3.0)], 3
    )  # of 10 and 20 mm outside each other, of 20 mm inside 50 mm
    asked = {}
    monkeypatch.setattr(
        "asperity.branches.sector_states.followed", lambda **given: asked.update(given) or (1, 2)
    )
    rest = SimpleNamespace(normal=jnp.array([500.0, 700.0, 600.0, 700.0, 600.0, 700.0]))
    _loaded_up_to(whole, Pressed(None, rest), jnp.asarray(7.0))
    assert bool(asked["keeps"](SimpleNamespace(normal=jnp.asarray(0.999 * most))))
    for contact in range(6):
        wide = np.where(np.arange(6) == contact, 1.001 * most, 1.0)
        assert not bool(asked["keeps"](SimpleNamespace(normal=jnp.asarray(wide))))
    assert asked["most"] == 7.0
    # a step of the first contact to slip: 0.08 of 500 N on both its sides at 30 mm make 2.4 N·m
    assert 0.01 * 2.4 < float(asked["first_step"]) < 0.5 * 2.4


@pytest.mark.slow
def test_each_sector_turns_as_a_joint_of_its_own_forces_and_speeds(planetary_of_three, monkeypatch):
    """The creep law is taken around its forces."""
    joint, _ = planetary_of_three()
    normal, tangential = np.arange(10.0, 16.0).reshape(3, 2), np.arange(1.0, 7.0).reshape(3, 2)
    rolling = SolvedState(
        normal=jnp.asarray(normal.ravel()),
        tangential=jnp.asarray(tangential.ravel()),
        creepage=jnp.asarray(1e-3 * tangential.ravel()),
        pin_force=jnp.array([20.0, 30.0, 40.0]),
        speed=jnp.array([1.0, 0.0, 0.11, 0.22, 0.33, 0.17]),  # sun, ring, three planets, carrier
    )
    sizes = SectorSizes(np.zeros((3, 2)), np.ones((3, 2)), 5e7)
    module = "asperity.branches.sector_states"
    monkeypatch.setattr(f"{module}.creep_law", lambda joint, contacts, *forces: jnp.stack(forces))

    def turned(joint, contacts, creep, state):
        shown = jnp.stack([state.normal, state.tangential, state.creepage])
        return Turned(shown, creep, Lives(jnp.concatenate([state.speed, state.pin_force])))

    monkeypatch.setattr(f"{module}.turning", turned)
    shown, creep, (rest,) = _turned(joint, sizes, rolling, 3)
    sense = np.asarray(driving_sense(joint.drive))
    expected = np.stack([normal, sense * tangential, 1e-3 * sense * tangential], axis=1)
    np.testing.assert_allclose(shown, expected, rtol=1e-12)
    np.testing.assert_allclose(creep, np.stack([normal, tangential], axis=1), rtol=1e-12)
    for sector, (planet, pin) in enumerate(((0.11, 20.0), (0.22, 30.0), (0.33, 40.0))):
        assert rest[sector] == pytest.approx([1.0, planet, 0.0, 0.17, pin], rel=1e-12)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_limits_in_the_sense_of_the_torque(planetary_of_three, monkeypatch, way):
    """The first slip of the joint that stands, and all limits of the one that turns."""
    joint, _ = planetary_of_three()
    joint = dataclasses.replace(joint, output_torque=np.asarray(7.0 * way))
    settled = SettledSectors(
        SectorSizes(np.zeros((3, 2)), np.ones((3, 2)), np.asarray(5e7)), Pressed(None, np.asarray(0.0)), None
    )
    module, asked = "asperity.branches.sector_states", []

    class Made(SimpleNamespace):
        def with_first(self, *given):
            return lambda *last: self.of(*last)

        def __call__(self, *given):
            return dict.fromkeys(set(SectorStates._fields) - STATES, np.asarray(3.0)) | {
                "interference": given[-2]
            }

    def under(torque, rolls, holds):
        assert (torque, rolls, holds) == (7.0 * way, True, False)
        return SimpleNamespace(state=np.asarray(2.0), pressed=np.asarray(4.0))

    programs = {
        "under_torque": Made(of=under, results=SimpleNamespace(state=None)),
        "_loaded_up_to": Made(of=lambda most: (np.asarray(1.0), most)),
        "_meaning": Made(),
    }
    monkeypatch.setattr(f"{module}.compile_fast", lambda program, *_, **__: programs[program.__name__])
    monkeypatch.setattr(
        f"{module}.torque_capacity", lambda *_, **given: asked.append(given) or np.asarray(5.0)
    )
    found = sector_states(3, ("sun",), joint, settled)
    assert [case["direction"] for case in asked] == [way, way]
    assert [(case["rolls"], case["holds"]) for case in asked] == [(False, True), (True, False)]
    assert (float(found.standing), float(found.rolling), float(found.interference)) == (1.0, 2.0, 2.0)
    assert float(found.most_torque) == np.inf


@pytest.mark.slow
def test_a_contact_that_slides_has_slipped_and_losses_are_the_mean(planetary_of_three, monkeypatch):
    """The mean of the sectors' losses: each is that of all if all were like it."""
    joint, whole = planetary_of_three()
    module, six = "asperity.branches.sector_states", jnp.ones(6)
    state = SolvedState(
        six, six, six, jnp.ones(3), jnp.ones(6), slides=jnp.array([0.0, 1.0, 0.0, 0.0, -1.0, 0.0])
    )
    for name, fake in {
        "loaded_stiffness": lambda *_: SimpleNamespace(contacts=None, assembly=None),
        "diagnose": lambda **_: SimpleNamespace(pressure_over_first_yield=six, slip_ratio=0.25 * six),
        "_turned": lambda *_: SimpleNamespace(
            power=SimpleNamespace(**dict.fromkeys(RollingLosses._fields, jnp.array([1.0, 2.0, 6.0]))),
            drift_per_output_turn=six,
            shakedown_ratio=six,
            slip_ratio=six,
            life_hours=Lives(six),
        ),
        "_on_centre": lambda *_: six,
        "_working_interference": lambda *_: six,
        "_output_moments": lambda *_: six,
        "_centre_moments": lambda *_: six,
    }.items():
        monkeypatch.setattr(f"{module}.{name}", fake)
    found = _meaning(3, ("sun",), joint, whole, None, Pressed(None, state), state, state, state)
    np.testing.assert_array_equal(found["slip_ratio"], [[0.25, 1.0], [0.25, 0.25], [1.0, 0.25]])
    assert found["losses"] == RollingLosses(*(6 * [3.0]))


class Lives(NamedTuple):
    """Of the drive alone."""

    drive: jax.Array


class Turned(NamedTuple):
    """What is read of a joint that turns."""

    shakedown_ratio: jax.Array
    slip_ratio: jax.Array
    life_hours: Lives


class SolvedState(eqx.Module):
    """What is read of a state."""

    normal: jax.Array
    tangential: jax.Array
    creepage: jax.Array
    pin_force: jax.Array
    speed: jax.Array
    slides: jax.Array | None = None
