r"""Forces, displacements and speeds of a planar roller drive at rest and in steady rolling.

Every floating body has two displacements and an angular velocity, and as many equations of balance. The normal force
of a contact follows from the approach of its bodies, the tangential force from their creep; no further assumption is
needed:

.. math::
    A^\mathsf{T} N + S^\mathsf{T} T + P^\mathsf{T} F = 0, \quad (W^\mathsf{T} T)_j + \dots = 0, \quad
    \delta_k(N_k) = (A u)_k + \delta_k^0, \quad \xi_k(T_k, N_k) = \frac{(W\omega)_k}{V_k}
"""

from __future__ import annotations

from typing import NamedTuple

import equinox as eqx
import jax
import jax.flatten_util
import jax.numpy as jnp
from jax import Array

from asperity.drive.mechanism import NormalSprings, compression
from asperity.drive.planar.layout import CARRIER, Incidence, PlanarDrive, incidence, speeds
from asperity.drive.rolling_state import CreepLaw, creepages
from asperity.types import Real

#: Largest relative residual of a state that is accepted as solved.
STATE_TOLERANCE = 1e-9

_NEWTON_BUDGET = 60
_SMALLEST_SHARE = 0.2  # a step leaves at least this share of each normal force


class ContactLaws(eqx.Module):
    """Response of the contacts of a drive to approach and creep. SI units, shape (contacts,).

    Parameters
    ----------
    springs : NormalSprings
        Secant and incremental compliance of the bodies at the reference forces [m/N].
    reference_force : Array
        Normal forces at which the springs are given [N].
    creep : CreepLaw
        Carter's creep.
    """

    springs: NormalSprings
    reference_force: Array
    creep: CreepLaw


class PlanarState(eqx.Module):
    """A balanced state of a drive. SI units.

    Parameters
    ----------
    normal, tangential : Array
        Forces of the contacts, shape (contacts,) [N]; a positive tangential force opposes a first surface that moves
        counter-clockwise around its body faster than the second.
    pin_force : Array
        Forces of the pins on their bodies, against the push direction, shape (pins,) [N].
    displacement : Array
        Displacements of the floating centres from first contact, shape (floating, 2) [m].
    speed : Array
        Angular velocities of the members per angular velocity of the input, shape (members,) [-].
    creepage : Array
        Creepages, shape (contacts,) [-].
    interference : Array
        Interference of the contacts, shape (contacts,) [m].
    input_torque : Array
        Torque at the input, in the sense of its rotation [N·m].
    speed_loss : Array
        Share of the output speed lost by creep [-].
    residual : Array
        Largest relative residual of all equations [-].
    """

    normal: Array
    tangential: Array
    pin_force: Array
    displacement: Array
    speed: Array
    creepage: Array
    interference: Array
    input_torque: Array
    speed_loss: Array
    residual: Array


class _Unknowns(NamedTuple):
    normal: Array  # over its reference
    tangential: Array  # over the friction limit at the reference
    pin: Array  # over the largest reference
    displacement: Array  # over the approach at the reference
    speed: Array
    interference: Array  # over the approach at the reference


def state_at_rest(*, drive: PlanarDrive, laws: ContactLaws, pattern: Array, preload: Real) -> PlanarState:
    """The assembled drive without torque: forces from the preload, and the interference that causes it.

    Parameters
    ----------
    drive : PlanarDrive
        The drive.
    laws : ContactLaws
        Its contacts.
    pattern : Array
        Interference of each contact over the interference of the drive, shape (contacts,) [-]; 1 at the ring's
        contacts where the ring's radius is too small.
    preload : Real
        Normal force of the first contact [N].

    Returns
    -------
    PlanarState
        State without rotation or creep; ``interference`` is that required for the preload.

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    return _solved(drive, laws, pattern, jnp.asarray(preload), None, None)


def rolling_state(
    *, drive: PlanarDrive, laws: ContactLaws, interference: Array, output_torque: Real, start: PlanarState
) -> PlanarState:
    """The drive in steady rolling under an output torque that resists the rotation.

    Parameters
    ----------
    drive : PlanarDrive
        The drive.
    laws : ContactLaws
        Its contacts.
    interference : Array
        Interference of each contact, shape (contacts,) [m].
    output_torque : Real
        Torque at the output against its rotation [N·m].
    start : PlanarState
        Initial state of the solution, :func:`state_at_rest`.

    Returns
    -------
    PlanarState
        Forces, displacements, speeds and creepages; check ``residual``, which is large where a contact is in gross
        slip or has lifted off.

    References
    ----------
    Equations (B1), (B3) and (M3) of :doc:`/equations`.
    """
    return _solved(drive, laws, interference, None, jnp.asarray(output_torque), start)


def _solved(
    drive: PlanarDrive,
    laws: ContactLaws,
    interference: Array,
    preload: Array | None,
    torque: Array | None,
    start: PlanarState | None,
) -> PlanarState:
    """Newton's method on all equations at once; with a preload the interference is the pattern times an unknown."""
    matrices = incidence(drive)
    ideal = speeds(drive)
    reference, friction = (
        laws.reference_force,
        jnp.broadcast_to(laws.creep.friction_coefficient, laws.reference_force.shape),
    )
    length = jnp.max(laws.springs.secant_compliance * reference)
    largest = jnp.max(reference)
    members = drive.members
    turning = [i for i, name in enumerate(members) if name not in (drive.input, drive.grounded)]

    def physical(x: _Unknowns) -> tuple[Array, Array, Array, Array, Array, Array]:
        speed = ideal.at[jnp.array(turning)].add(x.speed)
        size = x.interference * length if preload is not None else 1.0
        return (
            x.normal * reference,
            x.tangential * friction * reference,
            x.pin * largest,
            x.displacement * length,
            speed,
            interference * size,
        )

    def equations(x: _Unknowns) -> _Unknowns:
        normal, tangential, pin, moved, speed, given = physical(x)
        approach = compression(springs=laws.springs, normal_force=normal, rest_force=reference) + (
            laws.springs.secant_compliance * reference
        )
        misfit = (approach - matrices.approach @ moved - given) / length
        rolled = _rolled(drive, matrices, speed)
        creep = creepages(law=laws.creep, normal=normal, tangential=tangential) * rolled
        slip = matrices.turning @ speed
        force = (
            matrices.approach.T @ normal + matrices.sliding.T @ tangential + matrices.pins.T @ pin
        ) / largest
        moments = _moments(drive, matrices, tangential, pin)
        lever = jnp.max(drive.second_radius)
        if torque is not None:
            out = members.index(drive.output)
            moments = moments.at[out].add(-jnp.sign(ideal[out]) * torque)
        held = x.interference if preload is None else (normal[:1] - preload) / largest
        return _Unknowns(
            misfit,
            (creep - slip) / lever * 1e3 if preload is None else x.tangential,
            matrices.pins @ moved / length,
            force,
            moments[jnp.array(turning)] / (lever * largest) if preload is None else x.speed,
            held,
        )

    if start is None:
        first = _Unknowns(
            jnp.ones_like(reference),
            jnp.zeros_like(reference),
            jnp.zeros(len(drive.pinned)),
            jnp.zeros(2 * len(drive.floating)),
            jnp.zeros(len(turning)),
            jnp.ones(1),
        )
    else:
        first = _Unknowns(
            start.normal / reference,
            start.tangential / (friction * reference),
            start.pin_force / largest,
            start.displacement.ravel() / length,
            (start.speed - ideal)[jnp.array(turning)],
            jnp.zeros(1),
        )
    found, _ = _root(equations, first)
    normal, tangential, pin, moved, speed, given = physical(found)
    carried = (normal > 0.0) & (jnp.abs(tangential) <= friction * normal)
    worst = jnp.max(jnp.abs(jnp.concatenate(list(equations(found)))))
    out, entry = members.index(drive.output), members.index(drive.input)
    return PlanarState(
        normal=normal,
        tangential=tangential,
        pin_force=pin,
        displacement=moved.reshape(-1, 2),
        speed=speed,
        creepage=creepages(law=laws.creep, normal=normal, tangential=tangential),
        interference=given,
        input_torque=-drive.sense * _moments(drive, matrices, tangential, pin)[entry],
        speed_loss=1.0 - speed[out] / ideal[out],
        residual=jnp.where(jnp.all(carried), worst, jnp.inf),
    )


def _rolled(drive: PlanarDrive, matrices: Incidence, speed: Array) -> Array:
    """Rolling speed of each contact relative to the carrier, the mean of its surface speeds [m]."""
    members = drive.members
    carrier = speed[members.index(CARRIER)]
    first = jnp.array([members.index(contact.first) for contact in drive.contacts])
    second = jnp.array([members.index(contact.second) for contact in drive.contacts])
    one = drive.first_radius * jnp.abs(speed[first] - carrier)
    two = drive.second_radius * jnp.abs(speed[second] - carrier)
    return 0.5 * (one + two)


def _moments(drive: PlanarDrive, matrices: Incidence, tangential: Array, pin: Array) -> Array:
    """Moments of contacts and pins on the members, those on the axis from all sectors, shape (members,) [N·m]."""
    members = drive.members
    carrier = members.index(CARRIER)
    moments = -(matrices.turning.at[:, carrier].set(0.0).T @ tangential)
    moments = moments.at[carrier].set(jnp.sum(matrices.levers * pin))
    copies = [drive.sectors if body.place == "axis" else 1 for body in drive.bodies] + [drive.sectors]
    return moments * jnp.array(copies, dtype=float)


def _root(equations, first: _Unknowns) -> tuple[_Unknowns, Array]:  # type: ignore[no-untyped-def]
    """Newton's method with dense steps, shortened where a normal force would decrease too fast."""
    flat, shape = jax.flatten_util.ravel_pytree(first)
    count = first.normal.size

    def residual(x: Array) -> Array:
        return jax.flatten_util.ravel_pytree(equations(shape(x)))[0]

    def solve(_: object, start: Array) -> Array:
        def unfinished(state: tuple[Array, Array, Array]) -> Array:
            _, size, steps = state
            return (size > 1e-13) & (steps < _NEWTON_BUDGET)

        def improve(state: tuple[Array, Array, Array]) -> tuple[Array, Array, Array]:
            x, _, steps = state
            step = jnp.linalg.solve(jax.jacfwd(residual)(x), residual(x))
            normal, falling = x[:count], step[:count]
            room = jnp.where(falling > 0.0, (1.0 - _SMALLEST_SHARE) * normal / falling, jnp.inf)
            share = jnp.minimum(1.0, jnp.min(room))
            return x - share * step, jnp.max(jnp.abs(step)), steps + 1

        x, *_ = jax.lax.while_loop(unfinished, improve, (start, jnp.asarray(1.0), jnp.asarray(0)))
        return x

    def tangent_solve(linear, right_side: Array) -> Array:  # type: ignore[no-untyped-def]
        return jnp.linalg.solve(jax.jacfwd(linear)(right_side), right_side)

    found = jax.lax.custom_root(residual, flat, lambda _, x: solve(_, x), tangent_solve)
    return shape(found), found
