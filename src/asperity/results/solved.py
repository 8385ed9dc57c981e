"""A solved joint, with what is worth computing only when it is asked for."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any, TypeVar

import numpy as np

from asperity.branches.branches import AssembledBranches, assembled_branches
from asperity.contact.laws.registry import LAWS
from asperity.drive.layout.drive import sectors_of_members
from asperity.drive.layout.existence import neighbour_gaps, neighbours
from asperity.drive.state.loads import MemberLoads
from asperity.drive.state.state import STATE_TOLERANCE, ContactLaws
from asperity.engine import trees
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once
from asperity.engine.module import Module
from asperity.errors import InputError, NoSolutionError
from asperity.joint.bearing_lives import BearingLives, joint_bearing_lives
from asperity.joint.capacity import capacity_both_ways
from asperity.joint.description import (
    Joint,
    contact_values,
    in_motion,
    joint_contacts,
    pin_names,
    tracks_of,
    without_duty,
)
from asperity.joint.evaluation import JointResult, evaluated_with_laws
from asperity.joint.housing import Seats, seated, seats
from asperity.joint.mounting import Mounting, mounting
from asperity.joint.rims import joint_rims
from asperity.joint.solve import Solution, joint_state, solution_of
from asperity.joint.temperature import at_temperature, at_temperatures
from asperity.joint.temperature_limits import AtTemperature, TemperatureLimit, temperature_limits
from asperity.joint.torque_limits import TorqueCapacity
from asperity.joint.working_loads import working_loads
from asperity.results.notes import Note, loss_notes, plausibility, rolling_notes, skew_notes
from asperity.results.oil_notes import oil_notes
from asperity.rolling.accuracy import Accuracy, TurnErrors
from asperity.rolling.inlet_heat import film_unknown_because
from asperity.types import Array, Real

_Found = TypeVar("_Found")


class JointSize(Module):
    """Size and mass [kg] of the rolling parts of a drive.

    The envelope is the outer diameter of the largest body on the axis, or of the housing into which a ring is pressed,
    and the length of the longest roller [m], nan with stepped rollers: how far their tracks lie apart along the axis is
    not part of their description.
    """

    envelope_diameter: Array
    envelope_length: Array
    mass: Array

    @property
    def envelope_volume(self) -> Array:
        """Volume of the cylinder around the rolling parts [m^3]."""
        return 0.25 * xp.pi * self.envelope_diameter**2 * self.envelope_length


def _without_torque(joint: Joint, result: JointResult) -> tuple[Joint, JointResult]:
    """A joint that stands without torque, and its result so far as the stresses of its rings go."""
    normal = result.rest.normal
    forces = dataclasses.replace(result.forces, normal=normal, tangential=0.0 * normal)
    width = joint_contacts(joint).pairs.half_width(normal)
    diagnostics = dataclasses.replace(result.diagnostics, hertz_half_width=width)
    standing = dataclasses.replace(joint, input_speed=0.0 * joint.input_speed)
    return standing, dataclasses.replace(result, forces=forces, diagnostics=diagnostics)


#: Why contacts lack what :func:`has_spots` says they have.
ONLY_SPOTS = (
    f"only contacts whose law is {' or '.join(law.name for law in LAWS.values() if law.has_spots)}, which knows their "
    "spots, have it"
)


def has_spots(solved: SolvedJoint) -> tuple[bool, ...]:
    """Which contacts have a law that knows their spots."""
    return (solved.joint.surfaces[0].has_spots,) * len(solved.joint.drive.contacts)


def joint_size(joint: Joint, result: JointResult) -> JointSize:
    """Size and mass of the rolling parts."""
    outer: list[Any] = []
    for number, shape in enumerate(joint.shapes):
        if joint.drive.bodies[number].on_axis:
            wall = 0.0 if shape.kind != "ring" or shape.size is None else shape.size
            outer += [radius + wall for radius, _ in tracks_of(joint, number)]
    if joint.housing is not None and any(seated(joint)):
        outer.append(joint.housing.outer_radius)
    copies = xp.asarray(joint.drive.sectors) / sectors_of_members(joint.drive)[:-1]
    stepped = any(len(tracks_of(joint, number)) > 1 for number in range(len(joint.shapes)))
    stated = [xp.asarray(shape.length) for shape in joint.shapes if shape.length is not None]
    length = xp.nan if stepped else xp.max(xp.stack([*contact_values(joint, joint.contact_lengths), *stated]))
    diameter = 2.0 * xp.max(xp.stack([xp.asarray(radius) for radius in outer]))
    return JointSize(diameter, xp.asarray(length), xp.sum(copies * result.masses))


class SolvedJoint:
    """A solved joint, with what is worth computing only when it is asked for.

    ``result`` is what :func:`asperity.joint.evaluation.evaluated_with_laws` says about the ``joint``, and ``laws``
    likewise, None where nothing is asked for that needs them; ``notes``: comparisons with what is usual, which are
    requirements too; ``branches`` without torque, if their sizes differ.
    """

    joint: Joint
    result: JointResult
    #: What the drive and its rolling bearings have to reach [s], where somebody requires a life.
    required_life: Real | None = None
    #: What its form errors do over a turn, where a file states them; raises NoSolutionError where it does not roll.
    over_turn: Callable[[], Accuracy] | None = None
    #: The sums of that, of a point of a study.
    turn_errors: Callable[[], TurnErrors] | None = None
    #: The largest transmission error that somebody allows [rad].
    allowed_transmission_error: float | None = None
    #: Body → name of its material, where a file names them.
    material_names: Mapping[str, str] = MappingProxyType({})
    #: Of one joint that was solved on its own: what came out.
    solution: Solution

    def __init__(
        self,
        joint: Joint,
        result: JointResult,
        laws: ContactLaws | None,
        notes: tuple[Note, ...] = (),
        branches: AssembledBranches | None = None,
    ) -> None:
        self.joint = joint
        self.result = result
        self.branches = branches
        self.notes = notes
        self.laws = laws
        self._found: dict[Callable[..., Any], Any] = {}

    def once(self, find: Callable[[SolvedJoint], _Found]) -> _Found:
        """What a function finds of this joint, which is looked for once."""
        if find not in self._found:
            self._found[find] = find(self)
        return self._found[find]

    @functools.cached_property
    def bearings(self) -> BearingLives:
        """Lives of the rolling bearings; nothing to compute where none has ratings."""
        if not any(self.has_bearings):
            nothing = xp.full((len(self.has_bearings), *xp.shape(self.result.solved)), xp.nan)
            return BearingLives(nothing, nothing, nothing, nothing, nothing)
        return at_once(self._bearing_lives, self.joint, self.result, self.laws)

    @functools.cached_property
    def rims(self) -> Any:
        """Stresses of ring and hollow rollers."""
        return self._rims(self.joint, self.result)

    @functools.cached_property
    def duty_rims(self) -> tuple[Any, ...]:
        """As ``rims`` under each load of the duty; nan where the joint does not carry it. Of one joint alone."""
        return tuple(self._rims(*state) for state in self.duty_states)

    @property
    def has_bearings(self) -> tuple[bool, ...]:
        """Which rolling bearings have ratings."""
        return tuple(bearing is not None for bearing in self.joint.rated_bearings)

    @functools.cached_property
    def _standing(self) -> TorqueCapacity:
        """Both directions; a study that asks for no other does not search for those in rolling."""
        assert self.laws is not None
        return capacity_both_ways(self.joint, self.result.rest, self.laws, rolls=False)

    @functools.cached_property
    def _rolling(self) -> TorqueCapacity:
        assert self.laws is not None
        return capacity_both_ways(self.joint, self.result.rest, self.laws, rolls=True)

    def _capacity(self, *, rolls: bool, index: Any) -> TorqueCapacity:
        return trees.map(lambda leaf: leaf[index], self._rolling if rolls else self._standing)

    @functools.cached_property
    def standing_capacity(self) -> TorqueCapacity:
        """Torque capacity of positive torques, standing, and what limits it; damage does not count."""
        return self._capacity(rolls=False, index=0)

    @functools.cached_property
    def reverse_standing_capacity(self) -> TorqueCapacity:
        """Torque capacity of negative torques, likewise."""
        return self._capacity(rolls=False, index=1)

    @functools.cached_property
    def standing_capacity_of_direction(self) -> TorqueCapacity:
        """Torque capacity in the direction of the output torque, likewise."""
        backwards = (xp.asarray(self.joint.output_torque) < 0.0).astype(int)
        return self._capacity(rolls=False, index=backwards)

    @functools.cached_property
    def rolling_capacity(self) -> Any:
        """Largest positive output torque under which the joint rolls [N·m]."""
        return self._capacity(rolls=True, index=0).output_torque

    @functools.cached_property
    def reverse_rolling_capacity(self) -> Any:
        """Largest negative output torque under which the joint rolls, as a positive number [N·m]."""
        return self._capacity(rolls=True, index=1).output_torque

    _bearing_lives = staticmethod(joint_bearing_lives)

    @functools.cached_property
    def duty_states(self) -> tuple[tuple[Joint, JointResult], ...]:
        """The joint under each load of its duty alone, and its result."""
        numbers: Joint = as_numbers(self.joint)
        states = []
        for point in numbers.rolling.duty:
            joint = dataclasses.replace(
                without_duty(numbers), output_torque=point.output_torque, input_speed=point.input_speed
            )
            states.append((joint, joint_state(joint)))
        return tuple(states)

    def _rims(self, joint: Joint, result: JointResult) -> Any:
        """The bodies along the last axis."""
        return at_once(joint_rims, in_motion(joint), result)

    def at_temperature(self, temperature: float) -> Solution | None:
        """What one joint does at another working temperature [degC]; None where it is loose there."""
        heated = self._heated(temperature)
        return None if heated is None else solution_of(heated)

    def _heated(self, temperature: float) -> Joint | None:
        """The joint at another working temperature [degC], without its duty; None where a branch is loose there."""
        if self.branches is None:
            return at_temperature(without_duty(self.joint), temperature)
        equal = at_temperature(without_duty(self.branches.equal), temperature)
        try:
            return assembled_branches(equal, self.branches.sizes).joint
        except (InputError, NoSolutionError):
            return None

    @functools.cached_property
    def cold(self) -> SolvedJoint | None:
        """The joint at its cold start; None where it has none, or is loose there."""
        heat = self.joint.heat
        if heat is None or heat.flow.cold_start is None:
            return None
        start = heat.flow.cold_start
        if "solution" in vars(self):
            joint = self._heated(float(start))
            return None if joint is None else solved_with_capacities(joint, solution_of(joint))
        joint = at_temperatures(without_duty(self.joint), housing=start, rollers=start)
        return SolvedJoint(joint, *evaluated_with_laws(joint))

    @functools.cached_property
    def temperature_limits(self) -> tuple[TemperatureLimit, ...]:
        """What one joint loses as its temperature changes, on each side the first one first."""
        return temperature_limits(self.joint, functools.cache(self._at_temperature))

    def _at_temperature(self, temperature: float) -> AtTemperature:
        """Forces without torque and pressures of the seats at another working temperature [degC]."""
        joint = self._heated(temperature)
        if joint is None:
            return AtTemperature(
                np.full(len(self.joint.drive.contacts), np.nan), np.full(len(self.joint.shapes), np.nan)
            )
        result = joint_state(joint)
        normal = np.asarray(result.rest.normal)
        if not float(result.rest.residual) < STATE_TOLERANCE:
            normal = np.full_like(normal, np.nan)
        if not any(seated(joint)):
            return AtTemperature(normal, np.full(len(joint.shapes), np.nan))
        with_torque = np.asarray(self._rims(joint, result).seat_pressure)
        alone = np.asarray(self._rims(*_without_torque(joint, result)).seat_pressure)
        return AtTemperature(normal, np.fmin(with_torque, alone))

    @property
    def preload(self) -> Any:
        """Normal force of the first contact without torque [N]."""
        return self.result.preload

    def row_names(self, axis: str) -> tuple[str, ...]:
        """Names of the contacts, bodies, bearings or clearances of this joint's drive."""
        if axis == "bearing":
            return self.joint.bearing_names
        if axis == "pin":
            return pin_names(self.joint.drive)
        if axis == "clearance":
            return tuple("_to_".join(pair) for pair in neighbours(self.joint.drive))
        return self.result.contact_names if axis == "contact" else self.result.body_names

    @functools.cached_property
    def clearances(self) -> list[Any]:
        """Clearances between rollers that must not touch [m]."""
        return list(neighbour_gaps(self.joint.drive).values())

    @functools.cached_property
    def loads(self) -> MemberLoads:
        """Loads of the structure under the joint's torque."""
        return working_loads(self.joint, self.result)

    def mounting(self, gap: Any = 0.0) -> Mounting:
        """Force and temperatures that mount its rings, with a radial gap around the rollers [m]."""
        return at_once(mounting, in_motion(self.joint), self.result, gap)

    @functools.cached_property
    def seats(self) -> Seats:
        """How its rings sit in their housing under the joint's torque."""
        return at_once(seats, in_motion(self.joint), self.loads)

    @functools.cached_property
    def size(self) -> Any:
        """Size and mass of the rolling parts."""
        return joint_size(self.joint, self.result)


def solved_with_capacities(
    joint: Joint, solution: Solution, branches: AssembledBranches | None = None
) -> SolvedJoint:
    """A joint whose capacities are known already, for the table of results."""
    joint, result = trees.map(np.asarray, joint), solution.result
    backwards = float(joint.output_torque) < 0.0
    rolling = solution.reverse_rolling_capacity if backwards else solution.rolling_capacity
    notes = (
        *plausibility(joint, result),
        *rolling_notes(
            joint,
            float(rolling.output_torque),
            film_unknown_because(result.contact_names, result.inlet_heat_factor),
        ),
        *oil_notes(joint, result.rolling),
        *loss_notes(result.rolling, result.contact_names),
        *skew_notes(result.rolling, result.contact_names),
    )
    solved = SolvedJoint(joint, result, solution.laws, notes, branches)
    solved.solution = solution
    solved._standing, solved._rolling = (
        trees.map(lambda *leaves: np.stack(leaves), *both)
        for both in (
            (solution.standing_capacity, solution.reverse_standing_capacity),
            (solution.rolling_capacity, solution.reverse_rolling_capacity),
        )
    )
    return solved
