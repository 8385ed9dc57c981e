"""A drive that stands, followed along its loading: contacts that slide keep doing so as the torque grows."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.layout.drive import Drive
from asperity.drive.state.equations import STANDING, Machine, Task, Unknowns, forces_on, machine_of
from asperity.drive.state.search import solved, started_from, state_of
from asperity.drive.state.state import STATE_TOLERANCE, ContactLaws, DriveLoad, DriveState
from asperity.drive.state.states import closed_around
from asperity.types import Real

#: Relative width of the last step.
FOLLOWING_TOLERANCE = 1e-11

_MOST_STEPS = 400
_LONGER, _SHORTER = 1.5, 0.4


class _Path(NamedTuple):
    """The last balance, its torque, and the next step."""

    found: Unknowns
    state: DriveState
    torque: Array
    step: Array
    steps: Array


def followed(
    *,
    drive: Drive,
    pressed: Callable[[Array], tuple[ContactLaws, DriveState]],
    load: DriveLoad,
    first_step: Real,
    most: Real,
    keeps: Callable[[DriveState], Array],
) -> tuple[DriveState, Array]:
    """The drive under the largest torque up to a given one that it carries, loaded step by step.

    Parameters
    ----------
    drive : Drive
        The drive.
    pressed : callable
        Laws of its contacts and its assembled state under a torque, which differs where a loading cam presses it.
    load : DriveLoad
        Forces on the bodies, pins and bearings; of its torque only the sign counts, positive for 0.
    first_step : Real
        First step of the torque, positive [N·m].
    most : Real
        Torque at which the following ends [N·m]; ``math.inf`` for none.
    keeps : callable
        Whether a state keeps all further limits.

    Returns
    -------
    DriveState
        The last state that is balanced and keeps all limits.
    Array
        Its torque, without sign [N·m].

    Notes
    -----
    Which contacts slide is taken over from step to step, as on one loading from rest. Where many of them slide, a
    search that begins at rest under the whole torque may choose others, and find no balance although there is one.

    References
    ----------
    Equation (M3) of :doc:`/equations`.
    """
    way = jnp.where(jnp.asarray(load.output_torque) < 0.0, -1.0, 1.0)

    def at(torque: Array) -> tuple[Machine, Task, DriveState]:
        laws, rest = pressed(way * torque)
        laws, rest, borne = closed_around(drive=drive, laws=laws, rest=rest, load=load)
        size = jnp.max(rest.interference)
        machine = machine_of(drive, laws, rest.interference / size, supports=borne.supports)
        borne = dataclasses.replace(borne, output_torque=way * torque, body_force=forces_on(drive, borne))
        task = Task(STANDING, size, borne, rest.displacement.ravel(), rest.pin_force, rest.normal)
        return machine, task, rest

    def unfinished(path: _Path) -> Array:
        narrow = path.step < FOLLOWING_TOLERANCE * jnp.maximum(path.torque, first_step)
        return (path.torque < most) & ~narrow & (path.steps < _MOST_STEPS)

    def further(path: _Path) -> _Path:
        torque = jnp.minimum(path.torque + path.step, most)
        machine, task, _ = at(torque)
        found, slides = solved(machine, task, path.found, slides=path.state.slides, pressed_sectors=0)
        state = state_of(machine, task, found, slides)
        holds = (state.residual < STATE_TOLERANCE) & keeps(state)
        step = path.step * jnp.where(holds, _LONGER, _SHORTER)
        following = _Path(found, state, torque, step, path.steps + 1)
        last = path._replace(step=step, steps=path.steps + 1)
        kept: _Path = jax.tree.map(lambda new, old: jnp.where(holds, new, old), following, last)
        return kept

    nothing = jnp.zeros(())
    machine, task, rest = at(nothing)
    found = started_from(machine, rest, task.size)
    state = state_of(machine, task, found, rest.slides)
    begin = _Path(found, state, nothing, nothing + first_step, jnp.asarray(0))
    end = jax.lax.while_loop(unfinished, further, begin)
    return end.state, end.torque
