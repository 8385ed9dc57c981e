"""Creepage of rolling contacts under a traction, where their traction depends on their slip."""

from __future__ import annotations

import functools
from typing import NamedTuple

from asperity.contact.creep_capacity import CreepUnknowns
from asperity.contact.creep_law import (
    NEAR_CAPACITY,
    Capacity,
    LayerFactor,
    elastic_layers_factor,
    slip_forces,
    slip_size,
    stick_creepage,
)
from asperity.contact.film_traction import MixedContact, slip_at_warming
from asperity.engine.arrays import xp
from asperity.engine.control import while_loop
from asperity.engine.derivatives import value_and_slope, value_and_slopes, with_rule, without_slopes
from asperity.types import Array

#: Below this share of the capacity creepage is in proportion to the traction [-].
_LEAST_SHARE = 1e-9
#: Steps to a creepage, and the last change of its logarithm and of the film's warming [K], whose square is left.
_MOST_STEPS, _SMALL_STEP = 120, 1e-9
#: By what share of the traction its first order in an error of the warming may be off, over its square [1/K^2].
_SECOND_ORDER = 1e-3


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


class _Known(NamedTuple):
    """A contact, its traction [N] and its layer of asperities."""

    contact: MixedContact
    traction: Array
    layer: LayerFactor


def _of_slices(known: _Known, x: CreepUnknowns) -> CreepUnknowns:
    """Share of each slice in the known traction [-], and by how much its warming exceeds that of its heat [K]."""
    contact, creepage = known.contact, xp.exp(x.logarithm)
    slides = slip_at_warming(contact=contact, creepage=slip_size(contact, creepage), warming=x.warming)
    used = xp.minimum(known.traction / contact.total(slides.force), NEAR_CAPACITY)
    factor = elastic_layers_factor(contact=contact, layer_factor=known.layer(used), slides=slides)
    along, _ = slip_forces(contact, creepage, slides, factor)
    return CreepUnknowns(along / known.traction, x.warming - slides.heated)


class _Search(NamedTuple):
    """The unknowns, between which logarithms the creepage lies, the last steps, and how steep the traction is."""

    rounds: Array
    x: CreepUnknowns
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
        xp.asarray(0), CreepUnknowns(low, cold), low, high, 2.0 * (high - low), nothing + 1.0, nothing
    )
    found = while_loop(unfinished, functools.partial(_nearer, fixed), first)
    root = _known_root(found.x, known)
    return xp.where(found.step <= _SMALL_STEP, root.logarithm, xp.nan), found.steepness


@with_rule
def _known_root(root: CreepUnknowns, known: _Known) -> CreepUnknowns:
    """Unknowns that are known already, with the derivatives of the root that they are."""
    return root


@_known_root.defjvp
def _known_root_jvp(
    primals: tuple[CreepUnknowns, _Known], tangents: tuple[CreepUnknowns, _Known]
) -> tuple[CreepUnknowns, CreepUnknowns]:
    (root, known), (_, moved) = primals, tangents
    root = _known_root(root, known)  # itself, so that this may be differentiated in turn
    _, change = value_and_slope(lambda given: _of_slices(given, root), (known,), (moved,))
    _, slopes = _slopes(known, root)
    (by_logarithm, warms_by_it), (by_warming, warms) = slopes
    total = known.contact.total
    left = total(change.logarithm - by_warming * change.warming / warms)
    logarithm = -left / total(by_logarithm - by_warming * warms_by_it / warms)
    return root, CreepUnknowns(logarithm, -(change.warming + warms_by_it * logarithm) / warms)


def _slopes(known: _Known, x: CreepUnknowns) -> tuple[CreepUnknowns, list[CreepUnknowns]]:
    """Shares of the slices and misfits of their warmings, and their slopes by both unknowns."""
    one, none = xp.ones_like(x.logarithm), xp.zeros_like(x.logarithm)
    directions = [(CreepUnknowns(one, 0.0 * x.warming),), (CreepUnknowns(none, 1.0 + 0.0 * x.warming),)]
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
        x=CreepUnknowns(better, warming),
        low=low,
        high=high,
        before=before,
        step=abs(moved) + apart,
        steepness=steepness,
    )
