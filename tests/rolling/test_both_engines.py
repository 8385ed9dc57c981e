"""The formulas of joints that turn by NumPy and within programs of JAX: equal numbers and slopes."""

import dataclasses
import math

import numpy as np
import pytest
from both_engines import Engines, Formula, engine_tests, rows
from joint_changes import CROWNS, SKEW, SPRINGS
from machines import laws_and_states
from rolled_joint import Lives, Rolled

from asperity.drive.state.state import BodiesOfContacts
from asperity.engine.arrays import as_numbers
from asperity.joint.assembled import Pressed
from asperity.joint.description import in_motion, joint_contacts
from asperity.joint.machine import joint_machine
from asperity.rolling import creep, life, onset, power, surface
from asperity.rolling.conditions import PLAIN_ROLLING, DutyPoint, RollingConditions
from asperity.rolling.duty import duty_life
from asperity.rolling.rolling import turning
from asperity.rolling.turning import rolling_at

CLEAN = """[life]
cleanliness = 0.5

[lubrication]
pressure_coefficient = "20 1/GPa"
roughness = "0.2 um"
"""
JOINTS = {
    "parallel": SPRINGS,
    "skewed": {**SPRINGS, "[lubrication]": SKEW},
    "crowned": {**SPRINGS, "[load]": CROWNS},
    "crowned, with a film factor": {**SPRINGS, "[load]": CROWNS, "[lubrication]": CLEAN},
}
#: A drive of three kinds of bodies; the first and the last are shared by all branches.
BODIES = BodiesOfContacts(
    names=("sun", "planet", "ring"), shared=(True, False, True), driving=(0, 1), driven=(1, 2)
)
#: Lives of both tracks of both contacts; the last of them does not tire, or is not known.
TRACKS = np.array([[1e6, 2e7], [3e6, 4e7]])
ENDLESS, UNKNOWN = (np.where(TRACKS == 4e7, value, TRACKS) for value in (np.inf, np.nan))
#: Contacts in series, of which the second slips.
SERIES = {
    "half_width": np.array([8e-5, 2e-4]),
    "slip_ratio": np.array([0.4, 1.0]),
    "share": np.array([0.7, 0.3]),
    "distance": np.array([0.05, 0.06]),
    "input_angle": 6.0,
    "drift_per_output_turn": 2e-3,
}
#: Angles below a swing that drifts, between, and far beyond the tables.
TURNED = np.array([0.0, 1e-3, 3e-3, 2e-2, 1.0])


def of_duty(torque, speed, share):
    """Lives that fall with the cube of the torque."""

    def rolled(torque, speed):
        ratio = np.array([0.2, 0.3]) * abs(torque)
        hours = Lives(1e4 / abs(torque) ** 3)
        cycles = 1e9 / abs(torque) ** 3 * np.ones((2, 2))
        return Rolled(cycles, np.ones((2, 2)), speed / 6.0, hours, ratio, ratio, ratio)

    points = tuple(DutyPoint(torque[k], speed[k], share[k]) for k in range(3))
    conditions = RollingConditions(**(vars(PLAIN_ROLLING) | {"duty": points, "reliability": 0.99}))
    return duty_life(conditions=conditions, bodies=BODIES, branches=3.0, rolled=rolled)


def of_tracks(tracks, branches):
    given = {"bodies": BODIES, "tracks": tracks, "branches": branches}
    return life.drive_lives(**given), life.failure_shares(**given)


def of_series(angle, **numbers):
    contacts = onset.ContactsInSeries(**numbers)
    return onset.creep_lag(contacts=contacts, angle=angle)


def of_swings(angle, **numbers):
    return onset.swing_drift(contacts=onset.ContactsInSeries(**numbers), angle=angle)


def of_speeds(*, loss, output_torque, output_speed, input_speed):
    found = power.RollingPower(*[loss] * 10)
    speeds = {"output_speed": output_speed, "input_speed": input_speed}
    return power.rolling_input_torque(power=found, output_torque=output_torque, **speeds)


def of_creep(joint, normal, tangential):
    """The creep law of the contacts, and what skew does to their friction."""
    contacts = joint_contacts(joint)
    at = {"normal_force": normal, "tangential_force": tangential}
    law = creep.contact_creep(contacts=contacts, skew=joint.rolling.skew, **at)
    lines = contacts.loads_along(normal)
    pairs = contacts.pairs
    return (
        law,
        creep.contact_friction(pairs=pairs, creep=law, normal_force=normal, creepage=tangential * 1e-5),
        surface.rolling_strips(contacts=contacts, normal_force=normal, traction=tangential / normal),
        surface.mean_half_width(pairs=pairs, lines=lines, normal_force=normal),
        power.oil_drag(
            pairs=pairs, viscosity=0.03, normal_force=normal, rolling_speed=abs(tangential), lines=lines
        ),
    )


def of_rolling(joint, state):
    """A joint that turns, from its rolling state."""
    return turning(joint_machine(joint), state)


def of_onset(drive, rolling, half_width):
    found = onset.contacts_in_series(drive=drive, rolling=rolling, half_width=half_width)
    # known as well as the speeds whose difference it is
    return dataclasses.replace(found, drift_per_output_turn=1.0 + found.drift_per_output_turn)


def of_torques(joint, laws, rest, torque, speed):
    """Steady rolling at another torque and speed, as a duty has it."""
    found = rolling_at(joint_machine(joint), Pressed(laws, rest))(torque, speed)
    return found.normal, found.tangential, 1.0 + found.speed_loss, found.power.oil, found.life_turns


def given(function, **numbers):
    return Formula(lambda these: function(**these), numbers)


SPEEDS = {
    "loss": (1.0, 50.0),
    "output_torque": (-9.0, 9.0),
    "output_speed": (10.0, 50.0),
    "input_speed": (-300.0, 300.0),
}
SMALL = {
    "lives": given(of_tracks, tracks=TRACKS, branches=3.0),
    "lives of which one is endless": given(of_tracks, tracks=ENDLESS, branches=3.0),
    "lives of which one is unknown": given(of_tracks, tracks=UNKNOWN, branches=3.0),
    "life at a rate": rows(life.life_at_rate, {"rate": (1e-9, 1e-6)}),
    "duty": given(
        of_duty,
        torque=np.array([2.0, 5.0, -9.0]),
        speed=np.array([100.0, 300.0, 0.0]),
        share=np.array([0.5, 0.3, 0.2]),
    ),
    "creep lag": given(of_series, angle=TURNED, **SERIES),
    "swings": given(of_swings, angle=TURNED, **SERIES),
    "input torque": rows(of_speeds, SPEEDS),
}
#: Forces of both contacts: usual ones, one lifted, one at gross slip, none tangential, and one unknown.
FORCES = {
    "": ([1000.0, 1100.0], [50.0, -50.0]),
    ", one lifted": ([0.0, 1100.0], [0.0, 60.0]),
    ", one slips": ([1000.0, 1100.0], [80.0, -50.0]),
    ", no traction": ([1000.0, 1100.0], [0.0, 0.0]),
    ", one unknown": ([1000.0, math.nan], [50.0, 50.0]),
}
CREEPS = [
    f"creep, {name}{forces}"
    for name in JOINTS
    for forces in (("", ", one unknown") if name.startswith("crowned") else FORCES)
]
LARGE = [*CREEPS, *(f"rolling, {name}" for name in JOINTS), "onset", "at another torque"]


@pytest.fixture(scope="module")
def engines(planar_joint):
    found = {}
    for name, replaced in JOINTS.items():
        joint = as_numbers(planar_joint("planetary", replaced))
        joint = in_motion(joint)
        for label, forces in FORCES.items():
            normal, tangential = map(np.array, forces)
            found[f"creep, {name}{label}"] = given(
                of_creep, joint=joint, normal=normal, tangential=tangential
            )
        laws, states = laws_and_states(joint)
        found[f"rolling, {name}"] = given(of_rolling, joint=joint, state=states.rolling)
        if name == "parallel":
            rolling = of_rolling(joint, states.rolling)
            width = np.array([8e-5, 2e-4])
            found["onset"] = given(of_onset, drive=joint.drive, rolling=rolling, half_width=width)
            found["at another torque"] = given(
                of_torques, joint=joint, laws=laws, rest=states.rest, torque=6.0, speed=-200.0
            )
    return Engines(SMALL, alone=found)


NAMES = [*SMALL, *(pytest.param(name, marks=pytest.mark.slow) for name in LARGE)]


test_both_engines_compute_the_same_numbers, test_slopes_under_numpy_are_those_of_jax = engine_tests(NAMES)
