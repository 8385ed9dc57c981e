r"""Springs of a machine with elastic bodies: one compliance matrix of all its contacts.

A contact acts with :math:`N` on both bodies and with :math:`T` in opposite directions. On every body the
outward and counter-clockwise components of these forces have the same sign, so that the matrices of the bodies
add up where contacts share a body:

.. math:: C_{ij} = \sum_{\text{bodies } b \ni i, j} C^{(b)}_{ij}

for normal and tangential components. With it the assembly is :math:`B q - C f = 0`, :math:`B^\mathsf{T} f = g`;
:func:`asperity.drive.assembly.assembly_stiffness` takes its diagonal as springs and the rest as their coupling.
"""

from __future__ import annotations

from collections.abc import Sequence

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.body.compliance import compliance_matrix
from asperity.body.shapes import Annulus, Disc


class BodyInMachine(eqx.Module):
    """A body and the positions of its contacts.

    Parameters
    ----------
    body : Disc or Annulus
        The body.
    contacts : tuple of int
        Numbers of its contacts in the machine's list [-].
    contact_angles : Array
        Polar angles of these contacts about the body's centre, counter-clockwise in the plane of the machine,
        shape (n, ...) [rad].
    copies : int
        Number of sectors of the machine that this body belongs to: that of the planets for sun and ring, 1 for a
        body of one sector [-].
    """

    body: Disc | Annulus
    contacts: tuple[int, ...] = eqx.field(static=True)
    contact_angles: Array
    copies: int = eqx.field(static=True)


def coupled_compliance(
    *,
    bodies: Sequence[BodyInMachine],
    half_widths: Array,
    stick_half_widths: Array,
    mode_count: int,
) -> Array:
    r"""Compliance matrix of all contacts of one sector of a machine of elastic bodies.

    .. math:: C = \sum_b P_b^\mathsf{T} C^{(b)} P_b

    Parameters
    ----------
    bodies : sequence of BodyInMachine
        The bodies; :math:`P_b` picks their contacts.
    half_widths : Array
        Half-widths of the m contacts of the sector, shape (m, ...) [m].
    stick_half_widths : Array
        Half-widths of their stick zones, shape (m, ...) [m].
    mode_count : int
        Modes to sum for the annuli, :func:`~asperity.body.compliance.modes_needed` [-].

    Returns
    -------
    Array
        Compliance, shape (2m, 2m, ...), first the normal, then the tangential springs [m/N]. Elongations are
        approach, and slip along the counter-clockwise tangent of either body where both touch from outside, of the
        inner one where a ring surrounds it.

    Notes
    -----
    All sectors are loaded equally, as under a torque. The elongations of the springs are the sum of this matrix times
    the forces and of the rigid motions of the bodies, the unknowns :math:`q` of the assembly.

    References
    ----------
    Equation (E3) of :doc:`/equations`.
    """
    total = jnp.zeros(())
    for member in bodies:
        pick = np.array(member.contacts)
        own = compliance_matrix(
            body=member.body,
            contact_angles=jnp.asarray(member.contact_angles),
            half_widths=half_widths[pick],
            stick_half_widths=stick_half_widths[pick],
            copies=member.copies,
            mode_count=mode_count,
        )
        places = _places(pick, half_widths.shape[0])
        total = total + jnp.einsum("ai,ij...,bj->ab...", places, own, places)
    return total


def _places(pick: np.ndarray, contact_count: int) -> np.ndarray:
    """Matrix with a one for every component of a body's contacts in the list of the sector."""
    places = np.zeros((2 * contact_count, 2 * pick.size))
    places[np.concatenate([pick, pick + contact_count]), np.arange(2 * pick.size)] = 1.0
    return places
