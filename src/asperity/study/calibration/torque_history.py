r"""Angles along any history of torques as a linear operator on the compliance of the loading curve.

The loading curve is :math:`\varphi(T) = \int_0^T dT'/K(T')` (A9). After a reversal at :math:`T_r` the angle follows
Masing's rule, :math:`\varphi_r + 2 \operatorname{sgn}(T - T_r)\, \varphi(|T - T_r|/2)`; a branch that returns to the
reversal before it closes its loop, and goes on along the branch on which that loop began (Madelung's rules). Every
angle is so a sum of values of :math:`\varphi`, and every value of it a weighted sum of compliances at fixed torques.
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


def angle_terms(torques: np.ndarray, history: History) -> list[_Terms]:
    """Each angle of a history of torques as a sum of values of the loading curve.

    Parameters
    ----------
    torques : ndarray
        Torques in the order of time, shape (points,) [N·m].
    history : {"virgin", "cycled"}
        State before the first one: never loaded, or cycled between plus and minus the largest torque.

    Returns
    -------
    list of list of tuple
        For each point, coefficients and torques >= 0 [N·m]; the angle is the sum of coefficient times
        loading curve there.

    References
    ----------
    G. Masing, Proc. 2nd Int. Congr. Appl. Mech., Zurich 1926, 332; E. Madelung, Ann. Phys. 322 (1905) 861.
    """
    sequence = [float(torque) for torque in torques]
    before: list[float] = []
    if history == "cycled" and sequence:
        largest = max(abs(torque) for torque in sequence)
        moved = next((torque for torque in sequence[1:] if torque != sequence[0]), sequence[0])
        upward = moved >= sequence[0]
        before = [largest, -largest] if upward else [-largest, largest]
    reversals: list[tuple[float, _Terms]] = []
    last, direction = 0.0, 0.0
    last_terms: _Terms = []
    found = []
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
        found.append(terms)
        last, last_terms = torque, terms
    return found[len(before) :]


@dataclass(frozen=True)
class CurveOperator:
    """Angles of a torque history from compliances at fixed torques.

    Parameters
    ----------
    torque : ndarray
        Torques at which the compliance is needed, shape (nodes,) [N·m].
    weights : ndarray
        Shape (points, nodes) [N·m]; angle = weights @ (1/stiffness).
    """

    torque: np.ndarray
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


def curve_operator(torques: np.ndarray, history: History) -> CurveOperator:
    """The operator of a history of torques.

    Parameters
    ----------
    torques : ndarray
        Torques in the order of time, of either sign, shape (points,) [N·m].
    history : {"virgin", "cycled"}
        State before the first one.

    Returns
    -------
    CurveOperator
        Gauss–Legendre quadrature on panels of the loading curve; exact for compliances that are cubic in each panel.

    Raises
    ------
    InputError
        If all torques are zero.
    """
    largest = float(np.max(np.abs(torques), initial=0.0))
    if largest == 0.0:
        raise InputError("all measured torques are zero; a curve needs torque")
    terms = angle_terms(torques, history)
    arguments = np.unique([torque for each in terms for _, torque in each])
    nodes, gauss = np.polynomial.legendre.leggauss(_NODES)
    width = largest / _PANELS
    panel = np.minimum((arguments / width).astype(int), _PANELS - 1)
    inside = 2.0 * (arguments / width - panel) - 1.0
    integral = np.zeros((arguments.size, _PANELS, _NODES))
    for row, (whole, partial) in enumerate(zip(panel, _partial_weights(inside), strict=True)):
        integral[row, :whole] = gauss
        integral[row, whole] = partial
    integral = 0.5 * width * integral.reshape(arguments.size, -1)
    weights = np.zeros((len(terms), integral.shape[1]))
    for row, each in enumerate(terms):
        for coefficient, torque in each:
            weights[row] += coefficient * integral[np.searchsorted(arguments, torque)]
    centres = width * (np.arange(_PANELS)[:, None] + 0.5 * (1.0 + nodes))
    return CurveOperator(torque=centres.reshape(-1), weights=weights)
