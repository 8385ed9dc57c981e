"""What the sectors of a joint do whose sizes differ: each with its forces, and the forces on the axis."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.layout.drive import CARRIER, incidence
from asperity.drive.layout.unfolding import forces_on_centre
from asperity.drive.state.following import followed
from asperity.drive.state.loads import member_moments
from asperity.drive.state.state import ContactLaws, DriveLoad, DriveState
from asperity.drive.state.states import loaded_state
from asperity.drive.stiffness.assembly import Assembly
from asperity.joint.capacity import limiting_torques, smaller_sizes
from asperity.joint.contacts import JointContacts
from asperity.joint.description import (
    Joint,
    body_masses,
    joint_contacts,
)
from asperity.joint.diagnostics import diagnose
from asperity.joint.laws import contact_laws, creep_law, creep_under, drive_load
from asperity.joint.stiffness import loaded_stiffness
from asperity.joint.torque_limits import TorqueCapacity
from asperity.joint.unfolding import SectorSizes, unfolded_joint
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
    sectors: int, floating: tuple[str, ...], joint: Joint, sizes: SectorSizes, rest: DriveState
) -> SectorStates:
    """What is compiled to solve a joint whose sectors differ."""
    whole = unfolded_joint(joint, sizes, sectors=sectors, floating=floating)
    contacts, masses = joint_contacts(whole), body_masses(whole)
    laws, sense = contact_laws(whole, contacts), driving_sense(whole.drive)
    load = drive_load(whole, masses, whole.output_torque)
    rolling = loaded_state(
        drive=whole.drive,
        laws=laws,
        rest=rest,
        load=load,
        rolls=jnp.asarray(True),
        creep_of=creep_under(whole, contacts),
    )
    most = jnp.stack([jnp.abs(jnp.asarray(whole.output_torque)), jnp.asarray(jnp.inf)])
    both, reached = jax.vmap(lambda torque: _followed(whole, laws, rest, load, contacts, torque))(most)
    standing: DriveState = jax.tree.map(lambda leaf: leaf[0], both)
    tangential = sense * standing.tangential
    stiffness = loaded_stiffness(
        whole, contacts, standing.normal, tangential, standing.slides, standing.pin_force
    )
    diagnostics = diagnose(
        pairs=contacts.pairs,
        normal_force=standing.normal,
        tangential_force=tangential,
        loaded=stiffness.contacts,
        rest_force=rest.normal,
    )
    slides = standing.slides != 0.0
    turned = _turned(joint, sizes, rolling, sectors)
    apart, states = (sectors, -1), (rest, standing, rolling)
    return SectorStates(
        rest=rest,
        standing=standing,
        rolling=rolling,
        centre_force=jnp.stack([_on_centre(joint, whole, state) for state in states]),
        interference=_working_interference(whole, floating, rest).reshape(apart),
        output_moment=jnp.stack([_output_moments(whole, state, sectors) for state in (standing, rolling)]),
        centre_moment=jnp.stack([_centre_moments(joint, whole, state) for state in states]),
        losses=jax.tree.map(lambda each: jnp.mean(each, axis=0), losses_of(turned.power)),
        drift_per_output_turn=turned.drift_per_output_turn[0],
        pressure_over_first_yield=jnp.asarray(diagnostics.pressure_over_first_yield).reshape(apart),
        slip_ratio=jnp.where(slides, 1.0, diagnostics.slip_ratio).reshape(apart),
        shakedown_ratio=turned.shakedown_ratio,
        rolling_slip_ratio=turned.slip_ratio,
        life_hours=turned.life_hours.drive,
        assembly=stiffness.assembly,
        limits=limiting_torques(
            whole,
            rest,
            laws,
            direction=jnp.repeat(jnp.where(jnp.asarray(whole.output_torque) < 0.0, -1.0, 1.0), 2),
            rolls=jnp.array([False, True]),
            holds=jnp.array([True, False]),
        ),
        most_torque=reached[1],
    )


def _followed(
    whole: Joint,
    laws: ContactLaws,
    rest: DriveState,
    load: DriveLoad,
    contacts: JointContacts,
    most: Array,
) -> tuple[DriveState, Array]:
    """The joint that stands, loaded up to a torque or to the last that it carries."""
    drive, pairs, sizes = whole.drive, contacts.pairs, smaller_sizes(whole)

    def narrow(state: DriveState) -> Array:
        return jnp.all(contacts.largest_half_width(state.normal) < sizes)

    orbit = jnp.max(jnp.abs(drive.centres)) + jnp.max(drive.second_radius)
    step = _FIRST_STEP * jnp.min(pairs.friction_coefficient * rest.normal) * orbit
    return followed(drive=drive, laws=laws, rest=rest, load=load, first_step=step, most=most, keeps=narrow)


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
