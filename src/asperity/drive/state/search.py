"""States of drives by Newton's method, and which of their contacts slide as a whole."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from asperity.drive.state.equations import (
    ROLLING,
    STANDING,
    Machine,
    Responses,
    Task,
    Unknowns,
    contact_forces,
    contact_interference,
    contact_responses,
    known_kind,
    moments_of,
    no_displacement,
    numbers_of_pairs,
    of_kind,
    responses_of,
    speeds_and_turns,
    state_misfits,
    turning_members,
)
from asperity.drive.state.slopes import newton_step, responses_and_slopes, state_slopes
from asperity.drive.state.state import SLIP_TOLERANCE, STATE_TOLERANCE, DriveState
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import in_one, while_loop
from asperity.engine.derivatives import value_and_slope, with_rule, without_slopes
from asperity.linear import solve, solve_in_turn
from asperity.types import Array, Real

_NEWTON_BUDGET = 60
#: Steps without a shorter one after which a search is given up: towards a root they become shorter.
_PATIENCE = 20
#: Share of what it was below which a positive unknown is lost, as it falls to nothing: what
#: :mod:`asperity.joint.capacity` calls lifted off, by far.
_NOTHING = 1e-14
_SMALLEST_SHARE = 0.2  # a step leaves at least this share of each positive unknown
_SMALLEST_STEP = 1e-13
#: Steps shorter than this become shorter as their squares do, and the next one can be foretold.
_SHORT_STEP = 1e-6


def tied_zeros(values: Array) -> Array:
    """Zeros that are batched where some values are: JAX traces a loop once more for every start that is not."""
    return xp.where(values > xp.inf, 1.0, 0.0)


def newton(
    step_at: Callable[[Any], Any], first: Any, *, positive: int, longest: Real = math.inf
) -> tuple[Any, Array]:
    r"""Root of as many equations as unknowns, without derivatives.

    .. math:: x \leftarrow x - \alpha\, J^{-1} r(x)

    Parameters
    ----------
    step_at : callable
        From a module of unknowns, each of order 1, to the step :math:`J^{-1} r(x)`, of the same structure.
    first : module of Array
        Where the search starts.
    positive : int
        How many of the first unknowns must stay positive: a step is shortened (alpha < 1) so that they keep a fifth.
    longest : Real, optional
        Change of an unknown in one step, not shortened, beyond which the search is given up [-].

    Returns
    -------
    module of Array
        The last iterate; its residual is for the caller to check.
    Array
        Largest change of an unknown in the last step, not shortened [-]: large, or nan, where the unknowns are not
        determined.

    Notes
    -----
    The search ends with a step that is as small as rounding errors, or after which the next one would be: with
    quadratic convergence a step s after a step t is followed by one of :math:`s\,(s/t)^2`. It is given up where steps
    have not become shorter for a while, and where a positive unknown falls to nothing.

    References
    ----------
    Newton's method.
    """
    start, shape = in_one(first)

    def unfinished(state: _Iterate) -> Array:
        size = state.size
        settled = (size < _SHORT_STEP) & (size * (size / state.before) ** 2 < _SMALLEST_STEP)
        patient = (state.steps < _NEWTON_BUDGET) & (state.steps < state.best + _PATIENCE)
        lost = xp.min(state.x[:positive]) < _NOTHING
        return (size > _SMALLEST_STEP) & ~settled & (size < longest) & patient & ~lost

    def improve(state: _Iterate) -> _Iterate:
        step, _ = in_one(step_at(shape(state.x)))
        normal, falling = state.x[:positive], step[:positive]
        room = xp.where(falling > 0.0, (1.0 - _SMALLEST_SHARE) * normal / falling, xp.inf)
        share = xp.minimum(1.0, xp.min(room))
        size, steps = xp.max(xp.abs(step)), state.steps + 1
        shortest = size < state.shortest
        return _Iterate(
            x=state.x - share * step,
            size=size,
            before=state.size,
            steps=steps,
            shortest=xp.where(shortest, size, state.shortest),
            best=xp.where(shortest, steps, state.best),
        )

    nothing = tied_zeros(start[0])
    count = nothing.astype(int)
    # no step has gone before the first one: it foretells nothing
    last = while_loop(
        unfinished, improve, _Iterate(start, nothing + 1.0, nothing, count, nothing + xp.inf, count)
    )
    return shape(last.x), last.size


class _Iterate(NamedTuple):
    x: Array
    size: Array  # largest change of an unknown in the last step, not shortened
    before: Array  # and in the step before
    steps: Array
    shortest: Array  # the smallest of these changes so far
    best: Array  # the step that made it


# a state in which contacts slide: more than this, or a longer last step of Newton's method, is that of a mechanism
_BALANCED, _DETERMINED = 1e-11, 1e-6
_LOST = 1e4  # a step this long from one balance towards another is that of a mechanism

_Given = tuple[Machine, Task, Array]


class Balance(NamedTuple):
    """Unknowns of a state, what its contacts do under their forces, and the signs of those that slide as a whole."""

    unknowns: Unknowns
    responses: Responses
    slides: Array


def assembled_guess(machine: Machine) -> Unknowns:
    """An assembled drive with the reference forces, from which its state is sought."""
    drive, reference = machine.drive, machine.laws.reference_force
    return Unknowns(
        xp.ones_like(reference),
        xp.zeros_like(reference),
        xp.zeros(machine.matrices.levers.size),
        no_displacement(drive),
        xp.zeros(len(turning_members(drive))),
        xp.ones(1),
    )


def started_from(machine: Machine, state: DriveState, size: Array) -> Unknowns:
    """Unknowns at a known state under an interference [m], from which another state is sought; equation (M3)."""
    reference = machine.laws.reference_force
    return Unknowns(
        state.normal / reference,
        state.tangential / (machine.friction * reference),
        xp.pad(state.pin_force / machine.largest, (0, machine.matrices.levers.size - state.pin_force.size)),
        state.displacement.ravel() / machine.length,
        (state.speed - machine.ideal)[turning_members(machine.drive)],
        (size / machine.length)[None],
    )


class _Search(NamedTuple):
    """The last balance and what its contacts hold; those that slide in the next trial."""

    last: Balance
    held: Array
    trial: Array
    going: Array
    steps: Array


def solved(
    machine: Machine,
    task: Task,
    start: Unknowns,
    *,
    slides: Array | None = None,
    pressed_sectors: int,
    known: Array | bool = False,
    holds: Array | bool = False,
) -> Balance:
    """Unknowns of a state, what its contacts do, and which of them slide.

    Parameters
    ----------
    machine, task : Machine, Task
        The drive and the state.
    start : Unknowns
        Where the search starts.
    slides : Array or None, optional
        Signs of the contacts that slide there, shape (contacts,) [-]; None for none.
    pressed_sectors : int
        Number of sectors whose mean preload an assembled state has; 0 where it has a given interference.
    known : Array or bool, optional
        Whether the start is the state itself, which is not sought then.
    holds : Array or bool, optional
        Whether no contact begins to slide.

    Returns
    -------
    Balance
        Root of all equations, with its derivatives.

    Notes
    -----
    In a standing drive a contact that would bear more than its friction slides: its tangential force follows its normal
    force, and its slip is free. One contact after the other, the one most beyond its friction first; one whose slip
    falls back holds again. Where no balance is left, the last contact holds on the line that continues its law, beyond
    its friction. In rolling none slides: steady rolling ends at the first gross slip.

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    fixed_machine, fixed_task = without_slopes((machine, task))
    fixed_task = of_kind(fixed_task, known_kind(task))
    nothing = tied_zeros(fixed_machine.laws.reference_force)
    first: Unknowns = trees.map(lambda leaf: without_slopes(leaf) + nothing[0], start)
    may_slide = (xp.asarray(task.kind) == STANDING) & ~xp.asarray(holds)
    begin = nothing if slides is None else nothing + without_slopes(slides)
    paired = np.isin(np.arange(first.normal.size), numbers_of_pairs(machine.drive))

    def improve(state: _Search) -> _Search:
        first_trial = state.steps == 0
        # a known state is only evaluated
        longest = xp.where(known, 0.0, xp.where(first_trial, xp.inf, _LOST))
        misfits_at = partial(state_misfits, fixed_machine, fixed_task, pressed_sectors, state.trial)

        def step_at(x: Unknowns) -> Unknowns:
            responses = responses_and_slopes(fixed_machine, fixed_task, x)
            slopes = state_slopes(fixed_machine, fixed_task, pressed_sectors, state.trial, x, responses)
            return newton_step(slopes, misfits_at(x, responses.value).all, solve_in_turn)

        tried, step = newton(step_at, state.last.unknowns, positive=first.normal.size, longest=longest)
        responses = contact_responses(fixed_machine, fixed_task, *contact_forces(fixed_machine, tried))
        misfits = misfits_at(tried, responses)
        balanced = (_worst(misfits.all) < _BALANCED) & (step < _DETERMINED)
        last, held = trees.map(
            lambda new, old: xp.where(balanced | first_trial, new, old),
            (Balance(tried, responses, state.trial), misfits.held),
            (state.last, state.held),
        )
        trial = _next_slides(last.unknowns, last.slides, held, paired)
        going = balanced & may_slide & xp.any(trial != last.slides) & (state.steps < 2 * nothing.size)
        return _Search(last, held, trial, going, state.steps + 1)

    started = Balance(first, responses_of(nothing), begin)
    start_of = _Search(started, begin, begin, nothing[0] == 0.0, nothing[0].astype(int))
    last = while_loop(lambda state: state.going, improve, start_of).last
    return _with_derivatives(machine, task, last, pressed_sectors=pressed_sectors)


def known_state(
    machine: Machine, task: Task, unknowns: Unknowns, slides: Array, *, pressed_sectors: int
) -> Balance:
    """A state that is known already, as :func:`solved` returns it."""
    responses = contact_responses(machine, task, *contact_forces(machine, unknowns))
    return _with_derivatives(
        machine, task, Balance(unknowns, responses, slides), pressed_sectors=pressed_sectors
    )


def _with_derivatives(machine: Machine, task: Task, found: Balance, *, pressed_sectors: int) -> Balance:
    """A balance with the derivatives of a root, and of what its contacts do there."""
    unknowns, responses = _known_root(
        (pressed_sectors, known_kind(task)), found[:2], (machine, task, found.slides)
    )
    return Balance(unknowns, responses, found.slides)


_Root = tuple[Unknowns, Responses]
_Fixed = tuple[int, int | None]  # sectors that are pressed together, kind of the state where that is known


@partial(with_rule, fixed=1)
def _known_root(fixed: _Fixed, root: _Root, given: _Given) -> _Root:
    return root


@_known_root.defjvp
def _derivative(fixed: _Fixed, primals: tuple[Any, Any], tangents: tuple[Any, Any]) -> tuple[Any, Any]:
    (root, given), (_, moved) = primals, tangents
    root = _known_root(fixed, root, given)  # itself, so that this may be differentiated in turn
    (at, _), (pressed_sectors, kind) = root, fixed

    def equations(given: _Given) -> tuple[Unknowns, Responses]:
        machine, task, slides = given[0], of_kind(given[1], kind), given[2]
        responses = contact_responses(machine, task, *contact_forces(machine, at))
        return state_misfits(machine, task, pressed_sectors, slides, at, responses).all, responses

    machine, task, slides = given[0], of_kind(given[1], kind), given[2]
    _, (change, by_given) = value_and_slope(equations, (given,), (moved,))
    responses = responses_and_slopes(machine, task, at)
    step = newton_step(state_slopes(machine, task, pressed_sectors, slides, at, responses), change, solve)
    by_root = trees.map(xp.negative, step)
    normal, tangential = contact_forces(machine, by_root)
    by_forces = trees.map(
        lambda *slopes: slopes[0] + slopes[1] * normal + slopes[2] * tangential,
        by_given,
        responses.by_normal,
        responses.by_tangential,
    )
    return root, (by_root, by_forces)


def _next_slides(x: Unknowns, slides: Array, held: Array, paired: np.ndarray) -> Array:
    """Contacts that slide in the next trial: one that has fallen back holds, or else one beyond its friction slides."""
    back = slides * held  # positive where the slip is less than that at which the contact begins to slide
    over = xp.where((slides == 0.0) & ~paired, xp.abs(x.tangential) - x.normal, 0.0) / x.normal
    returns = xp.max(back) > STATE_TOLERANCE
    place = xp.where(returns, xp.argmax(back), xp.argmax(over))
    sign = xp.where(returns, 0.0, xp.sign(x.tangential[place]))
    changes = (returns | (xp.max(over) > SLIP_TOLERANCE)) & (xp.arange(slides.size) == place)
    return xp.where(changes, sign, slides)


def _worst(residuals: Unknowns) -> Array:
    return xp.max(xp.abs(xp.concatenate(list(residuals))))


def state_of(machine: Machine, task: Task, found: Balance) -> DriveState:
    """A state, with its residual, from its balance; equation (M3)."""
    drive, (x, responses, slides) = machine.drive, found
    normal, tangential = contact_forces(machine, x)
    pin = x.pin * machine.largest
    speed, turned = speeds_and_turns(machine, x, task.kind)
    rolls = xp.where(xp.asarray(task.kind) == ROLLING, 1.0, 0.0)
    misfits = state_misfits(machine, task, False, slides, x, responses)
    within = xp.abs(tangential) <= responses.capacity * (1.0 + SLIP_TOLERANCE)
    carried = xp.all((normal > 0.0) & within)
    worst = _worst(misfits.all._replace(interference=xp.zeros(1)))
    worst = xp.maximum(worst, xp.max(slides * misfits.held))  # what slides less than its law must hold
    out, entry = drive.layout.output, drive.layout.input
    return DriveState(
        normal=normal,
        tangential=tangential,
        pin_force=pin[: len(drive.pinned)],
        displacement=(x.displacement * machine.length).reshape(-1, 2),
        rotation=turned,
        speed=speed,
        creepage=rolls * responses.creepage,
        drag=responses.resistance.drag,
        hysteresis_moment=responses.resistance.hysteresis_moment,
        skew_drag=responses.resistance.skew_drag,
        interference=contact_interference(machine, x),
        input_torque=-drive.sense
        * moments_of(machine, task, (normal, tangential), pin, responses.resistance)[entry],
        speed_loss=1.0 - speed[out] / machine.ideal[out],
        worst=worst,
        slides=slides,
        carried=carried,
    )
