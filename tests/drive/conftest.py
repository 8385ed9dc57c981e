"""Forces of batches of drives, and states of one drive of each kind."""

import functools
import math

import numpy as np
import pytest

from asperity.contact.roller_pairs import roller_pairs
from asperity.drive.layout.drives import (
    planetary_drive,
    stepped_planet_drive,
    two_row_multiroller,
    wedge_drive,
)
from asperity.drive.mechanism import Bearings, Mechanism, leading_sense, rest_state
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.states import rolling_state, state_at_rest
from asperity.drive.wedge.force_balance import force_balance
from asperity.drive.wedge.geometry import DriveGeometry, carrier_speed, contact_radii, triangle
from asperity.engine.control import at_once, traced_once
from asperity.joint.contacts import JointContacts, bulk_springs
from asperity.materials import Material, pair

STANDARD = {
    "sun_radius": 4e-3,
    "planet_radius": 13.5e-3,
    "loading_roller_radius": 5e-3,
    "ring_radius": 40e-3,
    "planet_count": 3.0,
    "left_push_angle": 0.0,
    "right_push_angle": 0.0,
    "sun_torque": 0.0,
    "loading_roller_torque": 0.0,
    "carrier_torque": 0.0,
    "pin_friction_coefficient": 0.0,
    "pin_diameter": 0.0,
    "ring_wall_thickness": 10e-3,
    "contact_length": 5e-3,
    "preload": 1000.0,
    "sun_speed": 6000 * np.pi / 30,
    "youngs_modulus": 206e9,
    "density": 7850.0,
    "output_torque": 5.0,
}


def _mechanism(*, closure="elastic", **changes):
    """The paper's drive of steel with changes; friction of the bearings opposes its rotation."""
    assert not changes.keys() - STANDARD.keys()
    x = STANDARD | changes
    names = list(STANDARD)
    geometry = DriveGeometry(*(x[name] for name in names[:7]))
    against = leading_sense(rotation=x["sun_speed"], output_torque=x["output_torque"])
    torques, diameter = [against * x[name] for name in names[7:11]], x["pin_diameter"]
    sides = triangle(geometry)
    rest = rest_state(geometry=geometry, sides=sides, preload=x["preload"])
    radius_1, radius_2, sign = contact_radii(geometry)
    steel = Material(x["youngs_modulus"], 0.3, x["density"], 450e6, 1260e6)
    contacts = JointContacts(
        pairs=roller_pairs(
            radius_1=radius_1,
            radius_2=radius_2,
            sign=sign,
            contact_length=x["contact_length"],
            friction_coefficient=0.12,
            moduli=pair(steel, steel),
            surface=None,
        ),
        driving=steel,
        driven=steel,
        ring_wall_thickness=x["ring_wall_thickness"],
        contact_factor_model="printed",
    )
    planet, roller = (
        x["density"] * math.pi * x[name] ** 2 * x["contact_length"]
        for name in ("planet_radius", "loading_roller_radius")
    )
    return Mechanism(
        geometry=geometry,
        sides=sides,
        rest=rest,
        bearings=Bearings(*torques, diameter),
        springs=bulk_springs(contacts=contacts, half_width=contacts.pairs.half_width(rest.normal_force)),
        preload=x["preload"],
        carrier_speed=carrier_speed(geometry=geometry, sun_speed=x["sun_speed"]),
        planet_mass=planet,
        loading_roller_mass=roller,
        closure=closure,
    )


def _balance(numbers, *, closure):
    return force_balance(
        mechanism=_mechanism(closure=closure, **numbers), output_torque=numbers["output_torque"]
    )


_BALANCE = traced_once(_balance, fixed=("closure",))


def _numbers(forces):
    names = ("sp", "pwr", "pwl", "wro", "wlo")
    flat = {f"N_{name}": value for name, value in zip(names, forces.normal, strict=True)}
    flat |= {f"T_{name}": value for name, value in zip(names, forces.tangential, strict=True)}
    flat |= {"F_cl": forces.pin_left, "F_cr": forces.pin_right}
    flat |= {"T_in": forces.input_torque, "T_out": forces.output_torque}
    flat |= {"B_l": forces.left_bearing_torque, "B_r": forces.right_bearing_torque}
    return flat


@pytest.fixture(scope="session")
def mechanism():
    """Maker of the paper's drive with changes, for the balance of its forces."""
    return _mechanism


@pytest.fixture(scope="session")
def solved_forces():
    """The force balance of a batch of drives: numbers by name, of one shape, and the closure."""

    def solve(numbers, closure):
        (shape,) = {np.shape(value) for value in numbers.values()}
        whole = {name: np.full(shape, value) for name, value in STANDARD.items()} | numbers
        return at_once(functools.partial(_BALANCE, closure=closure), whole)

    return solve


@pytest.fixture(scope="session")
def forces_of(solved_forces):
    """Forces of a batch of the paper's drive with changes, as a dictionary of arrays of the length of the changes."""

    def solve(*, closure="elastic", **changes):
        rows = np.broadcast_arrays(*(np.atleast_1d(value).astype(float) for value in changes.values()))
        forces = solved_forces(dict(zip(changes, rows, strict=True)), closure)
        return _numbers(forces) | {"balance": forces.balance_residual, "closure": forces.closure_residual}

    return solve


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
