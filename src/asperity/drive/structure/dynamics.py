r"""A joint between the inertia of its motor and that of its load: natural frequencies and frequency response.

Two inertias are joined by one torsional spring at the output. While the drive turns, creep acts as a damper in series
with the spring: elastic above a corner frequency, viscous below it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import Array

from asperity.types import Real


def roller_inertia(*, mass: Real, radius: Real, bore_diameter: Real) -> Real:
    r"""Moment of inertia of a roller about its own axis, :math:`I = \tfrac12 m (R^2 + d^2/4)`.

    Parameters
    ----------
    mass : Real
        Mass m [kg].
    radius : Real
        Outer radius R [m].
    bore_diameter : Real
        Diameter d of its bore, 0 for a solid roller [m].

    Returns
    -------
    Real
        Moment of inertia [kg·m^2].

    References
    ----------
    Closed form of a hollow cylinder; equation (D1) of :doc:`/equations`.
    """
    return 0.5 * mass * (radius**2 + 0.25 * bore_diameter**2)


class NaturalFrequencies(NamedTuple):
    """Frequencies of a joint between two inertias.

    Parameters
    ----------
    locked, free : Real
        With the motor held, at which a torque of the motor does not move the motor; and with both inertias free [Hz].
    """

    locked: Real
    free: Real


def natural_frequencies(*, stiffness: Real, input_inertia: Real, output_inertia: Real) -> NaturalFrequencies:
    r"""Natural frequency with the motor locked (antiresonance) and with both inertias free (resonance).

    .. math::
        f_a = \frac1{2\pi}\sqrt{\frac K{J_2}}, \qquad f_r = \frac1{2\pi}\sqrt{K\left(\frac1{J_1} + \frac1{J_2}\right)}

    Parameters
    ----------
    stiffness : Real
        Torsional stiffness K at the output [N·m/rad].
    input_inertia, output_inertia : Real
        Inertia of the input side, referred to the output, and that of the output side [kg·m^2].

    Returns
    -------
    NaturalFrequencies
        Both [Hz].

    References
    ----------
    Two inertias and a spring; equation (D2) of :doc:`/equations`.
    """
    return NaturalFrequencies(
        locked=jnp.sqrt(stiffness / output_inertia) / (2.0 * math.pi),
        free=jnp.sqrt(stiffness * (1.0 / input_inertia + 1.0 / output_inertia)) / (2.0 * math.pi),
    )


def dynamic_stiffness(*, frequency: Real, stiffness: Real, loss_factor: Real, creep_damping: Real) -> Array:
    r"""Complex stiffness of a joint that turns: spring and creep in series.

    .. math:: \frac1{\tilde K} = \frac{1}{K(1 + i\eta)} + \frac{1}{i\omega c}, \qquad
        \frac1c = \frac{\partial \omega_{lost}}{\partial T}

    Parameters
    ----------
    frequency : Real
        Frequency, above 0 [Hz].
    stiffness : Real
        Torsional stiffness K at the output [N·m/rad].
    loss_factor : Real
        Loss factor eta of the spring [-].
    creep_damping : Real
        Torque c per speed lost by creep [N·m·s/rad]; infinite for a joint that stands.

    Returns
    -------
    Array
        Complex stiffness at the output [N·m/rad].

    Notes
    -----
    Linear about the working torque; for frequencies at which the contacts roll farther than their width in one period.
    Above, creep begins more slowly (:mod:`asperity.contact.rolling_in`).

    References
    ----------
    Equation (D3) of :doc:`/equations`.
    """
    omega = 2.0 * math.pi * jnp.asarray(frequency)
    spring = 1.0 / (stiffness * (1.0 + loss_factor**2))
    return 1.0 / _complex(spring, -loss_factor * spring - 1.0 / (creep_damping * omega))


class FrequencyResponse(NamedTuple):
    """Angles per torque of the motor, both referred to the output. Complex.

    Parameters
    ----------
    motor, load : Array
        Angle of the input and of the output side per torque at the input [rad/(N·m)].
    """

    motor: Array
    load: Array


def frequency_response(
    *, frequency: Real, stiffness: Array, input_inertia: Real, output_inertia: Real
) -> FrequencyResponse:
    r"""Angles of both sides under an oscillating torque of the motor.

    .. math::
        \frac{\varphi_1}{T} = \frac{\tilde K - J_2\omega^2}{\Delta}, \quad
        \frac{\varphi_2}{T} = \frac{\tilde K}{\Delta}, \quad \Delta = J_1 J_2\omega^4 - \tilde K (J_1 + J_2)\,\omega^2

    Parameters
    ----------
    frequency : Real
        Frequency, above 0 [Hz].
    stiffness : Array
        Complex stiffness of :func:`dynamic_stiffness` [N·m/rad].
    input_inertia, output_inertia : Real
        Inertia of the input side, referred to the output, and that of the output side [kg·m^2].

    Returns
    -------
    FrequencyResponse
        Angles per torque, both referred to the output [rad/(N·m)].

    References
    ----------
    Two inertias and a spring; equation (D3) of :doc:`/equations`.
    """
    square = (2.0 * math.pi * jnp.asarray(frequency)) ** 2
    inertial = _complex(input_inertia * output_inertia * square**2, 0.0)
    both = inertial - stiffness * _complex((input_inertia + output_inertia) * square, 0.0)
    return FrequencyResponse(
        motor=(stiffness - _complex(output_inertia * square, 0.0)) / both, load=stiffness / both
    )


def _complex(real: Real, imaginary: Real) -> Array:
    return jax.lax.complex(*jnp.broadcast_arrays(jnp.asarray(real), jnp.asarray(imaginary)))
