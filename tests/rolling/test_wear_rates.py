"""How fast tracks wear, and what that takes off a drive: an independent program, the power of creep, and geometry."""

import dataclasses

import numpy as np
import pytest
from tests.support.worn import EXAMPLES, changed, check_case, worn_joint

from asperity.drive.layout.drive import incidence
from asperity.drive.state.state import surface_speeds
from asperity.engine.control import at_once
from asperity.joint.capacity import loading
from asperity.joint.solve import joint_state
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.reader import parse_case, read_case
from asperity.rolling.wear import by_track, track_names
from asperity.rolling.wear_course import states_at
from asperity.rolling.wear_rates import (
    Worn,
    felt_interference,
    side_tracks,
    unworn,
    worn_assembled,
    worn_machine,
)

#: µm in 1000 h with 1e-17 1/Pa.
_PER_1000_H = 1e-17 * 3.6e6 * 1e6
#: Of an independent program: depths of sun, planet, right and left roller, ring; powers of creep of one branch [W].
DEPTHS = (0.6482, 0.1030, 0.1046, 0.0859, 0.0320)
POWERS = (0.09051, 0.03029, 0.02475, 0.02447, 0.02025)
SKEWED = '\n[rolling]\nskew = "0.2 mrad"\n'


def start(case):
    wearing, loads = worn_joint(case)
    return wearing, states_at(wearing, unworn(wearing), loads)


def test_depths_of_an_independent_program():
    wearing, state = start(check_case())
    depths = by_track(wearing.machine.drive, state.depth[0, 0])
    names = ("sun", "planet", "right_loading_roller", "left_loading_roller", "ring")
    assert track_names(wearing.machine.drive) == names
    assert depths * _PER_1000_H == pytest.approx(DEPTHS, rel=2e-3)
    assert state.load_power[0, 0] * 0.12 == pytest.approx(POWERS, rel=2e-3)
    assert state.drive_rate[0, 0] * _PER_1000_H == pytest.approx(1.01766, rel=1e-3)


def test_virtual_work_by_the_angles_of_the_wedge():
    r""":math:`N \propto 1, 1/(2\cos\theta), \cos\beta/(2\cos\theta)`, with theta and beta of the centres."""
    wearing, state = start(check_case())
    sun, planet, right, left, _ = wearing.machine.drive.centres
    forces = [1.0]
    at_planet, at_rollers = [], []
    for roller in (right, left):
        theta = _angle(roller - planet, planet - sun)
        beta = _angle(roller - sun, roller - planet)
        at_planet.append(0.5 / np.cos(theta))
        at_rollers.append(0.5 * np.cos(beta) / np.cos(theta))
    forces = np.array([*forces, *at_planet, *at_rollers])
    taken = state.depth[0, 0].sum(axis=0)
    by_hand = np.sum(forces * taken) / np.sum(forces[3:])
    assert state.drive_rate[0, 0] == pytest.approx(by_hand, rel=1e-9)


def _angle(one, other):
    return np.arccos(one @ other / np.linalg.norm(one) / np.linalg.norm(other))


def test_only_what_statics_feels_counts():
    """Wear that a shift of the rollers takes up changes no force, under load too."""
    wearing, loads = worn_joint(check_case())
    matrices = incidence(wearing.machine.drive)
    free = np.linalg.svd(np.asarray(matrices.pins))[2][matrices.pins.shape[0] :]
    shift = np.asarray(matrices.approach) @ (free.T @ np.array([0.7, -0.4, 1.1, 0.3]) * 1e-6)
    felt = felt_interference(wearing.machine)
    assert felt @ shift == pytest.approx(np.zeros(5), abs=1e-15)
    base = np.array([1.0, 0.2, 0.3, 0.6, 0.4]) * 1e-6
    one, other = (states_at(wearing, Worn(each[None]), loads) for each in (base, base + shift))
    for name in ("tangential", "load_power", "preload", "speed_loss"):
        assert getattr(one, name) == pytest.approx(getattr(other, name), rel=1e-8)
    assert one.interference == pytest.approx(other.interference, rel=1e-9)


def test_worn_contacts_are_a_smaller_interference():
    wearing, loads = worn_joint(check_case())
    taken = np.array([0.9, 0.4, 0.3, 0.2, 0.1]) * 1e-6
    worn = states_at(wearing, Worn(taken[None]), loads)
    left = float(worn.interference[0, 0])
    _, known = start(check_case({'"12.9043 um"': f'"{left * 1e6} um"'}))
    assert worn.preload[0, 0] == pytest.approx(known.preload[0, 0], rel=1e-6)
    assert worn.load_power[0, 0] == pytest.approx(known.load_power[0, 0], rel=1e-5)


def case_of(name, *changes, more=""):
    text = (EXAMPLES / f"{name}.toml").read_text()
    return parse_case(changed(text, dict(changes)) + more, source=name)


DRIVES = {
    "wedge": check_case(),
    "planetary": read_case(EXAMPLES / "planetary.toml"),
    "stepped": read_case(EXAMPLES / "stepped_planet.toml"),
    "multiroller": read_case(EXAMPLES / "multiroller.toml"),
    "listed": case_of("planar", ('preload = "1000 N"', 'interference = "13 um"')),
    "wheels": case_of("wheel_pair", ('preload = "1000 N"', 'interference = "20 mm"')),
    "crowned": check_case(
        {'contact_length = "5 mm"': 'contact_length = "5 mm"\nplanet_crown_radius = "2 m"'}
    ),
    "skewed": check_case(more=SKEWED),
    "branches": check_case(more="\n[[branch]]\n\n[[branch]]\n\n[[branch]]\n"),
}


@pytest.mark.parametrize("name", DRIVES)
def test_load_powers_of_every_drive_are_the_powers_of_creep_over_friction(name):
    wearing, state = start(DRIVES[name])
    joint = at_once(lambda: with_own_branches(DRIVES[name]))
    rolling = joint_state(joint).rolling
    assert np.isfinite(rolling.residual)
    creep = np.asarray(rolling.power.creep + rolling.power.skew) / float(np.asarray(joint.drive.sectors))
    friction = np.broadcast_to(np.asarray(wearing.machine.contacts.pairs.friction_coefficient), creep.shape)
    assert state.load_power[0, 0] == pytest.approx(creep / friction, rel=1e-6)


@pytest.mark.parametrize("name", ["planetary", "stepped", "multiroller", "wheels"])
def test_volumes_add_up(name):
    """What all tracks lose is both coefficients times what all contacts do, of all sectors."""
    wearing, state = start(DRIVES[name])
    drive = wearing.machine.drive
    numbers = np.array(side_tracks(drive))
    radii = np.stack([np.asarray(drive.first_radius), np.asarray(drive.second_radius)])
    lengths = np.asarray(wearing.machine.contacts.pairs.contact_length)
    sectors = float(np.asarray(drive.sectors))
    lost = 0.0
    for track in range(numbers.max() + 1):
        side, contact = np.argwhere(numbers == track)[0]
        body = (drive.layout.first, drive.layout.second)[side][contact]
        copies = 1.0 if drive.bodies[body].on_axis else sectors
        around = 2.0 * np.pi * radii[side, contact] * lengths[contact]
        lost += copies * around * state.depth[0, 0, side, contact]
    assert lost == pytest.approx(2.0 * sectors * state.load_power[0, 0].sum(), rel=1e-9)


def test_equal_branches_wear_as_one():
    wearing, state = start(DRIVES["branches"])
    _, known = start(DRIVES["wedge"])
    depth, sectors = state.depth[0, 0], 3
    assert depth.reshape(2, sectors, 5) == pytest.approx(
        np.repeat(known.depth[0, 0][:, None], sectors, axis=1), rel=1e-5
    )
    assert state.drive_rate == pytest.approx(known.drive_rate, rel=1e-5)
    assert wearing.machine.joint.unlike is not None


def test_a_crown_wears_most_in_its_middle_and_flatter():
    wearing, state = start(DRIVES["crowned"])
    _, even = start(DRIVES["wedge"])
    crowned = np.asarray(wearing.machine.contacts.crown_curvature) > 0.0
    assert crowned.tolist() == [True, True, True, False, False]
    assert np.all(state.rates.curvature[0, 0][crowned] > 0.0)
    assert np.all(state.rates.curvature[0, 0][~crowned] == 0.0)
    middle = state.depth[0, 0, 0, 0] / (state.load_power[0, 0, 0] * 3.0 / (2.0 * np.pi * 4e-3 * 5e-3))
    assert middle > 1.05
    assert even.depth[0, 0, 0, 0] / (even.load_power[0, 0, 0] * 3.0 / (2.0 * np.pi * 4e-3 * 5e-3)) == (
        pytest.approx(1.0, rel=1e-12)
    )


def test_oil_leaves_the_share_of_the_asperities():
    case = read_case(EXAMPLES / "oil.toml")
    _, state = start(case)
    joint = with_own_branches(case)
    rolling = joint_state(joint).rolling
    speed = np.asarray(rolling.power.creep) / np.abs(np.asarray(rolling.tangential)) / 3.0
    by_hand = np.asarray(rolling.film.asperity_share * rolling.normal) * speed
    sectors = float(np.asarray(joint.drive.sectors))
    assert state.load_power[0, 0] == pytest.approx(by_hand * 3.0 / sectors, rel=1e-6)


def test_parts_of_unlike_coefficients():
    """Twice the coefficient of the sun is twice its depth, and no other's."""
    wearing, loads = worn_joint(check_case())
    twice = dataclasses.replace(wearing, coefficients=np.array([1.0, 0.5, 0.5, 0.5, 0.5]))
    one, other = (states_at(each, unworn(each), loads).depth[0, 0] for each in (wearing, twice))
    assert other[0, 0] == pytest.approx(one[0, 0])
    assert other.ravel()[1:] == pytest.approx(0.5 * one.ravel()[1:])


def test_energy_of_a_joint_in_which_one_contact_slides():
    """Beyond the first slide: T = mu N there, and what enters is what leaves and what all contacts lose."""
    wearing, loads = worn_joint(check_case())
    lost = 7.35e-6  # between both ends of the check joint
    sliding = np.zeros((1, 5))
    sliding[0, 4] = np.sign(-1.0)
    worn = Worn((lost * np.asarray(wearing.machine.joint.pattern))[None])
    machine, pressed = worn_assembled(worn_machine(wearing.machine, Worn(worn.interference[0])))
    under = at_once(
        lambda machine, pressed: loading(machine, pressed, sliding=sliding[0])(5.0, True, False),
        machine,
        pressed,
    )
    state, drive = under.state, machine.drive
    assert np.all(under.excesses < 0.0)
    assert abs(state.tangential[4]) == pytest.approx(0.12 * state.normal[4], rel=1e-9)
    slip = np.abs(np.asarray(incidence(drive).turning) @ state.speed)
    assert slip[4] > 1.05 * np.abs(state.creepage[4]) * _rolled(drive, state.speed)[4]
    other = [0, 1, 2, 3]
    assert slip[other] == pytest.approx(
        (np.abs(state.creepage) * _rolled(drive, state.speed))[other], rel=1e-6
    )
    out = drive.members.index(drive.output)
    lost_power = 3.0 * np.sum(np.abs(state.tangential) * slip)
    assert state.input_torque == pytest.approx(5.0 * abs(state.speed[out]) + lost_power, rel=1e-9)
    shown = states_at(wearing, worn, loads._replace(sliding=sliding))
    assert shown.load_power[0, 0] * 0.12 == pytest.approx(
        np.abs(state.tangential) * slip * float(loads.input_speed[0]), rel=1e-9
    )


def _rolled(drive, speed):
    one, other = surface_speeds(drive=drive, speed=speed)
    return 0.5 * (np.asarray(one) + np.asarray(other))
