"""What the paper assumes of its drive in place of compatibility, against its own statics, equations (1)–(5)."""

import dataclasses

import numpy as np
import pytest
from steel_laws import steel_laws

from asperity.drive.bearings import Bearings
from asperity.drive.layout.drive import Closure
from asperity.drive.layout.unfolding import unfolded
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.drive.state.state import STATE_TOLERANCE, DriveLoad
from asperity.drive.state.states import drive_states, loaded_state, state_at_rest
from asperity.drive.types.wedge import EQUAL_COEFFICIENTS, SPRING_LOADED_PINS, wedge_drive
from asperity.engine.control import at_once
from asperity.zou2025.force_balance import force_balance
from asperity.zou2025.mechanism import Mechanism, rest_state

GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.1, -0.15)
CLOSURES = {
    "elastic": Closure(EQUAL_COEFFICIENTS),
    "constant_pin_force": Closure(EQUAL_COEFFICIENTS, SPRING_LOADED_PINS),
}
SIDES = triangle(GEOMETRY)
REST = rest_state(geometry=GEOMETRY, sides=SIDES, preload=1000.0)
PATTERN = np.array([0.0, 0.0, 0.0, 1.0, 1.0])
CENTRIFUGAL = 25.0  # of the planet [N]; of a loading roller 10


def laws_of(drive):
    return steel_laws(drive=drive, reference_force=REST.normal_force)


def load_of(drive, torque, *, turns):
    """Torque and centrifugal forces, which act along the radii of the floating bodies."""
    size = np.array([CENTRIFUGAL, 10.0, 10.0])
    centres = drive.centres[1:4]
    radial = centres / np.linalg.norm(centres, axis=1)[:, None]
    return DriveLoad(np.asarray(torque), turns * size[:, None] * radial)


def _states(drive, torque, turns):
    load = load_of(drive, torque, turns=turns)
    return drive_states(drive=drive, laws=laws_of(drive), pattern=PATTERN, preload=1000.0, load=load)


def general(closure, torque, turns):
    drive = wedge_drive(GEOMETRY, planet_count=3.0, closure=closure)
    return at_once(_states, drive, torque, turns)


def by_statics(closure, torque, turns):
    """The reduction of (1)–(5) to two unknowns, its masses those of the same centrifugal forces at 1 rad/s."""
    drive = wedge_drive(GEOMETRY, planet_count=3.0)
    still = Mechanism(
        geometry=GEOMETRY,
        sides=SIDES,
        rest=REST,
        bearings=Bearings(0.0, 0.0, 0.0, 0.0, 0.0),
        springs=laws_of(drive).springs,
        preload=1000.0,
        carrier_speed=turns * 1.0,
        planet_mass=CENTRIFUGAL / SIDES.planet_orbit,
        loading_roller_mass=10.0 / SIDES.roller_orbit,
        closure=closure,
    )
    return at_once(lambda torque: force_balance(mechanism=still, output_torque=torque), torque)


@pytest.mark.parametrize("closure", CLOSURES)
@pytest.mark.parametrize(("torque", "turns"), [(5.0, 0.0), (12.0, 1.0), (-7.0, 1.0)])
def test_forces_are_those_of_the_papers_statics(closure, torque, turns):
    found = general(CLOSURES[closure], torque, turns).standing
    expected = by_statics(closure, torque, turns)
    assert float(found.residual) < STATE_TOLERANCE
    np.testing.assert_allclose(found.normal, expected.normal, rtol=1e-9)
    np.testing.assert_allclose(np.abs(found.tangential), np.abs(expected.tangential), rtol=1e-9)
    np.testing.assert_allclose(np.abs(found.pin_force[0]), expected.pin_right, rtol=1e-9)
    np.testing.assert_allclose(np.abs(found.pin_force[1]), expected.pin_left, rtol=1e-9)


def test_only_the_standing_drive_has_equal_coefficients():
    """In rolling creep decides, with the assumption and without it."""
    with_springs, assumed = general(Closure(), 5.0, 0.0), general(CLOSURES["elastic"], 5.0, 0.0)
    np.testing.assert_allclose(assumed.rolling.tangential, with_springs.rolling.tangential, rtol=1e-9)
    share = [abs(each.standing.tangential / each.standing.normal)[1:3] for each in (with_springs, assumed)]
    assert share[0][1] > 1.2 * share[0][0]
    assert share[1][1] == pytest.approx(float(share[1][0]), rel=1e-12)


def test_the_first_slip_ends_it():
    """With springs the left ring contact slides from 9.7 N·m on while the others carry more; without them none can."""
    torque = 15.0
    assert float(general(Closure(), 12.5, 0.0).standing.residual) < STATE_TOLERANCE
    assert np.any(np.asarray(general(Closure(), 12.5, 0.0).standing.slides))
    beyond = general(CLOSURES["elastic"], torque, 0.0).standing
    expected = by_statics("elastic", torque, 0.0)
    assert np.max(np.abs(expected.tangential) / (0.12 * expected.normal)) > 1.0
    assert not np.isfinite(float(beyond.residual))
    assert not np.any(np.asarray(beyond.slides))


@pytest.mark.parametrize("rolls", [False, True])
def test_every_sector_keeps_the_pin_force_and_the_coefficients_of_its_own(rolls):
    """One planet 2 µm larger: its right pin keeps another force than those of the other two."""
    folded = wedge_drive(GEOMETRY, planet_count=3.0, closure=CLOSURES["constant_pin_force"])
    drive = dataclasses.replace(unfolded(folded, sectors=3), sectors=1.0)
    laws = laws_of(folded)
    laws = dataclasses.replace(
        laws,
        springs=type(laws.springs)(
            *(
                np.tile(each, 3)
                for each in (laws.springs.secant_compliance, laws.springs.incremental_compliance)
            )
        ),
        reference_force=np.tile(laws.reference_force, 3),
        creep=type(laws.creep)(
            *(np.tile(each, 3) for each in (laws.creep.friction_coefficient, laws.creep.gross_slip_scale))
        ),
    )
    added = 2e-6 * np.eye(15)[0]
    rest = state_at_rest(drive=drive, laws=laws, pattern=np.tile(PATTERN, 3), interference=13e-6, added=added)
    state = loaded_state(
        drive=drive,
        laws=laws,
        rest=rest,
        load=DriveLoad(6.0),
        rolls=rolls,
    )
    assert float(state.residual) < STATE_TOLERANCE
    right = np.asarray(rest.pin_force)[::2]
    assert right[0] > 1.05 * right[1]
    np.testing.assert_allclose(np.asarray(state.pin_force)[::2], right, rtol=1e-9)
    if not rolls:
        coefficient = np.abs(np.asarray(state.tangential / state.normal)).reshape(3, 5)
        np.testing.assert_allclose(coefficient[:, 1], coefficient[:, 2], rtol=1e-12)
