"""What the sectors of a joint do whose sizes differ: each with its forces, and the forces on the axis."""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.drive.layout.drive import CARRIER, incidence
from asperity.drive.layout.unfolding import forces_on_centre
from asperity.drive.state.following import followed
from asperity.drive.state.loads import member_moments
from asperity.drive.state.state import DriveState
from asperity.drive.stiffness.assembly import Assembly
from asperity.joint.capacity import smaller_sizes, torque_capacity, under_torque
from asperity.joint.description import (
    Joint,
    body_masses,
    joint_contacts,
)
from asperity.joint.diagnostics import diagnose
from asperity.joint.laws import creep_law, drive_load
from asperity.joint.loading_cam import Pressed, pressed_at, turned_cam, with_its_cam
from asperity.joint.motion import in_motion
from asperity.joint.stiffness import loaded_stiffness
from asperity.joint.torque_limits import TorqueCapacity
from asperity.joint.unfolding import SectorSizes, SettledSectors, unfolded_joint
from asperity.rolling.power import RollingLosses, losses_of
from asperity.rolling.rolling import RollingResult
from asperity.rolling.turning import driving_sense, turning

_FIRST_STEP = 0.1  # of the torque that the friction of one contact can carry


class SectorStates(NamedTuple):
    """What the sectors of a joint do. SI units; contacts and pins sector by sector.

    Parameters
    ----------
    rest, standing, rolling : DriveState
        Of the unfolded drive: without torque, standing and rolling under it.
    centre_force : Array
        Forces on the bodies on the axis and on the carrier in these states, shape (3, bodies on the axis + 1, 2) [N].
    interference : Array
        Interference of the contacts without torque, the floating bodies on the axis where they are, shape (sectors,
        contacts) [m].
    output_moment : Array
        Moments on the output in the standing and in the rolling state, shape (2, sectors) [N·m].
    centre_moment : Array
        Moments of all sectors on the bodies on the axis and on the carrier in the three states, counter-clockwise,
        shape (3, bodies on the axis + 1) [N·m].
    losses : RollingLosses
        Of the joint that turns, contacts as those of one sector.
    drift_per_output_turn : Array
        Angle by which its output has fallen behind after one turn of its own [rad].
    pressure_over_first_yield, slip_ratio : Array
        Of the joint that stands, shape (sectors, contacts) [-].
    shakedown_ratio, rolling_slip_ratio : Array
        Of the joint that turns, likewise.
    life_hours : Array
        Fatigue life if all sectors were like this one, shape (sectors,) [h].
    assembly : Assembly
        Stiffness of the joint that stands under its torque.
    limits : TorqueCapacity
        Torques of the first slip in the direction of the joint's own, standing and in rolling, shape (2,) [N·m].
    most_torque : Array
        Largest torque that the joint that stands carries, likewise without sign [N·m].
    """

    rest: DriveState
    standing: DriveState
    rolling: DriveState
    centre_force: Array
    interference: Array
    output_moment: Array
    centre_moment: Array
    losses: RollingLosses
    drift_per_output_turn: Array
    pressure_over_first_yield: Array
    slip_ratio: Array
    shakedown_ratio: Array
    rolling_slip_ratio: Array
    life_hours: Array
    assembly: Assembly
    limits: TorqueCapacity
    most_torque: Array


def sector_states(
    sectors: int, floating: tuple[str, ...], joint: Joint, settled: SettledSectors
) -> SectorStates:
    """What the sectors of a joint do, of NumPy's numbers.

    Parameters
    ----------
    sectors : int
        Their number.
    floating : tuple of str
        Names of the bodies on the axis whose centres can move.
    joint : Joint
        A joint with equal sectors.
    settled : SettledSectors
        Its own sectors without torque.

    Returns
    -------
    SectorStates
        States without a balance have an infinite residual.

    References
    ----------
    Equation (I4) of :doc:`/equations`.
    """
    whole: Joint = in_motion(
        jax.tree.map(np.asarray, unfolded_joint(joint, settled.sizes, sectors=sectors, floating=floating))
    )
    torque, yes, no = np.asarray(whole.output_torque), np.asarray(True), np.asarray(False)
    given = (whole, settled.without_torque)
    under_program = compile_fast(under_torque, *given, torque, no, no)
    loading_program = compile_fast(_loaded_up_to, *given, torque)
    found = under_program.results.state
    options, both = (sectors, floating), (found, found, found)
    meaning = compile_fast(
        _meaning, joint, whole, settled.sizes, settled.without_torque, *both, options=options
    )
    under, loading = under_program.with_first(*given), loading_program.with_first(*given)
    rolling = under(torque, yes, no)
    standing, _ = loading(np.abs(torque))
    meant = meaning(
        joint, whole, settled.sizes, settled.without_torque, standing, rolling.state, rolling.pressed
    )
    direction = -1.0 if torque < 0.0 else 1.0
    limits = [
        torque_capacity(*given, under, direction=direction, rolls=rolls, holds=not rolls)
        for rolls in (False, True)
    ]
    _, most = loading(np.asarray(np.inf))
    numbers: SectorStates = jax.tree.map(
        np.asarray,
        SectorStates(
            rest=settled.without_torque.rest,
            standing=standing,
            rolling=rolling.state,
            limits=jax.tree.map(lambda *each: np.stack(each), *limits),
            most_torque=most,
            **meant,
        ),
    )
    return numbers


def _loaded_up_to(whole: Joint, without_torque: Pressed, most: Array) -> tuple[DriveState, Array]:
    """The joint that stands, loaded as its own torque up to a size of it or to the last that it carries."""
    drive, contacts, sizes = whole.drive, joint_contacts(whole), smaller_sizes(whole)

    def narrow(state: DriveState) -> Array:
        return jnp.all(contacts.largest_half_width(state.normal) < sizes)

    orbit = jnp.max(jnp.abs(drive.centres)) + jnp.max(drive.second_radius)
    friction = contacts.pairs.friction_coefficient
    return followed(
        drive=drive,
        pressed=pressed_at(whole, contacts, without_torque),
        load=drive_load(whole, body_masses(whole), whole.output_torque),
        first_step=_FIRST_STEP * jnp.min(friction * without_torque.rest.normal) * orbit,
        most=most,
        keeps=narrow,
    )


def _meaning(
    sectors: int,
    floating: tuple[str, ...],
    joint: Joint,
    whole: Joint,
    sizes: SectorSizes,
    without_torque: Pressed,
    standing: DriveState,
    rolling: DriveState,
    pressed: DriveState,
) -> dict[str, Any]:
    """What the states of the sectors mean: all of :class:`SectorStates` but the states and the limits."""
    contacts, rest, sense = joint_contacts(whole), without_torque.rest, driving_sense(whole.drive)
    tangential = sense * standing.tangential
    stiffness = loaded_stiffness(
        whole, contacts, standing.normal, tangential, standing.slides, standing.pin_force
    )
    diagnostics = diagnose(
        pairs=contacts.pairs,
        normal_force=standing.normal,
        tangential_force=tangential,
        loaded=stiffness.contacts,
        rest_force=pressed.normal,
    )
    slides = standing.slides != 0.0
    turned = _turned(joint, sizes, rolling, sectors)
    by_sector, states = (sectors, -1), (rest, standing, rolling)
    return {
        "centre_force": jnp.stack([_on_centre(joint, whole, state) for state in states]),
        "interference": _working_interference(whole, floating, rest).reshape(by_sector),
        "output_moment": jnp.stack([_output_moments(whole, state, sectors) for state in (standing, rolling)]),
        "centre_moment": jnp.stack([_centre_moments(joint, whole, state) for state in states]),
        "losses": jax.tree.map(lambda each: jnp.mean(each, axis=0), losses_of(turned.power)),
        "drift_per_output_turn": turned.drift_per_output_turn[0],
        "pressure_over_first_yield": jnp.asarray(diagnostics.pressure_over_first_yield).reshape(by_sector),
        "slip_ratio": jnp.where(slides, 1.0, diagnostics.slip_ratio).reshape(by_sector),
        "shakedown_ratio": turned.shakedown_ratio,
        "rolling_slip_ratio": turned.slip_ratio,
        "life_hours": turned.life_hours.drive,
        "assembly": with_its_cam(stiffness.assembly, turned_cam(whole, contacts, rest, pressed)),
    }


def _on_centre(joint: Joint, whole: Joint, state: DriveState) -> Array:
    return forces_on_centre(
        drive=whole.drive,
        bodies=tuple(body.name for body in joint.drive.bodies if body.place == "axis"),
        normal=state.normal,
        tangential=state.tangential,
        pin_force=state.pin_force,
    )


def _working_interference(whole: Joint, floating: tuple[str, ...], rest: DriveState) -> Array:
    """Interference of the contacts, with what floating bodies on the axis take of it [m]."""
    drive = whole.drive
    central = np.array([drive.bodies[body].name in floating for body in drive.floating])
    return rest.interference + incidence(drive).approach @ jnp.where(
        np.repeat(central, 2), rest.displacement.ravel(), 0.0
    )


def _output_moments(whole: Joint, state: DriveState, sectors: int) -> Array:
    """Moments that the sectors pass to the output [N·m]."""
    drive, matrices = whole.drive, incidence(whole.drive)
    each = -matrices.turning[:, drive.members.index(drive.output)] * state.tangential
    if drive.output == CARRIER:
        each = matrices.levers * state.pin_force
    return jnp.sum(each.reshape(sectors, -1), axis=1)


def _centre_moments(joint: Joint, whole: Joint, state: DriveState) -> Array:
    """Moments that all sectors put on the bodies on the axis and on the carrier, counter-clockwise [N·m]."""
    drive = whole.drive
    moments = member_moments(drive, incidence(drive), state.tangential, state.pin_force)
    names = [body.name for body in joint.drive.bodies if body.place == "axis"]
    return moments[np.array([drive.members.index(name) for name in (*names, CARRIER)])]


def _turned(joint: Joint, sizes: SectorSizes, rolling: DriveState, sectors: int) -> RollingResult:
    """The joint that turns if all sectors were like one, for each of them, which comes first."""
    plain = dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, duty=()))
    contacts, sense, own = joint_contacts(joint), driving_sense(joint.drive), joint.drive
    central = sum(body.place == "axis" for body in own.bodies)
    per_sector = len(own.bodies) - central

    def speeds_of(sector: Array) -> Array:
        others = jax.lax.dynamic_slice(rolling.speed, (central + per_sector * sector,), (per_sector,))
        middle, rest = iter(rolling.speed[:central]), iter(others)
        each = [next(middle) if body.place == "axis" else next(rest) for body in own.bodies]
        return jnp.stack([*each, rolling.speed[-1]])

    def one(sector: Array) -> RollingResult:
        def mine(values: Array) -> Array:
            return values.reshape(sectors, -1)[sector]

        state = dataclasses.replace(
            rolling,
            normal=mine(rolling.normal),
            tangential=sense * mine(rolling.tangential),
            creepage=sense * mine(rolling.creepage),
            pin_force=mine(rolling.pin_force),
            speed=speeds_of(sector),
        )
        creep = creep_law(plain, contacts, state.normal, mine(rolling.tangential))
        return turning(plain, contacts, creep, state)

    return jax.vmap(one)(jnp.arange(sectors))
