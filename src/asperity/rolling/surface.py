"""What the surfaces of a joint that rolls experience: pressure, life, traction, flash temperature and oil film.

Of whole lines, or of slices where crowned.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from asperity.contact.crowned_line import CrownedLine
from asperity.contact.film_thickness import film_ratio, minimum_film_thickness
from asperity.contact.flash_temperature import (
    flash_temperature,
    partial_slip_flash_factor,
    thermal_effusivity,
)
from asperity.contact.hertz_line import peak_pressure
from asperity.contact.roller_pairs import RollerPairs
from asperity.contact.shakedown import shakedown_limit, shear_yield_strength
from asperity.contact.viscosity import reciprocal_asymptotic_coefficient
from asperity.drive.state.state import RollingSpeeds
from asperity.engine.arrays import xp
from asperity.joint.contacts import JointContacts
from asperity.joint.crowned_contacts import slice_slip_ratios
from asperity.materials import Material
from asperity.rolling.conditions import RollingConditions
from asperity.rolling.inlet_heat import inlet_heat
from asperity.rolling.life import sliced_track_lives, track_lives
from asperity.types import Array, Real


def flash_temperatures(
    *,
    materials: Sequence[tuple[Material, Material]],
    friction_power: Array,
    speeds: RollingSpeeds,
    half_width: Array,
    stick_fraction: Array,
) -> Array:
    """Flash temperature of each contact, Carter's slip zone being the source of heat.

    Shape (contacts, ...) [K].
    """
    effusivities = [[effusivity_of(material) for material in pair] for pair in materials]
    first, second = (
        xp.stack(xp.broadcast_arrays(*(xp.asarray(pair[side]) for pair in effusivities))) for side in (0, 1)
    )
    turns = speeds.driving > 0.0
    slips = stick_fraction < 1.0
    rise = flash_temperature(
        friction_power=friction_power,
        surface_speed_1=xp.where(turns, speeds.driving, 1.0),
        surface_speed_2=xp.where(turns, speeds.driven, 1.0),
        half_width=half_width,
        effusivity_1=first,
        effusivity_2=second,
    )
    factor = partial_slip_flash_factor(stick_fraction=xp.where(slips, stick_fraction, 0.0))
    known = turns & ~xp.isnan(first + second)
    return xp.where(known, xp.where(slips, rise * factor, 0.0), xp.nan)


def effusivity_of(material: Material) -> Real:
    """Thermal effusivity of a material [W s^0.5/(m^2 K)], nan where its thermal properties are not known."""
    if material.thermal_conductivity is None or material.specific_heat_capacity is None:
        return xp.full_like(xp.asarray(material.density, dtype=float), xp.nan)
    return thermal_effusivity(
        conductivity=material.thermal_conductivity,
        density=material.density,
        heat_capacity=material.specific_heat_capacity,
    )


def oil_film(
    *, conditions: RollingConditions, pairs: RollerPairs, normal_force: Array, rolling_speed: Array
) -> tuple[Array, Array]:
    """Thickness of the oil film that would carry the whole load, and its ratio to the roughness.

    Shape (contacts, ...); that of a fluid as heat and supply at the inlet leave it.
    """
    absent = xp.full_like(normal_force, xp.nan)
    coefficient = _pressure_coefficient(conditions, pairs, normal_force)
    if conditions.viscosity is None or coefficient is None:
        return absent, absent
    turns = rolling_speed > 0.0
    thickness = minimum_film_thickness(
        viscosity=conditions.viscosity,
        pressure_coefficient=coefficient,
        entrainment_speed=xp.where(turns, rolling_speed, 1.0),
        line_load=normal_force / pairs.contact_length,
        effective_radius=pairs.effective_radius,
        contact_modulus=pairs.moduli.contact_modulus,
    )
    thickness = xp.where(
        turns, thickness * _left_at_inlet(conditions, pairs, normal_force, rolling_speed), xp.nan
    )
    if conditions.roughness is None:
        return thickness, absent
    roughness = xp.stack(xp.broadcast_arrays(*map(xp.asarray, conditions.roughness)))
    roughness = roughness.reshape(*roughness.shape, *(1,) * (thickness.ndim - roughness.ndim))
    return thickness, xp.asarray(film_ratio(film_thickness=thickness, roughness=roughness))


def _left_at_inlet(
    conditions: RollingConditions, pairs: RollerPairs, normal_force: Array, rolling_speed: Array
) -> Real:
    """What heat and supply at the inlet leave of the film of a fluid [-]; 1 where its viscosity alone is known."""
    oil = conditions.lubricant
    if oil is None:
        return 1.0
    factor = oil.supply * inlet_heat(
        lubricant=oil,
        peak_pressure=_peak_pressure(pairs, normal_force),
        contact_modulus=pairs.moduli.contact_modulus,
        rolling_speed=xp.where(rolling_speed > 0.0, rolling_speed, 1.0),
    )
    return xp.where(factor > 0.0, factor, xp.nan)


def _peak_pressure(pairs: RollerPairs, normal_force: Array) -> Array:
    """Peak pressures of contacts [Pa]; of those without a force that of 1 N."""
    force = xp.where(normal_force > 0.0, normal_force, 1.0)
    return xp.asarray(
        peak_pressure(
            normal_force=force, contact_length=pairs.contact_length, half_width=pairs.half_width(force)
        )
    )


def _pressure_coefficient(
    conditions: RollingConditions, pairs: RollerPairs, normal_force: Array
) -> Real | None:
    """Pressure coefficient of the oil [1/Pa], of a fluid that below the peak pressures; None where it has none."""
    oil = conditions.lubricant
    if oil is None:
        return conditions.pressure_viscosity_coefficient
    return reciprocal_asymptotic_coefficient(
        viscosity=oil.fluid.viscosity,
        peak_pressure=_peak_pressure(pairs, normal_force),
        temperature=oil.temperature,
    )


class RollingStrips(NamedTuple):
    """The strips of the contacts under their forces in rolling, shape (contacts, ...).

    In the middle of the line: half-width [m]; ``largest_load``, normal forces as if the line load there acted on the
    whole line [N]; T/N [-]; friction power per length over the mean [-], None where the loads are even.
    ``peak_pressure``: of every slice where crowned, shape (slices, contacts, ...) [Pa]. ``tracks``: lives at 90 %
    survival, shape (2, 5, ...) [stress cycles]. ``shakedown_ratio``: peak pressure over the shakedown limit, the
    largest of the line [-]. ``lines``: loads along crowned contacts; None where they are even.
    """

    largest_half_width: Array
    largest_load: Array
    middle_traction: Array
    middle_power_ratio: Array | None
    peak_pressure: Array
    tracks: Array
    shakedown_ratio: Array
    lines: CrownedLine | None


def mean_half_width(*, pairs: RollerPairs, lines: CrownedLine | None, normal_force: Array) -> Array:
    """Half-widths of the contacts, of crowned ones the mean by load, shape (contacts, ...) [m]."""
    if lines is None:
        return xp.asarray(pairs.half_width(normal_force))
    loads = lines.line_load * pairs.contact_length
    return xp.sum(loads * lines.length_share * lines.half_width, axis=0) / normal_force


def rolling_strips(*, contacts: JointContacts, normal_force: Array, traction: Array) -> RollingStrips:
    """What the contacts' strips experience in rolling."""
    pairs = contacts.pairs
    width = xp.asarray(pairs.half_width(normal_force))
    lines = contacts.loads_along(normal_force)
    if lines is None:
        pressure = peak_pressure(
            normal_force=normal_force, contact_length=pairs.contact_length, half_width=width
        )
        return RollingStrips(
            largest_half_width=width,
            largest_load=normal_force,
            middle_traction=traction,
            middle_power_ratio=None,
            peak_pressure=xp.asarray(pressure),
            tracks=track_lives(pairs=pairs, half_width=width, peak_pressure=pressure),
            shakedown_ratio=_shakedown_ratio(pairs, pressure, traction),
            lines=None,
        )
    friction = pairs.friction_coefficient
    ratios = slice_slip_ratios(pairs=pairs, lines=lines, slip_ratio=traction / friction)
    pressures = xp.asarray(
        peak_pressure(normal_force=lines.line_load, contact_length=1.0, half_width=lines.half_width)
    )
    loads = lines.line_load * pairs.contact_length
    slips = traction != 0.0
    share = ratios[0] * friction / xp.where(slips, traction, 1.0)
    return RollingStrips(
        largest_half_width=lines.half_width[0],
        largest_load=loads[0],
        middle_traction=friction * ratios[0],
        middle_power_ratio=xp.where(slips, share, 1.0) * loads[0] / normal_force,
        peak_pressure=pressures,
        tracks=sliced_track_lives(pairs=pairs, lines=lines, peak_pressure=pressures),
        shakedown_ratio=xp.max(_shakedown_ratio(pairs, pressures, friction * ratios), axis=0),
        lines=lines,
    )


def _shakedown_ratio(pairs: RollerPairs, pressure: Real, traction: Array) -> Array:
    return xp.asarray(
        pressure
        / (
            shear_yield_strength(yield_strength=pairs.moduli.yield_strength)
            * shakedown_limit(friction_coefficient=xp.abs(traction))
        )
    )
