"""A pair of smooth wheels against closed forms of statics, Hertz and Carter."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.drive.layout.drive import CARRIER, Drive, gaps, speed_ratio, speeds
from asperity.drive.layout.existence import refuse_impossible
from asperity.drive.state.loads import member_loads
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.state import STATE_TOLERANCE, DriveLoad
from asperity.drive.state.states import drive_states
from asperity.drive.types.wheel_pair import WHEEL_PAIR

#: Radii [m], Young's modulus [Pa], friction coefficient, length [m], preload [N], output torque [N·m].
R_1, R_2, E, NU, MU, B, N, TORQUE = 20e-3, 45e-3, 206e9, 0.3, 0.1, 8e-3, 900.0, 2.7
FORCE = TORQUE / R_2


@pytest.fixture(scope="module")
def drive():
    return WHEEL_PAIR.drive({"driver_radius": R_1, "driven_radius": R_2})


def states_of(drive, torque, *, preload=N):
    laws = smooth_contact_laws(
        drive=drive,
        youngs_modulus=E,
        poisson_ratio=NU,
        friction_coefficient=MU,
        contact_length=B,
        ring_wall_thickness=1.0,
        reference_force=preload,
    )
    return drive_states(
        drive=drive,
        laws=laws,
        pattern=np.ones(1),
        preload=preload,
        load=DriveLoad(np.asarray(torque)),
    )


def carter(force):
    """Creepage mu b/R (1 - sqrt(1 - T/(mu N))) of two wheels, b by Hertz, 1/R = 1/R_1 + 1/R_2."""
    radius = R_1 * R_2 / (R_1 + R_2)
    width = math.sqrt(4.0 * N * radius / (math.pi * B * E / (2.0 * (1.0 - NU**2))))
    return MU * width / radius * (1.0 - math.sqrt(1.0 - force / (MU * N)))


def test_it_turns_the_other_way_by_the_ratio_of_the_radii(drive):
    refuse_impossible(drive)
    np.testing.assert_allclose(gaps(drive), 0.0, atol=1e-16)
    assert float(speed_ratio(drive)) == pytest.approx(-R_2 / R_1, rel=1e-14)
    np.testing.assert_allclose(speeds(drive), [1.0, -R_1 / R_2, 0.0], atol=1e-15)


def test_forces_and_creep_are_those_of_two_rollers(drive):
    states = states_of(drive, TORQUE)
    for state in (states.rest, states.standing, states.rolling):
        assert float(state.residual) < STATE_TOLERANCE
        np.testing.assert_allclose(state.normal, N, rtol=1e-9)  # no torque changes it: the centres stay
    for state in (states.standing, states.rolling):
        np.testing.assert_allclose(np.abs(state.tangential), FORCE, rtol=1e-9)
        assert float(state.input_torque) == pytest.approx(FORCE * R_1, rel=1e-9)
    creepage = carter(FORCE)
    np.testing.assert_allclose(np.abs(states.rolling.creepage), creepage, rtol=1e-9)
    # surface speeds V_1 - V_2 = xi (V_1 + V_2)/2
    lost = 1.0 - (1.0 - 0.5 * creepage) / (1.0 + 0.5 * creepage)
    assert float(states.rolling.speed_loss) == pytest.approx(lost, rel=1e-9)


def test_a_torque_that_drives_is_the_mirror_image(drive):
    """Only the tangential force changes its sign."""
    forwards, backwards = (states_of(drive, torque).standing for torque in (TORQUE, -TORQUE))
    np.testing.assert_allclose(backwards.tangential, -forwards.tangential, rtol=1e-12)
    np.testing.assert_allclose(backwards.normal, forwards.normal, rtol=1e-12)


def test_the_wheel_off_the_origin_may_drive(drive):
    """The same pair seen from the other wheel: ratio R_1/R_2 and the torques of its own radii."""
    other = dataclasses.replace(drive, input="driven", output="driver", motion=None)
    refuse_impossible(other)
    assert float(speed_ratio(other)) == pytest.approx(-R_1 / R_2, rel=1e-14)
    rolling = states_of(other, FORCE * R_1).rolling
    np.testing.assert_allclose(np.abs(rolling.tangential), FORCE, rtol=1e-9)
    assert float(rolling.input_torque) == pytest.approx(FORCE * R_2, rel=1e-9)
    np.testing.assert_allclose(np.abs(rolling.creepage), carter(FORCE), rtol=1e-9)


def test_the_frame_has_what_is_left_of_both_torques(drive: Drive):
    """T R_1 + T R_2 on the wheels, both in one sense, and T (R_1 + R_2) on the frame against it."""
    standing = states_of(drive, TORQUE).standing
    loads = member_loads(
        drive=drive, normal=standing.normal, tangential=standing.tangential, body_force=np.zeros((0, 2))
    )
    driver, driven, frame = loads.moments
    assert abs(float(driver)) == pytest.approx(FORCE * R_1, rel=1e-9)
    assert abs(float(driven)) == pytest.approx(FORCE * R_2, rel=1e-9)
    assert float(driver * driven) > 0.0
    assert float(frame) == pytest.approx(-float(driver + driven), rel=1e-12)
    assert drive.members[-1] == CARRIER
