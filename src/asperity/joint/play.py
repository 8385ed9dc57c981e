r"""Play of a joint: the angle that its output turns on passing zero torque, without load to resist it."""

from __future__ import annotations

import numpy as np

from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Array, Real


class Play(Module):
    """Play at the output with the input locked.

    Parameters
    ----------
    angle : Real
        Whole play, from one side to the other [rad].
    take_up_torque : Real
        Torque T_p over which the play is taken up [N·m]; 0 for a play that is taken up at once.
    """

    angle: Real
    take_up_torque: Real


#: A joint without play.
NO_PLAY = Play(angle=0.0, take_up_torque=0.0)


def play_angle(*, play: Play, output_torque: Real | np.ndarray) -> Array:
    r"""Angle that the play adds to the wind-up under an output torque T [rad].

    .. math:: \varphi_p(T) = \tfrac12 \varphi_0 \tanh(T/T_p)

    For a take-up torque of 0 it is :math:`\tfrac12 \varphi_0 \operatorname{sgn} T`. The same on loading and on
    unloading: play without friction makes lost motion, but no hysteresis. An empirical law; equation (A9) of
    :doc:`/equations`.
    """
    torque = xp.asarray(output_torque)
    gradual = xp.asarray(play.take_up_torque) > 0.0
    scaled = torque / xp.where(gradual, play.take_up_torque, 1.0)
    return 0.5 * play.angle * xp.where(gradual, xp.tanh(scaled), xp.sign(torque))


def play_compliance(*, play: Play, output_torque: Real | np.ndarray) -> Array:
    r"""Derivative of :func:`play_angle` by the torque [rad/(N·m)].

    .. math:: \frac{d\varphi_p}{dT} = \frac{\varphi_0}{2 T_p} \left[1 - \tanh^2(T/T_p)\right]

    For a take-up torque of 0 infinite at zero torque and 0 elsewhere. Equation (A9) of :doc:`/equations`.
    """
    torque = xp.asarray(output_torque)
    gradual = xp.asarray(play.take_up_torque) > 0.0
    width = xp.where(gradual, play.take_up_torque, 1.0)
    smooth = 0.5 * play.angle / width * (1.0 - xp.tanh(torque / width) ** 2)
    sudden = xp.where((torque == 0.0) & (xp.asarray(play.angle) > 0.0), xp.inf, 0.0)
    return xp.where(gradual, smooth, sudden)
