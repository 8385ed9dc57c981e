"""Branches of unlike sizes: two opposed planets by hand, with the closed forms of Hertz, Weber–Banaschek and Carter."""

from __future__ import annotations

import math
from collections.abc import Iterator

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array
from scipy.optimize import brentq

from asperity.drive.layout.drives import planetary_drive
from asperity.drive.layout.unfolding import forces_on_centre, unfolded
from asperity.drive.state.smooth_laws import smooth_contact_laws
from asperity.drive.state.state import DriveLoad
from asperity.drive.state.states import DriveStates, drive_states
from asperity.validation.check import Check, compared

_YOUNG, _POISSON, _FRICTION, _LENGTH, _WALL = 206e9, 0.3, 0.08, 10e-3, 60e-3
_SUN, _PLANET = 10e-3, 20e-3
_RING = _SUN + 2.0 * _PLANET
_INTERFERENCE, _ERROR, _TORQUE = 20e-6, 2e-6, 8.0
_RIGID, _SOFT = 1e16, 2e8


@eqx.filter_jit
def _states(support: Array) -> tuple[DriveStates, Array]:
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
    inner = jnp.array([1.0 if contact.internal else 0.0 for contact in drive.contacts])
    added = jnp.array([_ERROR, _ERROR, -_ERROR, -_ERROR]) / _INTERFERENCE
    found = drive_states(
        drive=drive,
        laws=laws,
        pattern=inner + added,
        interference=_INTERFERENCE,
        load=DriveLoad(
            output_torque=jnp.asarray(_TORQUE), support_stiffness=jnp.array([1.0, 0.0, 0.0]) * support
        ),
    )
    rest = found.rest
    centre = forces_on_centre(
        drive=drive,
        bodies=("sun", "ring"),
        normal=rest.normal,
        tangential=rest.tangential,
        pin_force=rest.pin_force,
    )
    return found, centre


def _half_width(force: float, radius: float) -> float:
    modulus = _YOUNG / (2.0 * (1.0 - _POISSON**2))
    return math.sqrt(4.0 * force * radius / (math.pi * modulus * _LENGTH))


_RADII = (_SUN * _PLANET / (_SUN + _PLANET), _PLANET * _RING / (_RING - _PLANET))


def _compression(force: float) -> float:
    """By how much sun, planet and ring give way together: Johnson 1985, (5.57), and Weber and Banaschek 1953."""
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
            brentq(lambda force, own=own: _compression(force) - own, 1.0, 1e5, xtol=1e-9)
            for own in (
                _INTERFERENCE + 2.0 * _ERROR - moved,
                _INTERFERENCE - 2.0 * _ERROR + moved,
            )
        ]
    )


def _creep(force: float, preload: float) -> float:
    """Creepage of both contacts of a planet together, Carter 1926."""
    at_slip = sum(_FRICTION * _half_width(preload, radius) / radius for radius in _RADII)
    return at_slip * (1.0 - math.sqrt(1.0 - force / (_FRICTION * preload)))


def unlike() -> Iterator[Check]:
    """A plain planetary with two opposed planets of unlike radii."""
    model = "Branches of unlike sizes"
    source = "two opposed planets by hand, 2 µm too large and too small, interference 20 µm: Johnson, Weber–Banaschek"
    held, centre = _states(jnp.asarray(_RIGID))
    preload = _preloads(0.0)
    yield compared(
        model=model,
        reference=source,
        quantity="normal forces of sun and ring on both planets, the sun held",
        unit="N",
        expected=np.repeat(preload, 2),
        found=np.asarray(held.rest.normal),
        tolerance=1e-6,
    )
    yield compared(
        model=model,
        reference=source,
        quantity="force on the bearings of the sun",
        unit="N",
        expected=preload[0] - preload[1],
        found=float(jnp.linalg.norm(centre[0])),
        tolerance=1e-6,
    )
    soft, _ = _states(jnp.asarray(_SOFT))
    moved = brentq(lambda u: _SOFT * u - np.subtract(*_preloads(u)), 0.0, 2.0 * _ERROR, xtol=1e-18)
    yield compared(
        model=model,
        reference=f"{source}; the sun on bearings of 200 N/µm",
        quantity="displacement of the sun",
        unit="µm",
        expected=1e6 * moved,
        found=1e6 * float(jnp.linalg.norm(soft.rest.displacement[0])),
        tolerance=1e-6,
    )
    both = 0.5 * _TORQUE / (_SUN + _PLANET)
    first = brentq(lambda t: _creep(t, preload[0]) - _creep(both - t, preload[1]), 0.3 * both, 0.7 * both)
    yield compared(
        model=model,
        reference="the same creep in both branches by hand: Carter 1926, 8 N·m on planets 30 mm from the axis",
        quantity="tangential forces of both planets in rolling",
        unit="N",
        expected=[first, first, both - first, both - first],
        found=np.abs(np.asarray(held.rolling.tangential)),
        tolerance=1e-5,
    )
