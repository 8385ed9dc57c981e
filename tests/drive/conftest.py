"""States of one drive of each kind."""

import functools

import numpy as np
import pytest

from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.states import rolling_state, state_at_rest
from asperity.drive.types.multiroller import two_row_multiroller
from asperity.drive.types.planetary import planetary_drive
from asperity.drive.types.stepped_planet import stepped_planet_drive
from asperity.drive.types.wedge import wedge_drive
from asperity.engine.control import at_once, traced_once


@pytest.fixture(scope="session")
def drives():
    return {
        "wedge": wedge_drive(DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0), planet_count=3),
        "planetary": planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=3),
        "multiroller": two_row_multiroller(
            sun_radius=10e-3, first_row_radii=(22e-3, 9e-3), second_row_radii=(25e-3, 14e-3), roller_count=4
        ),
        "stepped": stepped_planet_drive(sun_radius=10e-3, planet_radii=(20e-3, 18e-3), planet_count=3),
    }


@pytest.fixture(scope="session")
def steel_laws():
    """Laws of the contacts of a drive of steel, 5 mm long, in rings with walls of 60 mm."""
    return functools.partial(
        smooth_contact_laws,
        youngs_modulus=206e9,
        poisson_ratio=0.3,
        friction_coefficient=0.12,
        contact_length=5e-3,
        ring_wall_thickness=60e-3,
        reference_force=500.0,
    )


@pytest.fixture(scope="session")
def solved(drives, steel_laws):
    """State at rest and rolling state of a drive under 1000 N and an output torque."""

    @traced_once
    def states(drive, torque, preload, wall):
        laws = steel_laws(drive=drive, ring_wall_thickness=wall)
        pattern = np.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
        rest = state_at_rest(drive=drive, laws=laws, pattern=pattern, preload=preload)
        rolling = rolling_state(
            drive=drive, laws=laws, interference=rest.interference, output_torque=torque, start=rest
        )
        return rest, rolling

    def of(name, torque, preload=1000.0, wall=60e-3):
        return at_once(states, drives[name], torque, preload, wall)

    return of
