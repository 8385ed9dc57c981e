"""Forces of batches of the paper's drive; its curves, computed once for all tests; made-up curves for single claims."""

import functools
import math
from collections.abc import Callable
from dataclasses import fields

import numpy as np
import pytest

from asperity.contact.roller_pairs import roller_pairs
from asperity.drive.bearings import Bearings, leading_sense
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.engine.control import at_once, traced_once
from asperity.joint.contacts import JointContacts, bulk_springs
from asperity.materials import Material, pair
from asperity.zou2025.claims import judge
from asperity.zou2025.criteria import Claim
from asperity.zou2025.curves import Curves, JointCurves, PairCurve, compute
from asperity.zou2025.force_balance import force_balance
from asperity.zou2025.kinematics import carrier_speed, contact_radii
from asperity.zou2025.mechanism import Mechanism, rest_state

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
def curves() -> Curves:
    return compute()


@pytest.fixture(scope="session")
def claims(curves: Curves) -> dict[str, Claim]:
    return {claim.name: claim for claim in judge(curves)}


def _sweep(known: dict) -> JointCurves:
    return JointCurves(**{field.name: known.get(field.name, np.empty(0)) for field in fields(JointCurves)})


@pytest.fixture(scope="session")
def made_up() -> Callable[..., Curves]:
    """Maker of curves: ``pairs`` maps a case to (values, K_t), every other keyword a sweep to its known fields."""

    def make(*, pairs: dict | None = None, **sweeps: dict) -> Curves:
        return Curves(
            pairs={case: PairCurve("", *known) for case, known in (pairs or {}).items()},
            **{f.name: _sweep(sweeps.get(f.name, {})) for f in fields(Curves) if f.name != "pairs"},
        )

    return make
