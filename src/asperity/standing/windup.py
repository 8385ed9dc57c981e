r"""Wind-up of a joint under torque (A9): torque–angle curve, hysteresis loop, lost motion, catalogue stages.

The loading curve in either direction is the integral of the incremental compliance, with the forces solved anew at
every torque, and the play:

.. math:: \varphi(T) = \int_0^T \frac{dT'}{K(T')} + \varphi_p(T)

What slips is the difference to the curve without slip (infinite friction, the same normal forces), averaged over both
directions:

.. math::
    \gamma(T) = \tfrac12 \int_0^T \left[\frac1{K(T')} - \frac1{K_\infty(T')} + \frac1{K(-T')} - \frac1{K_\infty(-T')}
    \right] dT', \quad T \ge 0

Only this part follows Masing's rule; the rest :math:`\rho(T) = \varphi(T) - \operatorname{sgn}(T)\,\gamma(|T|)` is
reversible. The unloading branch from :math:`T_m` is :math:`\rho(T) + \gamma(T_m) - 2\,\gamma\bigl((T_m - T)/2\bigr)`.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable
from typing import Any, Literal, NamedTuple

import numpy as np

from asperity.drive.layout.mirror import mirror_image
from asperity.drive.state.state import SLIP_TOLERANCE
from asperity.engine.module import Module, same_numbers
from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.play import Play, play_angle, play_compliance
from asperity.standing import STAGE_SHARES
from asperity.standing.standing import Standing, standing_at
from asperity.types import Real
from asperity.units import format_apart, format_quantity

StiffnessLevel = Literal["published", "series_with_bulk", "assembly"]

#: Share of the largest torque at which makers of reducers read the lost motion.
LOST_MOTION_TORQUE_SHARE = 0.03

_STEPS = 40

#: Gauss nodes of a panel by the share of the largest torque at its end: slip grows without bound towards the capacity,
#: and only near it the compliance is far from a polynomial.
_NODES = ((0.6, 2), (0.95, 3), (1.0, 10))
#: Panels that end before a torque at which a contact begins to slide, each a quarter of the one before it, and their
#: nodes: there the compliance grows without bound.
_GRADED, _GRADED_NODES = 8, 4
#: How exactly these torques are sought, over the largest, and how many points each search takes.
_SLIP_TOLERANCE, _SEARCHED = 1e-8, 50


class Windup(Module):
    """Torque–angle behaviour at the output with the input locked. SI units.

    Parameters
    ----------
    torque : ndarray
        Torques of the loading curves from minus to plus the largest, shape (2n − 1,) [N·m].
    stiffness : ndarray
        Incremental stiffness on first loading in either direction, shape (2n − 1,) [N·m/rad].
    angle : ndarray
        Loading curves in both directions, shape (2n − 1,) [rad].
    slip_angle : ndarray
        Share of slip in ``angle``, gamma with the sign of the torque, shape (2n − 1,) [rad]; the rest is reversible.
    unloading_angle, reloading_angle : ndarray
        Both branches of the loop at ``torque``, shape (2n − 1,) [rad].
    hysteresis : ndarray
        Width of the loop at zero torque [rad].
    lost_motion : ndarray
        Angle between the loop's middle line at +3 % and at −3 % of the largest torque [rad].
    dissipated_energy : ndarray
        Area of the loop [J].
    stage_torque : ndarray
        Torques that bound the catalogue stages: 0, T1, T2, largest; shape (4,) [N·m].
    stage_stiffness, reverse_stage_stiffness : ndarray
        K1, K2, K3: secant stiffness of the loading curve in each stage, for positive and for negative torques; shape
        (3,) [N·m/rad].
    """

    torque: np.ndarray
    stiffness: np.ndarray
    angle: np.ndarray
    slip_angle: np.ndarray
    unloading_angle: np.ndarray
    reloading_angle: np.ndarray
    hysteresis: np.ndarray
    lost_motion: np.ndarray
    dissipated_energy: np.ndarray
    stage_torque: np.ndarray
    stage_stiffness: np.ndarray
    reverse_stage_stiffness: np.ndarray


def _distinct(shares: np.ndarray) -> np.ndarray:
    ordered = np.sort(shares)
    return ordered[np.diff(ordered, prepend=-1.0) > 1e-12]


class _Panels(NamedTuple):
    """Points between shares of the largest torque: where, their weights, and each panel's first."""

    shares: np.ndarray
    at: np.ndarray
    weight: np.ndarray
    first: np.ndarray

    def integral(self, values: np.ndarray) -> np.ndarray:
        """Of values at the points, from zero to each of the shares."""
        return np.concatenate([np.zeros(1), np.cumsum(np.add.reduceat(self.weight * values, self.first))])

    def index_of(self, share: np.ndarray) -> np.ndarray:
        """Where shares stand among those between which the panels are."""
        return np.abs(self.shares - share[..., None]).argmin(axis=-1)


_gauss_nodes = functools.cache(np.polynomial.legendre.leggauss)


def _panels(shown: np.ndarray, divisions: np.ndarray, steps: int) -> _Panels:
    finer = divisions[:, None] * (1.0 - 0.25 ** np.arange(1, _GRADED + 1) / steps)
    # Masing's rule halves distances along the loop
    shares = _distinct(
        np.concatenate([shown, 0.5 * (1.0 - shown), 0.5 * (1.0 + shown), divisions, finer.ravel()])
    )
    at, weight = [], []
    for start, end in itertools.pairwise(shares):
        count = next(count for bound, count in _NODES if end <= bound)
        if np.any((divisions >= end) & (divisions < end + 2.0 * (end - start))):
            count = max(count, _GRADED_NODES)
        nodes, weights = _gauss_nodes(count)
        at.append(start + 0.5 * (end - start) * (1.0 + nodes))
        weight.append(0.5 * (end - start) * weights)
    first = np.cumsum([0, *(part.size for part in at[:-1])])
    return _Panels(shares, np.concatenate(at), np.concatenate(weight), first)


def windup_of(
    compliances: Callable[[np.ndarray], tuple[Any, Any]],
    *,
    largest_torque: Real,
    stage_shares: tuple[float, float],
    play: Play,
    steps: int = _STEPS,
    divisions: np.ndarray | None = None,
) -> Windup:
    """Integrate a torque-dependent compliance into the loading curves and the hysteresis loop.

    ``compliances`` gives the incremental compliance on first loading, and the same without slip [rad/(N·m)], at an
    array of torques of either sign [N·m]; ``largest_torque`` is T_m > 0 [N·m], ``stage_shares`` are T1/T_m and T2/T_m
    of the catalogue stages [-]; ``play`` is added to every curve. The compliance is integrated between even ``steps``;
    ``divisions`` are shares of the largest torque at which it grows without bound, and goes on beyond. An
    ``InputError`` if the torque or the stages are out of range.

    Notes
    -----
    Gauss–Legendre integration, two to ten points on each of about two panels a step in either direction. The hysteresis
    of the shipped planetary drive errs by 1e-10 with 40 steps and 5e-9 with 20 at 99 % of its capacity, by 1e-8 and
    5e-7 at 99.9 %. Panels are divided, ever finer, before the torques at which a contact begins to slide.

    References
    ----------
    Equation (A9) of :doc:`/equations`; G. Masing, Proc. 2nd Int. Congr. Appl. Mech., Zurich 1926, 332;
    R. D. Mindlin and H. Deresiewicz, J. Appl. Mech. 20 (1953) 327.
    """
    first, second = stage_shares
    if not 0.0 < first < second < 1.0:
        raise InputError(
            f"stage bounds {first:g} and {second:g} (shares of the largest torque) are out of order; "
            "allowed 0 < first < second < 1"
        )
    largest = float(largest_torque)
    if not np.isfinite(largest) or largest <= 0.0:
        raise InputError(f"the largest torque is {largest:g} N·m; it must be positive and finite")
    even = np.linspace(0.0, 1.0, steps + 1)
    shown = _distinct(np.concatenate([even, stage_shares, [LOST_MOTION_TORQUE_SHARE]]))
    panels = _panels(shown, np.zeros(0) if divisions is None else np.asarray(divisions), steps)
    positive = np.concatenate([shown, panels.at])  # at the panels' other ends nobody asks
    sampled = np.stack([positive, -positive]) * largest
    real, without_slip = (np.asarray(law).reshape(sampled.shape) for law in compliances(sampled.ravel()))
    slip = np.mean(real - without_slip, axis=0)
    return _Curves(panels, shown, largest, real, slip).windup(stage_shares, play)


class _Curves(NamedTuple):
    """Compliances at the shown shares of the largest torque and at the points of the panels, forward and reverse."""

    panels: _Panels
    shown: np.ndarray
    largest: float
    real: np.ndarray
    slip: np.ndarray

    def angle(self, compliance: np.ndarray) -> np.ndarray:
        """Angle at each of the shares of the panels [rad]."""
        return self.largest * self.panels.integral(compliance[self.shown.size :])

    def windup(self, stage_shares: tuple[float, float], play: Play) -> Windup:
        """Both curves, and the loop by Masing's rule."""
        panels, shown, largest = self.panels, self.shown, self.largest
        slip_angle, at_shown = self.angle(self.slip), panels.index_of(shown)
        # both counted as positive
        forward, reverse = (self.angle(compliance)[at_shown] for compliance in self.real)
        signed = np.concatenate([-shown[:0:-1], shown])
        torque = signed * largest

        def slip_at(share: np.ndarray) -> np.ndarray:
            return slip_angle[panels.index_of(share)]

        def read(curve: np.ndarray, share: float) -> np.ndarray:
            return curve[int(np.argmin(np.abs(signed - share)))]

        def stages(curve: np.ndarray) -> np.ndarray:
            return np.diff(bounds) * largest / np.diff([read(curve, share) for share in bounds])

        angle = np.concatenate([-reverse[:0:-1], forward])
        angle = angle + np.asarray(play_angle(play=play, output_torque=torque))
        slipped = np.sign(signed) * slip_at(np.abs(signed))
        reversible = angle - slipped
        unloading = reversible + slip_angle[-1] - 2.0 * slip_at(0.5 * (1.0 - signed))
        reloading = reversible - slip_angle[-1] + 2.0 * slip_at(0.5 * (1.0 + signed))
        middle = 0.5 * (unloading + reloading)
        # T d gamma, over T_m
        slip_work = largest * np.sum(panels.weight * self.slip[shown.size :] * panels.at)
        bounds = np.array([0.0, *stage_shares, 1.0])
        compliance = np.concatenate([self.real[1, shown.size - 1 : 0 : -1], self.real[0, : shown.size]])
        return Windup(
            torque=torque,
            stiffness=1.0 / (compliance + np.asarray(play_compliance(play=play, output_torque=torque))),
            angle=angle,
            slip_angle=slipped,
            unloading_angle=unloading,
            reloading_angle=reloading,
            hysteresis=read(unloading, 0.0) - read(reloading, 0.0),
            lost_motion=read(middle, LOST_MOTION_TORQUE_SHARE) - read(middle, -LOST_MOTION_TORQUE_SHARE),
            dissipated_energy=4.0 * largest * (2.0 * slip_work - slip_angle[-1]),  # by Masing's rule
            stage_torque=bounds * largest,
            stage_stiffness=stages(angle),
            reverse_stage_stiffness=stages(-angle[::-1]),
        )


def is_symmetric(joint: Joint) -> bool:
    """Whether a joint behaves alike in both directions of torque."""
    image = None if joint.unlike is not None else mirror_image(joint.drive)
    if image is None:
        return False
    described = (
        *((sizes, image.bodies) for sizes in (joint.shapes, joint.materials)),
        *(
            (values, image.contacts)
            for values in (
                joint.surfaces,
                joint.contact_lengths,
                joint.friction_coefficients,
                joint.pattern,
                joint.crown_curvatures or (),
            )
            if len(values) > 1
        ),
    )
    return all(
        same_numbers(entries[k], entries[other])
        for entries, images in described
        for k, other in enumerate(images)
        if k != other
    )


def windup(
    joint: Joint,
    *,
    largest_torque: Real,
    level: StiffnessLevel,
    stage_shares: tuple[float, float] = STAGE_SHARES,
    steps: int = _STEPS,
) -> Windup:
    """Load a joint up to a torque in both directions, and follow the hysteresis loop between them.

    Parameters
    ----------
    joint : Joint
        One joint; its own output torque is replaced.
    largest_torque : Real
        Largest output torque T_m [N·m], below the capacity of both directions; its sign does not matter.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness is integrated.
    stage_shares : tuple of float, optional
        Bounds T1/T_m and T2/T_m of the catalogue stages [-], 0 < T1 < T2 < T_m.
    steps : int, optional
        Even steps of the torque in each direction.

    Returns
    -------
    Windup
        The curves and their figures.

    Raises
    ------
    InputError
        If the torque or the stages are out of range, or beyond the standing torque capacity.
    NoSolutionError
        If the force balance does not close somewhere.

    Notes
    -----
    Masing's rule is exact for slip under constant normal forces. Here they change with the torque, and the loop is an
    estimate; :doc:`/theory/windup` gives its error.

    References
    ----------
    Equation (A9) of :doc:`/equations`; G. Masing, Proc. 2nd Int. Congr. Appl. Mech., Zurich 1926, 332;
    R. D. Mindlin and H. Deresiewicz, J. Appl. Mech. 20 (1953) 327.
    """
    largest = abs(float(largest_torque))
    mirrored = is_symmetric(joint)
    slid: list[tuple[np.ndarray, np.ndarray]] = []

    def slides(torques: np.ndarray) -> np.ndarray:
        return _slides(standing_at(joint, torques))

    def compliances(torques: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        asked, place = np.unique(np.abs(torques) if mirrored else torques, return_inverse=True)
        standing = standing_at(joint, asked)
        slid.append((asked, _slides(standing)))
        _refuse(standing, asked, largest, joint.contact_names)
        real, elastic = (levels[level][place] for levels in (standing.levels, standing.levels_without_slip))
        if not np.all(real > 0.0):
            raise InputError(
                f"the joint has no {level} stiffness at every torque up to {format_quantity(largest, 'N*m')}: all "
                "contact spots of a contact are plastic; choose smoother surfaces or a higher preload"
            )
        return 1.0 / real, 1.0 / elastic

    integrated = functools.partial(
        windup_of,
        compliances,
        largest_torque=largest,
        stage_shares=stage_shares,
        play=joint.play,
        steps=steps,
    )
    curve = integrated()
    divisions = _divisions(*slid[0], slides, _SLIP_TOLERANCE * largest) / largest
    return integrated(divisions=divisions) if divisions.size else curve


def _slides(standing: Standing) -> np.ndarray:
    """Whether each contact bears all its friction, shape (torques, contacts)."""
    return standing.slip_ratio.T >= 1.0 - SLIP_TOLERANCE


def _divisions(
    torques: np.ndarray, sliding: np.ndarray, slides: Callable[[np.ndarray], np.ndarray], tolerance: float
) -> np.ndarray:
    """Torques, without sign, at which a contact begins to slide, between ascending ones that are known [N·m]."""
    changes = np.nonzero(np.any(sliding[1:] != sliding[:-1], axis=1))[0]
    divisions: list[float] = []
    for k in changes:
        start, end = torques[k], torques[k + 1]
        if end - start <= tolerance:
            divisions.append(float(min(abs(start), abs(end))))
            continue
        between = np.linspace(start, end, _SEARCHED)
        inner = np.vstack([sliding[k], slides(between[1:-1]), sliding[k + 1]])
        divisions += list(_divisions(between, inner, slides, tolerance))
    return np.unique(divisions)


def _refuse(standing: Standing, values: np.ndarray, largest: float, names: tuple[str, ...]) -> None:
    """Refuse torques at which the force balance does not close or friction does not hold."""
    shown = format_quantity(largest, "N*m")
    if not np.all(standing.solved):
        failed = values[~standing.solved]
        raise NoSolutionError(
            f"the force balance has no solution at {format_quantity(failed[np.abs(failed).argmin()], 'N*m')}, which "
            f"is within the largest torque of {shown}; check radii and preload"
        )
    if not np.all(standing.holds):
        first = np.abs(np.where(standing.holds, np.inf, values)).argmin()
        contact = names[int(standing.slip_ratio[:, first].argmax())]
        shown, slips = format_apart(largest, float(values[first]), "N*m")
        raise InputError(
            f"the largest torque {shown} is beyond the standing torque capacity: contact {contact} slips at "
            f"{slips} or less; lower the torque, or raise preload or friction"
        )
