"""The equations of a drive hold at states that are solved by hand: a plain planetary drive on linear springs."""

import dataclasses

import numpy as np
import pytest
from pins_in_bores import pins

from asperity.body.conforming_pin import SHARED
from asperity.drive.normal_springs import NormalSprings
from asperity.drive.state.bores import Bores, by_amplitude
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.equations import (
    ASSEMBLED,
    ROLLING,
    STANDING,
    Task,
    Unknowns,
    contact_forces,
    contact_responses,
    machine_of,
    no_displacement,
    no_force,
    state_misfits,
)
from asperity.drive.state.search import assembled_guess, known_state, solved, started_from, state_of
from asperity.drive.state.state import ContactLaws, DriveLoad

SUN, PLANET, RING, ORBIT = 10e-3, 20e-3, 50e-3, 30e-3
ONE, TWO = 4e-9, 6e-9  # compliance of the contacts with sun and ring [m/N]
NORMAL, FRICTION, SCALE = 1000.0, 0.1, 3e-5
TORQUE = 9.0
TANGENTIAL = TORQUE / (3.0 * 2.0 * ORBIT)  # 50 N: three planets, sun and ring push each with half
REFERENCE, LENGTH = 500.0, 6e-9 * 500.0


@pytest.fixture(scope="module")
def machine(drives):
    linear = np.array([ONE, TWO])
    laws = ContactLaws(
        springs=NormalSprings(linear, linear),
        reference_force=np.full(2, REFERENCE),
        creep=CreepLaw(np.full(2, FRICTION), np.full(2, SCALE)),
    )
    return machine_of(drives["planetary"], laws, np.array([0.0, 1.0]))


@pytest.fixture(scope="module")
def state(machine):
    """State from forces, speeds beyond those without slip, and rotations."""

    def of(
        kind, *, tangential=0.0, torque=0.0, turn=(0.0, 0.0), interference=(ONE + TWO) * NORMAL, force=None
    ):
        unknowns = Unknowns(
            normal=np.full(2, NORMAL / REFERENCE),
            tangential=np.array([1.0, -1.0]) * tangential / (FRICTION * REFERENCE),
            pin=np.array([-2.0 * tangential / REFERENCE]),
            displacement=np.array([0.0, -ONE * NORMAL]) / LENGTH,
            turn=np.asarray(turn),
            interference=np.array([interference]) / LENGTH,
        )
        drive = machine.drive
        load = DriveLoad(np.asarray(torque), force)
        task = Task(kind, np.asarray(interference), load, no_displacement(drive), no_force(drive))
        if kind == STANDING:  # slip counts from the assembled drive
            task = task._replace(origin=unknowns.displacement * LENGTH)
        found = known_state(machine, task, unknowns, np.zeros(2), pressed_sectors=0)
        return state_of(machine, task, found)

    return of


def creepage():
    """Carter's curve at q = T/(mu N)."""
    return SCALE * np.sqrt(NORMAL) * (1.0 - np.sqrt(1.0 - TANGENTIAL / (FRICTION * NORMAL)))


def rolling_speeds():
    """Of planet and carrier: creepage times rolling speed is the slip of each contact; fixed-point iteration."""
    creep, (planet, carrier) = creepage(), (-0.25, 1.0 / 6.0)
    for _ in range(50):
        first = 0.5 * (SUN * abs(1.0 - carrier) + PLANET * abs(planet - carrier))
        second = 0.5 * (PLANET * abs(planet - carrier) + RING * carrier)
        planet, carrier = np.linalg.solve(
            [[PLANET, -SUN - PLANET], [PLANET, RING - PLANET]],
            [creep * first - SUN, -creep * second],
        )
    return planet, carrier


def test_scales(machine):
    assert float(machine.length) == pytest.approx(LENGTH)
    assert (float(machine.largest), float(machine.lever)) == pytest.approx((REFERENCE, RING))


@pytest.mark.slow
def test_assembled(state):
    """The ring's interference is the sum of both compressions; the planet moves inward by that of the sun's contact."""
    found = state(ASSEMBLED)
    assert float(found.worst) < 1e-14
    np.testing.assert_allclose(found.interference, [0.0, (ONE + TWO) * NORMAL], rtol=1e-12)
    np.testing.assert_allclose(found.displacement, [[0.0, -ONE * NORMAL]], rtol=1e-12)
    assert float(state(ASSEMBLED, interference=1.01 * (ONE + TWO) * NORMAL).worst) == pytest.approx(
        0.01 * (ONE + TWO) * NORMAL / LENGTH, rel=1e-9
    )


@pytest.mark.slow
def test_standing(state):
    """Slips c T turn the carrier by (c_1 + c_2) T over twice the orbit, the planet by their difference."""
    carrier = (ONE + TWO) * TANGENTIAL / (2.0 * ORBIT)
    planet = (ONE - TWO) * TANGENTIAL / (2.0 * PLANET)
    found = state(
        STANDING,
        tangential=TANGENTIAL,
        torque=TORQUE,
        turn=np.array([planet, -carrier]) * RING / LENGTH,
    )
    assert float(found.worst) < 1e-12
    np.testing.assert_allclose(found.rotation, [0.0, planet, 0.0, -carrier], rtol=1e-12)
    assert float(found.input_torque) == pytest.approx(3.0 * SUN * TANGENTIAL, rel=1e-12)
    assert bool(found.carried)


def test_rolling(state):
    planet, carrier = rolling_speeds()
    found = state(ROLLING, tangential=TANGENTIAL, torque=TORQUE, turn=(planet + 0.25, carrier - 1.0 / 6.0))
    assert float(found.worst) < 1e-11
    np.testing.assert_allclose(found.speed, [1.0, planet, 0.0, carrier], rtol=1e-12)
    np.testing.assert_allclose(found.creepage, creepage() * np.array([1.0, -1.0]), rtol=1e-12)
    assert float(found.speed_loss) == pytest.approx(1.0 - 6.0 * carrier, rel=1e-9)
    np.testing.assert_allclose(found.pin_force, [-2.0 * TANGENTIAL])
    np.testing.assert_array_equal(found.rotation, 0.0)  # a rotation of members that stand


def test_a_wrong_torque_is_a_residual_of_its_size(state):
    """One per cent of the torque over the largest force and lever."""
    planet, carrier = rolling_speeds()
    turn = (planet + 0.25, carrier - 1.0 / 6.0)
    found = state(ROLLING, tangential=TANGENTIAL, torque=1.01 * TORQUE, turn=turn)
    assert float(found.worst) == pytest.approx(0.01 * TORQUE / (RING * REFERENCE), rel=1e-6)


def test_a_force_without_balance_is_a_residual_of_its_size(state):
    """5 N on the planet over the largest force."""
    found = state(ASSEMBLED, force=np.array([[3.0, -5.0]]))
    assert float(found.worst) == pytest.approx(5.0 / REFERENCE, rel=1e-9)


def test_members_that_do_not_follow_their_slip_are_a_residual_of_its_size(state):
    """Nothing turns, although the ring's contact slips by c T: over the approach at the reference."""
    found = state(STANDING, tangential=TANGENTIAL, torque=TORQUE)
    assert float(found.worst) == pytest.approx(TWO * TANGENTIAL / LENGTH, rel=1e-9)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_a_pin_in_its_bore_moves_the_contacts(machine):
    """By their compliances times its force, the slip by what the torque has added to it."""
    normal, tangential = np.array([[2e-9], [-1e-9]]), np.array([[3e-9], [5e-9]])
    none = by_amplitude(np.zeros((2, 1, SHARED.size)))
    bores = Bores(np.asarray(normal), np.asarray(tangential), none, none, pins(1, 0.0))
    pressed = machine._replace(laws=dataclasses.replace(machine.laws, bores=bores))
    pin, before = -100.0, -30.0
    x = assembled_guess(machine)._replace(pin=np.array([pin / REFERENCE]))
    load = DriveLoad(np.zeros(()))
    task = Task(STANDING, np.asarray(1e-6), load, np.zeros(2), np.array([before]), np.full(2, REFERENCE))
    responses = contact_responses(machine, task, *contact_forces(machine, x))
    bare, bored = (state_misfits(each, task, 0, np.zeros(2), x, responses) for each in (machine, pressed))
    np.testing.assert_allclose(
        bored.all.normal - bare.all.normal, normal[:, 0] * pin / LENGTH, rtol=1e-6, atol=1e-15
    )
    np.testing.assert_allclose(bored.held - bare.held, tangential[:, 0] * (pin - before) / LENGTH, rtol=1e-6)


def test_slip_and_lift_off_are_not_carried(state):
    assert not bool(state(STANDING, tangential=1.01 * FRICTION * NORMAL).carried)
    assert not np.isfinite(state(STANDING, tangential=1.01 * FRICTION * NORMAL).residual)


@pytest.mark.parametrize("kind", [ASSEMBLED, ROLLING])
def test_a_known_state_is_where_a_search_starts(machine, state, kind):
    planet, carrier = rolling_speeds()
    turn = (planet + 0.25, carrier - 1.0 / 6.0) if kind == ROLLING else (0.0, 0.0)
    known = state(kind, tangential=TANGENTIAL if kind == ROLLING else 0.0, torque=TORQUE, turn=turn)
    again = started_from(machine, known, np.asarray((ONE + TWO) * NORMAL))
    task = Task(
        kind, np.asarray((ONE + TWO) * NORMAL), DriveLoad(np.asarray(TORQUE)), np.zeros(2), np.zeros(0)
    )
    found = known_state(machine, task, again, np.zeros(2), pressed_sectors=0)
    for one, two in zip(
        dataclasses.astuple(known),
        dataclasses.astuple(state_of(machine, task, found)),
        strict=True,
    ):
        np.testing.assert_allclose(one, two, rtol=1e-12, atol=1e-13)


@pytest.mark.parametrize(("pressed_sectors", "size"), [(1, 700.0), (0, (ONE + TWO) * 700.0)])
def test_a_preload_or_an_interference_is_found_again(machine, pressed_sectors, size):
    """Both make 700 N at both contacts of the planet."""
    task = Task(
        ASSEMBLED,
        np.asarray(size),
        DriveLoad(np.zeros(())),
        no_displacement(machine.drive),
        no_force(machine.drive),
    )
    balance = solved(machine, task, assembled_guess(machine), pressed_sectors=pressed_sectors)
    found = state_of(machine, task, balance)
    np.testing.assert_allclose(found.normal, 700.0, rtol=1e-12)
    assert float(found.interference[1]) == pytest.approx((ONE + TWO) * 700.0, rel=1e-12)
