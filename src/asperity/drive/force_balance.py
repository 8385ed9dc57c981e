r"""Static force balance of the drive, equations (1)–(5), closed by (A3).

The thirteen unknown forces of a branch reduce to two, exactly: the sun–planet tangential force
:math:`T_{sp}` and the sum :math:`S = N_{pwr} + N_{pwl}` of the planet's loads. Equal creep makes
:math:`c = T_{sp}/S` the traction coefficient of both planet–roller contacts, and (2) then gives
:math:`N_{pwr} - N_{pwl} = T_{sp} \cot(\theta/2)`; every other force follows from one line of (1)–(5) each.
The two that remain are found from the carrier's moment (5) and the closure by Newton's method.
"""

from __future__ import annotations

import dataclasses
import functools
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.equilibrium import balance_equations
from asperity.drive.geometry import Triangle, triangle
from asperity.drive.mechanism import Mechanism, NormalSprings, RestState, compression, rest_state
from asperity.types import Real

#: Largest relative residual of the force balance and of its closure that counts as solved.
BALANCE_TOLERANCE = 1e-9

_NEWTON_BUDGET = 20
_STEP_TOLERANCE = 1e-6  # convergence is quadratic: what such a last step leaves behind is below 1e-13


class DriveForces(eqx.Module):
    """All forces of one branch and the torques of the drive, SI units.

    Parameters
    ----------
    normal, tangential : Array
        Normal and tangential forces of the contacts ``sp, pwr, pwl, wro, wlo``, shape (5, ...) [N].
    pin_left, pin_right : Array
        Carrier pin forces F_cl, F_cr [N].
    input_torque, output_torque : Array
        Torques T_in at the sun and T_out at the carrier [N·m].
    left_bearing_torque, right_bearing_torque : Array
        Friction torque T_B of one bearing of the left and the right loading roller [N·m].
    balance_residual : Array
        Largest residual of the eleven equations (1)–(5), relative to the largest force [-].
    closure_residual : Array
        Residual of the closure (A3), relative [-]; 0 where a contact has lifted off, because it then no longer
        binds.
    """

    normal: Array
    tangential: Array
    pin_left: Array
    pin_right: Array
    input_torque: Array
    output_torque: Array
    left_bearing_torque: Array
    right_bearing_torque: Array
    balance_residual: Array
    closure_residual: Array


class _Drive(NamedTuple):
    """Everything that stays fixed while the two unknowns are sought."""

    mechanism: Mechanism
    sides: Triangle
    rest: RestState
    output_torque: Array
    planet_centrifugal: Real
    roller_centrifugal: Real


def _branch_forces(drive: _Drive, load_sum: Array, sun_force: Array) -> dict[str, Array]:
    """Every force of a branch from S and T_sp, one published equation a line."""
    side, geometry, bearings = drive.sides, drive.mechanism.geometry, drive.mechanism.bearings
    radius = geometry.loading_roller_radius
    cos_l, sin_l = jnp.cos(geometry.left_push_angle), jnp.sin(geometry.left_push_angle)
    cos_r, sin_r = jnp.cos(geometry.right_push_angle), jnp.sin(geometry.right_push_angle)
    difference = sun_force * (1.0 + side.cos_direction) / side.sin_direction  # (2) x and moment
    traction = sun_force / load_sum  # (A3) equal creep
    n_pwr, n_pwl = 0.5 * (load_sum + difference), 0.5 * (load_sum - difference)
    t_pwr, t_pwl = traction * n_pwr, traction * n_pwl
    n_sp = (
        (t_pwr - t_pwl) * side.sin_direction + load_sum * side.cos_direction - drive.planet_centrifugal
    )  # (2) y
    # (3) t and (4) t with the roller moments T_wo = T_pw − 2 T_B/R_w put in; a pin's friction grows with |F|
    push_l = n_pwl * side.sin_wedge + t_pwl * (1.0 + side.cos_wedge)
    push_r = n_pwr * side.sin_wedge - t_pwr * (1.0 + side.cos_wedge)
    constant = 2.0 * bearings.loading_roller_torque / radius
    pin_friction = bearings.pin_friction_coefficient * bearings.pin_diameter / radius
    side_l = jnp.sign(push_l - constant)
    side_r = jnp.sign(push_r + constant)
    f_cl = (push_l - constant) / (cos_l + side_l * pin_friction)
    f_cr = (push_r + constant) / (cos_r - side_r * pin_friction)
    pin_torque = 0.5 * bearings.pin_friction_coefficient * bearings.pin_diameter
    b_l = bearings.loading_roller_torque + pin_torque * jnp.abs(f_cl)
    b_r = bearings.loading_roller_torque + pin_torque * jnp.abs(f_cr)
    return {
        "n_sp": n_sp,
        "n_pwr": n_pwr,
        "n_pwl": n_pwl,
        "n_wro": f_cr * sin_r
        + n_pwr * side.cos_wedge
        + t_pwr * side.sin_wedge
        + drive.roller_centrifugal,  # (4) r
        "n_wlo": f_cl * sin_l
        + n_pwl * side.cos_wedge
        - t_pwl * side.sin_wedge
        + drive.roller_centrifugal,  # (3) r
        "t_sp": sun_force,
        "t_pwr": t_pwr,
        "t_pwl": t_pwl,
        "t_wro": t_pwr - 2.0 * b_r / radius,  # (4) M
        "t_wlo": t_pwl - 2.0 * b_l / radius,  # (3) M
        "f_cl": f_cl,
        "f_cr": f_cr,
        "b_l": b_l,
        "b_r": b_r,
    }


def _normals(force: dict[str, Array]) -> tuple[Array, ...]:
    return force["n_sp"], force["n_pwr"], force["n_pwl"], force["n_wro"], force["n_wlo"]


def _each(springs: NormalSprings) -> list[NormalSprings]:
    return [jax.tree.map(lambda leaf, i=i: leaf[i], springs) for i in range(5)]


def _carrier_residual(drive: _Drive, force: dict[str, Array]) -> Array:
    """Equation (5) over 3 (R_o − R_w): a force [N]."""
    geometry = drive.mechanism.geometry
    push = force["f_cl"] * jnp.cos(geometry.left_push_angle) - force["f_cr"] * jnp.cos(
        geometry.right_push_angle
    )
    torque = 2.0 * drive.mechanism.bearings.carrier_torque + drive.output_torque
    return push - torque / (geometry.planet_count * drive.sides.roller_orbit)  # (5)


def _closure_residual(drive: _Drive, force: dict[str, Array]) -> Array:
    r"""Equation (A3), as a force [N]: zero where the closure holds, growing with S.

    For ``elastic`` the planet is displaced by (x, y) and the rollers radially by r_r and r_l. The approaches are
    delta_sp = −y, delta_pwr = x sin th + y cos th − r_r cos b, delta_pwl = −x sin th + y cos th − r_l cos b,
    delta_wro = r_r, delta_wlo = r_l. Eliminating the four displacements leaves one condition:
    2 cos th delta_sp + delta_pwr + delta_pwl + cos b (delta_wro + delta_wlo) = 0.
    """
    if drive.mechanism.closure == "constant_pin_force":
        return force["f_cr"] - drive.rest.pin_force_right
    # contact by contact: XLA does not vectorise logarithms of a stacked array inside a fused loop
    sp, pwr, pwl, wro, wlo = (
        compression(springs=springs, normal_force=normal, rest_force=rest)
        for springs, normal, rest in zip(
            _each(drive.mechanism.springs), _normals(force), drive.rest.normal_force, strict=True
        )
    )
    misfit = 2.0 * drive.sides.cos_direction * sp + pwr + pwl + drive.sides.cos_wedge * (wro + wlo)
    return misfit / drive.mechanism.springs.incremental_compliance[1]


def _contact_floor(drive: _Drive, sun_force: Array) -> Array:
    """Smallest S at which no contact pulls: N_pwl = 0, or N_sp = 0 under the planet's centrifugal force."""
    side, centrifugal = drive.sides, drive.planet_centrifugal
    difference = sun_force * (1.0 + side.cos_direction) / side.sin_direction
    product = centrifugal**2 - 4.0 * side.cos_direction * side.sin_direction * sun_force * difference
    real = product > 0.0
    root = jnp.where(real, jnp.sqrt(jnp.where(real, product, 1.0)), -centrifugal)
    return jnp.maximum(jnp.abs(difference), (centrifugal + root) / (2.0 * side.cos_direction))


def _residuals(drive: _Drive, unknowns: tuple[Array, Array]) -> tuple[Array, Array]:
    """Closure and carrier moment; a lifted contact stays at zero force while S goes below its floor."""
    load_sum, sun_force = unknowns
    free = _branch_forces(drive, load_sum, sun_force)
    held = _branch_forces(drive, jnp.maximum(load_sum, _contact_floor(drive, sun_force)), sun_force)
    return _closure_residual(drive, free), _carrier_residual(drive, held)


def _solve_two_by_two(linear, right_side: tuple[Array, Array]) -> tuple[Array, Array]:  # type: ignore[no-untyped-def]
    """Solve linear(u, v) = right_side for the pair (u, v) by Cramer's rule, elementwise."""
    one, zero = jnp.ones_like(right_side[0]), jnp.zeros_like(right_side[0])
    a, c = linear((one, zero))
    b, d = linear((zero, one))
    determinant = a * d - b * c
    e, f = right_side
    return (e * d - b * f) / determinant, (a * f - c * e) / determinant


def _newton(residuals, start: tuple[Array, Array]) -> tuple[Array, Array]:  # type: ignore[no-untyped-def]
    """Newton's method until the last step of every point is negligible, or the budget is spent."""

    def unfinished(state: tuple[Array, Array, Array, Array]) -> Array:
        *_, change, count = state
        return (change > _STEP_TOLERANCE) & (count < _NEWTON_BUDGET)

    def improve(state: tuple[Array, Array, Array, Array]) -> tuple[Array, Array, Array, Array]:
        load_sum, sun_force, _, count = state
        value, tangent_map = jax.linearize(residuals, (load_sum, sun_force))
        step = _solve_two_by_two(tangent_map, value)
        relative = jnp.maximum(jnp.abs(step[0]), jnp.abs(step[1])) / (jnp.abs(load_sum) + jnp.abs(sun_force))
        change = jnp.max(jnp.where(jnp.isnan(relative), 0.0, relative))
        return load_sum - step[0], sun_force - step[1], change, count + 1

    first = (*start, jnp.asarray(jnp.inf), jnp.asarray(0))
    load_sum, sun_force, *_ = jax.lax.while_loop(unfinished, improve, first)
    return load_sum, sun_force


def _largest(values: tuple[Array, ...]) -> Array:
    """Largest magnitude, taken one by one: XLA would write a stacked array to memory first."""
    return functools.reduce(jnp.maximum, (jnp.abs(value) for value in values))


def force_balance(*, mechanism: Mechanism, output_torque: Real) -> DriveForces:
    r"""Solve the static force balance of one branch under a given output torque.

    Parameters
    ----------
    mechanism : Mechanism
        The preloaded drive.
    output_torque : Real
        Torque T_out >= 0 at the carrier [N·m]. The other direction is the mirror image: left becomes right.

    Returns
    -------
    DriveForces
        Forces, torques and the two residuals. Contacts never pull: a lifted one carries no force.

    Notes
    -----
    Newton's method from the preload state, usually three steps. The residuals are part of the result; whoever
    uses the forces must look at them (:func:`asperity.joint.solve` does). Derivatives are those of the equations
    at their root.

    References
    ----------
    Zou et al. 2025, equations (1)–(5), with the signs of Newton's third law; (A3) of :doc:`/equations`.
    """
    geometry, bearings = mechanism.geometry, mechanism.bearings
    sides = triangle(geometry)
    rest = rest_state(geometry=geometry, preload=mechanism.preload)
    speed_squared = mechanism.carrier_speed**2
    drive = _Drive(
        mechanism=mechanism,
        sides=sides,
        rest=rest,
        output_torque=jnp.asarray(output_torque),
        planet_centrifugal=mechanism.planet_mass * speed_squared * sides.planet_orbit,
        roller_centrifugal=mechanism.loading_roller_mass * speed_squared * sides.roller_orbit,
    )
    leverage = (
        1.0 + sides.cos_wedge - sides.sin_wedge * (1.0 + sides.cos_direction) / sides.sin_direction
    )  # (5) with (3), (4) and no losses
    loss_free = output_torque / (geometry.planet_count * sides.roller_orbit * leverage)
    batch = dataclasses.replace(mechanism, springs=jax.tree.map(lambda leaf: leaf[0], mechanism.springs))
    shape = jnp.broadcast_shapes(*(jnp.shape(leaf) for leaf in jax.tree.leaves((batch, output_torque))))
    start = jnp.broadcast_to(2.0 * rest.normal_force[1], shape), jnp.broadcast_to(loss_free, shape)

    def residuals(unknowns: tuple[Array, Array]) -> tuple[Array, Array]:
        return _residuals(drive, unknowns)

    load_sum, sun_force = jax.lax.custom_root(residuals, start, _newton, _solve_two_by_two)
    floor = _contact_floor(drive, sun_force)
    held = load_sum < floor
    force = _branch_forces(drive, jnp.where(held, floor, load_sum), sun_force)
    force = jax.lax.optimization_barrier(force)  # keeps XLA from computing them again for every use
    closure_error = jnp.where(held, 0.0, jnp.abs(_closure_residual(drive, force)))
    # a lifted contact's rounding is cut off; the balance below is taken with what remains
    normals = tuple(jnp.maximum(value, 0.0) for value in _normals(force))
    tangentials = force["t_sp"], force["t_pwr"], force["t_pwl"], force["t_wro"], force["t_wlo"]
    input_torque = (
        2.0 * bearings.sun_torque + geometry.planet_count * geometry.sun_radius * force["t_sp"]
    )  # (1)
    scale = _largest((*normals, *tangentials))
    equations = balance_equations(
        geometry=geometry,
        bearings=bearings,
        normal=normals,
        tangential=tangentials,
        pin_left=force["f_cl"],
        pin_right=force["f_cr"],
        left_bearing_torque=force["b_l"],
        right_bearing_torque=force["b_r"],
        input_torque=input_torque,
        output_torque=drive.output_torque,
        planet_centrifugal=drive.planet_centrifugal,
        roller_centrifugal=drive.roller_centrifugal,
    )
    return DriveForces(
        normal=jnp.stack(jnp.broadcast_arrays(*normals)),
        tangential=jnp.stack(jnp.broadcast_arrays(*tangentials)),
        pin_left=force["f_cl"],
        pin_right=force["f_cr"],
        input_torque=input_torque,
        output_torque=jnp.broadcast_to(drive.output_torque, scale.shape),
        left_bearing_torque=force["b_l"],
        right_bearing_torque=force["b_r"],
        balance_residual=_largest(equations) / scale,
        closure_residual=closure_error / scale,
    )
