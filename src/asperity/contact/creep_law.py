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
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from asperity.contact.film_traction import EvenSlip, MixedContact, even_slip, slip_at_warming, width_integral
from asperity.contact.fluid import FilmBody
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import while_loop
from asperity.engine.derivatives import value_and_slopes, without_slopes
from asperity.implicit import implicit_root
from asperity.types import Array, Real

#: Creepage up to which a contact is said to carry its traction [-].
CREEP_LIMIT = 0.02

#: Creepages at which the largest traction is looked for, from this share of the limit on, and how often anew around it.
_GRID, _ROUNDS, _LOWEST = 32, 2, 1e-4
#: Share of the capacity above which the law is continued as a line, for iterates of a solver only.
NEAR_CAPACITY = 0.999
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

    ``traction`` [N]; ``even``: of rigid bodies [N]; ``elastic_factor``: of film and asperities as layers [-];
    ``warming`` of the film [K].
    """

    traction: Array
    even: Array
    elastic_factor: Array
    warming: Array


def film_yield(contact: MixedContact) -> Array:
    """Creepage that a film adds that carries all and does not slip, over that of the bodies, (1 − A)(f_F − 1) [-]."""
    body = FilmBody(
        thickness=contact.film_thickness,
        half_width=contact.half_width,
        peak_pressure=contact.peak_pressure,
        contact_modulus=contact.contact_modulus,
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
    return 1.0 + film * dry / (contact.film_share * dry + contact.asperity_share * film)


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
    slides = even_slip(contact=contact, creepage=creepage)
    factor = elastic_layers_factor(contact=contact, layer_factor=layer_factor)
    return _between_bounds(contact, creepage, slides, factor)


def _between_bounds(
    contact: MixedContact, creepage: Array, slides: EvenSlip, factor: Array
) -> CreepingContact:
    """Traction between the two bounds of the law, from that of rigid bodies and the factor of elastic layers."""
    felt = creepage / factor
    stick = 0.5 * math.pi * contact.half_width * contact.contact_modulus * contact.contact_length * felt
    used = xp.minimum(stick / slides.force, 2.0)
    upper = slides.force * used * (1.0 - 0.25 * used)
    bodies = 0.5 * contact.contact_modulus * felt
    lower = width_integral(contact, bodies * xp.arctan(slides.stress / bodies))
    exponent = xp.clip(slides.exponent, 0.0, 1.0)
    blend = 4.0 * exponent / (1.0 + 3.0 * exponent)
    traction = upper + blend * (lower - upper)
    return CreepingContact(traction, slides.force, factor, slides.heated)


class Capacity(NamedTuple):
    """Largest traction of contacts [N] and the creepage at which they reach it [-], shape (contacts, ...)."""

    traction: Array
    creepage: Array


def stick_creepage(*, contact: MixedContact, traction: Array, elastic_factor: Array) -> Array:
    r"""Creepage under a traction if nothing slipped, :math:`\xi = 2 T f/(\pi a E^* B)` [-]; the least there is."""
    stiffness = 0.5 * math.pi * contact.half_width * contact.contact_modulus * contact.contact_length
    return traction * elastic_factor / stiffness


def traction_capacity(
    *, contact: MixedContact, layer_factor: Array, creep_limit: Real = CREEP_LIMIT
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

    Returns
    -------
    Capacity
        The traction may fall beyond: heat thins the film. Derivatives at a fixed creepage, exact at the largest
        traction.

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    plain, dry = without_slopes((contact, xp.asarray(layer_factor)))
    limit = xp.log(without_slopes(xp.asarray(creep_limit))) + 0.0 * plain.film_share * plain.half_width
    share = np.linspace(0.0, 1.0, _GRID).reshape(-1, *(1 for _ in xp.shape(limit)))
    low, high = limit + math.log(_LOWEST), limit
    for _ in range(_ROUNDS):
        tried = high - (1.0 - share) * (high - low)
        found = traction_at_creepage(contact=_repeated(plain), creepage=xp.exp(tried), layer_factor=dry)
        best = xp.clip(xp.argmax(found.traction, axis=0), 1, _GRID - 2)[None]
        low, middle, high = (xp.take_along_axis(tried, best + k, axis=0)[0] for k in (-1, 0, 1))
        before, at, after = (xp.take_along_axis(found.traction, best + k, axis=0)[0] for k in (-1, 0, 1))
    # the parabola through the last three, which are evenly apart
    bend = before - 2.0 * at + after
    vertex = middle + 0.5 * (high - middle) * (before - after) / xp.where(bend < 0.0, bend, 1.0)
    rising = xp.where(after > before, high, low)
    creepage = xp.exp(xp.clip(xp.where(bend < 0.0, vertex, rising), low, high))
    at_it = traction_at_creepage(contact=contact, creepage=creepage, layer_factor=layer_factor)
    return Capacity(at_it.traction, creepage)


def _repeated(contact: MixedContact) -> MixedContact:
    """The contact with an axis before its others, for several creepages."""
    repeated: MixedContact = trees.map(lambda leaf: leaf[None] if xp.ndim(leaf) else leaf, contact)
    return repeated


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
    """Logarithm of the creepage [-] and warming of the film [K] of contacts under a traction."""

    logarithm: Array
    warming: Array


class _Known(NamedTuple):
    """A contact, its traction [N] and its layer of asperities."""

    contact: MixedContact
    traction: Array
    layer: LayerFactor


def _misfits(known: _Known, x: _Unknowns) -> _Unknowns:
    """By how much the traction exceeds the known one, relative to it [-], and the warming that of its heat [K]."""
    creepage = xp.exp(x.logarithm)
    slides = slip_at_warming(contact=known.contact, creepage=creepage, warming=x.warming)
    used = xp.minimum(known.traction / slides.force, NEAR_CAPACITY)
    factor = elastic_layers_factor(contact=known.contact, layer_factor=known.layer(used))
    traction = _between_bounds(known.contact, creepage, slides, factor).traction
    return _Unknowns(traction / known.traction - 1.0, x.warming - slides.heated)


def _root(
    contact: MixedContact, traction: Array, layer: LayerFactor, least: Array, most: Array
) -> tuple[Array, Array]:
    """Logarithm of the creepage under a traction, and the slope of the traction's logarithm over it without slopes."""
    known = _Known(contact, traction, layer)
    fixed, nothing = without_slopes(known), xp.zeros_like(least)

    def unfinished(state: _Search) -> Array:
        return (state.rounds < _MOST_STEPS) & xp.any(state.step > _SMALL_STEP)

    def improved(state: _Search) -> _Search:
        x = state.x
        value, slopes = _slopes(fixed, x)
        (_, by_logarithm), (by_warming, warms) = slopes
        colder = value.warming / warms
        misfit = value.logarithm - by_warming * colder  # at the warming that its heat makes, to first order
        steepness = _alone(slopes)
        told = abs(misfit) >= _SECOND_ORDER * colder**2
        low = xp.where(told & (misfit < 0.0), x.logarithm, state.low)
        high = xp.where(told & (misfit >= 0.0), x.logarithm, state.high)
        newton = x.logarithm - misfit / xp.where(steepness == 0.0, 1.0, steepness)
        inside = (newton >= low) & (newton <= high) & (steepness > 0.0)
        inside = inside & (abs(newton - x.logarithm) <= 0.5 * state.before)
        better = xp.where(told, xp.where(inside, newton, 0.5 * (low + high)), x.logarithm)
        better = xp.where(state.step > _SMALL_STEP, better, x.logarithm)
        moved = better - x.logarithm
        warming = xp.maximum(x.warming - colder - by_logarithm / warms * moved, 0.0)
        step = abs(moved) + abs(colder)
        before = xp.where(told, xp.maximum(abs(moved), _SMALL_STEP), state.before)
        return _Search(state.rounds + 1, _Unknowns(better, warming), low, high, before, step, steepness)

    low, high = without_slopes((least, most))
    start = _Unknowns(low, nothing)
    search = _Search(xp.asarray(0), start, low, high, 2.0 * (high - low), nothing + 1.0, nothing)
    found = while_loop(unfinished, improved, search)
    root = implicit_root(functools.partial(_misfits, known), found.x, lambda _, x: x, _solved)
    return xp.where(found.step <= _SMALL_STEP, root.logarithm, xp.nan), found.steepness


class _Search(NamedTuple):
    """The unknowns, between which logarithms the creepage lies, the last steps, and how steep the traction is."""

    rounds: Array
    x: _Unknowns
    low: Array
    high: Array
    before: Array
    step: Array
    steepness: Array


def _slopes(known: _Known, x: _Unknowns) -> tuple[_Unknowns, list[_Unknowns]]:
    """Misfits and their slopes by both unknowns."""
    one, none = xp.ones_like(x.logarithm), xp.zeros_like(x.logarithm)
    return value_and_slopes(
        functools.partial(_misfits, known), (x,), [(_Unknowns(one, none),), (_Unknowns(none, one),)]
    )


def _by_both(slopes: Sequence[_Unknowns], value: _Unknowns) -> _Unknowns:
    """The change of both unknowns that changes the misfits by a value."""
    (a, c), (b, d) = slopes
    size = a * d - b * c
    size = xp.where(size == 0.0, 1.0, size)
    return _Unknowns((d * value[0] - b * value[1]) / size, (a * value[1] - c * value[0]) / size)


def _alone(slopes: Sequence[_Unknowns]) -> Array:
    """Slope of the traction by the creepage, the warming going along."""
    (a, c), (b, d) = slopes
    return a - b * c / d


def _solved(linear: Callable[[_Unknowns], _Unknowns], right: _Unknowns) -> _Unknowns:
    """The unknowns of which a linear function, number by number, is given."""
    one, none = xp.ones_like(right.logarithm), xp.zeros_like(right.logarithm)
    return _by_both([linear(_Unknowns(one, none)), linear(_Unknowns(none, one))], right)
