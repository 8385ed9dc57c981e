"""What the surfaces of a joint that rolls experience: flash temperature and oil film."""

from __future__ import annotations

from collections.abc import Sequence

import jax.numpy as jnp
from jax import Array

from asperity.contact.film_thickness import film_ratio, minimum_film_thickness
from asperity.contact.flash_temperature import (
    flash_temperature,
    partial_slip_flash_factor,
    thermal_effusivity,
)
from asperity.contact.roller_pairs import RollerPairs
from asperity.drive.state.state import RollingSpeeds
from asperity.materials import Material
from asperity.rolling.conditions import RollingConditions
from asperity.types import Real


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
    effusivities = [[_effusivity(material) for material in pair] for pair in materials]
    first, second = (
        jnp.stack(jnp.broadcast_arrays(*(jnp.asarray(pair[side]) for pair in effusivities)))
        for side in (0, 1)
    )
    turns = speeds.driving > 0.0
    slips = stick_fraction < 1.0
    rise = flash_temperature(
        friction_power=friction_power,
        surface_speed_1=jnp.where(turns, speeds.driving, 1.0),
        surface_speed_2=jnp.where(turns, speeds.driven, 1.0),
        half_width=half_width,
        effusivity_1=first,
        effusivity_2=second,
    )
    factor = partial_slip_flash_factor(stick_fraction=jnp.where(slips, stick_fraction, 0.0))
    known = turns & ~jnp.isnan(first + second)
    return jnp.where(known, jnp.where(slips, rise * factor, 0.0), jnp.nan)


def _effusivity(material: Material) -> Real:
    if material.thermal_conductivity is None or material.specific_heat_capacity is None:
        return jnp.full_like(jnp.asarray(material.density, dtype=float), jnp.nan)
    return thermal_effusivity(
        conductivity=material.thermal_conductivity,
        density=material.density,
        heat_capacity=material.specific_heat_capacity,
    )


def oil_film(
    *, conditions: RollingConditions, pairs: RollerPairs, normal_force: Array, rolling_speed: Array
) -> tuple[Array, Array]:
    """Thickness of the oil film that would carry the whole load, and its ratio to the roughness.

    Shape (5, ...).
    """
    absent = jnp.full_like(normal_force, jnp.nan)
    if conditions.viscosity is None or conditions.pressure_viscosity_coefficient is None:
        return absent, absent
    turns = rolling_speed > 0.0
    thickness = minimum_film_thickness(
        viscosity=conditions.viscosity,
        pressure_coefficient=conditions.pressure_viscosity_coefficient,
        entrainment_speed=jnp.where(turns, rolling_speed, 1.0),
        line_load=normal_force / pairs.contact_length,
        effective_radius=pairs.effective_radius,
        contact_modulus=pairs.moduli.contact_modulus,
    )
    thickness = jnp.where(turns, thickness, jnp.nan)
    if conditions.roughness is None:
        return thickness, absent
    roughness = jnp.stack(jnp.broadcast_arrays(*map(jnp.asarray, conditions.roughness)))
    roughness = roughness.reshape(*roughness.shape, *(1,) * (thickness.ndim - roughness.ndim))
    return thickness, jnp.asarray(film_ratio(film_thickness=thickness, roughness=roughness))
