r"""Creep of a rolling line contact whose traction depends on its slip: oil film, asperities, or both.

With :math:`z = \xi/f`, the creepage that the bodies feel beside elastic layers, and the even-slip traction
:math:`\tau(x)`, :math:`T_0` of :mod:`asperity.contact.film_traction`,

.. math::
    T_{up} = T_0\left(r - \frac{r^2}{4}\right) \;(r < 2), \; T_0 \;(r \ge 2), \qquad
    r = \frac{\pi a E^* B z}{2 T_0}

.. math::
    T_{low} = \frac{E^* B}{2}\,z \int \arctan\frac{2\tau}{E^* z}\,dx, \qquad
    T = (1 - v)\,T_{up} + v\,T_{low}, \quad v = \frac{4 n}{1 + 3 n}, \quad n = \frac{d \ln T_0}{d \ln \xi}

The first is Carter's solution with the friction of the present slip, the second is exact for a film whose traction is
in proportion to its slip.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from typing import NamedTuple

from asperity.contact.film_traction import EvenSlip, MixedContact, even_slip, slip_at_warming, width_mean
from asperity.contact.fluid import FilmBody
from asperity.contact.skew import turn_exponent
from asperity.engine.arrays import xp
from asperity.engine.control import cond, while_loop
from asperity.engine.derivatives import value_and_slope, value_and_slopes, with_rule, without_slopes
from asperity.types import Array, Real

#: Creepage up to which a contact is said to carry its traction [-].
CREEP_LIMIT = 0.02

#: First step back from the creepage limit to the largest traction, and the last, as logarithms; share of the traction
#: that may be missing, and where only tractions matter that a contact may reach before.
_FIRST_STEP, _FARTHEST, _AT_THE_TOP, _NEAR_THE_TOP = 0.5, -10.0, 1e-7, 2e-5
#: Share of the capacity above which the law is continued as a line, for iterates of a solver only.
NEAR_CAPACITY = 0.999
#: Share of the traction at the creepage limit below which the largest does not matter [-].
_WELL_BELOW = 0.99
#: Repetitions with which the creepage is found at which all of a dry contact would slip.
_TO_THE_KNEE = 1
#: Below this share of the capacity creepage is in proportion to the traction [-].
_LEAST_SHARE = 1e-9
#: Steps to a creepage, and the last change of its logarithm and of the film's warming [K], whose square is left.
_MOST_STEPS, _SMALL_STEP = 120, 1e-9
#: By what share of the traction its first order in an error of the warming may be off, over its square [1/K^2].
_SECOND_ORDER = 1e-3

#: Creepage factor of the asperities as a layer without film, over the share of the traction that is used.
LayerFactor = Callable[[Array], Array]


class CreepingContact(NamedTuple):
    """Traction of contacts at a creepage, shape (contacts, ...).

    ``traction`` [N], and ``lateral`` traction of skewed axes [N]; ``even``: of rigid bodies [N]; ``elastic_factor``: of
    film and asperities as layers [-]; ``warming`` of the film [K].
    """

    traction: Array
    lateral: Array
    even: Array
    elastic_factor: Array
    warming: Array


def film_yield(contact: MixedContact) -> Array:
    """Creepage that a film adds that carries all and does not slip, over that of the bodies.

    Parameters
    ----------
    contact : MixedContact
        The contact.

    Returns
    -------
    Array
        (1 − A)(f_F − 1), shape (contacts, ...) [-].

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    body = FilmBody(
        thickness=contact.film_thickness,
        half_width=contact.half_width,
        peak_pressure=contact.peak_pressure,
        contact_modulus=contact.contact_modulus,
        oil_temperature=contact.oil_temperature,
        rolling_speed=contact.rolling_speed,
    )
    return contact.traction.elastic_yield(body)


def elastic_layers_factor(*, contact: MixedContact, layer_factor: Array) -> Array:
    r"""Creepage of film and asperities side by side over that of the bodies alone.

    .. math:: f = 1 + \left[\frac1{f_F - 1} + \frac A{f_D - 1}\right]^{-1}, \qquad
              f_F - 1 = \frac\pi4\frac{E^* h}{a G (1 - A)}

    Parameters
    ----------
    contact : MixedContact
        The contact.
    layer_factor : Array
        f_D, factor of the asperities alone, shape (contacts, ...) [-].

    Returns
    -------
    Array
        Factor, shape (contacts, ...) [-].

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    film, dry = film_yield(contact), layer_factor - 1.0
    # springs side by side; a film of no thickness or asperities that do not yield leave no compliance
    stiff = contact.film_share * dry + contact.asperity_share * film
    both = stiff > 0.0
    # a film that carries all does not ask for the asperities
    alone = xp.where(contact.asperity_share > 0.0, 0.0, film)
    return 1.0 + xp.where(both, film * dry / xp.where(both, stiff, 1.0), alone)


def traction_at_creepage(*, contact: MixedContact, creepage: Array, layer_factor: Array) -> CreepingContact:
    r"""Traction of rolling contacts at a creepage.

    Parameters
    ----------
    contact : MixedContact
        The contacts.
    creepage : Array
        xi, positive, shape (contacts, ...) [-].
    layer_factor : Array
        Creepage factor f_D of the asperities alone [-].

    Returns
    -------
    CreepingContact
        Their traction, not above the stick line, that of rigid bodies, or friction and limiting stress.

    Notes
    -----
    Exact for dry contacts (Carter), for a film that is elastic up to its limit, for a film in proportion to slip of any
    viscosity over the width, and for rigid bodies. Against boundary elements on 600 random contacts with the same shear
    stress: 3.1 % root mean square, 95 % within 6.5 %.

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; equation (F5) of :doc:`/equations`.
    """
    size = slip_size(contact, creepage)
    slides = even_slip(contact=contact, creepage=size)
    factor = elastic_layers_factor(contact=contact, layer_factor=layer_factor)
    along, across = _forces(contact, creepage, slides, factor)
    return CreepingContact(
        traction=contact.total(along),
        lateral=contact.total(across),
        even=contact.total(slides.force),
        elastic_factor=factor,
        warming=slides.heated,
    )


def slip_size(contact: MixedContact, creepage: Array) -> Array:
    r"""Size of the creepages along and across, :math:`\sqrt{\xi^2 + \xi_y^2}`.

    Parameters
    ----------
    contact : MixedContact
        The contact, whose lateral creepage is over how much further the bodies give way that way.
    creepage : Array
        xi along, shape (contacts, ...) [-].

    Returns
    -------
    Array
        Size, of the same shape [-].

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    if contact.lateral_creepage is None:
        return creepage
    return xp.sqrt(creepage**2 + contact.lateral_creepage**2)


def _forces(contact: MixedContact, creepage: Array, slides: EvenSlip, factor: Array) -> tuple[Array, Array]:
    """Tractions along and across of slices, between the two bounds of the law [N].

    ``slides``, ``factor``: traction of rigid bodies and factor of elastic layers, at the size of the creepages. The
    direction is that of dry contacts, :func:`asperity.contact.skew.skewed_slip_ratios`.
    """
    size = slip_size(contact, creepage)
    bodies = 0.5 * contact.contact_modulus * size / factor
    slid = 0.25 * math.pi * bodies / slides.mean  # creepage over that at which all would slip
    used = xp.minimum(slid, 1.0)
    upper = slides.mean * used * (2.0 - used)
    lower = width_mean(bodies * xp.arctan(slides.stress / bodies))
    exponent = xp.clip(slides.exponent, 0.0, 1.0)
    blend = 4.0 * exponent / (1.0 + 3.0 * exponent)
    area = 2.0 * contact.half_width * contact.contact_length
    traction = area * (upper + blend * (lower - upper))
    if contact.lateral_creepage is None:
        return traction, 0.0 * traction
    turned = contact.lateral_creepage * contact.lateral_ratio ** turn_exponent(slid)
    length = xp.sqrt(creepage**2 + turned**2)
    return traction * creepage / length, traction * turned / length


class Capacity(NamedTuple):
    """Largest traction of contacts [N], the creepage at which they reach it, and up to which it counts [-]."""

    traction: Array
    creepage: Array
    limit: Real


def stick_creepage(*, contact: MixedContact, traction: Array, elastic_factor: Array) -> Array:
    r"""Creepage under a traction if nothing slipped, :math:`\xi = 2 T f/(\pi a E^* B)`; the least there is.

    Parameters
    ----------
    contact : MixedContact
        The contact.
    traction : Array
        T, shape (contacts, ...) [N].
    elastic_factor : Array
        f of :func:`elastic_layers_factor` [-].

    Returns
    -------
    Array
        Creepage, shape (contacts, ...) [-].

    References
    ----------
    Carter's slope, stretched by the layers; equation (F5) of :doc:`/equations`.
    """
    area = contact.half_width * contact.contact_length * xp.ones_like(contact.film_thickness)
    stiffness = 0.5 * math.pi * contact.total(area * contact.contact_modulus / elastic_factor)
    return traction / stiffness


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
        traction.

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
    climb = functools.partial(_climb, plain, dry)
    at_limit = climb(limit, 0.0)

    def largest() -> Capacity:
        missing = _AT_THE_TOP if sought is None else _NEAR_THE_TOP
        creepage = xp.exp(_top(climb, limit, at_limit, missing))
        found = traction_at_creepage(contact=contact, creepage=creepage, layer_factor=layer_factor)
        return Capacity(found.traction, creepage, creep_limit + nothing)

    def at_warming(logarithm: Array, warming: Array) -> Capacity:
        """The traction at a creepage, its film as warm under any load."""
        creepage = xp.exp(logarithm)
        slides = slip_at_warming(contact=contact, creepage=slip_size(contact, creepage), warming=warming)
        factor = elastic_layers_factor(contact=contact, layer_factor=layer_factor)
        along, _ = _forces(contact, creepage, slides, factor)
        return Capacity(contact.total(along), creepage, creep_limit + nothing)

    def last() -> Capacity:
        return at_warming(limit, at_limit.warming)

    def at_knee() -> Capacity:
        factor = elastic_layers_factor(contact=plain, layer_factor=dry)
        even, warming, before = at_limit.even, at_limit.warming, limit
        for _ in range(_TO_THE_KNEE):
            stick = stick_creepage(contact=plain, traction=2.0 * even, elastic_factor=factor)
            knee = xp.minimum(xp.log(stick), limit)
            size = slip_size(plain, xp.exp(knee))
            slides = even_slip(contact=plain, creepage=size, guess=warming * xp.exp(knee - before))
            even, warming, before = plain.total(slides.force), slides.heated, knee
        return at_warming(before, warming)

    if sought is None:
        return largest()
    if roughly:
        return cond(xp.any(at_limit.slope < 0.0), at_knee, last)
    reached = xp.abs(without_slopes(sought)) > _WELL_BELOW * at_limit.traction
    return cond(xp.any(reached & (at_limit.slope < 0.0)), largest, last)


class _Climb(NamedTuple):
    """Traction, its slope over the logarithm of the creepage, that of rigid bodies [N], and the film's warming [K]."""

    traction: Array
    slope: Array
    even: Array
    warming: Array


def _climb(contact: MixedContact, layer_factor: Array, logarithm: Array, guess: Array | float) -> _Climb:
    """The traction at a creepage and how it rises there, the film as warm as its heat makes it."""
    size = slip_size(contact, xp.exp(logarithm))
    slides = even_slip(contact=contact, creepage=size, guess=guess)
    warming = slides.heated
    factor = elastic_layers_factor(contact=contact, layer_factor=layer_factor)

    def of_slices(x: _Unknowns) -> _Unknowns:
        creepage = xp.exp(x.logarithm)
        slides = slip_at_warming(contact=contact, creepage=slip_size(contact, creepage), warming=x.warming)
        along, _ = _forces(contact, creepage, slides, factor)
        return _Unknowns(along, x.warming - slides.heated)

    one = xp.ones_like(logarithm)
    directions = [(_Unknowns(one, 0.0 * warming),), (_Unknowns(0.0 * one, 1.0 + 0.0 * warming),)]
    value, slopes = value_and_slopes(of_slices, (_Unknowns(logarithm, warming),), directions)
    (by_logarithm, warms_by_it), (by_warming, warms) = slopes
    slope = contact.total(by_logarithm - by_warming * warms_by_it / warms)
    return _Climb(contact.total(value.logarithm), slope, contact.total(slides.force), warming)


class _Top(NamedTuple):
    """Logarithms of creepages before and behind the largest traction, the cube roots of its slopes, the last one tried.

    ``rises`` is 0 while no creepage before it is known. ``left``: share of the traction that may be missing [-].
    """

    rounds: Array
    low: Array
    high: Array
    rises: Array
    falls: Array
    tried: Array
    warming: Array
    left: Array


def _top(
    climb: Callable[[Array, Array | float], _Climb], limit: Array, at_limit: _Climb, missing: float
) -> Array:
    """Logarithm of the creepage of the largest traction, but for a missing share, or the limit if it rises up to there.

    Back from the limit by doubled steps until the traction rises, then by chords of the cube roots of the slopes, which
    are of unlike size where all of a contact begins to slip; an end that stays counts half (rule of the Illinois).
    """

    def unfinished(state: _Top) -> Array:
        return (state.rounds < _MOST_STEPS) & xp.any(state.left > missing)

    def improved(state: _Top) -> _Top:
        known = state.rises > 0.0
        chord = (state.low * state.falls - state.high * state.rises) / (state.falls - state.rises)
        back = limit - _FIRST_STEP * 2.0**state.rounds
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
            warming=at.warming,
            left=xp.where(going, left, state.left),
        )

    falling = at_limit.slope < 0.0
    first = _Top(
        rounds=xp.asarray(0.0),  # a float, which 2 is raised to
        low=limit - 1.0,
        high=limit,
        rises=0.0 * limit,
        falls=xp.where(falling, xp.cbrt(at_limit.slope), -1.0),
        tried=limit,
        warming=at_limit.warming,
        left=xp.where(falling, abs(at_limit.slope) / at_limit.traction, 0.0),
    )
    return while_loop(unfinished, improved, first).tried


def creepage_at_traction(
    *, contact: MixedContact, traction: Array, layer: LayerFactor, capacity: Capacity
) -> Array:
    """Creepage of rolling contacts under tractions below their capacity; inverse of the rising branch of the law.

    Parameters
    ----------
    contact : MixedContact
        The contacts.
    traction : Array
        T of either sign, shape (contacts, ...) [N].
    layer : callable
        Creepage factor f_D of the asperities alone over the traction by that of rigid bodies, T/T_0; a module.
    capacity : Capacity
        Of :func:`traction_capacity`.

    Returns
    -------
    Array
        Creepage, shape (contacts, ...) [-], odd in the traction; above 99.9 % of the capacity the tangent is
        continued, for iterates of a solver only.

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    size = xp.abs(traction)
    near = NEAR_CAPACITY * capacity.traction
    held = xp.minimum(xp.maximum(size, _LEAST_SHARE * capacity.traction), near)
    # nothing slips where all sticks, and no contact creeps less
    least = xp.log(stick_creepage(contact=contact, traction=held, elastic_factor=xp.ones_like(held)))
    most = xp.log(capacity.creepage)
    logarithm, steepness = _root(contact, held, layer, least, most)
    creepage = xp.exp(logarithm)
    beyond = without_slopes(creepage / (held * steepness)) * (size - held)
    return xp.where(
        size < held, traction / held * creepage, xp.sign(traction) * (creepage + xp.maximum(beyond, 0.0))
    )


class _Unknowns(NamedTuple):
    """Logarithm of the creepage of contacts under a traction [-], and warming of the film, of their slices [K]."""

    logarithm: Array
    warming: Array


class _Known(NamedTuple):
    """A contact, its traction [N] and its layer of asperities."""

    contact: MixedContact
    traction: Array
    layer: LayerFactor


def _of_slices(known: _Known, x: _Unknowns) -> _Unknowns:
    """Share of each slice in the known traction [-], and by how much its warming exceeds that of its heat [K]."""
    contact, creepage = known.contact, xp.exp(x.logarithm)
    slides = slip_at_warming(contact=contact, creepage=slip_size(contact, creepage), warming=x.warming)
    used = xp.minimum(known.traction / contact.total(slides.force), NEAR_CAPACITY)
    factor = elastic_layers_factor(contact=contact, layer_factor=known.layer(used))
    along, _ = _forces(contact, creepage, slides, factor)
    return _Unknowns(along / known.traction, x.warming - slides.heated)


class _Search(NamedTuple):
    """The unknowns, between which logarithms the creepage lies, the last steps, and how steep the traction is."""

    rounds: Array
    x: _Unknowns
    low: Array
    high: Array
    before: Array
    step: Array
    steepness: Array


def _root(
    contact: MixedContact, traction: Array, layer: LayerFactor, least: Array, most: Array
) -> tuple[Array, Array]:
    """Logarithm of the creepage under a traction, and the slope of the traction's logarithm over it without slopes."""
    known = _Known(contact, traction, layer)
    fixed, low, high = without_slopes((known, least, most))
    nothing = xp.zeros_like(low)
    cold = nothing + 0.0 * fixed.contact.film_thickness

    def unfinished(state: _Search) -> Array:
        return (state.rounds < _MOST_STEPS) & xp.any(state.step > _SMALL_STEP)

    first = _Search(
        xp.asarray(0), _Unknowns(low, cold), low, high, 2.0 * (high - low), nothing + 1.0, nothing
    )
    found = while_loop(unfinished, functools.partial(_nearer, fixed), first)
    root = _known_root(found.x, known)
    return xp.where(found.step <= _SMALL_STEP, root.logarithm, xp.nan), found.steepness


@with_rule
def _known_root(root: _Unknowns, known: _Known) -> _Unknowns:
    """Unknowns that are known already, with the derivatives of the root that they are."""
    return root


@_known_root.defjvp
def _known_root_jvp(
    primals: tuple[_Unknowns, _Known], tangents: tuple[_Unknowns, _Known]
) -> tuple[_Unknowns, _Unknowns]:
    (root, known), (_, moved) = primals, tangents
    root = _known_root(root, known)  # itself, so that this may be differentiated in turn
    _, change = value_and_slope(lambda given: _of_slices(given, root), (known,), (moved,))
    _, slopes = _slopes(known, root)
    (by_logarithm, warms_by_it), (by_warming, warms) = slopes
    total = known.contact.total
    left = total(change.logarithm - by_warming * change.warming / warms)
    logarithm = -left / total(by_logarithm - by_warming * warms_by_it / warms)
    return root, _Unknowns(logarithm, -(change.warming + warms_by_it * logarithm) / warms)


def _slopes(known: _Known, x: _Unknowns) -> tuple[_Unknowns, list[_Unknowns]]:
    """Shares of the slices and misfits of their warmings, and their slopes by both unknowns."""
    one, none = xp.ones_like(x.logarithm), xp.zeros_like(x.logarithm)
    directions = [(_Unknowns(one, 0.0 * x.warming),), (_Unknowns(none, 1.0 + 0.0 * x.warming),)]
    return value_and_slopes(functools.partial(_of_slices, known), (x,), directions)


def _nearer(known: _Known, state: _Search) -> _Search:
    """A step of Newton's in both unknowns, or half of the interval that is known to hold the root."""
    x, total = state.x, known.contact.total
    value, slopes = _slopes(known, x)
    (by_logarithm, warms_by_it), (by_warming, warms) = slopes
    colder = value.warming / warms
    # at the warming that the heat makes, to first order
    misfit = total(value.logarithm - by_warming * colder) - 1.0
    steepness = total(by_logarithm - by_warming * warms_by_it / warms)
    apart = total(abs(colder))
    told = abs(misfit) >= _SECOND_ORDER * apart**2
    low = xp.where(told & (misfit < 0.0), x.logarithm, state.low)
    high = xp.where(told & (misfit >= 0.0), x.logarithm, state.high)
    newton = x.logarithm - misfit / xp.where(steepness == 0.0, 1.0, steepness)
    inside = (newton >= low) & (newton <= high) & (steepness > 0.0)
    inside = inside & (abs(newton - x.logarithm) <= 0.5 * state.before)
    better = xp.where(told, xp.where(inside, newton, 0.5 * (low + high)), x.logarithm)
    better = xp.where(state.step > _SMALL_STEP, better, x.logarithm)
    moved = better - x.logarithm
    warming = xp.maximum(x.warming - colder - warms_by_it / warms * moved, 0.0)
    before = xp.where(told, xp.maximum(abs(moved), _SMALL_STEP), state.before)
    return _Search(
        rounds=state.rounds + 1,
        x=_Unknowns(better, warming),
        low=low,
        high=high,
        before=before,
        step=abs(moved) + apart,
        steepness=steepness,
    )
