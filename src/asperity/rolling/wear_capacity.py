"""Torques at which the first contact of worn joints slides: of many states of wear side by side."""

from __future__ import annotations

import numpy as np

from asperity.engine import trees
from asperity.engine.control import at_once, vectorised
from asperity.rolling.wear_rates import Wearing, WearLoad, Worn, wear_state
from asperity.types import Array

#: Torques at which each joint is looked at at a time, rounds of the search, its last width over the torque.
_LOOKS, _ROUNDS, _NARROW = 10, 12, 1e-6
#: Where the torques of a joint are looked for first, over the guess.
_FIRST, _LAST = 0.7, 1.6


def capacities(wearing: Wearing, worn: Worn, load: WearLoad, *, guess: np.ndarray) -> np.ndarray:
    """Torques in the sense of a load at which the first contact of worn joints slides, shape (n,) [N·m].

    ``guess`` of them; nan where no limit is found near it. All are looked for side by side, at several torques each.
    """
    count = len(guess)
    sense = -1.0 if load.output_torque < 0.0 else 1.0

    def largest(torques: np.ndarray) -> np.ndarray:
        """Largest excesses at torques, shape (n, looks) [-]."""
        looks = torques.shape[1]
        states: Worn = trees.map(lambda leaf: np.repeat(leaf, looks, axis=0), worn)
        numbers = count * looks
        under = WearLoad(
            sense * torques.ravel(),
            np.full(numbers, load.input_speed),
            np.ones(numbers),
            np.zeros((numbers, worn.interference.shape[1])),
        )

        def over_all(wearing: Wearing, states: Worn, under: WearLoad) -> Array:
            return vectorised(lambda *given: wear_state(wearing, *given).excesses)(states, under)

        found = np.asarray(at_once(over_all, wearing, states, under))
        return np.where(np.isnan(found), -1.0, found).max(axis=1).reshape(count, looks)

    lower, upper = np.zeros(count), np.full(count, np.inf)
    below, above = np.full(count, -1.0), np.full(count, np.inf)
    trials = guess[:, None] * np.linspace(_FIRST, _LAST, _LOOKS)
    rows = np.arange(count)
    for _ in range(_ROUNDS):
        found = largest(trials)
        reached = found >= 0.0
        first = np.where(reached.any(axis=1), reached.argmax(axis=1), trials.shape[1])
        some, before = first < trials.shape[1], first > 0
        at, last = np.minimum(first, trials.shape[1] - 1), np.maximum(first - 1, 0)
        upper = np.where(some, trials[rows, at], upper)
        above = np.where(some, found[rows, at], above)
        lower = np.where(before, trials[rows, last], lower)
        below = np.where(before, found[rows, last], below)
        known = np.isfinite(upper)
        width = np.where(known, upper - lower, lower)
        if np.all(known & (width <= _NARROW * upper)):
            break
        chord = np.where(known, lower - below * width / (above - below), lower)
        off = 0.2 * width**2 / np.where(known, upper, 1.0) + 0.2 * _NARROW * lower
        near = chord[:, None] + off[:, None] * np.array([-4.0, -1.0, -0.25, 0.25, 1.0, 4.0])
        even = lower[:, None] + width[:, None] * np.array([0.25, 0.5, 0.75])
        inside = np.sort(np.concatenate([near, even], axis=1), axis=1)
        inside = np.clip(inside, lower[:, None], np.where(known, upper, np.inf)[:, None])
        ahead = lower[:, None] * np.linspace(1.0, 2.0, inside.shape[1] + 1)[1:]
        trials = np.where(known[:, None], inside, ahead)
    return np.where(np.isfinite(upper), lower, np.nan)
