r"""A wind-up as a law of the torque's history: a reversible angle in series with slip that follows Masing's rule.

The angle is :math:`\rho(T) + s`, with the slip :math:`\gamma` from rest and :math:`s_r \pm 2\gamma(|T - T_r|/2)` after
a reversal. This is how :mod:`asperity.standing.windup` builds the loop between plus and minus its largest torque;
here it is a function of any torque within them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator
from scipy.optimize import nnls

from asperity.joint.play import Play, play_angle
from asperity.standing.windup import Windup


class SeriesLaw:
    """Angles of a wind-up without its play. SI units.

    Parameters
    ----------
    curve : Windup
        The wind-up.
    play : Play
        Play that is part of it.
    """

    def __init__(self, curve: Windup, play: Play) -> None:
        torque, slip = np.asarray(curve.torque), np.asarray(curve.slip_angle)
        taken_up = np.asarray(play_angle(play=play, output_torque=curve.torque))
        self.largest_torque = float(torque[-1])
        self.reversible = PchipInterpolator(torque, np.asarray(curve.angle) - slip - taken_up)
        positive = torque >= 0.0
        self.slip_torque, self.slip_angle = torque[positive], slip[positive]
        self.slip = PchipInterpolator(self.slip_torque, self.slip_angle)

    def loading(self, torque: np.ndarray) -> np.ndarray:
        """Angle on first loading from rest [rad], at torques of either sign [N·m]."""
        return self.reversible(torque) + np.sign(torque) * self.slip(np.abs(torque))

    def branch(self, torque: np.ndarray, *, size: float, sense: float) -> np.ndarray:
        """Angle [rad] on a branch of the loop between plus and minus a torque ``size`` [N·m].

        ``sense`` is 1 for growing torque, -1 for falling torque.
        """
        since = self.slip(0.5 * (size + sense * torque))
        return self.reversible(torque) + sense * (2.0 * since - self.slip(size))


@dataclass(frozen=True)
class SlipElements:
    """Slip of a wind-up as elements in series, each a spring beside a slider.

    ``threshold`` is the torque below which each slider sticks [N·m], ``compliance`` the angle per torque beyond it
    [rad/(N·m)], shape (n,); ``error`` the largest deviation of the angle on the loops between plus and minus the
    largest torque, and of half of it [rad].
    """

    threshold: np.ndarray
    compliance: np.ndarray
    error: float


def slip_elements(law: SeriesLaw, *, elements: int) -> SlipElements:
    r"""Elements whose slip follows that of a wind-up, by least squares, their thresholds evenly spread.

    .. math:: \gamma(T) = \sum_i c_i \max(0, T - r_i), \qquad c_i \ge 0

    They follow Masing's rule, because the torque at which an element slips back is twice its threshold below the last
    one (G. Masing, Proc. 2nd Int. Congr. Appl. Mech., Zurich 1926, 332).
    """
    largest = law.largest_torque
    threshold = np.arange(elements) / elements * largest
    torque = np.linspace(0.0, largest, 8 * elements + 1)[1:]

    def slip(compliance: np.ndarray, torque: np.ndarray) -> np.ndarray:
        return np.maximum(0.0, torque[:, None] - threshold) @ compliance

    scale = max(float(law.slip(largest)), np.finfo(float).tiny)
    scaled_compliance, _ = nnls(
        np.maximum(0.0, torque[:, None] - threshold) / largest, law.slip(torque) / scale
    )
    compliance = scaled_compliance * scale / largest
    off = slip(compliance, np.concatenate([[0.0], torque])) - law.slip(np.concatenate([[0.0], torque]))
    # along a branch from the torque S: gamma(S) - 2 gamma((S - T)/2)
    error = max(
        float(np.max(np.abs(off[end] - 2.0 * off[: end + 1]))) for end in (8 * elements, 4 * elements)
    )
    return SlipElements(threshold, compliance, error)
