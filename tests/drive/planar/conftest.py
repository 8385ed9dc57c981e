"""Drives of every type, and their states for smooth steel bodies."""

import equinox as eqx
import jax.numpy as jnp
import pytest

from asperity.drive.geometry import DriveGeometry
from asperity.drive.planar.drives import (
    planetary_drive,
    stepped_planet_drive,
    two_row_multiroller,
    wedge_drive,
)
from asperity.drive.planar.laws import smooth_contact_laws
from asperity.drive.planar.states import rolling_state, state_at_rest


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

    @eqx.filter_jit
    def states(drive, torque, preload, wall):
        laws = smooth_contact_laws(
            drive=drive,
            youngs_modulus=206e9,
            poisson_ratio=0.3,
            friction_coefficient=0.12,
            contact_length=5e-3,
            ring_wall_thickness=wall,
            reference_force=500.0,
        )
        pattern = jnp.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
        rest = state_at_rest(drive=drive, laws=laws, pattern=pattern, preload=preload)
        rolling = rolling_state(
            drive=drive, laws=laws, interference=rest.interference, output_torque=torque, start=rest
        )
        return rest, rolling

    def of(name, torque, preload=1000.0, wall=60e-3):
        return states(drives[name], jnp.asarray(torque), jnp.asarray(preload), jnp.asarray(wall))

    return of
