"""The paper's statics by NumPy and within a program of JAX: equal numbers and slopes, also at borders."""

import dataclasses

import numpy as np
from both_engines import Engines, Formula, rows

from asperity.drive.bearings import Bearings
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.drive.normal_springs import NormalSprings
from asperity.zou2025 import kinematics, mechanism
from asperity.zou2025.force_balance import force_balance

GEOMETRY = {
    "sun_radius": (3.8e-3, 4.4e-3),
    "planet_radius": (13.4e-3, 13.8e-3),
    "loading_roller_radius": (5.0e-3, 5.3e-3),
    "ring_radius": (40e-3, 40e-3),
    "planet_count": (3.0, 3.0),
    "left_push_angle": (-0.2, 0.2),
    "right_push_angle": (-0.2, 0.2),
}
SPRINGS = {
    "secant": (1e-8, 2e-8),
    "incremental": (8e-9, 9e-9),
}
JOINT = {
    "sun_radius": 4e-3,
    "planet_radius": 13.5e-3,
    "loading_roller_radius": 5e-3,
    "torque": 4.0,
    "preload": 1000.0,
}


def of_geometry(**numbers):
    geometry = DriveGeometry(**numbers)
    sides = triangle(geometry)
    return (
        sides,
        mechanism.rest_state(geometry=geometry, sides=sides, preload=1000.0),
        kinematics.speed_ratio(geometry),
        kinematics.contact_radii(geometry),
        kinematics.carrier_speed(geometry=geometry, sun_speed=600.0),
    )


def steepest(*, secant, incremental):
    return mechanism.steepest_compliance(NormalSprings(secant, incremental))


def balance(closure):
    """Forces of the paper's drive, and whether they are solved: residuals are only rounding."""

    def forces(numbers):
        torque, preload, *radii = (numbers[name] for name in ("torque", "preload", *list(JOINT)[:3]))
        geometry = DriveGeometry(*radii, 40e-3, 3.0, 0.0, 0.1)
        sides = triangle(geometry)
        secant = np.linspace(1.0e-8, 1.4e-8, 5)
        joint = mechanism.Mechanism(
            geometry=geometry,
            sides=sides,
            rest=mechanism.rest_state(geometry=geometry, sides=sides, preload=preload),
            bearings=Bearings(1e-3, 5e-4, 5e-3, 2e-3, 4e-3),
            springs=NormalSprings(secant, 0.9 * secant),
            preload=preload,
            carrier_speed=kinematics.carrier_speed(geometry=geometry, sun_speed=600.0),
            planet_mass=0.02,
            loading_roller_mass=0.003,
            closure=closure,
        )
        found = force_balance(mechanism=joint, output_torque=torque)
        closes = {name: getattr(found, name) < 1e-12 for name in ("balance_residual", "closure_residual")}
        return dataclasses.replace(found, **closes)

    return forces


FORMULAS = {
    "geometry": rows(of_geometry, GEOMETRY, {"left_push_angle": 0.0, "right_push_angle": 0.0}),
    "steepest compliance": rows(steepest, SPRINGS),
}
LARGE = {
    f"force balance, {closure}": Formula(balance(closure), JOINT)
    for closure in ("elastic", "constant_pin_force")
}

test_both_engines_compute_the_same_numbers, test_slopes_under_numpy_are_those_of_jax = Engines(
    FORMULAS, alone=LARGE
).tests()
