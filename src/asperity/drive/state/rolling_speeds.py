"""Speeds of the bodies of a drive that rolls, creep included."""

from __future__ import annotations

from typing import NamedTuple

import equinox as eqx
from jax import Array


class BodiesOfContacts(NamedTuple):
    """Which bodies the contacts of one branch of a drive join.

    Parameters
    ----------
    names : tuple of str
        Names of the bodies, in the order of every body axis.
    shared : tuple of bool
        Whether a body is one for all branches.
    driving, driven : tuple of int
        Places of the two bodies of each contact in the names.
    sectors : int, optional
        How many branches the contacts are listed of, one branch after the other: those of one kind pass over the same
        track of a shared body.
    """

    names: tuple[str, ...]
    shared: tuple[bool, ...]
    driving: tuple[int, ...]
    driven: tuple[int, ...]
    sectors: int = 1


class RollingSpeeds(eqx.Module):
    """Speeds of a rolling drive relative to the carrier. SI units.

    Parameters
    ----------
    driving, driven : Array
        Speeds of the two surfaces of each contact, shape (contacts, ...) [m/s].
    body : Array
        Angular velocities of the bodies of one sector relative to the carrier, shape (bodies, ...) [rad/s]; positive.
    output : Array
        Angular velocity of the output relative to the ground, reduced by creep [rad/s]; positive.
    """

    driving: Array
    driven: Array
    body: Array
    output: Array

    @property
    def rolling(self) -> Array:
        """Rolling speed of each contact, the mean of both surfaces [m/s]."""
        return 0.5 * (self.driving + self.driven)
