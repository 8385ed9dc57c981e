"""Inertias by the kinetic energy of all bodies, frequencies by chains of inertias, creep as dampers in contacts."""

import dataclasses
import math

import jax
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh

from asperity.drive.layout.drive import CARRIER, incidence, speeds
from asperity.drive.stiffness.network import SpringLaws, network_stiffness, spring_laws
from asperity.drive.structure.dynamics import (
    SprungDrive,
    frequency_response,
    inertia_at_motor,
    natural_frequencies,
    sprung_drive,
)
from asperity.drive.structure.inertia import mass_matrix
from asperity.engine.arrays import as_numbers
from asperity.joint.description import in_motion

RATIO = 5.0
STANDS = np.zeros((2, 2))


def chain(first, middle, last, springs, creep=STANDS, slides=None):
    """A roller between motor and load in three angles [rad]: it turns against both with the ratios 2 and 2.5."""
    ends = np.array([[-0.5, 1.0, 0.0], [0.0, -2.5, 1.0]]) * 0.1
    return SprungDrive(
        laws=0.01 * np.diag(1.0 / np.asarray(springs)),
        elongation=ends[:, [1, 0, 2]],  # the roller first, motor and load last
        slides=np.zeros(2, dtype=bool) if slides is None else slides,
        bearings=np.zeros(3),
        creep=0.01 * creep,
        mass=np.diag([middle, first, last]),
        rigid=np.array([0.5, 1.0, 1.25]),
        moves=0,
        length=0.1,
    )


def matrices(springs, first, middle, last):
    """Stiffness and mass of the same chain, in the angles of motor, roller and load."""
    rows = np.array([[-0.5, 1.0, 0.0], [0.0, -2.5, 1.0]])
    return rows.T @ np.diag(springs) @ rows, np.diag([first, middle, last])


@pytest.mark.parametrize("springs", [(9e4, 2e3), (2e3, 9e4), (1e4, 1e4)])
def test_frequencies_of_three_inertias_are_the_eigenvalues(springs):
    """The roller turns with the side on which its spring is stiffer, whatever the ratios are."""
    inertias = (3e-4, 2e-4, 5e-3)
    stiffness, mass = matrices(springs, *inertias)
    rigid, free, _ = eigh(stiffness, mass, eigvals_only=True)
    assert abs(rigid) < 1e-9 * free
    locked = eigh(stiffness[1:, 1:], mass[1:, 1:], eigvals_only=True)[0]
    found = natural_frequencies(chain(*inertias, springs))
    assert found.free == pytest.approx(math.sqrt(free) / (2 * math.pi), rel=1e-10)
    assert found.locked == pytest.approx(math.sqrt(locked) / (2 * math.pi), rel=1e-10)


def test_without_the_roller_two_inertias_are_on_one_spring():
    """1/K = 1/k_2 + 2.5^2/k_1 at the load; the motor counts with the square of the ratio 1/1.25."""
    k = 1.0 / (1.0 / 2e3 + 2.5**2 / 9e4)
    motor, load = 3e-4 / 1.25**2, 5e-3
    found = natural_frequencies(chain(3e-4, 0.0, load, (9e4, 2e3)))
    assert found.locked == pytest.approx(math.sqrt(k / load) / (2 * math.pi), rel=1e-12)
    both = 1.0 / motor + 1.0 / load
    assert found.free == pytest.approx(math.sqrt(k * both) / (2 * math.pi), rel=1e-12)


def test_a_soft_mode_of_nothing_between_motor_and_load_is_not_the_joints():
    """A mass on a spring of its own, far softer than the joint."""
    joint = chain(3e-4, 2e-4, 5e-3, (9e4, 2e3))
    alone = joint._replace(
        laws=np.pad(joint.laws, (0, 1)) + np.diag([0.0, 0.0, 1.0]),
        elongation=np.vstack([np.insert(joint.elongation, 0, 0.0, axis=1), [1.0, 0.0, 0.0, 0.0]]),
        slides=np.zeros(3, dtype=bool),
        bearings=np.zeros(4),
        creep=np.zeros((3, 3)),
        mass=np.pad(joint.mass, (1, 0)) + np.diag([1.0, 0.0, 0.0, 0.0]),
        rigid=np.insert(joint.rigid, 0, 0.0),
        moves=1,
    )
    assert natural_frequencies(alone) == pytest.approx(natural_frequencies(joint), rel=1e-9)


def test_springs_that_are_not_known_have_no_frequency():
    joint = chain(3e-4, 2e-4, 5e-3, (math.nan, 2e3))
    assert all(map(math.isnan, natural_frequencies(joint)))
    found = frequency_response(joint=joint, frequency=np.array([1.0]), loss_factor=0.0)
    assert np.isnan(found.motor).all()


def test_everything_as_the_motor_moves_it_by_hand():
    """Load held: the roller turns by 2.5^2 k_2 ... it is a lever between two springs, k_1/2 of (k_1 + 2.5^2 k_2)."""
    one, other = 9e4, 2e3
    turned = 0.5 * one / (one + 2.5**2 * other)
    found = inertia_at_motor(chain(3e-4, 2e-4, 5e-3, (one, other)))
    assert found == pytest.approx(3e-4 + 2e-4 * turned**2, rel=1e-12)


def test_the_loss_factor_turns_all_springs():
    """The load follows the motor on one spring K (1 + i eta)."""
    joint = chain(3e-4, 0.0, 5e-3, (9e4, 2e3))
    k = 1.0 / (1.0 / 2e3 + 2.5**2 / 9e4)
    frequency = 100.0
    omega = 2.0 * math.pi * frequency
    found = frequency_response(joint=joint, frequency=np.array([frequency]), loss_factor=0.02)
    spring = k * (1.0 + 0.02j)
    assert complex(found.load[0] / found.motor[0]) == pytest.approx(
        spring / (spring - 5e-3 * omega**2), rel=1e-9
    )


@pytest.mark.slow
def test_response_is_that_of_the_differential_equations():
    """Springs and dampers in series on both sides of a roller, integrated until the start has died away."""
    springs, dampers = np.array([900.0, 400.0]), np.array([40.0, 15.0])
    first, middle, last, frequency = 0.05, 0.02, 0.8, 6.0
    omega = 2 * math.pi * frequency
    rows = np.array([[-0.5, 1.0, 0.0], [0.0, -2.5, 1.0]])
    mass = np.array([first, middle, last])

    def rates(t, y):
        angles, moving, lost = y[:3], y[3:6], y[6:]
        torques = springs * (rows @ angles - lost)
        load = np.array([math.cos(omega * t), 0.0, 0.0])
        return np.concatenate([moving, (load - rows.T @ torques) / mass, torques / dampers])

    end = 300 / frequency
    t = np.linspace(end - 1 / frequency, end, 400, endpoint=False)
    y = solve_ivp(rates, (0.0, end), np.zeros(8), t_eval=t, rtol=1e-9, atol=1e-13, method="DOP853").y
    joint = chain(first, middle, last, springs, creep=np.diag(1.0 / dampers))
    found = frequency_response(joint=joint, frequency=np.array([frequency]), loss_factor=0.0)
    turning, ratio = np.exp(-1j * omega * t), 1.0 / 1.25
    for speed, angle, scale in ((y[3], found.motor, ratio**2), (y[5], found.load, ratio)):
        # of the speeds: the angles drift by their start; torque and angle of the motor referred to the load
        amplitude = 2.0 * np.mean(speed * turning) / (1j * omega)
        assert complex(angle[0]) * scale == pytest.approx(complex(amplitude), rel=2e-5)


def test_motor_stands_at_the_antiresonance():
    joint = chain(3e-4, 2e-4, 5e-3, (9e4, 2e3))
    locked = natural_frequencies(joint).locked
    found = frequency_response(joint=joint, frequency=np.array([locked]), loss_factor=0.0)
    assert abs(found.motor[0]) < 1e-9 * abs(found.load[0])


@pytest.fixture(scope="module")
def planetary(planar_joint):
    return in_motion(as_numbers(planar_joint("planetary")))


def springs_of(drive, rng):
    count = len(drive.contacts)
    coupling = rng.normal(size=(2 * count, 2 * count))
    return {
        "drive": drive,
        "normal_compliance": rng.uniform(1.0, 3.0, count) * 1e-9,
        "tangential_compliance": rng.uniform(1.0, 3.0, count) * 1e-9,
        "coupling": 1e-10 * (coupling + coupling.T),
        "pin_compliance": 2e-9,
        "sliding_friction": np.zeros(count),
        "support_stiffness": None,
        "supports": None,
    }


@pytest.mark.parametrize(
    "name",
    [
        "planetary",
        *(
            pytest.param(name, marks=pytest.mark.slow)
            for name in ("multiroller", "stepped_planet", "zou2025")
        ),
    ],
)
def test_under_a_slow_torque_the_drive_gives_way_as_its_network_does(planar_joint, name):
    """A motor far too heavy to move, and no masses between it and the load: 1/K and the shafts in series."""
    joint = in_motion(as_numbers(planar_joint(name)))
    given = springs_of(joint.drive, np.random.default_rng(2))
    springs = jax.tree.map(np.asarray, spring_laws(**given))
    members = joint.drive.members
    turns = np.asarray(speeds(joint.drive))
    ratio = turns[members.index(joint.drive.input)] / turns[members.index(joint.drive.output)]
    nothing = np.zeros((np.shape(springs.elongation)[1],) * 2)
    made = sprung_drive(
        drive=joint.drive, springs=springs, shafts=(2e-3, 3e-6), mass=nothing, ends=(1e6, 0.05), creep=None
    )
    np.testing.assert_allclose(made.elongation @ made.rigid, 0.0, atol=1e-15)
    compliance = 1.0 / float(network_stiffness(**given).output) + 2e-3 / ratio**2 + 3e-6
    expected = 1.0 / math.sqrt(compliance * 0.05) / (2.0 * math.pi)
    assert natural_frequencies(made).locked == pytest.approx(expected, rel=1e-9)
    assert made.total_inertia == pytest.approx(0.05 + 1e6 * ratio**2, rel=1e-12)


def test_a_contact_that_slides_follows_its_normal_force(planetary):
    """f_t = mu f_n in place of its spring, in the network and in the vibration."""
    given = springs_of(planetary.drive, np.random.default_rng(3)) | {"coupling": None}
    given["sliding_friction"] = np.array([0.0, 0.08])
    springs = jax.tree.map(np.asarray, spring_laws(**given))
    assert springs.slides.tolist() == [False, False, False, True, False]
    nothing = np.zeros((np.shape(springs.elongation)[1],) * 2)
    made = sprung_drive(
        drive=planetary.drive, springs=springs, shafts=(0.0, 0.0), mass=nothing, ends=(1e6, 0.05), creep=None
    )
    stiffness = float(network_stiffness(**given).output)
    found = natural_frequencies(made).locked
    assert (2.0 * math.pi * found) ** 2 * 0.05 == pytest.approx(stiffness, rel=1e-6, abs=1e-3)


def test_rigid_rings_and_all_masses_at_motor_and_load_leave_kinematics(planetary):
    """Of springs a millionfold stiffer than the output shaft rolling without slip remains: spins by the ratio."""
    drive, members = planetary.drive, planetary.drive.members
    given = springs_of(drive, np.random.default_rng(4)) | {"coupling": None}
    stiff = {
        name: given[name] * 1e-6 for name in ("normal_compliance", "tangential_compliance", "pin_compliance")
    }
    springs = jax.tree.map(np.asarray, spring_laws(**given | stiff))
    masses, spins = np.array([0.03, 0.1, 0.2]), np.array([1e-6, 2e-5, 6e-4])
    mass = mass_matrix(drive=drive, masses=masses, spins=spins)
    made = sprung_drive(
        drive=drive, springs=springs, shafts=(0.0, 1e-6), mass=mass, ends=(2e-5, 0.05), creep=None
    )
    turns = np.asarray(speeds(drive))
    carrier = turns[members.index(CARRIER)]
    inner = 1e-6 + 2e-5 + 3.0 * (2e-5 * turns[1] ** 2 + 0.1 * carrier**2 * np.sum(drive.centres[1] ** 2))
    inner = inner / carrier**2
    free = math.sqrt(1e6 * (1.0 / inner + 1.0 / 0.05)) / (2.0 * math.pi)
    assert natural_frequencies(made).free == pytest.approx(free, rel=1e-4)
    # with the motor held only the load moves
    assert natural_frequencies(made).locked == pytest.approx(
        math.sqrt(1e6 / 0.05) / (2.0 * math.pi), rel=1e-4
    )


def test_creep_acts_in_the_contacts_of_one_sector(planetary):
    """Of three planets side by side each bears a third; a heavy motor and load leave the creep of the rollers."""
    drive = planetary.drive
    springs = jax.tree.map(np.asarray, spring_laws(**springs_of(drive, np.random.default_rng(5))))
    count, rate = len(drive.contacts), np.array([2e-7, 3e-7])
    nothing = np.zeros((np.shape(springs.elongation)[1],) * 2)
    made = sprung_drive(
        drive=drive,
        springs=springs,
        shafts=(0.0, 0.0),
        mass=nothing,
        ends=(1e3, 1e3),
        creep=(np.zeros(count), rate),
    )
    frequency = 1e-3
    found = frequency_response(joint=made, frequency=np.array([frequency]), loss_factor=0.0)
    through = 1e3 / (1e3 + 36.0 * 1e3)
    slow = complex((found.motor - found.load)[0]) / through * 2j * math.pi * frequency
    # 1 N·m at the carrier is 1/6 N·m at the sun of 10 mm; either contact creeps over the sun's path, times the ratio
    force = 1.0 / (6.0 * 3.0 * 10e-3)
    lost = force**2 * 3.0 * rate.sum()
    assert slow.real == pytest.approx(lost, rel=1e-6)


def test_matrices_are_those_of_the_incidence(planetary):
    """Approaches, slips and pins in this order, with the rotations of all members behind the displacements."""
    drive = planetary.drive
    made = spring_laws(**springs_of(drive, np.random.default_rng(6)))
    matrices, moves = incidence(drive), 2 * len(drive.floating)
    count = len(drive.contacts)
    assert isinstance(made, SpringLaws)
    np.testing.assert_allclose(made.elongation[:count, :moves], matrices.approach)
    np.testing.assert_allclose(made.elongation[count : 2 * count, moves:], matrices.turning)
    np.testing.assert_allclose(made.elongation[2 * count :, :moves], matrices.pins)
    assert dataclasses.replace(drive).members[-1] == CARRIER
