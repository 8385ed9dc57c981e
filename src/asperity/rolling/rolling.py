"""A joint that turns: creep, drift, axial forces, losses, shakedown and life, from what the chain already derived."""

from __future__ import annotations

import functools
import operator
from typing import TypeVar

from asperity.contact.creep_layer import peak_pressure_factor, width_factor
from asperity.contact.hertz_line import peak_pressure
from asperity.contact.roller_pairs import RollerPairs
from asperity.contact.rolling_fatigue import life_at_reliability
from asperity.contact.skew import stick_fraction
from asperity.drive.bearings import leading_sense
from asperity.drive.layout.drive import CARRIER, speeds
from asperity.drive.state.creep import ROLLING_TOLERANCE, drift_per_turn
from asperity.drive.state.loads import friction_moments, friction_power
from asperity.drive.state.state import (
    BodiesOfContacts,
    DriveState,
    RollingSpeeds,
    in_driving_sense,
    surface_speeds,
)
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.joint.description import Joint, bodies_of_contacts, places
from asperity.joint.laws import creep_law
from asperity.joint.machine import JointMachine
from asperity.rolling.creep import ContactFriction, contact_friction, traction_limit
from asperity.rolling.film import FilmState, film_state
from asperity.rolling.life import DriveLives, cycle_rates, drive_lives, film_factors
from asperity.rolling.power import RollingPower, rolling_power
from asperity.rolling.surface import RollingStrips, flash_temperatures, oil_film, rolling_strips
from asperity.types import Array, Real

_Values = TypeVar("_Values")


class RollingResult(Module):
    """What a joint does in steady rolling. SI units; contact axis first. nan where a contact has lifted off or slips.

    Parameters
    ----------
    normal, tangential : Array
        Forces of the contacts, shape (contacts, ...) [N]; the tangential ones are those of equal creep on both sides.
    creepage : Array
        Creepages, shape (contacts, ...) [-].
    drag : Array
        Drag of the oil on each surface, with the sign of the rotation, shape (contacts, ...) [N]; 0 without a
        viscosity.
    hysteresis_moment, skew_drag : Array
        Moment of elastic hysteresis on both bodies [N·m], and drag of the axial friction on each surface [N], with the
        sign of the rotation, shape (contacts, ...); 0 without a loss factor, and without skew.
    traction_coefficient : Array
        T/N, shape (contacts, ...) [-].
    slip_ratio : Array
        Tangential force over what friction and skew leave for it, shape (contacts, ...) [-].
    stick_fraction : Array
        Share of the contact width that sticks under tangential and axial traction, shape (contacts, ...) [-].
    layer_ratio, layer_creepage_factor : Array
        Yield of the asperities over that of the bodies, and by how much the asperities change the creepage, shape
        (contacts, ...) [-].
    hertz_pressure : Array
        Peak pressure of smooth bodies, where a crowned contact carries most, shape (contacts,) [Pa].
    rough_half_width, rough_peak_pressure : Array
        Half-width of the ellipse whose root mean square the load's places have, and peak pressure, both with the
        asperities and in the middle of crowned contacts, shape (contacts, ...) [m] and [Pa]; life and shakedown take
        Hertz's.
    skew_creepage_factor : Array
        By how much skew raises the creepage, shape (contacts, ...) [-]; 1 without skew.
    capacity_loss : Array
        Share of the friction that skew takes from the tangential force, shape (contacts, ...) [-].
    axial_force : Array
        Axial force of one contact on its driven body, shape (contacts, ...) [N].
    axial_thrust : Array
        Sum of the axial forces on each body of a sector, on a body on the axis those of all sectors, shape
        (bodies, ...) [N].
    speed_loss : Array
        Share of the output speed that creep takes [-].
    drift_per_output_turn : Array
        Angle by which the output has fallen behind after one turn of its own [rad].
    drift_rate : Array
        The same per time [rad/s]; nan where the input stands.
    power : RollingPower
        Losses and efficiency; nan where the input stands.
    flash_temperature : Array
        Rise of the surfaces above the temperature of the bodies, shape (contacts, ...) [K]; nan where the input stands
        or a material has no thermal properties.
    film_thickness, film_ratio : Array
        Smallest thickness of the oil film, as if it carried the whole load [m], and its ratio to the roughness [-],
        shape (contacts, ...); nan where the input stands or the joint lacks a number for them.
    life_factor : Array
        Lives of the tracks with the oil film over those without, shape (contacts, ...) [-]; nan without a cleanliness
        of the oil, and where the film is not known or too thin for a factor: there is no life then.
    shakedown_ratio : Array
        Peak pressure over the shakedown limit at the contact's traction coefficient, shape (contacts, ...) [-].
    output_speed : Array
        Angular velocity of the output, creep taken off [rad/s]; without its sign.
    cycles : Array
        Life of the tracks of driving and driven bodies at 90 % survival, in stress cycles, shape (2, 5, ...) [-].
    cycles_per_turn : Array
        Their stress cycles in one turn of the output by one contact of one branch, shape (2, 5, ...) [-].
    life_turns : DriveLives
        Lives in turns of the output [-].
    life_hours : DriveLives
        Lives in hours of rolling at the joint's speed [h]; nan where the input stands.
    duty_life_hours, duty_life_turns : Array
        Life of the drive under its duty, in hours and in turns of the output; nan without a duty.
    duty_damage_shares, duty_load_hours, duty_shakedown_ratios, duty_slip_ratios, duty_film_ratios : Array
        Share of each load of the duty in the damage [-], life under it alone [h], and Hertz pressure over shakedown
        limit, slip ratio and film ratio of the worst contact under it [-], loads first; empty without a duty.
    residual : Array
        Residual of the rolling state, :data:`asperity.drive.state.creep.ROLLING_TOLERANCE` at most [-].
    crown_creepage_factor : Array or None
        By how much the crowns change the creepage of smooth rollers, shape (contacts, ...) [-]; None where none is
        crowned.
    film : FilmState or None
        Oil film and asperities in the contacts; None without an oil whose traction is known.
    """

    normal: Array
    tangential: Array
    creepage: Array
    drag: Array
    hysteresis_moment: Array
    skew_drag: Array
    traction_coefficient: Array
    slip_ratio: Array
    stick_fraction: Real
    layer_ratio: Array
    layer_creepage_factor: Array
    hertz_pressure: Array
    rough_half_width: Array
    rough_peak_pressure: Array
    skew_creepage_factor: Array
    capacity_loss: Array
    axial_force: Array
    axial_thrust: Array
    speed_loss: Array
    drift_per_output_turn: Array
    drift_rate: Array
    power: RollingPower
    flash_temperature: Array
    film_thickness: Array
    film_ratio: Array
    life_factor: Array
    shakedown_ratio: Array
    output_speed: Array
    cycles: Array
    cycles_per_turn: Array
    life_turns: DriveLives
    life_hours: DriveLives
    duty_life_hours: Array
    duty_life_turns: Array
    duty_damage_shares: Array
    duty_load_hours: Array
    duty_shakedown_ratios: Array
    duty_slip_ratios: Array
    duty_film_ratios: Array
    residual: Array
    crown_creepage_factor: Array | None = None
    film: FilmState | None = None


def turning(machine: JointMachine, rolls: DriveState) -> RollingResult:
    """Drift, losses, surfaces, shakedown and life of a joint that turns; equations (B1) and (M3) of :doc:`/equations`.

    ``rolls``: its drive that rolls under its torque at its speed.
    """
    joint, contacts, pairs = machine.joint, machine.contacts, machine.contacts.pairs
    creep = creep_law(machine, rolls.normal, rolls.tangential)
    state = in_driving_sense(rolls, machine.drive)
    normal = xp.where(state.normal > 0.0, state.normal, 1.0)
    traction = state.tangential / normal
    strips = rolling_strips(contacts=contacts, normal_force=normal, traction=traction)
    unit = _speeds_of_unit_input(joint, state)
    input_speed = xp.abs(xp.asarray(joint.input_speed))
    speeds, turns = trees.map(lambda speed: speed * input_speed, unit), input_speed > 0.0
    friction = contact_friction(pairs=pairs, creep=creep, normal_force=normal, creepage=state.creepage)
    limit = traction_limit(pairs=pairs, creep=creep, normal_force=normal)
    slip_ratio = xp.abs(traction) / limit
    oil: FilmState | None = None
    if creep.oiled is not None:
        oil = film_state(creep=creep.oiled, normal_force=normal, creepage=state.creepage, used=slip_ratio)
    turns_an_hour = 3600.0 * speeds.output / (2.0 * xp.pi)
    power = _power(joint, pairs, state, speeds, (friction.axial, creep.skew))
    stuck, flash_temperature = _flash(joint, pairs, strips, friction, power, speeds, traction)
    pressure = xp.asarray(
        peak_pressure(
            normal_force=strips.largest_load,
            contact_length=pairs.contact_length,
            half_width=strips.largest_half_width,
        )
    )
    film, film_over_roughness = oil_film(
        conditions=joint.rolling, pairs=pairs, normal_force=strips.largest_load, rolling_speed=speeds.rolling
    )
    life_factor = _life_factor(joint, pairs, strips, film_over_roughness)
    tracks, per_turn, lives = _lives(joint, strips, unit, slip_ratio, life_factor)
    drift = drift_per_turn(state.speed_loss)
    result = RollingResult(
        normal=state.normal,
        tangential=state.tangential,
        creepage=state.creepage,
        drag=state.drag,
        hysteresis_moment=state.hysteresis_moment,
        skew_drag=state.skew_drag,
        traction_coefficient=traction,
        slip_ratio=slip_ratio,
        stick_fraction=stuck,
        layer_ratio=creep.layer_ratio,
        layer_creepage_factor=creep.layer_factor,
        hertz_pressure=pressure,
        rough_half_width=strips.largest_half_width * width_factor(layer_ratio=creep.layer_ratio),
        rough_peak_pressure=pressure * peak_pressure_factor(layer_ratio=creep.layer_ratio),
        skew_creepage_factor=creep.skew_factor,
        capacity_loss=friction.lost,
        axial_force=friction.axial,
        axial_thrust=_thrust(bodies_of_contacts(joint), friction.axial, xp.asarray(joint.drive.sectors)),
        speed_loss=state.speed_loss,
        drift_per_output_turn=drift,
        drift_rate=_where(turns, drift * speeds.output / (2.0 * xp.pi)),
        power=_where(turns, power),
        flash_temperature=flash_temperature,
        film_thickness=film,
        film_ratio=film_over_roughness,
        life_factor=life_factor,
        shakedown_ratio=strips.shakedown_ratio,
        output_speed=speeds.output,
        cycles=tracks,
        cycles_per_turn=per_turn,
        life_turns=lives,
        life_hours=_where(turns, trees.map(lambda life: life / xp.where(turns, turns_an_hour, 1.0), lives)),
        residual=state.residual,
        crown_creepage_factor=creep.crown_factor,
        film=oil,
        **_without_duty(state.speed_loss),
    )
    return _where(state.residual < ROLLING_TOLERANCE, result)


def _without_duty(like: Array) -> dict[str, Array]:
    """Results of a duty where none is stated."""
    unknown, no_loads = xp.full_like(like, xp.nan), xp.zeros((0, *like.shape))
    lives = dict.fromkeys(("duty_life_hours", "duty_life_turns"), unknown)
    ratios = (f"duty_{name}_ratios" for name in ("shakedown", "slip", "film"))
    return lives | dict.fromkeys(("duty_damage_shares", "duty_load_hours", *ratios), no_loads)


def _power(
    joint: Joint,
    pairs: RollerPairs,
    state: DriveState,
    speeds: RollingSpeeds,
    across: tuple[Array, Array],
) -> RollingPower:
    """Budget of powers; ``across`` are axial forces and creepages of the contacts."""
    sense = xp.where(xp.asarray(joint.input_speed) < 0.0, -1.0, 1.0)
    return rolling_power(
        branches=xp.asarray(joint.drive.sectors),
        pairs=pairs,
        conditions=joint.rolling,
        state=state,
        speeds=speeds,
        axial_force=across[0],
        lateral_creepage=across[1],
        bearing_power=_bearing_power(joint, state),
        output_torque=sense * xp.asarray(joint.output_torque),
    )


def _speeds_of_unit_input(joint: Joint, state: DriveState) -> RollingSpeeds:
    """Speeds of the surfaces and bodies over that of the input."""
    drive = joint.drive
    one, two = surface_speeds(drive=drive, speed=state.speed)
    return RollingSpeeds(
        driving=one,
        driven=two,
        body=xp.abs(state.speed[:-1] - state.speed[drive.members.index(CARRIER)]),
        output=xp.abs(state.speed[drive.members.index(drive.output)]),
    )


def _life_factor(joint: Joint, pairs: RollerPairs, strips: RollingStrips, film_ratio: Array) -> Array:
    """Factors of the lives for the oil films; nan without a cleanliness."""
    cleanliness = joint.rolling.cleanliness
    if cleanliness is None:
        return xp.full_like(strips.largest_load, xp.nan)
    return film_factors(
        pairs=pairs,
        lines=strips.lines,
        peak_pressure=strips.peak_pressure,
        film_ratio=film_ratio,
        cleanliness=cleanliness,
    )


def _lives(
    joint: Joint, strips: RollingStrips, unit: RollingSpeeds, slip_ratio: Array, life_factor: Array
) -> tuple[Array, Array, DriveLives]:
    """Lives of the tracks in cycles, their cycles in one turn of the output, and lives in turns of the output."""
    bodies, branches = bodies_of_contacts(joint), xp.asarray(joint.drive.sectors)
    # above the shakedown limit the surface flows at every passage, and what slips as a whole wears: no law of elastic
    # fatigue holds
    rolls = (strips.shakedown_ratio < 1.0) & (slip_ratio < 1.0)
    lives = strips.tracks if joint.rolling.cleanliness is None else strips.tracks * life_factor
    tracks = xp.where(rolls, lives, xp.nan)
    rates = cycle_rates(bodies=bodies, speeds=unit)
    per_turn = rates * (2.0 * xp.pi / unit.output)
    reliable = life_at_reliability(life=tracks, reliability=joint.rolling.reliability)
    return tracks, per_turn, drive_lives(bodies=bodies, tracks=reliable / per_turn, branches=branches)


def _flash(
    joint: Joint,
    pairs: RollerPairs,
    strips: RollingStrips,
    friction: ContactFriction,
    power: RollingPower,
    speeds: RollingSpeeds,
    traction: Array,
) -> tuple[Array, Array]:
    """Shares of the contact widths that stick [-], and flash temperatures in the middle of the contacts [K]."""
    first, second = places(joint.drive)

    def stick(coefficient: Array) -> Array:
        ratio = coefficient / friction.most
        return xp.asarray(stick_fraction(longitudinal_slip_ratio=ratio, lateral_slip_ratio=friction.lateral))

    stuck = in_middle = stick(traction)
    heat = xp.asarray((power.creep + power.skew) / (xp.asarray(joint.drive.sectors) * pairs.contact_length))
    if strips.middle_power_ratio is not None:
        heat = heat * strips.middle_power_ratio
        in_middle = stick(strips.middle_traction)
    return stuck, flash_temperatures(
        materials=[(joint.materials[a], joint.materials[b]) for a, b in zip(first, second, strict=True)],
        friction_power=heat,
        speeds=speeds,
        half_width=strips.largest_half_width,
        stick_fraction=in_middle,
    )


def _where(condition: Array, values: _Values) -> _Values:
    """The numbers where a condition holds, nan elsewhere."""
    return trees.map(lambda value: xp.where(condition, value, xp.nan), values)


def _thrust(bodies: BodiesOfContacts, axial: Array, branches: Real) -> Array:
    """Axial forces on the bodies; a contact pushes its two bodies oppositely."""
    thrust = []
    for number, shared in enumerate(bodies.shared):
        pushed = [axial[k] for k, body in enumerate(bodies.driven) if body == number]
        pushed += [-axial[k] for k, body in enumerate(bodies.driving) if body == number]
        force = functools.reduce(operator.add, pushed, xp.zeros_like(axial[0]))
        thrust.append(branches * force if shared else force)
    return xp.stack(xp.broadcast_arrays(*thrust))


def _bearing_power(joint: Joint, state: DriveState) -> Array:
    """Power lost in bearings and pins at the joint's speed [W]."""
    if joint.bearings is None:
        return xp.zeros_like(state.speed_loss)
    sense = leading_sense(rotation=joint.input_speed, output_torque=joint.output_torque)
    moments = friction_moments(
        drive=joint.drive,
        bearings=joint.bearings,
        pin_force=state.pin_force,
        ideal=sense * speeds(joint.drive),
    )
    return friction_power(drive=joint.drive, moments=moments, speed=state.speed * joint.input_speed)
