"""Places of the rollers of a planar drive at which all contacts just touch."""

from __future__ import annotations

import dataclasses

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.planar.layout import PlanarDrive, gaps, incidence

_STEPS = 30
_LONGEST_STEP = 0.2  # over the smallest radius


@eqx.filter_jit
def closed(drive: PlanarDrive) -> PlanarDrive:
    r"""Move the centres of a drive as little as possible until all contacts just touch.

    .. math:: A u = g

    Parameters
    ----------
    drive : PlanarDrive
        The drive, its centres near their places.

    Returns
    -------
    PlanarDrive
        The drive with closed gaps; where the radii do not allow that, gaps remain.

    Notes
    -----
    Newton's method with the smallest displacements u that close the gaps g at each step, or come closest to it.

    References
    ----------
    Equation (M1) of :doc:`/equations`.
    """
    floating = jnp.array(drive.floating, dtype=int)
    longest = _LONGEST_STEP * jnp.minimum(jnp.min(drive.first_radius), jnp.min(drive.second_radius))

    def nearer(_: int, centres: Array) -> Array:
        there = dataclasses.replace(drive, centres=centres)
        moved, *_rest = jnp.linalg.lstsq(incidence(there).approach, gaps(there))
        moved = moved * jnp.minimum(1.0, longest / jnp.maximum(jnp.max(jnp.abs(moved)), 1e-300))
        return centres.at[floating].add(moved.reshape(-1, 2))

    return dataclasses.replace(drive, centres=jax.lax.fori_loop(0, _STEPS, nearer, drive.centres))
