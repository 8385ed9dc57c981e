"""A drive with form errors from instant to instant: against an independent prototype, first order, and energy."""

import numpy as np
import pytest
from form_errors import ARCSECONDS, balance_of, check_joint, lobes

from asperity.drive.state.march import Wave, form_at, march
from asperity.drive.state.ripple import ripples

UM = 1e-6


@pytest.fixture(scope="module")
def rolling():
    return balance_of(check_joint())


def marched(rolling, errors, *, turns, steps):
    """A march over turns of the output, and its first order: an amplitude of each, and added values over the angle."""
    waves = [Wave(lobes(rolling, body, harmonic), size, phase) for body, harmonic, size, phase in errors]
    linear = ripples(rolling, [wave.lobes for wave in waves])
    output = rolling.machine.drive.layout.output
    angle = 2.0 * np.pi * turns / abs(float(rolling.state.speed[output]))
    with np.errstate(all="ignore"):
        found = march(rolling, waves, linear, angle=angle, steps=steps)
    sizes = np.array([wave.amplitude * np.exp(1j * wave.phase) for wave in waves])

    def first_order(amplitudes):
        return (np.exp(1j * np.outer(found.angle, linear.frequency)) @ (sizes * amplitudes)).real

    return found, linear, first_order


def test_a_round_drive_rolls_steadily(rolling):
    found, *_ = marched(rolling, [("sun", 1, 0.0, 0.0)], turns=0.01, steps=4)
    np.testing.assert_allclose(found.normal, np.tile(np.asarray(rolling.state.normal), (5, 1)), rtol=1e-9)
    np.testing.assert_allclose(found.input_torque, float(rolling.state.input_torque), rtol=1e-9)


def test_eccentric_sun_of_the_prototype(rolling):
    found, linear, first_order = marched(rolling, [("sun", 1, 5.0 * UM, 0.0)], turns=0.11, steps=176)
    normal = found.normal[16:, 0]  # one turn of the sun, once it has left its start to first order
    # normal forces without form errors differ by .14 % from those of the prototype
    np.testing.assert_allclose([normal.min(), normal.max()], [619.7, 1399.1], rtol=3e-3)
    assert found.slip[16:].max() == pytest.approx(0.687, rel=3e-3)
    added = normal - float(rolling.state.normal[0])
    assert np.ptp(added) == pytest.approx(np.ptp(first_order(linear.normal[:, 0])), rel=0.005)
    loss = 1.0 - found.speed[17:, -1].mean() / float(rolling.machine.ideal[-1])
    assert loss / float(rolling.state.speed_loss) == pytest.approx(1.6182e-3 / 1.6337e-3, rel=1e-3)


@pytest.mark.parametrize(("body", "harmonic", "turns"), [("ring", 3, 1.0 / 3.0), ("planet_1", 2, 1.0 / 5.93)])
def test_transmission_error_is_that_of_first_order(rolling, body, harmonic, turns):
    found, linear, first_order = marched(rolling, [(body, harmonic, UM, 0.4)], turns=turns, steps=60)
    output = rolling.machine.drive.layout.output
    error = np.ptp(found.error(output)) * ARCSECONDS
    assert error == pytest.approx(np.ptp(first_order(linear.error(output))) * ARCSECONDS, rel=7e-3)
    normal = found.normal[:, 0]
    assert np.ptp(normal) == pytest.approx(np.ptp(first_order(linear.normal[:, 0])), rel=5e-3)


def test_powers_of_all_members_are_creep_and_elastic_energy(rolling):
    """In the mean over a wave of a planet, in which the energy of the springs comes back."""
    size, harmonic, steps = 2.0 * UM, 2, 120
    output = rolling.machine.drive.layout.output
    speed = np.asarray(rolling.state.speed)
    planet = lobes(rolling, "planet_1", harmonic)
    relative = abs(speed[planet.body] - speed[-1])
    turns = abs(speed[output]) / (harmonic * relative)
    found, *_ = marched(rolling, [("planet_1", harmonic, size, 0.0)], turns=turns, steps=steps)
    torque = float(rolling.task.load.output_torque)
    powers = found.input_torque - torque * np.abs(found.speed[:, output])
    relative_speeds = found.speed - found.speed[:, [-1]]
    drive = rolling.machine.drive
    rolled = 0.5 * (
        np.asarray(drive.first_radius) * np.abs(relative_speeds[:, drive.layout.first])
        + np.asarray(drive.second_radius) * np.abs(relative_speeds[:, drive.layout.second])
    )
    creep = (found.tangential * found.creepage * rolled).sum(axis=1)
    mean = [np.trapezoid(each, found.angle) / found.angle[-1] for each in (powers, creep)]
    assert mean[0] == pytest.approx(mean[1], rel=2e-3)
    # not that of round tracks, by what the prototype has: 5.5 % more at two micrometres
    steady = float(rolling.state.input_torque) - torque * abs(speed[output])
    assert mean[0] / steady - 1.0 == pytest.approx(0.055, abs=0.035)


def test_form_turns_with_its_body(rolling):
    """A hill that stood at a contact stands at the next one when the body has turned from one to the other."""
    machine, wave = rolling.machine, Wave(lobes(rolling, "sun", 1), UM, 0.0)
    nothing = np.zeros(len(machine.drive.members))
    turned = nothing + np.where(np.arange(nothing.size) == wave.lobes.body, 2.0 * np.pi / 3.0, 0.0)
    before, after = form_at(machine, [wave], nothing), form_at(machine, [wave], turned)
    at = np.flatnonzero(wave.lobes.first)
    np.testing.assert_allclose(
        np.asarray(after.first)[np.roll(at, -1)], np.asarray(before.first)[at], atol=1e-18
    )
    np.testing.assert_allclose(
        np.asarray(after.first_slope)[np.roll(at, -1)], np.asarray(before.first_slope)[at], atol=1e-18
    )


@pytest.mark.slow
def test_mixture_of_the_prototype_over_a_turn_of_the_carrier(rolling):
    errors = [
        ("sun", 1, 2.0 * UM, 0.0),
        ("ring", 3, UM, 0.7),
        ("planet_1", 2, 0.5 * UM, 1.1),
        ("right_loading_roller_2", 2, 0.5 * UM, 2.0),
    ]
    found, linear, first_order = marched(rolling, errors, turns=1.0, steps=480)
    output = rolling.machine.drive.layout.output
    assert np.ptp(first_order(linear.error(output))) * ARCSECONDS == pytest.approx(53.37, rel=3e-3)
    assert np.ptp(found.error(output)) * ARCSECONDS == pytest.approx(53.73, rel=5e-3)
    normal = found.normal[:, 0]
    np.testing.assert_allclose([normal.min(), normal.max()], [727.6, 1246.9], rtol=3e-3)
    assert found.slip.max() == pytest.approx(0.640, rel=3e-3)
