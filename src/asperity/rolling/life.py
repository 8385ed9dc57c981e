"""Fatigue life of the tracks, bodies and contacts of a drive that rolls."""

from __future__ import annotations

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.contact.crowned_line import CrownedLine
from asperity.contact.roller_pairs import RollerPairs
from asperity.contact.rolling_fatigue import BEARING_STEEL, WEIBULL_SLOPE, line_contact_life
from asperity.drive.state.state import BodiesOfContacts, RollingSpeeds
from asperity.types import Real

_MILLION = 1e6


class DriveLives(eqx.Module):
    """Lives at one survival, all in one unit.

    ``contact``: of both tracks of a contact in all branches, shape (contacts, ...); ``body``: of one body of each kind,
    shape (bodies, ...); ``drive``: until its first body fails, shape (...).
    """

    contact: Array
    body: Array
    drive: Array


def track_lives(*, pairs: RollerPairs, half_width: Real, peak_pressure: Real) -> Array:
    """Lives of the tracks of the driving and the driven body of each contact, at 90 % survival.

    Shape (2, contacts, ...) [-].
    """
    driving = _MILLION * line_contact_life(
        peak_pressure=peak_pressure,
        half_width=half_width,
        contact_length=pairs.contact_length,
        track_radius=pairs.radius_1,
        material_constant=BEARING_STEEL,
    )
    # the volume alone differs between the two bodies
    driven = driving * (pairs.radius_1 / pairs.radius_2) ** (1.0 / WEIBULL_SLOPE)
    return jnp.stack(jnp.broadcast_arrays(driving, driven))


def sliced_track_lives(*, pairs: RollerPairs, lines: CrownedLine, peak_pressure: Array) -> Array:
    r"""The same of crowned contacts, each slice with its own pressure, shape (slices, contacts, ...) [Pa].

    .. math:: L = \Bigl(\sum_j L_j^{-e}\Bigr)^{-1/e}

    Stress cycles, shape (2, contacts, ...) [-]: the stressed volumes of the slices add, equations (B7) and (B8) of
    :doc:`/equations`.
    """
    lives = track_lives(pairs=pairs, half_width=lines.half_width, peak_pressure=peak_pressure)
    shortest = jnp.min(lives, axis=1)
    rate = jnp.sum(lines.length_share * (lives / shortest[:, None]) ** -WEIBULL_SLOPE, axis=1)
    return jnp.asarray(shortest * rate ** (-1.0 / WEIBULL_SLOPE))


def cycle_rates(*, bodies: BodiesOfContacts, speeds: RollingSpeeds, planet_count: Real) -> Array:
    """Stress cycles of every track per time, shape (2, contacts, ...) [1/s]."""
    turns = speeds.body / (2.0 * jnp.pi)
    one = jnp.ones_like(turns[0])
    passes = jnp.stack([one * planet_count if shared else one for shared in bodies.shared])
    rates = turns * passes
    return jnp.stack([rates[jnp.array(bodies.driving)], rates[jnp.array(bodies.driven)]])


def drive_lives(*, bodies: BodiesOfContacts, tracks: Real, planet_count: Real) -> DriveLives:
    r"""Lives of contacts, bodies and drive from those of the tracks.

    .. math:: L = \Bigl(\sum_i L_i^{-e}\Bigr)^{-1/e}

    over the tracks of one body, of one kind of contact, or of all n branches. Where the contacts of all branches are
    listed, those of one kind roll on one track of a body that all share, and their damage adds up before:

    .. math:: \frac1L = \sum_b \frac1{L_b}

    Parameters
    ----------
    bodies : BodiesOfContacts
        Bodies of the contacts.
    tracks : Real
        Lives of the tracks of one driving and one driven body of each contact, all in one unit, shape
        (2, contacts, ...).
    planet_count : Real
        Number of branches n [-]: there are n of every body that is not shared.

    Returns
    -------
    DriveLives
        In the unit of the tracks.

    References
    ----------
    G. Lundberg and A. Palmgren, Acta Polytechnica 7 (1947); equation (B8) of :doc:`/equations`.
    """
    # (B8), once for each track
    driving, driven = _on_shared_tracks(bodies, jnp.asarray(tracks)) ** -WEIBULL_SLOPE
    body = jnp.stack(
        [
            sum(
                side[k]
                for side, places in ((driving, bodies.driving), (driven, bodies.driven))
                for k, member in enumerate(places)
                if member == b
            )
            for b in range(len(bodies.names))
        ]
    )
    first, second = _copies(bodies, planet_count, body.shape[1:])
    contact = driving * first + driven * second
    return DriveLives(
        contact=life_at_rate(contact), body=life_at_rate(body), drive=life_at_rate(jnp.sum(contact, axis=0))
    )


def failure_shares(*, bodies: BodiesOfContacts, tracks: Real, planet_count: Real) -> Array:
    r"""Share of the failures of a drive that begin on each track, all branches together, shape (2, contacts, ...) [-].

    .. math:: s_i = \frac{n_i L_i^{-e}}{\sum_k n_k L_k^{-e}}

    From the lives of the tracks as for :func:`drive_lives`; nan where no track fails. The hazards of Weibull lives of
    one slope are in this ratio at any time. Equation (B8) of :doc:`/equations`.
    """
    lives = _on_shared_tracks(bodies, jnp.asarray(tracks))
    shortest = jnp.min(lives, axis=(0, 1))
    rates = (lives / shortest) ** -WEIBULL_SLOPE * _copies(bodies, planet_count, lives.shape[2:])
    return rates / jnp.sum(rates, axis=(0, 1))


def _on_shared_tracks(bodies: BodiesOfContacts, tracks: Array) -> Array:
    """Lives of tracks, of which those on a shared body together fail as the one on which all branches roll."""
    if bodies.sectors == 1:
        return tracks
    by_sector = (2, bodies.sectors, -1, *tracks.shape[2:])
    sector_lives = tracks.reshape(by_sector)
    harmonic_lives = jnp.broadcast_to(
        1.0 / jnp.sum(1.0 / sector_lives, axis=1, keepdims=True), sector_lives.shape
    ).reshape(tracks.shape)
    shared = np.array([[bodies.shared[b] for b in side] for side in (bodies.driving, bodies.driven)])
    shared = shared.reshape(*shared.shape, *(1,) * (tracks.ndim - 2))
    return jnp.where(shared, harmonic_lives * bodies.sectors ** (1.0 / WEIBULL_SLOPE), tracks)


def _copies(bodies: BodiesOfContacts, planet_count: Real, shape: tuple[int, ...]) -> Array:
    """How many bodies of the drive have each track, shape (2, contacts, ...)."""
    count = jnp.broadcast_to(jnp.asarray(planet_count, dtype=float), shape)
    one = jnp.ones_like(count)
    times = jnp.stack([one if shared else count for shared in bodies.shared])
    return jnp.stack([times[jnp.array(bodies.driving)], times[jnp.array(bodies.driven)]])


def life_at_rate(rate: Array) -> Array:
    """Life of what fails at a rate L^(-e), shape of the rate; the rates of the parts of a system add up: (B8)."""
    endless = rate == 0.0
    return jnp.where(endless, jnp.inf, jnp.where(endless, 1.0, rate) ** (-1.0 / WEIBULL_SLOPE))
