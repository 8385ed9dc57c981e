r"""Forces, creepages and speeds of a rolling drive, without further assumptions.

A drive at rest needs an assumption on how the two loading rollers of a planet share its torque. In a rolling
drive both connect the same two surfaces, the planet's and the ring's, so that their creepages determine the split:

.. math::
    \prod_{k \in \{pwr, wro\}} \frac{1-\xi_k/2}{1+\xi_k/2} = \prod_{k \in \{pwl, wlo\}} \frac{1-\xi_k/2}{1+\xi_k/2},
    \qquad \xi_k = \kappa_k \sqrt{N_k}\left[1 - \sqrt{1 - T_k/(\mu_k N_k)}\right]

(Carter's creep of each contact; creepage is the difference of the surface speeds over their mean.) With (1)–(5) and
the closure (A3) these are as many equations as forces.
"""

from __future__ import annotations

from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.branch import Branch, BranchForces, branch_forces, carrier_residual
from asperity.drive.force_balance import DriveForces, closure_misfit, loaded_branch
from asperity.drive.geometry import DriveGeometry
from asperity.drive.mechanism import Mechanism
from asperity.implicit import implicit_root
from asperity.types import Real

#: Largest relative residual of a rolling state that is accepted as solved.
ROLLING_TOLERANCE = 1e-9

_NEWTON_STEPS = 8
_STEP_TOLERANCE = 1e-7  # relative; the error after it is its square times up to 1e4, near gross slip
_NEAR_SLIP = 0.999  # Carter's curve is continued as a line above this share of friction, for iterates only


class CreepLaw(eqx.Module):
    r"""Creep of the five contacts, :math:`\xi = \kappa\sqrt N\,[1-\sqrt{1-T/(\mu N)}]`.

    Parameters
    ----------
    friction_coefficient : Real
        mu, shape (1 or 5, ...) [-].
    gross_slip_scale : Real
        kappa: creepage at gross slip over the root of the normal force, shape (5, ...) [1/√N]. For Carter's contact
        :math:`\mu a/(R\sqrt N)`, times the factor of an elastic layer.
    """

    friction_coefficient: Real
    gross_slip_scale: Real


class RollingState(eqx.Module):
    """Forces, creepages and speeds of a drive in steady rolling. SI units; contact axis first.

    Parameters
    ----------
    normal, tangential : Array
        Forces of the contacts ``sp, pwr, pwl, wro, wlo``, shape (5, ...) [N].
    pin_left, pin_right : Array
        Carrier pin forces [N].
    left_bearing_torque, right_bearing_torque : Array
        Friction torque of one bearing of the left and of the right loading roller [N·m].
    creepage : Array
        Creepages xi, shape (5, ...) [-], with the sign of the tangential forces.
    speed_loss : Array
        Share of the output speed, and of the output angle, lost by creep [-]; negative where the torque drives
        the rotation.
    residual : Array
        Largest relative residual of closure, carrier moment and equal creep [-]; nan where a contact is open
        or in gross slip.
    """

    normal: Array
    tangential: Array
    pin_left: Array
    pin_right: Array
    left_bearing_torque: Array
    right_bearing_torque: Array
    creepage: Array
    speed_loss: Array
    residual: Array


class _Unknowns(NamedTuple):
    load_sum: Array
    sun_force: Array
    right_force: Array


def creepages(*, law: CreepLaw, normal: Array, tangential: Array) -> Array:
    r"""Creepage of contacts under given forces.

    .. math:: \xi = \kappa\sqrt N\,\frac{q}{1 + \sqrt{1-|q|}}, \qquad q = \frac{T}{\mu N}

    Parameters
    ----------
    law : CreepLaw
        The law of each contact.
    normal, tangential : Array
        Forces, shape (5, ...) [N]; the tangential ones of either sign.

    Returns
    -------
    Array
        Creepages, shape (5, ...) [-]; above 99.9 % of friction the tangent is continued, for iterates of
        a solver only.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; equation (B1) of :doc:`/equations`.
    """
    touching = normal > 0.0
    safe_normal = jnp.where(touching, normal, 1.0)
    q = tangential / (law.friction_coefficient * safe_normal)
    return jnp.where(touching, law.gross_slip_scale * _creep_shape(safe_normal, q), 0.0)


@jax.custom_jvp
def _creep_shape(normal: Array, q: Array) -> Array:
    """Carter's curve, √N [1 − √(1 − q)] with the sign of q, and its tangent near gross slip."""
    return jnp.sqrt(normal) * _carter(q)[0]


@_creep_shape.defjvp
def _creep_shape_jvp(primals: tuple[Array, Array], tangents: tuple[Array, Array]) -> tuple[Array, Array]:
    (normal, q), (normal_dot, q_dot) = primals, tangents
    share, slope = _carter(q)
    size = jnp.sqrt(normal)
    return size * share, (0.5 * share / size) * normal_dot + (size * slope) * q_dot


def _carter(q: Array) -> tuple[Array, Array]:
    """1 − √(1 − q) with the sign of q, and its slope."""
    size = jnp.abs(q)
    held = jnp.minimum(size, _NEAR_SLIP)
    root = jnp.sqrt(1.0 - held)
    slope = 0.5 / root
    return jnp.sign(q) * (held / (1.0 + root) + slope * (size - held)), slope


def lost_speed(creepage: Array) -> Array:
    r"""Logarithm of the speed of the driving surface over that of the driven one.

    .. math:: \ln\frac{1 + \xi/2}{1 - \xi/2} = 2\operatorname{artanh}\frac\xi2

    Parameters
    ----------
    creepage : Array
        Difference of the surface speeds over their mean [-].

    Returns
    -------
    Array
        Logarithm [-], which adds up over contacts in series.

    References
    ----------
    The definition of creepage; equation (B3) of :doc:`/equations`.
    """
    return 2.0 * jnp.arctanh(0.5 * creepage)


def drift_per_turn(loss: Real) -> Array:
    r"""Angle that the output falls behind in one of its turns, :math:`2\pi s/(1-s)`.

    Parameters
    ----------
    loss : Real
        Speed loss s of the drive [-].

    Returns
    -------
    Array
        Angle [rad]; negative where the creep runs ahead.

    References
    ----------
    Equation (B3) of :doc:`/equations`.
    """
    share = jnp.asarray(loss)
    return 2.0 * jnp.pi * share / (1.0 - share)


def speed_loss(*, geometry: DriveGeometry, creepage: Array) -> Array:
    r"""Exact share of the output speed that is lost by creep.

    .. math::
        1 - \frac{\omega_c}{\omega_{c,0}} = 1 - \rho\,\frac{R_o - R_s}{R_o - \rho R_s}
        \approx \xi_\Sigma \frac{R_o}{R_o-R_s},
        \qquad \rho = \prod \frac{1-\xi_k/2}{1+\xi_k/2}

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    creepage : Array
        Creepages, shape (5, ...) [-]; those in series on the right side are used, in a rolling state both sides agree.

    Returns
    -------
    Array
        Loss [-].

    References
    ----------
    Equation (B3) of :doc:`/equations`: in the carrier's frame the ring's surface is slower than the sun's by the
    product over the contacts in series.
    """
    missing = -jnp.expm1(-(lost_speed(creepage[0]) + lost_speed(creepage[1]) + lost_speed(creepage[3])))
    ring, sun = geometry.ring_radius, geometry.sun_radius
    return missing * ring / (ring - sun * (1.0 - missing))


def _forces(branch: Branch, unknowns: _Unknowns) -> BranchForces:
    return branch_forces(branch, unknowns.load_sum, unknowns.sun_force, unknowns.right_force)


def _creep(law: CreepLaw, force: BranchForces, k: int) -> Array:
    """Creepage of one contact; contact by contact, because XLA would write a stacked array to memory first."""
    one = CreepLaw(
        jnp.asarray(law.friction_coefficient)[min(k, jnp.shape(law.friction_coefficient)[0] - 1)],
        jnp.asarray(law.gross_slip_scale)[k],
    )
    return creepages(law=one, normal=force.normal[k], tangential=force.tangential[k])


def _misfits(branch: Branch, law: CreepLaw, unknowns: _Unknowns) -> _Unknowns:
    """Closure, carrier moment and equal creep, each as a force [N]."""
    force = _forces(branch, unknowns)
    a, b, c, d = (0.5 * _creep(law, force, k) for k in (1, 3, 2, 4))
    friction, scale = jnp.asarray(law.friction_coefficient), jnp.asarray(law.gross_slip_scale)
    per_creep = (
        jnp.sqrt(branch.rest.normal_force[3]) * friction[-1] / scale[3]
    )  # mu N over creepage at gross slip
    return _Unknowns(
        jnp.asarray(closure_misfit(branch, force)),
        carrier_residual(branch, force),
        # (1 − a)(1 − b)(1 + c)(1 + d) = (1 + a)(1 + b)(1 − c)(1 − d), the same products on both sides taken out
        2.0 * ((a + b) * (1.0 + c * d) - (c + d) * (1.0 + a * b)) * per_creep,
    )


def _solve_three(linear, right_side: _Unknowns) -> _Unknowns:  # type: ignore[no-untyped-def]
    """Solve linear(u) = right_side for three numbers, elementwise, by cofactors."""
    one, zero = jnp.ones_like(right_side[0]), jnp.zeros_like(right_side[0])
    a, d, g = linear(_Unknowns(one, zero, zero))
    b, e, h = linear(_Unknowns(zero, one, zero))
    c, f, i = linear(_Unknowns(zero, zero, one))
    p, q, r = right_side
    first, second, third = e * i - f * h, f * g - d * i, d * h - e * g
    inverse = 1.0 / (a * first + b * second + c * third)
    return _Unknowns(
        (first * p + (c * h - b * i) * q + (b * f - c * e) * r) * inverse,
        (second * p + (a * i - c * g) * q + (c * d - a * f) * r) * inverse,
        (third * p + (b * g - a * h) * q + (a * e - b * d) * r) * inverse,
    )


def _newton(misfits, start: _Unknowns) -> _Unknowns:  # type: ignore[no-untyped-def]
    """Newton's method until the last step of every point is negligible, or the budget is spent."""

    def unfinished(state: tuple[_Unknowns, Array, Array]) -> Array:
        _, moving, count = state
        return moving & (count < _NEWTON_STEPS)

    def improve(state: tuple[_Unknowns, Array, Array]) -> tuple[_Unknowns, Array, Array]:
        unknowns, _, count = state
        value, tangent_map = jax.linearize(misfits, unknowns)
        step = _solve_three(tangent_map, value)
        size = _STEP_TOLERANCE * (jnp.abs(unknowns.load_sum) + jnp.abs(unknowns.sun_force))
        moving = jnp.any(  # a nan does not move
            (jnp.abs(step[0]) > size) | (jnp.abs(step[1]) > size) | (jnp.abs(step[2]) > size)
        )
        return _Unknowns(*(x - dx for x, dx in zip(unknowns, step, strict=True))), moving, count + 1

    found, *_ = jax.lax.while_loop(unfinished, improve, (start, jnp.asarray(True), jnp.asarray(0)))
    return found


def rolling_state(*, mechanism: Mechanism, standing: DriveForces, law: CreepLaw) -> RollingState:
    """Steady rolling of a drive under the output torque of a standing state.

    Parameters
    ----------
    mechanism : Mechanism
        The preloaded drive.
    standing : DriveForces
        Its forces at rest under the same output torque, from which the search starts.
    law : CreepLaw
        Creep of the contacts.

    Returns
    -------
    RollingState
        Forces, creepages and speed loss; nan where a contact has lifted off or is in gross slip.

    Notes
    -----
    Newton's method, quadratic from the standing state; derivatives are those of the equations at their root. The
    approaches of the bodies are linear in their displacements (micrometres against millimetres): with displaced
    directions of the normals the forces differ by some 0.05 %.

    References
    ----------
    Equations (1)–(5) of Zou et al. 2025; (A3), (B1) and (B3) of :doc:`/equations`.
    """
    branch = loaded_branch(mechanism=mechanism, output_torque=standing.output_torque)
    start = _Unknowns(standing.normal[1] + standing.normal[2], standing.tangential[0], standing.tangential[1])

    def misfits(unknowns: _Unknowns) -> _Unknowns:
        return _misfits(branch, law, unknowns)

    found = _Unknowns(*implicit_root(misfits, start, _newton, _solve_three))
    force = _forces(branch, found)
    normal = jnp.stack(jnp.broadcast_arrays(*force.normal))
    tangential = jnp.stack(jnp.broadcast_arrays(*force.tangential))
    rolls = jnp.all((normal > 0.0) & (jnp.abs(tangential) < law.friction_coefficient * normal), axis=0)
    scale = jnp.max(jnp.abs(normal), axis=0)
    residual = jnp.max(jnp.abs(jnp.stack(jnp.broadcast_arrays(*misfits(found)))), axis=0) / scale
    creepage = jnp.where(rolls, creepages(law=law, normal=normal, tangential=tangential), jnp.nan)
    return RollingState(
        normal=normal,
        tangential=tangential,
        pin_left=force.pin_left,
        pin_right=force.pin_right,
        left_bearing_torque=force.left_bearing_torque,
        right_bearing_torque=force.right_bearing_torque,
        creepage=creepage,
        speed_loss=speed_loss(geometry=mechanism.geometry, creepage=creepage),
        residual=jnp.where(rolls, residual, jnp.nan),
    )
