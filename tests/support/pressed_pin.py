"""An elastic pin pressed in the bore of an elastic body, by pressures that are even over short elements.

Disc and bore answer each mode of the pressure; where the surfaces would part there is none.
"""

from typing import NamedTuple

import numpy as np

_MODES, _CHUNK, _ROUNDS = 20_000, 500, 200


class PressedPin(NamedTuple):
    """Half-angle of the contact [rad], approach from first touch [m]; centres [rad] and pressures [Pa] of elements."""

    angle: float
    approach: float
    centres: np.ndarray
    pressure: np.ndarray


def hole(mode, kolosov):
    """Motion of a hole in a large plate under a unit pressure of a mode n >= 2, in units of R/2G."""
    return ((kolosov + 1.0) * mode + kolosov - 1.0) / (2.0 * (mode**2 - 1.0))


def disc(mode, kolosov):
    """The same of a disc, inward."""
    return ((kolosov + 1.0) * mode - kolosov + 1.0) / (2.0 * (mode**2 - 1.0))


def pressed_pin(*, walls, kolosov, modulus, radius, clearance, line_load, span, elements=400):
    """A pin pressed by a force per length [N/m]; ``walls``: motion of the bore in the modes 0, 1, 2, ... in R/2G.

    Above the modes of the walls the bore is that of a large plate. ``span`` is an angle beyond the contact [rad], and
    ``modulus`` the shear modulus [Pa].
    """
    n = np.arange(_MODES + 1.0)
    answer = np.zeros(_MODES + 1)
    answer[2:] = hole(n[2:], kolosov)
    answer[: len(walls)] = walls
    answer[2:] += disc(n[2:], kolosov)
    answer[0] += 0.5 * (kolosov - 1.0)
    answer[1] += 0.25 * (kolosov - 1.0)  # under a force spread evenly over its section
    width = span / elements
    centres = (np.arange(elements) + 0.5) * width
    share = (
        np.concatenate([[0.5 * width / np.pi], 2.0 * np.sin(0.5 * n[1:] * width) / (np.pi * n[1:])]) * answer
    )
    apart = np.arange(2 * elements) * width
    kernel = sum(
        np.cos(np.outer(apart, n[k : k + _CHUNK])) @ share[k : k + _CHUNK] for k in range(0, n.size, _CHUNK)
    )
    i = np.arange(elements)
    moves = kernel[abs(i[:, None] - i)] + kernel[i[:, None] + i + 1]  # with the mirror image
    moves *= radius / (2.0 * modulus)
    bears = 4.0 * radius * np.sin(0.5 * width) * np.cos(centres)
    touches = centres < 0.9 * span
    for _ in range(_ROUNDS):
        at = np.flatnonzero(touches)
        system = np.block([[moves[np.ix_(at, at)], -np.cos(centres[at])[:, None]], [bears[at], np.zeros(1)]])
        *found, shift = np.linalg.solve(system, np.append(np.full(at.size, -clearance), line_load))
        pressure = np.zeros(elements)
        pressure[at] = found
        gap = moves @ pressure - shift * np.cos(centres) + clearance
        now = np.where(touches, pressure > 0.0, gap < 0.0)
        if np.array_equal(now, touches):
            break
        touches = now
    return PressedPin((touches.sum()) * width, shift - clearance, centres, pressure)
