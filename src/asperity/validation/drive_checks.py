"""Drives: speed ratios, forces and creep, against formulas, hand calculations and an independent computation."""

from __future__ import annotations

from collections.abc import Iterator

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.layout.drive import Drive, speed_ratio
from asperity.drive.layout.drives import (
    planetary_drive,
    stepped_planet_drive,
    two_row_multiroller,
    wedge_drive,
)
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.state import DriveState
from asperity.drive.state.states import rolling_state, state_at_rest
from asperity.drive.wedge.geometry import DriveGeometry
from asperity.validation.check import Check, compared

_WEDGE = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
_STATE = "Forces and creep of the wedge drive"
_INDEPENDENT = "independent rigid bodies in the plane, Hertz and Carter: the paper's radii, 1000 N, 5 N·m"


def ratios() -> Iterator[Check]:
    """Speed ratios of every type of drive by their formulas."""
    multiroller = two_row_multiroller(
        sun_radius=10e-3, first_row_radii=(22e-3, 9e-3), second_row_radii=(25e-3, 14e-3), roller_count=5
    )
    ring = float(multiroller.second_radius[-1])
    drives = {
        "wedge drive": (wedge_drive(_WEDGE, planet_count=3), "1 - R_o/R_s", -9.0),
        "plain planetary": (
            planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=3),
            "1 + R_r/R_s",
            6.0,
        ),
        "stepped planets": (
            stepped_planet_drive(sun_radius=10e-3, planet_radii=(20e-3, 18e-3), planet_count=3),
            "(1 + R_1/s)/(1 - R_1 p_2/(R_2 p_1))",
            (1.0 + 50.0 / 10.0) / (1.0 - 50.0 * 18.0 / (48.0 * 20.0)),
        ),
        "two-row multiroller": (
            multiroller,
            "(x_1/s)(x_2/y_1)(R_r/y_2)",
            (22.0 / 10.0) * (25.0 / 9.0) * ring / 14e-3,
        ),
    }
    for name, (drive, formula, expected) in drives.items():
        found = float(speed_ratio(drive))
        yield compared(
            model="Kinematics of roller drives",
            reference=formula,
            quantity=f"speed ratio of the {name}",
            unit="-",
            expected=expected,
            found=abs(found) if name == "two-row multiroller" else found,
            tolerance=1e-12,
        )


@eqx.filter_jit
def _states(drive: Drive, torque: Array) -> tuple[DriveState, DriveState]:
    laws = smooth_contact_laws(
        drive=drive,
        youngs_modulus=206e9,
        poisson_ratio=0.3,
        friction_coefficient=0.12,
        contact_length=5e-3,
        ring_wall_thickness=60e-3,
        reference_force=500.0,
    )
    pattern = jnp.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
    rest = state_at_rest(drive=drive, laws=laws, pattern=pattern, preload=jnp.asarray(1000.0))
    rolling = rolling_state(
        drive=drive, laws=laws, interference=rest.interference, output_torque=torque, start=rest
    )
    return rest, rolling


def states() -> Iterator[Check]:
    """The paper's drive at rest and rolling."""
    rest, rolling = _states(wedge_drive(_WEDGE, planet_count=3), jnp.asarray(5.0))
    rows = (
        ("interference under a preload of 1000 N", "µm", 12.904, 1e6 * rest.interference[3], 1e-4),
        (
            "normal forces of the five contacts",
            "N",
            [1001.74, 657.80, 464.95, 646.33, 447.98],
            rolling.normal,
            1e-3,
        ),
        (
            "tangential forces of sun, right and left roller",
            "N",
            [46.2963, 25.4224, 20.8739],
            np.abs(rolling.tangential[:3]),
            5e-4,
        ),
        ("speed loss by creep", "-", 1.633763e-3, rolling.speed_loss, 1e-4),
        ("displacement of the planet", "µm", 2.5515, 1e6 * np.abs(rolling.displacement[0, 0]), 5e-3),
    )
    for quantity, unit, expected, found, tolerance in rows:
        yield compared(
            model=_STATE,
            reference=_INDEPENDENT,
            quantity=quantity,
            unit=unit,
            expected=expected,
            found=np.asarray(found),
            tolerance=tolerance,
        )
    planetary = planetary_drive(sun_radius=10e-3, planet_radius=20e-3, planet_count=3)
    _, loaded = _states(planetary, jnp.asarray(8.0))
    by_hand = 8.0 / (3.0 * 30e-3)
    yield compared(
        model="Forces of the plain planetary",
        reference="statics by hand: 8 N·m on three planets 30 mm from the axis",
        quantity="carrier force and tangential force of a planet",
        unit="N",
        expected=[by_hand, by_hand / 2.0],
        found=[np.max(np.abs(loaded.pin_force)), np.max(np.abs(loaded.tangential))],
        tolerance=1e-10,
    )
