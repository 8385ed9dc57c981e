r"""Angles along any history of torques as a linear operator on the compliance of the loading curves.

The loading curve is :math:`\varphi(T) = \int_0^T dT'/K(T')` for torques of either sign (A9). The part of it that is
slip, :math:`\gamma`, follows Masing's rule after a reversal at :math:`T_r`: it grows by
:math:`2 \operatorname{sgn}(T - T_r)\, \gamma(|T - T_r|/2)`. A branch that returns to the reversal before it closes its
loop, and goes on along the branch on which that loop began (Madelung's rules). The rest of the loading curve is
reversible. Every angle is so a weighted sum of compliances, with slip and without, at fixed torques.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from asperity.errors import InputError

History = Literal["virgin", "cycled"]

_PANELS = 12
_NODES = 4

#: Coefficients and arguments of the loading curve whose sum is an angle.
_Terms = list[tuple[float, float]]


def cycled_before(torques: np.ndarray) -> list[float]:
    """Torques at the reversals of a joint that is cycled to plus and minus the largest torque before a history begins.

    [N·m].
    """
    sequence = [float(torque) for torque in torques]
    if not sequence:
        return []
    largest = max(abs(torque) for torque in sequence)
    moved = next((torque for torque in sequence[1:] if torque != sequence[0]), sequence[0])
    return [largest, -largest] if moved >= sequence[0] else [-largest, largest]


def slip_terms(torques: np.ndarray, history: History) -> list[_Terms]:
    """The slip at each torque of a history as a sum of values of the slip curve [N·m]."""
    sequence = [float(torque) for torque in torques]
    before = cycled_before(torques) if history == "cycled" else []
    reversals: list[tuple[float, _Terms]] = []
    last, direction = 0.0, 0.0
    last_terms: _Terms = []
    all_terms = []
    for torque in [*before, *sequence]:
        step = np.sign(torque - last)
        if step != 0.0:
            if direction not in (0.0, step):
                reversals.append((last, last_terms))
            direction = float(step)
            while len(reversals) >= 2 and (torque - reversals[-2][0]) * direction >= 0.0:
                del reversals[-2:]
            if (
                len(reversals) == 1
                and abs(torque) >= abs(reversals[0][0])
                and torque * reversals[0][0] <= 0.0
            ):
                reversals.clear()
        if reversals:
            turned, base = reversals[-1]
            terms = [*base, (2.0 * float(np.sign(torque - turned)), 0.5 * abs(torque - turned))]
        else:
            terms = [(float(np.sign(torque)), abs(torque))]
        all_terms.append(terms)
        last, last_terms = torque, terms
    return all_terms[len(before) :]


@dataclass(frozen=True)
class CurveOperator:
    """Angles of a torque history from compliances at fixed torques: angle = weights @ (1/stiffness).

    ``torque``, of either sign [N·m], and ``slips``, whether the compliance with slip is needed there or that without,
    have the shape (nodes,); ``weights`` (points, nodes) [N·m].
    """

    torque: np.ndarray
    slips: np.ndarray
    weights: np.ndarray


def _partial_weights(places: np.ndarray) -> np.ndarray:
    """Integrals of the Lagrange polynomials of the Gauss nodes from −1 to given places, shape (places, nodes)."""
    nodes, _ = np.polynomial.legendre.leggauss(_NODES)
    columns = []
    for index in range(_NODES):
        others = np.delete(nodes, index)
        basis = np.polynomial.Polynomial.fromroots(others) / np.prod(nodes[index] - others)
        integral = basis.integ()
        columns.append(integral(places) - integral(-1.0))
    return np.stack(columns, axis=-1)


def curve_operator(torques: np.ndarray, history: History, *, symmetric: bool) -> CurveOperator:
    """The operator of a history of torques."""
    largest = float(np.max(np.abs(torques), initial=0.0))
    if largest == 0.0:
        raise InputError("all measured torques are zero; a curve needs torques that differ from zero")
    terms = slip_terms(torques, history)
    torques = np.asarray(torques, float)
    arguments = np.unique([*np.abs(torques), *(torque for combination in terms for _, torque in combination)])
    integral = _integrals(arguments, largest)

    def along(torque: np.ndarray | float) -> np.ndarray:
        return integral[np.searchsorted(arguments, torque)]

    sign = np.sign(torques)[:, None]
    loading = along(np.abs(torques))
    slip = np.stack([sum((c * along(t) for c, t in combination), 0.0 * integral[0]) for combination in terms])
    slip = slip - sign * loading  # what remains of it beside the loading curve
    visited = np.concatenate([torques, cycled_before(torques) if history == "cycled" else []])
    sides = np.array([np.any(visited > 0.0), np.any(visited < 0.0)], float)
    sides = sides / sides.sum()
    forward = np.where(sign > 0.0, loading, 0.0) + sides[0] * slip
    reverse = np.where(sign < 0.0, -loading, 0.0) + sides[1] * slip
    nodes = _nodes(largest)
    if symmetric:
        blocks = [(nodes, True, forward + reverse), (nodes, False, -slip)]
    else:
        blocks = [(nodes, True, forward), (-nodes, True, reverse)]
        blocks += [(nodes, False, -sides[0] * slip), (-nodes, False, -sides[1] * slip)]
    needed = [(torque, slips, weights) for torque, slips, weights in blocks if np.any(weights)]
    return CurveOperator(
        torque=np.concatenate([torque for torque, _, _ in needed]),
        slips=np.concatenate([np.full(nodes.size, slips) for _, slips, _ in needed]),
        weights=np.concatenate([weights for _, _, weights in needed], axis=1),
    )


def _nodes(largest: float) -> np.ndarray:
    nodes, _ = np.polynomial.legendre.leggauss(_NODES)
    centres = largest / _PANELS * (np.arange(_PANELS)[:, None] + 0.5 * (1.0 + nodes))
    return centres.reshape(-1)


def _integrals(arguments: np.ndarray, largest: float) -> np.ndarray:
    """Weights of the integrals from 0 to each of the arguments, shape (arguments, nodes)."""
    _, gauss = np.polynomial.legendre.leggauss(_NODES)
    width = largest / _PANELS
    panel = np.minimum((arguments / width).astype(int), _PANELS - 1)
    inside = 2.0 * (arguments / width - panel) - 1.0
    integral = np.zeros((arguments.size, _PANELS, _NODES))
    for row, (panels, partial) in enumerate(zip(panel, _partial_weights(inside), strict=True)):
        integral[row, :panels] = gauss
        integral[row, panels] = partial
    return 0.5 * width * integral.reshape(arguments.size, -1)
