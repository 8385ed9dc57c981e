"""The eleven equations (1)–(5) as published, for checking any solution."""

from __future__ import annotations

from collections.abc import Sequence

import jax.numpy as jnp
from jax import Array

from asperity.drive.mechanism import Bearings
from asperity.drive.wedge.geometry import DriveGeometry, Triangle
from asperity.types import Real


def balance_equations(
    *,
    geometry: DriveGeometry,
    sides: Triangle,
    bearings: Bearings,
    normal: Sequence[Array] | Array,
    tangential: Sequence[Array] | Array,
    pin_left: Real,
    pin_right: Real,
    left_bearing_torque: Real,
    right_bearing_torque: Real,
    input_torque: Real,
    output_torque: Real,
    planet_centrifugal: Real,
    roller_centrifugal: Real,
) -> tuple[Array, ...]:
    """The eleven equations (1)–(5) as published, each as a force [N] that vanishes in equilibrium.

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    sides : Triangle
        Its triangle of centres.
    bearings : Bearings
        Friction of its bearings.
    normal, tangential : sequence of Array
        Contact forces in the order of :data:`asperity.drive.wedge.geometry.CONTACT_NAMES`, shape (5, ...) [N].
    pin_left, pin_right : Real
        Carrier pin forces [N].
    left_bearing_torque, right_bearing_torque : Real
        Friction torque of one loading-roller bearing on either side [N·m].
    input_torque, output_torque : Real
        Torques at sun and carrier [N·m].
    planet_centrifugal, roller_centrifugal : Real
        m omega_c^2 r of a planet and of a loading roller [N].

    Returns
    -------
    tuple of Array
        Eleven residuals in the order of the paper [N]; moments are divided by the radius they act at.

    References
    ----------
    Zou et al. 2025, equations (1)–(5); the signs of (2) and (4) as in :doc:`/assumptions`.
    """
    side = sides
    n_sp, n_pwr, n_pwl, n_wro, n_wlo = normal
    t_sp, t_pwr, t_pwl, t_wro, t_wlo = tangential
    cos_th, sin_th, cos_b, sin_b = side.cos_direction, side.sin_direction, side.cos_wedge, side.sin_wedge
    cos_l, sin_l = jnp.cos(geometry.left_push_angle), jnp.sin(geometry.left_push_angle)
    cos_r, sin_r = jnp.cos(geometry.right_push_angle), jnp.sin(geometry.right_push_angle)
    sun, roller = geometry.sun_radius, geometry.loading_roller_radius
    count, orbit = geometry.planet_count, side.roller_orbit
    return (
        (input_torque - 2.0 * bearings.sun_torque) / (count * sun) - t_sp,  # (1)
        t_sp + t_pwr * cos_th - n_pwr * sin_th + n_pwl * sin_th + t_pwl * cos_th,  # (2) x
        n_sp
        - t_pwr * sin_th
        - n_pwr * cos_th
        - n_pwl * cos_th
        + t_pwl * sin_th
        + planet_centrifugal,  # (2) y
        t_pwr + t_pwl - t_sp,  # (2) M
        pin_left * cos_l - n_pwl * sin_b - t_pwl * cos_b - t_wlo,  # (3) t
        pin_left * sin_l + n_pwl * cos_b - t_pwl * sin_b - n_wlo + roller_centrifugal,  # (3) r
        t_wlo - t_pwl + 2.0 * left_bearing_torque / roller,  # (3) M
        pin_right * cos_r - n_pwr * sin_b + t_pwr * cos_b + t_wro,  # (4) t
        pin_right * sin_r + n_pwr * cos_b + t_pwr * sin_b - n_wro + roller_centrifugal,  # (4) r
        t_wro - t_pwr + 2.0 * right_bearing_torque / roller,  # (4) M
        pin_left * cos_l
        - pin_right * cos_r
        - (2.0 * bearings.carrier_torque + output_torque) / (count * orbit),  # (5)
    )
