r"""Branches of given sizes, standing or in rolling: one common angle or speed loss, and the place of the sun."""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import jax.numpy as jnp
import numpy as np
from scipy.optimize import brentq, root

from asperity.drive.geometry import CONTACT_NAMES
from asperity.drive.unequal_branches import (
    added_interference,
    branch_directions,
    force_on_carrier,
    force_on_ring,
    force_on_sun,
)
from asperity.errors import NoSolutionError
from asperity.joint.branch_law import MEMBERS, BranchLaw
from asperity.joint.branch_results import BranchCapacity, BranchState
from asperity.joint.branch_sizes import BranchSizes, refuse_wide
from asperity.joint.working_loads import loads_at_rest

if TYPE_CHECKING:
    from asperity.joint.branches import BranchedJoint

#: Share of a branch's torque below which its contacts are looked at [-].
JUST_BELOW = 1e-9
_LEAST_SUPPORT = 1e-9  # over preload per interference: holds a floating sun where nothing else does
# shares below the first slip at which its contacts are looked at, until all of them have a state
_BELOW_SLIP = (1e-9, 1e-6, 1e-4, 1e-3, 1e-2)
_TOLERANCE = 1e-13
_CLOSE = 1e-10  # what may be left of preload and torque where both are found at once
_STEP = 1e-5  # in a difference quotient, of the angle or speed loss or of the interference
_HALVINGS, _ROUGHLY, _NEWTON_STEPS = 60, 12, 40


class BranchPoints(NamedTuple):
    """How branches share torques: each as a drive all of whose branches are like it. Branches last.

    Parameters
    ----------
    preload, torque : ndarray
        Preload of each, and the torque of that drive, without the sense of the joint's torque, shape (torques, n) [N],
        [N·m].
    slips : ndarray
        Which of them slip as a whole, shape (torques, n).
    moving_sun : ndarray
        By what the torque grows where the sun gives way, over that where it is held, in a small further rotation or
        speed loss, shape (torques,) [-].
    carried : ndarray
        Whether the branches carry the torque, shape (torques,); where they do not, nothing else holds.
    """

    preload: np.ndarray
    torque: np.ndarray
    slips: np.ndarray
    moving_sun: np.ndarray
    carried: np.ndarray


class BranchSolver:
    """Branches of given sizes, standing or in rolling: one common angle or speed loss decides everything."""

    def __init__(
        self, drive: BranchedJoint, sizes: BranchSizes, law: BranchLaw, *, turns: bool, slip: bool
    ) -> None:
        self.drive, self.sizes, self.law, self.turns, self.slip = drive, sizes, law, turns, slip
        self.radial, _ = branch_directions(drive.count)
        none = {"planet": 0.0, "right_roller": 0.0, "left_roller": 0.0}
        self.per_approach = float(added_interference(rest=drive.rest, approach=1.0, **none))
        own = added_interference(
            rest=drive.rest,
            approach=0.0,
            planet=jnp.asarray(sizes.planet),
            right_roller=jnp.asarray(sizes.right_roller),
            left_roller=jnp.asarray(sizes.left_roller),
        )
        self.own = drive.interference + np.asarray(own)
        self.origin = self._last = np.zeros(2)
        if not turns:
            self.origin = self._found(lambda moved: self._loads(np.zeros(drive.count), moved)[2])

    def lengths(self, displacement: np.ndarray) -> np.ndarray:
        """Interference of each branch, by places of the sun of shape (..., 2) [m]."""
        return self.own + self.per_approach * (displacement @ self.radial.T)

    def _demands(self, common: float | np.ndarray, displacement: np.ndarray) -> np.ndarray:
        even = np.repeat(np.asarray(common)[..., None], self.drive.count, axis=-1)
        return even if self.turns else even + self.drive.sun_turns(displacement - self.origin)

    def _loads(
        self, demand: np.ndarray, displacement: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Preload, share of the capacity, and the force on the sun."""
        preload = self.drive.preload(self.lengths(displacement))
        share = self.law.share(preload, demand)
        normal, tangential = self.law.sun_forces(preload, share)
        return preload, share, force_on_sun(normal=normal, tangential=tangential)

    def displacement(self, common: float) -> np.ndarray:
        """Displacement of the sun at an angle or a speed loss [m]."""
        return self._found(lambda moved: self._loads(self._demands(common, moved), moved)[2])

    def _found(self, force_at: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
        """Displacement of the sun at which its bearings balance the planets [m]."""
        force, held = self.drive.own_preload, np.zeros(2)
        if math.isinf(self.sizes.sun_support_stiffness):
            return held
        size, support = self.drive.interference, self._support()

        def misfit(scaled: np.ndarray) -> np.ndarray:
            moved = scaled * size
            return (force_at(moved) - support * moved) / force

        if np.max(np.abs(misfit(held))) < _TOLERANCE:
            return held
        found = root(misfit, self._last, method="hybr", options={"xtol": 1e-12})
        left = float(np.max(np.abs(misfit(found.x))))
        if left > 1e-6:
            raise NoSolutionError(
                f"no place was found at which the bearings of the sun balance its branches: {left:.1g} of the preload "
                "are left; hold the sun, by leaving out compliance.sun_support_stiffness, or state smaller deviations"
            )
        self._last = found.x  # near the next one
        return np.asarray(found.x * size)

    def total(self, common: float) -> float:
        """Torque of all branches [N·m]."""
        moved = self.displacement(common)
        preload, share, _ = self._loads(self._demands(common, moved), moved)
        return float(np.mean(self.law.torque(preload, share)))

    def _beyond(self, torque: float, common: float) -> float:
        return self.total(common) - torque

    def _most(self) -> float:
        """An angle or speed loss at which all branches slip."""
        most = 3.0 * self.drive.preload(np.array([np.max(self.own), self.drive.interference])).max()
        return 3.0 * float(self.law.demand_at_slip(min(most, float(self.law.preloads[-1]))))

    def under(self, torque: float) -> BranchState | None:
        """The state under a torque; None where all branches slip below it."""
        most = self._most()
        if torque > 0.0 and self.total(most) < torque:
            return None
        (common,), _ = self._places(np.array([torque]), most)
        state = self.at(float(common))
        whole = float(np.sum(state.torque))
        # the common angle is found to rounding only
        return dataclasses.replace(state, torque=state.torque * (torque / whole)) if whole > 0.0 else state

    def points(self, torques: np.ndarray) -> BranchPoints:
        """How the branches share torques without sign, shape (torques,), all of them at once."""
        most = self._most()
        carried = (torques <= self.total(most)) | (torques == 0.0)
        common, moved = self._places(np.where(carried, torques, 0.0), most)
        refuse_wide(self.lengths(moved), self.drive.interference)
        preload, share, _ = self._loads(self._demands(common, moved), moved)
        own = self.law.torque(preload, share)
        whole = np.mean(own, axis=-1)
        to_the_torque = np.where(whole > 0.0, torques / np.where(whole > 0.0, whole, 1.0), 1.0)
        return BranchPoints(
            preload=preload,
            torque=own * to_the_torque[:, None],
            slips=np.abs(share) >= 1.0,
            moving_sun=self._moving_sun(common, moved),
            carried=carried,
        )

    def _places(self, torques: np.ndarray, most: float) -> tuple[np.ndarray, np.ndarray]:
        """Angle or speed loss and place of the sun under torques that the branches carry."""
        moved = np.tile(self.displacement(0.0), (torques.size, 1))
        held = math.isinf(self.sizes.sun_support_stiffness)
        common = self._with_sun_at(moved, torques, most, halvings=_HALVINGS if held else _ROUGHLY)
        if held:
            return common, moved
        scale = np.array([most, *2 * (self.drive.interference,)])
        found, left = self._newton(np.column_stack([common, moved]) / scale, torques, scale)
        for index in np.flatnonzero(~(left < _CLOSE) & (torques > 0.0)):  # one by one, where that goes astray
            alone = _zero(functools.partial(self._beyond, float(torques[index])), most)
            found[index] = np.append(alone, self.displacement(alone)) / scale
        found = np.where(
            torques[:, None] > 0.0, found * scale, np.column_stack([np.zeros(torques.size), moved])
        )
        return found[:, 0], found[:, 1:]

    def _with_sun_at(
        self, moved: np.ndarray, torques: np.ndarray, most: float, *, halvings: int
    ) -> np.ndarray:
        """Angle or speed loss under torques where the sun is held at places, by halving."""
        low, high = np.zeros(torques.size), np.full(torques.size, most)
        for _ in range(halvings):
            middle = 0.5 * (low + high)
            preload, share, _ = self._loads(self._demands(middle, moved), moved)
            more = np.mean(self.law.torque(preload, share), axis=-1) < torques
            low, high = np.where(more, middle, low), np.where(more, high, middle)
        return np.where(torques > 0.0, 0.5 * (low + high), 0.0)

    def _newton(
        self, start: np.ndarray, torques: np.ndarray, scale: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """Scaled angles or speed losses and places of a sun that gives way, and what is left of preload and torque."""
        wanted = np.where(torques > 0.0, torques, 1.0)
        support, force = self._support(), self.drive.own_preload

        def misfit(scaled: np.ndarray) -> np.ndarray:
            common, moved = scaled[..., 0] * scale[0], scaled[..., 1:] * scale[1:]
            preload, share, sun = self._loads(self._demands(common, moved), moved)
            missing = np.mean(self.law.torque(preload, share), axis=-1) / wanted - 1.0
            return np.concatenate([missing[..., None], (sun - support * moved) / force], axis=-1)

        found, steps = start, np.eye(3)[:, None, :] * _STEP
        left = misfit(found)
        for _ in range(_NEWTON_STEPS):
            size = np.max(np.abs(left), axis=-1)
            if np.all((size < _CLOSE) | (torques <= 0.0)):
                break
            slopes = (misfit(found + steps) - misfit(found - steps)) / (2.0 * _STEP)  # (3 in, torques, 3 out)
            matrix = np.moveaxis(slopes, 0, -1) + 1e-14 * np.eye(3)
            ahead = -np.linalg.solve(matrix, left[..., None])[..., 0]
            for share in (1.0, 0.5, 0.25, 0.1, 0.01):  # the shortest of them, where no other is better
                tried = found + share * ahead
                there = misfit(tried)
                better = np.max(np.abs(there), axis=-1) < size
                take = (better | (share == 0.01)) & (size >= _CLOSE)
                found, left = np.where(take[:, None], tried, found), np.where(take[:, None], there, left)
                size = np.where(take, 0.0, size)  # done in this step
        return found, np.where(found[:, 0] >= 0.0, np.max(np.abs(left), axis=-1), np.inf)

    def _support(self) -> float:
        """Stiffness of the sun's bearings; a little where nothing holds it [N/m]."""
        least = _LEAST_SUPPORT * self.drive.own_preload / self.drive.interference
        return max(self.sizes.sun_support_stiffness, least)

    def _moving_sun(self, common: np.ndarray, moved: np.ndarray) -> np.ndarray:
        """How much more or less torque a further angle or speed loss takes where the sun gives way to it."""
        if math.isinf(self.sizes.sun_support_stiffness):
            return np.ones(common.size)
        support = self._support()

        def loads(point: np.ndarray) -> np.ndarray:
            preload, share, sun = self._loads(self._demands(point[..., 0], point[..., 1:]), point[..., 1:])
            torque = np.mean(self.law.torque(preload, share), axis=-1)
            return np.concatenate([torque[..., None], sun - support * point[..., 1:]], axis=-1)

        turned = np.maximum(common, 1e-3 * self._most())
        length = np.full(common.size, self.drive.interference)
        steps = _STEP * np.stack([turned, length, length], axis=-1)
        point = np.column_stack([np.maximum(common, steps[:, 0]), moved])
        apart = np.eye(3)[:, None, :] * steps
        slopes = (loads(point + apart) - loads(point - apart)) / (
            2.0 * steps.T[..., None]
        )  # (3 in, torques, 3 out)
        held = slopes[0, :, 0]
        by_place = np.moveaxis(slopes[1:, :, 1:], 0, -1)  # (torques, 2 out, 2 in)
        way = -np.linalg.solve(by_place, slopes[0, :, 1:, None])[..., 0]
        more = np.sum(slopes[1:, :, 0].T * way, axis=-1)
        return np.where(held > 0.0, 1.0 + more / np.where(held > 0.0, held, 1.0), 1.0)

    def at(self, common: float) -> BranchState:
        """The state at an angle or a speed loss."""
        moved = self.displacement(common)
        refuse_wide(self.lengths(moved), self.drive.interference)
        preload, share, force = self._loads(self._demands(common, moved), moved)
        torque = self.law.torque(preload, share)
        slip, known = np.full((len(CONTACT_NAMES), self.drive.count), np.nan), {}
        if self.slip:
            known = self._contacts(preload, torque * (1.0 - JUST_BELOW), loaded=self.turns or common > 0.0)
            slip = known.pop("slip_ratio")
        return BranchState(
            preload=preload,
            torque=torque / self.drive.count,
            slip_ratio=np.where(preload > 0.0, np.where(share >= 1.0, 1.0, np.max(slip, axis=0)), np.nan),
            sun_displacement=moved,
            # the bearings of a floating sun bear nothing; what is left of the search is rounding
            sun_force=force if self.sizes.sun_support_stiffness > 0.0 else np.zeros(2),
            **known,
        )

    def _contacts(self, preload: np.ndarray, torque: np.ndarray, *, loaded: bool) -> dict[str, Any]:
        """What the contacts of each branch do, as fields of its state, without the tables; or the preload alone."""
        drive, bears = self.drive, preload > 0.0
        found = drive.laws.states(preload, torque)
        prefix = "rolling_" if self.turns else ""
        limits = ("shakedown_ratio", "life_hours") if self.turns else ("pressure_over_first_yield",)
        forces = np.stack([found[f"{prefix}{kind}"] for kind in ("normal", "tangential")])
        pins = found[f"{prefix}pins"]
        if not loaded:
            forces = np.stack([np.outer(drive.rest.normal_force, preload), np.zeros(forces.shape[1:])])
            free = loads_at_rest(dataclasses.replace(drive.joint, preload=1.0))
            pins = np.stack([free.pin_radial, free.pin_tangential])[..., None] * preload
        forces, pins = (np.where(bears, each, 0.0) for each in (forces, pins))
        speed = np.max(np.where(bears, found["bearing_speed"], 0.0), axis=-1)
        torques = {
            name: float(all_together(found[f"{prefix}{name}_torque"], bears, drive.friction[name]))
            for name in MEMBERS
        }
        return {
            "slip_ratio": found[f"{prefix}slip_ratio"],
            "limits": {name: found[name] for name in limits},
            "pins": pins,
            "contact_forces": forces,
            "centre_forces": {
                "carrier": force_on_carrier(radial=pins[0], tangential=pins[1], polar=drive.polar),
                "ring": force_on_ring(normal=forces[0, 3:], tangential=forces[1, 3:], polar=drive.polar),
            },
            "bearing_speed": speed if self.turns else np.zeros_like(speed),
            "torques": torques if loaded else {},
            "input_torque": torques["sun"] if loaded else 0.0,
            "speeds": dict(zip(("sun", "carrier"), speed[2:], strict=True)) if self.turns else {},
        }

    def _used(self, common: float) -> float:
        """How far the branch nearest to slip is wound up or creeps, over that at which it slips."""
        moved = self.displacement(common)
        preload = self.drive.preload(self.lengths(moved))
        bears = preload > 0.0
        return float(np.max(self._demands(common, moved)[bears] / self.law.demand_at_slip(preload[bears])))

    def capacity(self) -> BranchCapacity:
        """Torque at the first slip, and that at which all branches slip."""
        most = self._most()
        first = _zero(lambda x: self._used(x) - 1.0, most)
        moved = self.displacement(first)
        preload = self.drive.preload(self.lengths(moved))
        over = np.where(
            preload > 0.0,
            self._demands(first, moved) / self.law.demand_at_slip(np.maximum(preload, 1e-9)),
            0.0,
        )
        branch = int(np.argmax(over))
        slips = np.full(len(CONTACT_NAMES), np.nan)
        for below in _BELOW_SLIP if self.slip else ():
            almost = self.law.torque(preload, np.minimum(over, 1.0) * (1.0 - below))
            slips = self._contacts(preload, almost, loaded=True)["slip_ratio"][:, branch]
            if np.all(np.isfinite(slips)):
                break
        return BranchCapacity(
            first_slip=self.total(first),
            branch=branch,
            contact=int(np.nanargmax(slips)) if np.any(np.isfinite(slips)) else None,
            all_slip=self.total(most),
            equal=float(self.law.capacity(self.drive.own_preload)),
        )


def all_together(each: np.ndarray, bears: np.ndarray, common: float) -> np.ndarray:
    """What all branches do together, from what the drive would do if all were like each.

    Parameters
    ----------
    each : ndarray
        What the drive would do if all branches were like one, branches last.
    bears : ndarray
        Which branches are not loose; a loose one does nothing.
    common : float
        The part of each that no branch does.

    Returns
    -------
    ndarray
        Without the axis of the branches.
    """
    own = np.where(bears, each - common, 0.0)
    return np.asarray(np.sum(own, axis=-1) / bears.size + common)


def _zero(function: Callable[[float], float], upper: float) -> float:
    return float(brentq(function, 0.0, upper, xtol=1e-15 * upper, rtol=1e-14))
