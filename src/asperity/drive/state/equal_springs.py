"""Forces of an assembled drive whose contacts all have one spring: exact where statics alone decides them."""

from __future__ import annotations

import jax.numpy as jnp
from jax import Array

from asperity.drive.layout.drive import Drive, incidence
from asperity.linear import solve


def rest_forces(*, drive: Drive, pattern: Array) -> Array:
    r"""Normal forces of an assembled drive over that of its first contact.

    .. math:: N = A u + p\,\delta, \qquad A^\mathsf{T} N + P^\mathsf{T} F = 0, \qquad P u = 0, \qquad N_1 = 1

    Parameters
    ----------
    drive : Drive
        The drive.
    pattern : Array
        Interference p of each contact over that of the drive, shape (contacts,) [-].

    Returns
    -------
    Array
        Forces, shape (contacts,) [-].

    References
    ----------
    Equation (M1) of :doc:`/equations`.
    """
    matrices = incidence(drive)
    contacts, moves, pins = matrices.approach.shape[0], matrices.approach.shape[1], matrices.pins.shape[0]
    none = jnp.zeros
    system = jnp.block(
        [
            [jnp.eye(contacts), none((contacts, pins)), -matrices.approach, -pattern[:, None]],
            [none((pins, contacts)), none((pins, pins)), matrices.pins, none((pins, 1))],
            [matrices.approach.T, matrices.pins.T, none((moves, moves)), none((moves, 1))],
            [jnp.eye(1, contacts), none((1, pins)), none((1, moves)), none((1, 1))],
        ]
    )
    return solve(system, jnp.eye(system.shape[0])[-1])[:contacts]
