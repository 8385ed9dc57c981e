r"""Rigid bodies in the plane, joined by springs at their contacts and by supports: forces of the springs.

Each contact of two rollers has a normal and a tangential spring, each support one spring to the ground. The
coordinates q are the displacements x, y of the centres and the rotations times the radius, so that all are lengths.
With the elongations :math:`e = B q`, the compliances C and the forces f of the springs

.. math:: B q - C f = 0, \qquad B^\mathsf{T} f = g

The bodies, contacts and supports are data; B follows from them. The displacements are eliminated: elongations are
compatible where :math:`Z^\mathsf{T} e = 0` for the self-stresses Z, the forces in equilibrium without a load,
:math:`B^\mathsf{T} Z = 0`. Stiffnesses are never added, so that springs of any stiffness can be combined
without loss of accuracy; a rigid spring has compliance 0, an absent one the force 0, both exactly.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

#: The body that does not move, in :attr:`PlanarAssembly.contacts`.
GROUND = -1

#: Substitutes that make the factors regular where a contact is open (share of the softest contact's stiffness) or
#: rigid (share of its compliance). The subsequent step of iterative refinement removes their effect.
_OPEN, _RIGID = 1e-10, 1e-14
#: Largest unbalanced force, relative to the load, of an assembly that carries its load.
_UNBALANCED = 1e-6


class PlanarAssembly(eqx.Module):
    """Bodies, contacts and supports of a planar drive; the batch axes of the arrays come last.

    Parameters
    ----------
    free : tuple of tuple of bool
        For each body, whether x, y and the rotation are free.
    contacts : tuple of tuple of int
        For each contact its two bodies, :data:`GROUND` for the one that does not move, and +1 where they touch from
        outside, −1 where the first lies inside the second.
    supports : tuple of int
        The body of each support. Every free centre has two supports, with stiffness 0 where it is unsupported.
    contact_direction : Array
        Unit vectors from the first body's centre to the contact, shape (contacts, 2, ...) [-].
    support_direction : Array
        Unit vectors along the supports, shape (supports, 2, ...) [-].
    """

    free: tuple[tuple[bool, bool, bool], ...] = eqx.field(static=True)
    contacts: tuple[tuple[int, int, int], ...] = eqx.field(static=True)
    supports: tuple[int, ...] = eqx.field(static=True)
    contact_direction: Array
    support_direction: Array


class SpringForces(NamedTuple):
    """Forces of the springs of an assembly under a load.

    Parameters
    ----------
    force : Array
        Normal forces of the contacts, then tangential ones, then those of the supports, shape (springs, ...) [N].
    carried : Array
        Whether the springs can carry the load, shape (...).
    """

    force: Array
    carried: Array


def elongation_matrix(assembly: PlanarAssembly) -> Array:
    r"""Elongation of each spring under a unit of each coordinate, :math:`B_{jk} = \partial e_j/\partial q_k`.

    Parameters
    ----------
    assembly : PlanarAssembly
        The bodies.

    Returns
    -------
    Array
        Shape (..., springs, coordinates) [-]: compression of a contact and slip of its first body along the direction
        turned left, then displacement along a support.

    References
    ----------
    Kinematics of rigid bodies: displacement of the centre plus rotation times arm.
    """
    bodies = len(assembly.free)
    ends = np.array([contact[:2] for contact in assembly.contacts])
    first, second = (
        np.eye(bodies + 1)[ends[:, side]][:, :bodies] for side in (0, 1)
    )  # the ground has no column
    turns = first + np.array([contact[2] for contact in assembly.contacts])[:, None] * second
    along = jnp.moveaxis(assembly.contact_direction, (0, 1), (-2, -1))[..., None, :]
    held = jnp.moveaxis(assembly.support_direction, (0, 1), (-2, -1))[..., None, :]
    apart = (first - second)[..., None]
    across = jnp.stack([-along[..., 1], along[..., 0]], axis=-1)

    def rows(translation: Array, rotation: np.ndarray) -> Array:
        turn = jnp.broadcast_to(rotation[..., None], (*translation.shape[:-1], 1))
        both = jnp.concatenate([translation, turn], axis=-1)
        return both.reshape((*both.shape[:-2], 3 * bodies))

    support_body = np.eye(bodies)[np.array(assembly.supports, dtype=int)][..., None]
    matrix = jnp.concatenate(
        [
            rows(apart * along, np.zeros_like(turns)),
            rows(apart * across, turns),
            rows(support_body * held, np.zeros(support_body.shape[:2])),
        ],
        axis=-2,
    )
    return matrix[..., np.flatnonzero(np.array(assembly.free))]


def _holding_springs(assembly: PlanarAssembly) -> list[int]:
    """Springs just sufficient to fix every coordinate: the supports, and one tangential spring per rotation."""
    count = len(assembly.contacts)
    known = {GROUND} | {body for body, free in enumerate(assembly.free) if not free[2]}
    tree: list[int] = []
    while len(known) <= len(assembly.free):
        found = [
            index
            for index, (first, second, _) in enumerate(assembly.contacts)
            if (first in known) != (second in known)
        ]
        if not found:
            raise ValueError("a body of the assembly is not connected to the ground by any chain of contacts")
        tree.append(count + found[0])
        known |= set(assembly.contacts[found[0]][:2])
    return [*range(2 * count, 2 * count + len(assembly.supports)), *tree]


def _compatibility(assembly: PlanarAssembly, matrix: Array) -> Array:
    """Z^T, shape (..., springs − coordinates, springs): every elongation follows from those of the holding springs."""
    holding = _holding_springs(assembly)
    others = [spring for spring in range(matrix.shape[-2]) if spring not in holding]
    transfer = jnp.linalg.solve(
        jnp.swapaxes(matrix[..., holding, :], -1, -2), jnp.swapaxes(matrix[..., others, :], -1, -2)
    )
    itself = jnp.broadcast_to(jnp.eye(len(others)), (*matrix.shape[:-2], len(others), len(others)))
    joined = jnp.concatenate([-jnp.swapaxes(transfer, -1, -2), itself], axis=-1)
    return joined[..., np.argsort([*holding, *others])]


def _refined_solution(matrix: Array, regular: Array, right_side: Array) -> Array:
    """Solve with the factors of a nearby regular matrix, and refine once with the matrix itself."""
    factors, _, order = jax.lax.linalg.lu(jax.lax.stop_gradient(regular))

    def triangle(vector: Array, *, lower: bool, transposed: bool) -> Array:
        return jax.lax.linalg.triangular_solve(
            factors,
            vector[..., None],
            left_side=True,
            lower=lower,
            transpose_a=transposed,
            unit_diagonal=lower,
        )[..., 0]

    def forward(vector: Array) -> Array:
        ordered = jnp.take_along_axis(vector, order, axis=-1)
        return triangle(triangle(ordered, lower=True, transposed=False), lower=False, transposed=False)

    def backward(vector: Array) -> Array:
        solved = triangle(triangle(vector, lower=False, transposed=True), lower=True, transposed=True)
        return jnp.take_along_axis(solved, jnp.argsort(order, axis=-1), axis=-1)

    def times(vector: Array) -> Array:
        return jnp.einsum("...jk,...k->...j", matrix, vector)

    def times_transposed(vector: Array) -> Array:
        return jnp.einsum("...jk,...j->...k", matrix, vector)

    def refined(rough: Callable[[Array], Array], product: Callable[[Array], Array], vector: Array) -> Array:
        found = rough(vector)
        return found + rough(vector - product(found))

    return jax.lax.custom_linear_solve(
        times,
        right_side,
        solve=lambda _, vector: refined(forward, times, vector),
        transpose_solve=lambda _, vector: refined(backward, times_transposed, vector),
    )


def _with_rank(matrix: Array, rank: int) -> Array:
    """A matrix with so many batch axes, which come last."""
    return matrix.reshape(matrix.shape[:2] + (1,) * (rank + 2 - matrix.ndim) + matrix.shape[2:])


def spring_forces(
    *, assembly: PlanarAssembly, compliance: Array, coupling: Array | None, load: np.ndarray
) -> SpringForces:
    r"""Forces of the springs of an assembly under a load.

    .. math:: B^\mathsf{T} f = g, \qquad Z^\mathsf{T} C f = 0

    Parameters
    ----------
    assembly : PlanarAssembly
        The bodies.
    compliance : Array
        Of each spring, shape (springs, ...) [m/N]: the diagonal of C; 0 is rigid, ``inf`` absent.
    coupling : Array or None
        What remains of C, for the first k springs, shape (k, k, ...) [m/N]: symmetric, with 0 on the diagonal and where
        a spring is absent; None if every spring deforms under its own force only.
    load : ndarray
        Force g on each coordinate, shape (coordinates,) [N].

    Returns
    -------
    SpringForces
        Forces, and whether they are in equilibrium.

    Notes
    -----
    One unknown p for each spring represents both force and elongation, :math:`f = p\, c_0/(c + c_0)` and
    :math:`e = c_0 p\, c/(c + c_0)` with any compliance c_0: regular for every c from 0 to infinity. Where an open
    contact leaves a body free without a load, or several rigid springs share a force, its motion or their shares are
    arbitrary, but the quantities needed for the stiffness are unique.

    References
    ----------
    Equation (A8) of :doc:`/equations`; the equilibrium form after S. A. Vavasis, SIAM J. Matrix Anal. Appl. 15 (1994)
    1108.
    """
    matrix = elongation_matrix(assembly)
    compatibility = _compatibility(assembly, matrix)
    own = jnp.moveaxis(compliance, 0, -1)
    absent = jnp.isinf(own)
    finite = jnp.where(absent, 0.0, own)
    at_contact = np.arange(own.shape[-1]) < 2 * len(assembly.contacts)
    largest = jnp.max(jnp.where(at_contact, finite, 0.0), axis=-1, keepdims=True)
    reference = jax.lax.stop_gradient(jnp.where(largest > 0.0, largest, 1.0))
    inverse = 1.0 / (finite + reference)
    force_share = jnp.where(absent, 0.0, reference * inverse)
    elongation_share = jnp.where(absent, 1.0, finite * inverse)

    mutual = None
    if coupling is not None:
        # batch axes last: the products of small matrices are then one loop over the batch
        rank = max(coupling.ndim, compatibility.ndim) - 2
        last, acting = (
            _with_rank(jnp.moveaxis(compatibility, (-2, -1), (0, 1)), rank),
            _with_rank(coupling, rank),
        )
        product = sum(last[:, k, None] * acting[k] for k in range(coupling.shape[0]))
        mutual = jnp.moveaxis(product, (0, 1), (-2, -1)) / reference[..., None]
        mutual = jnp.pad(mutual, [(0, 0)] * (mutual.ndim - 1) + [(0, own.shape[-1] - coupling.shape[0])])

    def system(forces: Array, elongations: Array) -> Array:
        fits = compatibility * elongations[..., None, :]
        if mutual is not None:
            fits = fits + mutual * forces[..., None, :]
        balance = jnp.swapaxes(matrix, -1, -2) * forces[..., None, :]
        shape = jnp.broadcast_shapes(fits.shape[:-2], balance.shape[:-2])
        return jnp.concatenate(
            [jnp.broadcast_to(part, (*shape, *part.shape[-2:])) for part in (balance, fits)], axis=-2
        )

    exact = system(force_share, elongation_share)
    regular = system(
        jnp.where(at_contact & absent, _OPEN, force_share),
        jnp.where(at_contact & (finite == 0.0) & ~absent, _RIGID, elongation_share),
    )
    right_side = jnp.broadcast_to(
        np.concatenate([load, np.zeros(own.shape[-1] - load.size)]), exact.shape[:-1]
    )
    found = _refined_solution(exact, regular, right_side)
    unbalanced = jnp.abs(jnp.einsum("...jk,...k->...j", exact, found) - right_side)
    return SpringForces(
        force=jnp.moveaxis(force_share * found, -1, 0),
        carried=jnp.max(unbalanced, axis=-1) < _UNBALANCED * float(np.max(np.abs(load))),
    )
