r"""Forces of one branch of the drive from two or three unknowns by statics, equations (1)–(5).

The thirteen unknown forces of a branch reduce to three, exactly: the sun–planet tangential force
:math:`T_{sp}`, the sum :math:`S = N_{pwr} + N_{pwl}` of the planet's loads, and the right one's share of
:math:`T_{sp}`. In a drive at rest both planet–roller contacts are assumed to have the same traction coefficient
:math:`c = T_{sp}/S`; in a rolling drive the creepages determine the split. Either way (2) gives
:math:`N_{pwr} - N_{pwl} = T_{sp} \cot(\theta/2)`; every other force follows from one line of (1)–(5) each.
"""

from __future__ import annotations

from typing import NamedTuple

from asperity.drive.bearings import bearing_torque
from asperity.drive.layout.wedge_geometry import Triangle
from asperity.engine.arrays import xp
from asperity.engine.derivatives import with_rule
from asperity.types import Array, Real
from asperity.zou2025.mechanism import Mechanism, RestState


class Branch(NamedTuple):
    """Quantities that are constant while the two unknowns are solved for; SI units.

    Parameters
    ----------
    mechanism : Mechanism
        The drive.
    sides : Triangle
        Its triangle of centres.
    rest : RestState
        Its forces at rest [N].
    output_torque : Array
        T_out at the carrier [N·m].
    planet_centrifugal, roller_centrifugal : Real
        m omega_c^2 r of a planet and of a loading roller [N].
    """

    mechanism: Mechanism
    sides: Triangle
    rest: RestState
    output_torque: Array
    planet_centrifugal: Real
    roller_centrifugal: Real


class BranchForces(NamedTuple):
    """Forces of one branch, contacts in the order ``sp, pwr, pwl, wro, wlo``; arrays of one shape.

    Parameters
    ----------
    normal, tangential : tuple of Array
        Forces of the five contacts [N].
    pin_left, pin_right : Array
        Carrier pin forces F_cl, F_cr [N].
    left_bearing_torque, right_bearing_torque : Array
        Friction torque T_B of one bearing of either loading roller [N·m].
    """

    normal: tuple[Array, ...]
    tangential: tuple[Array, ...]
    pin_left: Array
    pin_right: Array
    left_bearing_torque: Array
    right_bearing_torque: Array


@with_rule
def _reciprocal(x: Array) -> Array:
    """1/x, whose derivative reuses the value instead of dividing again."""
    return 1.0 / x


@_reciprocal.defjvp
def _reciprocal_jvp(primals: tuple[Array], tangents: tuple[Array]) -> tuple[Array, Array]:
    value = _reciprocal(*primals)
    return value, -value * value * tangents[0]


def branch_forces(
    branch: Branch, load_sum: Array, sun_force: Array, right_force: Array | None = None
) -> BranchForces:
    """All forces of a branch from S, T_sp and the split of T_sp, one published equation per line.

    Parameters
    ----------
    branch : Branch
        The branch.
    load_sum, sun_force : Array
        S = N_pwr + N_pwl and T_sp [N].
    right_force : Array, optional
        T_pwr [N]; by default both planet–roller contacts have the same traction coefficient (A3).

    Returns
    -------
    BranchForces
        Forces that satisfy (1)–(4) and the split; not yet the carrier's moment (5) and the closure.

    Notes
    -----
    Divisions by constants are written as products with an inverse: for XLA on a CPU, each quotient that depends on
    the unknowns is a pass over memory.

    References
    ----------
    Zou et al. 2025, equations (2)–(4); the signs of (2) and (4) as in :doc:`/assumptions`.
    """
    side, geometry, bearings = branch.sides, branch.mechanism.geometry, branch.mechanism.bearings
    radius = geometry.loading_roller_radius
    cos_l, sin_l = xp.cos(geometry.left_push_angle), xp.sin(geometry.left_push_angle)
    cos_r, sin_r = xp.cos(geometry.right_push_angle), xp.sin(geometry.right_push_angle)
    difference = sun_force * ((1.0 + side.cos_direction) / side.sin_direction)  # (2) x and moment
    n_pwr, n_pwl = 0.5 * (load_sum + difference), 0.5 * (load_sum - difference)
    if right_force is None:
        traction = sun_force * _reciprocal(load_sum)  # (A3) equal traction coefficients
        t_pwr, t_pwl = traction * n_pwr, traction * n_pwl
    else:
        t_pwr, t_pwl = right_force, sun_force - right_force  # (2) moment
    # (2) y
    n_sp = (t_pwr - t_pwl) * side.sin_direction + load_sum * side.cos_direction - branch.planet_centrifugal
    # (3) t and (4) t with the roller moments T_wo = T_pw − 2 T_B/R_w put in; a pin's friction grows with |F|
    push_l = n_pwl * side.sin_wedge + t_pwl * (1.0 + side.cos_wedge)
    push_r = n_pwr * side.sin_wedge - t_pwr * (1.0 + side.cos_wedge)
    constant = 2.0 * bearings.roller_torque / radius
    pin_friction = 0.5 * bearings.pin_friction_coefficient * bearings.pin_friction_diameter / radius
    f_cl = (push_l - constant) * xp.where(
        push_l > constant, 1.0 / (cos_l + pin_friction), 1.0 / (cos_l - pin_friction)
    )
    f_cr = (push_r + constant) * xp.where(
        push_r > -constant, 1.0 / (cos_r - pin_friction), 1.0 / (cos_r + pin_friction)
    )
    b_l, b_r = (bearing_torque(bearings=bearings, pin_force=force) for force in (f_cl, f_cr))
    # (4) r and (3) r
    n_wro = f_cr * sin_r + n_pwr * side.cos_wedge + t_pwr * side.sin_wedge + branch.roller_centrifugal
    n_wlo = f_cl * sin_l + n_pwl * side.cos_wedge - t_pwl * side.sin_wedge + branch.roller_centrifugal
    t_wro, t_wlo = t_pwr - b_r * (2.0 / radius), t_pwl - b_l * (2.0 / radius)  # (4) M, (3) M
    return BranchForces(
        normal=(n_sp, n_pwr, n_pwl, n_wro, n_wlo),
        tangential=(sun_force, t_pwr, t_pwl, t_wro, t_wlo),
        pin_left=f_cl,
        pin_right=f_cr,
        left_bearing_torque=b_l,
        right_bearing_torque=b_r,
    )


def carrier_residual(branch: Branch, force: BranchForces) -> Array:
    """Equation (5), the carrier's moment, over n (R_o − R_w).

    Parameters
    ----------
    branch : Branch
        The branch.
    force : BranchForces
        Its forces.

    Returns
    -------
    Array
        Residual [N]; 0 in equilibrium.

    References
    ----------
    Zou et al. 2025, equation (5).
    """
    geometry = branch.mechanism.geometry
    left, right = geometry.left_push_angle, geometry.right_push_angle
    push = force.pin_left * xp.cos(left) - force.pin_right * xp.cos(right)
    torque = 2.0 * branch.mechanism.bearings.output_torque + branch.output_torque
    return push - torque / (geometry.planet_count * branch.sides.roller_orbit)  # (5)


def contact_floors(branch: Branch, sun_force: Array) -> tuple[Array, Array]:
    r"""Load sum at which a contact lifts off: equation (2) with one normal force set to zero.

    .. math::
        S_{pwl} = |k T_{sp}|, \quad
        S_{sp} = \frac{C_p + \sqrt{C_p^2 - 4 k T_{sp}^2 \sin\theta\cos\theta}}{2\cos\theta}, \quad
        k = \cot\frac\theta2

    with the planet's centrifugal force C_p.

    Parameters
    ----------
    branch : Branch
        The branch.
    sun_force : Array
        T_sp [N].

    Returns
    -------
    roller, planet : Array
        S at N_pwl = 0, and S at N_sp = 0 under the planet's centrifugal force [N]; 0 where N_sp never vanishes.

    References
    ----------
    Zou et al. 2025, equation (2), with equal creep (A3) of :doc:`/equations`.
    """
    side, centrifugal = branch.sides, branch.planet_centrifugal
    difference = sun_force * ((1.0 + side.cos_direction) / side.sin_direction)
    product = centrifugal**2 - 4.0 * side.cos_direction * side.sin_direction * sun_force * difference
    real = product > 0.0
    root = xp.where(real, xp.sqrt(xp.where(real, product, 1.0)), -centrifugal)
    return xp.abs(difference), (centrifugal + root) * (0.5 / side.cos_direction)


def held_load_sum(branch: Branch, load_sum: Array, sun_force: Array) -> Array:
    """S, or the smallest S at which no normal force is negative: a lifted contact carries no force.

    Parameters
    ----------
    branch : Branch
        The branch.
    load_sum, sun_force : Array
        S and T_sp [N].

    Returns
    -------
    Array
        The larger of S and of both :func:`contact_floors` [N].
    """
    roller, planet = contact_floors(branch, sun_force)
    floor = xp.where(roller > planet, roller, planet)
    return xp.where(load_sum > floor, load_sum, floor)
