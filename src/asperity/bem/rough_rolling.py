r"""Steady rolling of rough cylinders: strips of the half-planes with asperities that yield in both directions.

The nominal pressure of the asperities falls exponentially with the separation u, and so every material point carries a
bundle of springs that touch at all separations. Each slips by itself, starts without force where it touches and lets go
where it parts (Jäger's superposition; the method of dimensionality reduction):

.. math::
    p \propto e^{-u/u_0}, \qquad p = k \int (g - u)_+\, e^{-g/u_0}\, \mathrm dg, \qquad
    \mathrm df = \kappa k\, \mathrm dw, \quad |f| \le \mu k (g - u)

Lengths are over Hertz's half-width a, pressures over Hertz's peak, displacements over :math:`a^2/R`, tractions over mu
times that peak, creepages over :math:`\mu a/R`. Two numbers then remain: :math:`s = u_0 R/a^2`, and the ratio kappa of
the asperities' tangential to their normal stiffness, :math:`2(1-\nu)/(2-\nu)` for like bodies.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from asperity.bem.free_half_space import strip_integral
from asperity.errors import NoSolutionError

_TOLERANCE = 1e-10
_STEPS = 200
#: The grid ends where the pressure is about exp(-16) of its peak.
_DECADES = 16.0


class RoughPressure(NamedTuple):
    """Normal contact of rough cylinders, from the leading edge to the trailing one; arrays over the strips.

    ``layer_ratio``: s = u_0 R/a^2 [-]; ``position`` of the middles over Hertz's half-width [-]; ``pressure`` over
    Hertz's peak [-]; ``compliance``: displacements per traction of the half-planes, shape (strips, strips) [-].
    """

    layer_ratio: float
    position: np.ndarray
    pressure: np.ndarray
    compliance: np.ndarray


class RoughRolling(NamedTuple):
    """Steady rolling of rough cylinders; arrays over the strips.

    ``creepage`` over that of smooth cylinders at gross slip, mu a/R [-]; ``traction`` over mu times Hertz's peak
    pressure [-]; ``shift``: growth of the asperities' displacement from each strip to the next [-], the start of a
    neighbouring state.
    """

    creepage: float
    traction: np.ndarray
    shift: np.ndarray


def _reach(layer_ratio: float) -> float:
    """Half-widths from the middle at which Hertz's separation makes the pressure negligible [-]."""
    low, high = 1.0, 10.0 + 6.0 * math.sqrt(_DECADES * layer_ratio)
    for _ in range(60):
        x = 0.5 * (low + high)
        gap = 0.5 * (x * math.sqrt(x * x - 1.0) - math.acosh(x))
        low, high = (x, high) if gap < _DECADES * layer_ratio else (low, x)
    return high


def rough_pressure(*, layer_ratio: float, strips: int) -> RoughPressure:
    r"""Normal pressure of cylinders with asperities between them, symmetric in x.

    .. math:: s \ln p(x) + \frac1\pi \int p(x') \ln\frac1{|x - x'|}\,\mathrm dx' + \frac{x^2}2 = C, \qquad
              \int p\,\mathrm dx = \frac\pi2

    ``layer_ratio`` is s = u_0 R/a^2, positive [-], ``strips`` an even number. A ``NoSolutionError`` if Newton's method
    does not converge.

    Notes
    -----
    Of second order in the width of the strips. The derivative of the equation, times :math:`x p` and integrated, gives
    the mean square of x exactly: :math:`(1 + 4 s)/4`.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, sections 2.3 and 13.5; B. N. J. Persson, Phys. Rev. Lett. 99 (2007) 125502
    (the exponential).
    """
    width = 2.0 * _reach(layer_ratio) / strips
    x = width * (0.5 * (strips - 1) - np.arange(strips))
    compliance = np.asarray(
        strip_integral(
            jnp.asarray(x[:, None] - x[None, :]),
            pixel_size=jnp.asarray(width),
            reference_distance=jnp.asarray(1.0),
        )
    )
    beyond = np.maximum(np.abs(x), 1.0)
    gap = 0.5 * (beyond * np.sqrt(beyond**2 - 1.0) - np.arccosh(beyond))
    logarithm = 0.5 * np.log(np.maximum(1.0 - x**2, 1e-4)) - gap / layer_ratio
    constant = 0.5
    for _ in range(_STEPS):
        pressure = np.exp(logarithm)
        misfit = layer_ratio * logarithm + compliance @ pressure + 0.5 * x**2 - constant
        jacobian = np.block(
            [
                [compliance * pressure + layer_ratio * np.eye(strips), -np.ones((strips, 1))],
                [width * pressure[None, :], np.zeros((1, 1))],
            ]
        )
        change = np.linalg.solve(jacobian, -np.append(misfit, width * pressure.sum() - 0.5 * math.pi))
        size = float(np.max(np.abs(change[:strips])))
        step = min(1.0, 2.0 / size)
        logarithm, constant = logarithm + step * change[:strips], constant + step * change[strips]
        if size < _TOLERANCE:
            logarithm = 0.5 * (logarithm + logarithm[::-1])
            return RoughPressure(layer_ratio, x, np.exp(logarithm), compliance)
    raise NoSolutionError(f"pressure of rough cylinders, layer ratio {layer_ratio:g}: not converged")


class _Bundle:
    """The springs under every strip, in groups that touch between one strip and the next on the way in."""

    def __init__(self, contact: RoughPressure, stiffness_ratio: float) -> None:
        self.strips = contact.pressure.size
        half = self.strips // 2
        s, share = contact.layer_ratio, contact.pressure[:half]
        before = np.append(0.0, share[:-1])
        self.ratio = stiffness_ratio
        self.depth = s * np.log(contact.pressure)  # minus the separation
        self.weight = (share - before) / s
        moment = s * share * (np.log(share) - 1.0)
        moment[1:] -= moment[:-1].copy()
        self.place = moment / (s * self.weight)  # where the group touches, the mean
        self.growth = np.append(np.inf, np.diff(self.depth[:half]))

    def tractions(self, shift: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Tractions of all strips from the growth of the displacement, and their derivatives."""
        n, half = self.strips, self.strips // 2
        force, since, slope = np.zeros(half), np.zeros(half, dtype=int), np.zeros(half)
        traction, derivative = np.zeros(n), np.zeros((n, n))
        for i in range(n):
            touching = min(i + 1, n - i)
            older = slice(0, min(i, n - i))
            limit = self.depth[i] - self.place[older]
            trial = force[older] + self.ratio * shift[i]
            slips = np.abs(trial) >= limit
            force[older] = np.where(slips, np.sign(trial) * limit, trial)
            since[older] = np.where(slips, i, since[older])
            slope[older] = np.where(slips, 0.0, slope[older])
            if i < half:  # springs that touch on the way from the last strip share its shift
                limit, angle = self.depth[i] - self.place[i], self.ratio * shift[i] / self.growth[i]
                force[i], since[i] = limit * np.clip(angle, -1.0, 1.0), i
                slope[i] = limit / self.growth[i] if abs(angle) < 1.0 else 0.0
            weight, start = self.weight[:touching], since[:touching]
            traction[i] = weight @ force[:touching]
            derivative[i, 1 : i + 1] = np.cumsum(np.bincount(start, weights=weight, minlength=n))[:i]
            derivative[i] += np.bincount(start, weights=weight * slope[:touching], minlength=n)
        return traction, self.ratio * derivative


def rough_rolling(
    contact: RoughPressure, *, stiffness_ratio: float, slip_ratio: float, start: RoughRolling | None = None
) -> RoughRolling:
    r"""Steady rolling of rough cylinders under a tangential force.

    .. math:: \frac{\mathrm d}{\mathrm dx}\left[w(x) + u(x)\right] + \xi = 0

    with the displacement w of the asperities and that of the half-planes u; the contact rolls towards positive x.

    Parameters
    ----------
    contact : RoughPressure
        Normal contact.
    stiffness_ratio : float
        kappa, tangential over normal stiffness of the asperities; across the rolling direction times
        :func:`asperity.contact.skew.lateral_compliance_ratio`, and creepage and displacements are then over that [-].
    slip_ratio : float
        Q/(mu N), from 0 to below 1 [-].
    start : RoughRolling or None, optional
        A state under a smaller force, from which the search starts; None for the state without slip.

    Returns
    -------
    RoughRolling
        Creepage and traction.

    Raises
    ------
    NoSolutionError
        If Newton's method does not converge.

    Notes
    -----
    Of second order in the width of the strips: with 240 strips the creepage over Carter's is within 0.0005 for s from
    0.05 on; smaller ratios need finer strips. Like bodies, or unlike ones whose pressure shears nothing.

    References
    ----------
    M. Ciavarella, J. Mech. Phys. Solids 46 (1998) 2391; J. Jäger, ASME J. Tribol. 120 (1998) 677 (superposition);
    V. L. Popov and M. Heß, Method of Dimensionality Reduction, 2015 (bundles of springs); J. J. Kalker,
    Three-Dimensional Elastic Bodies in Rolling Contact, 1990 (rolling).
    """
    n, width = contact.position.size, float(contact.position[0] - contact.position[1])
    bundle = _Bundle(contact, stiffness_ratio)
    transport = contact.compliance - np.vstack([contact.compliance[:1], contact.compliance[:-1]])
    scale = np.append(np.full(n, width), 1.0)

    def equations(x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        traction, derivative = bundle.tractions(x[:n])
        misfit = np.append(
            x[:n] + transport @ traction - width * x[n], width * traction.sum() - 0.5 * math.pi * slip_ratio
        )
        misfit[0] = x[0]
        jacobian = np.eye(n + 1)
        jacobian[1:n, :n] += (transport @ derivative)[1:]
        jacobian[1:n, n] = -width
        jacobian[n, :n], jacobian[n, n] = width * derivative.sum(axis=0), 0.0
        return misfit, jacobian, traction

    if start is None:
        misfit, jacobian, _ = equations(np.zeros(n + 1))
        x = np.linalg.solve(jacobian, -misfit)
    else:
        x = np.append(start.shift, start.creepage)
    misfit, jacobian, traction = equations(x)
    for _ in range(_STEPS):
        if np.max(np.abs(misfit / scale)) < _TOLERANCE:
            return RoughRolling(float(x[n]), traction, x[:n])
        if not np.any(jacobian[n]):  # every spring slips: the force does not depend on the creepage
            jacobian[n, n] = 1.0
        change = np.linalg.solve(jacobian, -misfit)
        step, size = 1.0, np.linalg.norm(misfit / scale)
        while True:
            trial = equations(x + step * change)
            if np.linalg.norm(trial[0] / scale) < size or step < 1e-3:
                break
            step *= 0.5
        x = x + step * change
        misfit, jacobian, traction = trial
    raise NoSolutionError(f"rolling of rough cylinders, slip ratio {slip_ratio:g}: not converged")
