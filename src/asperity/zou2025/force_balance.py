r"""Static force balance of the drive, equations (1)–(5), closed by (A3).

The forces of a branch follow from two unknowns, :math:`T_{sp}` and :math:`S = N_{pwr} + N_{pwl}`
(:mod:`asperity.zou2025.branch`); these are found from the carrier's moment (5) and the closure by Newton's method.
"""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Sequence

from asperity.drive.bearings import Bearings
from asperity.drive.layout.wedge_geometry import DriveGeometry, Triangle
from asperity.drive.normal_springs import NormalSprings, compression
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import once, while_loop
from asperity.engine.derivatives import linearised
from asperity.engine.module import Module
from asperity.implicit import implicit_root
from asperity.types import Array, Real
from asperity.zou2025.branch import (
    Branch,
    BranchForces,
    branch_forces,
    carrier_residual,
    contact_floors,
    held_load_sum,
)
from asperity.zou2025.mechanism import Mechanism, steepest_compliance

#: Largest relative residual of the force balance and of its closure that counts as solved.
BALANCE_TOLERANCE = 1e-9

_NEWTON_BUDGET = 20
_STEP_TOLERANCE = 1e-6  # convergence is quadratic: the error after such a last step is below 1e-13


class DriveForces(Module):
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
        Residual of the closure (A3), relative [-]; 0 where a contact has lifted off, because it then does not apply.
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


def _contact_springs(springs: NormalSprings) -> list[NormalSprings]:
    return [trees.map(lambda leaf, i=i: leaf[i], springs) for i in range(5)]


def _misfit(branch: Branch, approaches: Sequence[Real]) -> Real:
    r"""Incompatibility of the five contact approaches, as a force [N]; increases with each of them.

    The planet is displaced by (x, y) and each roller across the push of its pin, by r outward and by r tan g away from
    the planet's line of centres. The approaches are delta_sp = −y, delta_pwr = x sin th + y cos th − r_r (cos b + sin b
    tan g_r), delta_pwl = −x sin th + y cos th − r_l (cos b + sin b tan g_l), delta_wro = r_r, delta_wlo = r_l.
    Eliminating the four displacements leaves one condition, whose factors are the forces at rest: 2 cos th delta_sp +
    delta_pwr + delta_pwl + (cos b + sin b tan g_r) delta_wro + (cos b + sin b tan g_l) delta_wlo = 0.
    """
    sp, pwr, pwl, wro, wlo = approaches
    side, geometry = branch.sides, branch.mechanism.geometry
    right, left = (
        side.cos_wedge + side.sin_wedge * xp.tan(angle)
        for angle in (geometry.right_push_angle, geometry.left_push_angle)
    )
    misfit = 2.0 * side.cos_direction * sp + pwr + pwl + right * wro + left * wlo
    return misfit * (1.0 / branch.mechanism.springs.incremental_compliance[1])


def closure_misfit(branch: Branch, force: BranchForces) -> Real:
    """Equation (A3), as a force: zero where the closure holds, increasing with S.

    Parameters
    ----------
    branch : Branch
        The branch.
    force : BranchForces
        Its forces.

    Returns
    -------
    Real
        Residual [N].

    References
    ----------
    Equation (A3) of :doc:`/equations`.
    """
    if branch.mechanism.closure == "constant_pin_force":
        return force.pin_right - branch.rest.pin_force_right
    if branch.mechanism.springs.crowns is not None:
        normal = xp.stack(xp.broadcast_arrays(*force.normal))
        together = compression(
            springs=branch.mechanism.springs, normal_force=normal, rest_force=branch.rest.normal_force
        )
        return _misfit(branch, list(xp.asarray(together)))
    # contact by contact: XLA does not vectorise logarithms of a stacked array inside a fused loop
    springs = _contact_springs(branch.mechanism.springs)
    return _misfit(
        branch,
        [
            compression(springs=spring, normal_force=normal, rest_force=rest)
            for spring, normal, rest in zip(springs, force.normal, branch.rest.normal_force, strict=True)
        ],
    )


def _closure_steepness(branch: Branch) -> Real:
    """Upper bound of the slope of the closure over S: that of all contacts nearly unloaded [-]."""
    if branch.mechanism.closure == "constant_pin_force":
        return xp.asarray(1.0)
    if branch.mechanism.springs.crowns is not None:
        return _misfit(branch, list(xp.asarray(steepest_compliance(branch.mechanism.springs))))
    return _misfit(
        branch, [steepest_compliance(spring) for spring in _contact_springs(branch.mechanism.springs)]
    )


def _residuals(branch: Branch, unknowns: tuple[Array, Array]) -> tuple[Real, Real]:
    """Closure and carrier moment; where a contact lifts off, the closure is continued as a straight line in S.

    The line is at least as steep as the closure can be, so that a Newton step from there cannot overshoot the root.
    """
    load_sum, sun_force = unknowns
    held = held_load_sum(branch, load_sum, sun_force)
    force = branch_forces(branch, held, sun_force)
    lifted = _closure_steepness(branch) * (load_sum - held)
    return closure_misfit(branch, force) + lifted, carrier_residual(branch, force)


def _solve_two_by_two(linear, right_side: tuple[Array, Array]) -> tuple[Array, Array]:  # type: ignore[no-untyped-def]
    """Solve linear(u, v) = right_side for the pair (u, v) elementwise, v eliminated by the second equation.

    The second equation is the carrier's moment, which always depends on v = T_sp. XLA stores quotients
    instead of recomputing them for every use: each entry of the matrix is used only once.
    """
    one, zero = xp.ones_like(right_side[0]), xp.zeros_like(right_side[0])
    a, c = linear((one, zero))
    b, d = linear((zero, one))
    e, f = right_side
    coupling, alone = c / d, f / d
    u = (e - b * alone) / (a - b * coupling)
    return u, alone - coupling * u


def _newton(residuals, start: tuple[Array, Array]) -> tuple[Array, Array]:  # type: ignore[no-untyped-def]
    """Newton's method until the last step of every point is negligible, or the maximum number of steps is reached."""

    def unfinished(state: tuple[Array, Array, Array, Array]) -> Array:
        *_, moving, count = state
        return moving & (count < _NEWTON_BUDGET)

    def improve(state: tuple[Array, Array, Array, Array]) -> tuple[Array, Array, Array, Array]:
        load_sum, sun_force, _, count = state
        value, tangent_map = linearised(residuals, (load_sum, sun_force))
        step = _solve_two_by_two(tangent_map, value)
        allowed = _STEP_TOLERANCE * (xp.abs(load_sum) + xp.abs(sun_force))
        moving = xp.any((xp.abs(step[0]) > allowed) | (xp.abs(step[1]) > allowed))  # a nan stays unchanged
        return load_sum - step[0], sun_force - step[1], moving, count + 1

    first = (*start, xp.asarray(True), xp.asarray(0))
    load_sum, sun_force, *_ = while_loop(unfinished, improve, first)
    return load_sum, sun_force


def _largest(values: tuple[Array, ...]) -> Array:
    """Largest magnitude, compared one by one: XLA would first write a stacked array to memory."""
    return functools.reduce(xp.maximum, (xp.abs(value) for value in values))


def loaded_branch(*, mechanism: Mechanism, output_torque: Real) -> Branch:
    r"""A branch under an output torque: all quantities that are constant while its forces are solved for.

    .. math:: F_p = m_p \omega_c^2 (R_s + R_p), \qquad F_w = m_w \omega_c^2 (R_o - R_w)

    Parameters
    ----------
    mechanism : Mechanism
        The preloaded drive.
    output_torque : Real
        Torque T_out at the carrier [N·m].

    Returns
    -------
    Branch
        Triangle, state at rest and centrifugal forces.

    References
    ----------
    Zou et al. 2025, the centrifugal terms of equations (2)–(4).
    """
    sides = mechanism.sides
    speed_squared = mechanism.carrier_speed**2
    return Branch(
        mechanism=mechanism,
        sides=sides,
        rest=mechanism.rest,
        output_torque=xp.asarray(output_torque),
        planet_centrifugal=mechanism.planet_mass * speed_squared * sides.planet_orbit,
        roller_centrifugal=mechanism.loading_roller_mass * speed_squared * sides.roller_orbit,
    )


def _without_losses(branch: Branch) -> tuple[Array, Array]:
    """Where Newton's method starts: the load sum at rest, and the sun's force by (5) with (3), (4) and no losses."""
    mechanism, sides, rest = branch.mechanism, branch.sides, branch.rest
    leverage = 1.0 + sides.cos_wedge - sides.sin_wedge * (1.0 + sides.cos_direction) / sides.sin_direction
    sun_force = branch.output_torque / (mechanism.geometry.planet_count * sides.roller_orbit * leverage)
    springs, first_rest = trees.map(lambda leaf: leaf[0], (mechanism.springs, rest.normal_force))
    batch = dataclasses.replace(mechanism, springs=springs, rest=rest._replace(normal_force=first_rest))
    leaves = trees.leaves((batch, branch.output_torque))
    shape = xp.broadcast_shapes(*(xp.shape(leaf) for leaf in leaves))
    return xp.broadcast_to(2.0 * rest.normal_force[1], shape), xp.broadcast_to(sun_force, shape)


def force_balance(*, mechanism: Mechanism, output_torque: Real) -> DriveForces:
    r"""Solve the static force balance of one branch under a given output torque.

    Parameters
    ----------
    mechanism : Mechanism
        The preloaded drive.
    output_torque : Real
        Torque T_out at the carrier, of either sign [N·m]. A negative one loads the left side of the wedge; the result
        is the mirror image only of a drive whose two sides are alike and whose bearings have no friction or turn the
        other way too.

    Returns
    -------
    DriveForces
        Forces, torques and the two residuals. Contacts never pull: a lifted one carries no force.

    Notes
    -----
    Newton's method from the preload state, usually two or three steps. The residuals are part of the result;
    check them before using the forces (:func:`asperity.joint.solve.solve_joint` does). Derivatives are those of the
    equations at their root.

    References
    ----------
    Zou et al. 2025, equations (1)–(5), with the signs of Newton's third law; (A3) of :doc:`/equations`.
    """
    branch = loaded_branch(mechanism=mechanism, output_torque=output_torque)

    def residuals(unknowns: tuple[Array, Array]) -> tuple[Real, Real]:
        return _residuals(branch, unknowns)

    load_sum, sun_force = implicit_root(residuals, _without_losses(branch), _newton, _solve_two_by_two)
    held = held_load_sum(branch, load_sum, sun_force)
    force = branch_forces(branch, held, sun_force)
    force = once(force)  # prevents XLA from recomputing them for every use
    lifted = load_sum < held
    closure_error = xp.where(lifted, 0.0, xp.abs(closure_misfit(branch, force)))
    # removes the rounding error of a lifted contact; the balance below uses the result
    roller_floor, planet_floor = contact_floors(branch, sun_force)
    sun_contact, *others = (xp.maximum(value, 0.0) for value in force.normal)
    normals = (xp.where(lifted & (planet_floor >= roller_floor), 0.0, sun_contact), *others)
    geometry, bearings, traction = mechanism.geometry, mechanism.bearings, force.tangential[0]
    input_torque = 2.0 * bearings.input_torque + geometry.planet_count * geometry.sun_radius * traction  # (1)
    scale = _largest((*normals, *force.tangential))
    equations = balance_equations(
        geometry=geometry,
        sides=branch.sides,
        bearings=bearings,
        normal=normals,
        tangential=force.tangential,
        pin_left=force.pin_left,
        pin_right=force.pin_right,
        left_bearing_torque=force.left_bearing_torque,
        right_bearing_torque=force.right_bearing_torque,
        input_torque=input_torque,
        output_torque=branch.output_torque,
        planet_centrifugal=branch.planet_centrifugal,
        roller_centrifugal=branch.roller_centrifugal,
    )
    return DriveForces(
        normal=xp.stack(xp.broadcast_arrays(*normals)),
        tangential=xp.stack(xp.broadcast_arrays(*force.tangential)),
        pin_left=force.pin_left,
        pin_right=force.pin_right,
        input_torque=input_torque,
        output_torque=xp.broadcast_to(branch.output_torque, scale.shape),
        left_bearing_torque=force.left_bearing_torque,
        right_bearing_torque=force.right_bearing_torque,
        balance_residual=_largest(equations) / scale,
        closure_residual=closure_error / scale,
    )


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
        Contact forces in the order of :data:`asperity.zou2025.kinematics.CONTACT_NAMES`, shape (5, ...) [N].
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
    cos_l, sin_l = xp.cos(geometry.left_push_angle), xp.sin(geometry.left_push_angle)
    cos_r, sin_r = xp.cos(geometry.right_push_angle), xp.sin(geometry.right_push_angle)
    sun, roller = geometry.sun_radius, geometry.loading_roller_radius
    count, orbit = geometry.planet_count, side.roller_orbit
    return (
        (input_torque - 2.0 * bearings.input_torque) / (count * sun) - t_sp,  # (1)
        t_sp + t_pwr * cos_th - n_pwr * sin_th + n_pwl * sin_th + t_pwl * cos_th,  # (2) x
        # (2) y
        n_sp - t_pwr * sin_th - n_pwr * cos_th - n_pwl * cos_th + t_pwl * sin_th + planet_centrifugal,
        t_pwr + t_pwl - t_sp,  # (2) M
        pin_left * cos_l - n_pwl * sin_b - t_pwl * cos_b - t_wlo,  # (3) t
        pin_left * sin_l + n_pwl * cos_b - t_pwl * sin_b - n_wlo + roller_centrifugal,  # (3) r
        t_wlo - t_pwl + 2.0 * left_bearing_torque / roller,  # (3) M
        pin_right * cos_r - n_pwr * sin_b + t_pwr * cos_b + t_wro,  # (4) t
        pin_right * sin_r + n_pwr * cos_b + t_pwr * sin_b - n_wro + roller_centrifugal,  # (4) r
        t_wro - t_pwr + 2.0 * right_bearing_torque / roller,  # (4) M
        pin_left * cos_l
        - pin_right * cos_r
        - (2.0 * bearings.output_torque + output_torque) / (count * orbit),  # (5)
    )
