"""Moments of bearings by hand, and a planetary drive that rolls with them: balance of every body, and of the powers."""

import dataclasses

import numpy as np
import pytest
from steel_laws import steel_laws

from asperity.drive.bearings import Bearings
from asperity.drive.layout.drive import speeds
from asperity.drive.state.equations import ASSEMBLED, ROLLING, STANDING, Task, machine_of, moments_of
from asperity.drive.state.loads import friction_moments, friction_power
from asperity.drive.state.state import DriveLoad
from asperity.drive.state.states import drive_states
from asperity.engine.control import at_once

BEARINGS = Bearings(
    input_torque=0.01,
    roller_torque=0.02,
    output_torque=0.05,
    pin_friction_coefficient=0.1,
    pin_friction_diameter=8e-3,
)


def test_moments_of_a_planetary_drive_by_hand(drives):
    """Sun 10, planets 20, ring 50 mm: sun +1, carrier +1/6, planets against both; each pin 100 N."""
    drive = drives["planetary"]
    ideal = np.asarray(speeds(drive))
    moments = friction_moments(drive=drive, bearings=BEARINGS, pin_force=np.array([-100.0]), ideal=ideal)
    pin = 2.0 * 0.02 + 0.1 * 100.0 * 4e-3  # Coulomb
    sun, planet, ring, carrier = np.asarray(moments)
    assert sun == pytest.approx(-2.0 * 0.01)
    assert planet == pytest.approx(pin)  # it turns backwards on its pin
    assert ring == 0.0
    assert carrier == pytest.approx(-2.0 * 0.05 - 3.0 * pin)
    power = friction_power(drive=drive, moments=moments, speed=ideal)
    relative = ideal[3] - ideal[1]
    assert relative == pytest.approx((1.0 - 1.0 / 6.0) * 10.0 / 20.0)
    assert float(power) == pytest.approx(0.02 + 0.1 / 6.0 + 3.0 * pin * relative, rel=1e-12)


def test_an_input_by_the_carrier_is_braked_by_its_pins_too(drives):
    drive = drives["planetary"]
    turned = dataclasses.replace(drive, sectors=3, input="carrier", output="sun")
    moments = friction_moments(
        drive=turned, bearings=BEARINGS, pin_force=np.array([0.0]), ideal=speeds(turned)
    )
    assert np.asarray(moments) == pytest.approx([-0.1, 0.04, 0.0, -0.02 - 0.12])


@pytest.fixture(scope="module")
def rolled(drives):
    """The planetary drive under 1000 N and 10 N·m, with bearings and without."""

    def states(drive, bearings):
        laws = steel_laws(drive=drive, reference_force=1000.0)
        load = DriveLoad(10.0, bearings=bearings)
        return drive_states(drive=drive, laws=laws, pattern=np.array([0.0, 1.0]), preload=1000.0, load=load)

    drive = drives["planetary"]
    none = Bearings(0.0, 0.0, 0.0, 0.0, 8e-3)
    return drive, *(at_once(states, drive, each) for each in (BEARINGS, none))


@pytest.mark.parametrize("kind", ["standing", "rolling"])
def test_the_forces_of_a_planetary_drive_by_hand(rolled, kind):
    """F (r + p) n = T + 2 T_c + n M, T_1 + T_2 = F, (T_1 - T_2) p = M with M = 2 T_r + mu F d/2."""
    _, found, _ = rolled
    state = getattr(found, kind)
    force = (10.0 + 0.1 + 3.0 * 0.04) / (3.0 * (30e-3 - 0.1 * 4e-3))
    moment = 0.04 + 0.1 * 4e-3 * force
    one, two = 0.5 * (force + moment / 20e-3), 0.5 * (force - moment / 20e-3)
    assert abs(float(state.pin_force[0])) == pytest.approx(force, rel=1e-9)
    assert np.abs(np.asarray(state.tangential)) == pytest.approx([one, two], rel=1e-9)
    assert float(state.input_torque) == pytest.approx(3.0 * one * 10e-3 + 0.02, rel=1e-9)


def test_what_enters_and_does_not_leave_is_creep_and_bearings(rolled):
    drive, found, _ = rolled
    state = found.rolling
    moments = friction_moments(drive=drive, bearings=BEARINGS, pin_force=state.pin_force, ideal=speeds(drive))
    bearings = float(friction_power(drive=drive, moments=moments, speed=state.speed))
    sun, planet, ring, carrier = np.asarray(state.speed)
    # slip of each contact in the frame of the carrier: force times difference of the surface speeds
    slips = np.array(
        [
            10e-3 * (sun - carrier) + 20e-3 * (planet - carrier),
            20e-3 * (planet - carrier) - 50e-3 * (ring - carrier),
        ]
    )
    creep = 3.0 * float(np.sum(np.asarray(state.tangential) * slips))
    entered = float(state.input_torque) * sun - 10.0 * carrier
    assert creep > 0.0
    assert bearings > creep
    assert creep + bearings == pytest.approx(entered, rel=1e-9)


def test_without_friction_the_torque_is_that_of_the_ratio(rolled):
    _, _, free = rolled
    for state in (free.standing, free.rolling):
        assert float(state.input_torque) == pytest.approx(10.0 / 6.0, rel=1e-9)


@pytest.mark.parametrize(
    ("torque", "rotation", "kind", "sense"),
    [
        (10.0, 0.0, STANDING, 1.0),
        (-10.0, 0.0, STANDING, -1.0),
        (-10.0, 300.0, STANDING, 1.0),
        (10.0, -300.0, ROLLING, -1.0),
        (10.0, -300.0, ASSEMBLED, 0.0),
    ],
)
def test_friction_opposes_the_rotation_or_else_the_torque(drives, torque, rotation, kind, sense):
    drive = drives["planetary"]
    none = np.zeros(2)
    laws = steel_laws(drive=drive, reference_force=1000.0)
    machine = machine_of(drive, laws, np.array([0.0, 1.0]))
    load = DriveLoad(torque, bearings=BEARINGS, rotation=rotation, standing_rotation=rotation)
    pin_force = np.array([-100.0])
    moments = moments_of(machine, Task(kind, none, load, none, none), (none, none), pin_force, none)
    still = moments_of(
        machine, Task(kind, none, DriveLoad(torque), none, none), (none, none), pin_force, none
    )
    pin = 2.0 * 0.02 + 0.1 * 100.0 * 4e-3
    by_hand = sense * np.array([-0.02, pin, 0.0, -0.1 - 3.0 * pin])
    np.testing.assert_allclose(np.asarray(moments - still), by_hand, atol=1e-12)


def test_equation_5_leaves_the_rollers_bearings_out(drives):
    drive = drives["planetary"]
    moments = friction_moments(
        drive=drive, bearings=BEARINGS, pin_force=np.array([-100.0]), ideal=speeds(drive), on_carrier=False
    )
    assert np.asarray(moments) == pytest.approx([-0.02, 0.04 + 0.04, 0.0, -0.1])
