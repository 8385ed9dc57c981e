r"""Wind-up of a joint under torque (A9): torque–angle curve, hysteresis loop, lost motion, catalogue stages.

The loading curve is the integral of the incremental compliance, with the forces solved anew at every torque:

.. math:: \varphi(T) = \int_0^T \frac{dT'}{K(T')}

Unloading and reloading follow Masing's rule, the loading curve doubled in both directions from the turning point:
:math:`\varphi_u(T) = \varphi(T_m) - 2\,\varphi\bigl((T_m - T)/2\bigr)`.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Literal

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.errors import InputError, NoSolutionError
from asperity.joint.evaluation import Joint, evaluate
from asperity.precision import require_double_precision
from asperity.types import Real

StiffnessLevel = Literal["published", "series_with_bulk", "assembly"]

#: Share of the largest torque at which reducer makers read the lost motion.
LOST_MOTION_TORQUE_SHARE = 0.03

_PANELS = 40
_NODES = 4


class Windup(eqx.Module):
    """Torque–angle behaviour at the output with the sun locked. SI units.

    Parameters
    ----------
    torque : Array
        Torques of the loading curve from 0 to the largest, shape (n,) [N·m].
    stiffness : Array
        Incremental stiffness on the loading curve, shape (n,) [N·m/rad].
    angle : Array
        Loading curve, shape (n,) [rad].
    loop_torque : Array
        Torques of the unloading branch from the largest down to its negative, shape (n,) [N·m].
    unloading_angle, reloading_angle : Array
        Both branches of the loop at ``loop_torque``, shape (n,) [rad].
    hysteresis : Array
        Width of the loop at zero torque [rad].
    lost_motion : Array
        Angle between the loop's middle line at +3 % and at −3 % of the largest torque [rad].
    dissipated_energy : Array
        Area of the loop [J].
    stage_torque : Array
        Torques that bound the catalogue stages: 0, T1, T2, largest; shape (4,) [N·m].
    stage_stiffness : Array
        K1, K2, K3: secant stiffness of the loading curve in each stage, shape (3,) [N·m/rad].
    """

    torque: Array
    stiffness: Array
    angle: Array
    loop_torque: Array
    unloading_angle: Array
    reloading_angle: Array
    hysteresis: Array
    lost_motion: Array
    dissipated_energy: Array
    stage_torque: Array
    stage_stiffness: Array


def _breakpoints(stage_shares: tuple[float, float]) -> np.ndarray:
    """Shares of the largest torque: even panels, the stage bounds, and where the loop is read."""
    even = np.linspace(0.0, 1.0, _PANELS + 1)
    read = [0.5 * (1.0 - LOST_MOTION_TORQUE_SHARE), 0.5, 0.5 * (1.0 + LOST_MOTION_TORQUE_SHARE)]
    shares = np.concatenate([even, read, stage_shares])
    return np.unique(
        np.round(np.concatenate([shares, 1.0 - shares]), 12)
    )  # symmetric: the loop closes on its own points


def windup_of(
    stiffness: Callable[[Array], Array], *, largest_torque: Real, stage_shares: tuple[float, float]
) -> Windup:
    """Integrate a torque-dependent stiffness into the loading curve and the hysteresis loop.

    Parameters
    ----------
    stiffness : callable
        Incremental stiffness on first loading [N·m/rad] at an array of torques [N·m].
    largest_torque : Real
        Largest torque T_m > 0 [N·m].
    stage_shares : tuple of float
        Bounds T1/T_m and T2/T_m of the catalogue stages [-], 0 < T1 < T2 < T_m.

    Returns
    -------
    Windup
        The curves and their figures.

    Raises
    ------
    InputError
        If the torque or the stages are out of range.

    Notes
    -----
    Gauss–Legendre integration, four points on each of some forty panels.

    References
    ----------
    Equation (A9) of :doc:`/equations`; G. Masing, Proc. 2nd Int. Congr. Appl. Mech., Zurich 1926, 332;
    R. D. Mindlin and H. Deresiewicz, J. Appl. Mech. 20 (1953) 327.
    """
    first, second = stage_shares
    if not 0.0 < first < second < 1.0:
        raise InputError(
            f"stage bounds {first:g} and {second:g} of the largest torque are out of order; "
            "allowed 0 < first < second < 1"
        )
    if not np.isfinite(float(largest_torque)) or float(largest_torque) <= 0.0:
        raise InputError(f"largest torque {float(largest_torque):g} N·m must be positive and finite")
    shares = _breakpoints(stage_shares)
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    widths = np.diff(shares)
    inner = shares[:-1, None] + 0.5 * widths[:, None] * (1.0 + nodes)
    torques = jnp.asarray(np.concatenate([shares, inner.ravel()])) * largest_torque
    stiffness_at = stiffness(torques)
    compliance = weights / stiffness_at[shares.size :].reshape(inner.shape)
    half_widths = 0.5 * largest_torque * widths
    angle = jnp.concatenate([jnp.zeros(1), jnp.cumsum(jnp.sum(compliance, axis=1) * half_widths)])
    work = jnp.sum(jnp.sum(compliance * inner, axis=1) * half_widths) * largest_torque  # integral of T d phi
    torque = torques[: shares.size]

    def at(share: float) -> Array:
        return angle[int(np.argmin(np.abs(shares - share)))]

    def unloading(share: float) -> Array:
        return angle[-1] - 2.0 * at(0.5 * (1.0 - share))

    unloading_angle = angle[-1] - 2.0 * angle  # at T_m − 2 T_k: Masing doubles both axes
    bounds = jnp.array([0.0, first, second, 1.0])
    stage_angle = jnp.stack([at(0.0), at(first), at(second), at(1.0)])
    small = LOST_MOTION_TORQUE_SHARE
    return Windup(
        torque=torque,
        stiffness=stiffness_at[: shares.size],
        angle=angle,
        loop_torque=largest_torque - 2.0 * torque,
        unloading_angle=unloading_angle,
        reloading_angle=-unloading_angle[::-1],  # the unloading branch turned about the origin
        hysteresis=2.0 * unloading(0.0),
        lost_motion=unloading(small) - unloading(-small),
        dissipated_energy=4.0 * (2.0 * work - largest_torque * angle[-1]),  # both branches by Masing's rule
        stage_torque=bounds * largest_torque,
        stage_stiffness=jnp.diff(bounds) * largest_torque / jnp.diff(stage_angle),
    )


def windup(
    joint: Joint,
    *,
    largest_torque: Real,
    level: StiffnessLevel,
    stage_shares: tuple[float, float],
) -> Windup:
    """Load a joint up to a torque, and follow the hysteresis loop between plus and minus that torque.

    Parameters
    ----------
    joint : Joint
        One joint; its own output torque is replaced.
    largest_torque : Real
        Largest output torque T_m [N·m], below the capacity.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness is integrated.
    stage_shares : tuple of float
        Bounds T1/T_m and T2/T_m of the catalogue stages [-], 0 < T1 < T2 < T_m.

    Returns
    -------
    Windup
        The curves and their figures.

    Raises
    ------
    InputError
        If the torque or the stages are out of range, or a contact slips grossly below the largest torque.
    NoSolutionError
        If the force balance does not close somewhere.

    Notes
    -----
    Masing's rule holds for friction
    with a fixed normal load; where the normal forces change with the torque the loop is an estimate, because it takes
    the whole curvature of the loading curve as slip. The other direction of torque is the mirror image.

    References
    ----------
    Equation (A9) of :doc:`/equations`; G. Masing, Proc. 2nd Int. Congr. Appl. Mech., Zurich 1926, 332;
    R. D. Mindlin and H. Deresiewicz, J. Appl. Mech. 20 (1953) 327.
    """
    require_double_precision()

    def stiffness(torques: Array) -> Array:
        batch = dataclasses.replace(joint, output_torque=torques)
        result = compile_fast(evaluate, batch)(batch)
        if not bool(jnp.all(result.solved)):
            raise NoSolutionError(
                f"the force balance does not close everywhere up to {float(largest_torque):g} N·m; "
                "check radii and preload"
            )
        slips = np.any(np.asarray(result.diagnostics.slip_ratio) >= 1.0, axis=0)
        if np.any(slips):
            raise InputError(
                f"largest torque {float(largest_torque):g} N·m is past the capacity: a contact slips at "
                f"{float(np.min(np.asarray(torques)[slips])):.4g} N·m at the latest; lower the torque or raise "
                "preload or friction"
            )
        level_of = {
            "published": result.published,
            "series_with_bulk": result.series_with_bulk,
            "assembly": result.assembly.stiffness,
        }
        found = jnp.asarray(level_of[level].output)
        if not bool(jnp.all(found > 0.0)):
            raise InputError(
                "the joint has no stiffness here: every contact spot is plastic; smooth the surfaces or load more"
            )
        return found

    return windup_of(stiffness, largest_torque=largest_torque, stage_shares=stage_shares)
