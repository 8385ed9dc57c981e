"""States of one drive of each kind."""

import sys
from pathlib import Path

import numpy as np
import pytest
from steel_laws import steel_laws

from asperity.drive.layout.wedge_geometry import DriveGeometry
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
def solved(drives):
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


@pytest.fixture(scope="session")
def dense_assembly():
    """The dense baseline: all planets, the sun free to move sideways, rigid springs as constraints."""
    folder = str(Path(__file__).parents[2] / "benchmarks")
    sys.path.insert(0, folder)
    try:
        from baseline_assembly import torsional_stiffness_of_assembly
    finally:
        sys.path.remove(folder)
    return torsional_stiffness_of_assembly
