"""The bodies of a joint by exact plane elasticity: the springs of its assembly and their coupling."""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
from jax import Array

from asperity.joint.contacts import JointContacts, LoadedContacts

#: Half-width over effective radius that stands for an open contact, whose springs are left out.
_CLOSED = 1e-3


class AssemblySprings(NamedTuple):
    """Springs of the contacts in the assembly.

    Parameters
    ----------
    normal_stiffness, tangential_stiffness : Array
        Incremental, asperities and bodies in series, shape (contacts, ...) [N/m]; 0 where a contact is open or slips.
    coupling : Array or None
        Compliances between the contacts, shape (2 contacts, 2 contacts, ...) [m/N]; None without.
    bodies : Array or None
        Compliance of the bodies, without asperities, of the same shape [m/N], at the half-widths :attr:`half_width`
        [m]; None without.
    """

    normal_stiffness: Array
    tangential_stiffness: Array
    coupling: Array | None
    bodies: Array | None = None
    half_width: Array | None = None


def widths_of_bodies(*, contacts: JointContacts, loaded: LoadedContacts) -> tuple[Array, Array]:
    r"""Half-widths at which the compliance of exact bodies is taken, shape (contacts, ...) [m]."""
    touching = jnp.asarray(loaded.interfaces.normal) > 0.0
    sticking = jnp.asarray(loaded.interfaces.tangential) > 0.0
    width = jnp.where(touching, loaded.half_width, _CLOSED * contacts.pairs.effective_radius)
    return width, width * jnp.sqrt(jnp.where(sticking, 1.0 - loaded.traction, 1.0))


def springs_of_compliance(*, compliance: Array, half_width: Array, loaded: LoadedContacts) -> AssemblySprings:
    """Springs of the contacts from the compliance of their bodies, the asperities in series."""
    interfaces = loaded.interfaces
    touching = jnp.asarray(interfaces.normal) > 0.0
    sticking = jnp.asarray(interfaces.tangential) > 0.0
    acts = jnp.concatenate([touching, sticking])
    asperities = jnp.concatenate(
        [
            jnp.broadcast_to(interfaces.asperity_normal, touching.shape),
            jnp.broadcast_to(interfaces.asperity_tangential, sticking.shape),
        ]
    )
    own = jnp.einsum("ii...->i...", compliance)
    if loaded.crown is not None:
        own = own + jnp.concatenate(jnp.broadcast_arrays(*loaded.crown))
    stiffness = jnp.where(acts, 1.0 / (own + 1.0 / jnp.where(acts, asperities, 1.0)), 0.0)
    others = 1.0 - jnp.eye(acts.shape[0]).reshape((acts.shape[0],) * 2 + (1,) * (acts.ndim - 1))
    coupling = jnp.where(acts[:, None] & acts[None], others * compliance, 0.0)
    half = touching.shape[0]
    return AssemblySprings(stiffness[:half], stiffness[half:], coupling, compliance, half_width)
