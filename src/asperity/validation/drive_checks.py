"""Drives, also with unlike branches, against formulas, hand calculations and an independent computation."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator

import numpy as np
from scipy.optimize import brentq

from asperity.drive.layout.drive import Drive, speed_ratio
from asperity.drive.layout.unfolding import forces_on_centre, unfolded
from asperity.drive.layout.wedge_geometry import DriveGeometry
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.state import DriveLoad, DriveState
from asperity.drive.state.states import DriveStates, drive_states, rolling_state, state_at_rest
from asperity.drive.types.multiroller import two_row_multiroller
from asperity.drive.types.planetary import planetary_drive
from asperity.drive.types.stepped_planet import stepped_planet_drive
from asperity.drive.types.wedge import wedge_drive
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.types import Array
from asperity.validation.check import Check, compared

_WEDGE = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
_STATE = "Forces and creep of the wedge drive"
_INDEPENDENT = "independent rigid bodies in the plane, Hertz and Carter: the paper's radii, 1000 N, 5 N·m"
_YOUNG, _POISSON, _FRICTION, _LENGTH, _WALL = 206e9, 0.3, 0.08, 10e-3, 60e-3
_SUN, _PLANET = 10e-3, 20e-3
_RING = _SUN + 2.0 * _PLANET
_INTERFERENCE, _ERROR, _TORQUE = 20e-6, 2e-6, 8.0
_RIGID, _SOFT = 1e16, 2e8


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
        ratio = float(speed_ratio(drive))
        yield compared(
            model="Kinematics of roller drives",
            reference=formula,
            quantity=f"speed ratio of the {name}",
            unit="-",
            expected=expected,
            computed=abs(ratio) if name == "two-row multiroller" else ratio,
            tolerance=1e-12,
        )


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
    pattern = xp.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
    rest = state_at_rest(drive=drive, laws=laws, pattern=pattern, preload=xp.asarray(1000.0))
    rolling = rolling_state(
        drive=drive, laws=laws, interference=rest.interference, output_torque=torque, start=rest
    )
    return rest, rolling


def states() -> Iterator[Check]:
    """The paper's drive at rest and rolling."""
    drive = wedge_drive(_WEDGE, planet_count=3)
    rest, rolling = at_once(lambda torque: _states(drive, torque), 5.0)
    rows = (
        ("interference under a preload of 1000 N", "µm", 12.904, 1e6 * rest.interference[3], 1e-4),
        (
            "normal forces of the five contacts",
            "N",
            [1001.74, 657.80, 464.95, 646.33, 447.98],
            rolling.normal,
            7.9e-4,
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
    for quantity, unit, expected, computed, tolerance in rows:
        yield compared(
            model=_STATE,
            reference=_INDEPENDENT,
            quantity=quantity,
            unit=unit,
            expected=expected,
            computed=np.asarray(computed),
            tolerance=tolerance,
        )


def _opposed(support: Array) -> tuple[DriveStates, Array]:
    """Two opposed planets, the first too large and the second too small by as much; the sun on its bearings."""
    drive = unfolded(
        planetary_drive(sun_radius=_SUN, planet_radius=_PLANET, planet_count=2), sectors=2, floating=("sun",)
    )
    laws = smooth_contact_laws(
        drive=drive,
        youngs_modulus=_YOUNG,
        poisson_ratio=_POISSON,
        friction_coefficient=_FRICTION,
        contact_length=_LENGTH,
        ring_wall_thickness=_WALL,
        reference_force=500.0,
    )
    inner = xp.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
    added = xp.array([_ERROR, _ERROR, -_ERROR, -_ERROR]) / _INTERFERENCE
    states = drive_states(
        drive=drive,
        laws=laws,
        pattern=inner + added,
        interference=_INTERFERENCE,
        load=DriveLoad(
            output_torque=xp.asarray(_TORQUE), support_stiffness=xp.array([1.0, 0.0, 0.0]) * support
        ),
    )
    rest = states.rest
    centre = forces_on_centre(
        drive=drive,
        bodies=("sun", "ring"),
        normal=rest.normal,
        tangential=rest.tangential,
        pin_force=rest.pin_force,
    )
    return states, centre


def _half_width(force: float, radius: float) -> float:
    modulus = _YOUNG / (2.0 * (1.0 - _POISSON**2))
    return math.sqrt(4.0 * force * radius / (math.pi * modulus * _LENGTH))


_RADII = (_SUN * _PLANET / (_SUN + _PLANET), _PLANET * _RING / (_RING - _PLANET))


def _compression(force: float) -> float:
    """Compression of sun, planet and ring under a force [m]: Johnson 1985, (5.57), and Weber and Banaschek 1953."""
    at_sun, at_ring = (_half_width(force, radius) for radius in _RADII)
    rollers = sum(
        2.0 * math.log(4.0 * radius / width) - 1.0
        for radius, width in ((_SUN, at_sun), (_PLANET, at_sun), (_PLANET, at_ring))
    )
    wall = 2.0 * math.log(2.0 * _WALL / at_ring) - _POISSON / (1.0 - _POISSON)
    return force * (1.0 - _POISSON**2) / (math.pi * _YOUNG * _LENGTH) * (rollers + wall)


def _preloads(moved: float) -> np.ndarray:
    """Normal forces of both planets with the sun off centre, away from the larger one [N]."""
    return np.array(
        [
            brentq(lambda force, approach=approach: _compression(force) - approach, 1.0, 1e5, xtol=1e-9)
            for approach in (_INTERFERENCE + 2.0 * _ERROR - moved, _INTERFERENCE - 2.0 * _ERROR + moved)
        ]
    )


def _creep(force: float, preload: float) -> float:
    """Creepage of both contacts of a planet together, Carter 1926."""
    at_slip = sum(_FRICTION * _half_width(preload, radius) / radius for radius in _RADII)
    return at_slip * (1.0 - math.sqrt(1.0 - force / (_FRICTION * preload)))


def unlike() -> Iterator[Check]:
    """A plain planetary with two opposed planets of unlike radii."""
    check = functools.partial(compared, model="Branches of unlike sizes")
    source = "two opposed planets by hand, 2 µm too large and too small, interference 20 µm: Johnson, Weber–Banaschek"
    held, centre = trees.map(np.asarray, at_once(_opposed, np.asarray(_RIGID)))
    preload = _preloads(0.0)
    yield check(
        reference=source,
        quantity="normal forces of sun and ring on both planets, the sun held",
        unit="N",
        expected=np.repeat(preload, 2),
        computed=np.asarray(held.rest.normal),
        tolerance=1e-6,
    )
    yield check(
        reference=source,
        quantity="force on the bearings of the sun",
        unit="N",
        expected=preload[0] - preload[1],
        computed=float(np.linalg.norm(centre[0])),
        tolerance=1e-6,
    )
    soft, _ = trees.map(np.asarray, at_once(_opposed, np.asarray(_SOFT)))
    moved = brentq(lambda u: _SOFT * u - np.subtract(*_preloads(u)), 0.0, 2.0 * _ERROR, xtol=1e-18)
    yield check(
        reference=f"{source}; the sun on bearings of 200 N/µm",
        quantity="displacement of the sun",
        unit="µm",
        expected=1e6 * moved,
        computed=1e6 * float(np.linalg.norm(soft.rest.displacement[0])),
        tolerance=1e-6,
    )
    both = 0.5 * _TORQUE / (_SUN + _PLANET)
    first = brentq(lambda t: _creep(t, preload[0]) - _creep(both - t, preload[1]), 0.3 * both, 0.7 * both)
    yield check(
        reference="the same creep in both branches by hand: Carter 1926, 8 N·m on planets 30 mm from the axis",
        quantity="tangential forces of both planets in rolling",
        unit="N",
        expected=[first, first, both - first, both - first],
        computed=np.abs(np.asarray(held.rolling.tangential)),
        tolerance=1e-5,
    )
    yield compared(
        model="Forces of the plain planetary",
        reference="statics by hand: 8 N·m on two planets 30 mm from the axis, twice their tangential forces",
        quantity="forces of the carrier on both planets together, and tangential forces of the sun",
        unit="N",
        expected=[2.0 * both, both],
        computed=[
            np.abs(held.rolling.pin_force).sum(),
            np.abs(held.rolling.tangential[::2]).sum(),
        ],
        tolerance=1e-10,
    )
