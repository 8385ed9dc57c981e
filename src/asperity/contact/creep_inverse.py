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
from asperity.contact.film_traction import EvenSlip, MixedContact, slip_at_warming
from asperity.engine.arrays import xp
from asperity.engine.control import once, while_loop
from asperity.engine.derivatives import value_and_partial_slopes, value_and_slope, with_rule, without_slopes
from asperity.types import Array

#: Below this share of the capacity creepage is in proportion to the traction [-].
_LEAST_SHARE = 1e-9
#: Steps to a creepage, and the last change of its logarithm and of the film's warming [K], whose square is left.
_MOST_STEPS, _SMALL_STEP = 120, 1e-6
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
    # to first order nothing depends on where the law ends, as the tangents go on beyond
    most = without_slopes(capacity.traction)
    held = xp.minimum(xp.maximum(size, _LEAST_SHARE * most), NEAR_CAPACITY * most)
    logarithm, steepness = _root(_Known(contact, held, layer), most, without_slopes(capacity.creepage))
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
    factor = once(elastic_layers_factor(contact=contact, layer_factor=known.layer(used), slides=slides))
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


def _root(known: _Known, capacity: Array, limit: Array) -> tuple[Array, Array]:
    """Logarithm of the creepage under a traction, and the slope of the traction's logarithm over it without slopes.

    ``capacity``: the largest traction [N], at the creepage ``limit`` [-].
    """
    fixed = without_slopes(known)
    contact, traction = fixed.contact, fixed.traction
    nothing = xp.zeros_like(traction)
    # nothing slips where all sticks, and no contact creeps less
    low = xp.log(stick_creepage(contact=contact, traction=traction, elastic_factor=nothing + 1.0))
    high = xp.log(limit)
    cold = nothing + 0.0 * contact.film_thickness
    slides = slip_at_warming(contact=contact, creepage=slip_size(contact, limit), warming=cold)
    start = xp.log(_of_friction_alone(fixed, capacity, slides))

    def unfinished(state: _Search) -> Array:
        return (state.rounds < _MOST_STEPS) & xp.any(state.step > _SMALL_STEP)

    first = _Search(
        rounds=xp.asarray(0),
        x=CreepUnknowns(xp.clip(start, low, high), cold),
        low=low,
        high=high,
        before=2.0 * (high - low),
        step=nothing + 1.0,
        steepness=nothing,
    )
    found = while_loop(unfinished, functools.partial(_nearer, fixed), first)
    root = _known_root(found.x, known)
    return xp.where(found.step <= _SMALL_STEP, root.logarithm, xp.nan), found.steepness


def _of_friction_alone(known: _Known, capacity: Array, slides: EvenSlip) -> Array:
    """Creepage if the traction of rigid bodies were the largest at any creepage: Carter's over the layers [-].

    ``slides``: as the layers are taken, where rigid bodies slip most.
    """
    contact = known.contact
    layer = known.layer(NEAR_CAPACITY + xp.zeros_like(capacity))
    factor = elastic_layers_factor(contact=contact, layer_factor=layer, slides=slides)
    most = 2.0 * capacity * (1.0 - xp.sqrt(1.0 - known.traction / capacity))
    return stick_creepage(contact=contact, traction=most, elastic_factor=factor)


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
    return value_and_partial_slopes(lambda *unknowns: _of_slices(known, CreepUnknowns(*unknowns)), x)


def _nearer(known: _Known, state: _Search) -> _Search:
    """A step of Newton's in both unknowns, or half of the interval that is known to hold the root."""
    x, total = state.x, known.contact.total
    value, slopes = _slopes(known, x)
    (by_logarithm, warms_by_it), (by_warming, warms) = slopes
    colder = value.warming / warms
    # at the warming that the heat makes, to first order
    share = xp.maximum(total(value.logarithm - by_warming * colder), _LEAST_SHARE)
    misfit = xp.log(share)
    steepness = total(by_logarithm - by_warming * warms_by_it / warms) / share
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
