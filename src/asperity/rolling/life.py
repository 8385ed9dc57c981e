"""Fatigue life of the tracks, bodies and contacts of a drive that rolls."""

from __future__ import annotations

import numpy as np

from asperity.contact.crowned_line import CrownedLine
from asperity.contact.life_factor import fatigue_load_ratio, life_modification_factor, viscosity_ratio
from asperity.contact.roller_pairs import RollerPairs
from asperity.contact.rolling_fatigue import BEARING_STEEL, WEIBULL_SLOPE, line_contact_life
from asperity.drive.state.state import BodiesOfContacts, RollingSpeeds
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Array, Real

_MILLION = 1e6


class DriveLives(Module):
    """Lives at one survival, all in one unit.

    ``contact``: of both tracks of a contact of one branch, of a track that all branches share its part, shape
    (contacts, ...); ``body``: of one body of each kind, shape (bodies, ...); ``drive``: until its first body fails,
    shape (...).
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
    return xp.stack(xp.broadcast_arrays(driving, driven))


def sliced_track_lives(*, pairs: RollerPairs, lines: CrownedLine, peak_pressure: Array) -> Array:
    r"""The same of crowned contacts, each slice with its own pressure, shape (slices, contacts, ...) [Pa].

    .. math:: L = \Bigl(\sum_j L_j^{-e}\Bigr)^{-1/e}

    Stress cycles, shape (2, contacts, ...) [-]: the stressed volumes of the slices add, equations (B7) and (B8) of
    :doc:`/equations`.
    """
    lives = track_lives(pairs=pairs, half_width=lines.half_width, peak_pressure=peak_pressure)
    shortest = xp.min(lives, axis=1)
    rate = xp.sum(lines.length_share * (lives / shortest[:, None]) ** -WEIBULL_SLOPE, axis=1)
    return xp.asarray(shortest * rate ** (-1.0 / WEIBULL_SLOPE))


def film_factors(
    *,
    pairs: RollerPairs,
    lines: CrownedLine | None,
    peak_pressure: Array,
    film_ratio: Array,
    cleanliness: Real,
) -> Array:
    r"""Lives of the tracks of each contact with its oil film over those without, shape (contacts, ...) [-].

    .. math:: \Bigl(\sum_j s_j\,a_{ISO,j}^{-e}\Bigr)^{-1/e}, \qquad s_j = \frac{L_j^{-e}}{\sum_k L_k^{-e}}

    Parameters
    ----------
    pairs : RollerPairs
        The contacts.
    lines : CrownedLine or None
        Their slices j, each with its own factor; None where the load is even: that of the contact.
    peak_pressure : Array
        Of the slices, shape (slices, contacts, ...), or of the contacts [Pa].
    film_ratio : Array
        Smallest film of each contact over its roughness, shape (contacts, ...) [-].
    cleanliness : Real
        Contamination factor e_C of the oil [-].

    Returns
    -------
    Array
        Factors; nan where the film is not known, or too thin for a factor.

    References
    ----------
    ISO/TS 16281:2008 takes a_ISO of each slice; equation (F6) of :doc:`/equations`.
    """
    factor = life_modification_factor(
        viscosity_ratio=viscosity_ratio(film_ratio=film_ratio),
        cleanliness=cleanliness,
        fatigue_load_ratio=fatigue_load_ratio(peak_pressure=peak_pressure),
    )
    if lines is None:
        return factor
    lives = track_lives(pairs=pairs, half_width=lines.half_width, peak_pressure=peak_pressure)[0]
    damage = lines.length_share * (lives / xp.min(lives, axis=0)) ** -WEIBULL_SLOPE
    share = damage / xp.sum(damage, axis=0)
    return xp.asarray(xp.sum(share * factor**-WEIBULL_SLOPE, axis=0) ** (-1.0 / WEIBULL_SLOPE))  # (F6)


def cycle_rates(*, bodies: BodiesOfContacts, speeds: RollingSpeeds) -> Array:
    """Stress cycles of every track per time by one contact of one branch, shape (2, contacts, ...) [1/s]."""
    turns = speeds.body / (2.0 * xp.pi)
    return xp.stack([turns[xp.array(bodies.driving)], turns[xp.array(bodies.driven)]])


def drive_lives(*, bodies: BodiesOfContacts, tracks: Real, branches: Real) -> DriveLives:
    r"""Lives of contacts, bodies and drive from those of the tracks.

    .. math:: L = \Bigl(\sum_i L_i^{-e}\Bigr)^{-1/e}

    over the tracks of one body, of one contact of one branch, or of the drive. The contacts of one kind of all n
    branches roll on one track of a body that all share, and their damage adds up before:

    .. math:: \frac1L = \sum_b \frac1{L_b}

    Each of them has the n-th part of the rate at which that track fails: those of n equal branches are the same whether
    one stands for all, or all are listed.

    Parameters
    ----------
    bodies : BodiesOfContacts
        Bodies of the contacts.
    tracks : Real
        Lives of the tracks of one driving and one driven body of each contact, as if no other one rolled on them, all
        in one unit, shape (2, contacts, ...).
    branches : Real
        Number of branches n for which those of the contacts stand [-]; 1 where all are listed.

    Returns
    -------
    DriveLives
        In the unit of the tracks.

    References
    ----------
    G. Lundberg and A. Palmgren, Acta Polytechnica 7 (1947); equation (B8) of :doc:`/equations`.
    """
    # (B8), once for each track
    driving, driven = _of_one_branch(bodies, xp.asarray(tracks), branches) ** -WEIBULL_SLOPE
    body = xp.stack(
        [
            sum(
                side[k] * (branches if shared else 1.0)
                for side, places in ((driving, bodies.driving), (driven, bodies.driven))
                for k, member in enumerate(places)
                if member == b
            )
            for b, shared in enumerate(bodies.shared)
        ]
    )
    contact = driving + driven
    return DriveLives(
        contact=life_at_rate(contact),
        body=life_at_rate(body),
        drive=life_at_rate(branches * xp.sum(contact, axis=0)),
    )


def failure_shares(*, bodies: BodiesOfContacts, tracks: Real, branches: Real) -> Array:
    r"""Share of the failures of a drive that begin on each track, all branches together, shape (2, contacts, ...) [-].

    .. math:: s_i = \frac{L_i^{-e}}{\sum_k L_k^{-e}}

    From the lives of the tracks as for :func:`drive_lives`; nan where no track fails. The hazards of Weibull lives of
    one slope are in this ratio at any time. Equation (B8) of :doc:`/equations`.
    """
    lives = _of_one_branch(bodies, xp.asarray(tracks), branches)
    shortest = xp.min(lives, axis=(0, 1))
    rates = (lives / shortest) ** -WEIBULL_SLOPE
    return rates / xp.sum(rates, axis=(0, 1))


def _of_one_branch(bodies: BodiesOfContacts, tracks: Array, branches: Real) -> Array:
    """Lives of tracks, of one on a body that n branches share that at the n-th part of the rate at which it fails."""
    by_sector = (2, bodies.sectors, -1, *tracks.shape[2:])
    damage = xp.sum(1.0 / tracks.reshape(by_sector), axis=1, keepdims=True) * branches
    together = xp.broadcast_to(1.0 / damage, tracks.reshape(by_sector).shape).reshape(tracks.shape)
    all_branches = bodies.sectors * xp.asarray(branches, dtype=float)
    shared = np.array([[bodies.shared[b] for b in side] for side in (bodies.driving, bodies.driven)])
    shared = shared.reshape(*shared.shape, *(1,) * (tracks.ndim - 2))
    return xp.where(shared, together * all_branches ** (1.0 / WEIBULL_SLOPE), tracks)


def life_at_rate(rate: Array) -> Array:
    """Life of what fails at a rate L^(-e), shape of the rate; the rates of the parts of a system add up: (B8)."""
    endless = rate == 0.0
    return xp.where(endless, xp.inf, xp.where(endless, 1.0, rate) ** (-1.0 / WEIBULL_SLOPE))
