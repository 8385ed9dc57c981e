"""The largest traction of rolling contacts whose traction depends on their slip."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import NamedTuple

from asperity.contact.creep_law import (
    CREEP_LIMIT,
    Capacity,
    elastic_layers_factor,
    slip_forces,
    slip_size,
    stick_creepage,
    traction_at_creepage,
)
from asperity.contact.film_traction import MixedContact, even_slip, slip_at_warming
from asperity.engine.arrays import xp
from asperity.engine.control import while_loop
from asperity.engine.derivatives import value_and_partial_slopes, without_slopes
from asperity.types import Array, Real

#: First step back from the creepage limit to the largest traction, and the last, as logarithms; share of the traction
#: that may be missing, and where only tractions matter that a contact may reach before.
_FIRST_STEP, _FARTHEST, _AT_THE_TOP, _NEAR_THE_TOP = 0.5, -10.0, 1e-7, 2e-5
#: Share of the traction at the creepage limit below which the largest does not matter [-].
_WELL_BELOW = 0.99
_MOST_STEPS = 120


class CreepUnknowns(NamedTuple):
    """Logarithm of the creepage of contacts under a traction [-], and warming of the film, of their slices [K]."""

    logarithm: Array
    warming: Array


def traction_capacity(
    *,
    contact: MixedContact,
    layer_factor: Array,
    creep_limit: Real = CREEP_LIMIT,
    sought: Array | None = None,
    roughly: bool = False,
) -> Capacity:
    r"""Largest traction that contacts reach up to a creepage, :math:`\max_{\xi \le \xi_{lim}} T(\xi)`.

    Parameters
    ----------
    contact : MixedContact
        The contacts.
    layer_factor : Array
        Creepage factor of the asperities alone near gross slip [-].
    creep_limit : Real, optional
        Largest creepage that counts [-].
    sought : Array or None, optional
        Tractions of which only those matter that a contact reaches before [N]: where the traction still rises at the
        limit, or all of them stay below 99 % of it there, that is returned, and else the largest but for 2e-5. None to
        find it in any case.
    roughly : bool, optional
        Whether, where the traction falls at the limit, that at which all of a dry contact would slip will do: less by a
        thousandth or so.

    Returns
    -------
    Capacity
        The traction may fall beyond: heat thins the film. Derivatives at a fixed creepage, exact at the largest
        traction; none with ``sought``.

    Notes
    -----
    The search goes back from the limit and stays there where the traction rises. Of 8000 random contacts one, with an
    oil whose limiting stress hardly depends on the temperature, had a traction 0.4 % larger at a lower creepage.

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    plain, dry = without_slopes((contact, xp.asarray(layer_factor)))
    nothing = plain.total(0.0 * plain.film_share * plain.half_width)
    limit = xp.log(without_slopes(xp.asarray(creep_limit))) + nothing
    climb, cold = functools.partial(_climb, plain, dry), nothing + 0.0 * plain.film_thickness
    if sought is None:
        creepage = xp.exp(_top(climb, limit, cold, nothing == 0.0, _AT_THE_TOP).tried)
        found = traction_at_creepage(contact=contact, creepage=creepage, layer_factor=layer_factor)
        return Capacity(found.traction, creepage, creep_limit + nothing)
    at_limit, even, warming, factor = _evenly(plain, dry, limit, 0.0)
    reached = xp.abs(without_slopes(sought)) > _WELL_BELOW * at_limit
    if roughly:
        knee = xp.log(stick_creepage(contact=plain, traction=2.0 * even, elastic_factor=factor))
        knee = xp.where(reached, xp.minimum(knee, limit), limit)
        at_knee, *_ = _evenly(plain, dry, knee, warming * xp.exp(knee - limit))
        best = at_knee > at_limit
        knee, at_knee = xp.where(best, knee, limit), xp.where(best, at_knee, at_limit)
        return Capacity(at_knee, xp.exp(knee), creep_limit + nothing)
    top = _top(climb, limit, warming, reached, _NEAR_THE_TOP)
    return Capacity(xp.where(reached, top.traction, at_limit), xp.exp(top.tried), creep_limit + nothing)


def _evenly(
    contact: MixedContact, layer_factor: Array, logarithm: Array, guess: Array | float
) -> tuple[Array, Array, Array, Array]:
    """Tractions at a creepage and of rigid bodies [N], warming of the film, sought from a guess [K], and factor f."""
    creepage = xp.exp(logarithm)
    slides = even_slip(contact=contact, creepage=slip_size(contact, creepage), guess=guess)
    factor = elastic_layers_factor(contact=contact, layer_factor=layer_factor, slides=slides)
    along, _ = slip_forces(contact, creepage, slides, factor)
    return contact.total(along), contact.total(slides.force), slides.heated, factor


class _Climb(NamedTuple):
    """Traction, its slope over the logarithm of the creepage [N], and the film's warming [K]."""

    traction: Array
    slope: Array
    warming: Array


def _climb(contact: MixedContact, layer_factor: Array, logarithm: Array, guess: Array | float) -> _Climb:
    """The traction at a creepage and how it rises there, the film as warm as its heat makes it."""
    size = slip_size(contact, xp.exp(logarithm))
    slides = even_slip(contact=contact, creepage=size, guess=guess)
    warming = slides.heated

    def of_slices(logarithm: Array, warming: Array) -> CreepUnknowns:
        creepage = xp.exp(logarithm)
        slides = slip_at_warming(contact=contact, creepage=slip_size(contact, creepage), warming=warming)
        factor = elastic_layers_factor(contact=contact, layer_factor=layer_factor, slides=slides)
        along, _ = slip_forces(contact, creepage, slides, factor)
        return CreepUnknowns(along, warming - slides.heated)

    value, slopes = value_and_partial_slopes(of_slices, (logarithm, warming))
    (by_logarithm, warms_by_it), (by_warming, warms) = slopes
    slope = contact.total(by_logarithm - by_warming * warms_by_it / warms)
    return _Climb(contact.total(value.logarithm), slope, warming)


class _Top(NamedTuple):
    """Logarithms of creepages before and behind the largest traction, the cube roots of its slopes, the last one tried.

    ``rises`` is 0 while no creepage before it is known. ``traction`` there [N], and ``warming`` [K]. ``left``: share of
    the traction that may be missing [-].
    """

    rounds: Array
    low: Array
    high: Array
    rises: Array
    falls: Array
    tried: Array
    traction: Array
    warming: Array
    left: Array


def _top(
    climb: Callable[[Array, Array | float], _Climb],
    limit: Array,
    warming: Array,
    wanted: Array,
    missing: float,
) -> _Top:
    """The largest traction where it is wanted, but for a missing share, or that at the limit if it rises up to there.

    From the limit back by doubled steps until the traction rises, then by chords of the cube roots of the slopes, which
    are of unlike size where all of a contact begins to slip; an end that stays counts half (rule of the Illinois).
    """

    def unfinished(state: _Top) -> Array:
        return (state.rounds < _MOST_STEPS) & xp.any(state.left > missing)

    def improved(state: _Top) -> _Top:
        known = state.rises > 0.0
        chord = (state.low * state.falls - state.high * state.rises) / (state.falls - state.rises)
        back = xp.where(state.rounds > 0.0, limit - 0.5 * _FIRST_STEP * 2.0**state.rounds, limit)
        going = state.left > missing
        tried = xp.where(going, xp.where(known, chord, back), state.tried)
        at = climb(tried, state.warming * xp.exp(tried - state.tried))
        up, root = at.slope > 0.0, xp.cbrt(at.slope)
        low, high = xp.where(up, tried, state.low), xp.where(up, state.high, tried)
        bracketed = up | known
        # the slope falls on from here: no more is gained towards the other end
        left = xp.where(bracketed, abs(at.slope) * (high - low) / at.traction, 1.0)
        left = xp.where(~bracketed & (back < limit + _FARTHEST), 0.0, left)
        return _Top(
            rounds=state.rounds + 1,
            low=xp.where(going, low, state.low),
            high=xp.where(going, high, state.high),
            rises=xp.where(going, xp.where(up, root, 0.5 * state.rises), state.rises),
            falls=xp.where(going, xp.where(up, 0.5 * state.falls, root), state.falls),
            tried=tried,
            traction=at.traction,
            warming=at.warming,
            left=xp.where(going, left, state.left),
        )

    first = _Top(
        rounds=xp.asarray(0.0),  # a float, which 2 is raised to
        low=limit - 1.0,
        high=limit,
        rises=0.0 * limit,
        falls=0.0 * limit - 1.0,
        tried=limit,
        traction=0.0 * limit,
        warming=warming,
        left=xp.where(wanted, 1.0, 0.0),
    )
    return while_loop(unfinished, improved, first)
