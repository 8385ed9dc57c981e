"""A joint between motor and load: natural frequencies at its torque, damping by creep, frequency response."""

from __future__ import annotations

import numpy as np

from asperity.drive.layout.drive import speed_ratio
from asperity.drive.stiffness.network import SpringLaws
from asperity.drive.structure.dynamics import (
    SprungDrive,
    frequency_response,
    inertia_at_motor,
    natural_frequencies,
    sprung_drive,
)
from asperity.drive.structure.inertia import mass_matrix
from asperity.engine import trees
from asperity.engine.arrays import as_numbers
from asperity.engine.module import Module
from asperity.errors import InputError
from asperity.joint.bodies import body_spins, joint_inertias
from asperity.joint.description import Joint, body_masses, in_motion
from asperity.joint.solve import Solution, solve_joint
from asperity.joint.torque_limits import LIMIT_KINDS, MODEL_LIMITS
from asperity.standing.springs_over_torque import springs_of_solution, springs_over_torque
from asperity.types import Real

_FREQUENCIES = 400
_BESIDE = 1e-6  # of a natural frequency: on it a response without losses is infinite, or 0, and has no phase
_TORQUES = 25
_NEAR_CAPACITY = 0.98


class Inertias(Module):
    """What is coupled to a joint. SI units.

    Parameters
    ----------
    input : Real
        Moment of inertia of motor and coupling at the input [kg·m^2].
    output : Real
        Moment of inertia of the load at the carrier [kg·m^2].
    loss_factor : Real
        Loss factor of the joint's spring [-].
    """

    input: Real
    output: Real
    loss_factor: Real


class JointDynamics(Module):
    """A joint with its inertias, linear about its output torque [N·m]. SI units, all referred to the output.

    Incremental stiffness of the assembled joint [N·m/rad]. Inertias [kg·m^2] as it rolls without slip: of motor and
    input roller; of the spin of the rollers off the axis, which in a vibration turn as the springs on their two sides
    let them; and of load and all other motions, the carrier belonging to the load. Natural frequencies of all bodies on
    all springs, with the motor locked, and with both sides free [Hz]. ``creep_damping``: torque per speed lost by creep
    [N·m·s/rad], infinite where the input stands, nan where the joint does not roll. ``corner_frequency``: where creep
    and spring yield equally [Hz], below which the joint that turns is a damper, above it a spring; 0 where the input
    stands.
    """

    output_torque: np.ndarray
    stiffness: np.ndarray
    input_inertia: np.ndarray
    spin_inertia: np.ndarray
    output_inertia: np.ndarray
    locked_frequency: np.ndarray
    free_frequency: np.ndarray
    creep_damping: np.ndarray
    corner_frequency: np.ndarray


def _about_torques(
    joint: Joint, inertias: Inertias, torques: np.ndarray
) -> tuple[JointDynamics, SprungDrive, SprungDrive]:
    """A joint about each of the torques, as NumPy arrays; about the last one on its springs, standing and turning."""
    found = trees.map(np.asarray, springs_over_torque(joint, torques))
    drive = in_motion(joint).drive
    ratio = float(np.asarray(speed_ratio(drive)))
    slope = found.lost_speed_slope * abs(float(joint.input_speed) / ratio)
    mass, ends = _masses(joint), (float(inertias.input), float(inertias.output))

    def sprung(place: int, creep: tuple[np.ndarray, np.ndarray] | None) -> SprungDrive:
        return sprung_drive(
            drive=drive,
            springs=SpringLaws(*(leaf[place] for leaf in found.springs)),
            shafts=_shafts(joint, float(found.cam_compliance[place])),
            mass=mass,
            ends=ends,
            creep=creep,
        )

    standing = [sprung(place, None) for place in range(torques.size)]
    turning = sprung(-1, (found.creep_by_normal[-1], found.creep_by_tangential[-1]))
    frequencies = [natural_frequencies(each) for each in standing]
    known = np.where(np.isnan(found.stiffness), np.nan, 1.0)
    entry, spinning, moved = (float(np.asarray(each)) for each in joint_inertias(joint))
    turns = slope > 0.0
    with np.errstate(divide="ignore"):
        damping = np.where(
            turns, 1.0 / np.where(turns, slope, 1.0), np.where(np.isnan(slope), np.nan, np.inf)
        )
    about = JointDynamics(
        output_torque=torques,
        stiffness=found.stiffness,
        input_inertia=np.full(torques.shape, ratio**2 * (ends[0] + entry)),
        spin_inertia=np.full(torques.shape, ratio**2 * spinning),
        output_inertia=np.full(torques.shape, ends[1] + moved),
        locked_frequency=known * np.array([each.locked for each in frequencies]),
        free_frequency=known * np.array([each.free for each in frequencies]),
        creep_damping=damping,
        corner_frequency=found.stiffness * slope / (2.0 * np.pi),
    )
    return about, standing[-1], turning


def _masses(joint: Joint) -> np.ndarray:
    """Masses of all bodies for the motions of the drive."""
    masses, spins = (
        np.array([float(np.asarray(each)) for each in values])
        for values in (body_masses(joint), body_spins(joint))
    )
    return mass_matrix(drive=in_motion(joint).drive, masses=masses, spins=spins)


def _shafts(joint: Joint, cam_compliance: float) -> tuple[float, float]:
    """Compliances of the shafts of motor and load, that with the loading cam in series [rad/(N·m)]."""
    at_motor, at_load = (
        1.0 / float(np.asarray(each)) for each in (joint.input_shaft_stiffness, joint.output_shaft_stiffness)
    )
    return at_motor, at_load + cam_compliance


class Dynamics(Module):
    """What a designer of the control looks at.

    Parameters
    ----------
    at_torque : JointDynamics
        At the joint's own torque.
    over_torque : JointDynamics
        From no torque to nearly the capacity, or to the joint's torque if nothing limits it.
    frequency : np.ndarray
        Frequencies of the response [Hz].
    standing_motor, standing_load : np.ndarray
        Complex angles of both sides per torque at the input, of the joint that stands [rad/(N·m)].
    turning_motor, turning_load : np.ndarray
        The same at the joint's speed, where creep acts as a damper.
    """

    at_torque: JointDynamics
    over_torque: JointDynamics
    frequency: np.ndarray
    standing_motor: np.ndarray
    standing_load: np.ndarray
    turning_motor: np.ndarray
    turning_load: np.ndarray


def dynamics(joint: Joint, inertias: Inertias) -> Dynamics:
    """Natural frequencies over torque, and the frequency response at the joint's torque."""
    solution = solve_joint(joint)
    if not float(solution.result.assembly.stiffness.output) > 0.0:
        raise InputError("the assembled joint has no stiffness, so that it has no natural frequency")
    coupled: Inertias = as_numbers(inertias)
    output_torque = float(joint.output_torque)
    limit = _limit(solution, output_torque)
    largest = np.copysign(_NEAR_CAPACITY * limit, output_torque) if np.isfinite(limit) else output_torque
    torques = np.append(np.linspace(0.0, largest, _TORQUES), output_torque)
    numbers = as_numbers(joint)
    over, standing, turning = _about_torques(numbers, coupled, torques)
    at = trees.map(lambda values: values[-1], over)
    spread = np.geomspace(at.locked_frequency / 100.0, 10.0 * at.free_frequency, _FREQUENCIES)
    beside = np.outer([at.locked_frequency, at.free_frequency], [1.0 - _BESIDE, 1.0 + _BESIDE])
    frequency = np.sort(np.append(spread, beside))
    both = [
        frequency_response(joint=each, frequency=frequency, loss_factor=float(coupled.loss_factor))
        for each in (standing, turning)
    ]
    return Dynamics(
        at,
        trees.map(lambda values: values[:-1], over),
        frequency,
        *(angle for response in both for angle in response),
    )


def two_inertias(joint: Joint, inertias: Inertias | None, solution: Solution) -> tuple[float, float]:
    r"""Two inertias on the spring of a solved joint that stand for all of its bodies in simple models.

    .. math:: J_1 + J_2 = J, \qquad \frac{J_1 J_2}{J_1 + J_2} = \frac{K}{(2 \pi f_r)^2}

    With motor and load: together they have the inertia J of everything, and on the stiffness K the natural frequency
    :math:`f_r` with both sides free; two equal ones where the reduced inertia is beyond J/4. Without them, ``None``:
    the first is that of everything as the input moves it while the output is held, and the second the rest.

    Parameters
    ----------
    joint, solution : Joint, Solution
        The joint under its torque.
    inertias : Inertias or None
        Motor and load.

    Returns
    -------
    tuple of float
        At the input, about its own axis, and at the output [kg·m^2].
    """
    cam = solution.result.cam
    sprung = sprung_drive(
        drive=in_motion(joint).drive,
        springs=springs_of_solution(joint, solution),
        shafts=_shafts(joint, 0.0 if cam is None else float(cam.compliance)),
        mass=_masses(joint),
        ends=(0.0, 0.0) if inertias is None else (float(inertias.input), float(inertias.output)),
        creep=None,
    )
    squared, total = float(np.asarray(speed_ratio(joint.drive))) ** 2, sprung.total_inertia
    if inertias is None:
        entry = inertia_at_motor(sprung)
        return entry, total - squared * entry
    stiffness, frequencies = float(solution.result.assembly.stiffness.output), natural_frequencies(sprung)
    reduced, alone = (
        stiffness / (2.0 * np.pi * each) ** 2 for each in (frequencies.free, frequencies.locked)
    )
    apart = np.sqrt(max(total**2 - 4.0 * total * reduced, 0.0))
    out = min((0.5 * (total + apart), 0.5 * (total - apart)), key=lambda each: abs(each - alone))
    return (total - out) / squared, out


def _limit(solution: Solution, torque: float) -> float:
    """Capacity in the direction of a torque [N·m]; where only what is computed ends there, at most twice the torque."""
    capacity = solution.reverse_standing_capacity if torque < 0.0 else solution.standing_capacity
    limit = float(capacity.output_torque)
    ends = LIMIT_KINDS[int(capacity.limit)] in MODEL_LIMITS and torque != 0.0
    return min(limit, 2.0 * abs(torque) / _NEAR_CAPACITY) if ends else limit
