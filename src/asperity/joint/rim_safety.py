"""Strength of the ring and of hollow rollers: stresses along their rims at rest and under the torque."""

from __future__ import annotations

import operator
from typing import NamedTuple

import numpy as np

from asperity.body.bore import pin_stress
from asperity.body.coupling import BodyInMachine
from asperity.body.press_fit import PressFit
from asperity.body.rim_range import (
    RimLoads,
    RimRange,
    RimStresses,
    fatigue_safety,
    places_of,
    rim_range,
    rim_stresses,
)
from asperity.body.shapes import Annulus
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import vectorised
from asperity.engine.module import Module
from asperity.materials import Material
from asperity.types import Array

#: Rims of a ring or of a hollow roller, in the order of every rim axis.
RIM_NAMES = ("inner", "outer")


class PinLoad(NamedTuple):
    """Size [N] and polar angle [rad] of the force of a pin on its roller, under the torque and at rest, shape (2,).

    ``angle`` is the half-angle of the arc over which it touches its bore [rad].
    """

    force: Array
    direction: Array
    angle: Array


class BodyRims(Module):
    """Stresses and safeties of one body. SI units; nan for a solid one.

    Parameters
    ----------
    stress, stress_at_rest : Array
        Largest hoop stress of each rim under the torque and at rest, tension positive, shape (2, ...) [Pa].
    mean, amplitude : Array
        Of the hoop stress that every point of a rim goes through under the torque, shape (2, ...) [Pa].
    yield_safety : Array
        Yield strength over the largest equivalent stress of both rims, at rest and under the torque, shape (...) [-].
    fatigue_safety : Array
        Safety of the worse rim against fatigue under the torque, shape (...) [-]; nan where the material has no
        fatigue strength.
    seat_pressure : Array
        Smallest pressure of a ring on its housing, at rest and under the torque, shape (...) [Pa].
    """

    stress: Array
    stress_at_rest: Array
    mean: Array
    amplitude: Array
    yield_safety: Array
    fatigue_safety: Array
    seat_pressure: Array


def body_rims(
    member: BodyInMachine,
    material: Material,
    states: tuple[tuple[Array, Array], ...],
    width: Array,
    turns: tuple[float, ...],
    sectors: int = 1,
    pin: PinLoad | None = None,
    seat: PressFit | None = None,
) -> BodyRims:
    """Stresses of one body under the torque and at rest, with those of the pin in its bore, or of its seat."""
    batch = width.shape[1:]
    if not isinstance(member.body, Annulus):
        nothing = xp.full(batch, xp.nan)
        both = xp.stack([nothing, nothing])
        return BodyRims(both, both, both, both, nothing, nothing, nothing)
    at, body = np.array(member.contacts), member.body
    signs = xp.asarray(turns).reshape((-1,) + (1,) * len(batch))
    outward = 1.0 if body.loaded_rim == "inner" else -1.0

    def stress_range(forces: tuple[Array, ...], pressed: PinLoad | None) -> RimRange:
        normal, tangential = forces
        loads = RimLoads(
            angles=xp.broadcast_to(member.contact_angles, (len(at), *batch)),
            radial=outward * normal[at],
            tangential=signs * tangential[at],
            half_widths=width[at],
            sectors=member.sectors,
        )
        stresses = rim_stresses(body=body, loads=loads, fineness=sectors)
        if pressed is not None:
            away = places_of(loads, sectors) - pressed.direction
            by_pin = pin_stress(
                body=body, force=pressed.force, arc=xp.sin(0.5 * pressed.angle) ** 2, away=away
            )
            stresses = RimStresses(
                loaded_hoop=stresses.loaded_hoop + by_pin.rim_hoop,
                other_hoop=stresses.other_hoop + by_pin.bore_hoop,
                other_radial=stresses.other_radial + by_pin.bore_radial,
                other_shear=stresses.other_shear,
            )
        if seat is not None:
            held = seat.pressure - (0.0 if member.sectors is not None else _centring_pressure(body, loads))
            stresses = RimStresses(
                loaded_hoop=stresses.loaded_hoop + seat.ring_hoop[0],
                other_hoop=stresses.other_hoop + seat.ring_hoop[1],
                other_radial=stresses.other_radial - held,
                other_shear=stresses.other_shear,
            )
        return rim_range(body=body, stresses=stresses)

    ranges = vectorised(stress_range)(tuple(map(xp.stack, zip(*states, strict=True))), pin)
    working, resting = (trees.map(operator.itemgetter(i), ranges) for i in range(2))
    strength = material.yield_strength if material.tensile_strength is None else material.tensile_strength
    safety = xp.full(batch, xp.nan)
    if material.fatigue_strength is not None:
        point_safety = fatigue_safety(
            mean=working.mean,
            amplitude=working.amplitude,
            fatigue_strength=material.fatigue_strength,
            strength=strength,
        )
        safety = xp.min(point_safety, axis=0)
    return BodyRims(
        stress=working.largest,
        stress_at_rest=resting.largest,
        mean=working.mean,
        amplitude=working.amplitude,
        yield_safety=material.yield_strength / xp.maximum(working.mises, resting.mises),
        fatigue_safety=safety,
        seat_pressure=-xp.maximum(working.pull, resting.pull),
    )


def _centring_pressure(body: Annulus, loads: RimLoads) -> Array:
    """Amplitude F/(pi b L) of the pressure with which a housing holds a ring against forces that do not balance."""
    cosine, sine = xp.cos(loads.angles), xp.sin(loads.angles)
    x = xp.sum(loads.radial * cosine - loads.tangential * sine, axis=0)
    y = xp.sum(loads.radial * sine + loads.tangential * cosine, axis=0)
    return xp.sqrt(x**2 + y**2) / (xp.pi * body.outer_radius * body.length)
